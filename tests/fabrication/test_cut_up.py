"""Plates of which nothing whole is left: who takes it, at which edge, by which numbers."""

import numpy as np
import pytest
from fabrication import shapes
from hunting import case

from incontext.workbench.fabrication import FabricationError, PlateSettings, make_plates

#: An L; the partition passes its inner corner so near that both walls there go through it.
ELL = [(0, 0), (140, 0), (140, 50), (50, 50), (50, 120), (0, 120)]


def brushed(gap: float):
    loops = shapes.prism(ELL, 80.0)
    (x0, y0), (x1, y1) = (0.0, 100.0 - gap), (100.0 - gap, 0.0)
    loops["p"] = [(x0, y0, 0.0), (x1, y1, 0.0), (x1, y1, 80.0), (x0, y0, 80.0)]
    return shapes.model(loops, thickness=4.0)


def test_a_partition_that_brushes_a_corner_says_which():
    model = brushed(gap=1.0)
    with pytest.raises(FabricationError, match="plates of 4 mm cut p into 2 pieces") as caught:
        make_plates(model)
    error = caught.value
    (edge,) = (id_ for id_ in error.ids if id_ in model.edges)
    ends = [model.vertices_mm[v][:2].tolist() for v in model.edges[edge]]
    assert ends == [[50, 50], [50, 50]]
    assert {*error.ids} == {"p", "side3", "side4", edge}
    assert "mm apart" in str(error)
    assert "; try: thinner plates" in str(error)
    assert len(make_plates(brushed(gap=20.0))) == 9


def test_too_thick_plates_leave_nothing_of_a_narrow_one():
    model = shapes.polycube(20, thickness=25.0)
    with pytest.raises(FabricationError, match=r"plates of 25 mm leave nothing of f13") as caught:
        make_plates(model, PlateSettings(side="middle"))
    assert caught.value.ids[0] == "f13"
    assert any(id_ in model.edges for id_ in caught.value.ids)


def test_an_edge_that_turns_round_when_it_moves_is_named():
    model, settings = case("halfspaces", 50107)
    with pytest.raises(FabricationError, match=r"an edge of 3\.3 mm would run") as caught:
        make_plates(model, settings)
    face, edge = caught.value.ids
    v, w = (model.vertices_mm[v] for v in model.edges[edge])
    assert round(float(np.linalg.norm(v - w)), 1) == 3.3
    assert {*model.edges[edge]} <= {*model.faces[face].loop}
