"""What a benchmark run measures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from ...solver.reference import Limits
from ...solver.synthetic import Shape, bookshelf, box, l_shape, organizer, table

MakeShape = Callable[[], Shape]


def cube() -> Shape:
    """The smallest shape."""
    return box(100, 100, 100, "cube")


def organizer_of_200_vertices() -> Shape:
    """9 times 9 compartments."""
    return organizer(9, 9)


def organizer_of_500_vertices() -> Shape:
    """24 times 9 compartments."""
    return organizer(24, 9)


@dataclass(frozen=True, slots=True)
class Options:
    """What to measure.

    Parameters
    ----------
    shapes : tuple of callables
    noises : tuple of float
        RMS displacement of the drawn vertices, in parts of the sketch's diagonal.
    runs : int
        Views of each shape.
    slow_runs : int
        Views that the reference methods get, where a shape has many vertices.
    many_vertices, too_many_vertices : int
        From so many on the reference methods get `slow_runs` views, and none.
    limits : Limits
        Of the reference methods.
    limits_for_many : Limits
        The same, for shapes with many vertices.
    """

    shapes: tuple[MakeShape, ...]
    noises: tuple[float, ...] = (0.0, 0.005, 0.01)
    runs: int = 5
    slow_runs: int = 1
    many_vertices: int = 20
    too_many_vertices: int = 100
    limits: Limits = field(default_factory=Limits)
    limits_for_many: Limits = field(default_factory=Limits)

    @staticmethod
    def full() -> Options:
        """All shapes, the paper's restarts at every vertex; some minutes."""
        shapes: tuple[MakeShape, ...] = (
            cube,
            l_shape,
            bookshelf,
            organizer,
            table,
            organizer_of_200_vertices,
            organizer_of_500_vertices,
        )
        return Options(shapes, limits_for_many=Limits(evaluations_per_dimension=100))

    @staticmethod
    def quick() -> Options:
        """About a minute: fewer shapes, views and evaluations."""
        limits = Limits(evaluations_per_dimension=200)
        few = Limits(evaluations_per_dimension=40, restarts=4)
        return Options(
            (cube, l_shape, bookshelf, table), runs=2, limits=limits, limits_for_many=few
        )

    def with_runs(self, runs: int | None) -> Options:
        """The same with so many views, if told."""
        return self if runs is None else replace(self, runs=runs)

    def limits_of(self, shape: Shape) -> Limits:
        """The reference methods' limits for a shape."""
        return self.limits if len(shape.X) < self.many_vertices else self.limits_for_many
