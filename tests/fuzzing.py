"""Random and mutated sketch files, put through load, check, solve and save.

    python tests/fuzzing.py --count 100000

runs the cases 0 ... count - 1 in two processes of limited memory and tells each that ended in
anything but a SketchError or a finite solution, or took too long; `--first N --count 1` runs one.
"""

from __future__ import annotations

import argparse
import copy
import json
import os
import random
import resource
import signal
import sys
import time
import warnings
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from multiprocessing import get_context
from pathlib import Path

# Two threads that wait for each other on a busy machine take a hundred times as long.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from wild_sketches import (
    wild_annotation,
    wild_annotations,
    wild_camera,
    wild_circle,
    wild_photo,
    wild_sketch,
)

from incontext.solver import SketchError, findings, solve
from incontext.solver.serialise import (
    sketch_from_text,
    sketch_to_text,
    solution_from_text,
    solution_to_text,
)
from incontext.solver.synthetic import (
    LID,
    SHAPES,
    photograph,
    photograph_turned,
    with_traced_box,
)

MAX_SECONDS = 5.0
MAX_MEMORY_BYTES = 1_000_000_000
#: Cases that one process takes at once.
BATCH = 200
EXAMPLES = sorted(Path(__file__).parent.parent.glob("resources/examples/*/*.sketch.json"))
EXTREMES = [
    0, -1, 1, 0.5, 1e-9, 1e-300, 5e-324, 1e6, -1e6, 1.0000001e6, 1e300, -1e300, 2**70, None, "",
    "v1", "e1", "f1", "c1", "a1", "ground", True, False, [], {}, [[]], "v0", 800, 600.5, "\ud800",
    "\u0000", "v" * 41, float("nan"), float("inf"), -0.0, [1, 2], ["v1", "v2"], {"kind": "glue"},
]  # fmt: skip
#: A longer line is no line that anybody reads.
MAX_LINE = 1000


# Sketches as people draw them, and what is done to them.


def good_sketch(rng: random.Random) -> str:
    """A sketch of a known shape, exact or drawn by hand, or one of the examples."""
    kind = rng.random()
    numbers = np.random.default_rng(rng.randrange(10_000))
    if kind < 0.15 and EXAMPLES:
        return rng.choice(EXAMPLES).read_text(encoding="utf-8")
    if kind < 0.3:
        return sketch_to_text(photograph_turned(LID, numbers)[0])
    # The table has more than half of all vertices: it takes its time.
    shape = rng.choice(SHAPES[:10] if rng.random() < 0.9 else SHAPES)()
    noise = rng.choice([0.0, 0.005, 0.02, 0.3])
    photo = photograph(shape, numbers, noise=noise)
    if rng.random() < 0.1:
        photo = with_traced_box(photo, numbers, aligned=rng.random() < 0.5)
    camera = photo.camera if rng.random() < 0.1 else None
    return sketch_to_text(replace(photo.graph, camera=camera))


def bent_sketch(rng: random.Random) -> str:
    """A good sketch, still valid by its form, with elements moved, added, taken away or mixed."""
    body = json.loads(good_sketch(rng))
    body.setdefault("annotations", {})
    for _ in range(rng.randint(1, 4)):
        rng.choice(BENDS)(rng, body)
    return json.dumps(body)


def _collapse(rng: random.Random, body: dict) -> None:
    """Several vertices in one place."""
    names = sorted(body["vertices"])
    some = rng.sample(names, rng.randint(0, len(names)))
    for v in some:
        body["vertices"][v] = list(body["vertices"][some[0]])


def _flatten(rng: random.Random, body: dict) -> None:
    """Several vertices on one line, level or upright."""
    k = rng.randrange(2)
    for v in rng.sample(sorted(body["vertices"]), rng.randint(0, len(body["vertices"]))):
        body["vertices"][v][k] = 600.0


def _throw(rng: random.Random, body: dict) -> None:
    """Several vertices somewhere."""
    for v in rng.sample(sorted(body["vertices"]), min(3, len(body["vertices"]))):
        body["vertices"][v] = [rng.uniform(-1e3, 3e3), rng.choice([0.0, 600.0, 1e6])]


def _say_more(rng: random.Random, body: dict) -> None:
    body.setdefault("circles", {})
    for k in range(rng.randint(1, 8)):
        more = wild_annotation(rng, body) if body["vertices"] else None
        if more is not None:
            body["annotations"][f"more{k}"] = more


def _say_less(rng: random.Random, body: dict) -> None:
    said = sorted(body["annotations"])
    for id_ in rng.sample(said, rng.randint(0, len(said))):
        del body["annotations"][id_]


def _say_one_kind(rng: random.Random, body: dict) -> None:
    kind = rng.choice(["right_angle", "ground", "parallel", "length", "on_face", "diameter"])
    body["annotations"] = {k: a for k, a in body["annotations"].items() if a["kind"] == kind}


def _trace(rng: random.Random, body: dict) -> None:
    edges = sorted(body["edges"])
    body["construction"] = rng.sample(edges, rng.randint(0, len(edges)))


def _know_camera(rng: random.Random, body: dict) -> None:
    body["camera"] = wild_camera(rng)


def _add_circle(rng: random.Random, body: dict) -> None:
    body.setdefault("circles", {})["more"] = wild_circle(rng)


def _find_faces(_rng: random.Random, body: dict) -> None:
    body.pop("faces", None)


BENDS = (
    _collapse, _flatten, _throw, _say_more, _say_more, _say_less, _say_one_kind, _trace,
    _know_camera, _add_circle, _find_faces,
)  # fmt: skip


def huge_sketch(rng: random.Random) -> str:
    """Thousands of edges in a tangle, some of them annotated."""
    n = rng.choice([1000, 5000, 19_999])
    pairs = {
        "path": lambda k: (k, k + 1),
        "star": lambda k: (0, k + 1),
        "ladder": lambda k: (k, k + 2),
        "rays": lambda k: (k % 40, 40 + k // 40),
        "web": lambda k: (k + 2, k * 7 % (k + 2)),
    }[rng.choice(["path", "star", "ladder", "rays", "web"])]
    edges = {f"e{k}": [f"v{i}" for i in pairs(k)] for k in range(n)}
    edges = {e: ends for e, ends in edges.items() if ends[0] != ends[1]}
    names = sorted({v for ends in edges.values() for v in ends})
    body: dict = {
        "format": "incontext/sketch",
        "version": 1,
        "photo": wild_photo(rng),
        "vertices": {v: [rng.uniform(0, 1600), rng.uniform(0, 1200)] for v in names},
        "edges": edges,
        "circles": {},
    }
    body["annotations"] = wild_annotations(rng, body)
    return json.dumps(body)


def broken_sketch(rng: random.Random) -> str:
    """A good or wild file with values replaced, keys dropped or doubled, or bytes flipped."""
    text = rng.choice([good_sketch, wild_sketch])(rng)
    kind = rng.random()
    if kind < 0.2:
        return flipped(rng, text)
    if kind < 0.25:
        key = rng.choice(['"vertices"', '"edges"', '"kind"', '"version"', '"v1"', '"e1"'])
        return text.replace(key, f"{key}: 1, {key}", 1)
    if kind < 0.28:
        deep = rng.choice([50, 900, 5000, 100_000])
        left, right = rng.choice([("[", "]"), ('{"a":', "}")])
        return text.replace("1600", left * deep + "1" + right * deep, 1)
    body = json.loads(text)
    for _ in range(rng.randint(1, 4)):
        replace_somewhere(rng, body)
    return json.dumps(body)


def flipped(rng: random.Random, text: str) -> str:
    """The text with bytes flipped, put in or taken away."""
    data = bytearray(text.encode())
    for _ in range(rng.randint(1, 5)):
        k = rng.randrange(len(data))
        what = rng.randrange(4)
        if what == 0:
            data[k] ^= 1 << rng.randrange(8)
        elif what == 1:
            del data[k : k + rng.randrange(1, 20)]
        elif what == 2:
            data[k:k] = rng.choice([b'"', b"{", b"]", b",", b"-", b"e9", b"1e", b"\x00", b"NaN"])
        else:
            data[k] = rng.randrange(256)
        if not data:
            break
    return data.decode("utf-8", errors=rng.choice(["replace", "surrogateescape"]))


def replace_somewhere(rng: random.Random, body: dict) -> None:
    """A value somewhere within changed, or its key dropped or doubled."""
    place = body
    while True:
        keys = list(place) if isinstance(place, dict) else list(range(len(place)))
        if not keys:
            return
        key = rng.choice(keys)
        if isinstance(place[key], dict | list) and rng.random() < 0.85:
            place = place[key]
            continue
        what = rng.random()
        if what < 0.2:
            del place[key]
        elif what < 0.3 and isinstance(place, dict):
            place[rng.choice(["x", "v1", "e1", "holes", "ä"])] = copy.deepcopy(place[key])
        elif what < 0.5 and isinstance(place[key], int | float):
            place[key] *= rng.choice([-1, 0, 1e-9, 1e3, 1e9])
        else:
            place[key] = copy.deepcopy(rng.choice(EXTREMES))
        return


KINDS = {"wild": wild_sketch, "bent": bent_sketch, "broken": broken_sketch, "huge": huge_sketch}


@dataclass(frozen=True)
class Outcome:
    """How a case went: a status, or "refused"; and what must not be, if anything."""

    case: int
    kind: str
    ended: str
    seconds: float
    trouble: str | None = None


def case_text(case: int) -> tuple[str, str]:
    """The kind and the text of a case."""
    rng = random.Random(case)
    # Broken files are refused in no time: most cases can be such ones.
    (kind,) = rng.choices(list(KINDS), weights=[1, 1, 14, 0.02])
    return kind, KINDS[kind](rng)


def put_through(text: str) -> str:
    """How a sketch file ends: "refused", or the solution's status; raises where it must not."""
    try:
        graph = sketch_from_text(text)
    except SketchError as error:
        line = str(error)
        assert line
        assert len(line.splitlines()) == 1, line
        assert len(line) < MAX_LINE, line
        return "refused"
    again = sketch_to_text(graph)
    again.encode()
    assert sketch_from_text(again) == graph
    for finding in findings(graph):
        assert len(finding.text.splitlines()) == 1, finding
    solution = solve(graph)
    assert solution.message.endswith((".", ".)")), solution.message
    assert len(solution.message.splitlines()) == 1, solution.message
    assert all(np.isfinite(x).all() for x in solution.vertices_mm.values())
    saved = solution_to_text(solution)
    saved.encode()
    assert solution_to_text(solution_from_text(saved)) == saved
    return solution.status.value


def run_case(case: int) -> Outcome:
    """One case, timed in processor time; an endless loop is cut off."""
    kind, text = case_text(case)
    began = time.process_time()
    ended, trouble = "failed", None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            ended = put_through(text)
    except Exception as error:
        trouble = f"{type(error).__name__}: {str(error)[:300]} {_where(error)}"
    seconds = time.process_time() - began
    if trouble is None and seconds > MAX_SECONDS:
        trouble = f"took {seconds:.1f} s"
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    if trouble is None and memory > MAX_MEMORY_BYTES:
        trouble = f"{memory / 1e6:.0f} MB"
    return Outcome(case, kind, ended, seconds, trouble)


def _where(error: BaseException) -> str:
    places = []
    trace = error.__traceback__
    while trace is not None:
        code = trace.tb_frame.f_code
        places.append(f"{Path(code.co_filename).name}:{trace.tb_lineno} {code.co_name}")
        trace = trace.tb_next
    return " < ".join(reversed(places[-4:]))


def _limit() -> None:
    """In each process: memory, niceness, and an alarm for endless loops."""
    os.nice(10)
    resource.setrlimit(resource.RLIMIT_AS, (4 * MAX_MEMORY_BYTES, 4 * MAX_MEMORY_BYTES))

    def too_long(*_: object) -> None:
        raise TimeoutError("endless")

    signal.signal(signal.SIGPROF, too_long)


def run_batch(cases: range) -> list[Outcome]:
    outcomes = []
    for case in cases:
        signal.setitimer(signal.ITIMER_PROF, 4 * MAX_SECONDS)
        outcomes.append(run_case(case))
    signal.setitimer(signal.ITIMER_PROF, 0)
    return outcomes


def main() -> int:
    """Run cases; the exit status tells whether any failed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--processes", type=int, default=2)
    asked = parser.parse_args()
    last = asked.first + asked.count
    batches = [range(k, min(k + BATCH, last)) for k in range(asked.first, last, BATCH)]
    ended: Counter[tuple[str, str]] = Counter()
    troubles, slowest = 0, 0.0
    began = time.perf_counter()
    with ProcessPoolExecutor(asked.processes, get_context("spawn"), _limit) as pool:
        for outcomes in pool.map(run_batch, batches):
            if ended.total() % 10_000 < BATCH:
                print(f"{ended.total()} cases", file=sys.stderr)
            for outcome in outcomes:
                ended[outcome.kind, outcome.ended] += 1
                slowest = max(slowest, outcome.seconds)
                if outcome.trouble is not None:
                    troubles += 1
                    print(f"case {outcome.case} ({outcome.kind}): {outcome.trouble}", flush=True)
    for (kind, how), n in sorted(ended.items()):
        print(f"{kind:7} {how:15} {n:7}")
    print(f"{troubles} of {asked.count} failed; the slowest took {slowest:.2f} s", end="; ")
    print(f"{time.perf_counter() - began:.0f} s in all")
    return int(troubles > 0)


if __name__ == "__main__":
    sys.exit(main())
