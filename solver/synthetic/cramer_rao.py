"""The least error that any unbiased method can have: the Cramer-Rao floor of a photograph.

The unknowns are the shared coordinates g that the annotations leave, the camera's rotation and the
log of its focal length; the eye is the origin, so that the size is the one gauge. J is the
derivative of the projected vertices by them at the truth, N a basis of the directions that keep
what else is annotated (the null space of H), sigma the noise of each drawn coordinate. Then

    cov(g) = sigma^2 S N (N^T J^T J N)^+ N^T S^T,     S: the rows of g; the camera is nuisance

and the shape's error, the RMS over its n vertices after the best similarity, has the floor

    sqrt(tr(P cov(X) P) / n),      P: what no small similarity does.
"""

from __future__ import annotations

import numpy as np

from ..balances import balances_of
from ..geometry import cross
from ..problem import build_problem
from ..structure import build_structure
from ..values import Array, IntArray
from .photographs import Photograph, photograph_exactly

#: Singular values below this part of the largest are zero.
RANK_TOLERANCE = 1e-9
#: Drawings by which a share is estimated.
N_DRAWN = 400


def shape_error_floor(photo: Photograph, vertex_rms: float, *, focal_known: bool = False) -> float:
    """Floor of the shape's error, in parts of its diameter.

    Parameters
    ----------
    photo : Photograph
        Of a shape some of whose edges run along object axes.
    vertex_rms : float
        RMS displacement of each vertex, in parts of the sketch's diagonal.
    focal_known : bool
    """
    return float(np.linalg.norm(_moves(photo, vertex_rms, focal_known)))


def share_at_floor(
    photo: Photograph, vertex_rms: float, limit: float, *, focal_known: bool = False
) -> float:
    """The share of drawings that a method at the floor solves with a smaller error than a limit."""
    moves = _moves(photo, vertex_rms, focal_known)
    drawn = np.random.default_rng(0).normal(size=(moves.shape[1], N_DRAWN))
    return float(np.mean(np.linalg.norm(moves @ drawn, axis=0) < limit))


def _moves(photo: Photograph, vertex_rms: float, focal_known: bool) -> Array:
    """(3n, k): times independent normal numbers, displacements of an efficient method's vertices.

    In units in which their length is the shape's error.
    """
    graph = photograph_exactly(photo.shape, photo.camera)
    problem = build_problem(graph, build_structure(graph))
    coordinate, m = problem.structure.coordinate, problem.structure.n_coordinates
    axes = _object_axes(photo.shape.X, problem.ends, problem.structure.edge_axis)
    R = photo.camera.rotation_cam_from_world @ axes
    c = (photo.shape.X - photo.camera.position_mm) @ axes
    dX = np.zeros((len(c), 3, m))
    for k in range(3):
        dX[np.arange(len(c)), k, coordinate[:, k]] = 1.0
    focal = photo.camera.focal_px / problem.px_per_unit
    J = _projection_jacobian(c @ R.T, focal, np.einsum("ij,njm->nim", R, dX))
    if focal_known:
        J[:, 3] = 0.0
    balanced = balances_of(problem.structure).rows
    H = np.hstack([np.zeros((len(balanced), 4)), balanced])
    for block in problem.blocks:
        at = block.evaluate(c)
        rows = np.zeros((len(at.residual), 4 + m))
        np.add.at(rows, at.row, np.einsum("ti,tim->tm", at.value, _padded(dX)[at.vertex]))
        H = np.vstack([H, rows])
    N = _null_space(H)
    drawn = np.array(list(graph.vertices.values()))
    diagonal = float(np.linalg.norm(np.ptp(drawn, axis=0)))
    sigma = vertex_rms * diagonal / np.sqrt(2) / problem.px_per_unit
    root = N @ np.linalg.pinv(J @ N, rcond=RANK_TOLERANCE)  # cov = sigma^2 root root^T
    moved = (_padded(dX).reshape(-1, 4 + m) @ root) * sigma
    Q = _similarities(c)
    moved -= Q @ (Q.T @ moved)
    diameter = float(np.linalg.norm(c[:, None] - c[None], axis=2).max())
    return np.asarray(moved / np.sqrt(len(c)) / diameter)


def _padded(dX: Array) -> Array:
    """Derivatives of the positions by all unknowns: none by the camera's four."""
    return np.concatenate([np.zeros((*dX.shape[:2], 4)), dX], axis=2)


def _object_axes(X: Array, ends: IntArray, edge_axis: IntArray) -> Array:
    """True directions of the object axes, as columns; right-handed."""
    axes = np.zeros((3, 3))
    known = [k for k in range(3) if bool((edge_axis == k).any())]
    for k in known:
        a, b = ends[int(np.argmax(edge_axis == k))]
        axes[:, k] = (X[b] - X[a]) / np.linalg.norm(X[b] - X[a])
    if len(known) == 2:
        (k,) = {0, 1, 2} - set(known)
        axes[:, k] = cross(axes[:, (k + 1) % 3], axes[:, (k + 2) % 3])
    elif len(known) < 2:
        raise ValueError("no two edges of this shape are known to be square")
    if np.linalg.det(axes) < 0:
        axes[:, known[-1]] *= -1
    return axes


def _projection_jacobian(in_cam: Array, focal: float, by_g: Array) -> Array:
    """(2n, 4 + m) derivatives by a turn about the eye, the log focal length and g."""
    n = len(in_cam)
    depth = in_cam[:, 2]
    D = np.zeros((n, 2, 3))
    D[:, 0, 0] = D[:, 1, 1] = focal / depth
    D[:, :, 2] = -focal * in_cam[:, :2] / depth[:, None] ** 2
    by_turn = cross(in_cam[:, None, :], D)
    by_focal = (focal * in_cam[:, :2] / depth[:, None])[..., None]
    J = np.concatenate([by_turn, by_focal, np.einsum("nuc,ncm->num", D, by_g)], axis=2)
    return np.asarray(J.reshape(2 * n, -1))


def _null_space(H: Array) -> Array:
    """Orthonormal columns."""
    if not len(H):
        return np.eye(H.shape[1])
    _, s, Vt = np.linalg.svd(H)
    rank = int(np.count_nonzero(s > RANK_TOLERANCE * max(float(s[0]), 1e-300)))
    return np.asarray(Vt[rank:].T)


def _similarities(c: Array) -> Array:
    """Orthonormal basis (3n, 7) of small moves, turns and growth about the middle."""
    offset = c - c.mean(axis=0)
    columns = [np.tile(e, (len(c), 1)) for e in np.eye(3)]
    columns += [cross(np.tile(e, (len(c), 1)), offset) for e in np.eye(3)]
    columns.append(offset)
    return np.asarray(np.linalg.qr(np.array([x.reshape(-1) for x in columns]).T)[0])
