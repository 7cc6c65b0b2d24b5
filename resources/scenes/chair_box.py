"""Renders the photo of the chair box example: a wooden chair in a living room, by a wide lens.

Lengths are millimetres.  World frame: z up, the floor at z = 0, y to the back, the middle of the
chair's seat above the origin.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import common
import furniture
import materials
import props

CAMERA = common.Camera(
    target=(20.0, 0.0, 400.0), distance=1750.0, turn=-31.0, elevation=24.0, view=66.0
)


def build_room():
    oak = materials.wood("parquet", (0.46, 0.30, 0.17), (0.26, 0.14, 0.065), plank=120.0)
    common.add_box("floor", (-3500, -3500, -30), (3500, 900, 0), oak)
    paint = materials.plaster("wall paint", (0.60, 0.52, 0.42))
    common.add_box("wall", (-4000, 900, -200), (4000, 1000, 2800), paint)
    white = materials.plain("skirting", (0.78, 0.76, 0.72), roughness=0.5)
    common.add_box("skirting", (-4000, 884, 0), (4000, 902, 90), white, bevel=3)


def build_things():
    beech = materials.wood("beech", (0.55, 0.33, 0.17), (0.36, 0.19, 0.09), plank=400.0)
    seat = materials.wood("seat", (0.42, 0.24, 0.12), (0.26, 0.13, 0.06), plank=140.0)
    common.place(furniture.chair(beech, seat), (0, 0, 0))

    wool = materials.fabric("rug", (0.30, 0.34, 0.34), (0.55, 0.50, 0.40), pitch=170.0)
    rug = common.add_box("rug", (-700, -420, 0.5), (700, 420, 9), wool, bevel=3)
    common.place([rug], (1050, -260, 0), 0)

    rope = materials.clay("rope", (0.50, 0.36, 0.20))
    common.place(furniture.basket(rope), (-640, 600, 0))
    pot = materials.clay("pot", (0.30, 0.31, 0.30))
    soil = materials.clay("soil", (0.05, 0.035, 0.025))
    green = materials.leaf("leaf", dark=(0.022, 0.075, 0.028), light=(0.12, 0.22, 0.085))
    plant = props.plant(pot, soil, green, seed=9)
    common.place(plant, (-640, 600, 60))


def light_room():
    bars = materials.plain("window bars", (0.6, 0.6, 0.6))
    common.add_window_light(
        (-2300, -1100, 1700), (0, 0, 200), (1500, 1700), watts=185, glazing_bar=bars
    )
    common.set_room_fill((1.0, 0.95, 0.88), 0.25)


def main():
    wanted = common.parse_arguments("The chair box example's photo")
    common.empty_scene()
    build_room()
    build_things()
    light_room()
    about = "The true camera and things of room.jpg, kept for checking a reconstruction only."
    outside = furniture.SEAT_WIDE - 24, furniture.SEAT_DEEP - 24
    chair = {
        "legs_width_mm": outside[0],
        "legs_depth_mm": outside[1],
        "between_legs_mm": outside[0] - 2 * furniture.LEG,
        "under_apron_mm": furniture.SEAT_HIGH - furniture.SEAT_THICK - furniture.APRON,
        "seat_height_mm": furniture.SEAT_HIGH,
    }
    common.finish(wanted, CAMERA, about, 0.15, "Medium High Contrast", chair=chair)


main()
