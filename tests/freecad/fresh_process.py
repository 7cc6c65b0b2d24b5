"""What a second FreeCAD does for a test: started by `launch`, answers in a JSON file."""

import json
import sys
from pathlib import Path


def loaded_modules(arguments: list[str]) -> int:
    """Write the names of the modules that are loaded after the start."""
    names = sorted(sys.modules)
    Path(arguments[0]).write_text(json.dumps(names), encoding="utf-8")
    return 0


def reopen(arguments: list[str]) -> int:
    """Open a document; write proxies and volumes, before and after recomputing everything."""
    import FreeCAD

    answer, path = arguments
    document = FreeCAD.openDocument(path)
    found = {"proxies": [type(obj.Proxy).__name__ for obj in document.Objects]}
    found["modules"] = [type(obj.Proxy).__module__ for obj in document.Objects]
    found["stored"] = _measure(document)
    for obj in document.Objects:
        obj.touch()
    document.recompute()
    found["recomputed"] = _measure(document)
    document.getObject("PlateSet").Thickness = 5
    document.recompute()
    found["thicker"] = _measure(document)
    Path(answer).write_text(json.dumps(found), encoding="utf-8")
    return 0


def _measure(document) -> dict[str, float]:
    plates, model = document.getObject("PlateSet"), document.getObject("LiftedModel")
    photo = Path(document.getObject("PhotoSketch").Photo)
    return {
        "volume": plates.Shape.Volume,
        "solids": len(plates.Shape.Solids),
        "area": model.Shape.Area,
        "photo_bytes": photo.stat().st_size,
    }
