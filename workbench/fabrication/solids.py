"""Plates as solids in the world, and STEP. The only home of the raw kernel besides the shell.

One prism a plate from its finished outline: cutting fingers one by one takes a thousand times as
long.
"""

from __future__ import annotations

import itertools
import re
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

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


def plates_step_bytes(plates: Sequence[Plate], name: str = "plates") -> bytes:
    """The plates put together as STEP: an assembly, each plate a part by its own name."""
    from OCP.TDataStd import TDataStd_Name
    from OCP.TopLoc import TopLoc_Location

    document, tool = _document()
    whole = tool.NewShape()
    TDataStd_Name.Set_s(whole, _words(name))
    for plate in plates:
        part = tool.AddShape(plate_solid(plate).wrapped, False)
        for label in (part, tool.AddComponent(whole, part, TopLoc_Location())):
            TDataStd_Name.Set_s(label, _words(plate.id))
    tool.UpdateAssemblies()
    return _step_bytes(document)


def shape_step_bytes(shape: cq.Shape, name: str = "solid") -> bytes:
    """A shape as STEP."""
    from OCP.TDataStd import TDataStd_Name

    document, tool = _document()
    TDataStd_Name.Set_s(tool.AddShape(shape.wrapped, False), _words(name))
    return _step_bytes(document)


def _document() -> tuple[Any, Any]:
    """A document of the kernel's, without colours: it writes those in another order each time.

    An assembly of cadquery takes every letter of a name but the plain ones for two.
    """
    from OCP.TDocStd import TDocStd_Document
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    document = TDocStd_Document(_words("XmlXCAF"))
    return document, XCAFDoc_DocumentTool.ShapeTool_s(document.Main())


def _words(text: str) -> Any:
    from OCP.TCollection import TCollection_ExtendedString

    return TCollection_ExtendedString(text, True)


def _step_bytes(document: Any) -> bytes:
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.Interface import Interface_Static
    from OCP.STEPCAFControl import STEPCAFControl_Writer
    from OCP.STEPControl import STEPControl_StepModelType

    writer = STEPCAFControl_Writer()
    writer.SetNameMode(True)
    # Curves on surfaces are a third of the file, and planes need none.
    Interface_Static.SetIVal_s("write.surfacecurve.mode", 0)
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "out.step"
        written = writer.Transfer(document, STEPControl_StepModelType.STEPControl_AsIs)
        if not written or writer.Write(str(path)) != IFSelect_RetDone:
            raise FabricationError("the STEP file could not be written", (), "another format")
        text = path.read_bytes()
    return _without_chance(text)


def _without_chance(text: bytes) -> bytes:
    """The same STEP text for the same shapes: no time of writing, no count of earlier files."""
    numbers = itertools.count(1)
    text = re.sub(rb"'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d'", b"'2000-01-01T00:00:00'", text)
    return re.sub(
        rb"(NEXT_ASSEMBLY_USAGE_OCCURRENCE\(')\d+'",
        lambda found: found[1] + str(next(numbers)).encode() + b"'",
        text,
    )
