"""Must never be imported by us."""

raise ImportError("another addon's `solver` was imported")
