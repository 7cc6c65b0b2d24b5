"""From a sketch's text to its graph, solution and plates: pure functions, remembered.

What takes long is worked out on the side, while a window shows that it is being done; whoever asks
waits for it all the same, so that a recompute leaves everything as it should be.

Nothing is kept on document objects that follows from the sketch. So undo, copies and reopened
documents cannot disagree with it, and a change of the kerf solves nothing again. The solver is
imported on first use: opening FreeCAD must not wait for it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeVar

from .. import host
from ..problems import StoppedError
from .dimension_names import Dimension, said
from .methods import lift_slowly, parts_of
from .model_angles import Corner, angles_of

if TYPE_CHECKING:
    from ...solver import Drag
    from ...solver.graph import SketchGraph
    from ...solver.model import Model
    from ...solver.solution import Solution
    from ..fabrication.assembly import Step
    from ..fabrication.meshes import Mesh
    from ..fabrication.plates import Joined, Plate
    from ..fabrication.settings import PlateSettings, ShellSettings

T = TypeVar("T")
#: How many results of each kind are remembered: enough for undoing and redoing a while.
REMEMBERED = 32


@lru_cache(maxsize=REMEMBERED)
def graph_of(sketch_text: str) -> SketchGraph:
    """The graph that a sketch's text, or a source, says; raises SketchError."""
    from ...solver.serialise import sketch_from_text

    return sketch_from_text(parts_of(sketch_text).sketch)


@lru_cache(maxsize=REMEMBERED)
def resized_text(sketch_text: str, values: tuple[tuple[Dimension, float], ...]) -> str:
    """The sketch's text with other values said of some dimensions; raises SketchError."""
    from ...solver.serialise import sketch_to_text

    graph = graph_of(sketch_text)
    for dimension, value in values:
        graph = said(graph, dimension, value)
    return sketch_to_text(graph)


#: Solutions by their source, the oldest first.
_solutions: dict[str, Solution] = {}
#: Sources that a person did not wait for.
_stopped: set[str] = set()


def solution_of(source: str) -> Solution:
    """The sketch lifted to 3D by the method asked for.

    Raises
    ------
    SketchError
        Where the text is no sketch.
    StoppedError
        Where a person stopped it; it is not begun again before `forget_stop`.
    """
    if source in _stopped:
        raise StoppedError
    if source not in _solutions:
        parts, graph = parts_of(source), graph_of(source)
        angles = angles_of(parts.angles)
        if parts.method is None:
            solution = _lift_in_sight(graph, angles)
        else:
            solution = lift_slowly(graph, parts.method, angles)
        if solution is None:
            _stopped.add(source)
            raise StoppedError
        remember_solution(source, solution)
    return _solutions[source]


def _lift_in_sight(graph: SketchGraph, angles_deg: Mapping[Corner, float]) -> Solution | None:
    words = host.translate("InContext", "Lifting the sketch to 3D ...")
    return host.work(words, lambda stop, progress: lift(graph, stop, angles_deg=angles_deg))


def in_sight(words: str, make: Callable[..., T], *arguments: Any) -> T:
    """What a pure function gives: worked out before a person's eyes where that takes long.

    Raises
    ------
    StoppedError
        Where a person did not wait for it.
    """
    made = host.work(words, lambda stop, progress: make(*arguments))
    if made is None:
        raise StoppedError
    return made


def forget_stop(source: str) -> None:
    """What was stopped may be begun again."""
    _stopped.discard(source)


def known_solution_of(sketch_text: str) -> Solution | None:
    """The sketch lifted to 3D where that was done before, else None."""
    return _solutions.get(sketch_text)


def remember_solution(sketch_text: str, solution: Solution) -> None:
    """Take a solution that was found elsewhere, from the sketch alone."""
    _solutions[sketch_text] = solution
    for text in list(_solutions)[:-REMEMBERED]:
        del _solutions[text]


def lift(
    graph: SketchGraph,
    stop: Callable[[], bool] | None = None,
    start: Solution | None = None,
    angles_deg: Mapping[Corner, float] | None = None,
) -> Solution:
    """The graph lifted to 3D.

    Parameters
    ----------
    graph : SketchGraph
    stop : callable, optional
        Asked now and then whether to give up.
    start : Solution, optional
        Of the sketch before some small change.
    angles_deg : mapping of (edge id, edge id) to float, optional
        What the model says of corners beside the sketch.
    """
    from ...solver import solve

    return solve(graph, start=start, stop=stop, angles_deg=angles_deg)


def begin_drag(graph: SketchGraph, solution: Solution) -> Drag:
    """Get ready to lift a sketch at each move of the mouse."""
    from ... import solver

    return solver.begin_drag(graph, solution)


def drag(last: Drag, graph: SketchGraph) -> Drag:
    """The sketch with vertices or circles moved, lifted from the last shape."""
    from ... import solver

    return solver.drag(last, graph)


@lru_cache(maxsize=REMEMBERED)
def model_of(sketch_text: str, thickness_mm: float) -> Model:
    """The lifted faces with thickness; raises SketchError where there are none."""
    from ...solver.model import build_model

    revolutions = graph_of(sketch_text).made_revolutions
    return build_model(solution_of(sketch_text), thickness_mm, revolutions)


def joined_of(sketch_text: str, settings: PlateSettings) -> Joined:
    """The plates of a sketch and their joints.

    Raises
    ------
    SketchError, FabricationError
        Where there are none.
    StoppedError
        Where a person did not wait for them.
    """
    model = model_of(sketch_text, settings.thickness_mm)
    return in_sight(host.translate("InContext", "Making the plates ..."), _joined, model, settings)


@lru_cache(maxsize=REMEMBERED)
def _joined(model: Model, settings: PlateSettings) -> Joined:
    with host.own_packages_first():
        from ..fabrication import joined_plates

        return joined_plates(model, settings)


def plates_of(sketch_text: str, settings: PlateSettings) -> tuple[Plate, ...]:
    """The plates of a sketch; raises as `joined_of` does."""
    return joined_of(sketch_text, settings).plates


def steps_of(joined: Joined) -> tuple[Step, ...]:
    """The order in which plates go together; raises LockedError where there is none."""
    words = host.translate("InContext", "Looking how the plates go together ...")
    return in_sight(words, _steps, joined)


@lru_cache(maxsize=REMEMBERED)
def _steps(joined: Joined) -> tuple[Step, ...]:
    from ..fabrication.assembly import assembly_steps

    return assembly_steps(joined.plates)


def printed_of(sketch_text: str, settings: ShellSettings) -> tuple[Any, Mesh]:
    """The hollow solid of a sketch and its mesh; raises as `joined_of` does."""
    return in_sight(_shell_words(), _printed, _walled(sketch_text, settings), settings)


@lru_cache(maxsize=2)
def _printed(model: Model, settings: ShellSettings) -> tuple[Any, Mesh]:
    with host.own_packages_first():
        from ..fabrication import shell_solid
        from ..fabrication.meshes import mesh_of

        solid = shell_solid(model, settings)
        return solid, mesh_of(solid, settings.tolerance_mm)


def shell_of(sketch_text: str, settings: ShellSettings) -> str:
    """The hollow solid of a sketch as BREP text; raises as `joined_of` does."""
    return in_sight(_shell_words(), _shell, _walled(sketch_text, settings), settings)


@lru_cache(maxsize=REMEMBERED)
def _shell(model: Model, settings: ShellSettings) -> str:
    from .brep_bridge import brep_text

    with host.own_packages_first():
        from ..fabrication import shell_solid

        return brep_text(shell_solid(model, settings))


def _walled(sketch_text: str, settings: ShellSettings) -> Model:
    # The thickness of the faces is for plates: the shell has walls of one thickness.
    return model_of(sketch_text, settings.wall_mm)


def _shell_words() -> str:
    return host.translate("InContext", "Making the solid; the first time takes some seconds ...")
