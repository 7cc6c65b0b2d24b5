"""Vertices that lie on circles: those drawn on an end of an ellipse's axes ([Lau10] 4.1).

The paper has edges connect to ellipses at these ends only. Connected so, a vertex is a point of the
circle in space as well: as high as its centre, by construction, and as far from it as its radius.

Terms
-----
rim
    A vertex and the circle on which it lies.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .graph import SketchGraph
from .structure import Structure
from .topology import topology_of
from .values import Array, IntArray


@dataclass(frozen=True, slots=True, eq=False)
class Rims:
    """Distances to be held: with s = |v - c|^2 and q = r^2, residual (s - q) / (s + q).

    Parameters
    ----------
    apart : (t, 2, 2) int array
        Shared coordinates of the vertex and of the centre, each along the two level axes.
    radius : (t,) int array
        Index of the radius among the shared coordinates.
    """

    apart: IntArray
    radius: IntArray

    def __len__(self) -> int:
        return len(self.radius)

    def evaluate(self, g: Array) -> tuple[Array, Array]:
        """Residuals (t,) and their derivatives (t, m) by the shared coordinates."""
        places = g[self.apart]
        d, r = places[:, 0] - places[:, 1], g[self.radius]
        s, q = (d * d).sum(axis=1), r * r
        total = np.maximum(s + q, 1e-300)
        H, row = np.zeros((len(self), len(g))), np.arange(len(self))
        by_d = (4 * q / total**2)[:, None] * d
        # A vertex and a centre may share a coordinate: what one adds the other takes away.
        np.add.at(H, (row[:, None], self.apart[:, 0]), by_d)
        np.add.at(H, (row[:, None], self.apart[:, 1]), -by_d)
        np.add.at(H, (row, self.radius), -4 * s * r / total**2)
        return (s - q) / total, H


def rims_of(graph: SketchGraph, structure: Structure) -> Rims:
    """The vertices of a graph that lie on circles, by what is unknown of them."""
    topology = topology_of(graph)
    vertex, circle = topology.rims.T
    level = [k for k in range(3) if k != structure.vertical]
    centre = len(topology.vertices) + circle
    apart = structure.coordinate[np.stack([vertex, centre], axis=1)][:, :, level[:2]]
    return Rims(apart, structure.radius[circle])
