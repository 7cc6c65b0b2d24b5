"""How a model is lifted: by the solver's own method, or by those of papers, to compare with.

Terms
-----
source
    The text of a sketch, behind the name of a method where that is not the solver's own. All that
    follows from a model follows from its source.
slow
    The methods of papers: they search for seconds, or minutes.
"""

from __future__ import annotations

from collections.abc import Iterable
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


def source_of(sketch_text: str, method: str) -> str:
    """A sketch's text to be lifted by a method."""
    # JSON never begins like this.
    return f"{SLOW[method]}{_BEHIND}{sketch_text}" if method in SLOW else sketch_text


def parts_of(source: str) -> tuple[str | None, str]:
    """The slow method, if one, and the sketch's text."""
    name, _, text = source.partition(_BEHIND)
    return (name, text) if name in SLOW.values() else (None, source)


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


def lift_slowly(graph: SketchGraph, name: str) -> Solution | None:
    """The graph lifted by a method of a paper; None where a person stopped it."""
    from ...solver.reference import METHODS

    title = next(words for words, method in SLOW.items() if method == name)
    words = host.translate("InContext", "Lifting by the method {} ...").format(title)

    def work(stop: host.Stop, progress: host.Progress) -> Solution:
        return METHODS[name](graph, stop=stop, progress=progress)

    return host.work(words, work)
