"""Small helpers for frozen values: read-only arrays and mappings, and results that are kept.

Terms
-----
kept
    A pure function of frozen values is worked out once for the same values; the newest few results
    stay. Values are the same when they are one object: an edit that moves a vertex hands all other
    mappings on, and with them everything that was worked out from them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache, wraps
from operator import is_
from typing import Any, NoReturn, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]
K = TypeVar("K")
V = TypeVar("V")
#: Asked now and then by what takes long; True ends it.
Stop = Callable[[], bool]
#: Told now and then how far something is (0 to 1) and what is being done.
Progress = Callable[[float, str], None]

#: Results of each function that stay: a few sketches, each as drawn and as solved.
KEPT = 8


def frozen_array(values: Any, shape: tuple[int, ...] | None = None) -> Array:
    """A read-only float64 copy, reshaped to `shape` where one is given."""
    array = np.array(values, dtype=np.float64)
    if shape is not None:
        array = array.reshape(shape)
    array.setflags(write=False)
    return array


class FrozenDict(dict[K, V]):
    """A dict that cannot be changed."""

    __slots__ = ()

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError("this mapping is read-only: make a new one")

    __setitem__ = __delitem__ = __ior__ = _refuse
    clear = pop = popitem = setdefault = update = _refuse

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (dict(self),))


class Awaited(Mapping[K, V]):
    """A read-only mapping that is worked out when it is first looked into.

    Parameters
    ----------
    make : callable
        A pure function: it may be called more than once, by threads that look at the same time.
    """

    __slots__ = ("_made", "_make")

    def __init__(self, make: Callable[[], Mapping[K, V]]) -> None:
        self._make = make
        self._made: Mapping[K, V] | None = None

    @property
    def _mapping(self) -> Mapping[K, V]:
        if self._made is None:
            self._made = self._make()
        return self._made

    def __getitem__(self, key: K) -> V:
        return self._mapping[key]

    def __iter__(self) -> Iterator[K]:
        return iter(self._mapping)

    def __len__(self) -> int:
        return len(self._mapping)

    def __repr__(self) -> str:
        return repr(self._mapping)

    def __reduce__(self) -> tuple[Any, ...]:
        return (FrozenDict, (dict(self._mapping),))


class FrozenRows(FrozenDict[str, Array]):
    """Rows of one read-only array (n, 3) by id, and the array."""

    __slots__ = ("array",)

    def __init__(self, ids: Iterable[str], array: Array) -> None:
        array.setflags(write=False)
        super().__init__(zip(ids, array, strict=True))
        self.array = array

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (tuple(self), self.array))


def frozen_mapping(items: Mapping[str, V]) -> Mapping[str, V]:
    """The items, read-only, in their order; a frozen mapping itself comes back as it is."""
    return items if isinstance(items, FrozenDict | Awaited) else FrozenDict(items)


def frozen_rows(items: Mapping[str, Any]) -> Mapping[str, Array]:
    """Read-only (3,) arrays by id; frozen rows themselves come back as they are."""
    if isinstance(items, FrozenRows):
        return items
    return FrozenRows(items, frozen_array([*items.values()], (len(items), 3)))


def rows_of(items: Mapping[str, Array]) -> Array:
    """All rows together, (n, 3)."""
    if isinstance(items, FrozenRows):
        return items.array
    return np.array([*items.values()], dtype=np.float64).reshape(-1, 3)


def kept(make: Callable[..., V]) -> Callable[..., V]:
    """Keep the newest results of a pure function of frozen values.

    Arguments are compared by identity; tuples, texts and whole numbers by what they hold.
    """

    @lru_cache(maxsize=KEPT)
    def result(same: _Same) -> V:
        return make(*same.values)

    last: tuple[tuple[Any, ...], V] | None = None

    @wraps(make)
    def keeping(*values: Any) -> V:
        nonlocal last
        # Mostly the last values are asked for again: that is seen at once.
        same = last
        if same is None or len(same[0]) != len(values) or not all(map(is_, same[0], values)):
            same = last = (values, result(_Same(values)))
        return same[1]

    def forget() -> None:
        nonlocal last
        last = None
        result.cache_clear()

    forget_by(forget)
    return keeping


def forget_kept() -> None:
    """Begin anew, as for values never seen: what measures a solve from nothing needs this."""
    for forget in _forgetting:
        forget()


def forget_by(forget: Callable[[], object]) -> None:
    """Have something called when all that is kept is to be forgotten."""
    _forgetting.append(forget)


_forgetting: list[Callable[[], object]] = []


class _Same:
    """Values that are equal only if they are the same objects."""

    __slots__ = ("key", "values")

    def __init__(self, values: tuple[Any, ...]) -> None:
        # Holding the values keeps their addresses theirs.
        self.values = values
        self.key = tuple(v if isinstance(v, tuple | str | bytes | int) else id(v) for v in values)

    def __hash__(self) -> int:
        return hash(self.key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and self.key == other.key
