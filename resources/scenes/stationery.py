"""Things for the desks' scenes: notes, bank card, telephone, paperback, jar, scissors, thread.

In millimetres and built about the origin; each builder returns the list of its objects, for
`common.place`.
"""

import math
import random

from common import add_box, add_lathe, add_mesh, add_prism, add_tube

#: The closed blades, (x, y): from where they come out of the handles to their common tip.
BLADES_LONG, BLADES_WIDE, BLADES_HIGH = 98.0, 25.0, 4.0


def notes(papers, side=76.0, high=38.0, seed=2):
    """A block of sticky notes, in layers of several colours."""
    chance, half, parts, z = random.Random(seed), side / 2, [], 0.0
    for index, paper in enumerate(papers):
        top = high * (index + 1) / len(papers)
        dx, dy = chance.uniform(-0.25, 0.25), chance.uniform(-0.25, 0.25)
        low, upper = (-half + dx, -half + dy, z), (half + dx, half + dy, top)
        parts.append(add_box("notes", low, upper, paper, bevel=0.2))
        z = top
    return parts


def telephone(body, glass, wide=72.0, long=148.0, thick=8.0):
    """A telephone lying on its back, along y."""
    outline = rounded_rectangle(wide, long, 9.0)
    screen = rounded_rectangle(wide - 4, long - 4, 7.5)
    case = add_prism("telephone", outline, 0, thick, body, bevel=1.6)
    return [case, add_prism("screen", screen, thick - 0.1, thick + 0.15, glass)]


def rounded_rectangle(wide, long, radius, steps=8):
    """An outline [(x, y)] about the origin."""
    points = []
    for corner, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for step in range(steps + 1):
            a = math.pi / 2 * (corner + step / steps)
            x, y = sx * (wide / 2 - radius), sy * (long / 2 - radius)
            points.append((x + radius * math.cos(a), y + radius * math.sin(a)))
    return points


def paperback(cover, paper, wide=115.0, long=180.0, thick=24.0):
    """A paperback lying shut, its spine towards -x."""
    x, y = wide / 2, long / 2
    block = add_box("block", (-x + 0.6, -y + 0.4, 0.4), (x - 0.4, y - 0.4, thick - 0.4), paper)
    back = add_box("back", (-x, -y, 0), (x, y, 0.5), cover)
    front = add_box("front", (-x, -y, thick - 0.5), (x, y, thick), cover)
    spine = add_box("spine", (-x, -y, 0), (-x + 0.6, y, thick), cover)
    return [block, back, front, spine]


def paperback_label(paint, wide=115.0, long=180.0, thick=24.0):
    """Two bars and a disc on a paperback's front, in place of a title."""
    y = long / 2
    z = thick + 0.05
    bars = [((-38, y - 44), (38, y - 36)), ((-38, y - 58), (14, y - 53))]
    parts = [add_box("bar", (*low, z - 0.03), (*high, z), paint) for low, high in bars]
    disc = add_lathe("disc", [(0, z), (26, z)], paint)
    disc.location = (0.012, -0.035, 0)
    return [*parts, disc]


def jar(glaze, radius=38.0, high=105.0):
    """A jar for pens."""
    wall = 3.5
    profile = [(0, 0), (radius - 2, 0), (radius, 2), (radius, high - 1), (radius - 1, high)]
    profile += [(radius - wall + 1, high), (radius - wall, high - 1), (radius - wall, 5), (0, 5)]
    return [add_lathe("jar", profile, glaze)]


def clip(wire, seed):
    """A paper clip lying flat."""
    chance = random.Random(seed)
    loop = [(0, 0), (22, 0), (26, 4), (22, 8), (2, 8), (-2, 4.4), (2, 1.6), (17, 1.6), (19.5, 3.6)]
    loop += [(17, 5.8), (6, 5.8)]
    path = [(x, y, 0.6 + chance.uniform(0, 0.4)) for x, y in loop]
    return [add_tube("clip", path, 0.55, wire)]


def scissors(metal, plastic):
    """Closed scissors lying along +x: the blades begin at x = 0, the handles lie towards -x."""
    long, half, high = BLADES_LONG, BLADES_WIDE / 2, BLADES_HIGH
    under = [(-34, -5), (0, -half), (30, -half + 1.4), (long, -1.2), (long, 0.6), (0, half - 7)]
    upper = [(-34, 5), (0, half), (30, half - 1.4), (long, 1.2), (long, -0.6), (0, -half + 7)]
    lower_blade = add_prism("lower blade", under, 0.0, high / 2, metal, bevel=0.3)
    upper_blade = add_prism("upper blade", upper, high / 2, high, metal, bevel=0.3)
    screw = add_lathe("screw", [(0, 0), (5, 0), (5, 1.2), (4, 1.8), (0, 1.9)], metal, segments=40)
    screw.location = (-0.012, 0, high * 0.001)
    parts = [lower_blade, upper_blade, screw]
    for side in (-1, 1):
        ring = [(-30, 10), (-52, 7), (-84, 9), (-100, 22), (-92, 38), (-66, 40), (-42, 28)]
        path = [(x, side * y, 6.0) for x, y in ring]
        parts.append(add_tube("handle", path, 5.6, plastic, closed=True))
        neck = [(-14, side * -3, 4.2), (-28, side * 5, 5.2), (-44, side * 12, 6.0)]
        parts.append(add_tube("neck", neck, 5.0, plastic, taper=[0.8, 1.0, 1.1]))
    return parts


def spool(wood, thread):
    """Thread on a wooden spool, standing."""
    ends = [(0, 0), (15, 0), (16, 1), (16, 4), (11, 8), (11, 36), (16, 40), (16, 43), (15, 44)]
    wound = [(10.5, 8), (14.5, 9), (15, 12), (15, 32), (14.5, 35), (10.5, 36)]
    return [add_lathe("spool", [*ends, (0, 44)], wood), add_lathe("thread", wound, thread)]


def leaning_pen(paint, tip, long=150.0, radius=4.0):
    """A pen standing upright, its tip up; tip it to lean it in a jar."""
    body = add_lathe("pen", [(0, 0), (radius, 0.5), (radius, long - 16)], paint, segments=48)
    cone = add_lathe("pen tip", [(radius, long - 16), (1, long - 2), (0, long)], tip, segments=48)
    return [body, cone]


def cutting_mat(base, line, wide=450.0, deep=300.0, pitch=50.0, line_mm=0.7):
    """A self-healing mat with a grid of `pitch` mm."""
    x, y = wide / 2, deep / 2
    parts = [add_prism("mat", rounded_rectangle(wide, deep, 8.0), 0.02, 2.0, base, bevel=0.5)]
    vertices, faces = [], []

    def strip(low, high):
        first = len(vertices)
        corners = ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))
        vertices.extend((cx, cy, 2.03) for cx, cy in corners)
        faces.append((first, first + 1, first + 2, first + 3))

    across, along = int((wide - 30) / pitch), int((deep - 30) / pitch)
    for k in range(across + 1):
        at = (k - across / 2) * pitch
        strip((at - line_mm / 2, -y + 15), (at + line_mm / 2, y - 15))
    for k in range(along + 1):
        at = (k - along / 2) * pitch
        strip((-x + 15, at - line_mm / 2), (x - 15, at + line_mm / 2))
    return [*parts, add_mesh("grid", vertices, faces, line)]
