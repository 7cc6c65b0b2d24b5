"""The command line: solve, make, check, fit, marker, camera, straighten, bench.

Exit status: 0 all went well; 2 bad input (one line on stderr says what, where, what to try); 3 the
solve ended badly (the solution file is still written); 4 it does not fit or not stand; 1 a fault
of the program itself.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

if TYPE_CHECKING:
    from ..solver.graph import SketchGraph
    from ..solver.solution import Solution
    from .fabrication.errors import FabricationError

# Nothing else is imported before it is needed: --help must not wait for a CAD kernel.

OK, FAULT, BAD_INPUT, BAD_SOLVE, BAD_FIT = 0, 1, 2, 3, 4
ENDING = ".sketch.json"
#: What a solve says where there is nothing to say.
PLAIN = "Solved."
#: Drawings of each family of shapes in each case of the study: a few minutes.
STUDY_RUNS = 20
#: The solver, and the reference methods by their names in ``solver.reference.METHODS``.
METHODS = ("ours", "lau2010", "lipson1996")


class _Parser(argparse.ArgumentParser):
    """A parser that says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        self.exit(BAD_INPUT, f"{self.prog}: {message}; try: {self.prog} --help\n")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command.

    Parameters
    ----------
    argv : sequence of str or None
        The arguments; None takes the process's own.

    Returns
    -------
    int
        Exit status.
    """
    try:
        arguments = _parser().parse_args(argv)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else BAD_INPUT
    from ..solver.errors import SketchError
    from .fabrication.errors import FabricationError

    try:
        return int(arguments.run(arguments))
    except (SketchError, FabricationError) as error:
        _complain(f"incontext: {error}")
        return BAD_INPUT
    except KeyboardInterrupt:
        _complain("incontext: stopped")
        return 130
    except Exception as error:  # the last line of defence, and it says so
        _complain(f"incontext: a fault of this program: {type(error).__name__}: {error}")
        return FAULT


def _complain(text: str) -> None:
    print(" ".join(text.split()), file=sys.stderr)


def _parser() -> argparse.ArgumentParser:
    from .camera_commands import add_camera, add_marker
    from .straighten_command import add_straighten

    parser = _Parser(
        prog="incontext",
        description="Draw a new object over one photo, get its precise 3D shape and parts.",
        epilog="Exit status: 0 done; 2 bad input; 3 the solve ended badly; 4 it does "
        "not fit or not stand. Lengths are in mm.",
    )
    commands = parser.add_subparsers(
        metavar="COMMAND", required=True, title="commands", parser_class=_Parser
    )
    _add_solve(commands)
    _add_make(commands)
    _add_check(commands)
    _add_fit(commands)
    add_marker(commands)
    add_camera(commands)
    add_straighten(commands)
    _add_bench(commands)
    return parser


def _add_command(commands: Any, name: str, run: Any, text: str) -> argparse.ArgumentParser:
    command: argparse.ArgumentParser = commands.add_parser(
        name, help=text[0].lower() + text[1:].split(".")[0], description=text
    )
    command.add_argument("sketch", metavar="SKETCH", type=Path, help="a .sketch.json file")
    command.set_defaults(run=run)
    return command


def _add_solve(commands: Any) -> None:
    command = _add_command(
        commands, "solve", _solve, "Lift a sketch to 3D. Writes the solution file."
    )
    command.add_argument(
        "-o",
        "--output",
        metavar="SOLUTION.json",
        type=Path,
        help="where to write it (default: NAME.solution.json beside the sketch)",
    )
    command.add_argument(
        "--method",
        choices=METHODS,
        default=METHODS[0],
        help="which solver: ours (default), the paper's own or Lipson's, both slow",
    )
    command.add_argument(
        "--twin",
        action="store_true",
        help="the drawing's other reading, near and far exchanged (ours only)",
    )


def _add_check(commands: Any) -> None:
    _add_command(
        commands,
        "check",
        _check,
        "Say what is wrong or missing in a sketch. One line each; exit status 2 where a solve "
        "cannot succeed.",
    )


def _add_fit(commands: Any) -> None:
    from .make_options import add_settings

    command = _add_command(
        commands,
        "fit",
        _fit,
        "Say whether the new object fits and stands. What is traced on the photo as construction "
        "is there already: clearance, overlap and missing mm to each such thing; centre of mass "
        "and tipping angle; loose and thin parts. The options are those of make; nothing is "
        "written. Exit status 4 where it does not fit or not stand.",
    )
    add_settings(command)


def _add_bench(commands: Any) -> None:
    text = (
        "Compare the solver with the paper's method, Lipson's and SolveSpace's. Prints one table."
    )
    command = commands.add_parser("bench", help="compare the solvers", description=text)
    add = command.add_argument
    add("--runs", metavar="N", type=_count, help="views of each shape (5; 2 with --quick)")
    add("--study", action="store_true", help="how exact and how sure ours is, over random shapes")
    add("--speed", action="store_true", help="how fast ours is, to 1,000 vertices, and the ratios")
    add("--quick", action="store_true", help="small shapes and the table, about a minute")
    add("--examples", action="store_true", help="the shipped examples only: found beside true")
    add("--pictures", action="store_true", help="write figure8.png and figure9.png to build/bench")
    command.set_defaults(run=_bench)


def _count(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is no number of runs like 5")
    return int(text)


def _add_make(commands: Any) -> None:
    command = _add_command(
        commands,
        "make",
        _make,
        "Make parts of a sketch: plates for a laser cutter or a solid for a 3D printer. Writes "
        "NAME.dxf, .svg, .step, .plates.json (--laser), NAME.stl, .3mf, .step (--print; "
        "NAME.solid.step where both are asked), and always NAME.solution.json and NAME.png.",
    )
    from .make_options import add_make_options

    add_make_options(command)


def name_of(sketch: Path) -> str:
    """NAME: what stands before ``.sketch.json``."""
    name = sketch.name
    return name.removesuffix(ENDING) if name.endswith(ENDING) else name.removesuffix(".json")


def _load(path: Path) -> SketchGraph:
    from ..solver import load_sketch

    return load_sketch(path)


def _solution_text(solution: Solution) -> bytes:
    from ..solver.serialise import solution_to_text

    return solution_to_text(solution).encode()


def _check(arguments: argparse.Namespace) -> int:
    from ..solver import findings, solve
    from ..solver.editing.nearly_flat import message_with_wanting_faces
    from ..solver.perspective.vanishing_points import traced_lines
    from ..solver.solution import Status
    from .cropped_photos import perspective_notes
    from .photos import photo_problem
    from .straighten_command import lens_of_sketch

    graph = _load(arguments.sketch)
    found = [(str(f.severity), f.text) for f in findings(graph)]
    if not any(severity == "error" for severity, _ in found):
        # What only a solve shows: lengths that disagree, freedoms that are left.
        solution = solve(graph)
        message = message_with_wanting_faces(graph, solution)
        if solution.status is not Status.CONVERGED:
            found.insert(0, ("error", message))
        elif message != PLAIN:
            found.insert(0, ("warning", message))
        lens = lens_of_sketch(graph, arguments.sketch)
        notes = perspective_notes(graph, traced_lines(graph, solution))
        notes += () if lens is None else lens.notes
        found += [("warning", note) for note in notes]
    problem = photo_problem(graph, arguments.sketch)
    if problem:
        found.append(("warning", problem))
    for severity, text in found:
        print(" ".join(f"{severity}: {text}".split()))
    return BAD_INPUT if any(severity == "error" for severity, _ in found) else OK


def _fit(arguments: argparse.Namespace) -> int:
    from ..solver import solve
    from ..solver.solution import Status
    from .make_options import order_of
    from .making import checks

    order = order_of(arguments, name_of(arguments.sketch))
    graph = _load(arguments.sketch)
    solution = solve(graph)
    if solution.status is not Status.CONVERGED:
        return _verdict(graph, solution)
    found = checks(graph, solution, order)
    for check in found:
        for line in check.lines:
            print(line)
    _verdict(graph, solution)
    return OK if all(check.good for check in found) else BAD_FIT


def _solve(arguments: argparse.Namespace) -> int:
    from ..solver.files import write_files
    from .photos import photo_problem
    from .progress_line import ProgressLine

    graph = _load(arguments.sketch)
    problem = photo_problem(graph, arguments.sketch)
    if problem:
        _complain(f"warning: {problem}")
    progress = ProgressLine(sys.stderr)
    solution = _solver(arguments.method, twin=arguments.twin)(graph, progress=progress.tell)
    progress.clear()
    beside = arguments.sketch.with_name(name_of(arguments.sketch) + ".solution.json")
    output = arguments.output or beside
    write_files({output: _solution_text(solution)})
    return _verdict(graph, solution)


def _solver(method: str, *, twin: bool) -> Callable[..., Solution]:
    from ..solver import solve
    from ..solver.reference import METHODS as REFERENCES

    return partial(solve, twin=twin) if method == METHODS[0] else REFERENCES[method]


def _bench(arguments: argparse.Namespace) -> int:
    from .bench import Options, bench, speed, study, write_pictures
    from .bench.plates import plates_bench
    from .gallery.table import bench_lines

    if arguments.study:
        for line in study(arguments.runs or STUDY_RUNS):
            print(line, flush=True)
        return OK
    options = (Options.quick() if arguments.quick else Options.full()).with_runs(arguments.runs)
    if arguments.speed:
        for line in speed(options.shapes, options.runs):
            print(line, flush=True)
        return OK
    for line in bench_lines():
        print(line, flush=True)
    if arguments.examples:
        return OK
    print()
    for line in bench(options):
        print(line, flush=True)
    if not arguments.quick:
        for line in speed(options.shapes, options.runs):
            print(line, flush=True)
    for line in plates_bench():
        print(line, flush=True)
    if arguments.pictures:
        for path in write_pictures(Path("build") / "bench"):
            print(path)
    return OK


def _verdict(graph: SketchGraph, solution: Solution) -> int:
    """Say how a solve ended, where it did not end well."""
    from ..solver.editing.nearly_flat import message_with_wanting_faces
    from ..solver.solution import Status

    message = message_with_wanting_faces(graph, solution)
    if solution.status is not Status.CONVERGED:
        _complain(f"incontext: {solution.status.value}: {message}")
        return BAD_SOLVE
    if message != PLAIN:
        # Annotations that the drawing speaks against, a second shape, sizes that are unsure.
        _complain(f"warning: {message}")
    if solution.scale_assumed:
        _complain("warning: nothing says how large it is; the longest edge is taken as 100 mm")
    return OK


def _with_wanting_face(
    error: FabricationError, graph: SketchGraph, solution: Solution
) -> FabricationError:
    """The same error, with the nearly flat loop along the edges that it names, if there is one."""
    from ..solver.editing.nearly_flat import nearly_flat
    from .fabrication.errors import FabricationError

    named = {frozenset(solution.edges[id_]) for id_ in error.ids if id_ in solution.edges}
    for near in nearly_flat(graph, solution):
        if named & {frozenset(pair) for pair in pairwise((*near.loop, near.loop[0]))}:
            loop = " ".join(near.loop)
            flat = f"the loop {loop} is {near.off_mm:.2g} mm from flat, and so no face"
            remedy = f"right angles or parallels there, or take it for a face; {error.remedy}"
            return FabricationError(f"{error.what}; {flat}", error.ids, remedy)
    return error


def _make(arguments: argparse.Namespace) -> int:
    from ..solver import solve
    from ..solver.files import write_files
    from ..solver.solution import Status
    from .make_options import order_of
    from .photos import load_photo

    stem = name_of(arguments.sketch)
    order = order_of(arguments, stem)
    graph = _load(arguments.sketch)
    photo, problem = load_photo(graph, arguments.sketch)
    if problem:
        _complain(f"warning: {problem}")
    solution = solve(graph)
    contents = {f"{stem}.solution.json": _solution_text(solution)}
    details: tuple[str, ...] = ()
    if solution.status is Status.CONVERGED:
        from .fabrication.errors import FabricationError
        from .making import made

        try:
            product = made(graph, solution, photo, order)
        except FabricationError as error:
            raise _with_wanting_face(error, graph, solution) from error
        contents |= product.files
        for note in product.notes:
            _complain(f"note: {note}")
        details = product.details if arguments.explain else ()
    write_files({arguments.out / name: data for name, data in contents.items()})
    status = _verdict(graph, solution)
    for name in contents:
        print(arguments.out / name)
    for line in details:
        print(line)
    return status
