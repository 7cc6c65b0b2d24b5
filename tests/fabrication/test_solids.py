"""Plates in the kernel, shells, meshes: exact volumes."""

import io
import itertools
import zipfile
from itertools import pairwise

import lib3mf
import numpy as np
import pytest
import trimesh
from fabrication import shapes
from shapely.geometry import Polygon

from incontext.workbench.fabrication import (
    FabricationError,
    ShellSettings,
    assemble,
    make_plates,
    shell_solid,
)
from incontext.workbench.fabrication.meshes import (
    Mesh,
    check_mesh,
    mesh_of,
    stl_bytes,
    threemf_bytes,
)
from incontext.workbench.fabrication.solids import shape_step_bytes

HEXAGON = [(50, 0), (150, 0), (205, 85), (150, 180), (45, 170), (0, 90)]


def shelf_with_front(**options):
    """The bookshelf as a closed body, its front an opening."""
    loops = dict(shapes.box_loops(200, 90, 160))
    loops["shelf"] = shapes.rect(2, 75, (0, 200), (0, 90))
    return shapes.model(loops, left_out=("front",), **options)


def test_the_kernel_sees_no_overlap_and_no_void():
    compound = assemble(make_plates(shapes.bookshelf(turned=4)))
    solids = compound.Solids()
    assert len(solids) == 6
    assert all(solid.isValid() for solid in solids)
    for one, two in itertools.combinations(solids, 2):
        shared = one.intersect(two)
        assert sum(solid.Volume() for solid in shared.Solids()) <= 1e-6
    whole = solids[0].fuse(*solids[1:])
    assert whole.Volume() == pytest.approx(shapes.wall_volume("bookshelf", "inside"), rel=1e-9)


@pytest.mark.parametrize("turned", [None, 6])
@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
def test_a_closed_box_is_hollow(side, turned):
    solid = shell_solid(shapes.box(turned=turned), ShellSettings(3.0, side))
    assert solid.isValid()
    assert solid.Volume() == pytest.approx(shapes.wall_volume("box", side), rel=1e-9)


@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
def test_an_open_box_over_an_l(side):
    out = {"inside": 0.0, "outside": 3.0, "middle": 1.5}[side]
    inn = 3.0 - out
    outer, inner = shapes._l_area(out), shapes._l_area(-inn)
    solid = shell_solid(shapes.l_box(left_out=("top",)), ShellSettings(3.0, side))
    assert solid.Volume() == pytest.approx(outer * (50 + out) - inner * (50 - inn), rel=1e-9)


def test_walls_aslant():
    plan = Polygon(HEXAGON)
    solid = shell_solid(shapes.model(shapes.prism(HEXAGON, 70), left_out=("top",), turned=1))
    inner = plan.buffer(-2.0, join_style="mitre").area
    assert solid.Volume() == pytest.approx(plan.area * 70 - inner * 68, rel=1e-9)


@pytest.mark.parametrize("side", ["inside", "outside"])
def test_partitions_are_fused(side):
    solid = shell_solid(shelf_with_front(turned=3), ShellSettings(3.0, side))
    assert solid.Volume() == pytest.approx(shapes.wall_volume("bookshelf", side), rel=1e-9)


def test_a_window_is_cut_through_its_wall():
    loops = dict(shapes.box_loops(100, 80, 60))
    loops["front"] = shapes.rect(1, 0, (0, 60), (0, 40))
    loops["window"] = shapes.rect(1, 0, (0, 60), (40, 100))
    solid = shell_solid(shapes.model(loops, left_out=("window",)), ShellSettings(3.0))
    assert solid.Volume() == pytest.approx(100 * 80 * 60 - 94 * 74 * 54 - 60 * 60 * 3, rel=1e-9)


def test_a_solve_leaves_planes_a_little_bent():
    rng = np.random.default_rng(3)
    loops = {
        id_: [
            tuple(np.array(p) + 1e-4 * np.sin([7 * p[0], p[1] + p[2], p[0] + 3 * p[2]])) for p in f
        ]
        for id_, f in shapes.prism(HEXAGON, 70).items()
    }
    solid = shell_solid(shapes.model(loops, turned=int(rng.integers(9))), ShellSettings(2.0))
    plan = Polygon(HEXAGON)
    volume = plan.area * 70 - plan.buffer(-2.0, join_style="mitre").area * 66
    assert solid.isValid()
    assert solid.Volume() == pytest.approx(volume, rel=1e-4)


def test_a_flat_loop_without_a_face_is_an_opening():
    solid = shell_solid(shapes.tray(turned=2), ShellSettings(3.0))
    assert solid.Volume() == pytest.approx(150 * 90 * 40 - 144 * 84 * 37, rel=1e-9)
    shelf = shell_solid(shapes.bookshelf(turned=2), ShellSettings(3.0))
    assert shelf.Volume() == pytest.approx(shapes.wall_volume("bookshelf", "inside"), rel=1e-9)


def test_edges_that_lie_open_in_no_plane_are_named():
    loops = {f: x for f, x in shapes.box_loops(90, 70, 40).items() if f not in ("top", "front")}
    model = shapes.model(loops)
    with pytest.raises(FabricationError, match="do not close") as caught:
        shell_solid(model)
    uses = [frozenset(p) for f in model.faces.values() for p in pairwise((*f.loop, f.loop[0]))]
    free = {e for e, ends in model.edges.items() if uses.count(frozenset(ends)) == 1}
    assert set(caught.value.ids) == free


@pytest.mark.parametrize("wall", [30.0, 45.0])
def test_a_wall_too_thick_is_refused(wall):
    with pytest.raises(FabricationError, match="thinner wall"):
        shell_solid(shapes.box(), ShellSettings(wall))


def test_normals_in_a_file_are_those_of_the_corners_in_it():
    # A sliver's is turned by rounding; programs that repair would turn it back.
    corners = np.array([(187.123456, 0.1, 0.2), (3.3, 150.7, 91.1), (95.2, 75.400012, 45.65)])
    data = stl_bytes(Mesh(corners, np.array([(0, 1, 2)], dtype=np.int32)))
    normal, *written = np.frombuffer(data[84:132], "<f4").reshape(4, 3).astype(float)
    wanted = np.cross(written[1] - written[0], written[2] - written[0])
    assert normal == pytest.approx(wanted / np.linalg.norm(wanted), abs=1e-6)


def test_mesh_files_read_back():
    solid = shell_solid(shelf_with_front(turned=3), ShellSettings(3.0))
    mesh = mesh_of(solid)
    stl = trimesh.load(io.BytesIO(stl_bytes(mesh)), file_type="stl")
    assert stl.is_watertight
    assert stl.volume == pytest.approx(solid.Volume(), rel=1e-5)
    data = threemf_bytes(mesh, "shelf")
    assert data == threemf_bytes(mesh, "shelf")
    assert zipfile.ZipFile(io.BytesIO(data)).testzip() is None
    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromBuffer(data)
    assert reader.GetWarningCount() == 0
    objects = model.GetMeshObjects()
    assert objects.MoveNext()
    assert objects.GetCurrentMeshObject().IsManifoldAndOriented()


def test_an_open_mesh_is_refused():
    mesh = mesh_of(shell_solid(shapes.box()))
    with pytest.raises(FabricationError, match="not closed"):
        check_mesh(Mesh(mesh.vertices_mm, mesh.triangles[1:]), 1.0, 0.0)


def test_a_shape_as_step():
    data = shape_step_bytes(shell_solid(shapes.box()), "box")
    assert data.startswith(b"ISO-10303-21;")
    assert b"2000-01-01T00:00:00" in data


def test_two_bodies_are_no_print():
    loops = shapes.box_loops(40.0, 40.0, 40.0)
    beside = {
        f"{id_}_2": [(x / 4 + 60, y / 4 + 15, z / 4 + 15) for x, y, z in loop]
        for id_, loop in loops.items()
    }
    with pytest.raises(FabricationError, match="a body of their own") as caught:
        shell_solid(shapes.model({**loops, **beside}))
    assert set(caught.value.ids) in (set(loops), set(beside))
    assert shell_solid(shapes.model(loops)).isValid()
