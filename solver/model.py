"""The model: lifted faces with thickness, what fabrication starts from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from .errors import SketchError
from .graph import Face, Revolution
from .solution import Solution, Status
from .values import Array, frozen_array, frozen_mapping


@dataclass(frozen=True, slots=True, eq=False)
class ModelFace:
    """One planar face in the world.

    Parameters
    ----------
    loop : tuple of vertex ids
    loop_mm : (n, 3) array
        World positions of the loop.
    holes : tuple of loops
    holes_mm : tuple of (k, 3) arrays
    thickness_mm : float
    included : bool
        False for faces left out: an open side, nothing is made of it.
    """

    loop: tuple[str, ...]
    loop_mm: Array
    holes: tuple[tuple[str, ...], ...]
    holes_mm: tuple[Array, ...]
    thickness_mm: float
    included: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class Turned:
    """A surface of revolution about a vertical axis ([Lau10] 3.1).

    Parameters
    ----------
    axis_mm : (2,) array
        x and y of the axis.
    profile_rz_mm : (n, 2) array
        Radius and height of each profile vertex, from the bottom to the top circle.
    """

    axis_mm: Array
    profile_rz_mm: Array


@dataclass(frozen=True, slots=True, eq=False)
class Model:
    """The lifted faces by id, with the edges they share.

    Parameters
    ----------
    faces : mapping of face id to ModelFace
        Faces left out are there too, with ``included`` false.
    vertices_mm : mapping of vertex id to (3,) array
    edges : mapping of edge id to (vertex id, vertex id)
    turned : mapping of revolution id to Turned
    """

    faces: Mapping[str, ModelFace]
    vertices_mm: Mapping[str, Array]
    edges: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    turned: Mapping[str, Turned] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("faces", "vertices_mm", "edges", "turned"):
            object.__setattr__(self, name, frozen_mapping(getattr(self, name)))


def build_model(
    solution: Solution,
    thickness_mm: float = 3.0,
    revolutions: Mapping[str, Revolution] | None = None,
) -> Model:
    """The model of a solution.

    Parameters
    ----------
    solution : Solution
    thickness_mm : float
        For the faces that name no thickness of their own.
    revolutions : mapping of id to Revolution, optional
        The sketch graph's surfaces of revolution.

    Returns
    -------
    Model

    Raises
    ------
    SketchError
        Where there is no face to make anything of, or the solve ended badly.
    """
    if solution.status is not Status.CONVERGED:
        raise SketchError(f"the sketch is not solved: {solution.message}", (), "")
    for id_, r in (revolutions or {}).items():
        _check_belongs(id_, r, solution)
    faces = {id_: _model_face(face, solution, thickness_mm) for id_, face in solution.faces.items()}
    turned = {id_: turned_profile(r, solution) for id_, r in (revolutions or {}).items()}
    if not turned and not any(face.included for face in faces.values()):
        raise SketchError(
            "no face to make anything of",
            (),
            "close a loop of edges that lies in one plane, or include a face",
        )
    return Model(faces, solution.vertices_mm, solution.edges, turned)


def _check_belongs(id_: str, revolution: Revolution, solution: Solution) -> None:
    """A solution read from a file may be that of another sketch."""
    missing = [c for c in (revolution.bottom, revolution.top) if c not in solution.circles]
    missing += [v for v in revolution.profile if v not in solution.vertices_mm]
    if missing:
        raise SketchError(f"revolution {id_} is not solved", missing[:5], "solve the sketch again")


def turned_profile(revolution: Revolution, solution: Solution) -> Turned:
    """The surface of a solved revolution: its profile's ends lie on the bottom and top circle."""
    bottom, top = (solution.circles[c] for c in (revolution.bottom, revolution.top))
    axis = bottom.center_mm[:2]
    between = np.array([solution.vertices_mm[v] for v in revolution.profile[1:-1]]).reshape(-1, 3)
    radii = np.linalg.norm(between[:, :2] - axis, axis=1)
    rows = [
        (bottom.radius_mm, bottom.center_mm[2]),
        *zip(radii, between[:, 2], strict=True),
        (top.radius_mm, top.center_mm[2]),
    ]
    return Turned(frozen_array(axis), frozen_array(rows, (-1, 2)))


def _model_face(face: Face, solution: Solution, thickness_mm: float) -> ModelFace:
    def positions(loop: tuple[str, ...]) -> Array:
        return frozen_array(np.array([solution.vertices_mm[v] for v in loop]), (-1, 3))

    return ModelFace(
        face.loop,
        positions(face.loop),
        face.holes,
        tuple(positions(hole) for hole in face.holes),
        thickness_mm if face.thickness_mm is None else face.thickness_mm,
        face.included,
    )
