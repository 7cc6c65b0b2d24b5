"""Putting together: an order that works, or who locks whom."""

import numpy as np
import pytest
from fabrication import shapes, slanted
from fabrication.bodies import body, overlaps

from incontext.workbench.fabrication import FabricationError, Plate, make_plates
from incontext.workbench.fabrication.assembly import LockedError, assembly_steps, exploded

MODELS = {
    "organizer": shapes.organizer_8,
    "bookshelf": shapes.bookshelf,
    "divided shelf": shapes.divided_shelf,
    "crossed": slanted.crossed,
    "hexagon with shelf": slanted.hexagon_with_shelf,
    "board": shapes.board,
    "many-sided": slanted.many_sided,
}


@pytest.mark.parametrize("name", MODELS)
def test_each_step_can_be_made(name):
    plates = make_plates(MODELS[name](turned=2))
    places = {plate.id: plate for plate in plates}
    steps = assembly_steps(plates)
    assert sorted(id_ for step in steps for id_ in step.plate_ids) == sorted(places)
    there: set[str] = set()
    for step in steps:
        assert set(step.onto) <= there
        assert (len(step.onto) == 0) == (not step.way.any())
        for back in (0.4, 1.7, 2.9, 7.0, 40.0) if step.onto else ():
            for id_ in step.plate_ids:
                moved = body(places[id_]).translate(-back * step.way)
                for other in step.onto:
                    assert (moved ^ body(places[other])).volume() < 1e-2
        there |= set(step.plate_ids)
        assert all(id_ in step.words for id_ in step.plate_ids)


def ring(hook: float) -> tuple[Plate, ...]:
    """A square frame with a bar through it, and a second bar through the first and back."""
    outline = np.array([(0, 0), (100, 0), (100, 60), (0, 60)], dtype=float)
    window = np.array([(40, 20), (40, 40), (60, 40), (60, 20)], dtype=float)
    frame = Plate("f3", ("f3",), 4.0, outline, (window,), np.eye(4))
    upright = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    place = np.eye(4)
    place[:3, :3] = upright
    place[:3, 3] = (0.0, 32.0, 0.0)
    # A bar through the window, wider than it on both sides of the frame.
    bar = np.array(
        [(45 - hook, -20), (55 + hook, -20), (55 + hook, -1), (55, -1), (55, 5), (55 + hook, 5),
         (55 + hook, 24), (45 - hook, 24), (45 - hook, 5), (45, 5), (45, -1), (45 - hook, -1)],
        dtype=float,
    )  # fmt: skip
    return frame, Plate("f7", ("f7",), 4.0, bar, (), place)


def test_plates_that_lock_each_other_are_named():
    plates = ring(hook=20.0)
    assert max(overlaps(plates).values()) < 1e-9
    with pytest.raises(LockedError, match="f3 and f7 lock each other") as caught:
        assembly_steps(plates)
    assert isinstance(caught.value, FabricationError)
    assert len(assembly_steps(ring(hook=0.0))) == 2


def test_two_locked_plates_are_found_among_others():
    far = np.eye(4)
    far[:3, 3] = (0.0, 0.0, 60.0)
    lid = Plate(
        "lid", ("lid",), 3.0, np.array([(0, 0), (50, 0), (50, 50), (0, 50)], float), (), far
    )
    with pytest.raises(LockedError, match="f3 and f7 lock each other"):
        assembly_steps((lid, *ring(hook=20.0)))


def test_exploded_plates_are_apart():
    plates = make_plates(shapes.organizer_6())
    apart = exploded(plates, assembly_steps(plates), 50.0)
    assert [p.id for p in apart] == [p.id for p in plates]
    still = 0
    for before, after in zip(plates, apart, strict=True):
        assert before.outline.tobytes() == after.outline.tobytes()
        move = after.world_from_plate[:3, 3] - before.world_from_plate[:3, 3]
        still += not move.any()
    assert still == 1
    bodies = [body(p) for p in apart]
    assert all((a ^ b).volume() == 0 for n, a in enumerate(bodies) for b in bodies[:n])


def test_walls_go_on_square_to_themselves():
    plates = make_plates(shapes.model(shapes.prism(slanted.HEXAGON, 70.0)))
    normals = {plate.id: plate.world_from_plate[:3, 2] for plate in plates}
    steps = assembly_steps(plates)
    for step in steps[1:]:
        (id_,) = step.plate_ids
        assert abs(step.way @ normals[id_]) == pytest.approx(1.0)
