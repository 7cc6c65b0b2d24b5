"""Linear algebra runs in one thread during a solve, and as before afterwards."""

from __future__ import annotations

from threading import Barrier, Thread

import numpy as np
import pytest
from scenes import box, photograph

from incontext.solver import solve
from incontext.solver.blas_threads import _openblas, one_blas_thread

needs_openblas = pytest.mark.skipif(not _openblas(), reason="no OpenBLAS is loaded")


def counts() -> list[int]:
    return [get() for get, _ in _openblas()]


@pytest.fixture
def two_threads():
    before = counts()
    for _, put in _openblas():
        put(2)
    yield counts()
    for (_, put), count in zip(_openblas(), before, strict=True):
        put(count)


@needs_openblas
def test_one_thread_inside_and_as_before_afterwards(two_threads):
    with one_blas_thread:
        assert set(counts()) == {1}
        with one_blas_thread:
            pass
        assert set(counts()) == {1}
    assert counts() == two_threads


@needs_openblas
def test_a_solve_runs_in_one_thread(two_threads):
    seen = []
    solve(
        photograph(box(), np.random.default_rng(0)).graph,
        progress=lambda done, what: seen.append(counts()),
    )
    assert seen
    assert all(set(found) == {1} for found in seen)
    assert counts() == two_threads


@needs_openblas
def test_the_last_of_several_puts_back(two_threads):
    entered, left = Barrier(2), Barrier(2)

    def other() -> None:
        with one_blas_thread:
            entered.wait()
            left.wait()

    thread = Thread(target=other)
    with one_blas_thread:
        thread.start()
        entered.wait()
    assert set(counts()) == {1}
    left.wait()
    thread.join()
    assert counts() == two_threads
