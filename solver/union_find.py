"""Disjoint sets of whole numbers, merged as relations come in."""

from __future__ import annotations


class UnionFind:
    """Sets of 0 ... n-1; the smallest member names a set, so results do not depend on order."""

    def __init__(self, n: int) -> None:
        self._parent = list(range(n))

    def find(self, i: int) -> int:
        """The name of the set that holds i."""
        parent = self._parent
        root = i
        while parent[root] != root:
            root = parent[root]
        while parent[i] != root:
            parent[i], i = root, parent[i]
        return root

    def union(self, i: int, j: int) -> bool:
        """Merge two sets; True where they were two."""
        i, j = self.find(i), self.find(j)
        if i == j:
            return False
        low, high = (i, j) if i < j else (j, i)
        self._parent[high] = low
        return True

    def labels(self) -> list[int]:
        """The name of every member's set."""
        return [self.find(i) for i in range(len(self._parent))]
