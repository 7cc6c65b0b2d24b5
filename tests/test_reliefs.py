"""What leaving an annotation out would gain, by fewer rows than it has."""

from __future__ import annotations

import numpy as np
import pytest

from incontext.solver.diagnosis.definite import Definite
from incontext.solver.diagnosis.reliefs import FREED, Springs, of_one_row, of_several

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
    springs = Springs(H, h, Definite.of(np.eye(unknowns) + STIFFNESS * H.T @ H), STIFFNESS)
    (found,) = of_several({"a": list(range(rows))}, springs)
    assert found.gain == pytest.approx(gain, rel=1e-6)
    assert found.freed == np.count_nonzero(values < FREED)


def test_what_is_asked_for_twice_is_left_out_only_where_it_gains_too_little():
    rng = np.random.default_rng(3)
    H, h = rng.normal(size=(30, 20)), rng.normal(size=30) * 0.01
    H[10:20] = H[20:]
    springs = Springs(H, h, Definite.of(np.eye(20) + STIFFNESS * H.T @ H), STIFFNESS)
    owned = {str(k): [k] for k in range(30)}
    all_of_them = {r.id: r.gain for r in of_one_row(owned, springs, 0.0)}
    assert len(all_of_them) == 30
    enough = float(np.median([*all_of_them.values()]))
    found = {r.id: r.gain for r in of_one_row(owned, springs, enough)}
    assert len(found) < 30
    assert found.keys() >= {id_ for id_, gain in all_of_them.items() if gain > enough}
    assert all(found[id_] == pytest.approx(all_of_them[id_]) for id_ in found)
