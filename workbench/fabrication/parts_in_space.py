"""The new object's parts as bodies in the world, and its directions in a person's words.

Terms
-----
part
    A plate, or a whole print.
way
    One of `left`, `right`, `front`, `back` and `up`, as seen in the photo: `front` is towards the
    viewer. The horizontal ones keep to the object's own axes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import manifold3d
import numpy as np

from ...solver.camera import Camera
from ...solver.model import Model
from ...solver.values import Array
from .booleans import united
from .errors import FabricationError
from .frame import find_frame
from .meshes import Mesh
from .plates import Plate
from .prisms import prism

UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A plate or a whole print, in its place.

    Parameters
    ----------
    id : str
        The plate's; ``solid`` for a print.
    body : Manifold
        In the world, mm.
    plate : Plate or None
        None for a print.
    """

    id: str
    body: manifold3d.Manifold
    plate: Plate | None = None


def plate_parts(plates: Iterable[Plate]) -> tuple[Part, ...]:
    """Each plate in its place."""
    return tuple(Part(plate.id, _body(plate), plate) for plate in plates)


def _body(plate: Plate) -> manifold3d.Manifold:
    body = prism(plate.polygon, 0.0, plate.thickness_mm)
    return body.transform(plate.world_from_plate[:3])


def print_part(mesh: Mesh) -> Part:
    """A print where it was drawn."""
    surface = manifold3d.Mesh64(mesh.vertices_mm, mesh.triangles.astype(np.uint64))
    return Part("solid", manifold3d.Manifold(surface))


def whole(parts: Iterable[Part]) -> manifold3d.Manifold:
    """All parts as one body."""
    return united(part.body for part in parts)


def ways_of(model: Model, camera: Camera | None) -> dict[str, Array]:
    """The five ways by name, as unit vectors in the world.

    Parameters
    ----------
    model : Model
        Whose axes count; the world's where its faces have none.
    camera : Camera or None
        Without one, x points right and y to the back.
    """
    along = _level_axis(model)
    across = np.cross(UP, along)
    right = np.array([1.0, 0.0, 0.0]) if camera is None else camera.rotation_cam_from_world[0]
    chosen = max((along, across, -along, -across), key=lambda way: float(way @ right))
    back = np.cross(UP, chosen)
    return {"left": -chosen, "right": chosen, "front": -back, "back": back, "up": UP}


def _level_axis(model: Model) -> Array:
    """A horizontal axis of the object."""
    faces = {id_: face for id_, face in model.faces.items() if face.included}
    try:
        axes = find_frame(faces).frame_from_world if faces else np.eye(3)
    except FabricationError:
        edges = [model.vertices_mm[w] - model.vertices_mm[v] for v, w in model.edges.values()]
        axes = np.array(sorted(edges, key=lambda e: -float(np.hypot(*e[:2]))) or np.eye(3))
    level = axes[:1] * (1.0, 1.0, 0.0)
    size = float(np.linalg.norm(level))
    return np.asarray(level[0] / size) if size > 0 else np.array([1.0, 0.0, 0.0])


def centroid(bodies: Iterable[manifold3d.Manifold]) -> tuple[Array, float]:
    """Centre of mass and volume of bodies of one density (sums of tetrahedra)."""
    moment, volume = np.zeros(3), 0.0
    for body in bodies:
        mesh = body.to_mesh64()
        a, b, c = (mesh.vert_properties[:, :3][mesh.tri_verts[:, k]] for k in range(3))
        sizes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
        moment += sizes @ (a + b + c) / 4
        volume += float(sizes.sum())
    return moment / volume, volume


def corners(bodies: Iterable[manifold3d.Manifold]) -> Array:
    """All corners of bodies, (n, 3)."""
    meshes = [body.to_mesh64().vert_properties[:, :3] for body in bodies]
    return np.vstack([np.zeros((0, 3)), *meshes])


def in_words(room: Mapping[str, float | None]) -> str:
    """Room by way, as words."""
    said = [f"{size:.1f} mm {way}" for way, size in room.items() if size is not None]
    free = [way for way, size in room.items() if size is None]
    return ", ".join([*said, *([f"free {' and '.join(free)}"] if free else [])])
