# SPDX-License-Identifier: BSD-3-Clause
"""Collisions until the object is out on the paper's scene, every trial a point (paper, figure 7)."""
import plot_results

from experiments import methods
from experiments.trials import reported_seeds

WHAT = "collisions until the object is out on the paper's scene, all methods beside the paper's (its figure 7)"
SCENE = "s_shape_two_pegs"
METHODS = ("smore", "smore_told", "chs", "blocked", "paper", "cspace")
COUNT, QUICK_COUNT = 10, 2
QUICK_LIMIT = 40  # of collisions, of which the slower methods need hundreds: crosses in the figure


def trials(directory, quick):
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT)
    options = ("--max-collisions", str(QUICK_LIMIT)) if quick else ()
    return [methods.trial(directory, SCENE, method, seed, options) for method in METHODS for seed in seeds]


def report(records, _directory):
    """The table as text, and the figure by its name."""
    by_method = methods.results_of(records)[SCENE]
    lines = [f"| method | {methods.ROW_HEAD} |", "|---" * 6 + "|"]
    lines += [f"| {method} | {methods.row(results)} |" for method, results in by_method.items()]
    return "\n".join(lines) + "\n", {"figure7": plot_results.draw(by_method, SCENE, [SCENE])}
