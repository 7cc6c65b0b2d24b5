"""Fit, standing and weak spots of objects whose truth is known by hand."""

import math
from itertools import combinations

import numpy as np
import pytest
from fabrication import shapes

from incontext.solver.camera import Camera
from incontext.solver.graph import Ellipse, Revolution, SketchGraph
from incontext.solver.solution import Solution, SolvedCircle, Status
from incontext.workbench.fabrication import PlateSettings, ShellSettings, joined_plates
from incontext.workbench.fabrication.checking import check_plates, check_print
from incontext.workbench.fabrication.fit import TOUCH_MM
from incontext.workbench.fabrication.joints import JointChoice
from incontext.workbench.fabrication.meshes import mesh_of
from incontext.workbench.fabrication.parts_in_space import centroid, plate_parts, ways_of
from incontext.workbench.fabrication.shell import shell_solid
from incontext.workbench.fabrication.things import existing_things
from incontext.workbench.fabrication.weak_spots import loose_plates, thin_plates

#: 2000 mm before the scene, 500 mm up, looking along y.
CAMERA = Camera(1000.0, [800, 600], [[1, 0, 0], [0, 0, -1], [0, 1, 0]], [0, 500, 2000])


def block(low, high):
    """Corners and edges of a box."""
    corners = {
        f"b{n}": np.array(point, float)
        for n, point in enumerate(
            np.array(np.meshgrid(*zip(low, high, strict=True))).T.reshape(-1, 3)
        )
    }
    return corners, [
        (v, w) for v, w in combinations(corners, 2) if (corners[v] != corners[w]).sum() == 1
    ]


def traced(corners=None, ends=(), circles=None, revolutions=None, profile=None):
    """A solved sketch in which everything is traced."""
    corners = {k: np.asarray(x, float) for k, x in (corners or {}).items()}
    edges = {f"t{n}": pair for n, pair in enumerate(ends)}
    solved = {
        id_: SolvedCircle(np.array(centre, float), float(radius))
        for id_, (centre, radius) in (circles or {}).items()
    }
    ellipse = Ellipse(((0, 0), (2, 0)), ((1, -1), (1, 1)))
    graph = SketchGraph(
        vertices=dict.fromkeys(corners, (0.0, 0.0)),
        edges=edges,
        circles=dict.fromkeys(solved, ellipse),
        revolutions=revolutions or {},
        construction=(*edges, *solved),
    )
    return graph, Solution("", Status.CONVERGED, "", corners, edges, {}, solved, CAMERA)


def things_of(*args, **options):
    return existing_things(*traced(*args, **options))


def volume(thing):
    return sum(body.volume() for body in thing.bodies)


def test_a_traced_box_is_a_block():
    (thing,) = things_of(*block((10, 20, 0), (60, 50, 30)))
    assert (thing.kind, thing.id) == ("block", "t0")
    assert volume(thing) == pytest.approx(50 * 30 * 30)
    assert thing.pixel_mm == pytest.approx((2000 + 35) / 1000)


def test_the_unseen_corner_of_a_box_is_found():
    corners, ends = block((0, 0, 0), (50, 30, 20))
    hidden = next(k for k, x in corners.items() if (x == (50, 30, 0)).all())
    del corners[hidden]
    (thing,) = things_of(corners, [pair for pair in ends if hidden not in pair])
    assert thing.kind == "block"
    assert volume(thing) == pytest.approx(50 * 30 * 20)


def test_a_closed_body_with_a_dent_keeps_it():
    loops = shapes.prism([(0, 0), (60, 0), (60, 20), (20, 20), (20, 50), (0, 50)], 40)
    model = shapes.model(loops)
    (thing,) = things_of(model.vertices_mm, list(model.edges.values()))
    assert thing.kind == "block"
    assert volume(thing) == pytest.approx((60 * 20 + 20 * 30) * 40)


def test_faces_that_bound_nothing_stay_faces():
    """A chair's seat and its back, with one leg: what lies between them is free."""
    corners = {"a": (0, 0, 40), "b": (50, 0, 40), "c": (50, 50, 40), "d": (0, 50, 40)}
    corners |= {"e": (50, 70, 90), "f": (0, 70, 90), "g": (0, 0, 0)}
    ends = [("a", "b"), ("b", "c"), ("c", "d"), ("d", "a"), ("c", "e"), ("e", "f"), ("f", "d")]
    (thing,) = things_of(corners, [*ends, ("a", "g")])
    assert thing.kind == "surface"
    assert len(thing.bodies) == 3
    assert volume(thing) < 60


def test_what_lies_on_the_ground_is_a_mark():
    sheet = {"a": (0, 0, 0), "b": (297, 0, 0), "c": (297, 210, 0), "d": (0, 210, 0)}
    things = things_of(
        sheet, [("a", "b"), ("b", "c"), ("c", "d"), ("d", "a")], {"c1": ((500, 0, 0), 30)}
    )
    assert [(t.kind, t.bodies) for t in things] == [("mark", ())] * 2


def test_circles_are_cylinders():
    circles = {"c1": ((0, 0, 90), 40), "c2": ((0.5, 0, 0), 30), "c3": ((300, 0, 70), 25)}
    cup, glass = things_of(circles=circles)
    assert (cup.id, cup.kind, glass.id) == ("c2", "cylinder", "c3")
    frustum = math.pi * 90 / 3 * (40**2 + 40 * 30 + 30**2)
    assert volume(cup) == pytest.approx(frustum, rel=2e-3)
    assert volume(glass) == pytest.approx(math.pi * 25**2 * 70, rel=2e-3)


def test_a_traced_surface_of_revolution_is_there_and_not_made():
    circles = {"c0": ((0, 0, 0), 20), "c1": ((0, 0, 5), 20), "c2": ((0, 0, 50), 30)}
    graph, solution = traced(
        {"p": (20, 0, 5), "q": (45, 0, 30), "r": (30, 0, 50)},
        circles=circles,
        revolutions={"r1": Revolution("c0", "c1", "c2", ("p", "q", "r"))},
    )
    assert graph.made_revolutions == {}
    (thing,) = existing_things(graph, solution)
    parts = [math.pi * h / 3 * (a * a + a * b + b * b) for h, a, b in ((25, 20, 45), (20, 45, 30))]
    assert (thing.id, thing.kind) == ("r1", "cylinder")
    assert volume(thing) == pytest.approx(sum(parts), rel=2e-3)


def shelf():
    """Open to the front: inside from 3 to 197, 0 to 87, 3 to 73.5."""
    return shapes.bookshelf(200, 90, 160, 75)


def checked(things, model=None, camera=CAMERA, **options):
    model = model or shelf()
    return check_plates(joined_plates(model, PlateSettings(**options)), model, things, camera)


def test_a_book_that_fits_has_room():
    things = things_of(*block((10, 1, 3), (190, 80, 60)))
    (fit,) = checked(things).fits
    assert fit.fits
    assert fit.clearance_mm == 0.0  # it stands on the bottom
    truth = {"left": 7.0, "right": 7.0, "back": 7.0, "up": 13.5, "front": None}
    for way, size in truth.items():
        if size is None:
            assert fit.room_mm[way] is None
        else:
            assert fit.room_mm[way] == pytest.approx(size, abs=TOUCH_MM)
    assert "fits, touches bottom" in fit.words
    assert "7.0 mm left" in fit.words
    assert "free front" in fit.words


def test_clearance_is_the_shortest_distance():
    (fit,) = checked(things_of(*block((240, 30, 30), (260, 40, 40)))).fits
    assert (fit.nearest, fit.clearance_mm) == ("right", pytest.approx(40.0))


@pytest.mark.parametrize("turned", [None, 5])
def test_a_book_too_wide_says_what_is_missing(turned):
    turn = np.eye(3) if turned is None else shapes.rotation(turned)
    corners, ends = block((-7, 1, 10), (201, 80, 60))
    corners = {k: turn @ x + (0, 0, 500) for k, x in corners.items()}
    model = shapes.bookshelf(200, 90, 160, 75, turned=turned, moved=(0.0, 0.0, 500.0))
    (fit,) = checked(things_of(corners, ends), model).fits
    assert not fit.fits
    missing = {o.part_id: o.missing_mm for o in fit.overlaps}
    # Beyond the thickness too: the inner side of the left plate is 10 mm further in.
    assert missing == {"left": pytest.approx(10.0), "right": pytest.approx(4.0)}
    assert "10.0 mm into left, 4.0 mm into right" in fit.words
    assert fit.overlaps[0].volume_mm3 == pytest.approx(3 * 79 * 50)


def test_a_wall_that_is_in_the_way_of_an_edge():
    """A room's wall 2 mm before the back's plane: every plate has to be 2 mm shorter."""
    check = checked(things_of(*block((-500, 88, 0), (500, 300, 400))))
    missing = {o.part_id: o.missing_mm for o in check.fits[0].overlaps}
    assert missing.pop("back") == pytest.approx(2.0)
    assert {id_: pytest.approx(2.0) for id_ in missing} == missing
    assert not check.good
    assert check.problems[0].startswith("block t0: does not fit")


def test_a_print_over_a_cylinder():
    model = shapes.box(80, 80, 60, left_out=("bottom",), moved=(-40.0, -40.0, 0.0))
    mesh = mesh_of(shell_solid(model, ShellSettings(4.0)))
    for radius, missing in ((35.0, None), (37.0, 1.0), (38.5, 2.5)):
        things = things_of(circles={"c1": ((0, 0, 40), radius)})
        (fit,) = check_print(mesh, model, things, CAMERA, 0.4).fits
        if missing is None:
            assert fit.clearance_mm == pytest.approx(1.0, abs=0.02)
            assert fit.room_mm["up"] == pytest.approx(16.0, abs=TOUCH_MM)
        else:
            assert fit.overlaps[0].missing_mm == pytest.approx(missing, abs=0.03)


@pytest.mark.parametrize(("at", "missing"), [(88.0, 2.0), (90.0, None), (95.0, None)])
def test_a_wall_of_which_only_the_surface_is_traced(at, missing):
    wall = {"a": (-99, at, -5), "b": (300, at, -5), "c": (300, at, 400), "d": (-99, at, 400)}
    (fit,) = checked(things_of(wall, [("a", "b"), ("b", "c"), ("c", "d"), ("d", "a")])).fits
    assert fit.thing.kind == "surface"
    if missing is None:
        assert fit.fits
        assert fit.clearance_mm == pytest.approx(at - 90.0, abs=0.01)
    else:
        reach = {o.part_id: o.missing_mm for o in fit.overlaps}
        assert reach.pop("back") == pytest.approx(1.0, abs=0.01)
        assert len(reach) == 5
        assert all(size == pytest.approx(missing, abs=0.01) for size in reach.values())


@pytest.mark.parametrize("printed", [False, True])
def test_a_book_on_the_desk_will_stand_on_the_floor_of_the_shelf(printed):
    """As the paper's books do: they were there before the shelf had a bottom."""
    model = shelf()
    for width, height, fits in ((150, 65, True), (150, 72, False), (190, 65, False)):
        things = things_of(*block((10, 10, 0), (10 + width, 80, height)))
        if printed:
            loops = {
                **shapes.box_loops(200, 90, 160),
                "shelf": shapes.rect(2, 75, (0, 200), (0, 90)),
            }
            closed = shapes.model(loops, left_out=("front",))
            mesh = mesh_of(shell_solid(closed, ShellSettings(3.0)))
            (fit,) = check_print(mesh, model, things, CAMERA, 0.4).fits
        else:
            (fit,) = checked(things, model).fits
        assert fit.lift_mm == pytest.approx(3.0, abs=1e-3)
        assert fit.fits is fits
        assert "(which will stand 3.0 mm higher)" in fit.words
        if fits:
            assert fit.room_mm["up"] == pytest.approx(5.5, abs=TOUCH_MM)
        elif not printed:
            # 3 + 72 under a board that begins at 73.5; 10 + 190 before a wall that begins at 197.
            assert fit.overlaps[0].missing_mm == pytest.approx(
                1.5 if width == 150 else 3.0, abs=1e-3
            )


def test_ways_are_those_of_the_photo():
    turn = [[0, 1, 0], [0, 0, -1], [-1, 0, 0]]
    ways = ways_of(shelf(), Camera(1000.0, [800, 600], turn, [0, 500, 2000]))
    np.testing.assert_allclose(ways["right"], (0, 1, 0), atol=1e-12)
    np.testing.assert_allclose(ways["front"], (1, 0, 0), atol=1e-12)


def test_the_centre_of_mass_is_that_of_the_slabs():
    parts = plate_parts(joined_plates(shapes.tray(150, 90, 40)).plates)
    centre, size = centroid(part.body for part in parts)
    truth = shapes.slab_volume(150, 90, 40, 3, lid=False)
    hollow = 144 * 84 * 37
    z = (150 * 90 * 40 * 20 - hollow * (3 + 18.5)) / truth
    assert size == pytest.approx(truth)
    np.testing.assert_allclose(centre, (75, 45, z), atol=1e-6)


def test_a_box_stands_and_tips_at_the_angle_of_its_corner():
    check = checked((), shapes.box(120, 40, 100))
    assert check.standing.stands
    assert check.standing.margin_mm == pytest.approx(20.0)
    assert check.standing.tipping_deg == pytest.approx(math.degrees(math.atan2(20, 50)))
    # The back is as near: the first of the ways, not what rounding has.
    assert check.standing.way == "front"
    assert check.lines[0].startswith("nothing to fit to")


def test_a_leaning_prism_tips_over():
    over = {
        id_: [(x + 1.2 * z, y, z) for x, y, z in loop]
        for id_, loop in shapes.box_loops(60, 60, 120).items()
    }
    standing = checked((), shapes.model(over)).standing
    assert not standing.stands
    assert standing.way == "right"
    assert standing.margin_mm == pytest.approx(-(1.2 * 60 + 30 - 60), abs=1.0)
    assert "it does not stand: it tips to the right" in standing.words


def test_what_stands_on_an_edge_does_not_stand():
    plan = [(50, 0), (100, 80), (0, 80)]
    loops = {id_: [(x, z, y) for x, y, z in loop] for id_, loop in shapes.prism(plan, 60).items()}
    standing = checked((), shapes.model(loops)).standing
    assert "in a line only" in standing.words
    assert not standing.stands


def test_plates_that_little_holds_are_named():
    joined = joined_plates(shapes.bracket())
    assert loose_plates(joined) == (
        "floor is held by one joint only (e4); glue it",
        "wall is held by one joint only (e4); glue it",
    )
    butted = joined_plates(shapes.bracket(), PlateSettings(joints=(JointChoice("e4", "butt"),)))
    assert "floor is held by glue alone (e4)" in loose_plates(butted)
    apart = joined_plates(shapes.bracket(), PlateSettings(joints=(JointChoice("e4", "none"),)))
    assert loose_plates(apart) == ("nothing joins these to one another: floor; wall",)
    assert loose_plates(joined_plates(shapes.box())) == ()


def test_a_bridge_narrower_than_the_plate_is_named():
    thin = shapes.board()
    assert thin_plates(joined_plates(thin).plates) == ()
    ring = shapes.model(
        {"f1": [(0, 0, 0), (0, 0, 80), (50, 0, 80), (50, 0, 41), (55, 0, 41), (55, 0, 80),
                (120, 0, 80), (120, 0, 0), (55, 0, 0), (55, 0, 39), (50, 0, 39), (50, 0, 0)]}
    )  # fmt: skip
    (line,) = thin_plates(joined_plates(ring).plates)
    assert line.startswith("f1 is thinner than 3 mm about (")


def test_walls_that_no_printer_prints_are_named():
    """A wedge: its walls grow together towards its edge."""
    plan = [(0, 0), (60, 0), (60, 1.0)]
    loops = {id_: [(y, z, x) for x, y, z in loop] for id_, loop in shapes.prism(plan, 50).items()}
    model = shapes.model(loops)
    mesh = mesh_of(shell_solid(model, ShellSettings(solid=True)))
    (line,) = check_print(mesh, model, (), None, 0.4).weak
    # 0.392 mm thick 23.5 mm from its edge, on which it stands.
    low, high = (float(word) for word in line.split(" mm above")[0].split("from ")[1].split(" to "))
    assert low < 3.0
    assert high == pytest.approx(23.5, abs=1.5)
    thick = shapes.box(50, 50, 50)
    sound = mesh_of(shell_solid(thick, ShellSettings(1.0)))
    assert check_print(sound, thick, (), None, 0.4).weak == ()
