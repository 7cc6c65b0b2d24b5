"""Stands in for another addon: its folder on `sys.path` has `workbench` and `solver` too."""
