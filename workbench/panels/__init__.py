"""What stands between FreeCAD's window and the canvas: tabs, their tiling, messages."""
