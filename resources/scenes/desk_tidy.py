"""Renders the photo of the desk tidy example: a dark desk in the evening, seen from low down.

The photo is cropped, so that its principal point is not in its middle.  Lengths are millimetres.
World frame: z up, the desk's top at z = 0, y to the back.
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import common
import materials
import props
import stationery
from mathutils import Matrix

#: The paperback: wide, long, thick; it lies straight on the desk.
BOOK, BOOK_AT = (115.0, 180.0, 24.0), (-205.0, 40.0)

CAMERA = common.Camera(
    target=(0.0, 30.0, 75.0),
    distance=720.0,
    turn=36.0,
    elevation=23.0,
    view=56.0,
    size_px=(1600, 1100),
    shift=(150.0, -90.0),
)


def build_room():
    walnut = materials.wood("walnut", (0.20, 0.105, 0.055), (0.085, 0.04, 0.02), plank=140.0)
    common.add_box("desk", (-1600, -900, -30), (1500, 480, 0), walnut, bevel=2)
    paint = materials.plaster("wall paint", (0.16, 0.24, 0.20))
    common.add_box("wall", (-4000, 490, -1200), (4000, 590, 2600), paint)


def build_things():
    cover = materials.plain("cover", (0.50, 0.10, 0.05), roughness=0.5)
    paper = materials.plain("paper", (0.82, 0.75, 0.60), roughness=0.9)
    cream = materials.plain("cream", (0.85, 0.76, 0.58), roughness=0.6)
    book = stationery.paperback(cover, paper, *BOOK) + stationery.paperback_label(cream, *BOOK)
    common.place(book, (*BOOK_AT, 0))

    stone = materials.clay("stoneware", (0.42, 0.40, 0.36))
    common.place(stationery.jar(stone), (-330, 300, 0))
    paints = ((0.05, 0.13, 0.28), (0.62, 0.33, 0.05), (0.03, 0.03, 0.03), (0.45, 0.05, 0.05))
    for number, colour in enumerate(paints):
        paint = materials.plain(f"pen {number}", colour, roughness=0.3, Clearcoat=0.5)
        lean = Matrix.Rotation(math.radians(9 + 2 * number), 4, "X")
        turn = 40 + 97 * number
        away = math.radians(turn)
        spot = (-330 - 18 * math.sin(away), 300 + 18 * math.cos(away), 6)
        common.place(stationery.leaning_pen(paint, cream, 158 - 6 * number), spot, turn, lean)

    case = materials.plain("case", (0.55, 0.56, 0.58), roughness=0.3, Metallic=0.8)
    glass = materials.plain("glass", (0.012, 0.013, 0.016), roughness=0.06, Clearcoat=0.6)
    common.place(stationery.telephone(case, glass), (60, -190, 0), 62)

    pot = materials.clay("pot", (0.52, 0.22, 0.115))
    soil = materials.clay("soil", (0.05, 0.035, 0.025))
    green = materials.leaf("leaf", dark=(0.022, 0.075, 0.028), light=(0.12, 0.22, 0.085))
    common.place(props.plant(pot, soil, green, seed=5), (-40, 385, 0), 70)


def light_room():
    bars = materials.plain("lamp bars", (0.9, 0.8, 0.6))
    common.add_window_light(
        (-520, -340, 640), (0, 40, 0), (300, 300), watts=10.5, glazing_bar=bars, panes=(1, 1)
    )
    common.set_room_fill((1.0, 0.86, 0.70), 0.22)


def main():
    wanted = common.parse_arguments("The desk tidy example's photo")
    common.empty_scene()
    build_room()
    build_things()
    light_room()
    about = "The true camera and things of evening.jpg, kept for checking a reconstruction only."
    low = (BOOK_AT[0] - BOOK[0] / 2, BOOK_AT[1] - BOOK[1] / 2, 0.0)
    high = (BOOK_AT[0] + BOOK[0] / 2, BOOK_AT[1] + BOOK[1] / 2, BOOK[2])
    book = {"width_mm": BOOK[0], "length_mm": BOOK[1], "height_mm": BOOK[2]}
    book["corners_world_mm"] = common.box_corners(low, high)
    common.finish(wanted, CAMERA, about, 0.35, "Medium High Contrast", book=book)


main()
