"""Publishes this folder as the package `incontext`, at FreeCAD's start, console and window alike.

FreeCAD puts every addon's folder on one shared `sys.path`, so plain names such as `workbench` may
be another addon's; and a saved document names the modules of its objects, which must be loadable
before any workbench is opened. FreeCAD runs this text without `__file__` and inside a function:
names defined here are not visible in functions defined here, hence no functions.
"""

import importlib.machinery as _machinery
import importlib.util as _import_util
import os as _os
import sys as _sys

if "incontext" not in _sys.modules:
    # FreeCAD's loader has our path in `InstallFile`, newer ones compile with it; should neither
    # be so any more, `sys.path` is searched for a file that only this addon has.
    _places = [
        _os.path.dirname(locals().get("InstallFile") or globals().get("InstallFile") or ""),
        _os.path.dirname(_sys._getframe(0).f_code.co_filename),
        *_sys.path,
    ]
    _proof = _os.path.join("workbench", "features", "photo_sketch.py")
    for _place in _places:
        if _place and _os.path.isfile(_os.path.join(_place, _proof)):
            _spec = _machinery.ModuleSpec("incontext", None, is_package=True)
            _spec.submodule_search_locations = [_place]
            _sys.modules["incontext"] = _import_util.module_from_spec(_spec)
            break
    else:
        raise ImportError("Modeling in Context: its own folder was not found on sys.path")

    # Documents may be opened and saved before the workbench is.
    from incontext.workbench.features import waking as _waking

    _waking.start()

    # File > Export. Only names: the module is imported when one of these is chosen.
    import FreeCAD as _FreeCAD

    for _kind in (
        "Plates to cut - Modeling in Context (*.dxf *.svg *.pdf *.step)",
        "Solid to print - Modeling in Context (*.stl *.3mf *.step)",
    ):
        _FreeCAD.addExportType(_kind, "incontext.workbench.features.exporting")
