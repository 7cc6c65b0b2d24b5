"""Exact booleans on plates, by manifold3d."""

from itertools import combinations

import manifold3d as m3
import numpy as np

from incontext.solver.model import Model
from incontext.workbench.fabrication.enclosed import enclosed
from incontext.workbench.fabrication.plates import Plate
from incontext.workbench.fabrication.prisms import prism
from incontext.workbench.fabrication.sides import face_sides


def body(plate: Plate, frame_from_world: np.ndarray | None = None) -> m3.Manifold:
    """A plate in its place in the world (or in another frame)."""
    place = (
        plate.world_from_plate
        if frame_from_world is None
        else frame_from_world @ (plate.world_from_plate)
    )
    solid = prism(plate.polygon, 0.0, plate.thickness_mm)
    if frame_from_world is None:
        return solid.transform(place[:3])
    # In the object's own frame faces shall lie in one plane to the last bit.
    return solid.warp_batch(lambda points: np.round(points @ place[:3, :3].T + place[:3, 3], 10))


def overlaps(
    plates: tuple[Plate, ...], frame_from_world: np.ndarray | None = None
) -> dict[tuple[str, str], float]:
    """Volume that each two plates share, mm3.

    manifold3d is exact where faces lie in one plane to the last bit, which they do in the
    object's own frame; in a turned one it may report touching faces as a sliver.
    """
    bodies = {plate.id: body(plate, frame_from_world) for plate in plates}
    return {(a, b): (bodies[a] ^ bodies[b]).volume() for a, b in combinations(bodies, 2)}


def union(plates: tuple[Plate, ...], frame_from_world: np.ndarray | None = None) -> m3.Manifold:
    bodies = [body(plate, frame_from_world) for plate in plates]
    return m3.Manifold.batch_boolean(bodies, m3.OpType.Add)


def drawn_body(model: Model) -> m3.Manifold | None:
    """What the faces enclose, where each edge has two of them."""
    faces = model.faces
    loops = {id_: (face.loop, *face.holes) for id_, face in faces.items()}
    placed = {id_: (face.loop_mm, *face.holes_mm) for id_, face in faces.items()}
    return enclosed(loops, model.vertices_mm, face_sides(placed, list(placed)))
