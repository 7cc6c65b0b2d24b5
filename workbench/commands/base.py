"""What all commands have in common: how FreeCAD shows them, and how a problem is told."""

from __future__ import annotations

from typing import Any, ClassVar

import FreeCAD

from .. import host
from ..problems import in_words, known_problems


class CommandError(Exception):
    """A command that cannot do its work yet; says what to do first."""


class Command:
    """One command.

    Subclasses say what they are called and implement `run`. `run` asks the person what it must
    and leaves the work to a function that scripts and tests can call.
    """

    NAME: ClassVar[str]
    ICON: ClassVar[str]
    MENU_TEXT: ClassVar[str]
    TOOLTIP: ClassVar[str]
    SHORTCUT: ClassVar[str] = ""
    #: Packages, by import name, without which the command need not begin.
    NEEDS: ClassVar[tuple[str, ...]] = ()

    def GetResources(self) -> dict[str, str]:  # noqa: N802  FreeCAD's names
        """How the command looks in menus and toolbars."""
        resources = {
            "Pixmap": host.icon(self.ICON),
            "MenuText": host.translate(self.NAME, self.MENU_TEXT),
            "ToolTip": host.translate(self.NAME, self.TOOLTIP),
        }
        if self.SHORTCUT:
            resources["Accel"] = self.SHORTCUT
        return resources

    def IsActive(self) -> bool:  # noqa: N802
        """Whether the command can be used now."""
        return True

    def Activated(self, index: int = 0) -> None:  # noqa: N802
        """Run the command; a problem a person can do something about is told in words."""
        from ..canvas.photo import PhotoError

        try:
            self._run_with_packages()
        except (CommandError, PhotoError, *known_problems()) as error:
            from ..panels.messages import tell

            tell(in_words(error))

    def _run_with_packages(self) -> None:
        """Run; where a package is missing, offer to install it and run again."""
        from .. import packages

        try:
            packages.require(self.NEEDS)
            self.run()
        except ModuleNotFoundError as error:
            from ..panels.installing import offer_to_install

            host.report(in_words(error))
            if offer_to_install(error):
                self.run()

    def run(self) -> None:
        """Do it."""
        raise NotImplementedError


def active_document() -> Any:
    """The active document, a new one where there is none."""
    return FreeCAD.ActiveDocument or FreeCAD.newDocument()
