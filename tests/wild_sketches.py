"""Random sketch files that are valid by their form, however wild by what they say."""

from __future__ import annotations

import itertools
import json
import math
import random

import numpy as np

IDS = ("v", "ä", "点", "е\u0301", "🙂", "-", '"', "\\", "'", "0")


def wild_sketch(rng: random.Random) -> str:
    """A sketch of random elements of all kinds that refer to each other properly."""
    prefix = rng.choice(IDS) if rng.random() < 0.1 else "v"
    vertices = wild_vertices(rng, prefix)
    names = list(vertices)
    pairs = [(v, w) for i, v in enumerate(names) for w in names[:i]]
    rng.shuffle(pairs)
    edges = {f"e{k}": list(p) for k, p in enumerate(pairs[: rng.randint(0, 2 * len(names))])}
    circles = {f"c{k}": wild_circle(rng) for k in range(rng.choice([0, 0, 0, 1, 2, 3]))}
    body = {
        "format": "incontext/sketch",
        "version": 1,
        "photo": wild_photo(rng),
        "vertices": vertices,
        "edges": edges,
        "circles": circles,
        "revolutions": wild_revolutions(rng, names, edges, list(circles)),
        "construction": rng.sample(sorted([*edges, *circles]), rng.randint(0, len(edges)))
        if rng.random() < 0.3
        else [],
        "camera": wild_camera(rng) if rng.random() < 0.15 else None,
    }
    if rng.random() < 0.5 and len(names) >= 3:
        body["faces"] = wild_faces(rng, names)
    body["annotations"] = wild_annotations(rng, body)
    return json.dumps(body)


def wild_vertices(rng: random.Random, prefix: str) -> dict[str, list[float]]:
    """Positions on coarse grids (many coincide or lie on lines), or anywhere, or far away."""
    n = rng.choice([1, 2, 3, 4, 5, 6, 8, 8, 10, 12])
    kind = rng.choice(["point", "grid", "grid", "photo", "photo", "line", "far", "tiny"])
    draw = {
        "point": lambda: [5.0, 5.0],
        "grid": lambda: [rng.randint(0, 4) * 100.0, rng.randint(0, 4) * 100.0],
        "photo": lambda: [rng.uniform(0, 1600), rng.uniform(0, 1200)],
        "line": lambda: [float(k := rng.randint(0, 1000)), 3.0 * k],
        "far": lambda: [rng.choice([-1e6, 0.0, 1e6]), rng.uniform(-1e6, 1e6)],
        "tiny": lambda: [800 + rng.uniform(0, 1e-9), 600 + rng.uniform(0, 1e-9)],
    }[kind]
    return {f"{prefix}{i}": draw() for i in range(n)}


def wild_circle(rng: random.Random) -> dict:
    x, y = rng.uniform(0, 1600), rng.uniform(0, 1200)
    a, b = rng.choice([0.0, 1e-9, 20, 200, 5000]), rng.choice([0.0, 1e-6, 10, 100, 300])
    turn = rng.choice([0.0, 0.0, 0.5, 2.0])
    c, s = math.cos(turn), math.sin(turn)
    if rng.random() < 0.1:
        c, s = 0.0, 0.0
    return {
        "a": [[x - a * c, y - a * s], [x + a * c, y + a * s]],
        "b": [[x + b * s, y - b * c], [x - b * s, y + b * c]],
    }


def wild_photo(rng: random.Random) -> dict | None:
    photo: dict = {"file": rng.choice([None, "desk.jpg"]), "width_px": 1600, "height_px": 1200}
    if rng.random() < 0.2:
        photo |= {"width_px": rng.choice([1, 100_000]), "height_px": rng.choice([1, 1200])}
    if rng.random() < 0.3:
        photo["focal_px"] = rng.choice([1e-6, 1.0, 900.0, 1500.0, 1e6])
    if rng.random() < 0.2:
        photo["principal_point_px"] = [rng.choice([0.0, 800.0, -1e6]), rng.choice([600.0, 1e6])]
    return rng.choice([None, photo, photo])


def wild_camera(rng: random.Random) -> dict:
    turn = np.linalg.qr(np.random.default_rng(rng.randrange(99)).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    return {
        "focal_px": rng.choice([1e-3, 900.0, 1500.0, 1e6]),
        "principal_point_px": [800, 600],
        "rotation_cam_from_world": turn.tolist(),
        "translation_cam_from_world_mm": [rng.uniform(-500, 500) for _ in range(3)],
    }


def wild_revolutions(rng: random.Random, vertices: list, edges: dict, circles: list) -> dict:
    found = {}
    for k in range(rng.choice([0, 1, 1, 2]) if circles else 0):
        profile = rng.sample(vertices, min(len(vertices), rng.randint(2, 5)))
        if len(profile) < 2:
            continue
        for v, w in itertools.pairwise(profile):
            if rng.random() < 0.7 and not any({v, w} == set(p) for p in edges.values()):
                edges[f"p{len(edges)}"] = [v, w]
        ground, bottom, top = (rng.choice(circles) for _ in range(3))
        found[f"r{k}"] = {"ground": ground, "bottom": bottom, "top": top, "profile": profile}
    return found


def wild_faces(rng: random.Random, vertices: list) -> dict:
    found = {}
    for k in range(rng.randint(0, 3)):
        face: dict = {"loop": rng.sample(vertices, rng.randint(3, min(6, len(vertices))))}
        if rng.random() < 0.2:
            face["holes"] = [rng.sample(vertices, 3)]
        if rng.random() < 0.3:
            face |= {"included": rng.random() < 0.5, "thickness_mm": rng.choice([1e-9, 3, 1e6])}
        found[f"f{k + 1}"] = face
    return found


def wild_annotations(rng: random.Random, body: dict) -> dict:
    """Annotations of all kinds, at random: most of them contradict each other."""
    found = {}
    for k in range(rng.choice([0, 1, 3, 6, 12, 30])):
        annotation = wild_annotation(rng, body)
        if annotation is not None:
            found[f"a{k}"] = annotation
    return found


def wild_annotation(rng: random.Random, body: dict) -> dict | None:
    vertices, edges, circles = (sorted(body[key]) for key in ("vertices", "edges", "circles"))
    kind = rng.choice(
        ["right_angle", "right_angle", "right_angle", "parallel", "equal_length", "ground",
         "length", "symmetry_plane", "diameter", "on_face"]
    )  # fmt: skip
    size = rng.choice([1e-6, 1e-3, 5, 100, 250.5, 1e6])
    if kind == "right_angle":
        at = rng.choice(vertices)
        there = [e for e in edges if at in body["edges"][e]]
        if len(there) >= 2:
            return {"kind": kind, "at": at, "between": rng.sample(there, 2)}
    elif kind == "ground":
        return {"kind": kind, "vertices": rng.sample(vertices, rng.randint(1, len(vertices)))}
    elif kind == "length" and edges:
        return {"kind": kind, "edge": rng.choice(edges), "length_mm": size}
    elif kind == "diameter" and circles:
        return {"kind": kind, "circle": rng.choice(circles), "diameter_mm": size}
    elif kind == "on_face":
        faces = body.get("faces", {"f1": None, "f2": None, "f99": None})
        if faces:
            return {"kind": kind, "vertex": rng.choice(vertices), "face": rng.choice(list(faces))}
    elif kind == "symmetry_plane" and edges:
        return {"kind": kind, "midpoints_of": rng.sample(edges, rng.randint(1, len(edges)))}
    elif kind in ("parallel", "equal_length") and len(edges) >= 2:
        return {"kind": kind, "edges": rng.sample(edges, rng.randint(2, len(edges)))}
    return None
