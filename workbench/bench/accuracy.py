"""How exact and how sure the solver is, over random shapes, views and hands.

Terms
-----
hand
    How a drawing differs from the exact projection (`solver.synthetic.Hand`).
floor
    The Cramer-Rao floor of the shape's error (`solver.synthetic.cramer_rao`); "allowed" is the
    share that a method at the floor would have within 3 %.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from ...solver import solve
from ...solver.solution import Solution
from ...solver.synthetic import (
    FAMILIES,
    Hand,
    Photograph,
    Shape,
    Views,
    box,
    photograph,
    shape_error_floor,
    share_at_floor,
    with_traced_box,
)
from ...solver.values import Array
from .turned_study import turned_lines

Draw = Callable[[np.random.Generator], Shape]

#: Right within this part of the diameter; over FAR it is another shape, over WRONG_BASIN it may be.
RIGHT, WRONG_BASIN, FAR = 0.03, 0.12, 0.25
EXACT = 1e-8
#: A person's drawing: each direction leans by 3 to 10 degrees, lengths are off by up to 5 %, and
#: ends miss each other by 0.3 % of the drawing (2 to 3 px).
PERSON = Hand(0.003, (3.0, 10.0), 0.05)
#: Views with a camera that leans and does not aim at the object; from afar; straight on.
ROLLED = Views(roll_deg=20.0, off_centre=0.5)
AFAR = Views(fov_deg=(3.0, 8.0))
FRONTAL = Views(elevation_deg=(0.0, 2.0), azimuth_deg=(-91.0, -89.0))


def _frontal_box(rng: np.random.Generator) -> Shape:
    return box(*rng.uniform(80, 240, 3))


@dataclass(frozen=True, slots=True)
class Case:
    """One row: what is drawn how, and what is told of the camera.

    Parameters
    ----------
    name : str
    hand : Hand
    views : Views
    focal_known : bool
        As from EXIF.
    traced : str
        "", "aligned" or "turned": a real box beside the object, traced to 1.5 px.
    families : mapping of name to Draw
    """

    name: str
    hand: Hand = field(default_factory=Hand)
    views: Views = field(default_factory=Views)
    focal_known: bool = False
    traced: str = ""
    families: Mapping[str, Draw] = field(default_factory=lambda: FAMILIES)

    def photographs(self, runs: int) -> Iterator[Photograph]:
        """So many of each family; the same shapes and views for each case."""
        for k, draw in enumerate(self.families.values()):
            for run in range(runs):
                rng = np.random.default_rng([run, k])
                photo = photograph(
                    draw(rng), rng, hand=self.hand, views=self.views, focal_known=self.focal_known
                )
                if self.traced:
                    photo = with_traced_box(photo, rng, aligned=self.traced == "aligned")
                yield photo


EXACT_CASES = (
    Case("exact"),
    Case("exact, rolled 20 degrees, off centre", views=ROLLED),
    Case("exact, from afar", views=AFAR),
)
NOISY_CASES = (
    Case("0.5 % noise", Hand(0.005)),
    Case("1 % noise", Hand(0.01)),
    Case("1 % noise, EXIF", Hand(0.01), focal_known=True),
    Case("1 % noise, rolled, off centre", Hand(0.01), ROLLED),
    Case("2 % noise", Hand(0.02)),
    Case("2 % noise, EXIF", Hand(0.02), focal_known=True),
)
PERSONS = (
    Case("a person's errors", PERSON),
    Case("a person's errors, EXIF", PERSON, focal_known=True),
    Case("a person's errors, a traced box", PERSON, traced="aligned"),
    Case("a person's errors, a turned one", PERSON, traced="turned"),
)
FRONTAL_BOXES = {"box": _frontal_box}
FRONTAL_CASES = (
    Case("frontal, 0.5 % noise", Hand(0.005), FRONTAL, families=FRONTAL_BOXES),
    Case("frontal, 0.5 % noise, EXIF", Hand(0.005), FRONTAL, True, families=FRONTAL_BOXES),
)


@dataclass(frozen=True, slots=True)
class Outcomes:
    """What came of a case: errors (k,), the worst angle, degrees, and who was told as unsure."""

    photos: tuple[Photograph, ...]
    errors: Array
    worst_angle_deg: float
    unsure: Array

    def over(self, limit: float) -> float:
        """Percent with a larger error."""
        return 100 * float(np.mean(self.errors > limit))


def run(case: Case, runs: int) -> Outcomes:
    """Solve all photographs of a case."""
    photos = tuple(case.photographs(runs))
    errors, angle, unsure = [], 0.0, []
    for photo in photos:
        solution = solve(photo.graph)
        found = solution.vertices_mm
        errors.append(photo.error(found) if found else np.inf)
        angle = max(angle, _worst_angle_deg(solution))
        unsure.append(solution.message != "Solved.")
    return Outcomes(photos, np.array(errors), angle, np.array(unsure))


def _worst_angle_deg(solution: Solution) -> float:
    found = [r.value for r in solution.report.residuals.values() if r.unit == "deg"]
    return max(found, default=0.0)


def study(runs: int) -> Iterator[str]:
    """The lines of the study, each as soon as it is known.

    Parameters
    ----------
    runs : int
        Drawings of each family in each case.
    """
    yield from _heading(runs)
    for case in EXACT_CASES:
        yield _exact_line(case, run(case, runs))
    yield ""
    for case in NOISY_CASES:
        yield _noisy_line(case, run(case, runs))
    yield ""
    for case in PERSONS:
        yield _person_line(case, run(case, runs))
    yield ""
    for case in FRONTAL_CASES:
        yield _frontal_line(case, run(case, runs * len(FAMILIES)))
    yield ""
    yield from turned_lines(runs * len(FAMILIES))


def _heading(runs: int) -> Iterator[str]:
    yield f"{runs} drawings of each family in each case, all of random sizes:"
    yield f"{', '.join(FAMILIES)}."
    yield "Elevation 15 to 50, field of view 25 to 65 degrees (from afar: 3 to 8);"
    yield "nothing is told of the camera but where EXIF is said."
    yield "noise: RMS of each drawn vertex, in the sketch's diagonal. error: RMS over the diameter."
    yield "allowed: what a method at the Cramer-Rao floor would have within 3 %."
    yield "a person's errors: directions lean by 3 to 10 degrees, lengths are off by up to 5 %,"
    yield "ends miss by 0.3 %. A traced box: beside the object, 1.5 px; the turned one only shares"
    yield "the ground with it."
    yield ""


def _exact_line(case: Case, found: Outcomes) -> str:
    within = 100 - found.over(EXACT)
    return (
        f"{case.name}: {within:.1f} % of {len(found.errors)} within 1e-8, worst "
        f"{found.errors.max():.1g}; annotated angles within {found.worst_angle_deg:.1g} degrees"
    )


def _noisy_line(case: Case, found: Outcomes) -> str:
    rms, known = case.hand.vertex_rms, case.focal_known
    floors = [shape_error_floor(p, rms, focal_known=known) for p in found.photos]
    allowed = [share_at_floor(p, rms, RIGHT, focal_known=known) for p in found.photos]
    return (
        f"{case.name}: {100 - found.over(RIGHT):.1f} % within 3 % "
        f"(allowed {100 * np.mean(allowed):.1f} %), median {100 * np.median(found.errors):.2f} %, "
        f"{np.median(found.errors / floors):.2f} of the floor, "
        f"over 12 %: {found.over(WRONG_BASIN):.2f} %, over 25 %: {found.over(FAR):.2f} %"
    )


def _person_line(case: Case, found: Outcomes) -> str:
    p50, p90, p99 = (100 * float(np.quantile(found.errors, q)) for q in (0.5, 0.9, 0.99))
    untold = 100 * float(np.mean((found.errors > FAR) & ~found.unsure))
    return (
        f"{case.name}: p50 {p50:.1f} %, p90 {p90:.1f} %, p99 {p99:.1f} %, over 25 %: "
        f"{found.over(FAR):.2f} % (not told as unsure: {untold:.2f} %)"
    )


def _frontal_line(case: Case, found: Outcomes) -> str:
    return (
        f"{case.name}: {100 - found.over(RIGHT):.1f} % within 3 %, worst "
        f"{100 * found.errors.max():.1f} %, told as unsure: {100 * np.mean(found.unsure):.1f} %"
    )
