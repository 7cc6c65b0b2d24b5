"""Renders the photo of the bookshelf example: six volumes of a set on a wooden desk by a window.

Everything is procedural and seeded.  Lengths are millimetres (made metres once, in common.metres).
World frame: z up, the table top at z = 0, x along the row of books, y to the back; the row's box
starts at the origin and its spines face -y.
"""

import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import common
import materials
import props

WIDE, DEEP, HIGH = 200.0, 178.0, 240.0  # the row of books
VOLUMES = 6
WALL_Y = 560.0

CAMERA = common.Camera(
    target=(108.0, 85.0, 147.0), distance=960.0, turn=34.0, elevation=27.0, view=52.0
)


def build_room():
    oak = materials.wood("oak", light=(0.50, 0.285, 0.14), dark=(0.22, 0.105, 0.045))
    common.add_box("table", (-2600, -900, -32), (1500, WALL_Y - 8, 0), oak, bevel=2)
    paint = materials.plaster("wall paint", (0.74, 0.72, 0.67))
    common.add_box("wall", (-4000, WALL_Y, -1200), (4000, WALL_Y + 100, 2600), paint)


def build_books():
    """The row: every book a little different, the whole still WIDE x DEEP x HIGH."""
    chance = random.Random(6)
    paper = materials.pages("paper", (0.80, 0.71, 0.54))
    headband = materials.cloth("headband", (0.45, 0.10, 0.07))
    gilt = materials.plain("gilt", (0.72, 0.50, 0.20), roughness=0.34, Metallic=0.85)
    label = materials.cloth("label cloth", (0.035, 0.030, 0.028), thread=0.9)
    pitch = WIDE / VOLUMES
    row = []
    for volume in range(VOLUMES):
        outermost = volume in (0, VOLUMES - 1)
        thick = pitch - 0.6
        high = HIGH - (0.0 if outermost else chance.uniform(0.1, 0.9))
        yaw = chance.uniform(-0.08, 0.08) if outermost else chance.uniform(-0.28, 0.28)
        back = 0.05 if outermost else chance.uniform(0.1, 0.7)
        shift = {0: -0.25, VOLUMES - 1: 0.25}.get(volume, 0.0)
        look = {"cover": book_cloth(volume, chance), "paper": paper, "band_cloth": headband}
        look |= {"gilt": gilt, "label": label, "marks": volume + 1}
        book = props.hardback(thick, DEEP - 0.1, high, **look)
        row += common.place(book, ((volume + 0.5) * pitch + shift, back, 0), yaw)
    check_size(row)
    return row


def book_cloth(volume, chance):
    """Cloth of one dye lot that has faded differently."""
    fade = chance.uniform(0.85, 1.2)
    warm = chance.uniform(-0.015, 0.02)
    colour = (0.030 * fade + max(warm, 0), 0.105 * fade, (0.125 - warm) * fade)
    return materials.cloth(f"cloth {volume + 1}", colour)


def check_size(row):
    low, high = common.bounds(row)
    for found, wanted in zip(low + high, [0, 0, 0, WIDE, DEEP, HIGH], strict=True):
        if abs(found - wanted) > 1.0:
            raise ValueError(f"the row of books is not in its box: {low} to {high}")


def build_other_things():
    glaze = materials.plain("glaze", (0.78, 0.74, 0.66), roughness=0.2)
    coffee = materials.plain("coffee", (0.035, 0.014, 0.006), roughness=0.08)
    common.place(props.mug(glaze, coffee), (-205, 130, 0), 215)

    ochre = materials.plain("pencil paint", (0.62, 0.33, 0.05), roughness=0.3, Clearcoat=0.5)
    cedar = materials.plain("cedar", (0.60, 0.36, 0.20), roughness=0.7)
    lead = materials.plain("lead", (0.03, 0.03, 0.035), roughness=0.4)
    common.place(props.pencil(ochre, cedar, lead), (-130, -150, 0), 20)

    kraft = materials.cloth("notebook cover", (0.30, 0.085, 0.05), thread=0.8)
    white = materials.plain("notebook paper", (0.80, 0.76, 0.68), roughness=0.9)
    strap = materials.plain("strap", (0.03, 0.03, 0.03), roughness=0.7)
    common.place(props.notebook(kraft, white, strap), (395, 330, 0), -58)

    pot = materials.clay("pot", (0.52, 0.22, 0.115))
    soil = materials.clay("soil", (0.05, 0.035, 0.025))
    green = materials.leaf("leaf", dark=(0.022, 0.075, 0.028), light=(0.12, 0.22, 0.085))
    common.place(props.plant(pot, soil, green), (-560, 390, 0), 20)


def light_room():
    bars = materials.plain("window bars", (0.6, 0.6, 0.6))
    common.add_window_light(
        (-1450, -620, 1050), (50, 100, 100), (850, 1150), watts=92, glazing_bar=bars
    )
    common.set_room_fill((1.0, 0.97, 0.93), 0.27)


def main():
    wanted = common.parse_arguments("The bookshelf example's photo")
    common.empty_scene()
    build_room()
    build_books()
    build_other_things()
    light_room()
    about = "The true camera and books of desk.jpg, kept for checking a reconstruction only."
    books = {"height_mm": HIGH, "depth_mm": DEEP, "width_mm": WIDE}
    books["corners_world_mm"] = common.box_corners((0.0, 0.0, 0.0), (WIDE, DEEP, HIGH))
    tone = {"exposure": 0.2, "look": "Medium High Contrast"}
    common.finish(wanted, CAMERA, about, books=books, **tone)


main()
