"""What leaving an annotation out would gain, by fewer rows than it has."""

from __future__ import annotations

import numpy as np
import pytest

from incontext.solver.diagnosis.reliefs import FREED, _of_several

STIFFNESS = 1e3


@pytest.mark.parametrize(("rows", "unknowns"), [(40, 12), (31, 30), (30, 30), (5, 12)])
def test_thousands_of_rows_say_no_more_than_there_are_unknowns(rows, unknowns):
    rng = np.random.default_rng(rows)
    H, h = rng.normal(size=(rows, unknowns)), rng.normal(size=rows) * 0.01
    H[rows // 2 :] = H[: rows - rows // 2]
    inverse = np.linalg.inv(np.eye(unknowns) + STIFFNESS * H.T @ H)
    left = np.eye(rows) * (1 + 1e-9) - STIFFNESS * (H @ inverse @ H.T)
    values, vectors = np.linalg.eigh(left)
    gain = STIFFNESS * float(((h @ vectors) ** 2 / np.maximum(values, 1e-9)).sum())
    (found,) = _of_several({"a": list(range(rows))}, H, inverse, h, STIFFNESS)
    assert found.gain == pytest.approx(gain, rel=1e-6)
    assert found.freed == np.count_nonzero(values < FREED)
