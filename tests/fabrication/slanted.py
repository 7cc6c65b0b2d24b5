"""Models with walls and partitions at any angle, on purpose without symmetry."""

import math

import numpy as np
import shapely
from scipy.spatial import ConvexHull

from . import shapes

HEXAGON = [(50, 0), (150, 0), (205, 85), (150, 180), (45, 170), (0, 90)]
PENTAGON = [(0, 0), (140, 0), (170, 80), (60, 140), (-20, 70)]


def hexagon_with_shelf(**options):
    """Closed; the shelf ends on six walls at right angles."""
    loops = shapes.prism(HEXAGON, 70)
    loops["shelf"] = [(x, y, 30.0) for x, y in HEXAGON]
    return shapes.model(loops, **options)


def leaning(degrees: float = 60.0, **options):
    """An open box with one partition that leans, from the bottom to the opening."""
    loops = shapes.box_loops(200, 100, 90)
    over = 90 / math.tan(math.radians(degrees))
    loops["lean"] = [(80, 0, 0), (80 + over, 0, 90), (80 + over, 100, 90), (80, 100, 0)]
    return shapes.model(loops, left_out=("top",), **options)


def crossed(**options):
    """Two upright partitions that cross at another angle than they meet the walls."""
    loops = shapes.box_loops(200, 120, 60)
    loops["d1"] = [(40, 0, 0), (150, 120, 0), (150, 120, 60), (40, 0, 60)]
    loops["d2"] = [(60, 120, 0), (170, 0, 0), (170, 0, 60), (60, 120, 60)]
    return shapes.model(loops, left_out=("top",), **options)


def shelf_and_divider(**options):
    """A pentagonal bin with a shelf, and a divider that stands on the shelf."""
    loops = shapes.prism(PENTAGON, 120)
    loops["shelf"] = [(x, y, 50.0) for x, y in PENTAGON]
    y = 140 - 10 * 70 / 80
    loops["divider"] = [(70, 0, 50), (70, 0, 120), (50, y, 120), (50, y, 50)]
    return shapes.model(loops, left_out=("top",), **options)


def diagonal(**options):
    """A partition from corner to corner, where the walls' fingers are."""
    loops = shapes.box_loops(120, 80, 60)
    loops["diagonal"] = [(0, 0, 0), (120, 80, 0), (120, 80, 60), (0, 0, 60)]
    return shapes.model(loops, left_out=("top",), **options)


def from_both_sides(**options):
    """Boards that lean on a wall from both sides, along one line."""
    loops = shapes.box_loops(240, 100, 90)
    loops["mid"] = [(120, 0, 0), (120, 100, 0), (120, 100, 90), (120, 0, 90)]
    loops["l"] = [(40, 0, 0), (120, 0, 50), (120, 100, 50), (40, 100, 0)]
    loops["r"] = [(190, 0, 0), (120, 0, 50), (120, 100, 50), (190, 100, 0)]
    return shapes.model(loops, left_out=("top",), **options)


def vee(**options):
    """Two boards that lean to both sides from one line of the bottom."""
    loops = shapes.box_loops(240, 100, 90)
    loops["l"] = [(120, 0, 0), (60, 0, 90), (60, 100, 90), (120, 100, 0)]
    loops["r"] = [(120, 0, 0), (170, 0, 90), (170, 100, 90), (120, 100, 0)]
    return shapes.model(loops, left_out=("top",), **options)


def leaning_unequal(**options):
    thickness = {"bottom": 5, "top": 3, "front": 3, "back": 4, "left": 3, "right": 6, "lean": 2}
    return leaning(50.0, thickness=thickness, **options)


def eaves(**options):
    """A desk whose slanted top reaches beyond its walls, which end on it."""
    loops = shapes.prism([(0, 0), (110, 0), (110, 150), (0, 150)], 1.0)

    def height(x):
        return 70 + 0.3 * x

    loops = {
        id_: [(x, y, height(x) if z else 0.0) for x, y, z in loop] for id_, loop in loops.items()
    }
    corners = [(-20, -15), (130, -15), (130, 165), (-20, 165)]
    loops["top"] = [(x, y, height(x)) for x, y in corners]
    return shapes.model(loops, **options)


PARTITIONED = {
    "hexagon with shelf": hexagon_with_shelf,
    "leaning": leaning,
    "crossed": crossed,
    "shelf and divider": shelf_and_divider,
    "diagonal": diagonal,
    "from both sides": from_both_sides,
    "vee": vee,
    "leaning, unequal": leaning_unequal,
}


def many_sided(n: int = 9, **options):
    """A frustum with n sides, no two alike: few plates leave square to themselves."""
    turns = 2 * np.pi * np.arange(n) / n + 0.1 * np.sin(np.arange(n))
    low = [(100 * np.cos(t), 80 * np.sin(t), 0.0) for t in turns]
    high = [(1.2 * x, 1.2 * y, 90.0) for x, y, _ in low]
    loops = {"bottom": low, "top": high}
    for k in range(n):
        m = (k + 1) % n
        loops[f"s{k}"] = [low[k], low[m], high[m], high[k]]
    return shapes.model(loops, **options)


def void_mm2(theta: float, t: float) -> float:
    """What two plates of one thickness must leave empty, mm3 for each mm of their edge."""
    if theta <= math.pi / 2:
        return t**2 / math.tan(theta)
    phi = math.pi - theta
    lens = (1 - math.cos(phi)) * (math.sin(phi) - math.tan(phi / 2))
    return t**2 / 2 * (math.sin(phi) * math.cos(phi) + lens)


def random_plan(seed: int) -> tuple[list[tuple[float, float]], list[float]]:
    """A polygon, often with corners that look inwards, and its interior angles, rad."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(3, 8))
    while True:
        turns, radii = np.sort(rng.uniform(0, 2 * np.pi, n)), rng.uniform(50, 130, n)
        points = np.round(np.c_[radii * np.cos(turns), radii * np.sin(turns)], 3)
        polygon = shapely.Polygon(points)
        ahead, back = np.roll(points, -1, axis=0) - points, np.roll(points, 1, axis=0) - points
        lengths = np.linalg.norm(ahead, axis=1)
        if not polygon.is_valid or not polygon.exterior.is_ccw or lengths.min() < 35:
            continue
        angles = np.arctan2(back[:, 1], back[:, 0]) - np.arctan2(ahead[:, 1], ahead[:, 0])
        angles %= 2 * np.pi
        folded = np.minimum(angles, 2 * np.pi - angles)
        inner = polygon.buffer(-12, join_style="mitre", mitre_limit=50)
        whole = inner.geom_type == "Polygon" and len(inner.exterior.coords) == n + 1
        if whole and folded.min() > math.radians(40) and folded.max() < math.radians(175):
            return [tuple(p) for p in points.tolist()], angles.tolist()


def random_convex(seed: int) -> tuple[dict[str, list[tuple[float, float, float]]], np.ndarray]:
    """Loops and corners of a convex body; faces of three corners, vertices of any valence."""
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(int(rng.integers(5, 9)), 3))
    points *= rng.uniform(80, 100, (len(points), 1)) / np.linalg.norm(points, axis=1)[:, None]
    points = np.round(points, 3)
    hull = ConvexHull(points)
    loops = {}
    for n, (corners, plane) in enumerate(zip(hull.simplices, hull.equations, strict=True)):
        a, b, c = points[corners]
        loop = [a, b, c] if np.cross(b - a, c - a) @ plane[:3] > 0 else [a, c, b]
        loops[f"f{n + 1}"] = [tuple(p.tolist()) for p in loop]
    return loops, points
