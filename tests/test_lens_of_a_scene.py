"""An example's photo as a lens bends it: said with numbers, and put right by what is traced."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image
from scipy.ndimage import map_coordinates

from incontext.solver import load_sketch, save_sketch
from incontext.solver.camera import Camera
from incontext.solver.graph import Photo, SketchGraph
from incontext.workbench.cli import main
from incontext.workbench.examples import load_example
from incontext.workbench.lens import Lens
from incontext.workbench.photos import grey_of, load_photo

WIDE, HIGH = 1800, 1200
#: What a person traces in the straight photo: the sheet of A5, and the mat's borders.
SHEET = np.array([[842.0, 170], [1518, 288], [1432, 622], [692, 478]])
BORDERS = np.array(
    [[[20.0, 993], [1727, 1136]], [[1704, 370], [1765, 1090]], [[190, 260], [10, 735]]]
)
#: Places on the mat, whose distances are measured.
MEASURED = np.array([[300.0, 900], [1500, 1000], [1600, 400], [200, 400]])


@pytest.fixture(scope="module")
def example():
    return load_example("scissors_cover")


def camera_of(told):
    names = ("focal_px", "principal_point_px", "rotation_cam_from_world")
    where = told["translation_cam_from_world_mm"]
    return Camera(told[names[0]], *(np.array(told[n]) for n in names[1:]), np.array(where))


def distances(camera, places):
    """Between places on the ground, in order around, mm."""
    rays = np.column_stack([(places - camera.principal_point_px) / camera.focal_px, np.ones(4)])
    rays, eye = rays @ camera.rotation_cam_from_world, camera.position_mm
    on_ground = eye - rays * (eye[2] / rays[:, 2])[:, None]
    return np.linalg.norm(on_ground - np.roll(on_ground, 1, axis=0), axis=1)


def bent_sketch(example, lens, folder):
    """The photo through the lens, with what is traced in it, 2 px off."""
    photo, _ = load_photo(load_sketch(example.sketch_path), example.sketch_path)
    u, v = np.meshgrid(np.arange(WIDE) + 0.5, np.arange(HIGH) + 0.5)
    at = lens.straightened(np.stack([u, v], axis=-1)) - 0.5
    bent = map_coordinates(grey_of(photo), [at[..., 1], at[..., 0]], order=1, mode="nearest")
    Image.fromarray(np.rint(bent).astype(np.uint8)).save(folder / "mat.png")
    places = np.concatenate([SHEET, BORDERS.reshape(-1, 2)])
    drawn = lens.bent(places + np.random.default_rng(1).uniform(-2, 2, places.shape))
    lines = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (6, 7), (8, 9)]
    edges = {f"e{k}": (f"v{a}", f"v{b}") for k, (a, b) in enumerate(lines)}
    graph = SketchGraph(
        photo=Photo("mat.png", WIDE, HIGH),
        vertices={f"v{k}": (u, v) for k, (u, v) in enumerate(drawn.tolist())},
        edges=edges,
        construction=tuple(edges),
    )
    save_sketch(graph, folder / "mat.sketch.json")
    return folder / "mat.sketch.json"


def camera_by_the_sheet(sketch, folder):
    """As the command finds it, by the sheet's corners as they are drawn."""
    corners = [f"{u},{v}" for u, v in list(load_sketch(sketch).vertices.values())[:4]]
    found = folder / "found.sketch.json"
    # What is drawn has no angles yet that would tell of the camera.
    alone = ["--size", "A5", "--corners", *corners, "-o", str(found)]
    assert main(["camera", str(sketch), *alone]) == 0
    return load_sketch(found).camera


@pytest.mark.parametrize("k", [-0.1, 0.06])
def test_a_bent_photo_is_said_to_be_and_measures_right_once_straight(example, k, tmp_path, capsys):
    lens = Lens(np.array([WIDE, HIGH]) / 2, float(np.hypot(WIDE, HIGH)) / 2, k, 0.0, {})
    bent = bent_sketch(example, lens, tmp_path)
    true = distances(camera_of(example.truth["camera"]), MEASURED)
    before = distances(camera_by_the_sheet(bent, tmp_path), lens.bent(MEASURED)) / true - 1
    assert np.abs(before).max() > 0.02

    straight = tmp_path / "straight.sketch.json"
    capsys.readouterr()
    assert main(["straighten", str(bent), "-o", str(straight)]) == 0
    said = capsys.readouterr().out
    told = float(said.split("distorts, by ")[1].split(" %")[0])
    assert told == pytest.approx(100 * abs(k), abs=0.4)
    after = distances(camera_by_the_sheet(straight, tmp_path), MEASURED) / true - 1
    assert np.abs(after).max() < 0.01
