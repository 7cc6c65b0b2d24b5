"""One false annotation planted into a photograph, and the truth that shows it false.

Terms
-----
planted
    An annotation that does not hold on the true shape, by so much that a person would see it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import combinations

import numpy as np

from ..annotations import (
    Annotation,
    Diameter,
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
from ..graph import Face, SketchGraph
from .photographs import Photograph
from .shapes import Shape, v
from .turned import Turned

#: The id of the planted annotation.
PLANTED = "planted"
#: A planted angle is off by at least this, deg; a planted length by this part of it; a vertex said
#: to lie in a plane by this part of the shape's size.
OFF_DEG, OFF_LENGTH, OFF_PLANE = 12.0, 0.2, 0.08


def planted(photo: Photograph, rng: np.random.Generator, kind: str) -> SketchGraph | None:
    """The sketch with a false annotation of a kind, or None where the shape offers no such.

    Parameters
    ----------
    photo : Photograph
    rng : numpy Generator
    kind : str
        A key of `KINDS`.
    """
    graph = photo.graph
    if kind == OnFace.kind and graph.faces is None:
        loops = enumerate(photo.shape.loops)
        graph = replace(graph, faces={f"f{k}": Face(tuple(map(v, loop))) for k, loop in loops})
    offered = list(KINDS[kind](photo.shape, graph, rng))
    if not offered:
        return None
    false = offered[int(rng.integers(len(offered)))]
    if isinstance(false, Length):
        # Of two lengths that disagree either may be wrong: a third one decides.
        true = [a for a in _true_lengths(photo.shape) if a.edge != false.edge]
        graph = _saying(graph, "true_length", true[int(rng.integers(len(true)))])
    return _somewhere_among(graph, false, rng)


def planted_diameter(graph: SketchGraph, turned: Turned, rng: np.random.Generator) -> SketchGraph:
    """A surface of revolution with a false diameter, one that is true and that which was given."""
    k = int(rng.choice([1, 2]))
    factor = np.exp(rng.choice([-1, 1]) * rng.uniform(OFF_LENGTH, 0.7))
    graph = _saying(graph, "true_diameter", Diameter(f"c{3 - k}", 2 * turned.circles[3 - k][0]))
    return _somewhere_among(graph, Diameter(f"c{k}", 2 * turned.circles[k][0] * factor), rng)


def _saying(graph: SketchGraph, id_: str, annotation: Annotation) -> SketchGraph:
    return replace(graph, annotations={**graph.annotations, id_: annotation})


def _somewhere_among(
    graph: SketchGraph, false: Annotation, rng: np.random.Generator
) -> SketchGraph:
    """Not always the last one said."""
    said = list(graph.annotations.items())
    said.insert(int(rng.integers(len(said) + 1)), (PLANTED, false))
    return replace(graph, annotations=dict(said))


def _vectors(shape: Shape) -> np.ndarray:
    ends = np.array(shape.edges)
    return np.asarray(shape.X[ends[:, 1]] - shape.X[ends[:, 0]])


def _angle_deg(a: np.ndarray, b: np.ndarray) -> float:
    """Between two lines, 0 to 90 degrees."""
    cosine = abs(float(a @ b)) / float(np.linalg.norm(a) * np.linalg.norm(b))
    return float(np.degrees(np.arccos(min(1.0, cosine))))


def _right_angles(
    shape: Shape, graph: SketchGraph, rng: np.random.Generator
) -> Iterator[Annotation]:
    u = _vectors(shape)
    for (i, a), (j, b) in combinations(enumerate(shape.edges), 2):
        shared = set(a) & set(b)
        if shared and _angle_deg(u[i], u[j]) < 90.0 - OFF_DEG:
            yield RightAngle(v(shared.pop()), (f"e{i}", f"e{j}"))


def _parallels(shape: Shape, graph: SketchGraph, rng: np.random.Generator) -> Iterator[Annotation]:
    u = _vectors(shape)
    for i, j in combinations(range(len(u)), 2):
        if _angle_deg(u[i], u[j]) > OFF_DEG:
            yield Parallel((f"e{i}", f"e{j}"))


def _equal_lengths(
    shape: Shape, graph: SketchGraph, rng: np.random.Generator
) -> Iterator[Annotation]:
    lengths = np.linalg.norm(_vectors(shape), axis=1)
    for i, j in combinations(range(len(lengths)), 2):
        if abs(np.log(lengths[i] / lengths[j])) > OFF_LENGTH:
            yield EqualLength((f"e{i}", f"e{j}"))


def _ground(shape: Shape, graph: SketchGraph, rng: np.random.Generator) -> Iterator[Annotation]:
    size = float(np.ptp(shape.X, axis=0).max())
    for i in np.flatnonzero(shape.X[:, 2] > OFF_PLANE * size).tolist():
        yield Ground((v(i),))


def _true_lengths(shape: Shape) -> list[Length]:
    """Of edges that do not run along the one whose length is given already."""
    u = _vectors(shape)
    given = [a.edge for a in shape.annotations.values() if isinstance(a, Length)]
    lengths = np.linalg.norm(u, axis=1)
    return [
        Length(f"e{k}", float(lengths[k]))
        for k in range(len(u))
        if all(_angle_deg(u[k], u[int(e[1:])]) > OFF_DEG for e in given)
    ]


def _lengths(shape: Shape, graph: SketchGraph, rng: np.random.Generator) -> Iterator[Annotation]:
    said = {a.edge for a in graph.annotations.values() if isinstance(a, Length)}
    for k, length in enumerate(np.linalg.norm(_vectors(shape), axis=1)):
        if f"e{k}" not in said:
            factor = np.exp(rng.choice([-1, 1]) * rng.uniform(OFF_LENGTH, 0.7))
            yield Length(f"e{k}", float(length * factor))


def _symmetry(shape: Shape, graph: SketchGraph, rng: np.random.Generator) -> Iterator[Annotation]:
    """Two edges that do cross one plane in their midpoints, and one that does not."""
    u, middles = _vectors(shape), np.mean(shape.X[np.array(shape.edges)], axis=1)
    size = float(np.ptp(shape.X, axis=0).max())

    def crosses(i: int, j: int) -> tuple[bool, bool]:
        turned = _angle_deg(u[i], u[j])
        off = abs(float((middles[j] - middles[i]) @ u[i])) / float(np.linalg.norm(u[i])) / size
        return turned < 1e-6 and off < 1e-9, turned > OFF_DEG or off > OFF_PLANE

    for i, j in combinations(range(len(u)), 2):
        if crosses(i, j)[0]:
            third = int(rng.integers(len(u)))
            if third not in (i, j) and crosses(i, third)[1]:
                yield SymmetryPlane((f"e{i}", f"e{j}", f"e{third}"))


def _on_face(shape: Shape, graph: SketchGraph, rng: np.random.Generator) -> Iterator[Annotation]:
    size = float(np.ptp(shape.X, axis=0).max())
    for id_, loop in zip(graph.faces or {}, shape.loops, strict=True):
        corners = shape.X[list(loop)]
        normal = np.linalg.svd(corners - corners.mean(axis=0))[2][2]
        off = np.abs((shape.X - corners.mean(axis=0)) @ normal)
        for i in np.flatnonzero(off > OFF_PLANE * size).tolist():
            yield OnFace(v(i), id_)


#: What can be planted, by kind.
KINDS: dict[str, Callable[[Shape, SketchGraph, np.random.Generator], Iterator[Annotation]]] = {
    RightAngle.kind: _right_angles,
    Parallel.kind: _parallels,
    EqualLength.kind: _equal_lengths,
    Ground.kind: _ground,
    Length.kind: _lengths,
    SymmetryPlane.kind: _symmetry,
    OnFace.kind: _on_face,
}
