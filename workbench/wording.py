"""What the solver and the making of plates say, in the person's language.

They know no languages: their sentences are English, with numbers and ids in them. Here the known
ones are told by their pattern, and put together again from their translation.
"""

from __future__ import annotations

import re
from functools import lru_cache

from . import host
from .file_reasons import FILE_REASONS
from .made_lines import LINES
from .reasons import REASONS

#: Sentences with a place `{}` for each number, id or list of ids.
SENTENCES = (
    "Solved.",
    "Stopped before the end: this is as far as it came.",
    "Solved, but seen from below: check the ground vertices.",
    "Solved, but seen from below: mark what stands on the ground.",
    "Solved, with a usual focal length assumed: the drawing does not tell it.",
    "Solved, with what is drawn nearly square taken to be square: mark right angles where it is.",
    "Solved, but the drawing is missed by {} px: check the annotations against it.",
    "The drawing is missed by {} px.",
    "Solved, but the drawing is missed by {} px: check {}.",
    "Solved, but a second shape, with near and far exchanged, fits as well: mark what stands on "
    "the ground, or ask for the twin.",
    "Solved, but {} contradicts the drawing, which is missed by {} px.",
    "The drawing does not tell the focal length: a usual one is assumed.",
    "Its sizes are unsure: mark more, give a length, or trace something real in the photo.",
    "Only just enough is said, and other shapes may fit as well: mark more.",
    "{} freedom left: add a right angle, parallel or ground vertex at {}.",
    "{} freedoms left: add a right angle, parallel or ground vertex at {}.",
    "{} freedom left: nothing is said to be square or parallel; begin with right angles at {}.",
    "{} freedoms left: nothing is said to be square or parallel; begin with right angles at {}.",
    "{} freedom left: give the diameter of {}, or join circles of one axis to a surface of "
    "revolution (V).",
    "{} freedoms left: give the diameter of {}, or join circles of one axis to a surface of "
    "revolution (V).",
    "If {} and {} are square at {}, saying so would help most.",
    "{} cannot all hold: take one of them away.",
    "{} cannot hold with what is said of the circles and the rest of the side: take one of these "
    "away.",
    "{} cannot hold with the rest: try removing them.",
    "{0} cannot hold: try removing {0}.",
    "{0} cannot hold together with {1}: try removing {0}.",
    "{} contradicts the rest: with it the drawing is missed by {} px, without it by {} px.",
    "Solved, but {} contradicts the drawing: with it the drawing is missed by {} px, "
    "without it by {} px.",
    "Solved without {}.",
    "Correct {}, or take it away.",
    "The drawing and the annotations are too far apart: check the annotations.",
    "No shape was found in which all annotations hold: mark more right angles, parallels or "
    "ground vertices, or check {}.",
    "No 3D shape fits this drawing; check the annotations against it.",
    "The sketch has no edges: draw the object's edges over the photo.",
    "All vertices lie on one line: draw edges in at least two directions.",
    "No straight edges are seen between the corners, which are taken as they are: place them well.",
    "The photo is blurred there, edges are {} px wide: sizes are less sure; take it with a steady "
    "hand, or in more light.",
    "No camera takes photos of {} x {} px: where this one was cropped, sizes may be off by some "
    "percent: use the whole photo, or say where it looked in the photo's camera.",
    "The corners are {} px off any rectangle of this size: check the size, that it lies flat, and "
    "that the photo was not cropped.",
    "The rectangle is seen too square-on to tell the focal length, which is good to {} % only: "
    "take the photo from lower down, or keep its EXIF data.",
    "Seen from straight above, heights are hardly to be told: take the photo from lower down.",
    "Heights are good to {} % only: have the rectangle larger in the photo.",
    "The corners do not tell which way the ground leans: have the rectangle larger in the photo, "
    "and check the grid on the ground.",
    "The corners do not tell which side is the longer one: check the grid on the ground, or keep "
    "the photo's EXIF data.",
    "The traced line {} is {} px ({} degrees) off the perspective of the rest: check it.",
    "Several traced lines are off: where the photo was cropped, use the whole photo, or say where "
    "it looked in the photo's camera.",
    "The traced lines {} are too nearly parallel in the photo to tell where they meet: trace "
    "others further apart, or use a marker.",
    "Lines on straight things bend by up to {} px ({}): the lens distorts, by {} % at the photo's "
    "corners: straighten the photo.",
    "Long edges in the photo bend by up to {} px: the lens distorts, by {} % at the photo's "
    "corners: straighten the photo.",
    "{}, too many to solve for: mark right angles and parallels.",
    "{} drawn without width or height: pull the ellipse open.",
    "The given lengths put the camera {} mm ({} %) off its known height: check the length, the "
    "camera, and what stands on the ground.",
    "Too many copies ({} and so on): take some symmetry planes away.",
    "No faces were looked for: {}.",
    "No face was found for {}: choose another one.",
    "Not flat enough for a face: {}, {} mm off: mark right angles or parallels there, or take it "
    "for a face.",
    "Where {} is flat, taking it for a face would help.",
    "Nothing is said to be square or parallel: begin with right angles at {}.",
    "The traced lines meet as in a cropped photo: it was taken towards {} px, not {} px: say "
    "so in the photo's camera, or use the whole photo.",
)
#: What is no sentence: what is wrong, what to try, lines of a list.
CLAUSES = (*REASONS, *LINES, *FILE_REASONS)
#: The words between the last two ids of a list.
JOINTS = ("and", "or")

#: An error: what is wrong, the ids at fault in brackets, and what to try.
_REASON = re.compile(r"(?P<what>.+?)(?P<ids> \([^()]*\))?; try: (?P<remedy>.+)")

_PLACE = re.compile(r"\{(\d*)\}")
_ENDS = re.compile(r"(?<=[.!?])\s+(?=[A-Zac-z])")


def in_language(words: str) -> str:
    """What the solver or the making of plates says, in the person's language.

    Sentences, and errors with what to try; others stay as they are.
    """
    if words.endswith("."):
        return " ".join(_known(SENTENCES, sentence) for sentence in _ENDS.split(words))
    reason = _REASON.fullmatch(words)
    if reason is None:
        return _known(CLAUSES, words)
    what = in_language(reason["what"]) + (reason["ids"] or "")
    return host.translate("InContext", "{}; try: {}").format(what, in_language(reason["remedy"]))


def _known(sources: tuple[str, ...], words: str) -> str:
    for source in sources:
        found = _pattern(source).fullmatch(words)
        if found:
            parts = [_part(part) for part in found.groups()]
            return host.translate("InContext", source).format(*parts)
    return words


@lru_cache(maxsize=len(SENTENCES) + len(CLAUSES))
def _pattern(source: str) -> re.Pattern[str]:
    """A sentence with anything in its places, and the same where a place comes again."""
    pattern, number = "", 0
    for k, part in enumerate(_PLACE.split(source)):
        if k % 2 == 0:
            pattern += re.escape(part)
        elif part and int(part) < number:
            pattern += rf"\{int(part) + 1}"
        else:
            number += 1
            pattern += "(.+?)"
    return re.compile(pattern)


def _part(words: str) -> str:
    """What stands in a place: a clause, or ids or clauses in a list."""
    whole = in_language(words)
    if whole != words:
        return whole
    parts = re.split(rf"(, | (?:{'|'.join(JOINTS)}) )", words)
    if len(parts) == 1:
        return words
    joints = (_joint(part) if k % 2 else in_language(part) for k, part in enumerate(parts))
    return "".join(joints)


def _joint(words: str) -> str:
    return words if words == ", " else f" {host.translate('InContext', words.strip())} "
