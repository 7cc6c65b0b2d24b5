"""DXF files as Inkscape and LibreCAD read them; prints as slicers and mesh checkers do.

The programs come with ``make setup``.
"""

import io
import math
import os
import re
import shutil
import subprocess
import zlib
from collections import Counter, defaultdict
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
import trimesh
from fabrication import shapes, slanted
from fabrication.catalogue import CATALOGUE

from incontext.solver.model import Model, Turned
from incontext.workbench.fabrication import PlateSettings, ShellSettings, joined_plates, shell_solid
from incontext.workbench.fabrication.drawing import draw
from incontext.workbench.fabrication.dxf import dxf_bytes
from incontext.workbench.fabrication.marks import edge_marks
from incontext.workbench.fabrication.meshes import mesh_of, stl_bytes
from incontext.workbench.fabrication.presets import load_preset
from incontext.workbench.fabrication.sheets import lay_out

IMPORTER = Path("/usr/share/inkscape/extensions/dxf_input.py")
SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
PX_PER_MM = 96 / 25.4
CUT = ("CUT_OUTER", "CUT_INNER")
TOLERANCE_MM = 0.05


def needs(program: str):
    there = IMPORTER.is_file() if program == "inkscape" else shutil.which(program)
    return pytest.mark.skipif(not there, reason=f"{program} is missing: make setup")


def run(*command: object, folder: Path) -> str:
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": str(folder)}
    done = subprocess.run(
        [str(part) for part in command],
        cwd=folder, env=environment, capture_output=True, text=True, check=True, timeout=120,
    )  # fmt: skip
    return done.stdout


@cache
def drawn(name: str, preset: str = "plain"):
    """The sheets of a shape of the catalogue, their drawing and its DXF."""
    settings = PlateSettings(kerf_mm=0.15, sheet_mm=(320.0, 300.0))
    joined = joined_plates(CATALOGUE[name].make(), settings)
    sheets = lay_out(joined.plates, settings, edge_marks(joined.plates, joined.joints))
    return sheets, draw(sheets), dxf_bytes(sheets, load_preset(preset))


def rings_of(drawing, layer: str) -> list[np.ndarray]:
    return [p.points for p in drawing.paths if p.purpose == layer]


def length_of(drawing, layer: str) -> float:
    return sum(
        shapely.LineString([*p.points, *(p.points[:1] if p.closed else [])]).length
        for p in drawing.paths
        if p.purpose == layer
    )


#: Runs the importer for many files: most of its time is that of its start.
IMPORT_ALL = """
import os, runpy, sys
importer, *names = sys.argv[1:]
sys.path.insert(0, os.path.dirname(importer))
for name in names:
    sys.argv = [importer, f"--output={name}.svg", name]
    runpy.run_path(importer, run_name="__main__")
"""


@pytest.fixture(scope="module")
def read_by_inkscape(tmp_path_factory):
    """What Inkscape's importer makes of each shape: paths by layer, mm, and whether closed."""
    folder = tmp_path_factory.mktemp("inkscape")
    files = {name: folder / f"{n}.dxf" for n, name in enumerate(CATALOGUE)}
    for name, path in files.items():
        path.write_bytes(drawn(name)[2])
    run("/usr/bin/python3", "-c", IMPORT_ALL, IMPORTER, *files.values(), folder=folder)
    return {name: paths_in(path.with_suffix(".dxf.svg")) for name, path in files.items()}


def paths_in(svg: Path) -> dict[str, list[tuple[np.ndarray, bool]]]:
    layers = {}
    for group in ElementTree.parse(svg).getroot().iter(f"{SVG}g"):
        paths = []
        for element in group.iter(f"{SVG}path"):
            text = element.get("d")
            points = np.array(re.findall(r"(-?[\d.e-]+),(-?[\d.e-]+)", text), dtype=float)
            paths.append((points / PX_PER_MM, text.rstrip().lower().endswith("z")))
        layers[group.get(LABEL)] = paths
    return layers


@needs("inkscape")
@pytest.mark.parametrize("name", CATALOGUE)
def test_inkscape_reads_what_was_drawn(name, read_by_inkscape):
    _, drawing, _ = drawn(name)
    layers = read_by_inkscape[name]
    every = []
    for layer in (*CUT, "ENGRAVE"):
        mine = rings_of(drawing, layer)
        read = layers.get(layer, [])
        assert len(read) == len(mine)
        total = 0.0
        for points, closed in read:
            assert closed == (layer in CUT)
            ring = [*points, points[0]] if closed else points
            total += shapely.LineString(ring).length
        assert total == pytest.approx(length_of(drawing, layer), rel=1e-4)
        every += [points for points, _ in read]
    sizes = [np.ptp(np.vstack(points), axis=0) for points in (
        every, [p.points for p in drawing.paths if p.purpose in (*CUT, "ENGRAVE")]
    )]  # fmt: skip
    np.testing.assert_allclose(sizes[0], sizes[1], rtol=1e-4)


@pytest.mark.parametrize("name", CATALOGUE)
def test_no_segment_is_cut_twice_and_no_plates_overlap(name):
    sheets, drawing, _ = drawn(name)
    segments: Counter[tuple] = Counter()
    for layer in CUT:
        for ring in rings_of(drawing, layer):
            points = [tuple(p) for p in np.round(ring, 4).tolist()]
            ends = zip(points, [*points[1:], points[0]], strict=True)
            segments.update(tuple(sorted(pair)) for pair in ends)
    assert max(segments.values()) == 1
    for sheet in sheets:
        parts = [shapely.Polygon(part.outer) for part in sheet.parts]
        border = shapely.box(0, 0, sheet.width_mm, sheet.height_mm)
        assert all(border.contains(part) for part in parts)
        tree = shapely.STRtree(parts)
        near = tree.query(parts, predicate="dwithin", distance=2.9)
        assert all(a == b for a, b in near.T.tolist())


def read_by_librecad(path: Path) -> dict[tuple[str, ...], tuple[float, int]]:
    """Length, mm, and number of closed paths by colour."""
    scale = 20  # so that rounding to its grid does not count
    run("librecad", "dxf2pdf", "-s", scale, "-c", "-p", "900x420", path, folder=path.parent)
    streams = re.findall(
        rb"stream\r?\n(.*?)endstream", path.with_suffix(".pdf").read_bytes(), re.DOTALL
    )
    texts = [zlib.decompress(s).decode("latin1") for s in streams if s[:1] == b"x"]
    text = max(texts, key=len)
    unit = float(re.search(r"([\d.]+) 0 0 -[\d.]+ 0", text)[1]) * 25.4 / 72 / scale
    lengths: dict[tuple[str, ...], float] = defaultdict(float)
    closed: Counter[tuple[str, ...]] = Counter()
    colour, at, first = (), (0.0, 0.0), (0.0, 0.0)
    for line in text.splitlines():
        words = line.split()
        if line.endswith("SCN"):
            colour = tuple(words[:-1])
        elif line.endswith((" m", " l")):
            point = (float(words[0]), float(words[1]))
            if line.endswith(" m"):
                first = first if point == at else point
            else:
                lengths[colour] += math.dist(at, point) * unit
                if point == first:
                    closed[colour] += 1
                    point = first = (math.nan, math.nan)
            at = point
    return {colour: (length, closed[colour]) for colour, length in lengths.items()}


@needs("librecad")
@pytest.mark.parametrize("name", CATALOGUE)
def test_librecad_reads_what_was_drawn(name, tmp_path):
    check_librecad(*drawn(name)[1:], tmp_path)


@needs("librecad")
def test_librecad_reads_r12_too(tmp_path):
    check_librecad(*drawn("crossed", "simple")[1:], tmp_path)


def check_librecad(drawing, dxf: bytes, folder: Path) -> None:
    path = folder / "plates.dxf"
    path.write_bytes(dxf)
    read = read_by_librecad(path)
    colours = {"CUT_OUTER": ("1", "0", "0"), "CUT_INNER": ("1", "0", "1")}
    mine = {layer: length_of(drawing, layer) for layer in CUT}
    # It rounds its page to whole points: one factor near 1 for everything.
    factor = read[colours["CUT_OUTER"]][0] / mine["CUT_OUTER"]
    assert factor == pytest.approx(1.0, abs=5e-4)
    for layer, colour in colours.items():
        if mine[layer]:
            length, closed = read[colour]
            assert length == pytest.approx(factor * mine[layer], rel=1e-4)
            assert closed == len(rings_of(drawing, layer))


def bowl(**_) -> Model:
    profile = np.array([(15.0, 0.0), (26.0, 9.0), (30.0, 25.0)])
    return Model({}, {}, {}, {"r1": Turned(np.array([10.0, -5.0]), profile)})


def shelf_with_front(**options) -> Model:
    loops = dict(shapes.box_loops(120, 60, 90))
    loops["shelf"] = shapes.rect(2, 40, (0, 120), (0, 60))
    return shapes.model(loops, left_out=("front",), **options)


def hexagon(**options) -> Model:
    return shapes.model(shapes.prism(slanted.HEXAGON, 70), left_out=("top",), **options)


def spire(**options) -> Model:
    plan = [(0, 0), (60, 40), (120, 0), (130, 70), (60, 100), (0, 60)]
    loops = {"bottom": [(x, y, 0.0) for x, y in plan]}
    for n, corner in enumerate(plan):
        after = plan[(n + 1) % len(plan)]
        loops[f"s{n}"] = [(*corner, 0.0), (*after, 0.0), (60.0, 62.0, 90.0)]
    return shapes.model(loops, left_out=("bottom",), **options)


PRINTS = {
    "spire": spire,
    "l box": lambda: shapes.l_box(left_out=("top",)),
    "hexagon": hexagon,
    "shelf": shelf_with_front,
    "bowl": bowl,
}


@pytest.fixture(params=PRINTS)
def printed(request, tmp_path):
    """The exact solid, and its STL file."""
    solid = shell_solid(PRINTS[request.param](), ShellSettings(2.5))
    path = tmp_path / "print.stl"
    path.write_bytes(stl_bytes(mesh_of(solid, TOLERANCE_MM)))
    return solid, path


def test_trimesh_sees_a_closed_solid(printed):
    solid, path = printed
    mesh = trimesh.load(io.BytesIO(path.read_bytes()), file_type="stl")
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.body_count == 1
    assert abs(mesh.volume - solid.Volume()) <= TOLERANCE_MM * solid.Area()
    assert (mesh.area_faces > 0).all()


@needs("admesh")
def test_admesh_finds_nothing_to_mend(printed):
    _, path = printed
    text = run("admesh", path, folder=path.parent)
    mends = ("Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Normals fixed")
    for what in (*mends, "Facets reversed", "Backwards edges"):
        assert int(re.search(rf"{what}\s*:\s*(\d+)", text)[1]) == 0
    before, after = re.search(r"Total disconnected facets\s*:\s*(\d+)\s+(\d+)", text).groups()
    assert (before, after) == ("0", "0")
    assert int(re.search(r"Number of parts\s*:\s*(\d+)", text)[1]) == 1


@needs("prusa-slicer")
def test_prusaslicer_sees_one_manifold_and_slices_it(printed):
    solid, path = printed
    text = run("prusa-slicer", "--info", path, folder=path.parent)
    facts = dict(re.findall(r"(\w+) =\s+(\S+)", text))
    assert facts["manifold"] == "yes"
    assert facts["number_of_parts"] == "1"
    assert not any("repair" in line or "fixed" in line for line in text.splitlines())
    assert float(facts["volume"]) == pytest.approx(solid.Volume(), rel=1e-2)
    out = path.with_suffix(".gcode")
    run(
        "prusa-slicer", "--export-gcode", "--center", "150,150", "--bed-shape",
        "0x0,300x0,300x300,0x300", "--layer-height", 0.3, "--fill-density", "5%",
        "-o", out, path, folder=path.parent,
    )  # fmt: skip
    assert out.read_text().count("G1 ") > 1000
