# SPDX-License-Identifier: BSD-3-Clause
"""Collisions until the object is out on the paper's scene, every trial a point (paper, figure 7)."""
import plot_results

from experiments import methods, sac
from experiments.trials import reported_seeds

WHAT = "collisions until the object is out on the paper's scene, all methods beside the paper's (its figure 7)"
SCENE = "s_shape_two_pegs"
METHODS = ("smore", "smore_told", "chs", "blocked", "paper", "cspace")
COUNT, QUICK_COUNT = 10, 2
SAC_COUNT, SAC_INTERACTIONS = 5, 20000
QUICK_SAC_COUNT, QUICK_SAC_INTERACTIONS = 1, 1000
QUICK_LIMIT = 40  # of collisions, of which the slower methods need hundreds: crosses in the figure


def sac_trials(quick):
    if quick:
        return sac.trials(SCENE, reported_seeds(QUICK_SAC_COUNT), QUICK_SAC_INTERACTIONS)
    return sac.trials(SCENE, reported_seeds(SAC_COUNT), SAC_INTERACTIONS)


def trials(directory, quick):
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT)
    options = ("--max-collisions", str(QUICK_LIMIT)) if quick else ()
    ours = [methods.trial(directory, SCENE, method, seed, options) for method in METHODS for seed in seeds]
    return ours + sac_trials(quick)


def report(records, _directory):
    """The tables as text, and the figures by their names."""
    by_method = methods.results_of(records)[SCENE]
    lines = [f"| method | {methods.ROW_HEAD} |", "|---" * 6 + "|"]
    lines += [f"| {method} | {methods.row(results)} |" for method, results in by_method.items()]
    figures = {"figure7": plot_results.draw(by_method, SCENE, [SCENE])}
    learnt = by_method.get("sac")
    if learnt:
        figures["figure7_sac"] = sac.draw(learnt)
    return "\n".join(lines) + "\n\n" + (sac.table(learnt) if learnt else sac.MISSING), figures
