"""Triangle meshes of solids, checked to be watertight, as binary STL and 3MF."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...solver.values import Array
from .errors import FabricationError

if TYPE_CHECKING:
    import cadquery as cq

#: How the print looks in a slicer, red, green and blue.
PLASTIC = (196, 208, 222)
#: Vertices of one corner come once for each face, equal to about 1e-12 mm; they are welded.
_WELD_MM = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """Triangles that look outwards.

    Parameters
    ----------
    vertices_mm : (n, 3) array
    triangles : (m, 3) array of int
    """

    vertices_mm: Array
    triangles: NDArray[np.int32]


def mesh_of(shape: cq.Shape, deflection_mm: float = 0.02) -> Mesh:
    """The triangles of a solid.

    Parameters
    ----------
    shape : cadquery.Shape
    deflection_mm : float
        How far triangles may leave curved surfaces; planes are exact.

    Returns
    -------
    Mesh
        Welded and checked.

    Raises
    ------
    FabricationError
        Where the mesh is not watertight, or has not the solid's volume.
    """
    raw, faces = shape.tessellate(deflection_mm, 0.1)
    mesh = welded([v.toTuple() for v in raw], faces)
    check_mesh(mesh, shape.Volume(), deflection_mm * shape.Area())
    return mesh


def welded(points: Sequence[Sequence[float]], faces: Sequence[Sequence[int]]) -> Mesh:
    """The mesh of triangles that have each its own corners: equal ones are made one."""
    every = np.array(points)
    keys = np.round(every / _WELD_MM).astype(np.int64)
    _, first, number = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    triangles = number.reshape(-1)[np.array(faces, dtype=np.int64)]
    thin = [len(set(t)) < 3 for t in triangles.tolist()]
    return Mesh(every[first], triangles[~np.array(thin)].astype(np.int32))


def check_mesh(mesh: Mesh, volume_mm3: float, slack_mm3: float) -> None:
    """Refuse a mesh that is not a closed manifold of the given volume."""
    import manifold3d

    solid = manifold3d.Manifold(
        manifold3d.Mesh64(mesh.vertices_mm, mesh.triangles.astype(np.uint64))
    )
    volume = solid.volume()
    if solid.status() != manifold3d.Error.NoError or solid.is_empty():
        raise FabricationError(
            f"the surface is not closed: {solid.status().name}", (), "a thinner or thicker wall"
        )
    if abs(volume - volume_mm3) > slack_mm3 + 1e-6 * abs(volume_mm3):
        raise FabricationError(
            f"the mesh holds {volume:.6g} mm3 instead of {volume_mm3:.6g}",
            (),
            "a thinner or thicker wall",
        )


def stl_bytes(mesh: Mesh) -> bytes:
    """The mesh as binary STL, mm."""
    # Normals of the corners as they are written: rounding turns slivers.
    corners = mesh.vertices_mm.astype(np.float32).astype(float)[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = normals / np.where(lengths > 0, lengths, 1.0)
    rows = np.zeros(len(corners), dtype=[("numbers", "<f4", (12,)), ("attribute", "<u2")])
    rows["numbers"] = np.concatenate([normals[:, None], corners], axis=1).reshape(-1, 12)
    # The head must not begin with "solid": that is how text files begin.
    head = b"Modeling in Context, binary STL, mm".ljust(80)
    return head + struct.pack("<I", len(rows)) + rows.tobytes()


def threemf_bytes(mesh: Mesh, name: str = "solid") -> bytes:
    """The mesh as 3MF, by lib3mf."""
    import lib3mf

    wrapper = lib3mf.get_wrapper()
    model = wrapper.CreateModel()
    model.SetUnit(lib3mf.ModelUnit.MilliMeter)
    body = model.AddMeshObject()
    body.SetName(name)
    vertices = [_position(lib3mf, p) for p in mesh.vertices_mm.tolist()]
    triangles = [_triangle(lib3mf, t) for t in mesh.triangles.tolist()]
    body.SetGeometry(vertices, triangles)
    if not body.IsManifoldAndOriented():
        raise FabricationError("the surface is not closed", (), "a thinner or thicker wall")
    materials = model.AddBaseMaterialGroup()
    colour = wrapper.RGBAToColor(*PLASTIC, 255)
    body.SetObjectLevelProperty(materials.GetResourceID(), materials.AddMaterial(name, colour))
    item = model.AddBuildItem(body, wrapper.GetIdentityTransform())
    # Identifiers of our own: the library would invent new ones each time.
    for number, set_uuid in enumerate((model.SetBuildUUID, body.SetUUID, item.SetUUID), start=1):
        set_uuid(f"00000000-0000-4000-8000-{number:012d}")
    return bytes(model.QueryWriter("3mf").WriteToBuffer())


def _position(lib3mf: object, point: Sequence[float]) -> object:
    position = lib3mf.Position()  # type: ignore[attr-defined]
    position.Coordinates[:] = point
    return position


def _triangle(lib3mf: object, corners: Sequence[int]) -> object:
    triangle = lib3mf.Triangle()  # type: ignore[attr-defined]
    triangle.Indices[:] = corners
    return triangle
