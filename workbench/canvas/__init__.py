"""The photo with the sketch over it, in Qt and without FreeCAD."""
