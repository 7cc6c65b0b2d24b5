"""`incontext fit`: what is in the way, in words and in the exit status."""

from pathlib import Path

import pytest
from tracing import with_block

from incontext.solver import load_sketch, save_sketch
from incontext.workbench.cli import main

SHELF = Path(__file__).parent / "data" / "shelf.sketch.json"


def fit(capsys, tmp_path, *blocks, options=()):
    graph = load_sketch(SHELF)
    for n, (low, size) in enumerate(blocks):
        graph = with_block(graph, low, size, f"b{n}")
    path = tmp_path / "shelf.sketch.json"
    save_sketch(graph, path)
    status = main(["fit", str(path), *options])
    caught = capsys.readouterr()
    assert caught.err == ""
    return status, caught.out.splitlines()


def test_nothing_to_fit_to(tmp_path, capsys):
    status, lines = fit(capsys, tmp_path)
    assert status == 0
    assert lines[0].startswith("nothing to fit to")
    assert lines[1].startswith("it stands: ")


def test_a_book_in_the_shelf(tmp_path, capsys):
    book = ((150, 20), (60, 120, 200))
    status, lines = fit(capsys, tmp_path, book)
    assert status == 0
    assert "fits, touches f1" in lines[0]
    assert "7.0 mm right" in lines[0]
    assert "one pixel of the photo is" in lines[0]


@pytest.mark.parametrize("options", [(), ("--print", "--wall", "3")])
def test_a_box_in_the_way(tmp_path, capsys, options):
    status, lines = fit(capsys, tmp_path, ((-40, 60), (60, 80, 120)), options=options)
    assert status == 4
    assert "does not fit, it reaches 20.0 mm into " in lines[0]


def test_make_says_what_is_in_the_way(tmp_path, capsys):
    path = tmp_path / "shelf.sketch.json"
    save_sketch(with_block(load_sketch(SHELF), (-40, 60), (60, 80, 120)), path)
    arguments = ["make", str(path), "--out", str(tmp_path / "out"), "--explain"]
    assert main(arguments) == 0
    caught = capsys.readouterr()
    assert "note: block be0: does not fit, it reaches 20.0 mm into f4" in caught.err
    assert "it stands: its centre of mass lies" in caught.out
