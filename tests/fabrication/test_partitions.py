"""Partitions at any angle: tabs and closed slots, half-laps, and what a square cut leaves empty."""

import math
from itertools import pairwise

import manifold3d as m3
import numpy as np
import pytest
import shapely
from fabrication import shapes, slanted
from fabrication.bodies import body, overlaps, union

from incontext.workbench.fabrication import PlateSettings, joined_plates, make_plates
from incontext.workbench.fabrication.notes import notes_of


@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
@pytest.mark.parametrize("name", slanted.PARTITIONED)
def test_laws(name, side):
    model = slanted.PARTITIONED[name](turned=3 if side == "inside" else None)
    plates = make_plates(model, PlateSettings(side=side))
    assert [plate.id for plate in plates] == [f for f in model.faces if model.faces[f].included]
    assert max(overlaps(plates).values()) <= 1e-6
    for plate in plates:
        assert shapely.LinearRing(plate.outline).is_simple
        assert plate.polygon.buffer(-0.05).geom_type == "Polygon"
        for hole in plate.holes:
            border = shapely.LinearRing(plate.outline)
            assert border.distance(shapely.LinearRing(hole)) >= plate.thickness_mm - 1e-6
    if side == "inside":
        hull = m3.Manifold.hull_points(np.array(list(model.vertices_mm.values())))
        assert (union(plates) - hull).volume() <= 1e-3


@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
def test_a_plate_on_which_walls_end_stays_whole(side):
    plates = {plate.id: plate for plate in make_plates(slanted.eaves(), PlateSettings(side=side))}
    assert max(overlaps(tuple(plates.values())).values()) <= 1e-6
    assert plates["top"].polygon.area == pytest.approx(180 * 150 * math.hypot(1, 0.3), rel=1e-6)
    for plate in plates.values():
        assert plate.polygon.buffer(-0.05).geom_type == "Polygon"


@pytest.mark.parametrize("turns", [(0.0, 1.9, 4.1), (0.0, 1.2, math.pi), (0.0, 1.4, 2.9, 4.6)])
def test_plates_that_meet_in_one_line_and_nowhere_else(turns):
    """All of them are partitions: none has an outside."""
    loops = {}
    for n, turn in enumerate(turns):
        x, y = 80 * math.cos(turn), 80 * math.sin(turn)
        loops[f"s{n}"] = [(0, 0, 0), (x, y, 0), (x, y, 90), (0, 0, 90)]
    plates = make_plates(shapes.model(loops))
    assert max(overlaps(plates).values()) <= 1e-6
    assert sum(plate.polygon.area for plate in plates) > (len(turns) * 80 - 12) * 90


def slots_of(plate):
    """Length and width of each slot, the longer first."""
    boxes = [shapely.Polygon(hole).minimum_rotated_rectangle for hole in plate.holes]
    sides = [np.linalg.norm(np.diff(np.array(b.exterior.coords), axis=0), axis=1) for b in boxes]
    return [(float(max(s)), float(min(s))) for s in sides]


@pytest.mark.parametrize("degrees", [50, 60, 75, 105, 130])
def test_a_leaning_partition_leaves_what_a_square_cut_must(degrees):
    theta, t = math.radians(degrees), 3.0
    sine, cot = math.sin(theta), abs(1 / math.tan(theta))
    plates = {plate.id: plate for plate in make_plates(slanted.leaning(degrees))}
    slots = slots_of(plates["bottom"])
    assert len(slots) >= 2
    width = t / sine + t * cot
    for _, across in slots:
        assert across == pytest.approx(width, abs=1e-6)
    tabs = sum(length for length, _ in slots)
    # The space of all walls: those of the tray, and the partition's slab within the hollow.
    tray = shapes.slab_volume(200, 100, 90, t, lid=False)
    slab = t / sine * 94 * 87
    triangle = t * t * cot / 2
    void = tabs * (width * t - (t * t / sine - triangle)) + (94 - tabs) * triangle + 94 * triangle
    total = sum(body(plate).volume() for plate in plates.values())
    assert total == pytest.approx(tray + slab - void, rel=1e-6)


def test_a_tab_is_as_long_as_the_slanted_way_through_the_wall():
    theta = math.radians(60)
    plates = {plate.id: plate for plate in make_plates(slanted.leaning(60))}
    outline = plates["lean"].outline
    edge = outline[outline[:, 1] < outline[:, 1].min() + 4.0]
    depths = np.unique(np.round(edge[:, 1], 4))
    assert depths[-1] - depths[0] == pytest.approx(3.0 / math.sin(theta), abs=1e-3)


def test_crossing_partitions_are_slotted_half_through_each():
    model = slanted.crossed()
    plates = {plate.id: plate for plate in make_plates(model)}
    n1, n2 = (plates[p].world_from_plate[:3, 2] for p in ("d1", "d2"))
    cosine = abs(float(n1 @ n2))
    sine = math.sqrt(1 - cosine**2)
    width = 3.0 / sine + 3.0 * cosine / sine
    for id_ in ("d1", "d2"):
        polygon = plates[id_].polygon
        low_x, low_y, high_x, high_y = polygon.bounds
        gaps = []
        for share in (0.35, 0.8):
            y = low_y + share * (high_y - low_y)
            parts = polygon.intersection(shapely.LineString([(low_x - 1, y), (high_x + 1, y)]))
            gaps += [one.distance(two) for one, two in pairwise(shapely.get_parts(parts))]
        assert gaps == [pytest.approx(width, abs=1e-6)]
    joints = [j for j in joined_plates(model).joints if j.kind == "half_lap"]
    assert [j.meeting.one + j.meeting.two for j in joints] == [("d1", "d2")]


def test_a_partition_between_two_fingered_corners_is_cut_off_square():
    joined = joined_plates(slanted.diagonal())
    assert notes_of(joined) == ()
    kinds = {j.meeting.one[0]: j.kind for j in joined.joints if j.meeting.two == ("diagonal",)}
    assert kinds == {"bottom": "tab_slot"}


def tabs_along(plate, border):
    """Where a plate's outline reaches a border of its box, as intervals along it."""
    low, high = plate.outline.min(axis=0), plate.outline.max(axis=0)
    at = {"top": (1, high[1]), "bottom": (1, low[1])}[border]
    ends = zip(plate.outline, np.roll(plate.outline, -1, axis=0), strict=True)
    on = [e for e in ends if max(abs(p[at[0]] - at[1]) for p in e) < 1e-6]
    return sorted(tuple(sorted((a[0], b[0]))) for a, b in on)


def test_boards_from_both_sides_take_turns_in_one_row_of_slots():
    model = slanted.from_both_sides()
    joined = joined_plates(model)
    plates = {plate.id: plate for plate in joined.plates}
    kinds = {j.meeting.two[0]: j.kind for j in joined.joints if j.meeting.one == ("mid",)}
    assert kinds == {"l": "tab_slot", "r": "tab_slot"}
    in_world = {}
    for id_ in ("l", "r"):
        place = plates[id_].world_from_plate
        tabs = tabs_along(plates[id_], "top")
        # y in the world, which runs along both boards' upper edges.
        in_world[id_] = sorted(
            tuple(sorted((place[:3, :2] @ (x, 0.0) + place[:3, 3])[1] for x in ends))
            for ends in tabs
        )
    assert len(in_world["l"]) == len(in_world["r"]) + 1
    for (_, high), (low, _) in zip(in_world["l"], in_world["r"], strict=False):
        assert low == pytest.approx(high, abs=1e-4)


def test_of_two_boards_from_one_line_the_first_has_tabs():
    joints = joined_plates(slanted.vee()).joints
    kinds = {j.meeting.two[0]: j.kind for j in joints if j.meeting.one == ("bottom",)}
    assert kinds["l"] == "tab_slot"
    assert kinds["r"] == "butt"


def test_joints_know_where_they_are():
    """So that edge marks lie beside them."""
    (joint,) = [
        j
        for j in joined_plates(slanted.leaning(60)).joints
        if (j.meeting.one, j.meeting.two) == (("bottom",), ("lean",))
    ]
    assert joint.meeting.middle_mm == pytest.approx((80.0, 50.0, 0.0), abs=3.0)


def test_play_widens_slots_at_any_angle():
    tight, loose = (
        {p.id: p for p in make_plates(slanted.leaning(), PlateSettings(play_mm=play))}
        for play in (0.0, 0.2)
    )
    for a, b in zip(slots_of(tight["bottom"]), slots_of(loose["bottom"]), strict=True):
        np.testing.assert_allclose(np.subtract(b, a), 0.2, atol=1e-6)
    assert loose["lean"].polygon.equals_exact(tight["lean"].polygon, 1e-6)
