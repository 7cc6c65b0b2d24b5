"""Every shipped example, end to end, against what is expected and what is truly there."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import shapely
import trimesh
from asserts import assert_annotations_hold, assert_solved
from fabrication.test_other_readers import (
    IMPORT_ALL,
    IMPORTER,
    needs,
    paths_in,
    read_by_librecad,
    run,
)
from PIL import Image, ImageOps
from tracing import with_block

from incontext.solver import findings, load_sketch, solve
from incontext.solver.model import build_model
from incontext.workbench.checked import plates_check
from incontext.workbench.cli import main
from incontext.workbench.examples import EXAMPLES, load_example
from incontext.workbench.fabrication import joined_plates
from incontext.workbench.marker_sheet import marker_file

FOLDER = Path(__file__).parent.parent / "resources" / "examples"
#: The largest photo, bytes.
MOST = 500_000


@pytest.fixture(scope="module", params=EXAMPLES)
def example(request):
    return load_example(request.param)


@pytest.fixture(scope="module")
def made(example, tmp_path_factory):
    """The files that ``incontext make`` writes."""
    out = tmp_path_factory.mktemp(example.name)
    words = ["make", str(example.sketch_path), "--out", str(out), *example.options]
    assert main(words) == 0
    return out


def test_every_folder_is_an_example():
    assert sorted(EXAMPLES) == sorted(p.name for p in FOLDER.iterdir() if p.is_dir())
    assert {load_example(name).is_printed for name in EXAMPLES} == {True, False}


def test_photo_is_small_and_of_the_told_size(example):
    photo = load_sketch(example.sketch_path).photo
    path = example.sketch_path.with_name(photo.file)
    assert path.stat().st_size < MOST
    with Image.open(path) as picture:
        upright = ImageOps.exif_transpose(picture)
    assert upright.size == (photo.width_px, photo.height_px)
    assert example.truth["camera"]["image_size_px"] == [photo.width_px, photo.height_px]


def test_no_two_photos_are_alike():
    truths = [load_example(name).truth["camera"] for name in EXAMPLES]
    focals = [round(t["focal_px"] / max(t["image_size_px"]), 2) for t in truths]
    assert len(set(focals)) == len(EXAMPLES)
    cropped = [t for t in truths if t["principal_point_px"] != [s / 2 for s in t["image_size_px"]]]
    portrait = [t for t in truths if t["image_size_px"][1] > t["image_size_px"][0]]
    assert len(cropped) == len(portrait) == 1


def test_portrait_lies_on_its_side_in_the_file():
    with Image.open(FOLDER / "cup_saucer" / "table.jpg") as picture:
        assert picture.width > picture.height
        assert picture.getexif()[0x0112] == 6


def test_sketch_solves_with_every_annotation_exact(example):
    graph = load_sketch(example.sketch_path)
    assert findings(graph) == ()
    solution = solve(graph)
    assert_solved(solution)
    assert_annotations_hold(solution, 500.0)


def test_sketch_is_drawn_by_hand(example):
    """No vertex is where the truth would put it: each is some pixels off what is solved."""
    graph = load_sketch(example.sketch_path)
    if graph.revolutions:
        return
    solution = solve(graph)
    traced = {v for e in graph.construction if e in graph.edges for v in graph.edges[e]}
    off = [px for v, px in solution.report.reprojection_px.items() if v not in traced]
    assert np.sqrt(np.mean(np.square(off))) > 0.5


def test_files_are_what_is_expected(example, made):
    name, facts = example.name, example.facts
    rough = {"rel": facts["tolerance"]}
    if example.is_printed:
        mesh = trimesh.load(made / f"{name}.stl")
        assert mesh.is_watertight
        assert mesh.body_count == 1
        assert mesh.extents == pytest.approx(facts["size_mm"], **rough)
        assert mesh.volume == pytest.approx(facts["volume_mm3"], **rough)
        endings = {".stl", ".3mf", ".step"}
    else:
        plates = json.loads((made / f"{name}.plates.json").read_text())["plates"]
        assert len(plates) == facts["plates"]
        corners = np.concatenate([corners_of(plate) for plate in plates])
        assert np.ptp(corners, axis=0) == pytest.approx(facts["size_mm"], **rough)
        rings = [ring for plate in plates for ring in (plate["outline"], *plate["holes"])]
        length = sum(np.linalg.norm(np.diff([*r, r[0]], axis=0), axis=1).sum() for r in rings)
        assert length == pytest.approx(facts["cut_length_mm"], **rough)
        endings = {".dxf", ".svg", ".step", ".plates.json"}
    written = {path.name for path in made.iterdir()}
    assert written == {name + e for e in endings | {".solution.json", ".png"}}


@needs("inkscape")
@needs("librecad")
def test_plates_are_read_back_by_other_programs(example, made, tmp_path):
    """FreeCAD's importer is asked in `freecad/test_examples.py`."""
    if example.is_printed:
        return
    facts = example.facts
    path = tmp_path / "plates.dxf"
    path.write_bytes((made / f"{example.name}.dxf").read_bytes())
    run("/usr/bin/python3", "-c", IMPORT_ALL, IMPORTER, path, folder=tmp_path)
    layers = paths_in(path.with_suffix(".dxf.svg"))
    by_inkscape = sum(
        shapely.LineString([*points, points[0]]).length
        for layer in ("CUT_OUTER", "CUT_INNER")
        for points, closed in layers.get(layer, [])
        if closed
    )
    assert by_inkscape == pytest.approx(facts["cut_length_mm"], rel=facts["tolerance"])
    read = read_by_librecad(path)
    by_librecad = sum(
        read.get(colour, (0.0, 0))[0] for colour in (("1", "0", "0"), ("1", "0", "1"))
    )
    assert by_librecad == pytest.approx(by_inkscape, rel=1e-3)


@needs("prusa-slicer")
def test_prints_are_sliced_without_repair(example, made):
    if not example.is_printed:
        return
    path = made / f"{example.name}.stl"
    said = run("prusa-slicer", "--info", path, folder=made)
    assert "manifold = yes" in said
    assert "number_of_parts =  1" in said
    assert not any("repair" in line or "fixed" in line for line in said.splitlines())
    out = made.parent / f"{example.name}.gcode"
    run(
        "prusa-slicer", "--export-gcode", "--center", "150,150", "--bed-shape",
        "0x0,300x0,300x300,0x300", "--layer-height", 0.3, "--fill-density", "5%",
        "-o", out, path, folder=made,
    )  # fmt: skip
    assert out.read_text().count("G1 ") > 1000


def corners_of(plate):
    ring = np.array(plate["outline"])
    place = np.array(plate["world_from_plate"])
    both = [np.column_stack([ring, np.full(len(ring), z)]) for z in (0, plate["thickness_mm"])]
    return np.concatenate(both) @ place[:3, :3].T + place[:3, 3]


def solved(name):
    example = load_example(name)
    return solve(load_sketch(example.sketch_path)), example.truth


def test_bookshelf_has_the_books_proportions_without_any_camera():
    """Within 5 %; the paper's users were within 8 and 20 %."""
    solution, truth = solved("bookshelf")
    books, X, thickness = truth["books"], solution.vertices_mm, 3.0
    outside_width, outside_depth, _ = X["v3"] - X["v1"]
    # Drawn faces are the outside; the shelf has its face in the middle; the front is open.
    width = outside_width - 2 * thickness
    depth = outside_depth - thickness
    height = X["v5"][2] - 1.5 * thickness
    assert height / depth == pytest.approx(books["height_mm"] / books["depth_mm"], rel=0.05)
    assert height / width == pytest.approx(books["height_mm"] / books["width_mm"], rel=0.05)
    assert np.all([width, depth, height] > np.array([200.0, 170.0, 235.0]))


def fit_of(graph, settings):
    """What the product says of a thing traced in a sketch."""
    solution = solve(graph)
    model = build_model(solution, settings.thickness_mm)
    (fit,) = plates_check(joined_plates(model, settings), model, graph, solution).fits
    return fit


@pytest.mark.parametrize("wider_mm", [0.0, 12.0])
def test_true_books_fit_into_the_shelf_and_wider_ones_do_not(wider_mm):
    """The clearance is what is left of the inside beside the true books."""
    example = load_example("bookshelf")
    graph, settings, books = (
        load_sketch(example.sketch_path), example.plate_settings(), example.truth["books"],
    )  # fmt: skip
    t, beside = settings.thickness_mm, 2.0
    width = books["width_mm"] + wider_mm
    size = (width, books["depth_mm"], books["height_mm"])
    fit = fit_of(with_block(graph, (t + beside, 0.0), size), settings)
    # The shelf was told to be 210 mm wide.
    left_over = 210.0 - 2 * t - beside - width
    assert fit.fits == (left_over > 0)
    if fit.fits:
        assert fit.room_mm["right"] == pytest.approx(left_over, abs=0.05)
        assert fit.room_mm["left"] == pytest.approx(beside, abs=0.05)
        # They stand on the bottom, under the board, which has its face in its middle.
        above = solve(graph).vertices_mm["v5"][2] - 1.5 * t - books["height_mm"]
        assert fit.room_mm["up"] == pytest.approx(above, abs=0.05)
        assert 0 < above < 10
    else:
        assert fit.overlaps[0].missing_mm == pytest.approx(-left_over, abs=0.3)


def test_box_has_the_room_that_is_truly_left_around_it():
    """Between the traced legs: their width was measured, their depth came out by itself."""
    example = load_example("chair_box")
    graph, settings, chair = (
        load_sketch(example.sketch_path), example.plate_settings(), example.truth["chair"],
    )  # fmt: skip
    fit = fit_of(graph, settings)
    assert fit.fits
    X = solve(graph).vertices_mm
    box = X["v3"] - X["v1"]
    beside, behind = (
        chair["legs_width_mm"] - box[0] - X["v1"][0],
        chair["legs_depth_mm"] - box[1] - X["v1"][1],
    )
    assert fit.room_mm["right"] == pytest.approx(beside, abs=1.0)
    # Within the 2 % by which the depth of the legs is missed.
    assert fit.room_mm["back"] == pytest.approx(behind, abs=0.025 * chair["legs_depth_mm"])


def test_lid_has_the_rims_diameter():
    solution, truth = solved("teapot_lid")
    rim = truth["teapot"]["rim_diameter_mm"]
    assert 2 * solution.circles["c2"].radius_mm == pytest.approx(rim, rel=0.02)


def test_saucer_has_the_diameter_of_the_cups_foot_by_the_marker():
    solution, truth = solved("cup_saucer")
    foot = truth["cup"]["foot_diameter_mm"]
    assert 2 * solution.circles["c2"].radius_mm == pytest.approx(foot, rel=0.02)
    assert solution.camera.focal_px == pytest.approx(truth["camera"]["focal_px"], rel=0.02)


def test_marker_in_the_photo_is_the_one_that_is_written():
    path = FOLDER / "cup_saucer" / "marker.svg"
    assert path.read_bytes() == marker_file(path, 100.0)


def test_cover_leaves_room_for_the_blades():
    solution, truth = solved("scissors_cover")
    blades, X = truth["blades"], solution.vertices_mm
    wide, long = np.linalg.norm(X["v4"] - X["v1"]), np.linalg.norm(X["v2"] - X["v1"])
    assert blades["width_mm"] < wide < blades["width_mm"] + 8
    assert blades["length_mm"] < long < blades["length_mm"] + 12
    assert X["v5"][2] > blades["height_mm"]


def test_box_slides_in_between_the_legs_of_the_chair():
    solution, truth = solved("chair_box")
    chair, X = truth["chair"], solution.vertices_mm
    assert X["v2"][0] - X["v1"][0] < chair["between_legs_mm"]
    assert X["v5"][2] < chair["under_apron_mm"]
    depth = np.linalg.norm(X["g3"] - X["g1"])
    assert depth == pytest.approx(chair["legs_depth_mm"], rel=0.04)


def test_traced_paperback_of_a_cropped_photo_has_its_sizes():
    solution, truth = solved("desk_tidy")
    book, X = truth["book"], solution.vertices_mm
    long = np.linalg.norm(X["t3"] - X["t2"])
    assert long == pytest.approx(book["length_mm"], rel=0.05)
    assert X["t1"][2] == pytest.approx(book["height_mm"], rel=0.05)
