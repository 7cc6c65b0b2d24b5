"""Random shapes and settings for plates and prints, each held to the laws.

    python tests/hunting.py --count 50
    python tests/hunting.py --family star --first 17 --count 1

tells each case that breaks a law, is refused in words that help nobody, or takes too long; and
counts what was made and what was refused.
"""

from __future__ import annotations

import argparse
import os
import re
import signal
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from itertools import combinations, pairwise
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.insert(0, str(Path(__file__).parent))

import numpy as np
import shapely
from fabrication import shapes, slanted, strange
from fabrication.bodies import body, drawn_body, overlaps
from fabrication.print_laws import broken_print
from scipy.spatial import HalfspaceIntersection

from incontext.solver.model import Model
from incontext.workbench.fabrication import (
    FabricationError,
    PlateSettings,
    ShellSettings,
    joined_plates,
)
from incontext.workbench.fabrication.cut_paths import cut_path
from incontext.workbench.fabrication.errors import SettingsError
from incontext.workbench.fabrication.marks import edge_marks
from incontext.workbench.fabrication.plates import Joined, Plate
from incontext.workbench.fabrication.prisms import prism as prism_over
from incontext.workbench.fabrication.sheets import Sheet, lay_out

MAX_SECONDS = 60
Loops = dict[str, list[tuple[float, float, float]]]
Plan = list[tuple[float, float]]


# Shapes.


def _plan(rng: np.random.Generator, kind: str) -> Plan:
    if kind == "star":
        n = int(rng.integers(3, 6))
        turns = 2 * np.pi * (np.arange(2 * n) + rng.uniform(-0.2, 0.2, 2 * n)) / (2 * n)
        radii = np.where(np.arange(2 * n) % 2, rng.uniform(45, 75), rng.uniform(100, 140))
        points = np.round(np.c_[radii * np.cos(turns), radii * np.sin(turns)], 2)
        return [(x, y) for x, y in points.tolist()]
    if kind == "section":
        a, b, t = rng.uniform(120, 220), rng.uniform(90, 160), rng.uniform(35, 45)
        forms = {
            "L": [(0, 0), (a, 0), (a, t), (t, t), (t, b), (0, b)],
            "U": [(0, 0), (a, 0), (a, b), (a - t, b), (a - t, t), (t, t), (t, b), (0, b)],
            "T": [
                (0, 0), (a, 0), (a, t), (a / 2 + t / 2, t), (a / 2 + t / 2, b), (a / 2 - t / 2, b),
                (a / 2 - t / 2, t), (0, t),
            ],
            "H": [
                (0, 0), (t, 0), (t, b / 3), (a - t, b / 3), (a - t, 0), (a, 0), (a, b), (a - t, b),
                (a - t, b / 3 + t), (t, b / 3 + t), (t, b), (0, b),
            ],
        }  # fmt: skip
        plan = forms[str(rng.choice(list(forms)))]
        return [(round(float(x), 2), round(float(y), 2)) for x, y in plan]
    return slanted.random_plan(int(rng.integers(10**6)))[0]


def _scaled(loops: Loops, by: float) -> Loops:
    return {id_: [(x * by, y * by, z * by) for x, y, z in loop] for id_, loop in loops.items()}


def prism(rng: np.random.Generator) -> tuple[Loops, dict]:
    """Over any polygon."""
    return shapes.prism(_plan(rng, "any"), float(rng.uniform(40, 150))), {}


def star(rng: np.random.Generator) -> tuple[Loops, dict]:
    """Over a star, now and then with a hole in its top."""
    loops = shapes.prism(_plan(rng, "star"), float(rng.uniform(40, 120)))
    h = loops["top"][0][2]
    hole = [(15.0, -12.0, h), (15.0, 10.0, h), (-14.0, 12.0, h), (-9.0, -13.0, h)]
    return loops, {"holes": {"top": [hole]}} if rng.random() < 0.5 else {}


def section(rng: np.random.Generator) -> tuple[Loops, dict]:
    """L, U, T and H, some with an upright partition at an angle from side to side."""
    plan = _plan(rng, "section")
    h = float(rng.uniform(40, 120))
    loops = shapes.prism(plan, h)
    polygon = shapely.Polygon(plan)
    for n in range(int(rng.integers(0, 3))):
        i, j = rng.choice(len(plan), 2, replace=False)
        ends = []
        for k in (i, j):
            (x0, y0), (x1, y1) = plan[k], plan[(k + 1) % len(plan)]
            s = rng.uniform(0.3, 0.7)
            ends.append((round(x0 + s * (x1 - x0), 3), round(y0 + s * (y1 - y0), 3)))
        line = shapely.LineString(ends)
        if line.length > 20 and polygon.buffer(1e-3).covers(line):
            (x0, y0), (x1, y1) = ends
            loops[f"p{n}"] = [(x0, y0, 0), (x1, y1, 0), (x1, y1, h), (x0, y0, h)]
    return loops, {}


def convex(rng: np.random.Generator) -> tuple[Loops, dict]:
    """The hull of points: triangles, vertices of any valence."""
    return slanted.random_convex(int(rng.integers(10**6)))[0], {}


def halfspaces(rng: np.random.Generator) -> tuple[Loops, dict]:
    """What random half-spaces bound: polygons, three at each vertex."""
    n = int(rng.integers(5, 10))
    normals = rng.normal(size=(n, 3))
    normals = np.vstack([normals, -normals.sum(axis=0)])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    limits = rng.uniform(60, 110, len(normals))
    far = np.vstack([np.eye(3), -np.eye(3)])
    spaces = np.column_stack(
        [np.vstack([normals, far]), -np.concatenate([limits, np.full(6, 140.0)])]
    )
    points = HalfspaceIntersection(spaces, np.zeros(3)).intersections
    loops: Loops = {}
    for n, (a, b, c, d) in enumerate(spaces.tolist()):
        normal = np.array([a, b, c])
        corners = np.unique(np.round(points[np.abs(points @ normal + d) < 1e-7], 9), axis=0)
        if len(corners) < 3:
            continue
        u = np.cross(np.eye(3)[np.abs(normal).argmin()], normal)
        middle = corners.mean(axis=0)
        turns = np.arctan2((corners - middle) @ np.cross(normal, u), (corners - middle) @ u)
        loops[f"f{n}"] = [(x, y, z) for x, y, z in corners[np.argsort(turns)].tolist()]
    return loops, {}


def organizer(rng: np.random.Generator) -> tuple[Loops, dict]:
    """Orthogonal, each wall of its own thickness."""
    columns, rows = (
        [0.0, *np.cumsum(rng.integers(25, 90, int(rng.integers(1, 4)))).tolist()] for _ in range(2)
    )
    model = shapes.organizer(columns, rows, float(rng.integers(30, 90)))
    loops = _loops_of(model)
    thick = {
        id_: float(rng.choice([2, 3, 4, 6]))
        for id_ in dict.fromkeys(f.split(".")[0] for f in loops)
    }
    return loops, {"thickness": {id_: thick[id_.split(".")[0]] for id_ in loops}}


def _loops_of(model: Model) -> Loops:
    return {
        id_: [(x, y, z) for x, y, z in face.loop_mm.tolist()] for id_, face in model.faces.items()
    }


def polycube(rng: np.random.Generator) -> tuple[Loops, dict]:
    """Boxes side by side, some missing."""
    model = shapes.polycube(int(rng.integers(10**6)))
    left_out = [id_ for id_, face in model.faces.items() if not face.included]
    return _loops_of(model), {"left_out": left_out}


def slanted_lid(rng: np.random.Generator) -> tuple[Loops, dict]:
    """A box or section whose lid leans any way."""
    plan = _plan(rng, str(rng.choice(["any", "section", "star"])))
    low, a, b = rng.uniform(50, 90), *rng.uniform(-0.35, 0.35, 2)
    x0, y0 = np.min(plan, axis=0)
    x1, y1 = np.max(plan, axis=0)
    low += max(0.0, -a) * (x1 - x0) + max(0.0, -b) * (y1 - y0)
    loops = shapes.prism(plan, 1.0)

    def height(x: float, y: float) -> float:
        return float(low + a * (x - x0) + b * (y - y0))

    loops = {
        id_: [(x, y, height(x, y) if z else 0.0) for x, y, z in loop] for id_, loop in loops.items()
    }
    return loops, {}


def frustum(rng: np.random.Generator) -> tuple[Loops, dict]:
    """A polygon and the same smaller above it: edges that lean in or out."""
    plan = _plan(rng, str(rng.choice(["any", "star"])))
    by, h = rng.uniform(0.6, 1.3), float(rng.uniform(50, 120))
    top = [(round(x * by, 6), round(y * by, 6), h) for x, y in plan]
    bottom = [(x, y, 0.0) for x, y in plan]
    loops: Loops = {"bottom": bottom, "top": top}
    for n in range(len(plan)):
        m = (n + 1) % len(plan)
        loops[f"side{n}"] = [bottom[n], bottom[m], top[m], top[n]]
    return loops, {}


def spire(rng: np.random.Generator) -> tuple[Loops, dict]:
    """A tip over any polygon, concave ones too: a vertex with edges that look in and out."""
    plan = _plan(rng, str(rng.choice(["any", "star"])))
    bottom = [(x, y, 0.0) for x, y in plan]
    tip = (float(rng.uniform(-20, 20)), float(rng.uniform(-20, 20)), float(rng.uniform(60, 160)))
    loops: Loops = {"bottom": bottom}
    for n in range(len(plan)):
        loops[f"s{n}"] = [bottom[n], bottom[(n + 1) % len(plan)], tip]
    return loops, {}


def house(rng: np.random.Generator) -> tuple[Loops, dict]:
    """A box with a saddle roof, its ridge not in the middle; a shelf now and then."""
    w, d, h, r = (
        rng.uniform(90, 200),
        rng.uniform(70, 150),
        rng.uniform(50, 90),
        rng.uniform(30, 70),
    )
    x = w * rng.uniform(0.25, 0.75)
    w, d, h, r, x = (round(float(v), 2) for v in (w, d, h, r, x))
    gable = [(0.0, 0.0), (w, 0.0), (w, h), (x, h + r), (0.0, h)]
    loops: Loops = {
        "front": [(a, 0.0, z) for a, z in gable],
        "back": [(a, d, z) for a, z in gable],
    }
    for n, ((a, z), (b, y)) in enumerate(pairwise([*gable, gable[0]])):
        loops[f"w{n}"] = [(a, 0.0, z), (b, 0.0, y), (b, d, y), (a, d, z)]
    if rng.random() < 0.5:
        loops["loft"] = [(0.0, 0.0, h / 2), (w, 0.0, h / 2), (w, d, h / 2), (0.0, d, h / 2)]
    return loops, {}


def long(rng: np.random.Generator) -> tuple[Loops, dict]:
    """A thin, long duct."""
    w, d, h = float(rng.uniform(600, 2500)), float(rng.uniform(15, 60)), float(rng.uniform(15, 60))
    return shapes.box_loops(w, d, h), {}


FAMILIES: dict[str, Callable[[np.random.Generator], tuple[Loops, dict]]] = {
    f.__name__: f
    for f in (
        prism, star, section, convex, halfspaces, organizer, polycube, slanted_lid, frustum, spire,
        house, long, strange.halved, strange.plus, strange.fan, strange.pencil,
    )
}  # fmt: skip


def case(family: str, seed: int) -> tuple[Model, PlateSettings]:
    """A shape of a family, turned, perhaps of another size, with some faces left out."""
    rng = np.random.default_rng((list(FAMILIES).index(family), seed))
    loops, options = FAMILIES[family](rng)
    by = float(np.exp(rng.uniform(np.log(0.05), np.log(15)))) if rng.random() < 0.15 else 1.0
    t = round(float(rng.choice([1, 2, 3, 3, 4, 6])) * by, 3)
    if rng.random() < 0.15:
        t = round(float(rng.uniform(0.3, 12)), 2)
    options.setdefault("thickness", t if rng.random() < 0.7 else _unequal(rng, loops, t))
    if by != 1.0:
        options["holes"] = {
            f: [list(_scaled({"": h}, by)[""]) for h in holes]
            for f, holes in options.get("holes", {}).items()
        }
        if not isinstance(options["thickness"], float):
            options["thickness"] = {f: v * by for f, v in options["thickness"].items()}
    if rng.random() < 0.35 and "left_out" not in options:
        count = int(rng.integers(1, max(2, len(loops) // 3)))
        options["left_out"] = [str(f) for f in rng.choice(list(loops), count, replace=False)]
    turned = int(rng.integers(1000)) if rng.random() < 0.5 else None
    model = shapes.model(_scaled(loops, by), turned=turned, **options)
    settings = PlateSettings(
        side=str(rng.choice(["inside", "outside", "middle"])),
        finger_mm=max(0.5, round(float(rng.choice([6, 12, 12, 25, 60])) * by, 3)),
        play_mm=float(rng.choice([0, 0, 0.1])),
        kerf_mm=float(rng.choice([0, 0.1, 0.2, 2.0 if rng.random() < 0.2 else 0.3])),
        relief=str(rng.choice(["none", "none", "dogbone", "tbone"])),
        tool_mm=1.5,
        sheet_mm=(5000.0, 5000.0),
    )
    return model, settings


def _unequal(rng: np.random.Generator, loops: Loops, t: float) -> dict[str, float]:
    return {id_: round(t * float(rng.choice([0.7, 1, 1.5])), 3) for id_ in loops}


# Laws.


def broken(model: Model, settings: PlateSettings, joined: Joined) -> Iterator[str]:
    """Each law that plates break."""
    plates = joined.plates
    size = max(float(np.ptp(np.vstack([f.loop_mm for f in model.faces.values()]), axis=0).max()), 1)
    own = np.linalg.inv(plates[0].world_from_plate)
    for pair, volume in overlaps(plates, own).items():
        if volume > 1e-6 * max(1.0, (size / 300) ** 2):
            yield f"{pair} overlap by {volume:.3g} mm3"
    for plate in plates:
        yield from _of_plate(plate, settings)
        yield from _slots_near_borders(plate, plates)
    yield from _of_body(model, plates, settings.side)
    marks = edge_marks(plates, joined.joints)
    sheets = lay_out(plates, settings, marks)
    yield from _of_sheets(sheets, settings, plates)


def _of_body(model: Model, plates: tuple[Plate, ...], side: str) -> Iterator[str]:
    """Plates inside of the faces stay within, plates outside of them without."""
    drawn = drawn_body(model) if side != "middle" else None
    if drawn is None:
        return
    for plate in plates:
        solid = body(plate)
        within = (solid ^ drawn).volume()
        wrong = solid.volume() - within if side == "inside" else within
        # Corners are multiples of 1e-6 mm.
        if wrong > max(1e-2, 1e-5 * solid.surface_area()):
            yield f"{plate.id} lies on the wrong side of the faces with {wrong:.3g} mm3"


def _of_plate(plate: Plate, settings: PlateSettings) -> Iterator[str]:
    outline = shapely.LinearRing(plate.outline)
    if not outline.is_simple or not plate.polygon.is_valid:
        yield f"the outline of {plate.id} crosses itself"
    if plate.polygon.buffer(-0.04).geom_type != "Polygon":
        yield f"{plate.id} is in pieces"
    steps = np.linalg.norm(np.roll(plate.outline, -1, axis=0) - plate.outline, axis=1)
    if steps.min() < 1e-6:
        yield f"{plate.id} has an edge of {steps.min():.2g} mm"
    path = cut_path(plate, settings.kerf_mm)
    if len(path.inner) != len(plate.holes):
        yield f"{plate.id} lost a hole"
    if settings.kerf_mm:
        rings = [shapely.LinearRing(ring) for ring in (path.outer, *path.inner)]
        beam = shapely.union_all([r.buffer(settings.kerf_mm / 2 - 1e-5) for r in rings])
        lost = plate.polygon.intersection(beam).area
        if lost > 1e-5 * plate.polygon.length:
            yield f"the beam takes {lost:.3g} mm2 of {plate.id}"


def _slots_near_borders(plate: Plate, plates: tuple[Plate, ...]) -> Iterator[str]:
    """Slots nearer than one thickness to a border, drawn holes included."""
    rings = [shapely.LinearRing(ring) for ring in (plate.outline, *plate.holes)]
    filled = [False, *(_is_filled(plate, hole, plates) for hole in plate.holes)]
    for n, slot in enumerate(filled):
        gaps = [r.distance(rings[n]) for r, slot in zip(rings, filled, strict=True) if not slot]
        if slot and min(gaps) < plate.thickness_mm - 1e-5:
            yield (
                f"a slot of {plate.id} is {min(gaps):.3f} mm from a border, less than "
                f"{plate.thickness_mm} mm"
            )


def _is_filled(plate: Plate, hole: np.ndarray, plates: tuple[Plate, ...]) -> bool:
    room = prism_over(shapely.Polygon(hole), 0.0, plate.thickness_mm)
    room = room.transform(plate.world_from_plate[:3])
    return any((room ^ body(other)).volume() > 1e-3 for other in plates if other is not plate)


def _of_sheets(
    sheets: tuple[Sheet, ...], settings: PlateSettings, plates: tuple[Plate, ...]
) -> Iterator[str]:
    parts = [part for sheet in sheets for part in sheet.parts]
    if sorted(p.plate_id for p in parts) != sorted(p.id for p in plates):
        yield "a plate is on no sheet"
    for sheet in sheets:
        laid = [shapely.Polygon(p.outer) for p in sheet.parts]
        for a, b in combinations(laid, 2):
            if a.distance(b) < settings.spacing_mm - 1e-6:
                yield "two parts of a sheet are too near"
        for part in sheet.parts:
            area = shapely.Polygon(part.outer, part.inner)
            if not all(area.covers(shapely.LineString(s)) for s in part.name if len(s) > 1):
                yield f"the name or a mark of {part.plate_id} leaves it"


def in_words(error: FabricationError) -> bool:
    """Whether an error says what, where and what to try."""
    text = str(error)
    where = bool(error.ids) or bool(re.search(r"\d", text)) or isinstance(error, SettingsError)
    return "\n" not in text and "; try: " in text and where


# Prints.


def print_case(family: str, seed: int) -> tuple[Model, ShellSettings]:
    """A shape of a family, and a wall for it."""
    model, _ = case(family, seed)
    rng = np.random.default_rng((77, seed))
    size = float(np.ptp(np.array(list(model.vertices_mm.values())), axis=0).max())
    wall = round(float(rng.uniform(0.004, 0.04)) * size, 3)
    side = str(rng.choice(["inside", "outside", "middle"]))
    return model, ShellSettings(wall_mm=wall, side=side, least_wall_mm=0.0)


class _TooLongError(Exception):
    pass


def _alarm(*_: object) -> None:
    raise _TooLongError


def outcome(family: str, seed: int, *, printed: bool) -> tuple[str, list[str]]:
    """What became of a case: made, or why refused; and which laws were broken."""
    try:
        if printed:
            return "printed", list(broken_print(*print_case(family, seed)))
        model, settings = case(family, seed)
        return "made", list(broken(model, settings, joined_plates(model, settings)))
    except FabricationError as error:
        words = re.sub(r"\(.*?\)", "", re.sub(r"[\d.]+", "#", str(error)))
        words = re.sub(r"\b[a-z]+#(?:#)*\b", "@", words)
        return f"refused: {words}", [] if in_words(error) else [f"says only: {error}"]
    except _TooLongError:
        return "too long", [f"takes more than {MAX_SECONDS} s"]
    except Exception as error:
        return "fault", [f"{type(error).__name__}: {error}"]


def main() -> int:
    """Run the cases that were asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--family", action="append", choices=list(FAMILIES))
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--prints", action="store_true", help="hollow solids instead of plates")
    parser.add_argument("--reasons", action="store_true", help="tell every refusal")
    arguments = parser.parse_args()
    signal.signal(signal.SIGALRM, _alarm)
    bad = 0
    for family in arguments.family or FAMILIES:
        ends: Counter[str] = Counter()
        for seed in range(arguments.first, arguments.first + arguments.count):
            signal.alarm(MAX_SECONDS)
            start = time.perf_counter()
            end, laws = outcome(family, seed, printed=arguments.prints)
            signal.alarm(0)
            ends[end] += 1
            bad += bool(laws)
            for law in laws[:3]:
                print(f"{family} {seed}: {law}", flush=True)
            if arguments.reasons and end not in ("made", "printed"):
                print(f"{family} {seed}: {end}")
            if time.perf_counter() - start > 20:
                print(f"{family} {seed}: {time.perf_counter() - start:.0f} s", flush=True)
        for end, count in ends.most_common():
            print(f"{family:>12} {count:4d} {end}", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
