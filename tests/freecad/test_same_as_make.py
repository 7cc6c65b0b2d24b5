"""The document objects and `incontext make` write the same files, whatever is asked for."""

import Mesh
import numpy as np
import pytest
import random_objects

from incontext.solver.serialise import save_sketch
from incontext.solver.synthetic import photograph
from incontext.workbench.cli import main
from incontext.workbench.features.examples import import_sketch
from incontext.workbench.features.exports import export_plates, export_print
from incontext.workbench.features.lifted_model import make_lifted_model
from incontext.workbench.features.plate_set import make_plate_set
from incontext.workbench.features.shelled_solid import make_shelled_solid

#: A hexagon with partitions; a roof with joints too flat for fingers.
SEEDS = (50007, 50009)
#: What is asked for, as the command line and as the document object call it.
CHOICES = {
    "thickness": ("Thickness", (2.0, 3.0, 5.5)),
    "side": ("Side", ("inside", "outside", "middle")),
    "finger": ("FingerWidth", (8.0, 12.0, 30.0)),
    "play": ("Play", (0.0, 0.15)),
    "kerf": ("Kerf", (0.0, 0.2)),
    "relief": ("CornerRelief", ("none", "dogbone", "tbone")),
    "tool": ("ToolDiameter", (1.0,)),
    "margin": ("Margin", (5.0, 12.0)),
    "spacing": ("Spacing", (3.0, 7.5)),
    "grain": ("Grain", ("free", "x", "y")),
    "preset": ("Preset", ("plain", "lightburn", "ponoko", "simple")),
    "page": ("PdfPage", ("A4", "A3")),
    "price": ("SheetPrice", (4.5,)),
}
OF_PRINTS = {
    "side": ("Side", ("inside", "outside", "middle")),
    "wall": ("Wall", (1.2, 2.0, 3.5)),
    "tolerance": ("Tolerance", (0.05, 0.2)),
}


@pytest.fixture(params=SEEDS)
def thing(request, tmp_path):
    """A random object's sketch, and what chooses settings."""
    rng = np.random.default_rng(request.param)
    names = list(random_objects.RANDOM)
    graph = photograph(random_objects.RANDOM[names[request.param % len(names)]](rng), rng).graph
    path = tmp_path / "thing.sketch.json"
    save_sketch(graph, path)
    return path, rng


def chosen(rng, choices):
    return {key: values[int(rng.integers(len(values)))] for key, (_, values) in choices.items()}


def by_command_line(path, asked, *more):
    options = [text for key, value in asked.items() for text in (f"--{key}", str(value))]
    return main(["make", str(path), "--out", str(path.parent / "cli"), *more, *options])


def test_the_files_are_the_same(thing, document, tmp_path, capsys):
    path, rng = thing
    asked = chosen(rng, CHOICES)
    sketch = import_sketch(document, path)
    plates = make_plate_set(document, make_lifted_model(document, sketch))
    for key, value in asked.items():
        setattr(plates, CHOICES[key][0], value)
    plates.WithPartsList = plates.WithCoupon = True
    document.recompute()
    made = by_command_line(path, asked, "--parts", "--coupon")
    assert (made, plates.Status) == (0, "made"), (capsys.readouterr().err, plates.Message)
    ours = {p.name: p.read_bytes() for p in export_plates(plates, tmp_path / "doc", "thing")}
    theirs = {p.name: p.read_bytes() for p in (tmp_path / "cli").iterdir()}
    assert len(ours) == 8
    # A STEP file has the object's label and the time in it.
    assert {n for n, data in ours.items() if theirs[n] != data} <= {"thing.step"}


def test_prints_are_the_same(thing, document, tmp_path, capsys):
    path, rng = thing
    asked = chosen(rng, OF_PRINTS)
    sketch = import_sketch(document, path)
    solid = make_shelled_solid(document, make_lifted_model(document, sketch))
    for key, value in asked.items():
        setattr(solid, OF_PRINTS[key][0], value)
    document.recompute()
    made = by_command_line(path, asked, "--print")
    assert (made, solid.Status) == (0, "made"), (capsys.readouterr().err, solid.Message)
    ours = {p.name: p.read_bytes() for p in export_print(solid, tmp_path / "doc", "thing")}
    theirs = {p.name: p.read_bytes() for p in (tmp_path / "cli").iterdir()}
    assert {".stl", ".3mf"} <= {name[-4:] for name in ours}
    assert {n for n, data in ours.items() if theirs[n] != data} <= {"thing.step"}
    # The document's solid is what the mesh is of.
    mesh = Mesh.Mesh(str(tmp_path / "doc" / "thing.stl"))
    assert mesh.isSolid()
    assert not mesh.hasSelfIntersections()
    assert mesh.Volume == pytest.approx(solid.Shape.Volume, rel=1e-4)
