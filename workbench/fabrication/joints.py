"""How two plates hold together where they meet: decided here, and changed by the person's choices.

Terms
-----
meeting
    Where two plates share space along a line: L (both end there), T (one ends on the other) or
    X (both pass).
joint
    What is made of a meeting: ``finger`` (L), ``tab_slot`` (T), ``half_lap`` (X), ``butt`` (one
    covers the other's edge) or ``none`` (both end before the shared space, which stays empty).
choice
    What a person wants of the joints at one edge of the sketch, or between two faces.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace

from .dihedral import FINGERS_FROM_RAD, FINGERS_TO_RAD
from .errors import FabricationError, SettingsError

KINDS = ("finger", "butt", "half_lap", "tab_slot", "none")
#: What each meeting can become; the first is made if nothing speaks against it.
POSSIBLE = {
    "L": ("finger", "butt", "none"),
    "T": ("tab_slot", "butt", "none"),
    "X": ("half_lap", "tab_slot"),
}
_FINGERED = ("finger", "tab_slot")
_FORMS = {"L": "both plates end", "T": "one plate ends on the other", "X": "both plates pass"}
HOW_TO_SAY = "EDGE=KIND like e5=butt or f1:f2=finger,finger=8,play=0.1,owner=f1"


@dataclass(frozen=True, slots=True)
class JointChoice:
    """What a person wants of some joints.

    Parameters
    ----------
    where : str
        The id of an edge, or of two faces with a colon between them.
    kind : str or None
        One of `KINDS`; None leaves it to us.
    finger_mm, play_mm : float or None
        Instead of the settings' own.
    owner : str or None
        The face whose plate has the end fingers, or covers the butted edge.

    Raises
    ------
    SettingsError
    """

    where: str
    kind: str | None = None
    finger_mm: float | None = None
    play_mm: float | None = None
    owner: str | None = None

    def __post_init__(self) -> None:
        if not self.where.strip(":"):
            raise SettingsError("a joint names no edge", (), HOW_TO_SAY)
        if self.kind is not None and self.kind not in KINDS:
            raise SettingsError(
                f"there is no joint {self.kind!r}", (self.where,), ", ".join(("auto", *KINDS))
            )
        for name, value, most in (("finger", self.finger_mm, 1000.0), ("play", self.play_mm, 2.0)):
            least = 0.5 if name == "finger" else 0.0
            if value is not None and not least <= value <= most:
                raise SettingsError(
                    f"the joint's {name} is {value:g} mm",
                    (self.where,),
                    f"a number from {least:g} to {most:g} mm",
                )

    @staticmethod
    def parse(text: str) -> JointChoice:
        """A choice from text such as ``e5=butt`` or ``f1:f2=finger,finger=8,owner=f1``."""
        where, _, wish = (part.strip() for part in text.partition("="))
        kind, *rest = (part.strip() for part in wish.split(","))
        known: dict[str, str] = {}
        for part in rest:
            name, _, value = (piece.strip() for piece in part.partition("="))
            known[name] = value
        numbers = {}
        for name in ("finger", "play"):
            try:
                numbers[name] = float(known.pop(name)) if name in known else None
            except ValueError:
                raise SettingsError(
                    f"the {name} in {text!r} is no number", (), HOW_TO_SAY
                ) from None
        owner = known.pop("owner", None)
        if not kind or known:
            raise SettingsError(f"{text!r} is no joint", (), HOW_TO_SAY)
        kind = kind.replace("-", "_")
        return JointChoice(
            where, None if kind == "auto" else kind, numbers["finger"], numbers["play"], owner
        )

    def concerns(self, meeting: Meeting) -> bool:
        """Whether this choice is about a meeting."""
        if ":" not in self.where:
            return self.where in meeting.edge_ids
        one, two = self.where.split(":", 1)
        pairs = ((meeting.one, meeting.two), (meeting.two, meeting.one))
        return any(one in a and two in b for a, b in pairs)


@dataclass(frozen=True, slots=True)
class Meeting:
    """Where two plates meet.

    Parameters
    ----------
    form : str
        ``L``, ``T`` (`one` passes) or ``X``.
    one, two : tuple of face ids
        Of the two plates; `one` owns the ends unless told otherwise.
    edge_ids : tuple of str
        The sketch's edges there.
    theta_rad : float
        Interior dihedral angle.
    length_mm, least_mm, room_mm : float
        Of what is clear of the corners; of the narrowest finger that holds; of what is needed for
        fingers at all.
    middle_mm : (x, y, z)
        About where it is, in the world once all is decided.
    """

    form: str
    one: tuple[str, ...]
    two: tuple[str, ...]
    edge_ids: tuple[str, ...]
    theta_rad: float
    length_mm: float
    least_mm: float
    room_mm: float
    middle_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)

    @property
    def name(self) -> tuple[str, ...]:
        """The edges' ids; the faces' where the sketch has no edge there."""
        return self.edge_ids or (self.one[0], self.two[0])

    @property
    def everything(self) -> tuple[str, ...]:
        """The edges' ids and the plates': for errors."""
        return (*self.edge_ids, self.one[0], self.two[0])

    def is_too_narrow(self, finger_mm: float) -> bool:
        """Whether fingers of a width would not hold here."""
        return finger_mm < self.least_mm - 1e-9


@dataclass(frozen=True, slots=True)
class Joint:
    """What is made of a meeting.

    Parameters
    ----------
    meeting : Meeting
    kind : str
        One of `KINDS`.
    finger_mm, play_mm : float
        Wished width of fingers; clearance.
    swapped : bool
        True where the meeting's second plate owns the ends.
    reason : str
        Why it is not the usual kind; empty where it is, or where the person chose it.
    """

    meeting: Meeting
    kind: str
    finger_mm: float
    play_mm: float
    swapped: bool = False
    reason: str = ""

    @property
    def owner(self) -> str:
        """The face whose plate owns the ends."""
        return (self.meeting.two if self.swapped else self.meeting.one)[0]

    @property
    def widened(self) -> bool:
        """Whether the wished fingers would not hold, so that they are made wider."""
        cut = self.meeting.form != "X" and self.kind in _FINGERED
        return cut and self.meeting.is_too_narrow(self.finger_mm)

    @property
    def words(self) -> str:
        """One line about it."""
        degrees = math.degrees(self.meeting.theta_rad)
        faces = f"{self.meeting.one[0]} and {self.meeting.two[0]}"
        edges = f"{', '.join(self.meeting.edge_ids)}: " if self.meeting.edge_ids else ""
        why = f" ({self.reason})" if self.reason else ""
        kind = self.kind.replace("_", " ")
        return f"{edges}{kind} between {faces} at {degrees:.0f} degrees{why}"


@dataclass(slots=True)
class JointPlan:
    """Decides joints one after the other and remembers them.

    Parameters
    ----------
    finger_mm, play_mm : float
        The settings' own.
    choices : tuple of JointChoice
        The last one that concerns a meeting counts.
    """

    finger_mm: float
    play_mm: float
    choices: tuple[JointChoice, ...] = ()
    joints: list[Joint] = field(default_factory=list)
    _butted: dict[tuple[tuple[str, ...], tuple[str, ...]], str] = field(default_factory=dict)
    _used: set[JointChoice] = field(default_factory=set)

    def decide(self, meeting: Meeting, count: Callable[[float], int]) -> Joint:
        """The joint of a meeting.

        Parameters
        ----------
        meeting : Meeting
        count : callable
            From the wished width of fingers to how many there is room for; 1 means none.

        Raises
        ------
        FabricationError
            Where the chosen joint cannot be made.
        """
        wish = self._wish(meeting)
        finger = self.finger_mm if wish.finger_mm is None else wish.finger_mm
        play = self.play_mm if wish.play_mm is None else wish.play_mm
        kind, reason, swapped = _possible(wish.kind, meeting), "", _swapped(meeting, wish.owner)
        if meeting.form != "X" and kind in _FINGERED:
            reason = why_no_fingers(meeting, count(finger)) or self._butted.get(_sides(meeting), "")
            if reason and wish.kind is not None:
                raise FabricationError(
                    f"fingers cannot hold here: {reason}", meeting.everything, "butt"
                )
            if not reason and wish.finger_mm is not None and meeting.is_too_narrow(finger):
                raise FabricationError(
                    f"fingers of {finger:g} mm cannot hold here",
                    meeting.everything,
                    f"{meeting.least_mm:g} mm or wider",
                )
        joint = Joint(meeting, "butt" if reason else kind, finger, play, swapped, reason)
        self.joints.append(joint)
        return joint

    def _wish(self, meeting: Meeting) -> JointChoice:
        """The last choice about a meeting; one that wants nothing where there is none."""
        wish = JointChoice("-")
        for choice in self.choices:
            if choice.concerns(meeting):
                self._used.add(choice)
                wish = choice
        return wish

    def butt_instead(self, face_ids: Sequence[str]) -> bool:
        """Begin again, with one finger joint fewer at a plate that fingers cut into pieces.

        Parameters
        ----------
        face_ids : sequence of str
            Of the plate.

        Returns
        -------
        bool
            False where no finger joint is left that the person did not choose; then nothing
            changes.
        """
        able = [
            joint.meeting
            for joint in self.joints
            if joint.kind == "finger"
            and {*face_ids} & {*joint.meeting.one, *joint.meeting.two}
            and not self._chosen(joint.meeting)
        ]
        if not able:
            return False
        # The shortest holds least.
        shortest = min(able, key=lambda meeting: meeting.length_mm)
        self._butted[_sides(shortest)] = f"fingers would cut {face_ids[0]} into pieces"
        self.joints.clear()
        return True

    def butt_after_all(self, joint: Joint, reason: str) -> None:
        """Say that a joint of tabs has none.

        Parameters
        ----------
        joint : Joint
        reason : str

        Raises
        ------
        FabricationError
            Where the person chose tabs there.
        """
        if self._chosen(joint.meeting):
            raise FabricationError(
                f"tabs cannot hold here: {reason}", joint.meeting.everything, "butt"
            )
        self.joints[self.joints.index(joint)] = replace(joint, kind="butt", reason=reason)

    def edges_between(self, face_ids: Collection[str]) -> tuple[str, ...]:
        """The sketch's edges in which any two of some plates are joined; one's with any other."""
        found = [id_ for meeting in self._between(face_ids) for id_ in meeting.edge_ids]
        return tuple(dict.fromkeys(found))

    def chosen_between(self, face_ids: Collection[str]) -> tuple[str, ...]:
        """Where the person chose a joint of any two of some plates, as they said it."""
        found = [c.where for m in self._between(face_ids) for c in self._chosen(m)]
        return tuple(dict.fromkeys(found))

    def _between(self, face_ids: Collection[str]) -> list[Meeting]:
        known, enough = {*face_ids}, min(2, len(face_ids))
        meetings = [joint.meeting for joint in self.joints]
        return [m for m in meetings if len(known & {m.one[0], m.two[0]}) == enough]

    def _chosen(self, meeting: Meeting) -> list[JointChoice]:
        return [c for c in self.choices if c.kind is not None and c.concerns(meeting)]

    def check_used(self) -> None:
        """Refuse choices that concern no joint, by their names."""
        unused = [choice.where for choice in self.choices if choice not in self._used]
        if unused:
            raise SettingsError(
                "no two plates meet there", unused, f"one of {_some(self._names())}"
            )

    def _names(self) -> list[str]:
        return list(dict.fromkeys(":".join(j.meeting.name) for j in self.joints))


def _possible(kind: str | None, meeting: Meeting) -> str:
    """The kind that is wanted, or the usual one."""
    possible = POSSIBLE[meeting.form]
    if kind is None or (meeting.form, kind) == ("T", "finger"):
        return possible[0]
    if kind not in possible:
        raise FabricationError(
            f"no {kind.replace('_', ' ')} joint can be made where {_FORMS[meeting.form]}",
            meeting.everything,
            " or ".join(possible).replace("_", " "),
        )
    return kind


def _swapped(meeting: Meeting, owner: str | None) -> bool:
    """Whether the meeting's second plate shall own the ends."""
    if owner is None or owner in meeting.one:
        return False
    if owner not in meeting.two:
        raise SettingsError(
            f"{owner} does not meet this edge",
            meeting.name,
            f"owner {meeting.one[0]} or {meeting.two[0]}",
        )
    if meeting.form == "T":
        raise SettingsError(
            f"{owner} ends on {meeting.one[0]}, which must own the ends",
            meeting.name,
            f"owner {meeting.one[0]}",
        )
    return True


def _sides(meeting: Meeting) -> tuple[tuple[str, ...], tuple[str, ...]]:
    return meeting.one, meeting.two


def why_no_fingers(meeting: Meeting, count: int) -> str:
    """Why fingers cannot hold at a meeting; empty where they can."""
    folded = min(meeting.theta_rad, 2 * math.pi - meeting.theta_rad)
    if not FINGERS_FROM_RAD <= folded <= FINGERS_TO_RAD:
        degrees = math.degrees(folded)
        return f"{degrees:.0f} degrees; fingers hold from 30 to 150 degrees"
    if count < 2:
        return (
            f"{max(meeting.length_mm, 0.0):.1f} mm clear of the corners; "
            f"fingers need {meeting.room_mm:.1f} mm at least"
        )
    return ""


def _some(names: Iterable[str], most: int = 8) -> str:
    names = list(names)
    return ", ".join(names[:most]) + (", ..." if len(names) > most else "")
