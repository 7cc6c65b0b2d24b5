"""The kerf: a simulated beam along the path leaves the finished size."""

import numpy as np
import pytest
import shapely
from fabrication import shapes

from incontext.workbench.fabrication import FabricationError, Plate, make_plates
from incontext.workbench.fabrication.cut_paths import cut_path


def path_lines(path):
    return [shapely.LinearRing(ring) for ring in (path.outer, *path.inner)]


@pytest.mark.parametrize("kerf", [0.08, 0.2, 0.5])
@pytest.mark.parametrize("name", ["organizer_6", "magazine_file"])
def test_the_beam_leaves_the_part(name, kerf):
    for plate in make_plates(shapes.TRUTHS[name].make()):
        path = cut_path(plate, kerf)
        beam = shapely.union_all([line.buffer(kerf / 2) for line in path_lines(path)])
        # Path positions are multiples of 1e-6 mm.
        assert beam.intersection(plate.polygon).area < 1e-7 * plate.polygon.length
        stock = shapely.box(*plate.polygon.buffer(20).bounds)
        left = [
            part
            for part in shapely.get_parts(stock.difference(beam))
            if part.contains(plate.polygon.representative_point())
        ]
        assert len(left) == 1
        # The round beam leaves a fillet in each inner corner: (1 - pi / 4) (k / 2)^2.
        rings = [plate.outline, *plate.holes]
        fillets = sum(len(ring) for ring in rings) * (1 - np.pi / 4) * (kerf / 2) ** 2
        assert left[0].area - plate.polygon.area == pytest.approx(fillets / 2, abs=fillets)
        assert left[0].covers(plate.polygon.buffer(-1e-5))


def test_no_kerf_is_the_finished_outline():
    plate = make_plates(shapes.tray())[0]
    assert cut_path(plate, 0.0).outer is plate.outline


def test_outlines_grow_and_holes_shrink():
    plate = make_plates(shapes.bookshelf())[3]
    path = cut_path(plate, 0.2)
    np.testing.assert_allclose(np.ptp(path.outer, axis=0), np.ptp(plate.outline, axis=0) + 0.2)
    assert len(path.inner) == len(plate.holes) > 0
    for cut, hole in zip(path.inner, plate.holes, strict=True):
        np.testing.assert_allclose(np.ptp(cut, axis=0), np.ptp(hole, axis=0) - 0.2, atol=1e-5)


def square_with_hole(width: float) -> Plate:
    hole = np.array([(10, 10), (10, 20), (10 + width, 20), (10 + width, 10)], dtype=float)
    outline = np.array([(0, 0), (40, 0), (40, 40), (0, 40)], dtype=float)
    return Plate("p1", ("p1",), 3.0, outline, (hole,), np.eye(4))


def test_a_hole_narrower_than_the_kerf_is_named():
    with pytest.raises(FabricationError, match="narrower than the kerf") as caught:
        cut_path(square_with_hole(0.15), 0.2)
    assert caught.value.ids == ("p1",)
    assert len(cut_path(square_with_hole(0.4), 0.2).inner) == 1


def test_a_notch_narrower_than_the_kerf_is_named():
    outline = [(0, 0), (40, 0), (40, 40), (20.1, 40), (20.1, 20), (20, 20), (20, 40), (0, 40)]
    plate = Plate("p2", ("p2",), 3.0, np.array(outline, dtype=float), (), np.eye(4))
    with pytest.raises(FabricationError, match="narrower than the kerf"):
        cut_path(plate, 0.3)
