"""Plates as solids in the world, and any solid as STEP. The raw kernel is here and in the shell.

One prism a plate from its finished outline: cutting fingers one by one takes a thousand times as
long.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ...solver.values import Array
from .errors import FabricationError
from .plates import Plate

if TYPE_CHECKING:
    import cadquery as cq


def plate_solid(plate: Plate) -> cq.Solid:
    """A plate as a solid in its place in the world, mm."""
    import cadquery as cq
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Pnt, gp_Vec

    def wire(ring: Array) -> BRepBuilderAPI_MakePolygon:
        polygon = BRepBuilderAPI_MakePolygon()
        for x, y in ring.tolist():
            polygon.Add(gp_Pnt(x, y, 0.0))
        polygon.Close()
        return polygon.Wire()

    face = BRepBuilderAPI_MakeFace(wire(plate.outline), True)
    for hole in plate.holes:
        face.Add(wire(hole))
    prism = BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0.0, 0.0, plate.thickness_mm))
    solid = cq.Solid(prism.Shape())
    return solid.moved(_location(plate.world_from_plate))


def _location(matrix: Array) -> cq.Location:
    import cadquery as cq
    from OCP.gp import gp_Trsf

    transform = gp_Trsf()
    transform.SetValues(*matrix[:3].ravel().tolist())
    return cq.Location(transform)


def assemble(plates: Sequence[Plate]) -> cq.Compound:
    """All plates put together.

    Parameters
    ----------
    plates : sequence of Plate

    Returns
    -------
    cadquery.Compound
        One solid a plate, in the same order, in world mm.
    """
    import cadquery as cq

    return cq.Compound.makeCompound([plate_solid(plate) for plate in plates])


def shape_step_bytes(shape: cq.Shape, name: str = "solid") -> bytes:
    """A shape as STEP: the same bytes for the same shape."""
    import cadquery as cq

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "out.step"
        # Curves on surfaces are a third of the file, and planes need none.
        cq.Assembly(shape, name=name).export(str(path), exportType="STEP", write_pcurves=False)
        if not path.is_file():
            raise FabricationError("the STEP file could not be written", (), "another format")
        text = path.read_bytes()
    return re.sub(rb"'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d'", b"'2000-01-01T00:00:00'", text)
