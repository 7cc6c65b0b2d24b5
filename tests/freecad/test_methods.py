"""A model lifted by a method of a paper."""

import numpy as np
import pytest

from incontext.solver.reference import METHODS
from incontext.solver.serialise import sketch_to_text
from incontext.solver.synthetic import box, photograph
from incontext.workbench import host
from incontext.workbench.features import pipeline
from incontext.workbench.features.lifted_model import make_lifted_model, solution_of
from incontext.workbench.features.methods import OURS, SLOW, parts_of, source_of
from incontext.workbench.features.model_angles import text_of
from incontext.workbench.features.photo_sketch import make_photo_sketch


@pytest.fixture
def graph():
    return photograph(box(), np.random.default_rng(1)).graph


@pytest.fixture
def model(document, graph):
    sketch = make_photo_sketch(document, sketch_to_text(graph))
    model = make_lifted_model(document, sketch)
    document.recompute()
    return model


@pytest.fixture
def nobody_waits():
    """Whoever is asked to wait for something stops it."""
    before, asked = list(host._workers), []
    host.set_worker(lambda words, job: asked.append(words))
    yield asked
    host._workers[:] = before


def test_a_source_comes_apart_again():
    text, angles = '{"format": 1,\n"a": 2}', text_of({("e1", "e\n2"): 60.0})
    for method in (OURS, *SLOW):
        for said in ("", angles):
            parts = parts_of(source_of(text, method, said))
            assert (parts.method, parts.angles, parts.sketch) == (SLOW.get(method), said, text)


def test_the_solver_s_own_method_comes_first(model):
    assert model.Method == OURS == "Modified Lipson"
    assert model.getEnumerationsOfProperty("Method") == [OURS, "Lau 2010", "Lipson 1996"]
    assert model.Status == "converged"
    assert len(model.Shape.Faces) == 6


def test_the_paper_s_method_is_the_one_that_is_used(model, document, graph):
    own = solution_of(model)
    model.Method = "Lau 2010"
    document.recompute()
    found, expected = solution_of(model), METHODS["lau2010"](graph)
    assert found.status is expected.status
    assert model.Status == expected.status.value
    for v, x in expected.vertices_mm.items():
        assert (found.vertices_mm[v] == x).all()
        assert (found.vertices_mm[v] != own.vertices_mm[v]).any()
    assert len(model.Shape.Edges) >= 12
    model.Method = OURS
    document.recompute()
    assert solution_of(model) is own
    assert len(model.Shape.Faces) == 6


def test_what_is_not_waited_for_keeps_the_shape(model, document, nobody_waits):
    area = model.Shape.Area
    model.Method = "Lipson 1996"
    document.recompute()
    assert len(nobody_waits) == 1
    assert "Lipson 1996" in nobody_waits[0]
    assert model.Status == "stopped"
    assert "recompute" in model.Message
    assert model.Shape.Area == pytest.approx(area)
    with pytest.raises(Exception, match="stopped"):
        pipeline.solution_of(source_of(model.PhotoSketch.Sketch, model.Method))
    assert len(nobody_waits) == 1
    model.touch()
    document.recompute()
    assert len(nobody_waits) == 2
