"""Which packages are asked for where one is missing."""

from __future__ import annotations

import pytest

from incontext.workbench import packages


def test_what_is_needed_for_one_thing_alone_is_asked_for_alone(monkeypatch):
    monkeypatch.setattr(packages, "missing_requirements", lambda: ("cadquery>=2.8",))
    (wanted,) = packages.requirements_for("cv2")
    assert packages.package_name(wanted) == "opencv-python-headless"
    assert packages.requirements_for("cadquery") == ("cadquery>=2.8",)


@pytest.mark.parametrize("name", ["numpy", "PIL", "cadquery"])
def test_where_nothing_seems_missing_the_import_is_asked_for(monkeypatch, name):
    monkeypatch.setattr(packages, "missing_requirements", lambda: ())
    assert packages.requirements_for(name) == (name,)
