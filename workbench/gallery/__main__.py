"""``make gallery``: the pictures and the page ``resources/docs/gallery.md``."""

from __future__ import annotations

import io
import sys
from pathlib import Path

from ...solver.files import write_files
from .. import host
from ..examples import EXAMPLES, load_example
from .outcome import Outcome, outcome
from .panels import close_up, overview, panels, strip
from .table import facts_lines

#: The objects of the paper's figures, once each.
OF_THE_PAPER = frozenset(EXAMPLES) - {"desk_tidy"}
HEADING = """# Gallery

Every shipped example, end to end. From left to right: the photo; the sketch, placed by eye; the
shape; the new object in the photo; the plates on their sheet, or the print cut open. The menu
*Examples* opens each in FreeCAD. `make gallery` makes this page again, `incontext bench --examples`
prints what was measured. The photos are rendered (`resources/scenes`): so the truth is known.
"""
NOTES = """Time is the processor's, from nothing. Gestures: a drag for each line and circle, a click
for each face whose angles are right, and so on. In brackets what it took with real mouse and keys,
from an empty sketch, each typed letter counted (a lid like this one on a table; the organizer
without the notes, its own width given instead; the saucer with the clicks on its marker; the
cover with those on its sheet of A5, and the wheel; the desk tidy as two boxes and their partition,
the wheel and the middle of the uncropped photo counted too). *Measured, true*: existing things,
by the sketch.
"""


def page(outcomes: list[Outcome]) -> str:
    """The page's text."""
    parts = [HEADING]
    for made in outcomes:
        example = made.example
        check = " ".join(line[0].upper() + line[1:].rstrip(".") + "." for line in _check(made))
        parts.append(f"## {example.title}\n\n![{example.title}](gallery/{example.name}.jpg)\n")
        parts.append(f"{example.about} {check}".strip() + "\n")
    parts.append("## Facts\n\n" + "\n".join(facts_lines(outcomes)) + "\n")
    return "\n".join([*parts, NOTES])


def _check(made: Outcome) -> tuple[str, ...]:
    """Whether it stands and fits, in words."""
    return tuple(line for check in made.checks for line in check.lines if "nothing" not in line)


def main() -> int:
    """Write all; names on the command line choose examples whose pictures are made."""
    chosen = sys.argv[1:] or EXAMPLES
    folder = Path(host.resource("docs"))
    outcomes = []
    for name in EXAMPLES:
        made = outcome(load_example(name))
        outcomes.append(made)
        if name in chosen:
            picture = io.BytesIO()
            strip(panels(made)).save(picture, "JPEG", quality=86)
            write_files({folder / "gallery" / f"{name}.jpg": picture.getvalue()})
            print(folder / "gallery" / f"{name}.jpg", flush=True)
    small = [close_up(made) for made in outcomes if made.example.name in OF_THE_PAPER]
    picture = io.BytesIO()
    overview(small).save(picture, "JPEG", quality=86)
    write_files({folder / "gallery" / "overview.jpg": picture.getvalue()})
    write_files({folder / "gallery.md": page(outcomes).encode()})
    return 0


if __name__ == "__main__":
    sys.exit(main())
