"""Walls put together from pieces: exact where planes meet, thick enough everywhere."""

from dataclasses import replace

import pytest
from fabrication import shapes
from fabrication.print_laws import broken_print
from hunting import print_case

from incontext.workbench.fabrication import ShellSettings, shell_solid

PLAN = [(0, 0), (60, 40), (120, 0), (130, 70), (60, 100), (0, 60)]


def spire(left_out=()):
    """A tip over a concave polygon: edges look outwards and inwards in it."""
    loops = {"bottom": [(x, y, 0.0) for x, y in PLAN]}
    for n, corner in enumerate(PLAN):
        after = PLAN[(n + 1) % len(PLAN)]
        loops[f"s{n}"] = [(*corner, 0.0), (*after, 0.0), (60.0, 62.0, 90.0)]
    return shapes.model(loops, left_out=left_out)


@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
@pytest.mark.parametrize(
    "left_out", [(), ("bottom",), ("s0",), ("s3",), ("s5",), ("s0", "s1"), ("s2", "bottom")]
)
def test_walls_around_a_vertex_of_convex_and_concave_edges(side, left_out):
    """Beside openings too, two of them next to each other."""
    model, settings = spire(left_out), ShellSettings(side=side)
    assert list(broken_print(model, settings)) == []
    solid = shell_solid(model, settings)
    assert solid.isValid()
    assert len(solid.Solids()) == 1


@pytest.mark.parametrize("left_out", ["s0", "s3", "s5"])
def test_an_opening_beside_such_a_vertex_is_open(left_out):
    """The kernel crashes at such shapes; no wall reaches over the opening."""
    model = spire((left_out,))
    solid = shell_solid(model)
    assert solid.isValid()
    assert len(solid.Solids()) == 1
    closed = shell_solid(spire())
    assert solid.Volume() < closed.Volume() - 1000.0
    middle = model.faces[left_out].loop_mm.mean(axis=0)
    assert not solid.isInside(tuple(middle + 0.1 * (model.vertices_mm["v7"] - middle)), 1e-6)


@pytest.mark.parametrize("move", [-3.0, 2.5])
@pytest.mark.parametrize("left_out", [(), ("top",)])
@pytest.mark.parametrize("plan", [PLAN, [(0, 0), (90, 0), (90, 50), (40, 80), (0, 50)]])
def test_a_prism_has_the_wall_of_its_moved_polygon(plan, left_out, move):
    from shapely import Polygon

    side, h = ("inside" if move < 0 else "outside"), 70.0
    model = shapes.model(shapes.prism(plan, h), left_out=left_out)
    area = Polygon(plan).area
    moved = Polygon(plan).buffer(move, join_style="mitre", mitre_limit=100.0).area
    tall = h + move * (1 if left_out else 2)
    solid = shell_solid(model, ShellSettings(abs(move), side))
    assert solid.Volume() == pytest.approx(abs(moved * tall - area * h), rel=1e-9)


def test_rims_may_end_nearer_to_a_face_than_its_wall_is_thick():
    """What lies straight over each face is full: the wall is no thinner for it."""
    model, settings = print_case("frustum", 40307)
    assert list(broken_print(model, settings)) == []


def test_faces_of_a_wall_are_whole():
    """Two faces in each plane, none in triangles."""
    model, settings = print_case("pencil", 13000)
    for side in ("inside", "outside", "middle"):
        wall = shell_solid(model, replace(settings, side=side))
        assert len(wall.Faces()) == 2 * len(model.faces)
