"""Faces within others of their plane: a door that touches the edge of its wall."""

import pytest
from fabrication import shapes
from fabrication.print_laws import broken_print
from hunting import broken

from incontext.workbench.fabrication import PlateSettings, ShellSettings, joined_plates
from incontext.workbench.fabrication.overlapping import disjoint

W, D, H, RIDGE, OUT = 160.0, 100.0, 70.0, 120.0, 45.0
DOOR = [(20.0, 0.0), (90.0, 0.0), (90.0, 50.0), (20.0, 50.0)]
SIDES = ("inside", "middle", "outside")


def house(*, gable: bool, as_hole: bool = False, **options):
    """A house with a porch; nobody has drawn the wall around the door."""
    front = [(0.0, 0.0), (W, 0.0), (W, H), *([(60.0, RIDGE)] if gable else []), (0.0, H)]
    loops = {"front": [(x, 0.0, z) for x, z in front], "back": [(x, D, z) for x, z in front]}
    for n, (x, z) in enumerate(front):
        u, v = front[(n + 1) % len(front)]
        loops[f"w{n}"] = [(x, 0.0, z), (u, 0.0, v), (u, D, v), (x, D, z)]
    loops |= {"door": [(x, 0.0, z) for x, z in DOOR], "porch": [(x, -OUT, z) for x, z in DOOR]}
    for n, (x, z) in enumerate(DOOR):
        u, v = DOOR[(n + 1) % 4]
        loops[f"p{n}"] = [(x, 0.0, z), (u, 0.0, v), (u, -OUT, v), (x, -OUT, z)]
    holes = {"front": [loops["door"]]} if as_hole else None
    return shapes.model(loops, holes=holes, turned=5, **options)


@pytest.mark.parametrize("as_hole", [False, True])
@pytest.mark.parametrize("gable", [False, True])
@pytest.mark.parametrize("side", SIDES)
def test_a_door_on_the_border_of_its_wall_is_a_plate_of_its_own(gable, as_hole, side):
    model, settings = house(gable=gable, as_hole=as_hole), PlateSettings(side=side)
    joined = joined_plates(model, settings)
    assert not list(broken(model, settings, joined))
    # At right angles, or in one plane with it, it is one plate with its wall.
    door = next(plate for plate in joined.plates if "door" in plate.face_ids)
    assert door.face_ids == (("door",) if gable else ("front", "door"))
    if gable:
        # Where the porch's corners meet the wall, the wall fills the space between its fingers.
        assert not next(plate for plate in joined.plates if plate.id == "front").holes


@pytest.mark.parametrize("gable", [False, True])
def test_a_door_left_out_is_open(gable):
    model = house(gable=gable, left_out=["door"])
    joined = joined_plates(model, PlateSettings())
    assert not list(broken(model, PlateSettings(), joined))
    front = next(plate for plate in joined.plates if plate.id == "front")
    assert front.polygon.area < W * (RIDGE if gable else H) - 0.8 * 70 * 50


@pytest.mark.parametrize("left_out", [(), ("door",)])
def test_a_house_with_a_porch_is_printed(left_out):
    model = house(gable=True, left_out=left_out)
    assert not list(broken_print(model, ShellSettings(wall_mm=2.0)))


def test_what_is_within_nothing_stays():
    model = shapes.organizer_8()
    assert disjoint(model) is model
    window = shapes.box(
        holes={"top": [[(20.0, 20.0, 60.0), (40.0, 20.0, 60.0), (40.0, 50.0, 60.0)]]}
    )
    assert disjoint(window) is window
