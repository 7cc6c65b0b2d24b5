"""The frame of a PDF file: pages, what they refer to, and the table of where all of it stands.

Written by hand: PDF 1.4 with nothing but lines and plain words needs no library, and gives the same
bytes every time.
"""

from __future__ import annotations

import math
import zlib
from collections.abc import Sequence

POINTS_PER_MM = 72 / 25.4


def plain(value: float) -> str:
    """At most five decimals, no trailing zeros, never -0."""
    text = f"{value:.5f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def pdf_file(
    pages: Sequence[tuple[tuple[float, float], bytes]], resources: bytes = b"<< >>"
) -> bytes:
    """A PDF file of pages.

    Parameters
    ----------
    pages : sequence of (size, content)
        Width and height, mm; drawing operators, in points.
    resources : bytes
        What the operators refer to: fonts, say.
    """
    kids = " ".join(f"{3 + 2 * n} 0 R" for n in range(len(pages)))
    objects = [
        b"<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>",
        f"<< /Type /Pages /Kids [{kids}] /Count {len(pages)} >>".encode(),
    ]
    for n, (size, content) in enumerate(pages):
        width, height = (plain(math.ceil(side * POINTS_PER_MM * 1000) / 1000) for side in size)
        objects.append(
            f"<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {width} {height}] /Resources ".encode()
            + resources
            + f" /Contents {4 + 2 * n} 0 R >>".encode()
        )
        packed = zlib.compress(content, 9)
        head = f"<< /Length {len(packed)} /Filter /FlateDecode >>\nstream\n".encode()
        objects.append(head + packed + b"\nendstream")
    data = b"%PDF-1.4\n"
    offsets = []
    for n, body in enumerate(objects, start=1):
        offsets.append(len(data))
        data += f"{n} 0 obj\n".encode() + body + b"\nendobj\n"
    table = "".join(f"{offset:010d} 00000 n \n" for offset in offsets)
    tail = f"trailer\n<< /Size {len(objects) + 1} /Root 1 0 R >>\nstartxref\n{len(data)}\n%%EOF\n"
    return data + f"xref\n0 {len(objects) + 1}\n0000000000 65535 f \n{table}{tail}".encode()
