"""Merging, numbering and looking up whole numbers all at once."""

from __future__ import annotations

import numpy as np
import pytest

from incontext.solver import merging
from incontext.solver.merging import are_among, each_once, first_members, numbered
from incontext.solver.two_paths import pairs_of_runs
from incontext.solver.union_find import UnionFind


@pytest.mark.parametrize("seed", range(8))
def test_first_members_are_those_of_merging_one_by_one(seed):
    rng = np.random.default_rng(seed)
    n = int(rng.integers(1, 60))
    pairs = rng.integers(0, n, (int(rng.integers(0, 80)), 2))
    sets = UnionFind(n)
    for i, j in pairs.tolist():
        sets.union(i, j)
    assert first_members(pairs, n).tolist() == sets.labels()


def test_stars_and_long_chains_are_merged():
    n = 500
    leaves = np.arange(n - 1)
    star = np.column_stack([leaves, np.full(n - 1, n - 1)])
    chain = np.column_stack([leaves, leaves + 1])[::-1]
    for pairs in (star, star[::-1], chain, chain[::-1, ::-1]):
        assert not first_members(pairs, n).any()


def test_labels_are_numbered_in_order():
    labels = np.array([7, 2, 7, 0, 2])
    names, place = numbered(labels, 9)
    assert names.tolist() == [0, 2, 7]
    assert names[place].tolist() == labels.tolist()


@pytest.mark.parametrize("room", [merging.MAX_TABLE, 3])
def test_numbers_are_looked_up_in_a_table_or_by_sorting(room, monkeypatch):
    monkeypatch.setattr(merging, "MAX_TABLE", room)
    wanted = np.array([[1, 5], [0, 9]])
    assert are_among(wanted, np.array([5, 0, 5]), 10).tolist() == [[False, True], [True, False]]


@pytest.mark.parametrize("few", [0, merging.FEW])
def test_rows_are_kept_once_in_order(few, monkeypatch):
    monkeypatch.setattr(merging, "FEW", few)
    rows = np.random.default_rng(3).integers(0, 4, (50, 4))
    wanted = {tuple(row) for row in rows.tolist()}
    found = [tuple(row) for row in each_once(rows).tolist()]
    assert set(found) == wanted
    assert len(found) == len(wanted)
    assert found == sorted(found, key=lambda row: row[::-1])
    assert len(each_once(np.zeros((0, 3), dtype=np.int64))) == 0


def test_all_pairs_within_runs_and_the_longest_runs_left_out_first():
    i, j = pairs_of_runs(np.array([1, 3, 0, 2]), 100)
    assert list(zip(i.tolist(), j.tolist(), strict=True)) == [(1, 2), (1, 3), (2, 3), (4, 5)]
    i, j = pairs_of_runs(np.array([40, 3, 2]), 5)
    assert i.tolist() == [40, 40, 41, 43]
    assert j.tolist() == [41, 42, 42, 44]
