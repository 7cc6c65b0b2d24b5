"""Wild sketches end in a SketchError or in a status, never in an exception, NaN or a warning.

A sample of the cases that `fuzzing.py` runs by the hundred thousand.
"""

from __future__ import annotations

import random

import pytest
from fuzzing import KINDS, put_through

SEEDS = range(40)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", SEEDS)
def test_wild_sketches_end_in_an_error_or_a_status(kind, seed):
    rng = random.Random(seed)
    for _ in range(3):
        put_through(KINDS[kind](rng))
