"""Merging and numbering whole numbers all at once, where there are thousands.

Terms
-----
label
    The smallest member of the set that a number is in.
"""

from __future__ import annotations

import numpy as np

from .values import BoolArray, IntArray

#: Up to so many flags in a table, looking things up in it is faster than sorting.
MAX_TABLE = 4_000_000

#: A table with so many flags for each row is worth it.
FEW = 50


def first_members(pairs: IntArray, n: int) -> IntArray:
    """Merge 0 ... n-1 as the pairs (k, 2) say; the label of each, (n,).

    Of each pair in two sets the greater label is hung below the smallest that it meets, all of
    them at once, and all numbers then move up to their set's top: a few rounds do.
    """
    label = np.arange(n)
    i, j = pairs.T
    while True:
        of_i, of_j = label[i], label[j]
        apart = np.flatnonzero(of_i != of_j)
        if not len(apart):
            return label
        i, j, of_i, of_j = i[apart], j[apart], of_i[apart], of_j[apart]
        np.minimum.at(label, np.maximum(of_i, of_j), np.minimum(of_i, of_j))
        above = label[label]
        while not np.array_equal(above, label):
            label, above = above, above[above]


def numbered(labels: IntArray, n: int) -> tuple[IntArray, IntArray]:
    """The different labels among 0 ... n-1, in order, and for each label its place there."""
    there = np.zeros(n, dtype=bool)
    there[labels] = True
    names = np.flatnonzero(there)
    place = np.empty(n, dtype=np.int64)
    place[names] = np.arange(len(names))
    return names, place[labels]


def are_among(wanted: IntArray, known: IntArray, n: int) -> BoolArray:
    """Whether numbers below n are among those that are known."""
    if n > MAX_TABLE:
        return np.isin(wanted, known)
    there = np.zeros(n, dtype=bool)
    there[known] = True
    return there[wanted]


def each_once(rows: IntArray) -> IntArray:
    """The different rows (k, w) of numbers below 2^15, in order of their last numbers; w <= 4."""
    n, width = int(rows.max(initial=-1)) + 1, rows.shape[1]
    if n**width <= FEW * len(rows):
        # Of few numbers a table is made sooner than an order.
        there = np.zeros((n,) * width, dtype=bool)
        there[tuple(rows.T[::-1])] = True
        return np.column_stack(np.nonzero(there)[::-1])
    shifts = 15 * np.arange(width, dtype=np.int64)
    # Sorted by hand: `np.unique` takes several times as long.
    codes = np.sort(rows @ (1 << shifts))
    codes = codes[np.flatnonzero(np.append(True, codes[1:] != codes[:-1]))[: len(codes)]]
    return np.asarray((codes[:, None] >> shifts) & 0x7FFF)
