"""What a solve takes besides the optimisation: processor time of each part, ms.

    OPENBLAS_NUM_THREADS=1 python tests/benchmarks/around.py

Medians for the 52-vertex table and an organizer of 500 vertices, each while a vertex is dragged:
its topology is known, its positions are new.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from incontext.solver import findings, solve
from incontext.solver.faces import find_faces
from incontext.solver.residuals import annotation_residuals
from incontext.solver.serialise import sketch_from_text, sketch_to_text
from incontext.solver.solution import Solution
from incontext.solver.synthetic import organizer, photograph, table
from incontext.solver.values import frozen_mapping

RUNS = 31


def median_ms(work: Callable[[], object], runs: int = RUNS) -> float:
    """Median processor time of some work, ms."""
    times = []
    for _ in range(runs):
        began = time.process_time()
        work()
        times.append(time.process_time() - began)
    return 1e3 * statistics.median(times)


def parts(graph, solution) -> dict[str, Callable[[], object]]:
    """The parts of a solve that are no optimisation."""
    positions = np.array([solution.vertices_mm[v] for v in graph.vertices])
    rows = dict(zip(graph.vertices, positions, strict=True))
    edges = frozen_mapping(graph.edges)
    drawn = np.array([*graph.vertices.values()])

    def reprojection() -> dict[str, float]:
        off = solution.camera.project(positions) - drawn
        return dict(zip(graph.vertices, np.linalg.norm(off, axis=1).tolist(), strict=True))

    def built() -> Solution:
        return Solution(
            solution.sketch,
            solution.status,
            solution.message,
            rows,
            edges,
            solution.faces,
            solution.circles,
            solution.camera,
            report=replace(solution.report),
        )

    return {
        "findings": lambda: findings(graph),
        "faces in 3D": lambda: find_faces(rows, edges),
        "residuals": lambda: annotation_residuals(graph, rows, solution.faces, solution.circles),
        "reprojection": reprojection,
        "digest": lambda: graph.digest,
        "Solution": built,
    }


def main() -> None:
    """Print the figures."""
    for shape in (table(), organizer(24, 9)):
        graph = photograph(shape, np.random.default_rng(1), noise=0.003).graph
        work = parts(graph, solve(graph))
        times = {name: median_ms(part) for name, part in work.items()}
        each = ", ".join(f"{name} {ms:.2f}" for name, ms in times.items())
        print(f"{len(graph.vertices)} vertices: {each}; together {sum(times.values()):.2f} ms")
        text = sketch_to_text(graph)
        print(
            f"    read from its file in {median_ms(lambda t=text: sketch_from_text(t), 7):.1f} ms"
        )


if __name__ == "__main__":
    main()
