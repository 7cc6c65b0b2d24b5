"""Frozen values, and results that are kept for them."""

from __future__ import annotations

import copy
import json
import pickle
from dataclasses import replace

import numpy as np
import pytest
from scenes import box, organizer, photograph

from incontext.solver.solution import Residual, Residuals
from incontext.solver.values import Awaited, FrozenDict, frozen_mapping, frozen_rows, kept


@pytest.mark.parametrize(
    "change",
    [
        lambda m: m.__setitem__("a", 2),
        lambda m: m.__delitem__("a"),
        lambda m: m.update(a=2),
        lambda m: m.pop("a"),
        lambda m: m.popitem(),
        lambda m: m.clear(),
        lambda m: m.setdefault("b", 2),
        lambda m: m.__ior__({"b": 2}),
    ],
)
def test_a_frozen_mapping_refuses_every_change(change):
    mapping = frozen_mapping({"a": 1})
    with pytest.raises(TypeError, match="read-only"):
        change(mapping)
    assert mapping == {"a": 1}


def test_an_awaited_mapping_is_worked_out_once_and_only_when_looked_into():
    made = []

    def make():
        made.append(1)
        return {"a": 1, "b": 2}

    awaited = frozen_mapping(Awaited(make))
    assert not made
    assert awaited == {"a": 1, "b": 2}
    assert (len(awaited), list(awaited), awaited["b"], "c" in awaited) == (2, ["a", "b"], 2, False)
    assert {**awaited} == pickle.loads(pickle.dumps(awaited)) == copy.deepcopy(awaited) == awaited
    assert repr(awaited) == "{'a': 1, 'b': 2}"
    assert len(made) == 1
    with pytest.raises(TypeError):
        awaited["a"] = 2


def test_a_frozen_mapping_is_copied_and_saved_like_a_dict():
    mapping = frozen_mapping({"a": [1]})
    for twin in (copy.deepcopy(mapping), copy.copy(mapping), pickle.loads(pickle.dumps(mapping))):
        assert twin == mapping
        assert isinstance(twin, FrozenDict)
    assert json.dumps(mapping) == '{"a": [1]}'
    assert frozen_mapping(mapping) is mapping


def test_frozen_rows_are_read_only():
    rows = frozen_rows({"a": [1, 2, 3], "b": np.zeros(3)})
    assert rows["a"].dtype == np.float64
    with pytest.raises(ValueError, match="read-only"):
        rows["b"][0] = 1.0
    assert frozen_rows(rows) is rows
    assert len(frozen_rows({})) == 0


def test_an_edit_hands_the_other_mappings_on():
    graph = photograph(box(), np.random.default_rng(0)).graph
    moved = replace(graph, vertices={**graph.vertices, "v0": (1.0, 2.0)})
    assert moved.edges is graph.edges
    assert moved.annotations is graph.annotations
    assert moved != graph


def test_results_are_kept_for_the_same_values_only():
    calls = []

    @kept
    def work(mapping, names):
        calls.append(names)
        return object()

    one, other = frozen_mapping({"a": 1}), frozen_mapping({"a": 1})
    assert work(one, ("x",)) is work(one, ("x",))
    assert work(other, ("x",)) is not work(one, ("x",))
    work(one, ("y",))
    assert len(calls) == 3


def test_the_digest_tells_what_is_said_and_not_in_which_order():
    graph = photograph(organizer(), np.random.default_rng(0)).graph
    turned = replace(
        graph,
        vertices=dict(reversed(graph.vertices.items())),
        annotations=dict(reversed(graph.annotations.items())),
    )
    assert turned.digest == graph.digest
    for name in ("vertices", "edges", "annotations"):
        fewer = dict(getattr(graph, name))
        fewer.popitem()
        assert replace(graph, **{name: fewer}).digest != graph.digest


def test_residuals_are_a_mapping():
    residuals = Residuals(("a", "b"), np.array([0.5, 0.0]), ("deg", "mm"))
    assert residuals == {"a": Residual(0.5, "deg"), "b": Residual(0.0, "mm")}
    assert residuals.above(0.1) == {"a": Residual(0.5, "deg")}
    assert "c" not in residuals
    assert list(residuals) == ["a", "b"]
