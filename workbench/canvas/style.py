"""Colours and sizes of what is drawn over the photo; sizes in screen px, whatever the zoom.

The language is that of FreeCAD's Sketcher: what is annotated is red, what is traced to help is
dashed, what is selected is cyan. Lines are blue with a white casing, so that they read on light
and dark photos alike.
"""

from __future__ import annotations

EDGE = "#1769c9"
CASING = "#ffffff"
CONSTRUCTION = "#8a4fbf"
VERTEX = "#ffffff"
GROUND = "#1f9d3a"
SYMMETRY = "#12872b"
HOVER = "#ffd21f"
ANNOTATION = "#d8281c"
GROUPS = (ANNOTATION, "#8a2be2", "#00796b", "#a0522d", "#c2185b", "#37474f")
"""Of groups of equal or parallel edges, which differ by the number of their marks as well."""
SELECTED = "#00c2d1"
SNAP = "#e0790b"
GUIDE = "#c25e00"
HOVER_LINE = "#e0a800"
LOOSE = "#ff8c00"
CONFLICT = "#ff0022"
TEXT = "#2e3436"
LEFT_OUT = "#1769c9"
OUTSIDE = "#5c6066"
NUMBER = "#5c3a86"
"""Of a vertex that has parameters; one without is grey."""
NO_NUMBER = "#8c9196"
GHOST = "#6a3fb5"
"""Of what is suggested."""
LIFTED = "#39b6a8"
"""Of the lifted shape's faces, where they lie in the photo."""
LIFTED_LINE = "#0b7a6e"

GRID = "#ffffff"
GRID_CASING = "#1b3a57"

EDGE_PX = 2.0
LIFTED_PX = 1.4
GHOST_PX = 20.0
"""Side of a suggested right angle: larger than a said one, to be clicked beside the vertex."""
PLUS_PX = 5.0
CONSTRUCTION_PX = 1.6
CASING_PX = 1.2
"""How far the casing looks out on both sides of a line."""
SYMBOL_PX = 1.2
VERTEX_RADIUS_PX = 3.6
HOVER_RADIUS_PX = 6.0
RIGHT_ANGLE_PX = 11.0
TICK_PX = 6.0
ARROW_PX = 6.0
MARK_SPACING_PX = 5.0
PLAQUE_DISTANCE_PX = 7.0
TEXT_PX = 12
INVITATION_PX = 16
HALO_PX = 9.0
"""Of the bands behind edges that are lit or selected."""
SYMBOL_HALO_PX = 6.0
"""Of the bands behind symbols that are lit or selected."""
CONFLICT_PX = 12.0
"""Of the bands behind edges of which annotations say what cannot be."""
SNAP_PX = 7.0
DOT_PX = 3.0
GRIP_PX = 7.0
CURSOR_PX = (5.0, 15.0)
"""Where the arms of the keyboard's cursor begin and end."""
DIAMOND_PX = 4.5
TOUCHING_PX = 6.8
"""Radius of the ring around a vertex that touches a face."""
GROUND_PX = 11.0
GROUND_BELOW_PX = 5.6
"""Of the ground below a vertex that stands on it."""
BADGE_PX = 3.0
HATCH_PX = 11.0
FINE_PX = 1.3
"""Of lines that explain: guides, axes, the circles that a side's points stand for."""

#: A vertex is grabbed within this distance of the pointer.
REACH_PX = 9.0
CASING_ALPHA = 225
BOX_ALPHA = 40
AREA_ALPHA = 80
LIFTED_ALPHA = 22
GRID_ALPHA = 105
GRID_STRONG_ALPHA = 210
CONFLICT_ALPHA = 190
PALE_ALPHA = 60
LEFT_OUT_ALPHA = 130
"""Of the hatching over faces left out; 255 is opaque."""
