"""Renders the photo of the scissors cover example: scissors on a cutting mat beside a sheet of A5.

Lengths are millimetres.  World frame: z up, the mat's top at z = 0, y to the back.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import common
import materials
import props
import stationery

A5 = (210.0, 148.0)
SHEET_AT, SHEET_TURN = (70.0, 130.0), -7.0
SCISSORS_AT, SCISSORS_TURN = (-35.0, -35.0), -16.0
MAT_THICK = 2.0

CAMERA = common.Camera(
    target=(22.0, 30.0, 0.0),
    distance=980.0,
    turn=9.0,
    elevation=44.0,
    view=28.0,
    size_px=(1800, 1200),
)


def build_room():
    ash = materials.wood("ash", (0.58, 0.44, 0.30), (0.36, 0.24, 0.14), plank=100.0)
    table = common.add_box("table", (-1200, -700, -32), (1200, 900, -MAT_THICK), ash, bevel=2)
    table.location = (0, 0, 0)
    base = materials.plain("mat", (0.035, 0.12, 0.105), roughness=0.62)
    line = materials.plain("grid", (0.45, 0.58, 0.50), roughness=0.7)
    common.place(stationery.cutting_mat(base, line), (20, 20, -MAT_THICK - 0.03), 3)


def build_things():
    steel = materials.steel("blades", (0.66, 0.67, 0.69), 0.24)
    red = materials.plain("handles", (0.55, 0.055, 0.03), roughness=0.35)
    pair = stationery.scissors(steel, red)
    common.place(pair, (*SCISSORS_AT, 0), SCISSORS_TURN)

    paper = materials.plain("paper", (0.83, 0.82, 0.78), roughness=0.9)
    wide, deep = A5[0] / 2, A5[1] / 2
    sheet = common.add_box("sheet", (-wide, -deep, 0.02), (wide, deep, 0.14), paper)
    common.place([sheet], (*SHEET_AT, 0), SHEET_TURN)

    wood = materials.plain("spool", (0.60, 0.40, 0.22), roughness=0.6)
    threads = ((0.05, 0.16, 0.30), (0.62, 0.40, 0.07), (0.50, 0.10, 0.12))
    for colour, at in zip(threads, ((-165, 95), (-135, 128), (-188, 132)), strict=True):
        thread = materials.cloth(f"thread {at[0]}", colour, thread=0.7)
        common.place(stationery.spool(wood, thread), (*at, 0))
    ochre = materials.plain("pencil paint", (0.08, 0.20, 0.30), roughness=0.3, Clearcoat=0.33)
    cedar = materials.plain("cedar", (0.60, 0.36, 0.20), roughness=0.7)
    lead = materials.plain("lead", (0.03, 0.03, 0.035), roughness=0.4)
    common.place(props.pencil(ochre, cedar, lead), (20, 112, 0.1), 18)


def light_room():
    bars = materials.plain("window bars", (0.6, 0.6, 0.6))
    common.add_window_light((-700, 800, 1000), (0, 40, 0), (800, 900), watts=31, glazing_bar=bars)
    common.set_room_fill((0.95, 0.98, 1.0), 0.33)


def main():
    wanted = common.parse_arguments("The scissors cover example's photo")
    common.empty_scene()
    build_room()
    build_things()
    light_room()
    about = "The true camera and things of mat.jpg, kept for checking a reconstruction only."
    blades = {
        "length_mm": stationery.BLADES_LONG,
        "width_mm": stationery.BLADES_WIDE,
        "height_mm": stationery.BLADES_HIGH,
        "from_mm": [*SCISSORS_AT, 0.0],
        "turn_deg": SCISSORS_TURN,
    }
    tone = {"exposure": 0.05, "look": "Medium High Contrast"}
    common.finish(wanted, CAMERA, about, sheet_mm=A5, blades=blades, **tone)


main()
