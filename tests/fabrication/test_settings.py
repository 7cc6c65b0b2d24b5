"""Settings say what is wrong with them; errors are one line."""

import dataclasses

import pytest

import incontext.workbench.fabrication as fabrication
from incontext.workbench.fabrication import FabricationError, PlateSettings, ShellSettings


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"thickness_mm": 0.0}, "thickness"),
        ({"thickness_mm": float("nan")}, "thickness"),
        ({"kerf_mm": -0.1}, "kerf"),
        ({"play_mm": float("inf")}, "play"),
        ({"finger_mm": 0.0}, "finger width"),
        ({"sheet_mm": (0.0, 100.0)}, "sheet size"),
        ({"side": "left"}, "side"),
    ],
)
def test_a_setting_out_of_range(options, words):
    with pytest.raises(FabricationError, match=words):
        PlateSettings(**options)


def test_shell_settings():
    with pytest.raises(FabricationError, match="wall"):
        ShellSettings(wall_mm=-1.0)
    with pytest.raises(FabricationError, match="side"):
        ShellSettings(side="")


def test_settings_are_frozen_and_can_be_compared():
    assert PlateSettings() == PlateSettings()
    assert hash(PlateSettings(kerf_mm=0.1)) == hash(PlateSettings(kerf_mm=0.1))
    with pytest.raises(dataclasses.FrozenInstanceError):
        PlateSettings().kerf_mm = 1.0


def test_an_error_is_one_line():
    error = FabricationError("too\nthick", ["f1", "f2"], "thinner\tplates")
    assert str(error) == "too thick (f1, f2); try: thinner plates"
    assert (error.ids, isinstance(error, ValueError)) == (("f1", "f2"), True)


def test_public_names():
    for name in fabrication.__all__:
        assert getattr(fabrication, name) is not None
    with pytest.raises(AttributeError, match="nothing"):
        _ = fabrication.nothing
