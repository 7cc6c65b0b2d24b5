"""Joints: decided, overridden by edge or faces, refused with a reason."""

import math

import pytest
from fabrication import shapes, slanted
from fabrication.bodies import body, overlaps

from incontext.workbench.fabrication import (
    FabricationError,
    JointChoice,
    PlateSettings,
    joined_plates,
    make_plates,
)
from incontext.workbench.fabrication.fits import effects
from incontext.workbench.fabrication.notes import notes_of


def with_joints(*texts, **options):
    return PlateSettings(joints=tuple(JointChoice.parse(text) for text in texts), **options)


def joint_of(joined, one, two):
    wanted = {one, two}
    (joint,) = [j for j in joined.joints if {*j.meeting.one, *j.meeting.two} >= wanted]
    return joint


@pytest.mark.parametrize(
    ("text", "choice"),
    [
        ("e5=butt", JointChoice("e5", "butt")),
        (" f1:f2 = half-lap ", JointChoice("f1:f2", "half_lap")),
        ("e1=auto,finger=8", JointChoice("e1", None, 8.0)),
        ("e1=finger,play=0.1,owner=f2", JointChoice("e1", "finger", None, 0.1, "f2")),
    ],
)
def test_choices_are_read_from_text(text, choice):
    assert JointChoice.parse(text) == choice


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("e5", "no joint"),
        ("=butt", "names no edge"),
        ("e5=glue", "no joint 'glue'"),
        ("e5=finger,width=3", "no joint"),
        ("e5=finger,finger=wide", "no number"),
        ("e5=finger,finger=0.1", "finger is 0.1 mm"),
        ("e5=butt,play=9", "play is 9 mm"),
    ],
)
def test_a_text_that_is_no_choice(text, words):
    with pytest.raises(FabricationError, match=words):
        JointChoice.parse(text)


def test_every_edge_of_a_box_gets_fingers_and_its_name():
    model = shapes.box()
    joined = joined_plates(model)
    assert notes_of(joined) == ()
    assert {j.kind for j in joined.joints} == {"finger"}
    assert sorted(e for j in joined.joints for e in j.meeting.edge_ids) == sorted(model.edges)


@pytest.mark.parametrize(
    "make", [shapes.box, lambda: shapes.model(shapes.prism(slanted.HEXAGON, 70))]
)
@pytest.mark.parametrize("kind", ["butt", "none"])
def test_an_edge_can_be_butted_or_left_without_joint(make, kind):
    model = make()
    fingered = joined_plates(model)
    joint = fingered.joints[0]
    edge = joint.meeting.edge_ids[0]
    joined = joined_plates(model, with_joints(f"{edge}={kind}"))
    changed = next(j for j in joined.joints if edge in j.meeting.edge_ids)
    assert changed.kind == kind
    assert changed.reason == ""
    assert max(overlaps(joined.plates).values()) <= 1e-6
    volumes = [sum(body(p).volume() for p in some.plates) for some in (fingered, joined)]
    zone = 3.0 * 3.0 * joint.meeting.length_mm
    if kind == "butt" and make is shapes.box:
        assert volumes[1] == pytest.approx(volumes[0], rel=1e-9)
    elif kind == "none":
        assert volumes[0] - volumes[1] > 0.9 * zone
    before = {p.id: len(p.outline) for p in fingered.plates}
    after = {p.id: len(p.outline) for p in joined.plates}
    for face in (joint.meeting.one[0], joint.meeting.two[0]):
        assert after[face] < before[face]


def test_who_owns_the_ends_can_be_said():
    model = shapes.box()
    usual = joint_of(joined_plates(model), "front", "left")
    other = {"front": "left", "left": "front"}[usual.owner]
    plates = make_plates(model, with_joints(f"front:left=butt,owner={other}"))
    sizes = {p.id: p.size_mm for p in plates}
    # The owner's plate covers the other's edge, between bottom and top.
    bodies = {
        p.id: body(p).trim_by_plane((0, 0, 1), 20).trim_by_plane((0, 0, -1), -40) for p in plates
    }
    box = bodies[other].bounding_box()
    assert (box[0], box[1]) == pytest.approx((0.0, 0.0))
    assert sizes[other] is not None
    assert max(overlaps(plates).values()) <= 1e-6


def test_finger_width_and_play_of_one_edge():
    model = shapes.box()
    joined = joined_plates(model, with_joints("front:left=finger,finger=6,play=0.2"))
    joint = joint_of(joined, "front", "left")
    assert (joint.finger_mm, joint.play_mm) == (6.0, 0.2)
    plain = {p.id: p for p in make_plates(model)}
    more = {p.id: p for p in joined.plates}
    assert len(more["left"].outline) > len(plain["left"].outline)
    assert len(more["right"].outline) == len(plain["right"].outline)


def test_tabs_can_be_left_out():
    joined = joined_plates(shapes.bookshelf(), with_joints("left:shelf=butt"))
    plates = {p.id: p for p in joined.plates}
    assert plates["left"].holes == ()
    assert len(plates["right"].holes) > 0
    assert max(overlaps(joined.plates).values()) <= 1e-6


def test_a_slanted_partition_can_be_butted():
    joined = joined_plates(slanted.leaning(), with_joints("bottom:lean=butt"))
    plates = {p.id: p for p in joined.plates}
    assert plates["bottom"].holes == ()
    assert len(plates["front"].holes) > 0


@pytest.mark.parametrize(
    ("make", "choice", "words"),
    [
        (shapes.box, "e1=half_lap", "no half lap joint can be made where both plates end"),
        (shapes.box, "e99=butt", "no two plates meet there .e99"),
        (shapes.box, "top:bottom=butt", "no two plates meet there"),
        (shapes.box, "front:left=finger,owner=top", "top does not meet this edge"),
        (shapes.bookshelf, "left:shelf=tab_slot,owner=shelf", "shelf ends on left"),
        (shapes.divided_shelf, "shelf:divider=none", "where both plates pass"),
        (slanted.crossed, "d1:d2=tab_slot", "into 2 pieces .*; try: another joint at d1:d2, or"),
        (lambda: shapes.box(120, 80, 12), "front:left=finger", "6.0 mm clear of the corners"),
        (shapes.box, "e1=finger,finger=4", "fingers of 4 mm cannot hold here .*4.5 mm or wider"),
        (shapes.bookshelf, "left:shelf=auto,finger=2", "fingers of 2 mm cannot hold here"),
        (slanted.leaning, "bottom:lean=tab_slot,finger=4.4", "4.5 mm or wider"),
    ],
)
def test_a_joint_that_cannot_be_is_refused_by_name(make, choice, words):
    with pytest.raises(FabricationError, match=words):
        joined_plates(make(), with_joints(choice))


def test_short_edges_are_butted_and_it_is_said():
    joined = joined_plates(shapes.box(120, 80, 12))
    notes = [note for note in notes_of(joined) if "front" in note and "left" in note]
    assert len(notes) == 1
    assert "butt" in notes[0]
    assert "fingers need 13.5 mm at least" in notes[0]


@pytest.mark.parametrize("make", [shapes.bookshelf, slanted.leaning])
def test_fingers_that_would_not_hold_are_made_wider_and_it_is_said(make):
    joined = joined_plates(make(), PlateSettings(finger_mm=2.0))
    (note,) = [note for note in notes_of(joined) if "would not hold" in note]
    assert f"and {len(joined.joints) - 1} more: fingers of 2 mm" in note
    assert note.endswith("they are 4.5 mm wide or wider")
    assert "finger at a corner: 4.5 mm wide" in effects(PlateSettings(finger_mm=2.0))[0]
    narrow = PlateSettings(finger_mm=4.5)
    assert not [note for note in notes_of(joined_plates(make(), narrow)) if "would" in note]


def wedge(degrees):
    theta = math.radians(degrees)
    far = (60 * math.cos(theta), 60 * math.sin(theta))
    return shapes.model(
        {
            "floor": [(0, 0, 0), (60, 0, 0), (60, 120, 0), (0, 120, 0)],
            "wall": [(0, 0, 0), (0, 120, 0), (far[0], 120, far[1]), (far[0], 0, far[1])],
        }
    )


@pytest.mark.parametrize("degrees", [20, 155])
def test_flat_and_sharp_edges_are_butted_and_it_is_said(degrees):
    joined = joined_plates(wedge(degrees))
    (note,) = notes_of(joined)
    assert f"{degrees} degrees; fingers hold from 30 to 150 degrees" in note
    with pytest.raises(FabricationError, match="fingers cannot hold here") as caught:
        joined_plates(wedge(degrees), with_joints("floor:wall=finger"))
    assert caught.value.ids


def test_half_laps_can_become_closed_slots():
    joined = joined_plates(shapes.divided_shelf(), with_joints("shelf:divider=tab_slot"))
    assert joint_of(joined, "shelf", "divider").kind == "tab_slot"
    assert max(overlaps(joined.plates).values()) <= 1e-6
