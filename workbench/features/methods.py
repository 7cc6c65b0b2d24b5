"""How a model is lifted: by the solver's own method, or by those of papers, to compare with.

Terms
-----
source
    The text of a sketch, behind the name of a method where that is not the solver's own, and
    behind the angles that are said of the model. All that follows from a model follows from it.
slow
    The methods of papers: they search for seconds, or minutes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import StoppedError
from .properties import Property

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution

OURS = "Modified Lipson"
#: Slow ones, and their names in `solver.reference`.
SLOW = {"Lau 2010": "lau2010", "Lipson 1996": "lipson1996"}

METHOD = Property(
    "App::PropertyEnumeration",
    "Method",
    "Model",
    "How the sketch is lifted. The methods of the papers are slow and less exact: they are there "
    "to compare with",
    default=OURS,
    choices=(OURS, *SLOW),
)

_BEHIND = "\n"
_ANGLES = "angles "


@dataclass(frozen=True, slots=True)
class Parts:
    """What a source says.

    Parameters
    ----------
    method : str or None
        The slow method, if one, by its name in `solver.reference`.
    angles : str
        What `model_angles.text_of` gives.
    sketch : str
        The sketch's text.
    """

    method: str | None
    angles: str
    sketch: str


def source_of(sketch_text: str, method: str, angles: str = "") -> str:
    """A sketch's text to be lifted by a method, with angles as `model_angles.text_of` gives."""
    # JSON never begins like these.
    behind = f"{_ANGLES}{angles}{_BEHIND}{sketch_text}" if angles else sketch_text
    return f"{SLOW[method]}{_BEHIND}{behind}" if method in SLOW else behind


def parts_of(source: str) -> Parts:
    """The method, the angles and the sketch of a source."""
    method, _, text = source.partition(_BEHIND)
    if method not in SLOW.values():
        method, text = "", source
    angles, _, sketch = text.partition(_BEHIND)
    if not angles.startswith(_ANGLES):
        angles, sketch = "", text
    return Parts(method or None, angles[len(_ANGLES) :], sketch)


def choose_method(models: Iterable[Any], method: str) -> None:
    """Have lifted models lifted by a method, as one step to undo; none where a person stops it."""
    models = [model for model in models if str(model.Method) != method]
    if not models:
        return
    document = models[0].Document
    try:
        with host.transaction(document, host.translate("InContext", "Change method")):
            for model in models:
                model.Method = method
            document.recompute()
            if any(model.Status == "stopped" for model in models):
                raise StoppedError
    except StoppedError:
        # The step is taken back; what the models say of themselves comes with a recompute.
        for model in models:
            model.touch()
        document.recompute()


def lift_slowly(
    graph: SketchGraph, name: str, angles_deg: Mapping[tuple[str, str], float]
) -> Solution | None:
    """The graph lifted by a method of a paper; None where a person stopped it.

    Raises
    ------
    SketchError
        Where angles are said: the papers know right ones only.
    """
    from ...solver.errors import SketchError
    from ...solver.reference import METHODS

    if angles_deg:
        first = next(iter(angles_deg))
        raise SketchError(
            f"the papers' methods know no angle between {first[0]} and {first[1]} but a right one",
            first,
            f"the method {OURS}, or freeing that angle",
        )
    title = next(words for words, method in SLOW.items() if method == name)
    words = host.translate("InContext", "Lifting by the method {} ...").format(title)

    def work(stop: host.Stop, progress: host.Progress) -> Solution:
        return METHODS[name](graph, stop=stop, progress=progress)

    return host.work(words, work)
