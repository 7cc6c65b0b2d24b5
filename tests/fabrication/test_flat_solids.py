"""Triangles made faces of the kernel's: rounding goes, what touches in an edge is told."""

import numpy as np
import pytest
from fabrication import shapes
from fabrication.print_laws import broken_print
from hunting import print_case
from manifold3d import Manifold, Mesh64, OpType

from incontext.workbench.fabrication import FabricationError, ShellSettings, shell, shell_solid
from incontext.workbench.fabrication.booleans import hull, united
from incontext.workbench.fabrication.flat_solids import (
    PartedError,
    TouchingError,
    flat_faces,
    kernel_solid,
)
from incontext.workbench.fabrication.frame import newell


def cube(*low, size=(10.0, 10.0, 10.0)):
    return Manifold.cube(list(size)).translate(list(low))


def turned(body):
    return body.rotate([17.0, 31.0, 5.0])


def test_films_between_bodies_that_nearly_touch_go():
    """Gaps of 1e-9 mm, one of them cut into other triangles than what lies opposite."""
    low = cube(0, 0, 0, size=(20, 10, 10))
    high = Manifold.compose([cube(0, 0, 10 + 1e-9), cube(10 + 1e-9, 0, 10 + 1e-9)])
    solid = kernel_solid(turned(Manifold.batch_boolean([low, high], OpType.Add)))
    assert solid.isValid()
    assert len(solid.Faces()) == 6
    assert solid.Volume() == pytest.approx(4000.0, rel=1e-7)


def test_vertices_on_edges_and_triangles_without_width_go():
    points = [(0, 0, 0), (9, 0, 0), (0, 9, 0), (0, 0, 9), (4.5, 4.5, 1e-8)]
    triangles = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 4), (1, 4, 3), (4, 2, 3)]
    body = Manifold(Mesh64(np.array(points, float), np.array(triangles, np.uint64)))
    _, faces = flat_faces(body)
    assert sorted(len(ring) for face in faces for ring in face.rings) == [3, 3, 3, 3]


def test_a_hollow_and_a_hole_through_a_face_are_kept():
    body = cube(0, 0, 0) - cube(2, 2, 2, size=(6, 6, 6)) - cube(4, 4, 7, size=(2, 2, 4))
    solid = kernel_solid(turned(body))
    assert solid.Volume() == pytest.approx(1000 - 216 - 8, rel=1e-9)
    assert sorted(len(face.innerWires()) for face in solid.Faces()) == [0] * 14 + [1, 1]


@pytest.mark.parametrize("shift", [(10, 10, 0), (10, 10, 5)])
def test_bodies_that_share_an_edge_are_told_with_it(shift):
    with pytest.raises(TouchingError) as caught:
        kernel_solid(Manifold.batch_boolean([cube(0, 0, 0), cube(*shift)], OpType.Add))
    (edge,) = caught.value.edges_mm
    assert sorted(edge[:, 2].tolist()) == [float(shift[2]), 10.0]
    assert edge[:, :2].tolist() == [[10.0, 10.0]] * 2


def test_bodies_that_lie_apart_are_told():
    with pytest.raises(PartedError, match="2 solids instead of one") as caught:
        kernel_solid(Manifold.compose([cube(0, 0, 0), cube(30, 0, 0)]))
    assert [len(part) for part in caught.value.parts_mm] == [8, 8]
    with pytest.raises(FabricationError, match="nothing is left"):
        kernel_solid(Manifold())


def test_openings_that_part_the_walls_are_refused_with_a_face_of_each_part():
    sides = ("front", "back", "left", "right")
    with pytest.raises(PartedError, match="leave fewer faces out") as caught:
        shell_solid(shapes.box(left_out=sides))
    assert sorted(caught.value.ids) == ["bottom", "top"]


def test_walls_that_would_touch_in_an_edge_are_joined_by_a_bead(monkeypatch):
    """A partition that two windows leave with an edge in common with a wall."""
    model, settings = print_case("polycube", 50020)
    solid = shell_solid(model, settings)
    assert solid.isValid()
    monkeypatch.setattr(shell, "_BEAD", 1e-4)
    assert shell_solid(model, settings).Volume() == pytest.approx(solid.Volume(), rel=1e-4)
    monkeypatch.setattr(shell, "_bead", lambda *_: cube(1e4, 0, 0))
    with pytest.raises((TouchingError, PartedError)) as caught:
        shell_solid(model, settings)
    assert caught.value.ids


def test_rims_end_in_the_plane_of_an_opening_where_nothing_is_made_in_it():
    """No steps of 0.3 mm in front of it, though the same plane has a wall elsewhere."""
    model, settings = print_case("section", 50018)
    mouth = model.faces["side1"].loop_mm
    normal = newell(mouth) / np.linalg.norm(newell(mouth))
    corners = np.array([v.toTuple() for v in shell_solid(model, settings).Vertices()])
    heights = (corners - mouth[0]) @ normal
    near = np.abs(heights) < settings.wall_mm / 2
    assert np.abs(heights[near]).max() < 1e-6


@pytest.mark.parametrize("seed", [50003, 60017])
def test_no_piece_of_a_union_is_lost(seed):
    """`batch_boolean` alone loses 45 and 15 mm3 of walls."""
    family = "polycube" if seed == 50003 else "prism"
    assert list(broken_print(*print_case(family, seed))) == []


def test_a_hull_of_points_that_nearly_lie_in_a_plane():
    """manifold3d's own hull of a gusset had 17 % more: it passed through itself."""
    rng = np.random.default_rng(5)
    square = np.array([(0, 0, 0), (8, 0, 0), (8, 8, 0), (0, 8, 0), (4, 4, 0), (0, 4, 0)], float)
    points = np.vstack([square, square + np.array([0.0, 0.0, 3.0])])
    points += 1e-15 * rng.normal(size=points.shape)
    body = hull(points @ np.linalg.qr(rng.normal(size=(3, 3)))[0])
    assert body.volume() == pytest.approx(192.0, rel=1e-12)
    assert hull(square).is_empty()
    assert united([body, hull(square)]).volume() == pytest.approx(192.0, rel=1e-12)


@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
def test_a_solid_print_is_the_block(side):
    solid = shell_solid(shapes.l_box(turned=3), ShellSettings(3.0, side, solid=True))
    assert solid.Volume() == pytest.approx(shapes._l_area(0.0) * 50, rel=1e-9)
    assert len(solid.Faces()) == 8
