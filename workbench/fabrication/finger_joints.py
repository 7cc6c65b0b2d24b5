"""Who owns what: every part of space in which walls meet goes to one of them.

Terms
-----
finger, space
    Along a run the two walls take turns; what is one's finger is the other's space.
order
    One global order of the walls. A wall that ends on another comes after it; otherwise the
    order of the model's faces decides. The lower wall owns junctions and the end fingers of
    corners, the passing wall those of a T: so every plate stays in one piece.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Mapping, Sequence

from shapely.geometry import box

from ...solver.values import Array
from .cells import Cells, Run, meetings
from .joints import Joint, JointPlan, Meeting
from .junctions import junction_pieces
from .pieces import NO_SLACK, Corner, Piece, Slack
from .settings import PlateSettings
from .walls import Wall

#: Ends of the sketch's edges in the frame, mm.
Edges = Mapping[str, tuple[Array, Array]]


def share_out(
    walls: Sequence[Wall],
    settings: PlateSettings,
    plan: JointPlan | None = None,
    edges: Edges | None = None,
) -> list[Piece]:
    """All pieces of a right-angled model.

    Parameters
    ----------
    walls : sequence of Wall
    settings : PlateSettings
        `finger_mm`, `play_mm` and (for the narrowest finger) `beam_mm` are used.
    plan : JointPlan or None
        Decides the joints, and knows them afterwards.
    edges : mapping of edge id to ends
        So that choices can name edges.

    Returns
    -------
    list of Piece
        Boxes that overlap nowhere and hold all space which several walls share.
    """
    plan = plan or JointPlan(settings.finger_mm, settings.play_mm, settings.joints)
    cells = Cells(walls)
    runs, claimed = meetings(cells)
    ranks = global_order(len(walls), runs)
    joints = {run: _joint(run, walls, ranks, plan, settings.beam_mm, edges or {}) for run in runs}
    owners = {run: _owner(run, ranks, joint) for run, joint in joints.items()}
    pieces = junction_pieces(cells, claimed, owners, ranks)
    for run, joint in joints.items():
        if run.kind != "X":
            pieces += _finger_pieces(run, walls, owners[run], joint)
    for run, joint in joints.items():
        if run.kind == "X":
            pieces += _half_lap(run, walls, ranks, cells, pieces, joint)
    return pieces


def _joint(
    run: Run, walls: Sequence[Wall], ranks: list[int], plan: JointPlan, kerf: float, edges: Edges
) -> Joint:
    """What the plan decides for a run."""
    one, two = run.one, run.two
    if run.kind == "L" and ranks[two] < ranks[one]:
        one, two = two, one
    thickness = max(walls[one].thickness_mm, walls[two].thickness_mm)
    least = least_finger_mm(thickness, kerf)
    meeting = Meeting(
        run.kind,
        walls[one].face_ids,
        walls[two].face_ids,
        tuple(id_ for id_, ends in edges.items() if _lies_on(run, walls, ends)),
        math.pi / 2,
        run.high_mm - run.low_mm,
        least,
        3 * least if run.kind == "L" else least + 2 * thickness,
        _middle(run, walls),
    )
    return plan.decide(
        meeting, lambda finger: len(finger_borders(run, thickness, finger, least, "")) - 1
    )


def _middle(run: Run, walls: Sequence[Wall]) -> Corner:
    spot = [0.0] * 3
    for wall in (walls[run.one], walls[run.two]):
        spot[wall.axis] = (wall.low_mm + wall.high_mm) / 2
    spot[run.axis] = (run.low_mm + run.high_mm) / 2
    return spot[0], spot[1], spot[2]


def _lies_on(run: Run, walls: Sequence[Wall], ends: tuple[Array, Array]) -> bool:
    start, end = ends
    for wall in (walls[run.one], walls[run.two]):
        if max(abs(p[wall.axis] - wall.drawn_mm) for p in ends) > 1e-5:
            return False
    low, high = sorted((float(start[run.axis]), float(end[run.axis])))
    return min(high, run.high_mm) - max(low, run.low_mm) > 1e-5


def _owner(run: Run, ranks: list[int], joint: Joint) -> int:
    """Which wall owns the ends of a run; -1 where nobody has any of it."""
    if joint.kind == "none" and run.kind == "L":
        return -1
    first, second = run.one, run.two
    if run.kind != "T" and ranks[second] < ranks[first]:
        first, second = second, first
    return second if joint.swapped else first


def global_order(count: int, runs: Iterable[Run]) -> list[int]:
    """The rank of each wall: after all walls on which it ends, else by its number."""
    carriers: list[set[int]] = [set() for _ in range(count)]
    for run in runs:
        if run.kind == "T":
            carriers[run.two].add(run.one)
    ranks = [-1] * count
    for rank in range(count):
        waiting = [w for w in range(count) if ranks[w] < 0]
        # Walls that end on one another in a circle: the first of them has to begin.
        ready = [w for w in waiting if all(ranks[c] >= 0 for c in carriers[w])] or waiting
        ranks[ready[0]] = rank
    return ranks


def divide(length: float, target: float, least: float) -> int:
    """Into how many equal fingers to divide a length: odd, near the target width, 1 if too short.

    Parameters
    ----------
    length, target, least : float
        Of the run; wished for; the narrowest allowed, mm.

    Returns
    -------
    int
        An odd number n with ``length / n >= least`` where n > 1.
    """
    most = int(length / least + 1e-9)
    most -= 1 - most % 2
    if most < 3:
        return 1
    wished = 2 * int(length / target / 2) + 1
    wished = min((n for n in (wished, wished + 2) if n > 1), key=lambda n: abs(length / n - target))
    return min(wished, most)


def least_finger_mm(thickness: float, kerf: float) -> float:
    """The narrowest finger that holds: 1.5 thicknesses, and 2 mm besides the kerf."""
    return max(1.5 * thickness, 2.0 + kerf)


def finger_borders(
    run: Run, thickness: float, finger: float, least: float, kind: str
) -> list[float]:
    """Where the fingers of a run begin and end, along its axis, mm.

    Of a T that is too short for three fingers, one tab is left if it keeps one thickness of
    material at each end.
    """
    if kind in ("butt", "none"):
        return [run.low_mm, run.high_mm]
    length = run.high_mm - run.low_mm
    count = divide(length, finger, least)
    if count == 1 and run.kind == "T" and length >= least + 2 * thickness:
        tab = max(least, length / 3)
        middle = (run.low_mm + run.high_mm) / 2
        borders = [run.low_mm, middle - tab / 2, middle + tab / 2, run.high_mm]
    else:
        borders = [run.low_mm + length * k / count for k in range(count + 1)]
    inner = [round(border, 6) for border in borders[1:-1]]
    return [run.low_mm, *inner, run.high_mm]


def _finger_pieces(run: Run, walls: Sequence[Wall], first: int, joint: Joint) -> list[Piece]:
    """The fingers of a run in turns, beginning and ending with those of its owner."""
    if first < 0:
        piece = _run_piece(run, walls, (run.low_mm, run.high_mm), -1, run.one, NO_SLACK)
        return [Piece(piece.low_mm, piece.high_mm, -1, ())]
    second = run.two if first == run.one else run.one
    thickness = max(walls[first].thickness_mm, walls[second].thickness_mm)
    least = joint.meeting.least_mm
    borders = finger_borders(run, thickness, joint.finger_mm, least, joint.kind)
    pieces = []
    for n, (low, high) in enumerate(itertools.pairwise(borders)):
        owner, rival = (second, first) if n % 2 else (first, second)
        at_end = (n == 0, n == len(borders) - 2)
        slack = _finger_slack(run, walls, owner, at_end, joint.play_mm)
        pieces.append(_run_piece(run, walls, (low, high), owner, rival, slack, least))
    return pieces


def _finger_slack(
    run: Run, walls: Sequence[Wall], owner: int, at_end: tuple[bool, bool], play: float
) -> Slack:
    """Play around a finger: half on each side of a slot; in a corner both plates give a quarter."""
    slack = [(0.0, 0.0)] * 3
    if run.kind == "T" and owner == run.two:
        slack[run.axis] = slack[walls[owner].axis] = (play / 2, play / 2)
    elif run.kind == "L":
        slack[run.axis] = (0.0 if at_end[0] else play / 4, 0.0 if at_end[1] else play / 4)
    return slack[0], slack[1], slack[2]


def _run_piece(
    run: Run,
    walls: Sequence[Wall],
    ends: tuple[float, float],
    owner: int,
    rival: int,
    slack: Slack,
    least: float = 0.0,
) -> Piece:
    low, high = [0.0] * 3, [0.0] * 3
    for wall in (walls[run.one], walls[run.two]):
        low[wall.axis], high[wall.axis] = wall.low_mm, wall.high_mm
    low[run.axis], high[run.axis] = ends
    return Piece(
        (low[0], low[1], low[2]),
        (high[0], high[1], high[2]),
        owner,
        (rival,),
        slack,
        run.axis if run.kind != "L" else -1,
        least,
        run.one if run.kind == "T" else -1,
    )


def _half_lap(
    run: Run,
    walls: Sequence[Wall],
    ranks: list[int],
    cells: Cells,
    pieces: list[Piece],
    joint: Joint,
) -> list[Piece]:
    """Two walls through one another: each has a slot to the middle, open at one end.

    A slot can only open where its wall does not go on; a wall that goes on at both ends gets one
    closed slot and the other wall goes through it whole. Where even that cannot be, the plates
    stay whole, though they can be put together only in pieces.
    """
    play = joint.play_mm
    first, second = sorted((run.one, run.two), key=lambda wall: ranks[wall])
    if joint.swapped:
        first, second = second, first
    if joint.kind == "tab_slot":
        ends = (run.low_mm, run.high_mm)
        return [_lap(run, walls, ends, first, second, (play / 2, play / 2))]
    goes_on = {w: _goes_on(run, w, walls, cells, pieces) for w in (first, second)}
    # The owner of the low half has its slot in the high half, and the other way round.
    orders = ((first, second), (second, first))
    opens = [not goes_on[low][1] and not goes_on[high][0] for low, high in orders]
    for whole, other in ((second, first), (first, second)):
        if not any(opens) and all(goes_on[other]) and _stays_whole(run, other, walls):
            ends = (run.low_mm, run.high_mm)
            return [_lap(run, walls, ends, whole, other, (play / 2, play / 2))]
    low, high = orders[opens.index(True)] if any(opens) else orders[0]
    middle = round((run.low_mm + run.high_mm) / 2, 6)
    return [
        _lap(run, walls, (run.low_mm, middle), low, high, (0.0, play / 4)),
        _lap(run, walls, (middle, run.high_mm), high, low, (play / 4, 0.0)),
    ]


def _stays_whole(run: Run, wall: int, walls: Sequence[Wall]) -> bool:
    """Whether a wall keeps hanging together when the other one goes through it all along a run."""
    other = walls[run.two if wall == run.one else run.one]
    low, high = [0.0] * 3, [0.0] * 3
    low[other.axis], high[other.axis] = other.low_mm, other.high_mm
    low[run.axis], high[run.axis] = run.low_mm, run.high_mm
    u, v = walls[wall].plane_axes
    rest = walls[wall].region.difference(box(low[u], low[v], high[u], high[v]))
    return bool(rest.geom_type == "Polygon")


def _lap(
    run: Run,
    walls: Sequence[Wall],
    ends: tuple[float, float],
    owner: int,
    rival: int,
    along: tuple[float, float],
) -> Piece:
    slack = [(0.0, 0.0)] * 3
    slack[run.axis] = along
    half = 2 * max(along)
    slack[walls[owner].axis] = (half, half) if ends != (run.low_mm, run.high_mm) else along
    return _run_piece(run, walls, ends, owner, rival, (slack[0], slack[1], slack[2]))


def _goes_on(
    run: Run, wall: int, walls: Sequence[Wall], cells: Cells, pieces: list[Piece]
) -> tuple[bool, bool]:
    """Whether a wall has material of its own just before and just beyond a run."""
    other = run.two if wall == run.one else run.one
    span, across = cells.spans[other], walls[other].axis
    flags = cells.in_plane(cells.full[wall], wall, across, span).max(axis=0).tolist()
    lines = cells.lines[run.axis]
    result = []
    for at, step in ((run.low_mm, -1), (run.high_mm, 1)):
        border = int(abs(lines - at).argmin())
        cell = border - 1 if step < 0 else border
        there = 0 <= cell < len(flags) and flags[cell]
        if there:
            point = [0.0] * 3
            for member in (walls[wall], walls[other]):
                # Off the middle: there the drawn planes of other walls are, and no piece.
                point[member.axis] = 0.63 * member.low_mm + 0.37 * member.high_mm
            point[run.axis] = at + 1e-3 * step
            there = all(piece.owner == wall for piece in pieces if _holds(piece, point))
        result.append(there)
    return result[0], result[1]


def _holds(piece: Piece, point: Sequence[float]) -> bool:
    return all(
        low < x < high for low, x, high in zip(piece.low_mm, point, piece.high_mm, strict=True)
    )
