"""Things for the room's scene: a wooden chair, a basket.

In millimetres and built about the origin; each builder returns the list of its objects, for
`common.place`.
"""

from common import add_box, add_lathe

#: The chair's seat and legs.
SEAT_WIDE, SEAT_DEEP, SEAT_HIGH = 430.0, 420.0, 450.0
SEAT_THICK, LEG, APRON = 24.0, 36.0, 58.0


def chair(wood, seat):
    """A chair facing -y, the seat's middle above the origin; its four legs are upright."""
    x, y, under = SEAT_WIDE / 2 - 12, SEAT_DEEP / 2 - 12, SEAT_HIGH - SEAT_THICK
    parts = []
    for sx in (-1, 1):
        for sy, high in ((-1, under), (1, 860.0)):
            low = (min(sx * x, sx * (x - LEG)), min(sy * y, sy * (y - LEG)), 0)
            leg = add_box("leg", low, (low[0] + LEG, low[1] + LEG, high), wood, bevel=3)
            parts.append(leg)
    for sx in (-1, 1):
        side = sx * (x - LEG / 2)
        low = (side - 10, -y + LEG, under - APRON)
        parts.append(add_box("apron", low, (side + 10, y - LEG, under), wood, bevel=2))
    for sy in (-1, 1):
        front = sy * (y - LEG / 2)
        low = (-x + LEG, front - 10, under - APRON)
        parts.append(add_box("apron", low, (x - LEG, front + 10, under), wood, bevel=2))
    low = (-SEAT_WIDE / 2, -SEAT_DEEP / 2, under)
    board = add_box("seat", low, (SEAT_WIDE / 2, y - LEG, SEAT_HIGH), seat, bevel=7)
    for z in (590.0, 690.0, 790.0):
        back = (-x + LEG, y - LEG / 2 - 9, z)
        parts.append(add_box("slat", back, (x - LEG, y - LEG / 2 + 9, z + 52), wood, bevel=4))
    return [*parts, board]


def basket(weave, radius=150.0, high=240.0):
    """A round basket of wound rope, open above."""
    profile = [(0, 6), (radius * 0.82, 6)]
    turns = 12
    for k in range(turns):
        z, share = high * k / turns, k / turns
        out = radius * (0.84 + 0.16 * share)
        step = high / turns
        profile += [(out - 3, z), (out + 2, z + step * 0.3), (out + 2, z + step * 0.7)]
    profile += [(radius - 4, high), (radius - 12, high - 4), (radius * 0.8, 14), (0, 12)]
    return [add_lathe("basket", profile, weave)]
