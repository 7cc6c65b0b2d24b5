"""Small helpers for frozen values: read-only arrays and mappings."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]
V = TypeVar("V")


def frozen_array(values: Any, shape: tuple[int, ...] | None = None) -> Array:
    """A read-only float64 copy, reshaped to `shape` where one is given."""
    array = np.array(values, dtype=np.float64)
    if shape is not None:
        array = array.reshape(shape)
    array.setflags(write=False)
    return array


def frozen_mapping(items: Mapping[str, V]) -> Mapping[str, V]:
    """A read-only copy that keeps the order."""
    return MappingProxyType(dict(items))
