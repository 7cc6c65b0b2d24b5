"""Makes the document of tests/data/documents that this FreeCAD is to have; see test_lasting."""

from __future__ import annotations

from pathlib import Path


def make(arguments: list[str]) -> int:
    """Save a shelf with everything that has to last; takes the path."""
    import json

    import FreeCAD

    from incontext.workbench.features.dimension_names import LENGTH, property_name
    from incontext.workbench.features.examples import import_sketch
    from incontext.workbench.features.lifted_model import make_lifted_model
    from incontext.workbench.features.plate_set import make_plate_set
    from incontext.workbench.features.shelled_solid import make_shelled_solid

    document = FreeCAD.newDocument("Shelf")
    sheet = document.addObject("Spreadsheet::Sheet", "Sizes")
    for cell, value, alias in (("A1", "260 mm", "width"), ("A2", "4 mm", "board")):
        sheet.set(cell, value)
        sheet.setAlias(cell, alias)
    data = Path(__file__).parent.parent / "data"
    sketch = import_sketch(document, data / "shelf.sketch.json")
    model = make_lifted_model(document, sketch)
    plates = make_plate_set(document, model)
    shell = make_shelled_solid(document, model)
    document.recompute()
    annotations = json.loads(sketch.Sketch)["annotations"].values()
    (edge,) = (a["edge"] for a in annotations if a["kind"] == "length")
    model.setExpression(property_name(LENGTH, edge), "Sizes.width")
    plates.setExpression("Thickness", "Sizes.board")
    document.recompute()
    print([obj.Status for obj in (sketch, model, plates, shell)])
    document.saveAs(arguments[0])
    return 0
