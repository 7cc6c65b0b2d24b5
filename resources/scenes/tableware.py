"""Things for the kitchen's scenes: teapot, teacup, plate, spoon, lemon, the printed sheet.

In millimetres and built about the origin; each builder returns the list of its objects, for
`common.place`.
"""

import math
import re

from common import add_box, add_lathe, add_tube

#: The teapot's rim, on which a lid will lie.
RIM_RADIUS, RIM_HIGH = 44.0, 121.0
FOOT_RADIUS = 45.0
#: The teacup.
CUP_FOOT, CUP_RIM, CUP_HIGH = 27.0, 46.0, 66.0


def rounded(middle_radius, high, half=1.5, steps=6):
    """Points over a round rim, from the outside to the inside."""
    turns = [math.pi * step / steps for step in range(steps + 1)]
    return [(middle_radius + half * math.cos(a), high - half + half * math.sin(a)) for a in turns]


def smooth(points, steps=8):
    """A Catmull-Rom curve through (radius, z) points."""
    found = []
    for i in range(len(points) - 1):
        a, b = points[max(i - 1, 0)], points[i]
        c, d = points[i + 1], points[min(i + 2, len(points) - 1)]
        for step in range(steps):
            t = step / steps
            found.append(
                tuple(
                    0.5
                    * (
                        2 * q
                        + (r - p) * t
                        + (2 * p - 5 * q + 4 * r - s) * t * t
                        + (3 * q - p - 3 * r + s) * t**3
                    )
                    for p, q, r, s in zip(a, b, c, d, strict=True)
                )
            )
    return [*found, points[-1]]


def teapot(glaze):
    """A round pot, its spout towards +x and its handle towards -x; the rim's top is RIM_HIGH."""
    foot, rim = FOOT_RADIUS, RIM_RADIUS
    belly = smooth([(foot, 6), (70, 30), (80, 60), (70, 92), (52, 108), (rim, 114)])
    outer = [(0, 2), (foot - 6, 2), (foot - 5, 0), (foot - 1, 0), (foot, 1.5)]
    lip = rounded(rim - 2.5, RIM_HIGH, 2.5)
    inner = smooth([(rim - 5, 112), (48, 104), (66, 90), (75, 60), (64, 30), (30, 10), (0, 9)])
    body = add_lathe("teapot", [*outer, *belly, *lip, *inner], glaze)
    path = [(66, 0, 40), (98, 0, 58), (112, 0, 86), (128, 0, 112), (140, 0, 118)]
    spout = add_tube("spout", path, 10.0, glaze, taper=[1.9, 1.5, 1.05, 0.85, 0.75])
    path = [(-68, 0, 92), (-96, 0, 104), (-122, 0, 84), (-116, 0, 52), (-76, 0, 34)]
    handle = add_tube("handle", path, 6.5, glaze)
    return [body, spout, handle]


def teacup(glaze, tea):
    """A cup with its handle towards +x, standing without a saucer."""
    side = smooth([(CUP_FOOT, 5), (38, 18), (44, 42), (CUP_RIM, CUP_HIGH - 2)])
    foot = [(0, 3), (CUP_FOOT - 5, 3), (CUP_FOOT - 4, 0), (CUP_FOOT - 0.5, 0), (CUP_FOOT, 0.8)]
    inner = smooth([(CUP_RIM - 3, CUP_HIGH - 3), (41, 42), (34, 18), (18, 7), (0, 6)])
    body = add_lathe("cup", [*foot, *side, *rounded(CUP_RIM - 1.5, CUP_HIGH), *inner], glaze)
    surface = add_lathe("tea", [(0, 50), (42.3, 50)], tea)
    path = [(42, 0, 54), (58, 0, 57), (69, 0, 44), (60, 0, 28), (38, 0, 21)]
    return [body, surface, add_tube("handle", path, 3.6, glaze)]


def plate(glaze, radius=85.0):
    """A dessert plate."""
    under = [(0, 2), (radius * 0.55, 2), (radius * 0.58, 0), (radius * 0.62, 0)]
    outer = smooth([(radius * 0.62, 1), (radius * 0.85, 9), (radius, 14)])
    inner = smooth([(radius - 2, 16), (radius * 0.82, 11.5), (radius * 0.62, 5), (0, 4.6)])
    return [add_lathe("plate", [*under, *outer, *inner], glaze)]


def biscuit(dough, radius=27.0, thick=8.0):
    """A round biscuit."""
    profile = [(0, 0), (radius - 3, 0), *rounded(radius - thick / 2, thick, thick / 2)[:4]]
    return [add_lathe("biscuit", [*profile, (0, thick - 0.5)], dough, segments=40)]


def lemon(peel, long=86.0, radius=31.0):
    """A lemon standing on its end; tip it to lay it down."""
    half = long / 2
    points = [(0, -half), (6, -half + 3), (18, -half + 13), (radius, 0), (18, half - 13)]
    return [add_lathe("lemon", smooth([*points, (6, half - 3), (0, half)]), peel)]


def spoon(metal, long=132.0):
    """A tea spoon lying along +x."""
    bowl = add_lathe("bowl", smooth([(0, 1.2), (9, 2.2), (13, 5.0), (14, 6.4)]), metal)
    bowl.scale = (1.45, 1.0, 1.0)
    path = [(16, 0, 6), (34, 0, 8), (74, 0, 5), (long, 0, 2.5)]
    handle = add_tube("stem", path, 3.0, metal, taper=[0.7, 0.6, 0.8, 1.3])
    return [bowl, handle]


def printed_sheet(svg, paper, ink):
    """The printed marker, from its own SVG file: the paper and all that is black on it."""
    text = svg.read_text(encoding="utf-8")
    wide, tall = (float(n) for n in re.search(r'viewBox="0 0 (\S+) (\S+)"', text).groups())
    sheet = add_box("sheet", (-wide / 2, -tall / 2, 0.02), (wide / 2, tall / 2, 0.12), paper)
    parts = [sheet]
    layers = {"marker": (0.14, ink), "pattern": (0.16, paper), "scale": (0.14, ink)}
    for name, (level, material) in layers.items():
        path = re.search(rf'id="{name}"[^>]*? d="([^"]+)"', text).group(1)
        for box in re.findall(r"M (\S+) (\S+) h (\S+) v (\S+)", path):
            x, y, w, h = (float(n) for n in box)
            low = (x - wide / 2, tall / 2 - y - h, level - 0.01)
            parts.append(add_box(name, low, (low[0] + w, low[1] + h, level), material))
    return parts
