"""Every example as document objects: what comes out is what is expected."""

import ezdxf
import Import
import numpy as np
import pytest

from incontext.workbench.examples import EXAMPLES, load_example
from incontext.workbench.features.examples import make_example
from incontext.workbench.features.exports import export_plates
from incontext.workbench.features.plate_set import plates_of

CUT = ("CUT_OUTER", "CUT_INNER")


@pytest.mark.parametrize("name", EXAMPLES)
def test_example_has_its_facts(document, name):
    facts = load_example(name).facts
    rough = {"rel": facts["tolerance"]}
    _, model, product = make_example(document, name)
    assert (model.Status, product.Status) == ("converged", "made"), product.Message
    assert not model.ScaleAssumed
    assert product.Shape.isValid()
    box = product.Shape.BoundBox
    size = [box.XLength, box.YLength, box.ZLength]
    # FreeCAD's box of a turned solid is a little too large.
    assert size == pytest.approx(facts["size_mm"], rel=3 * facts["tolerance"])
    if "plates" in facts:
        assert product.PlateCount == facts["plates"]
        rings = [r for plate in plates_of(product) for r in (plate.outline, *plate.holes)]
        length = sum(np.linalg.norm(np.diff([*r, r[0]], axis=0), axis=1).sum() for r in rings)
        assert length == pytest.approx(facts["cut_length_mm"], **rough)
    else:
        assert product.Shape.Volume == pytest.approx(facts["volume_mm3"], **rough)


@pytest.mark.parametrize("name", [n for n in EXAMPLES if not load_example(n).is_printed])
def test_freecads_importer_reads_the_plates(document, name, tmp_path):
    _, _, plates = make_example(document, name)
    export_plates(plates, tmp_path, name)
    drawing = ezdxf.readfile(tmp_path / f"{name}.dxf")
    for entity in [e for e in drawing.modelspace() if e.dxf.layer not in CUT]:
        drawing.modelspace().delete_entity(entity)
    drawing.saveas(tmp_path / "cuts.dxf")
    known = set(document.Objects)
    Import.readDXF(str(tmp_path / "cuts.dxf"), document.Name)
    document.recompute()
    read = [o.Shape for o in document.Objects if o not in known and hasattr(o, "Shape")]
    facts = load_example(name).facts
    length = sum(shape.Length for shape in read)
    assert length == pytest.approx(facts["cut_length_mm"], rel=facts["tolerance"])
