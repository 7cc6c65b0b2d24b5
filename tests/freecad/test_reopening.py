"""A saved document in another FreeCAD: objects alive, and the same shapes again."""

import json
from pathlib import Path

import pytest

from incontext.workbench.launch import Launch, run

DECOY = Path(__file__).parent / "decoy_addon"


@pytest.fixture
def reopened(shelf, document, tmp_path):
    document.saveAs(str(tmp_path / "shelf.FCStd"))
    answer = tmp_path / "answer.json"
    launch = Launch(
        call="incontext.tests.freecad.fresh_process:reopen",
        home=tmp_path / "home",
        arguments=[str(answer), document.FileName],
        addons=(DECOY,),
    )
    assert run(launch) == 0
    return json.loads(answer.read_text())


def test_reopened_document_is_alive_and_the_same(shelf, reopened, shelf_path):
    _, model, plates = shelf
    assert reopened["proxies"] == ["PhotoSketch", "LiftedModel", "PlateSet"]
    assert all(name.startswith("incontext.workbench.features.") for name in reopened["modules"])
    for state in (reopened["stored"], reopened["recomputed"]):
        assert state["volume"] == pytest.approx(plates.Shape.Volume, rel=1e-9)
        assert state["area"] == pytest.approx(model.Shape.Area, rel=1e-9)
        assert state["solids"] == 6
        assert state["photo_bytes"] == (shelf_path.parent / "shelf.jpg").stat().st_size
    assert reopened["thicker"]["volume"] > 1.5 * reopened["stored"]["volume"]
