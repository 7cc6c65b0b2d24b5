"""A small window that installs missing packages, or shows the command that does."""

from __future__ import annotations

from .. import host
from ..canvas.qt import QtCore, QtGui

#: What is written of pip's own words at most, when it failed.
_LAST_LINES = 6


class InstallDialog(QtGui.QDialog):
    """One button installs; it goes on in the background, can be stopped, and tells how it ended.

    Parameters
    ----------
    names : sequence of str
        The packages, for people.
    command : list of str
        The program that installs them, and its arguments.
    typed : str
        The command for a person to type.
    parent : QWidget, optional
    """

    def __init__(
        self, names: list[str], command: list[str], typed: str, parent: QtGui.QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._command = command
        self._output = ""
        self._process = QtCore.QProcess(self)
        self._process.setProcessChannelMode(QtCore.QProcess.MergedChannels)
        self._process.setProcessEnvironment(_clean_environment())
        self._process.readyReadStandardOutput.connect(self._listen)
        self._process.finished.connect(self._ended)
        self._process.errorOccurred.connect(self._failed_to_start)
        self.setWindowTitle(host.translate("InContext", "Modeling in Context"))
        self.setMinimumWidth(520)
        self._build(names, typed)

    def _build(self, names: list[str], typed: str) -> None:
        self._words = QtGui.QLabel(
            host.translate(
                "InContext",
                "This needs Python packages that are not installed: {}.\n"
                "They are put into FreeCAD's own folder, and may take some minutes and up to 2 GB.",
            ).format(", ".join(names))
        )
        self._words.setWordWrap(True)
        self._progress = QtGui.QProgressBar()
        self._progress.setRange(0, 0)
        self._progress.hide()
        self._typed = QtGui.QLineEdit(typed)
        self._typed.setReadOnly(True)
        self._typed.setCursorPosition(0)
        copy = QtGui.QPushButton(host.translate("InContext", "Copy"))
        copy.setAutoDefault(False)
        copy.clicked.connect(lambda: QtGui.QApplication.clipboard().setText(typed))
        row = QtGui.QHBoxLayout()
        row.addWidget(self._typed, 1)
        row.addWidget(copy)
        self.install_button = QtGui.QPushButton(host.translate("InContext", "Install"))
        self.install_button.setDefault(True)
        self.install_button.clicked.connect(self.install)
        self.close_button = QtGui.QPushButton(host.translate("InContext", "Not now"))
        self.close_button.setAutoDefault(False)
        self.close_button.clicked.connect(self.reject)
        buttons = QtGui.QHBoxLayout()
        buttons.addStretch(1)
        buttons.addWidget(self.close_button)
        buttons.addWidget(self.install_button)
        layout = QtGui.QVBoxLayout(self)
        layout.setSpacing(10)
        layout.addWidget(self._words)
        layout.addWidget(self._progress)
        layout.addWidget(QtGui.QLabel(host.translate("InContext", "Or in a terminal:")))
        layout.addLayout(row)
        layout.addLayout(buttons)

    @property
    def words(self) -> str:
        """What is said."""
        return self._words.text()

    @property
    def is_working(self) -> bool:
        """Whether packages are being installed now."""
        return self._process.state() != QtCore.QProcess.NotRunning

    def install(self) -> None:
        """Begin."""
        self._output = ""
        self._progress.show()
        self.install_button.setEnabled(False)
        self.close_button.setText(host.translate("InContext", "Cancel"))
        self._say(host.translate("InContext", "Installing ..."))
        self._process.start(self._command[0], self._command[1:])

    def reject(self) -> None:
        """Stop where it is at work, else close."""
        if self.is_working:
            self._process.kill()
        else:
            super().reject()

    def closeEvent(self, event: QtGui.QCloseEvent) -> None:  # noqa: N802  Qt's name
        """Leave nothing running behind."""
        self._process.kill()
        self._process.waitForFinished(2000)
        super().closeEvent(event)

    def _say(self, words: str) -> None:
        self._words.setText(words)

    def _listen(self) -> None:
        self._output += bytes(self._process.readAllStandardOutput().data()).decode(errors="replace")
        lines = self._output.split("\n")
        said = next((line.strip() for line in reversed(lines) if line.strip()), "")
        if said and self.is_working:
            self._say(said[:200])

    def _ended(self, status: int, how: QtCore.QProcess.ExitStatus) -> None:
        self._listen()
        if how == QtCore.QProcess.NormalExit and status == 0:
            self.accept()
        elif how == QtCore.QProcess.NormalExit:
            last = "\n".join(self._output.strip().splitlines()[-_LAST_LINES:])
            self._stop(host.translate("InContext", "That did not work:") + f"\n{last}")
        else:
            self._stop(host.translate("InContext", "Stopped; nothing is installed."))

    def _failed_to_start(self, error: QtCore.QProcess.ProcessError) -> None:
        if error == QtCore.QProcess.FailedToStart:
            words = host.translate("InContext", "{} is not there; use the command below.")
            self._stop(words.format(self._command[0]))

    def _stop(self, words: str) -> None:
        self._say(words)
        self._progress.hide()
        self.install_button.setEnabled(True)
        self.install_button.setText(host.translate("InContext", "Try again"))
        self.close_button.setText(host.translate("InContext", "Not now"))


def _clean_environment() -> QtCore.QProcessEnvironment:
    """FreeCAD's own settings for its Python would mislead another one."""
    environment = QtCore.QProcessEnvironment.systemEnvironment()
    for name in ("PYTHONHOME", "PYTHONPATH"):
        environment.remove(name)
    return environment


def offer_to_install(error: ModuleNotFoundError) -> bool:
    """Ask whether to install what is missing, and do so.

    Returns
    -------
    bool
        True where it is there now.
    """
    import FreeCADGui

    from .. import packages
    from .asking import shown

    wanted = packages.requirements_for(str(error.name).split(".")[0])
    dialog = InstallDialog(
        [packages.package_name(one) for one in wanted],
        packages.install_command(wanted),
        packages.command_to_type(wanted),
        FreeCADGui.getMainWindow(),
    )
    installed = shown(dialog)
    if installed:
        packages.look_again()
    return installed
