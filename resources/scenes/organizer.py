"""Renders the photo of the organizer example: stationery all over a light desk in the morning.

Lengths are millimetres.  World frame: z up, the desk's top at z = 0, y to the back.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import common
import materials
import props
import stationery

#: The block of sticky notes, which is a little turned.
NOTES_SIDE, NOTES_HIGH, NOTES_AT, NOTES_TURN = 76.0, 38.0, (-190.0, -70.0), 8.0

CAMERA = common.Camera(
    target=(-5.0, 35.0, 25.0), distance=1020.0, turn=-24.0, elevation=36.0, view=40.0
)


def build_room():
    birch = materials.wood("birch", (0.66, 0.52, 0.36), (0.48, 0.35, 0.22), plank=160.0)
    common.add_box("desk", (-1400, -900, -26), (1600, 640, 0), birch, bevel=2)
    paint = materials.plaster("wall paint", (0.36, 0.47, 0.52))
    common.add_box("wall", (-4000, 650, -1200), (4000, 750, 2600), paint)


def build_things():
    colours = ((0.86, 0.70, 0.13), (0.84, 0.34, 0.27), (0.25, 0.53, 0.62), (0.90, 0.78, 0.22))
    papers = [materials.plain(f"note {n}", c, roughness=0.85) for n, c in enumerate(colours)]
    block = stationery.notes(papers, NOTES_SIDE, NOTES_HIGH)
    common.place(block, (*NOTES_AT, 0), NOTES_TURN)

    case = materials.plain("case", (0.05, 0.05, 0.055), roughness=0.35)
    glass = materials.plain("glass", (0.012, 0.013, 0.016), roughness=0.06, Clearcoat=0.6)
    common.place(stationery.telephone(case, glass), (265, 60, 0), -24)

    cedar = materials.plain("cedar", (0.60, 0.36, 0.20), roughness=0.7)
    lead = materials.plain("lead", (0.03, 0.03, 0.035), roughness=0.4)
    paints = ((0.62, 0.33, 0.05), (0.07, 0.22, 0.33), (0.50, 0.07, 0.06))
    for number, (at, turn) in enumerate((((150, -165), 28), ((60, -190), 12), ((120, -215), 19))):
        paint = materials.plain(f"paint {number}", paints[number], roughness=0.3, Clearcoat=0.5)
        common.place(props.pencil(paint, cedar, lead), (*at, 0), turn)

    wire = materials.steel("wire", roughness=0.2)
    places = (
        (-95, -150, 20),
        (-62, -175, 130),
        (-110, -190, 75),
        (-40, -140, -30),
        (-140, -165, 5),
    )
    for number, (x, y, turn) in enumerate(places):
        common.place(stationery.clip(wire, number), (x, y, 0), turn)

    kraft = materials.cloth("notebook cover", (0.10, 0.20, 0.17), thread=0.8)
    white = materials.plain("notebook paper", (0.80, 0.76, 0.68), roughness=0.9)
    strap = materials.plain("strap", (0.03, 0.03, 0.03), roughness=0.7)
    common.place(props.notebook(kraft, white, strap), (-235, 235, 0), 70)

    glaze = materials.plain("glaze", (0.70, 0.28, 0.16), roughness=0.25)
    coffee = materials.plain("coffee", (0.035, 0.014, 0.006), roughness=0.08)
    common.place(props.mug(glaze, coffee), (255, 300, 0), -30)


def light_room():
    bars = materials.plain("window bars", (0.6, 0.6, 0.6))
    common.add_window_light((1300, -500, 1100), (0, 80, 0), (900, 1200), watts=52, glazing_bar=bars)
    common.set_room_fill((0.93, 0.97, 1.0), 0.30)


def main():
    wanted = common.parse_arguments("The organizer example's photo")
    common.empty_scene()
    build_room()
    build_things()
    light_room()
    about = "The true camera and things of desk.jpg, kept for checking a reconstruction only."
    notes = {"side_mm": NOTES_SIDE, "height_mm": NOTES_HIGH, "middle_mm": [*NOTES_AT, 0.0]}
    notes["turn_deg"] = NOTES_TURN
    common.finish(wanted, CAMERA, about, 0.1, "Medium High Contrast", notes=notes)


main()
