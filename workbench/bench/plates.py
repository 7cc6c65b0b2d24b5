"""The benchmark of plates: outlines in 2D beside booleans in the kernel, and sheets.

Terms
-----
booleans
    The same joints, cut from the same walls in the B-rep kernel: a cut for each finger, as
    scripts do; or, much better, one cut for each wall with all boxes that other walls own. Then
    each plate is cleaned (cuts split its faces) and its lower face written as DXF by cadquery. Who
    owns which box is given to it, and it has neither kerf, names nor sheets: all in its favour.
"""

from __future__ import annotations

import importlib.util
import io
import math
import time
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from ...solver.model import Model, ModelFace
from ...solver.synthetic import Shape, organizer
from ..fabrication.dxf import dxf_bytes
from ..fabrication.finger_joints import share_out
from ..fabrication.frame import find_frame
from ..fabrication.packing import pack
from ..fabrication.pieces import Piece
from ..fabrication.plates import make_plates
from ..fabrication.settings import PlateSettings
from ..fabrication.sheets import lay_out
from ..fabrication.walls import Wall, find_walls

if TYPE_CHECKING:
    import cadquery as cq

#: Sheets of 600 x 400 mm, less a margin of 5 mm, more a spacing of 3 mm.
ROOM_MM = (593.0, 393.0)
LINE = "{:<44} {:>9} {:>9}"


def plates_bench(runs: int = 5, columns: int = 4) -> Iterator[str]:
    """The lines of the table, each as soon as it is known; `columns` times 2 compartments."""
    settings = PlateSettings(kerf_mm=0.1)
    model = open_organizer(columns)
    yield ""
    yield LINE.format(f"plates of a {2 * columns}-compartment organizer", "ms", "x ours")
    ours = _best_ms(lambda: dxf_bytes(lay_out(make_plates(model, settings), settings)), runs)
    yield LINE.format("outlines to DXF, no CAD kernel", f"{ours:.0f}", "1")
    if importlib.util.find_spec("cadquery") is None:
        yield "cadquery is not installed: no booleans to compare with"
    else:
        importlib.import_module("cadquery")
        for name, singly in (("one cut a plate", False), ("a cut a finger", True)):
            again = 1 if singly else min(runs, 3)
            cut = _best_ms(lambda: dxf_by_booleans(model, settings, singly=singly), again)  # noqa: B023
            yield LINE.format(f"booleans in OCCT, {name}", f"{cut:.0f}", f"{cut / ours:.0f}")
    yield ""
    yield LINE.format("50 plates on sheets of 600 x 400 mm", "sheets", "by area")
    for seed, high in enumerate((200.0, 300.0)):
        count, bound = sheets_of_fifty(seed, high)
        yield LINE.format(f"sides of 40 to {high:g} mm", count, bound)


def _best_ms(work: Callable[[], object], runs: int) -> float:
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return 1e3 * min(times)


def open_organizer(columns: int = 4) -> Model:
    """Compartments in two rows without lids, every face between two crossings its own."""
    shape: Shape = organizer(columns, 2)
    vertices = {f"v{i}": point for i, point in enumerate(shape.X)}
    faces = {}
    for n, loop in enumerate(shape.loops):
        points = shape.X[list(loop)]
        if points[:, 2].min() == 0:
            faces[f"f{n}"] = ModelFace(tuple(f"v{i}" for i in loop), points, (), (), 3.0)
    return Model(faces, vertices)


def dxf_by_booleans(model: Model, settings: PlateSettings, *, singly: bool = False) -> bytes:
    """The plates' outlines as DXF, from the kernel's booleans."""
    import cadquery as cq
    from cadquery.occ_impl.exporters.dxf import DxfDocument

    drawing = DxfDocument()
    for plate in cut_by_booleans(model, settings, singly=singly):
        face = max(plate.clean().Faces(), key=lambda face: face.Area())
        plane = cq.Plane(face.Center(), normal=face.normalAt())
        drawing.add_shape(cq.Workplane(plane).newObject(face.Wires()))
    text = io.StringIO()
    drawing.document.write(text)
    return text.getvalue().encode()


def cut_by_booleans(
    model: Model, settings: PlateSettings, *, singly: bool = False
) -> list[cq.Shape]:
    """The plates, cut in the kernel."""
    import cadquery as cq

    def box(low: tuple[float, ...], high: tuple[float, ...]) -> cq.Solid:
        size = [b - a for a, b in zip(low, high, strict=True)]
        return cq.Solid.makeBox(*size, cq.Vector(*low))

    walls = find_walls(model, find_frame(model.faces), settings.side)
    pieces = share_out(walls, settings)
    plates = []
    for number, wall in enumerate(walls):
        tools = [box(p.low_mm, p.high_mm) for p in pieces if p.owner != number and _meets(p, wall)]
        plate: cq.Shape = box(*_corners(wall))
        for some in [[tool] for tool in tools] if singly else [tools]:
            plate = plate.cut(*some)
        plates.append(plate)
    return plates


def _meets(piece: Piece, wall: Wall) -> bool:
    low, high = piece.low_mm[wall.axis], piece.high_mm[wall.axis]
    return min(high, wall.high_mm) - max(low, wall.low_mm) > 1e-6


def _corners(wall: Wall) -> tuple[tuple[float, ...], tuple[float, ...]]:
    low, high = np.zeros(3), np.zeros(3)
    u, v = wall.plane_axes
    low[u], low[v], high[u], high[v] = wall.region.bounds
    low[wall.axis], high[wall.axis] = wall.low_mm, wall.high_mm
    return tuple(low.tolist()), tuple(high.tolist())


def sheets_of_fifty(seed: int, high: float) -> tuple[int, int]:
    """How many sheets 50 random plates take, and how many their area alone would."""
    rows = np.random.default_rng(seed).uniform(40.0, high, (50, 2)).tolist()
    sizes = [(width, height) for width, height in rows]
    bound = math.ceil(sum(width * height for width, height in sizes) / (ROOM_MM[0] * ROOM_MM[1]))
    return max(place.sheet for place in pack(sizes, ROOM_MM)) + 1, bound
