"""Hollow solids of revolution."""

from __future__ import annotations

import numpy as np
import pytest

from incontext.solver.model import Model, Turned
from incontext.workbench.fabrication.errors import FabricationError
from incontext.workbench.fabrication.meshes import mesh_of
from incontext.workbench.fabrication.settings import ShellSettings
from incontext.workbench.fabrication.turned import turned_solid, wall_section


def model_of(*profile, axis=(10.0, -20.0)) -> Model:
    return Model({}, {}, {}, {"r1": Turned(np.array(axis), np.array(profile, dtype=float))})


CAN = model_of((50, 0), (50, 80))
BELL = model_of((45, 95), (38, 110), (30, 112), (12, 135))
SAUCER = model_of((30, 0), (70, 12))


@pytest.mark.parametrize(
    ("side", "open_end", "volume"),
    [
        ("inside", "none", 50**2 * 80 - 48**2 * 76),
        ("inside", "bottom", 50**2 * 80 - 48**2 * 78),
        ("inside", "both", (50**2 - 48**2) * 80),
        ("outside", "none", 52**2 * 84 - 50**2 * 80),
        ("outside", "top", 52**2 * 82 - 50**2 * 80),
        ("middle", "none", 51**2 * 82 - 49**2 * 78),
    ],
)
def test_walls_of_a_can_are_exact(side, open_end, volume):
    solid = turned_solid(CAN, ShellSettings(2.0, side, open_end))
    assert solid.isValid()
    assert solid.Volume() == pytest.approx(np.pi * volume, rel=1e-9)
    centre = solid.BoundingBox().center
    assert (centre.x, centre.y) == pytest.approx((10.0, -20.0), abs=1e-6)


@pytest.mark.parametrize("model", [BELL, SAUCER, CAN], ids=["bell", "saucer", "can"])
@pytest.mark.parametrize("side", ["inside", "outside", "middle"])
@pytest.mark.parametrize("wall", [0.8, 2.0, 5.0])
def test_solid_follows_pappus_and_its_mesh_is_closed(model, side, wall):
    settings = ShellSettings(wall, side)
    section = wall_section("r1", model.turned["r1"], settings)
    solid = turned_solid(model, settings)
    assert solid.Volume() == pytest.approx(2 * np.pi * section.centroid.x * section.area, rel=1e-6)
    mesh = mesh_of(solid)  # refuses what is not watertight
    assert len(mesh.triangles) > 100


@pytest.mark.parametrize("side", ["inside", "outside"])
def test_the_drawn_side_is_one_face_of_the_wall(side):
    profile = BELL.turned["r1"].profile_rz_mm
    section = wall_section("r1", BELL.turned["r1"], ShellSettings(2.0, side))
    from shapely import LineString

    drawn = LineString(profile)
    assert section.boundary.intersection(drawn.buffer(1e-4)).length >= drawn.length - 0.01
    # The wall is nowhere thinner and, away from corners, nowhere thicker than asked.
    assert section.buffer(-0.99).area > 0
    assert section.buffer(-1.01).area < 0.05 * section.area


def test_a_lid_is_open_below_and_a_saucer_above():
    lid = turned_solid(BELL, ShellSettings(2.0))
    saucer = turned_solid(SAUCER, ShellSettings(2.0))
    assert not lid.isInside((10, -20, 96))
    assert lid.isInside((10, -20, 134))
    assert saucer.isInside((10, -20, 1))
    assert not saucer.isInside((10, -20, 11))


@pytest.mark.parametrize(
    ("model", "words"),
    [
        (model_of((20, 0), (20, 30)), "wall of 25 mm is too thick"),
        (model_of((20, 0), (-5, 10), (20, 30)), "crosses itself or the axis"),
        (model_of((20, 0), (30, 30), (30, 5), (10, 20)), "crosses itself or the axis"),
    ],
)
def test_what_cannot_be_made_is_refused_by_name(model, words):
    with pytest.raises(FabricationError, match=words) as caught:
        turned_solid(model, ShellSettings(25.0))
    assert "r1" in str(caught.value)
