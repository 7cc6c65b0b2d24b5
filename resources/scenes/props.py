"""Things to stand in the example scenes: hardback, mug, pencil, notebook, plant.

In millimetres and built about the origin; each builder returns the list of its objects, for
`common.place`.
"""

import math
import random

from common import add_box, add_lathe, add_mesh, add_prism, add_tube, metres, place
from mathutils import Matrix

BOARD = 2.6  # thickness of a hardback's boards
SQUARE = 3.5  # how far the boards overhang the pages
SPINE_ROUND = 0.3  # how far the middle of a spine stands out before its edges


def spine_curve(width, steps=12, proud=0.0):
    """Points (x, y) along a slightly rounded spine, from left to right, foremost at y = -proud."""
    points = []
    for step in range(steps + 1):
        share = 2 * step / steps - 1
        points.append((share * width / 2, SPINE_ROUND * share * share - proud))
    return points


def hardback(thick, deep, high, cover, paper, band_cloth, gilt, label, marks):
    """A book standing upright: spine at y = 0 facing -y, x from -thick/2 to thick/2, z from 0.

    `marks` gilt points near the foot of the spine say which volume it is.
    """
    half = thick / 2
    inner = half - BOARD
    side = [(half, 5), (half - 1.3, 6.5), (half - 1.3, 10.5), (half, 13.5), (half, deep)]
    left = [(-x, y) for x, y in reversed(side)]
    inside = [(inner, deep), (inner, BOARD + 1), (-inner, BOARD + 1), (-inner, deep)]
    case = add_prism("case", left + spine_curve(thick) + side + inside, 0, high, cover, bevel=0.25)
    block = add_box(
        "pages", (-inner, BOARD + 3, SQUARE), (inner, deep - SQUARE, high - SQUARE), paper
    )
    head = high - SQUARE
    band = add_box(
        "headband",
        (-inner, BOARD + 1.2, head - 4),
        (inner, BOARD + 4.6, head + 0.8),
        band_cloth,
        0.8,
    )
    return [case, block, band, *spine_label(thick, high, gilt, label, marks)]


def spine_label(thick, high, gilt, label, marks):
    """Gold rules, a label bearing an ornament in place of a title, and the volume's points."""
    wide = thick - 2.4
    parts = [spine_strip("label", wide, 0.700 * high, 0.830 * high, label)]
    for share, rule in (
        (0.935, 1.6),
        (0.920, 0.7),
        (0.842, 0.8),
        (0.686, 0.8),
        (0.085, 0.7),
        (0.065, 1.6),
    ):
        parts.append(spine_strip("rule", wide, share * high, share * high + rule, gilt))
    for share in (0.715, 0.811):
        parts.append(
            spine_strip("label rule", wide, share * high, share * high + 0.9, gilt, proud=0.2)
        )
    parts.append(spine_diamond("ornament", 4.4, 5.6, 0.765 * high, gilt))
    for index in range(marks):
        parts.append(spine_diamond("volume point", 1.7, 1.7, 0.14 * high + 6.0 * index, gilt))
    return parts


def spine_diamond(name, half_wide, half_high, z, material):
    """A lozenge in the middle of a spine."""
    corners = [(-half_wide, z), (0, z - half_high), (half_wide, z), (0, z + half_high)]
    return add_mesh(name, [(x, -0.25, z) for x, z in corners], [(0, 1, 2, 3)], material)


def spine_strip(name, width, z_from, z_to, material, proud=0.12):
    """A thin patch lying on the spine."""
    curve = spine_curve(width, proud=proud)
    count = len(curve)
    vertices = [(x, y, z) for z in (z_from, z_to) for x, y in curve]
    faces = [(i, i + 1, count + i + 1, count + i) for i in range(count - 1)]
    return add_mesh(name, vertices, faces, material)


def mug(glaze, drink, radius=41.0, high=92.0, wall=4.0):
    """A plain mug with its handle towards +x, nearly full."""
    foot, lip = radius - 5, wall / 2
    outer = [(0, 2), (foot - 4, 2), (foot - 3, 0), (foot, 0), (foot + 1.5, 1.5)]
    outer += [(radius - 1, 7), (radius, 14)]
    bends = (0, 0.5, 1.05, 1.57)
    rim = [(radius - lip + lip * math.cos(a), high - lip + lip * math.sin(a)) for a in bends]
    rim += [(2 * (radius - lip) - r, z) for r, z in reversed(rim[:-1])]
    inner = [(radius - wall, 14), (radius - wall - 3, 8), (radius - wall - 9, 6), (0, 6)]
    body = add_lathe("mug", outer + rim + inner, glaze)
    surface = add_lathe("drink", [(0, high - 14), (radius - wall + 0.2, high - 14)], drink)
    reach = radius + 27
    path = [(radius - 2, 0, 74), (radius + 12, 0, 77), (reach, 0, 64), (reach - 1, 0, 42)]
    path += [(radius + 12, 0, 24), (radius - 2, 0, 21)]
    return [body, surface, add_tube("handle", path, 5.2, glaze)]


def pencil(paint, bare_wood, lead, long=165.0, radius=3.7):
    """A sharpened six-sided pencil lying along +x on the table."""
    body = add_lathe("pencil", [(0, 0), (radius, 0), (radius, long - 22)], paint, segments=6)
    cone = add_lathe(
        "cut", [(radius * 0.98, long - 23.5), (1.0, long - 4.5)], bare_wood, segments=32
    )
    tip = add_lathe("lead", [(1.05, long - 5), (0.25, long), (0, long)], lead, segments=32)
    lie_down = Matrix.Translation(metres((0, 0, radius * 0.866))) @ Matrix.Rotation(
        math.pi / 2, 4, "Y"
    )
    flat_side_down = lie_down @ Matrix.Rotation(math.pi / 6 + math.pi / 2, 4, "Z")
    return place([body, cone, tip], (0, 0, 0), tip=flat_side_down)


def notebook(cover, paper, strap, wide=130.0, long=190.0, thick=13.0):
    """A soft notebook lying shut, held by a strap."""
    x, y = wide / 2, long / 2
    bottom = add_box("notebook back", (-x, -y, 0), (x, y, 1.4), cover, bevel=0.6)
    block = add_box(
        "notebook pages", (-x + 1.5, -y + 2, 1.4), (x - 2, y - 2, thick - 1.4), paper, bevel=0.4
    )
    front = add_box("notebook front", (-x, -y, thick - 1.4), (x, y, thick), cover, bevel=0.6)
    spine = add_box("notebook spine", (-x, -y, 0.4), (-x + 1.4, y, thick - 0.4), cover, bevel=0.6)
    band = add_box(
        "strap", (x - 22, -y - 0.5, 0.2), (x - 15, y + 0.5, thick + 0.5), strap, bevel=0.4
    )
    return [bottom, block, front, spine, band]


def plant(clay, soil, leaf, leaves=11, seed=3):
    """A bow-string hemp: stiff upright leaves in a clay pot."""
    outer = [(0, 0), (44, 0), (46, 2), (60, 88), (65, 88), (67, 90), (68, 108), (66, 110)]
    outer += [(61, 110), (59, 96)]
    parts = [add_lathe("pot", outer, clay), add_lathe("soil", [(0, 98), (60, 98)], soil)]
    chance = random.Random(seed)
    for index in range(leaves):
        around = index * 137.5 + chance.uniform(-15, 15)
        out = 7 + 30 * math.sqrt(index / leaves)
        shape = {"long": chance.uniform(190, 300) - 2.2 * out, "wide": chance.uniform(30, 40)}
        shape |= {"lean": 0.006 * out, "twist": chance.uniform(-50, 50)}
        blade = leaf_blade(leaf, **shape)
        parts += place([blade], (0, 0, 94), around, Matrix.Translation(metres((out, 0, 0))))
    return parts


def leaf_blade(material, long, wide, lean, twist, steps=14):
    """A channelled leaf growing up from the origin, leaning towards +x and turning about itself."""
    vertices, faces, across = [], [], (-1.0, -0.5, 0.0, 0.5, 1.0)
    for step in range(steps + 1):
        share = step / steps
        half = wide / 2 * (0.55 + 1.1 * share) * (1 - share**2.6) + 0.3
        turn = math.radians(90 + twist * share)
        middle = lean * long * (share + 0.8 * share * share)
        for side in across:
            x, y = 0.35 * half * (1 - side * side), side * half
            x, y = x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)
            vertices.append((middle + x, y, long * share))
    for step in range(steps):
        for side in range(len(across) - 1):
            a = step * len(across) + side
            faces.append((a, a + 1, a + 1 + len(across), a + len(across)))
    return add_mesh("leaf", vertices, faces, material, smooth_degrees=80)
