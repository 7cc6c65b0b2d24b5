"""Renders the photo of the cup saucer example: a cup beside the printed marker, held upright.

Lengths are millimetres.  World frame: z up, the table's top at z = 0, y to the back, the marker's
middle at the origin.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import common
import materials
import tableware

MARKER = 100.0
#: The marker's square in the middle of its sheet, which lies so far beside the origin.
SHEET_AT = (18.0, -30.0)
SHEET_SVG = Path(__file__).resolve().parent.parent / "examples" / "cup_saucer" / "marker.svg"
CUP_AT = (-12.0, 192.0)

CAMERA = common.Camera(
    target=(-8.0, 105.0, 15.0),
    distance=610.0,
    turn=-17.0,
    elevation=42.0,
    view=37.0,
    size_px=(1200, 1600),
)
#: What the camera writes into the photo: its 35 mm equivalent.
FOCAL_35MM = 39


def build_room():
    cherry = materials.wood("cherry", (0.42, 0.19, 0.095), (0.22, 0.085, 0.04), plank=120.0)
    common.add_box("table", (-1500, -700, -30), (1500, 900, 0), cherry, bevel=2)
    paint = materials.plaster("wall paint", (0.80, 0.70, 0.58))
    common.add_box("wall", (-4000, 1500, -1200), (4000, 1600, 2600), paint)


def build_things():
    paper = materials.plain("paper", (0.84, 0.84, 0.82), roughness=0.9)
    ink = materials.plain("ink", (0.018, 0.018, 0.02), roughness=0.75)
    common.place(tableware.printed_sheet(SHEET_SVG, paper, ink), (*SHEET_AT, 0), 0)

    glaze = materials.plain("glaze", (0.80, 0.78, 0.72), roughness=0.16)
    tea = materials.plain("tea", (0.24, 0.075, 0.015), roughness=0.06)
    common.place(tableware.teacup(glaze, tea), (*CUP_AT, 0), 15)

    blue = materials.plain("blue glaze", (0.16, 0.30, 0.34), roughness=0.2)
    dough = materials.clay("biscuit", (0.55, 0.31, 0.12))
    common.place(tableware.plate(blue), (-185, 330, 0))
    for x, y, z in ((-198, 342, 5), (-168, 318, 5), (-184, 332, 13)):
        common.place(tableware.biscuit(dough), (x, y, z))
    steel = materials.steel("spoon", (0.75, 0.75, 0.76), 0.2)
    common.place(tableware.spoon(steel), (75, 285, 0), 52)


def light_room():
    bars = materials.plain("window bars", (0.6, 0.6, 0.6))
    common.add_window_light((900, 900, 950), (0, 120, 0), (1000, 800), watts=40, glazing_bar=bars)
    common.set_room_fill((1.0, 0.95, 0.88), 0.34)


def main():
    wanted = common.parse_arguments("The cup saucer example's photo")
    common.empty_scene()
    build_room()
    build_things()
    light_room()
    about = "The true camera and things of table.jpg, kept for checking a reconstruction only."
    cup = {
        "foot_diameter_mm": 2 * tableware.CUP_FOOT,
        "rim_diameter_mm": 2 * tableware.CUP_RIM,
        "rim_height_mm": tableware.CUP_HIGH,
        "middle_mm": [*CUP_AT, 0.0],
    }
    tone = {"exposure": 0.1, "look": "Medium High Contrast", "exif": FOCAL_35MM}
    common.finish(wanted, CAMERA, about, marker_mm=MARKER, cup=cup, **tone)


main()
