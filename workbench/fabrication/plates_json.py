"""NAME.plates.json: every plate in its own frame and where it belongs, for anyone to check."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from .plates import Plate


def plates_json_bytes(plates: Sequence[Plate]) -> bytes:
    """The plates as JSON: finished size in mm, before kerf."""
    body = {"plates": [plate_to_json(plate) for plate in plates]}
    return (json.dumps(body, indent=1, allow_nan=False, ensure_ascii=False) + "\n").encode()


def plate_to_json(plate: Plate) -> dict[str, Any]:
    """One plate as plain lists and numbers."""
    return {
        "id": plate.id,
        "faces": list(plate.face_ids),
        "thickness_mm": plate.thickness_mm,
        "outline": plate.outline.tolist(),
        "holes": [hole.tolist() for hole in plate.holes],
        "world_from_plate": plate.world_from_plate.tolist(),
    }
