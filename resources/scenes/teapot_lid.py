"""Renders the photo of the teapot lid example: a teapot without a lid on a tiled kitchen counter.

Lengths are millimetres.  World frame: z up, the counter at z = 0, y to the back; the tiles' joints
run along x and y through the origin.
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import common
import materials
import tableware
from mathutils import Matrix

TILE = 150.0
POT_AT = (75.0, 70.0)

CAMERA = common.Camera(
    target=(72.0, 60.0, 58.0), distance=790.0, turn=13.0, elevation=35.0, view=43.0
)


def build_room():
    tiles = materials.tiles("tiles", (0.60, 0.68, 0.66), (0.30, 0.29, 0.27), TILE)
    common.add_box("counter", (-1500, -600, -30), (1800, 430, 0), tiles)
    wall = materials.tiles("wall tiles", (0.82, 0.80, 0.75), (0.55, 0.53, 0.49), 100.0, 2.0)
    board = common.add_box("wall", (-2000, -400, 0), (2000, 1600, 20), wall)
    upright = Matrix.Rotation(math.radians(90), 4, "X")
    common.place([board], (0, 455, 400), 0, upright)


def build_things():
    glaze = materials.plain("pot glaze", (0.10, 0.20, 0.30), roughness=0.18, Clearcoat=0.4)
    common.place(tableware.teapot(glaze), (*POT_AT, 0), 205)

    white = materials.plain("glaze", (0.80, 0.77, 0.70), roughness=0.2)
    tea = materials.plain("tea", (0.20, 0.06, 0.012), roughness=0.06)
    common.place(tableware.teacup(white, tea), (270, -35, 0), -55)
    peel = materials.clay("peel", (0.82, 0.58, 0.06))
    lying = Matrix.Translation(common.metres((0, 0, 30))) @ Matrix.Rotation(1.57, 4, "Y")
    common.place(tableware.lemon(peel), (330, 165, 0), 35, lying)
    common.place(tableware.lemon(peel), (255, 215, 0), -40, lying)

    linen = materials.fabric("linen", (0.74, 0.70, 0.60), (0.46, 0.12, 0.09))
    towel = common.add_box("towel", (-105, -160, 0.1), (105, 160, 3.0), linen, bevel=1.2)
    common.place([towel], (-205, -30, 0), 24)
    steel = materials.steel("spoon", (0.75, 0.75, 0.76), 0.2)
    common.place(tableware.spoon(steel), (-245, -60, 3), 62)


def light_room():
    bars = materials.plain("window bars", (0.6, 0.6, 0.6))
    common.add_window_light(
        (-900, -700, 1250), (50, 50, 50), (900, 900), watts=40, glazing_bar=bars
    )
    common.set_room_fill((1.0, 0.97, 0.93), 0.24)


def main():
    wanted = common.parse_arguments("The teapot lid example's photo")
    common.empty_scene()
    build_room()
    build_things()
    light_room()
    about = "The true camera and things of kitchen.jpg, kept for checking a reconstruction only."
    pot = {
        "rim_diameter_mm": 2 * tableware.RIM_RADIUS,
        "rim_height_mm": tableware.RIM_HIGH,
        "foot_diameter_mm": 2 * tableware.FOOT_RADIUS,
        "middle_mm": [*POT_AT, 0.0],
    }
    tone = {"exposure": 0.1, "look": "Medium High Contrast"}
    common.finish(wanted, CAMERA, about, tile_mm=TILE, teapot=pot, **tone)


main()
