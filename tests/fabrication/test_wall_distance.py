"""Walls of prints are as thick as asked, or another way of making them is taken."""

from dataclasses import replace

import pytest
from fabrication import shapes
from hunting import print_case

from incontext.workbench.fabrication import ShellSettings, shell, shell_solid
from incontext.workbench.fabrication.polyhedra import polyhedron_of
from incontext.workbench.fabrication.shell import _block, _hollow, _outwards
from incontext.workbench.fabrication.wall_distance import (
    ThinWallError,
    check_planes,
    check_wall,
)


@pytest.mark.parametrize("move", [-2.0, 2.0])
@pytest.mark.parametrize("left_out", [(), ("top",), ("bottom", "top")])
def test_planes_that_are_not_where_they_belong_are_told(move, left_out):
    model = shapes.l_box(left_out=left_out)
    body = polyhedron_of(model)
    outwards, wall = _outwards(body), _hollow(_block(body), body, left_out, move)
    check_planes(wall, body, outwards, left_out, move)
    with pytest.raises(ThinWallError, match=r"comes out 2 mm thick here, not 2.01 mm") as caught:
        check_planes(wall, body, outwards, left_out, 1.005 * move)
    assert set(caught.value.ids) <= set(body.skin) - set(left_out)


@pytest.mark.parametrize(
    ("move", "left_out"), [(-2.0, ()), (2.0, ()), (-2.0, ("top",)), (-2.0, ("front",))]
)
def test_the_least_distance_of_a_wall_is_told(move, left_out):
    body = polyhedron_of(shapes.box(left_out=left_out))
    wall = _hollow(_block(body), body, left_out, move)
    check_wall(wall, body, left_out, 2.0)
    with pytest.raises(ThinWallError, match=r"comes out 2 mm thick here, not 2.01 mm") as caught:
        check_wall(wall, body, left_out, 2.01)
    assert set(caught.value.ids) <= set(body.skin) - set(left_out)


def thinner(block, body, mouths, move):
    """A kernel whose walls are a tenth too thin."""
    return _hollow(block, body, mouths, 0.9 * move)


@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
def test_where_the_kernel_falls_short_slabs_are_taken(side, monkeypatch):
    model, settings = shapes.l_box(left_out=("top",)), ShellSettings(3.0, side)
    volume = shell_solid(model, settings).Volume()
    monkeypatch.setattr(shell, "_hollow", thinner)
    assert shell_solid(model, settings).Volume() == pytest.approx(volume, rel=1e-9)


def test_a_wall_that_no_way_makes_thick_enough_is_refused_with_its_number(monkeypatch):
    def no_slabs(*_):
        raise ValueError

    monkeypatch.setattr(shell, "_hollow", thinner)
    monkeypatch.setattr(shell, "built_wall", no_slabs)
    with pytest.raises(ThinWallError, match=r"comes out 2.7 mm thick here, not 3 mm") as caught:
        shell_solid(shapes.l_box(), ShellSettings(3.0))
    assert caught.value.ids


def test_faces_of_a_convex_wall_are_whole():
    """Two faces in each plane, none in triangles."""
    model, settings = print_case("pencil", 13000)
    for side in ("inside", "outside", "middle"):
        wall = shell_solid(model, replace(settings, side=side))
        assert len(wall.Faces()) == 2 * len(model.faces)
