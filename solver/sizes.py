"""Given diameters in proportion to one reference: the first length, else the first diameter.

One picture never tells the size, so what is given enters as ratios, as in `energies.length_ratio`:
with p and q the two measures, each in its wanted size, r = (p - q) / (p + q).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .annotations import Length
from .graph import SketchGraph
from .structure import Structure
from .topology import topology_of
from .values import Array, IntArray


@dataclass(frozen=True, slots=True, eq=False)
class Diameters:
    """Diameters to be held in proportion to a reference.

    Parameters
    ----------
    radius : (d,) int array
        Index of each radius among the shared coordinates.
    wanted : (d,) array
        Diameters, mm.
    owners : tuple of str
        The annotation of each.
    reference_owner : tuple of str
        The annotation of the reference, where there is one.
    reference_edge : (2,) int array or None
        Vertices of the edge that the reference length measures; None where the reference is the
        diameter of the radius `reference_radius`.
    reference_radius : int
    reference_wanted : float
    """

    radius: IntArray
    wanted: Array
    owners: tuple[str, ...]
    reference_owner: tuple[str, ...]
    reference_edge: IntArray | None
    reference_radius: int
    reference_wanted: float

    def __len__(self) -> int:
        return len(self.radius)

    def evaluate(self, g: Array, coordinate: IntArray) -> tuple[Array, Array]:
        """Residuals (d,) and their derivatives (d, m) by the shared coordinates."""
        q, dq = self._reference(g, coordinate)
        p = 2 * g[self.radius] / self.wanted
        total = np.maximum(np.abs(p + q), 1e-300)
        H = (-2 * p / total**2)[:, None] * dq[None]
        H[np.arange(len(self)), self.radius] += 2 * q / total**2 * 2 / self.wanted
        return (p - q) / total, H

    def _reference(self, g: Array, coordinate: IntArray) -> tuple[float, Array]:
        dq = np.zeros(len(g))
        if self.reference_edge is None:
            dq[self.reference_radius] = 2 / self.reference_wanted
            return 2 * float(g[self.reference_radius]) / self.reference_wanted, dq
        a, b = self.reference_edge
        u = g[coordinate[b]] - g[coordinate[a]]
        length = float(np.linalg.norm(u))
        gradient = u / max(length, 1e-300) / self.reference_wanted
        for k in range(3):
            dq[coordinate[b, k]] += gradient[k]
            dq[coordinate[a, k]] -= gradient[k]
        return length / self.reference_wanted, dq


def proportional_diameters(graph: SketchGraph, structure: Structure) -> Diameters:
    """The diameters of a graph that are to be held in proportion."""
    radius = dict(zip(graph.circles, structure.radius.tolist(), strict=True))
    topology = topology_of(graph)
    given, lengths = topology.by_kind["diameter"], topology.by_kind["length"]
    reference_owner = tuple(id_ for id_, _ in (lengths or given)[:1])
    edge, first, wanted = None, 0, 1.0
    if lengths:
        first_length: Length = lengths[0][1]
        edge = topology.ends[topology.edges[first_length.edge]]
        wanted = first_length.length_mm
    elif given:
        first, wanted = radius[given[0][1].circle], given[0][1].diameter_mm
        given = given[1:]
    return Diameters(
        np.array([radius[a.circle] for _, a in given], dtype=np.int64),
        np.array([a.diameter_mm for _, a in given], dtype=float),
        tuple(id_ for id_, _ in given),
        reference_owner,
        edge,
        first,
        wanted,
    )
