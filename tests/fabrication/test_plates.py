"""Laws of plates: no overlap, no void, one piece, nothing outside."""

import itertools

import manifold3d as m3
import numpy as np
import pytest
import scenes
import shapely
from fabrication import shapes
from fabrication.bodies import body, overlaps, union
from hypothesis import given, settings
from hypothesis import strategies as st

from incontext.solver.model import Model, Turned
from incontext.workbench.fabrication import (
    FabricationError,
    Plate,
    PlateSettings,
    joined_plates,
    make_plates,
)
from incontext.workbench.fabrication.frame import find_frame
from incontext.workbench.fabrication.notes import notes_of
from incontext.workbench.fabrication.walls import find_walls

SIDES = ("inside", "outside", "middle")
CASES = [(name, side) for name in shapes.TRUTHS for side in SIDES]


def check_laws(plates: tuple[Plate, ...], volume: float) -> None:
    assert max(overlaps(plates).values(), default=0.0) <= 1e-6
    total = sum(body(plate).volume() for plate in plates)
    assert total == pytest.approx(volume, rel=1e-6)
    for plate in plates:
        assert plate.polygon.is_valid
        assert shapely.LinearRing(plate.outline).is_simple
        # In one piece, and held together by more than a point.
        assert plate.polygon.buffer(-0.05).geom_type == "Polygon"


@pytest.mark.parametrize(("name", "side"), CASES)
def test_plates_fill_the_walls_and_overlap_nowhere(name, side):
    plates = make_plates(shapes.TRUTHS[name].make(), PlateSettings(side=side))
    check_laws(plates, shapes.wall_volume(name, side))


@pytest.mark.parametrize("name", shapes.TRUTHS)
def test_a_turned_model_gives_the_same_plates(name):
    make = shapes.TRUTHS[name].make
    straight = make_plates(make())
    turned = make_plates(make(turned=7, moved=(310.0, -120.0, 45.0)))
    assert [p.face_ids for p in turned] == [p.face_ids for p in straight]
    check_laws(turned, shapes.wall_volume(name, "inside"))
    if name != "board":  # a single board hangs below its face: which side that is may change
        areas = [[p.polygon.area for p in plates] for plates in (straight, turned)]
        np.testing.assert_allclose(sorted(areas[0]), sorted(areas[1]), rtol=0.02)


def test_the_union_is_one_solid_inside_the_drawn_box():
    whole = union(make_plates(shapes.box()))
    assert whole.volume() == pytest.approx(120 * 80 * 60 - 114 * 74 * 54, rel=1e-9)
    assert whole.bounding_box() == pytest.approx((0, 0, 0, 120, 80, 60), abs=1e-9)


@pytest.mark.parametrize(("side", "low", "high"), [("inside", 0, 3), ("outside", -3, 0)])
def test_the_side_says_where_the_material_lies(side, low, high):
    bottom = make_plates(shapes.tray(), PlateSettings(side=side))[0]
    box = body(bottom).bounding_box()
    assert (box[2], box[5]) == pytest.approx((low, high))


def test_a_partition_has_its_drawn_face_in_the_middle():
    for side in SIDES:
        shelf = make_plates(shapes.bookshelf(), PlateSettings(side=side))[-1]
        box = body(shelf).bounding_box()
        assert shelf.id == "shelf"
        assert (box[2], box[5]) == pytest.approx((73.5, 76.5))


def test_faces_of_one_plane_become_one_plate():
    plates = make_plates(shapes.organizer_8())
    assert len(plates) == 9
    assert ("y1.0", "y1.1", "y1.2", "y1.3") in [plate.face_ids for plate in plates]


def test_plates_are_in_the_order_of_the_faces():
    assert [p.id for p in make_plates(shapes.box())] == list(shapes.box_loops(1, 1, 1))


def test_a_face_left_out_is_an_open_side():
    plates = make_plates(shapes.box(left_out=("top",)))
    assert "top" not in [plate.id for plate in plates]
    check_laws(plates, shapes.slab_volume(120, 80, 60, 3, lid=False))


def test_walls_of_unequal_thickness():
    thickness = {"bottom": 6.0, "top": 4.0, "front": 3.0, "back": 3.0, "left": 5.0, "right": 2.0}
    plates = make_plates(shapes.box(thickness=thickness, turned=5))
    check_laws(plates, 120 * 80 * 60 - (120 - 7) * (80 - 6) * (60 - 10))
    assert [plate.thickness_mm for plate in plates] == list(thickness.values())


def test_a_solve_leaves_a_little_noise():
    noisy = shapes.model(
        {
            id_: [
                tuple(np.round(np.array(p) + 1e-5 * np.sin([3 * p[0], p[1], p[2]]), 9)) for p in f
            ]
            for id_, f in shapes.box_loops(120, 80, 60).items()
        },
        turned=2,
    )
    check_laws(make_plates(noisy), shapes.slab_volume(120, 80, 60, 3) * (1 + 1e-8))


def test_the_same_model_gives_the_same_plates():
    one, two = (make_plates(shapes.organizer_6(turned=1)) for _ in range(2))
    for a, b in zip(one, two, strict=True):
        assert a.outline.tobytes() == b.outline.tobytes()


def test_plates_are_frozen():
    plate = make_plates(shapes.board())[0]
    with pytest.raises(ValueError, match="read-only"):
        plate.outline[0, 0] = 1.0


def test_two_boxes_corner_to_corner_keep_their_own_plates():
    """Faces of one plane whose insides lie opposite ways are two plates; the boxes hold together.

    At the common edge walls of both reach through one another, as at any inner corner.
    """
    loops = {f"a.{k}": v for k, v in shapes.box_loops(60, 60, 60).items()}
    for id_, loop in shapes.box_loops(60, 60, 60).items():
        loops[f"b.{id_}"] = [(x + 60, y + 60, z) for x, y, z in loop]
    plates = make_plates(shapes.model(loops))
    assert len(plates) == 12
    check_laws(plates, 2 * shapes.slab_volume(60, 60, 60, 3) + 2 * 3 * 3 * 60)


def test_half_laps_open_where_their_wall_ends():
    plates = {plate.id: plate for plate in make_plates(shapes.organizer_6())}
    # Along z the crossing goes from the bottom's upper side to the top border: 42 mm, half each.
    long = body(plates["y1.0"]) - body(plates["x1.0"])
    assert long.volume() == pytest.approx(body(plates["y1.0"]).volume(), rel=1e-9)
    notch = plates["y1.0"].polygon.convex_hull.area - plates["y1.0"].polygon.area
    assert notch > 2 * 3 * 21 - 1e-6


def spaces(model, side: str) -> m3.Manifold:
    """All space that belongs to a wall, each lengthened through those that it meets."""
    made = {id_: face for id_, face in model.faces.items() if face.included}
    bodies = []
    for wall in find_walls(model, find_frame(made), side):
        rings = [np.array(r.coords)[:-1] for r in (wall.region.exterior, *wall.region.interiors)]
        section = m3.CrossSection(rings, m3.FillRule.EvenOdd)
        place = np.zeros((3, 4))
        place[[*wall.plane_axes, wall.axis], [0, 1, 2]] = 1.0
        place[wall.axis, 3] = wall.low_mm
        bodies.append(m3.Manifold.extrude(section, wall.thickness_mm).transform(place))
    return m3.Manifold.batch_boolean(bodies, m3.OpType.Add)


@pytest.mark.parametrize("seed", [*range(12), 13, 15, 17, 41, 45, 50, 59, 61, 83, 170])
def test_random_bodies(seed):
    """Shapes nobody would draw; each plate is whole, none is in another, no wall has a hole."""
    model, side = shapes.polycube(seed), SIDES[seed % 3]
    check_laws(make_plates(model, PlateSettings(side=side)), spaces(model, side).volume())


@pytest.mark.parametrize(
    ("seed", "side", "void"),
    [(26, "inside", 1.5 * 1.5 * 3), (32, "middle", 1.5**3), (128, "middle", 1.5**3)],
)
def test_walls_that_touch_in_one_point_leave_what_a_square_cut_must(seed, side, void):
    """Around the point both want a column of which each has a part alone: one part stays empty."""
    model = shapes.polycube(seed)
    joined = joined_plates(model, PlateSettings(side=side))
    check_laws(joined.plates, spaces(model, side).volume() - void)
    assert sum(joined.empty_mm3.values()) == pytest.approx(void)
    assert [note for note in notes_of(joined) if f"{void:.1f} mm3 stay empty" in note]


@pytest.mark.parametrize("name", ["bookshelf", "organizer_8"])
def test_nothing_is_said_to_be_empty_where_walls_are_filled(name):
    for play in (0.0, 0.2):
        joined = joined_plates(shapes.TRUTHS[name].make(), PlateSettings(play_mm=play))
        assert not joined.empty_mm3


@settings(max_examples=15, deadline=None, derandomize=True)
@given(
    st.lists(st.integers(20, 70), min_size=1, max_size=4),
    st.lists(st.integers(20, 70), min_size=1, max_size=4),
    st.integers(20, 80),
    st.sampled_from([2.0, 3.0, 4.5]),
    st.sampled_from(SIDES),
)
def test_random_organizers(columns, rows, h, t, side):
    x, y = ([0.0, *itertools.accumulate(map(float, widths))] for widths in (columns, rows))
    plates = make_plates(shapes.organizer(x, y, h, thickness=t), PlateSettings(side=side))
    o = {"inside": 0.0, "outside": t, "middle": t / 2}[side]
    size, i = (len(columns) - 1, len(rows) - 1), t - o
    check_laws(plates, shapes._organizer(x[-1], y[-1], h, *size, o, i))


@pytest.mark.parametrize("make", [scenes.staircase, scenes.organizer, scenes.table])
def test_scenes_of_the_solver(make):
    """Steps, compartments, and a table of boxes that touch one another."""
    truth = make()
    loops = {f"f{n}": [tuple(truth.X[i]) for i in loop] for n, loop in enumerate(truth.loops)}
    plates = make_plates(shapes.model(loops))
    assert max(overlaps(plates).values()) <= 1e-6
    assert all(plate.polygon.buffer(-0.05).geom_type == "Polygon" for plate in plates)


def test_play_widens_slots_on_both_sides():
    loose = {p.id: p for p in make_plates(shapes.bookshelf(), PlateSettings(play_mm=0.2))}
    tight = {p.id: p for p in make_plates(shapes.bookshelf())}
    for a, b in zip(loose["left"].holes, tight["left"].holes, strict=True):
        np.testing.assert_allclose(np.ptp(a, axis=0) - np.ptp(b, axis=0), 0.2, atol=1e-9)
        np.testing.assert_allclose(a.mean(axis=0), b.mean(axis=0), atol=1e-9)
    # The shelf's tabs keep their size.
    assert loose["shelf"].polygon.equals(tight["shelf"].polygon)
    assert max(overlaps(tuple(loose.values())).values()) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("name", ["bookshelf", "organizer_8", "divided_shelf"])
def test_slots_keep_one_thickness_from_borders(name):
    for plate in make_plates(shapes.TRUTHS[name].make()):
        border = shapely.LinearRing(plate.outline)
        for hole in plate.holes:
            assert border.distance(shapely.LinearRing(hole)) >= 3.0 - 1e-6


def test_faces_closer_than_the_thickness_are_named():
    loops = shapes.box_loops(120, 80, 60)
    loops["shelf"] = shapes.rect(2, 2, (0, 120), (0, 80))
    with pytest.raises(FabricationError, match="2 mm apart") as caught:
        make_plates(shapes.model(loops))
    assert set(caught.value.ids) == {"bottom", "shelf"}


def test_a_crossed_outline_is_named():
    crossed = [(0, 0, 0), (50, 50, 0), (50, 0, 0), (0, 40, 0)]
    with pytest.raises(FabricationError) as caught:
        make_plates(shapes.model({"f1": crossed}))
    assert caught.value.ids == ("f1",)


def test_a_turned_body_has_no_plates():
    with pytest.raises(FabricationError, match="no flat face to make a plate of") as caught:
        make_plates(Model({}, {}, turned={"r1": Turned(np.zeros(2), np.array([(9.0, 0), (9, 5)]))}))
    assert caught.value.ids == ("r1",)


def test_nothing_included():
    with pytest.raises(FabricationError, match="no face"):
        make_plates(shapes.board(left_out=("f1",)))


def test_a_half_drawn_face_can_be_left_out_or_thick():
    """Half of a box, mirrored: what is said of the face with a mirrored corner counts."""
    from test_symmetry import listed_half

    from incontext.solver import solve
    from incontext.solver.model import build_model

    whole = make_plates(build_model(solve(listed_half(thickness_mm=5.0))))
    assert sorted(plate.thickness_mm for plate in whole) == [3.0, 3.0, 3.0, 5.0]
    assert len(make_plates(build_model(solve(listed_half(included=False))))) == 3
