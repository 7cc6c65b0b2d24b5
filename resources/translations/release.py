"""Writes the `.qm` files that FreeCAD loads from the `.ts` files that people edit.

    python resources/translations/release.py

Does what Qt's `lrelease` does for plain messages, so that nobody needs Qt's tools.
"""

from __future__ import annotations

import struct
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
MAGIC = bytes.fromhex("3cb86418caef9c95cd211cbf60a1bddd")
#: Sections of a file, and parts of a message in it.
HASHES, MESSAGES = 0x42, 0x69
END, TRANSLATION, SOURCE, CONTEXT, COMMENT = 1, 3, 6, 7, 8


def messages_in(ts: Path) -> dict[tuple[str, str], str]:
    """Translations of a `.ts` file by context and source text."""
    found = {}
    for context in ElementTree.parse(ts).getroot().iter("context"):
        name = context.findtext("name", "")
        for message in context.iter("message"):
            found[name, message.findtext("source", "")] = message.findtext("translation", "")
    return found


def qm_of(messages: dict[tuple[str, str], str]) -> bytes:
    """The bytes of a `.qm` file."""
    body, places = b"", []
    for (context, source), translation in sorted(messages.items()):
        text = source.encode()
        places.append((_hash(text), len(body)))
        body += _part(TRANSLATION, translation.encode("utf-16-be"))
        body += _part(SOURCE, text) + _part(CONTEXT, context.encode()) + _part(COMMENT, b"")
        body += bytes([END])
    table = b"".join(struct.pack(">II", *place) for place in sorted(places))
    return MAGIC + _part(HASHES, table) + _part(MESSAGES, body)


def _part(tag: int, data: bytes) -> bytes:
    return struct.pack(">BI", tag, len(data)) + data


def _hash(text: bytes) -> int:
    """The hash of System V's object files, by which Qt finds a message."""
    value = 0
    for byte in text:
        value = (value << 4) + byte
        high = value & 0xF0000000
        value = (value ^ high >> 24) & ~high & 0xFFFFFFFF
    return value or 1


def main() -> None:
    """Write a `.qm` beside each `.ts`."""
    for ts in sorted(HERE.glob("*.ts")):
        ts.with_suffix(".qm").write_bytes(qm_of(messages_in(ts)))


if __name__ == "__main__":
    main()
