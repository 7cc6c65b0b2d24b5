"""Models built by hand, with known truth.

A model is a mapping of face ids to loops of corners; equal corners are one vertex.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from incontext.solver.model import Model, ModelFace

Point = tuple[float, float, float]
Loops = Mapping[str, Sequence[Point]]


def rotation(seed: int) -> np.ndarray:
    """A random proper rotation."""
    q, r = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else q[:, [1, 0, 2]]


def model(
    loops: Loops,
    *,
    left_out: Sequence[str] = (),
    thickness: float | Mapping[str, float] = 3.0,
    holes: Mapping[str, Sequence[Sequence[Point]]] | None = None,
    turned: int | None = None,
    moved: Point = (0.0, 0.0, 0.0),
) -> Model:
    """A model of faces given by their corners, perhaps turned and moved in the world."""
    turn = np.eye(3) if turned is None else rotation(turned)
    ids: dict[Point, str] = {}
    vertices: dict[str, np.ndarray] = {}

    def named(loop: Sequence[Point]) -> tuple[str, ...]:
        for point in loop:
            if tuple(point) not in ids:
                ids[tuple(point)] = f"v{len(ids) + 1}"
                vertices[ids[tuple(point)]] = turn @ np.array(point, float) + moved
        return tuple(ids[tuple(point)] for point in loop)

    def placed(loop: tuple[str, ...]) -> np.ndarray:
        return np.array([vertices[v] for v in loop])

    faces = {}
    edges: dict[frozenset[str], str] = {}
    for id_, points in loops.items():
        loop = named(points)
        inner = tuple(named(hole) for hole in (holes or {}).get(id_, ()))
        t = thickness if isinstance(thickness, int | float) else thickness[id_]
        faces[id_] = ModelFace(
            loop, placed(loop), inner, tuple(map(placed, inner)), float(t), id_ not in left_out
        )
        for a, b in pairwise((*loop, loop[0])):
            edges.setdefault(frozenset((a, b)), f"e{len(edges) + 1}")
    named_edges = {id_: tuple(sorted(ends)) for ends, id_ in edges.items()}
    return Model(faces, vertices, named_edges)


def rect(axis: int, at: float, u: tuple[float, float], v: tuple[float, float]) -> list[Point]:
    """A rectangle across an axis; u and v are ranges along the two following axes."""
    corners = []
    for a, b in ((u[0], v[0]), (u[1], v[0]), (u[1], v[1]), (u[0], v[1])):
        point = [0.0, 0.0, 0.0]
        point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = at, a, b
        corners.append(tuple(point))
    return corners


def box_loops(w: float, d: float, h: float) -> dict[str, list[Point]]:
    """Bottom, top, front, back, left, right."""
    return {
        "bottom": rect(2, 0, (0, w), (0, d)),
        "top": rect(2, h, (0, w), (0, d)),
        "front": rect(1, 0, (0, h), (0, w)),
        "back": rect(1, d, (0, h), (0, w)),
        "left": rect(0, 0, (0, d), (0, h)),
        "right": rect(0, w, (0, d), (0, h)),
    }


def box(w: float = 120, d: float = 80, h: float = 60, **options) -> Model:
    return model(box_loops(w, d, h), **options)


def tray(w: float = 150, d: float = 90, h: float = 40, **options) -> Model:
    """Five faces, no lid."""
    loops = box_loops(w, d, h)
    del loops["top"]
    return model(loops, **options)


def bookshelf(w: float = 200, d: float = 90, h: float = 160, shelf: float = 75, **options) -> Model:
    """Bottom, top, two sides, back, one shelf; the front is open."""
    loops = box_loops(w, d, h)
    del loops["front"]
    # The shelf's edges split the faces on which it ends, as they do in a drawing.
    loops["left"] = [(0, 0, 0), (0, d, 0), (0, d, shelf), (0, d, h), (0, 0, h), (0, 0, shelf)]
    loops["right"] = [(w, y, z) for _, y, z in loops["left"]]
    loops["shelf"] = rect(2, shelf, (0, w), (0, d))
    return model(loops, **options)


def l_box(**options) -> Model:
    """A closed box over an L: eight faces, one inner corner."""
    plan = [(0, 0), (140, 0), (140, 60), (80, 60), (80, 110), (0, 110)]
    return model(prism(plan, 50), **options)


def prism(plan: Sequence[tuple[float, float]], h: float) -> dict[str, list[Point]]:
    """Bottom, top and one side for each edge of the plan."""
    loops = {"bottom": [(x, y, 0) for x, y in plan], "top": [(x, y, h) for x, y in plan]}
    for n, ((x0, y0), (x1, y1)) in enumerate(pairwise((*plan, plan[0])), start=1):
        loops[f"side{n}"] = [(x0, y0, 0), (x1, y1, 0), (x1, y1, h), (x0, y0, h)]
    return loops


def organizer(columns: Sequence[float], rows: Sequence[float], h: float, **options) -> Model:
    """An open box with partitions both ways, every piece between two crossings its own face."""
    loops: dict[str, list[Point]] = {}
    w, d = columns[-1], rows[-1]
    loops["bottom"] = rect(2, 0, (0, w), (0, d))
    for n, x in enumerate(columns):
        if n in (0, len(columns) - 1):
            loops[f"x{n}"] = rect(0, x, (0, d), (0, h))
        else:
            for m, (y0, y1) in enumerate(pairwise(rows)):
                loops[f"x{n}.{m}"] = rect(0, x, (y0, y1), (0, h))
    for n, y in enumerate(rows):
        if n in (0, len(rows) - 1):
            loops[f"y{n}"] = rect(1, y, (0, h), (0, w))
        else:
            for m, (x0, x1) in enumerate(pairwise(columns)):
                loops[f"y{n}.{m}"] = rect(1, y, (0, h), (x0, x1))
    return model(loops, **options)


def organizer_6(**options) -> Model:
    return organizer((0, 55, 120, 180), (0, 70, 130), 45, **options)


def organizer_8(**options) -> Model:
    return organizer((0, 50, 110, 165, 230), (0, 80, 150), 60, **options)


def bracket(**options) -> Model:
    """Two faces only."""
    return model(
        {"floor": rect(2, 0, (0, 100), (0, 60)), "wall": rect(0, 0, (0, 60), (0, 70))}, **options
    )


def board(**options) -> Model:
    """A single face."""
    return model({"f1": rect(2, 50, (0, 100), (0, 60))}, **options)


def magazine_file(**options) -> Model:
    """Sides with a border aslant; the top is open, nothing was drawn there."""
    side = [(0, 0, 0), (0, 200, 0), (0, 200, 220), (0, 60, 220), (0, 0, 100)]
    return model(
        {
            "bottom": rect(2, 0, (0, 90), (0, 200)),
            "left": side,
            "right": [(90, y, z) for _, y, z in side],
            "back": rect(1, 200, (0, 220), (0, 90)),
            "front": rect(1, 0, (0, 100), (0, 90)),
        },
        **options,
    )


def polycube(seed: int, **options) -> Model:
    """A random body of boxes: some of them missing, some faces left out, some partitions."""
    rng = np.random.default_rng(seed)
    count = rng.integers(1, 4, 3)
    lines = [[0.0, *np.cumsum(rng.integers(18, 80, n)).astype(float).tolist()] for n in count]
    solid = np.zeros(count + 2, dtype=bool)
    solid[1:-1, 1:-1, 1:-1] = rng.random(count) < 0.75
    solid[1, 1, 1] = True
    loops: dict[str, list[Point]] = {}
    left_out = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for place in np.ndindex(*count + np.eye(3, dtype=int)[axis]):
            here = np.array(place) + 1
            before = here - np.eye(3, dtype=int)[axis]
            inner = solid[tuple(before)] and solid[tuple(here)]
            outer = solid[tuple(before)] != solid[tuple(here)]
            if outer or (inner and rng.random() < 0.5):
                id_ = f"f{len(loops)}"
                ends = [(lines[k][place[k]], lines[k][place[k] + 1]) for k in (u, v)]
                loops[id_] = rect(axis, lines[axis][place[axis]], *ends)
                if outer and rng.random() < 0.2:
                    left_out.append(id_)
    return model(loops, left_out=left_out[1:], **options)


def slab_volume(w: float, d: float, h: float, t: float, *, lid: bool = True) -> float:
    """Walls of a box, the material inside, with or without its lid."""
    return w * d * h - (w - 2 * t) * (d - 2 * t) * (h - (2 if lid else 1) * t)


def divided_shelf(**options) -> Model:
    """An open box with a shelf and a divider through one another; no wall is split by them."""
    loops = box_loops(180, 70, 200)
    del loops["front"]
    loops["shelf"] = rect(2, 90, (0, 180), (0, 70))
    loops["divider"] = rect(0, 60, (0, 70), (0, 200))
    return model(loops, **options)


def table_tray(**options) -> Model:
    """A box whose bottom hangs 20 mm above its lower border, with a hole in the back."""
    loops = box_loops(130, 90, 70)
    loops["bottom"] = rect(2, 20, (0, 130), (0, 90))
    hole = [(40, 90, 40), (40, 90, 55), (90, 90, 55), (90, 90, 40)]
    return model(loops, left_out=("top",), holes={"back": [hole]}, **options)


@dataclass(frozen=True)
class Truth:
    """A shape, and the volume of its walls for material `o` outside and `i` inside of the faces."""

    make: Callable[..., Model]
    volume: Callable[[float, float], float]


def _l_area(grow: float) -> float:
    # One inner corner: the notch of 60 x 50 shrinks as the rest grows.
    return (140 + 2 * grow) * (110 + 2 * grow) - 60 * 50


def _organizer(w: float, d: float, h: float, nx: int, ny: int, o: float, i: float) -> float:
    hollow = (w - 2 * i - nx * (o + i)) * (d - 2 * i - ny * (o + i)) * (h - i)
    return (w + 2 * o) * (d + 2 * o) * (h + o) - hollow


def _magazine(o: float, i: float) -> float:
    side = 200 * 220 - 60 * 120 / 2 + o * (200 + 2 * o) + o * 220 + o * 100
    between = (o + i) * (200 + 2 * o) + (o + i) * (220 - i) + (o + i) * (100 - i)
    return 2 * (o + i) * side + (90 - 2 * i) * between


def _divided(o: float, i: float) -> float:
    t = o + i
    hollow = (180 - 2 * i - t) * (70 - i) * (200 - 2 * i - t)
    return (180 + 2 * o) * (70 + o) * (200 + 2 * o) - hollow


def _table_tray(o: float, i: float) -> float:
    t = o + i
    ring = (130 + 2 * o) * (90 + 2 * o) - (130 - 2 * i) * (90 - 2 * i)
    return ring * 70 + (130 - 2 * i) * (90 - 2 * i) * t - 50 * 15 * t


TRUTHS = {
    "box": Truth(box, lambda o, i: _grown(120, 80, 60, o, 2) - _grown(120, 80, 60, -i, 2)),
    "tray": Truth(tray, lambda o, i: _grown(150, 90, 40, o, 1) - _grown(150, 90, 40, -i, 1)),
    "bookshelf": Truth(
        bookshelf,
        lambda o, i: (
            (200 + 2 * o) * (90 + o) * (160 + 2 * o)
            - (200 - 2 * i) * (90 - i) * (160 - 2 * i - (o + i))
        ),
    ),
    "l_box": Truth(l_box, lambda o, i: _l_area(o) * (50 + 2 * o) - _l_area(-i) * (50 - 2 * i)),
    "organizer_6": Truth(organizer_6, lambda o, i: _organizer(180, 130, 45, 2, 1, o, i)),
    "organizer_8": Truth(organizer_8, lambda o, i: _organizer(230, 150, 60, 3, 1, o, i)),
    "bracket": Truth(bracket, lambda o, i: 60 * ((100 + o) * (70 + o) - (100 - i) * (70 - i))),
    "board": Truth(board, lambda o, i: 100 * 60 * (o + i)),
    "magazine_file": Truth(magazine_file, _magazine),
    "divided_shelf": Truth(divided_shelf, _divided),
    "table_tray": Truth(table_tray, _table_tray),
}


def _grown(w: float, d: float, h: float, grow: float, ends: int) -> float:
    return (w + 2 * grow) * (d + 2 * grow) * (h + ends * grow)


def wall_volume(name: str, side: str, t: float = 3.0) -> float:
    """Volume of all walls of a shape, by hand."""
    out = {"inside": 0.0, "outside": t, "middle": t / 2}[side]
    return TRUTHS[name].volume(out, t - out)
