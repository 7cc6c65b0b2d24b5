"""How the document objects look in the tree and in the 3D view."""

from __future__ import annotations

from typing import Any, ClassVar

from .. import host

#: Plywood, and the dark edge that a laser leaves.
WOOD = (0.80, 0.67, 0.48)
BURNT_EDGE = (0.35, 0.23, 0.12)
#: The lifted model: the blue of the sketch's own lines, lighter.
LIFTED = (0.62, 0.77, 0.93)
LIFTED_EDGE = (0.10, 0.35, 0.70)
#: Light grey plastic.
PRINT = (0.80, 0.82, 0.84)
PRINT_EDGE = (0.30, 0.32, 0.35)

#: FreeCAD's display mode of a photo in the 3D view.
PHOTO_MODE = "Photo"
#: Part of a face's colour that it has without any light on it.
GLOW = 0.35


class View:
    """Behaviour of an object's looks; the looks themselves are FreeCAD's own properties."""

    ICON: ClassVar[str] = ""

    def __init__(self, view_object: Any) -> None:
        view_object.Proxy = self
        # FreeCAD 1.1 has asked for the icon before.
        view_object.signalChangeIcon()
        self.dress(view_object)

    def dress(self, view_object: Any) -> None:
        """Set the first colours; called once, later ones are the person's."""

    def attach(self, view_object: Any) -> None:
        """FreeCAD calls this when the object appears, also on opening a document."""
        self.Object = view_object.Object

    def getIcon(self) -> str:  # noqa: N802  FreeCAD's name
        """The icon in the tree."""
        return host.icon(self.ICON)

    def dumps(self) -> dict[str, Any]:
        """Nothing is stored but that we are here."""
        return {}

    def loads(self, state: dict[str, Any] | None) -> None:
        """Nothing to take back."""

    __getstate__ = dumps
    __setstate__ = loads


class PhotoSketchView(View):
    """A photo sketch has its own tab; in the 3D view its photo stands behind the object.

    The panels put the photo into `photo_root`, as soon as the sketch is lifted.
    """

    ICON = "InContext_PhotoSketch"

    def attach(self, view_object: Any) -> None:
        """See `View.attach`."""
        from pivy import coin

        super().attach(view_object)
        self.photo_root = coin.SoSeparator()
        view_object.addDisplayMode(self.photo_root, PHOTO_MODE)

    def getDisplayModes(self, view_object: Any) -> list[str]:  # noqa: N802  FreeCAD's names
        """The one way of being shown."""
        return [PHOTO_MODE]

    def getDefaultDisplayMode(self) -> str:  # noqa: N802
        """The same."""
        return PHOTO_MODE

    def setDisplayMode(self, mode: str) -> str:  # noqa: N802
        """The same."""
        return mode

    def doubleClicked(self, view_object: Any) -> bool:  # noqa: N802
        """Open the tab."""
        import FreeCADGui

        # By the command's name: this layer knows no windows.
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(view_object.Object)
        if "InContext_EditSketch" not in FreeCADGui.listCommands():
            FreeCADGui.activateWorkbench("InContextWorkbench")
        FreeCADGui.runCommand("InContext_EditSketch")
        return True


class LiftedModelView(View):
    """The lifted faces, in light blue; its icon shows when the last solve ended badly."""

    ICON = "InContext_LiftedModel"

    def dress(self, view_object: Any) -> None:
        """See `View.dress`."""
        _dress(view_object, LIFTED, LIFTED_EDGE)

    def getIcon(self) -> str:  # noqa: N802
        """The icon in the tree, with a warning where the shape is not what is drawn."""
        return host.icon(self.ICON if self._is_good() else f"{self.ICON}_Warning")

    def updateData(self, obj: Any, name: str) -> None:  # noqa: N802
        """FreeCAD calls this after a property of the object changed."""
        if name == "Status":
            obj.ViewObject.signalChangeIcon()

    def _is_good(self) -> bool:
        obj = getattr(self, "Object", None)
        return getattr(obj, "Status", "") in ("", "converged", "made")


class PlateSetView(LiftedModelView):
    """The plates, in wood."""

    ICON = "InContext_PlateSet"

    def dress(self, view_object: Any) -> None:
        """See `View.dress`."""
        _dress(view_object, WOOD, BURNT_EDGE)


class FlatPlateView(PlateSetView):
    """A flat plate, in wood."""


class FitTestView(PlateSetView):
    """The pieces to try the play with, in the plates' wood."""

    ICON = "InContext_FitTest"


class ShelledSolidView(LiftedModelView):
    """The hollow solid, in the grey of a print."""

    ICON = "InContext_ShelledSolid"

    def dress(self, view_object: Any) -> None:
        """See `View.dress`."""
        _dress(view_object, PRINT, PRINT_EDGE)


def _dress(view_object: Any, faces: tuple[float, ...], edges: tuple[float, ...]) -> None:
    import FreeCAD

    material = FreeCAD.Material()
    material.DiffuseColor = faces
    # Glowing a little: faces that look away from the viewer's lamp are nearly black otherwise.
    material.EmissiveColor = tuple(GLOW * part for part in faces)
    if hasattr(view_object, "ShapeAppearance"):  # FreeCAD 1.0 and later
        view_object.ShapeAppearance = (material,)
    else:
        view_object.ShapeMaterial = material
    view_object.LineColor = edges
    view_object.PointColor = edges
    view_object.LineWidth = 1.0
    view_object.PointSize = 2.0
