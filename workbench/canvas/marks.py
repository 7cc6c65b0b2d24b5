"""Which marks stand where, read off a graph's annotations: pure, no Qt and no screen.

Terms
-----
mark
    A number of equal symbols on an edge; edges with equally many belong together.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph


@dataclass(frozen=True, slots=True)
class Marks:
    """What to draw besides the edges themselves.

    Parameters
    ----------
    right_angles : mapping of annotation to (vertex, vertex, vertex)
        The corner and the other ends of its two edges.
    equal_lengths, parallels : mapping of edge to count
    lengths, diameters, thicknesses : mapping of edge, circle or face to text
    ground, on_face : frozenset of vertices
    symmetry_planes : tuple of tuples of edges
        The edges that each plane halves.
    """

    right_angles: dict[str, tuple[str, str, str]] = field(default_factory=dict)
    equal_lengths: dict[str, int] = field(default_factory=dict)
    parallels: dict[str, int] = field(default_factory=dict)
    lengths: dict[str, str] = field(default_factory=dict)
    diameters: dict[str, str] = field(default_factory=dict)
    thicknesses: dict[str, str] = field(default_factory=dict)
    ground: frozenset[str] = frozenset()
    on_face: frozenset[str] = frozenset()
    symmetry_planes: tuple[tuple[str, ...], ...] = ()


def marks_of(graph: SketchGraph) -> Marks:
    """The marks of a graph's annotations."""
    ground = [v for a in graph.annotations_of("ground").values() for v in a.vertices]
    return Marks(
        right_angles=_right_angles(graph),
        equal_lengths=_numbered(graph, "equal_length"),
        parallels=_numbered(graph, "parallel"),
        lengths={a.edge: length_text(a.length_mm) for a in graph.annotations_of("length").values()},
        diameters={
            a.circle: f"\N{DIAMETER SIGN} {length_text(a.diameter_mm)}"
            for a in graph.annotations_of("diameter").values()
        },
        thicknesses={
            id_: f"t {length_text(face.thickness_mm)}"
            for id_, face in (graph.faces or {}).items()
            if face.thickness_mm is not None
        },
        ground=frozenset(ground),
        on_face=frozenset(a.vertex for a in graph.annotations_of("on_face").values()),
        symmetry_planes=tuple(
            a.midpoints_of for a in graph.annotations_of("symmetry_plane").values()
        ),
    )


def _right_angles(graph: SketchGraph) -> dict[str, tuple[str, str, str]]:
    found = {}
    for id_, annotation in graph.annotations_of("right_angle").items():
        ends = [graph.edges[edge] for edge in annotation.between]
        others = [w if v == annotation.at else v for v, w in ends]
        if all(annotation.at in pair for pair in ends):
            found[id_] = (annotation.at, *others)
    return found


def _numbered(graph: SketchGraph, kind: str) -> dict[str, int]:
    """How many symbols each edge gets: one for the first annotation of a kind, two for the next."""
    numbers: dict[str, int] = {}
    for number, annotation in enumerate(graph.annotations_of(kind).values(), start=1):
        numbers |= dict.fromkeys(annotation.edges, number)
    return numbers


def length_text(length_mm: float) -> str:
    """A length as people write it."""
    return f"{length_mm:.4g} mm" if length_mm < 1000 else f"{length_mm:.0f} mm"
