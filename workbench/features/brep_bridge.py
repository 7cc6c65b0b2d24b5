"""Shapes of cadquery as FreeCAD shapes.

Two geometry kernels live in one process then; a shape of one must never reach the other, so it
crosses as BREP text, which both read exactly.
"""

from __future__ import annotations

import io
from typing import Any


def brep_text(shape: Any) -> str:
    """The BREP text of a cadquery shape."""
    buffer = io.BytesIO()
    shape.exportBrep(buffer)
    return buffer.getvalue().decode("ascii")


def shape_from_brep(text: str) -> Any:
    """The FreeCAD shape that BREP text says."""
    import Part

    shape = Part.Shape()
    shape.importBrepFromString(text)
    return shape
