"""Pure edits of a sketch graph: each gives a new valid graph, the old one stays."""
