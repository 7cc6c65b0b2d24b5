"""How a fit check looks: things see-through, overlaps red and the support drawn over all else."""

from __future__ import annotations

from typing import Any

from .view_providers import LiftedModelView

#: Grey glass: existing things.
THING = (0.55, 0.60, 0.68)
THING_EDGE = (0.25, 0.30, 0.38)
SEE_THROUGH = 65
RED = (0.88, 0.10, 0.10)
GREEN = (0.10, 0.60, 0.20)
#: The dot in the centre of mass, in parts of the support's size.
DOT = 0.025


class FitCheckView(LiftedModelView):
    """See the module."""

    ICON = "InContext_FitCheck"

    def dress(self, view_object: Any) -> None:
        """See `View.dress`."""
        if hasattr(view_object, "ShapeAppearance"):  # FreeCAD 1.0 and later
            import FreeCAD

            material = FreeCAD.Material()
            material.DiffuseColor = THING
            view_object.ShapeAppearance = (material,)
        else:
            view_object.ShapeColor = THING
        view_object.Transparency = SEE_THROUGH
        view_object.LineColor = THING_EDGE
        view_object.PointColor = THING_EDGE
        view_object.LineWidth = 1.0
        view_object.PointSize = 2.0

    def attach(self, view_object: Any) -> None:
        """See `View.attach`."""
        from pivy import coin

        super().attach(view_object)
        # Drawn last and over everything: an overlap lies within both bodies that share it.
        self._marks = coin.SoAnnotation()
        self._switch = coin.SoSwitch()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        for node in (pick, self._marks):
            self._switch.addChild(node)
        self._switch.whichChild = coin.SO_SWITCH_ALL
        view_object.RootNode.addChild(self._switch)
        self._draw(view_object.Object)

    def updateData(self, obj: Any, name: str) -> None:  # noqa: N802  FreeCAD's name
        """See `LiftedModelView.updateData`."""
        super().updateData(obj, name)
        if name in ("Overlap", "Support", "CentreOfMass", "Stands"):
            self._draw(obj)

    def onChanged(self, view_object: Any, name: str) -> None:  # noqa: N802
        """The marks come and go with the object."""
        if name == "Visibility" and hasattr(self, "_switch"):
            from pivy import coin

            shown = coin.SO_SWITCH_ALL if view_object.Visibility else coin.SO_SWITCH_NONE
            self._switch.whichChild = shown

    def doubleClicked(self, view_object: Any) -> bool:  # noqa: N802
        """Show the numbers."""
        import FreeCADGui

        # By the command's name: this layer knows no windows.
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(view_object.Object)
        if "InContext_CheckFit" not in FreeCADGui.listCommands():
            FreeCADGui.activateWorkbench("InContextWorkbench")
        FreeCADGui.runCommand("InContext_CheckFit")
        return True

    def _is_good(self) -> bool:
        return getattr(getattr(self, "Object", None), "Status", "") in ("", "good")

    def _draw(self, obj: Any) -> None:
        """Draw the marks anew."""
        if not hasattr(self, "_marks") or "Stands" not in obj.PropertiesList:
            return
        self._marks.removeAllChildren()
        for node in (*_red(obj.Overlap), *_support(obj)):
            self._marks.addChild(node)


def _coloured(colour: tuple[float, float, float], *nodes: Any) -> Any:
    from pivy import coin

    group, light, paint = coin.SoSeparator(), coin.SoLightModel(), coin.SoBaseColor()
    light.model = coin.SoLightModel.BASE_COLOR
    paint.rgb = colour
    for node in (light, paint, *nodes):
        group.addChild(node)
    return group


def _red(overlap: Any) -> list[Any]:
    """The overlaps' faces."""
    from pivy import coin

    if overlap is None or overlap.isNull():
        return []
    points, triangles = overlap.tessellate(0.1)
    if not triangles:
        return []
    places, faces, paint = coin.SoCoordinate3(), coin.SoIndexedFaceSet(), coin.SoMaterial()
    places.point.setValues(0, len(points), [tuple(p) for p in points])
    numbers = [n for triangle in triangles for n in (*triangle, -1)]
    faces.coordIndex.setValues(0, len(numbers), numbers)
    paint.diffuseColor = paint.emissiveColor = RED
    group = coin.SoSeparator()
    for node in (paint, places, faces):
        group.addChild(node)
    return [group]


def _support(obj: Any) -> list[Any]:
    """The polygon on which the object stands, the centre of mass and its plumb line."""
    from pivy import coin

    if not obj.Support:
        return []
    points, centre = [tuple(p) for p in obj.Support], obj.CentreOfMass
    ring = [*points, points[0]]
    foot = (centre.x, centre.y, points[0][2])
    places, lines, style = coin.SoCoordinate3(), coin.SoLineSet(), coin.SoDrawStyle()
    places.point.setValues(0, len(ring) + 2, [*ring, tuple(centre), foot])
    lines.numVertices.setValues(0, 2, [len(ring), 2])
    style.lineWidth = 2
    move, dot = coin.SoTranslation(), coin.SoSphere()
    move.translation = tuple(centre)
    size = max(
        abs(a - b) for one in points for two in points for a, b in zip(one, two, strict=True)
    )
    dot.radius = DOT * max(size, 1.0)
    colour = RED if obj.Status == "tips_over" else GREEN
    return [_coloured(colour, style, places, lines), _coloured(colour, move, dot)]
