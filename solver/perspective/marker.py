"""The camera from a rectangle of known size that lies on the ground ([Lau10] 4.3, first method).

Terms
-----
rectangle
    A printed marker, a sheet of paper, a bank card, a tile: four corners and two sides.
corners
    In any order, as clicked; they come back counterclockwise as seen from above, the first being
    at the world's (-x, -y).

The world's origin is the rectangle's middle, z is up, and x runs along the side that points most to
the right in the photo. Which of its sides is the longer one is found out, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..camera import Camera
from ..errors import SketchError
from ..full import EXIF_LOG_SIGMA
from ..graph import Photo, Point
from ..problem import TRACED_SIGMA_PX
from ..values import Array
from .plane_pose import Known, homography
from .rectangle_reading import CLEARLY, RectangleReading, on_ground

#: Sizes that people have at hand, mm.
RECTANGLES: dict[str, tuple[float, float]] = {
    "A4": (297.0, 210.0),
    "A5": (210.0, 148.0),
    "letter": (279.4, 215.9),
    "card": (85.60, 53.98),
}
#: Sizes are wished at least so exact; what is this unsure is not known at all.
WISHED_SIZE_SIGMA, HARDLY = 0.02, 0.5
#: Corners nearer than this to each other, or sides meeting flatter than this, make no rectangle.
LEAST_SIDE_PX, LEAST_SINE = 4.0, 0.05
#: Corners that fit no better than this are not of this rectangle, px.
LOST_PX = 4.0
#: A misfit of more standard errors than this is no chance: the errors were larger than was thought.
#: From this on, px, it is told.
BELIEVED, NOTABLE_PX = 3.0, 0.4


@dataclass(frozen=True, slots=True, eq=False)
class RectangleView:
    """A camera found from a rectangle, and how well.

    Parameters
    ----------
    camera : Camera
    size_mm : (float, float)
        The rectangle's sides along the world's x and y.
    corners_px : (4, 2) array
        As seen, in the order of `corners_mm`.
    misfit_px : float
        RMS distance between seen and projected corners.
    focal_sigma, size_sigma : float
        Standard errors, in parts: of the focal length; and of the height of an upright edge in
        the rectangle's middle that is as tall as its longer side.
    focal_from : str
        ``corners``, ``photo`` (EXIF) or ``usual``: what mainly tells the focal length.
    sides_unsure : bool
        Whether the longer side may as well be the other one.
    twin : Camera or None
        The other pose, where it explains the corners almost as well.
    is_off : bool
        Whether the corners are further off any such rectangle than their own errors explain.
    """

    camera: Camera
    size_mm: tuple[float, float]
    corners_px: Array
    misfit_px: float
    focal_sigma: float
    size_sigma: float
    focal_from: str
    sides_unsure: bool = False
    twin: Camera | None = None
    is_off: bool = False

    @property
    def corners_mm(self) -> Array:
        """The corners in the world, counterclockwise as seen from above, (4, 3)."""
        return np.column_stack([on_ground(self.size_mm), np.zeros(4)])

    @property
    def notes(self) -> tuple[str, ...]:
        """What a person should know of it, a sentence each."""
        found = []
        if self.is_off:
            found.append(
                f"The corners are {self.misfit_px:.1f} px off any rectangle of this size: check "
                "the size, that it lies flat, and that the photo was not cropped."
            )
        if self.focal_from == "usual":
            found.append(
                "The rectangle is seen too square-on to tell the focal length, which is good to "
                f"{100 * self.focal_sigma:.0f} % only: take the photo from lower down, or keep its "
                "EXIF data."
            )
        if self.size_sigma > HARDLY:
            found.append(
                "Seen from straight above, heights are hardly to be told: take the photo from "
                "lower down."
            )
        elif self.size_sigma > WISHED_SIZE_SIGMA:
            found.append(
                f"Heights are good to {100 * self.size_sigma:.1f} % only: have the rectangle "
                "larger in the photo."
            )
        if self.twin is not None:
            found.append(
                "The corners do not tell which way the ground leans: have the rectangle larger in "
                "the photo, and check the grid on the ground."
            )
        if self.sides_unsure:
            found.append(
                "The corners do not tell which side is the longer one: check the grid on the "
                "ground, or keep the photo's EXIF data."
            )
        return tuple(found)


def camera_from_rectangle(
    photo: Photo,
    corners_px: Sequence[Point] | Array,
    size_mm: tuple[float, float],
    *,
    corner_sigma_px: float = TRACED_SIGMA_PX,
) -> RectangleView:
    """Focal length, pose and scale from the four corners of a rectangle on the ground.

    Parameters
    ----------
    photo : Photo
        Its size, its principal point, and its focal length where EXIF tells it.
    corners_px : four (u, v)
        In any order.
    size_mm : (float, float)
        The two sides, in any order.
    corner_sigma_px : float
        Standard error of a corner's coordinates.

    Raises
    ------
    SketchError
        Where there is no such rectangle: corners in a line, in one place, not of a rectangle.
    """
    _check_size(size_mm)
    corners = ring_of(np.asarray(corners_px, dtype=float))
    unit = max(photo.width_px, photo.height_px) / 2
    middle = (photo.width_px / 2, photo.height_px / 2)
    principal = np.array(photo.principal_point_px or middle)
    seen = (corners - principal) / unit
    told = None
    if photo.focal_px is not None:
        told = Known(float(np.log(photo.focal_px / unit)), EXIF_LOG_SIGMA)
    seen = max((np.roll(seen, turn, axis=0) for turn in range(4)), key=_points_right)
    readings = [
        RectangleReading.of(size, seen, corner_sigma_px / unit, told)
        for size in sorted({size_mm, size_mm[::-1]}, reverse=True)
    ]
    best, *others = sorted(readings, key=lambda reading: reading.badness)
    # Eight numbers, seven unknowns: what is left over is one number's error.
    left_over = 2 * best.misfit * unit / corner_sigma_px
    wider = left_over if left_over > BELIEVED else 1.0
    best, twin = best.upright()
    view = RectangleView(
        camera=best.camera(unit, principal),
        size_mm=best.size_mm,
        corners_px=best.sight.seen * unit + principal,
        misfit_px=best.misfit * unit,
        focal_sigma=wider * best.focal_sigma,
        size_sigma=wider * best.size_sigma(),
        focal_from=best.focal_from,
        sides_unsure=any(other.badness < best.badness + CLEARLY for other in others),
        twin=None if twin is None else twin.camera(unit, principal),
        is_off=wider > 1.0 and best.misfit * unit > NOTABLE_PX,
    )
    if view.misfit_px > max(LOST_PX, 3 * corner_sigma_px):
        raise SketchError(
            f"these corners are {view.misfit_px:.0f} px off any rectangle of "
            f"{size_mm[0]:g} x {size_mm[1]:g} mm",
            (),
            "check the size, and click the four corners again",
        )
    return view


def _check_size(size_mm: tuple[float, float]) -> None:
    if not all(np.isfinite(side) and 0 < side < 1e6 for side in size_mm):
        raise SketchError(
            f"a rectangle of {size_mm[0]:g} x {size_mm[1]:g} mm is none", (), "sides above 0 mm"
        )


def ring_of(corners: Array) -> Array:
    """Four corners of a rectangle seen from above, counterclockwise.

    Parameters
    ----------
    corners : (4, 2) array
        Photo px, in any order.

    Raises
    ------
    SketchError
        Where they are no rectangle seen in perspective.
    """
    if corners.shape != (4, 2) or not bool(np.isfinite(corners).all()):
        raise SketchError("a rectangle has four corners", (), "click each of them once")
    offset = corners - corners.mean(axis=0)
    # The photo's v runs down: what is counterclockwise for the eye has falling angles.
    ring = corners[np.argsort(-np.arctan2(offset[:, 1], offset[:, 0]), kind="stable")]
    sides = np.roll(ring, -1, axis=0) - ring
    lengths = np.linalg.norm(sides, axis=1)
    if float(lengths.min()) < LEAST_SIDE_PX:
        raise SketchError(
            "two corners are almost in one place", (), "click four different corners, zoomed in"
        )
    ahead = np.roll(sides, -1, axis=0)
    turning = ahead[:, 0] * sides[:, 1] - ahead[:, 1] * sides[:, 0]
    sines = turning / (lengths * np.roll(lengths, -1))
    if float(sines.min()) < LEAST_SINE:
        raise SketchError(
            "these corners are no rectangle seen in perspective",
            (),
            "click the four outer corners of one flat rectangle, seen less from the side",
        )
    return np.asarray(ring)


def _points_right(seen: Array) -> float:
    """How far to the right the x axis points in the photo, the corners being taken so."""
    H = homography(on_ground((1.0, 1.0)), seen)
    ahead = H[:2, 0] * H[2, 2] - H[:2, 2] * H[2, 0]
    return float(ahead[0] / np.linalg.norm(ahead))
