# SPDX-License-Identifier: BSD-3-Clause
"""Collisions until the object is out on the paper's scene, every trial a point (paper, figure 7)."""
import statistics

import plot_results

from experiments.trials import Trial, reported_seeds

WHAT = "collisions until the object is out on the paper's scene, all methods beside the paper's (its figure 7)"
SCENE = "s_shape_two_pegs"
METHODS = ("smore", "paper", "cspace")
COUNT, QUICK_COUNT = 10, 2


def trials(_directory, quick):
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT)
    return [Trial(f"{method}_{seed}", SCENE, seed, method) for method in METHODS for seed in seeds]


def report(records, _directory):
    """The table as text, and the figure by its name."""
    by_method = {method: [] for method in METHODS}
    for record in records.values():
        by_method[record["trial"]["method"]].append(record["result"])
    lines = ["| method | mean | median | least | most | at the goal |", "|---|---|---|---|---|---|"]
    for method, results in by_method.items():
        counts = [result["collisions"] for result in results]
        reached = sum(result["success"] for result in results)
        lines.append(
            f"| {method} | {statistics.mean(counts):.1f} | {statistics.median(counts):.0f} | {min(counts)} | "
            f"{max(counts)} | {reached} of {len(counts)} |"
        )
    return "\n".join(lines) + "\n", {"figure7": plot_results.draw(by_method, SCENE, [SCENE])}
