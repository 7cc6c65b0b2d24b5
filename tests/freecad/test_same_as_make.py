"""The document objects and `incontext make` write the same files, whatever is asked for."""

import numpy as np
import pytest
import random_objects

from incontext.solver.serialise import save_sketch
from incontext.solver.synthetic import photograph
from incontext.workbench.cli import main
from incontext.workbench.features.examples import import_sketch
from incontext.workbench.features.exports import export_plates
from incontext.workbench.features.lifted_model import make_lifted_model
from incontext.workbench.features.plate_set import make_plate_set

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


@pytest.mark.parametrize("seed", SEEDS)
def test_the_files_are_the_same(seed, document, tmp_path, capsys):
    rng = np.random.default_rng(seed)
    names = list(random_objects.RANDOM)
    graph = photograph(random_objects.RANDOM[names[seed % len(names)]](rng), rng).graph
    path = tmp_path / "thing.sketch.json"
    save_sketch(graph, path)
    asked = {key: values[int(rng.integers(len(values)))] for key, (_, values) in CHOICES.items()}
    sketch = import_sketch(document, path)
    plates = make_plate_set(document, make_lifted_model(document, sketch))
    for key, value in asked.items():
        setattr(plates, CHOICES[key][0], value)
    plates.WithPartsList = plates.WithCoupon = True
    document.recompute()
    options = [text for key, value in asked.items() for text in (f"--{key}", str(value))]
    made = main(
        ["make", str(path), "--out", str(tmp_path / "cli"), "--parts", "--coupon", *options]
    )
    assert (made, plates.Status) == (0, "made"), (capsys.readouterr().err, plates.Message)
    ours = {p.name: p.read_bytes() for p in export_plates(plates, tmp_path / "doc", "thing")}
    theirs = {p.name: p.read_bytes() for p in (tmp_path / "cli").iterdir()}
    assert len(ours) == 8
    # A STEP file has the object's label and the time in it.
    assert {n for n, data in ours.items() if theirs[n] != data} <= {"thing.step"}
