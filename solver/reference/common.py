"""What both reference methods share: the simplex search and the camera.

Lengths are in drawing units (see `drawing`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy import optimize

from ..values import Array, Progress, Stop
from .drawing import Drawing

#: Stands for the energy of what is no photograph: a vertex behind the eye, or one that is further
#: away than `FAR` drawing units.
IMPOSSIBLE = 1e12
FAR = 1e5
#: A search asks after so many evaluations whether to stop, and tells how far it is.
ASK_EVERY = 8


@dataclass(frozen=True, slots=True)
class Limits:
    """Where the searches end; [Lau10] does not say.

    Parameters
    ----------
    evaluations_per_dimension : int
        Evaluations of the function that one optimisation may take, for each of its dimensions.
    tolerance : float
        An optimisation ends when the simplex is smaller than this (drawing units) and its values
        differ by less.
    restarts : int or None
        How many vertices are re-initialised in turn; None: all of them, as in the paper.
    seed : int
        Of the random depths.
    """

    evaluations_per_dimension: int = 400
    tolerance: float = 1e-4
    restarts: int | None = None
    seed: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """Where a search ended: the unknowns, the energy, the evaluations it took."""

    x: Array
    energy: float
    evaluations: int

    def after(self, evaluations: int) -> Found:
        """The same after so many evaluations."""
        return replace(self, evaluations=evaluations)


@dataclass(frozen=True, slots=True)
class Watch:
    """Who may stop a search and is told how far it is.

    Parameters
    ----------
    stop : callable
    tell : callable
    begun, share : float
        How far the solve was when this search began, and how much of the solve it is.
    what : str
        What is being done.
    """

    stop: Stop = lambda: False
    tell: Progress = lambda done, what: None
    begun: float = 0.0
    share: float = 1.0
    what: str = "optimization"

    def part(self, begun: float, share: float, what: str) -> Watch:
        """The same people watch a part of it."""
        return replace(self, begun=begun, share=share, what=what)

    def say(self, done: float) -> None:
        """How far this search is, 0 to 1."""
        self.tell(self.begun + self.share * min(done, 1.0), self.what)


def watched_by(stop: Stop | None, tell: Progress | None) -> Watch:
    """The watch of a solve that somebody may stop, and somebody is told of."""
    watch = Watch() if stop is None else Watch(stop)
    return watch if tell is None else replace(watch, tell=tell)


class _StoppedError(Exception):
    """Somebody stopped the search; nobody sees this outside of it."""


class _Watched:
    """An energy that is watched, and the least that it was."""

    def __init__(self, energy: Callable[[Array], float], x0: Array, most: int, watch: Watch):
        self.energy, self.most, self.watch = energy, most, watch
        self.best = Found(x0, np.inf, 0)

    def __call__(self, x: Array) -> float:
        count = self.best.evaluations
        if count % ASK_EVERY == 0:
            self.watch.say(count / self.most)
            if self.watch.stop():
                raise _StoppedError
        value = self.energy(x)
        better = value < self.best.energy
        self.best = Found(x.copy(), value, count + 1) if better else self.best.after(count + 1)
        return value


def nelder_mead(
    energy: Callable[[Array], float], x0: Array, step: Array, limits: Limits, watch: Watch
) -> Found:
    """Minimise by the simplex method, begun as GSL's nmsimplex begins: x0, and x0 + step_i e_i.

    One that is stopped ends at once, with the best point that it saw.
    """
    n = len(x0)
    most = limits.evaluations_per_dimension * n
    watched = _Watched(energy, x0, most, watch)
    try:
        found = optimize.minimize(
            watched,
            x0,
            method="Nelder-Mead",
            options={
                "initial_simplex": np.vstack([x0, x0 + np.diag(step)]),
                "maxfev": most,
                "maxiter": most,
                "xatol": limits.tolerance,
                "fatol": limits.tolerance,
            },
        )
    except _StoppedError:
        return watched.best
    return Found(np.asarray(found.x, dtype=float), float(found.fun), int(found.nfev))


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """The camera of [Lau10] 4.3: position, orientation and focal length, drawing units.

    ``x_in_cam = rotation @ (x - position)``
    """

    position: Array
    rotation: Array
    focal: float

    def moved(self, change: Array) -> View:
        """The camera changed by seven numbers: position, a turn (rad), log of the focal length."""
        return View(
            self.position + change[:3],
            turn(change[3:6]) @ self.rotation,
            self.focal * float(np.exp(min(max(change[6], -20.0), 20.0))),
        )

    def project(self, X: Array) -> Array | None:
        """The image (n, 2) of vertices; None where one is not before the eye, or too far away."""
        in_cam = (X - self.position) @ self.rotation.T
        depth = in_cam[:, 2:]
        if not (depth.min() > 1e-3 and depth.max() < FAR):
            return None
        return np.asarray(self.focal * in_cam[:, :2] / depth)

    def projection_energy(self, X: Array, p: Array) -> float:
        """Square of the norm of p - p', square drawing units."""
        seen = self.project(X)
        return IMPOSSIBLE if seen is None else float(np.sum((seen - p) ** 2))


def view_along_z(focal: float) -> View:
    """The camera as far before z = 0 as its focal length: it sees the drawing where it is drawn."""
    return View(np.array([0.0, 0.0, -focal]), np.eye(3), focal)


def turn(rotation_vector: Array) -> Array:
    """The rotation about a vector by its length in rad (Rodrigues), (3, 3)."""
    x, y, z = rotation_vector
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = float(np.sqrt(x * x + y * y + z * z))
    if angle < 1e-8:
        return np.asarray(np.eye(3) + K)
    return np.asarray(
        np.eye(3) + np.sin(angle) / angle * K + (1 - np.cos(angle)) / angle**2 * (K @ K)
    )


def camera_steps(drawing: Drawing) -> Array:
    """First steps of the seven numbers of the camera."""
    distance = 0.05 * drawing.focal
    return np.array([distance, distance, distance, 0.05, 0.05, 0.05, 0.1])


@dataclass(frozen=True, slots=True, eq=False)
class Reference:
    """What a reference method found, before it is put on the ground.

    Parameters
    ----------
    X : (n, 3) array
        Vertices, drawing units, any frame.
    view : View
    evaluations : int
    """

    X: Array
    view: View
    evaluations: int
