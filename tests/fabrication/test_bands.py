"""Plates at any angles: no overlap, nothing outside, one piece, and no more void than must be."""

import itertools
import math

import manifold3d as m3
import numpy as np
import pytest
import shapely
from fabrication import shapes, slanted
from fabrication.bodies import body, drawn_body, overlaps, union
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from incontext.workbench.fabrication import (
    FabricationError,
    PlateSettings,
    joined_plates,
    make_plates,
)
from incontext.workbench.fabrication.dihedral import tip_and_notch
from incontext.workbench.fabrication.frame import newell

CHEVRON = [(0, 0), (60, 40), (120, 0), (120, 60), (60, 100), (0, 60)]


def frustum(low: float, high: float, h: float, n: int, **options):
    """A prism that widens or narrows; a pyramid where `high` is 0."""
    angles = 2 * np.pi * (np.arange(n) + 0.5) / n
    bottom = [(low * math.cos(a), low * math.sin(a), 0.0) for a in angles]
    top = [(high * math.cos(a), high * math.sin(a), float(h)) for a in angles]
    loops = {"bottom": bottom}
    if high:
        loops["top"] = top
    for k in range(n):
        m = (k + 1) % n
        sides = [bottom[k], bottom[m], top[m], top[k]]
        loops[f"side{k}"] = sides if high else [*sides[:2], (0.0, 0.0, float(h))]
    return shapes.model(loops, **options)


MODELS = {
    "hexagonal box": lambda: shapes.model(shapes.prism(slanted.HEXAGON, 70), turned=4),
    "open hexagonal box": lambda: shapes.model(
        shapes.prism(slanted.HEXAGON, 70), left_out=("top",)
    ),
    "chevron": lambda: shapes.model(shapes.prism(CHEVRON, 60), turned=1),
    "frustum": lambda: frustum(60, 90, 100, 4),
    "planter": lambda: frustum(60, 90, 100, 6, left_out=("top",)),
    "tetrahedron": lambda: frustum(80, 0, 120, 3),
    "pyramid": lambda: frustum(80, 0, 90, 6),
    "leaning pyramid": lambda: shapes.model(
        {
            "bottom": [(0, 0, 0), (150, 0, 0), (140, 110, 0), (10, 90, 0)],
            "s1": [(0, 0, 0), (150, 0, 0), (60, 40, 95)],
            "s2": [(150, 0, 0), (140, 110, 0), (60, 40, 95)],
            "s3": [(140, 110, 0), (10, 90, 0), (60, 40, 95)],
            "s4": [(10, 90, 0), (0, 0, 0), (60, 40, 95)],
        }
    ),
    "unequal": lambda: frustum(
        90,
        60,
        80,
        4,
        thickness={"bottom": 6, "top": 3, "side0": 3, "side1": 4, "side2": 2, "side3": 5},
    ),
}


@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
@pytest.mark.parametrize("name", MODELS)
def test_laws(name, side):
    model = MODELS[name]()
    plates = make_plates(model, PlateSettings(side=side))
    assert [plate.id for plate in plates] == [f for f in model.faces if model.faces[f].included]
    assert max(overlaps(plates).values()) <= 1e-6
    for plate in plates:
        assert shapely.LinearRing(plate.outline).is_simple
        assert plate.polygon.buffer(-0.05).geom_type == "Polygon"
        assert plate.thickness_mm == model.faces[plate.id].thickness_mm
    if name != "chevron":
        hull = m3.Manifold.hull_points(np.array(list(model.vertices_mm.values())))
        if side == "inside":
            assert (union(plates) - hull).volume() <= 1e-3
        elif side == "outside" and name != "open hexagonal box":
            assert (union(plates) ^ hull).volume() <= 1e-3


@pytest.mark.parametrize(("name", "most"), [("hexagonal box", 0.006), ("pyramid", 0.045)])
def test_the_void_is_small(name, most):
    model = MODELS[name]()
    total = sum(body(plate).volume() for plate in make_plates(model))
    hull = m3.Manifold.hull_points(np.array(list(model.vertices_mm.values())))
    if name == "hexagonal box":
        plan = shapely.Polygon(slanted.HEXAGON)
        walls = plan.area * 70 - plan.buffer(-3, join_style="mitre").area * 64
    else:
        # A body around a sphere: the hollow is the whole, smaller by the sphere's radius.
        apothem, h = 80 * math.cos(math.pi / 6), 90.0
        radius = apothem * h / (apothem + math.hypot(apothem, h))
        walls = hull.volume() * (1 - ((radius - 3) / radius) ** 3)
    assert walls * (1 - most) < total < walls


@pytest.mark.parametrize("degrees", [35, 60, 75, 100, 120, 145])
def test_the_void_is_exactly_what_a_square_cut_leaves(degrees):
    theta, t, width, length = math.radians(degrees), 3.0, 60.0, 120.0
    far = (width * math.cos(theta), width * math.sin(theta))
    loops = {
        "floor": [(0, 0, 0), (width, 0, 0), (width, length, 0), (0, length, 0)],
        "wall": [(0, 0, 0), (0, length, 0), (far[0], length, far[1]), (far[0], 0, far[1])],
    }
    plates = make_plates(shapes.model(loops))
    total = sum(body(plate).volume() for plate in plates)
    area = 2 * width * t - t**2 / math.tan(theta / 2) - slanted.void_mm2(theta, t)
    assert total == pytest.approx(area * length, rel=1e-6)
    assert max(overlaps(plates).values()) <= 1e-6


def test_the_right_angle_is_the_common_border_of_both_formulas():
    for other in (2.0, 3.0, 5.0):
        for theta in (math.pi / 2 - 1e-7, math.pi / 2, math.pi / 2 + 1e-7):
            assert tip_and_notch(theta, 3.0, other) == pytest.approx((0.0, other), abs=1e-5)
        concave = tip_and_notch(3 * math.pi / 2, 3.0, other)
        assert concave == pytest.approx((-other, 0.0), abs=1e-9)


@settings(max_examples=14, deadline=None, derandomize=True)
@given(st.integers(0, 10**6))
def test_random_prisms_leave_what_square_cuts_must(seed):
    """Any angles, some looking inwards: the void is the closed form along each upright edge."""
    plan, angles = slanted.random_plan(seed)
    h, t = 60.0, 3.0
    plates = make_plates(shapes.model(shapes.prism(plan, h)))
    assert max(overlaps(plates).values()) <= 1e-6
    polygon = shapely.Polygon(plan)
    inner = polygon.buffer(-t, join_style="mitre", mitre_limit=50)
    walls = polygon.area * h - inner.area * (h - 2 * t)
    void = sum(slanted.void_mm2(min(a, 2 * math.pi - a), t) for a in angles) * (h - 2 * t)
    assert sum(body(plate).volume() for plate in plates) == pytest.approx(walls - void, rel=2e-6)
    block = m3.Manifold.extrude(m3.CrossSection([np.array(plan)]), h)
    assert (union(plates) - block).volume() <= 1e-3
    assert all(plate.polygon.buffer(-0.05).geom_type == "Polygon" for plate in plates)


@pytest.mark.parametrize("seed", [1, 3, 5, 7, 9, 13, 15, 33, 37, 55])
def test_random_convex_bodies(seed):
    """Vertices of any valence, edges of any angle; flat ones are butted, and it is said."""
    loops, points = slanted.random_convex(seed)
    joined = joined_plates(shapes.model(loops))
    assert max(overlaps(joined.plates).values()) <= 1e-6
    assert (union(joined.plates) - m3.Manifold.hull_points(points)).volume() <= 1e-3
    for plate in joined.plates:
        assert shapely.LinearRing(plate.outline).is_simple
        assert plate.polygon.buffer(-0.05).geom_type == "Polygon"
    for joint in joined.joints:
        degrees = math.degrees(joint.meeting.theta_rad)
        if not 30 <= degrees <= 150:
            assert joint.kind == "butt"
            assert "30 to 150 degrees" in joint.reason


@settings(max_examples=10, deadline=None, derandomize=True)
@given(st.integers(0, 10**6), st.sampled_from(["inside", "outside", "middle"]))
def test_random_convex_bodies_of_any_side(seed, side):
    """Where more than three moved planes meet in no point, the corner is split."""
    loops, points = slanted.random_convex(seed)
    try:
        joined = joined_plates(shapes.model(loops), PlateSettings(side=side))
    except FabricationError as refused:
        # A sliver of a face, of which its joints would leave little or nothing.
        assume(not refused.ids)
        raise
    assert max(overlaps(joined.plates).values()) <= 1e-6
    hull = m3.Manifold.hull_points(points)
    if side == "inside":
        assert (union(joined.plates) - hull).volume() <= 1e-3
    if side == "outside":
        assert (union(joined.plates) ^ hull).volume() <= 1e-3
    assert all(plate.polygon.buffer(-0.05).geom_type == "Polygon" for plate in joined.plates)


def test_outside_of_a_pyramid_of_unequal_plates_leaves_the_void_that_it_must():
    """The body of half-spaces moved outwards, less the drawn one, is nearly filled."""
    model = MODELS["leaning pyramid"]()
    drawn = m3.Manifold.hull_points(np.array(list(model.vertices_mm.values())))
    outer = m3.Manifold.cube([1000.0] * 3, center=True)
    for face in model.faces.values():
        a, b, c = face.loop_mm[:3]
        normal = np.cross(b - a, c - a) / np.linalg.norm(np.cross(b - a, c - a))
        middle = np.mean(list(model.vertices_mm.values()), axis=0)
        normal = normal if normal @ (a - middle) > 0 else -normal
        outer = outer.trim_by_plane(-normal, float(-normal @ a) - 3.0)
    whole = union(make_plates(model, PlateSettings(side="outside")))
    walls = outer.volume() - drawn.volume()
    assert (whole - outer).volume() <= 1e-3
    assert 0.93 * walls < whole.volume() < walls


def spire(thickness) -> shapes.Model:
    """A tip over a plan that looks inwards twice: its edges there are convex and concave."""
    plan = [(0, 0), (60, 40), (120, 0), (130, 70), (60, 100), (0, 60)]
    loops = {"bottom": [(x, y, 0.0) for x, y in plan]}
    for n, (a, b) in enumerate(itertools.pairwise((*plan, plan[0]))):
        loops[f"s{n}"] = [(*a, 0.0), (*b, 0.0), (60.0, 62.0, 90.0)]
    chosen = thickness if isinstance(thickness, float) else dict(zip(loops, thickness, strict=True))
    return shapes.model(loops, thickness=chosen, turned=3)


@pytest.mark.parametrize("thickness", [3.0, (3, 2, 4, 3, 5, 2, 3)])
@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
def test_a_vertex_of_convex_and_concave_edges(side, thickness):
    """Its moved planes meet in no point and bound no cone: each plate ends by itself."""
    model = spire(thickness)
    plates = make_plates(model, PlateSettings(side=side))
    assert max(overlaps(plates).values()) <= 1e-6
    drawn = drawn_body(model)
    for plate in plates:
        solid, whole = body(plate), model.faces[plate.id]
        wrong = {"inside": solid - drawn, "outside": solid ^ drawn}.get(side, m3.Manifold())
        assert wrong.volume() <= 1e-3
        assert plate.polygon.buffer(-0.05).geom_type == "Polygon"
        # Not cut off either: most of the face is covered.
        assert plate.polygon.area > 0.75 * np.linalg.norm(newell(whole.loop_mm))


def test_a_plate_ends_at_an_opening_beside_an_edge_that_looks_inwards():
    """Material outside of the faces next to the open side of an arrow: none of it in the arrow."""
    plan = [(0, 0), (60, 20), (120, 0), (60, 110)]
    model = shapes.model(shapes.prism(plan, 60), left_out=("side1",))
    drawn = drawn_body(model)
    plates = make_plates(model, PlateSettings(side="outside"))
    assert max((body(plate) ^ drawn).volume() for plate in plates) <= 1e-3


def test_fingers_that_would_cut_a_plate_are_left_out_and_it_is_said():
    loops, _ = slanted.random_convex(3)
    joined = joined_plates(shapes.model(loops), PlateSettings(side="middle"))
    said = [j for j in joined.joints if j.reason.startswith("fingers would cut")]
    assert said
    assert {j.kind for j in said} == {"butt"}
    assert max(overlaps(joined.plates).values()) <= 1e-6


def test_a_bent_face_is_named():
    loops = shapes.prism(slanted.HEXAGON, 70)
    x, y, _ = loops["top"][0]
    bent = {
        id_: [(x, y, 75.0) if point == (x, y, 70) else point for point in loop]
        for id_, loop in loops.items()
    }
    with pytest.raises(FabricationError, match="not flat"):
        make_plates(shapes.model(bent))


def test_a_box_that_leans_a_little_is_still_made():
    lean = {
        id_: [(x + 0.004 * z, y, z) for x, y, z in loop]
        for id_, loop in shapes.box_loops(120, 80, 60).items()
    }
    plates = make_plates(shapes.model(lean))
    assert max(overlaps(plates).values()) <= 1e-6
    total = sum(body(plate).volume() for plate in plates)
    assert total == pytest.approx(shapes.slab_volume(120, 80, 60, 3), rel=2e-3)


def test_play_leaves_room_between_fingers():
    tight, loose = (
        make_plates(MODELS["frustum"](), PlateSettings(play_mm=play)) for play in (0.0, 0.2)
    )
    for a, b in zip(tight, loose, strict=True):
        assert (body(b) - body(a)).volume() <= 1e-6
    assert sum(p.polygon.area for p in loose) < sum(p.polygon.area for p in tight) - 1.0
