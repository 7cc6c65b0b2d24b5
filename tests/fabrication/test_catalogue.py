"""The laws of plates on every shape of the catalogue, turned in the world."""

import manifold3d as m3
import numpy as np
import pytest
import shapely
from fabrication.bodies import body, overlaps, union
from fabrication.catalogue import CATALOGUE, having

from incontext.workbench.fabrication import PlateSettings, joined_plates
from incontext.workbench.fabrication.cut_paths import cut_path


def test_the_catalogue_is_hard_enough():
    assert len(CATALOGUE) >= 12
    wanted = {"angle": 4, "partition": 3, "concave": 2, "unequal": 2, "valence 4": 1, "holes": 1}
    assert all(len(having(trait)) >= count for trait, count in wanted.items())


@pytest.mark.parametrize("name", CATALOGUE)
def test_laws(name):
    model = CATALOGUE[name].make(turned=len(name), moved=(210.0, -35.0, 12.0))
    joined = joined_plates(model, PlateSettings(kerf_mm=0.1))
    plates = joined.plates
    assert max(overlaps(plates).values()) <= 1e-6
    own = np.linalg.inv(plates[0].world_from_plate)
    whole = union(plates, own)
    # Nothing is counted twice: the union has the volume of all plates together.
    assert whole.volume() == pytest.approx(sum(body(p).volume() for p in plates), rel=1e-6)
    hull = m3.Manifold.hull_points(np.array(list(model.vertices_mm.values())))
    if not any(trait == "partition" for trait in CATALOGUE[name].traits):
        assert max((body(plate) - hull).volume() for plate in plates) <= 1e-3
    for plate in plates:
        outline = shapely.LinearRing(plate.outline)
        assert outline.is_simple
        assert plate.polygon.is_valid
        assert plate.polygon.buffer(-0.05).geom_type == "Polygon"
        # Slots keep one thickness from the border; a drawn hole lies where it was drawn.
        for hole in plate.holes:
            assert outline.distance(shapely.LinearRing(hole)) >= plate.thickness_mm - 1e-6


@pytest.mark.parametrize("name", CATALOGUE)
def test_a_round_beam_along_the_path_leaves_the_finished_part(name):
    kerf = 0.2
    for plate in joined_plates(CATALOGUE[name].make(), PlateSettings(kerf_mm=kerf)).plates:
        path = cut_path(plate, kerf)
        rings = [shapely.LinearRing(ring) for ring in (path.outer, *path.inner)]
        beam = shapely.union_all([ring.buffer(kerf / 2 - 1e-5, quad_segs=16) for ring in rings])
        assert plate.polygon.intersection(beam).area <= 1e-6 * plate.polygon.length
        stock = shapely.Polygon(path.outer, path.inner)
        left = stock.difference(beam)
        # What is left is the part; corners the beam cannot reach stay round by a little.
        extra = left.difference(plate.polygon.buffer(2e-5, join_style="mitre"))
        corners = sum(len(ring.coords) for ring in rings)
        assert extra.area <= corners * kerf**2 * 0.25
        assert len(path.inner) == len(plate.holes)
