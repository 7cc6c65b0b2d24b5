"""Walls as slabs: the kernel's own where it can, and one around every other vertex."""

import pytest
from fabrication import shapes
from fabrication.print_laws import broken_print

from incontext.workbench.fabrication import ShellSettings, shell_solid
from incontext.workbench.fabrication.mixed_walls import mixed_wall
from incontext.workbench.fabrication.polyhedra import polyhedron_of
from incontext.workbench.fabrication.shell import _block, _hollow, _mixed, _outwards

PLAN = [(0, 0), (60, 40), (120, 0), (130, 70), (60, 100), (0, 60)]


def spire(left_out=()):
    """A tip over a concave polygon: edges look outwards and inwards in it."""
    loops = {"bottom": [(x, y, 0.0) for x, y in PLAN]}
    for n, corner in enumerate(PLAN):
        after = PLAN[(n + 1) % len(PLAN)]
        loops[f"s{n}"] = [(*corner, 0.0), (*after, 0.0), (60.0, 62.0, 90.0)]
    return shapes.model(loops, left_out=left_out)


@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
@pytest.mark.parametrize("left_out", [(), ("bottom",)])
def test_walls_around_a_vertex_of_convex_and_concave_edges(side, left_out):
    model, settings = spire(left_out), ShellSettings(side=side)
    body = polyhedron_of(model)
    assert _mixed(body, _outwards(body), left_out)
    assert list(broken_print(model, settings)) == []
    solid = shell_solid(model, settings)
    assert solid.isValid()
    assert len(solid.Solids()) == 1


@pytest.mark.parametrize("move", [-3.0, 2.5])
@pytest.mark.parametrize("left_out", [(), ("top",)])
@pytest.mark.parametrize("shape", ["house", "concave"])
def test_elsewhere_it_is_the_wall_of_the_kernel(shape, left_out, move):
    plan = PLAN if shape == "concave" else [(0, 0), (90, 0), (90, 50), (40, 80), (0, 50)]
    model = shapes.model(shapes.prism(plan, 70.0), left_out=left_out)
    body = polyhedron_of(model)
    block = _block(body)
    ours = mixed_wall(block, body, _outwards(body), left_out, move)
    kernel = _hollow(block, body, list(left_out), move)
    assert ours.Volume() == pytest.approx(kernel.Volume(), rel=1e-9)
