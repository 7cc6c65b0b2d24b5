"""FreeCAD's mesh module looks at prints: the only reader that sees bodies in one another."""

import Mesh
import pytest

from incontext.tests.fabrication import shapes
from incontext.workbench.fabrication import ShellSettings, shell_solid
from incontext.workbench.fabrication.meshes import mesh_of, stl_bytes


def shelf_with_front(**options):
    loops = dict(shapes.box_loops(120, 60, 90))
    loops["shelf"] = shapes.rect(2, 40, (0, 120), (0, 60))
    return shapes.model(loops, left_out=("front",), **options)


PRINTS = {
    "l box": lambda: shapes.l_box(left_out=("top",), turned=3),
    "closed box": lambda: shapes.box(turned=1),
    "shelf": shelf_with_front,
}


@pytest.mark.parametrize("name", PRINTS)
def test_no_triangle_cuts_another(name, tmp_path):
    solid = shell_solid(PRINTS[name](), ShellSettings(2.5))
    path = tmp_path / "print.stl"
    path.write_bytes(stl_bytes(mesh_of(solid)))
    mesh = Mesh.Mesh(str(path))
    assert mesh.isSolid()
    assert not mesh.hasSelfIntersections()
    assert not mesh.hasNonManifolds()
    assert not mesh.hasNonUniformOrientedFacets()
    assert mesh.Volume == pytest.approx(solid.Volume(), rel=1e-5)


def test_it_would_see_two_bodies_in_one_another():
    one, two = Mesh.createBox(10, 10, 10), Mesh.createBox(10, 10, 10)
    two.translate(4, 3, 2)
    one.addMesh(two)
    assert one.hasSelfIntersections()
