"""Must never be imported by us."""

raise ImportError("another addon's `workbench` was imported")
