# SPDX-License-Identifier: BSD-3-Clause
"""All methods on all scenes, the planar ones and those in space; a trial is given up after 100 or 200 collisions."""
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np
import plot_results

from experiments import methods
from experiments.trials import reported_seeds

WHAT = "all methods on all scenes in the plane and in space, with and without the object told"
PLANAR = (
    "one_peg", "s_shape_two_pegs", "s_shape_three_pegs", "s_shape_perturbed", "hook_on_peg", "c_on_peg", "mug_on_hook",
    "t_in_slot", "comb", "spiral", "random_1", "random_2", "random_3", "random_4", "random_5",
)
SPATIAL = ("hanger_on_rail", "hook_on_rail", "slit", "window")
# What cspace remembers is too little to be worth its time in six dimensions (docs/experiments.md).
SPATIAL_METHODS = [method for method in methods.METHODS if method != "cspace"]
MARKERS = dict(zip(methods.METHODS, "os^Dvp"))
COUNT, LIMIT = 3, 200  # trials of each, collisions of a trial
QUICK_SCENES, QUICK_COUNT, QUICK_LIMIT = ("one_peg", "c_on_peg", "hook_on_peg"), 1, 40


def trials(directory, quick):
    scenes = QUICK_SCENES if quick else PLANAR + SPATIAL
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT)
    most = QUICK_LIMIT if quick else LIMIT
    return [
        methods.trial(directory, scene, method, seed, methods.limited(method, most))
        for scene in scenes for method in (SPATIAL_METHODS if scene in SPATIAL else methods.METHODS) for seed in seeds
    ]


def cell(results):
    """Mean collisions of the trials that reached the goal, and how many did where that is not all."""
    reached = [result["collisions"] for result in results if result["success"]]
    if not results:
        return ""
    if not reached:
        return "-"
    some = "" if len(reached) == len(results) else f" ({len(reached)} of {len(results)})"
    return f"{statistics.mean(reached):.1f}{some}"


def table(results):
    """A row for each scene, a column for each method: empty where it was not tried."""
    lines = [f"| scene | {' | '.join(methods.label(method, '`{}`') for method in methods.METHODS)} |", "|---" * (len(methods.METHODS) + 1) + "|"]
    for scene, by_method in results.items():
        cells = [cell(by_method.get(method, [])) for method in methods.METHODS]
        lines.append(f"| {scene} | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def beside(counts):
    """Shifts of trials that lasted equally long, so that each is seen."""
    return 0.05 * np.array([np.count_nonzero(counts[:i] == count) for i, count in enumerate(counts)])


def draw(results):
    """Each trial a point, a cross where it was given up; a row for each scene."""
    figure, axes = plt.subplots(figsize=(5.4, 1.4 + 0.38 * len(results)), constrained_layout=True)
    shifts = dict(zip(methods.METHODS, np.linspace(-0.33, 0.33, len(methods.METHODS))))
    for row, by_method in enumerate(results.values()):
        for method, some in by_method.items():
            counts = np.maximum([result["collisions"] for result in some], plot_results.LEAST)
            reached = np.array([result["success"] for result in some])
            place, color = row + shifts[method] + beside(counts), plot_results.COLORS[method]
            axes.scatter(counts[reached], place[reached], s=14, marker=MARKERS[method], color=color)
            axes.scatter(counts[~reached], place[~reached], s=16, marker="x", linewidths=1.0, color=color)
    for method in methods.METHODS:
        axes.plot([], [], MARKERS[method], color=plot_results.COLORS[method], label=methods.label(method))
    for edge in range(1, len(results)):
        axes.axhline(edge - 0.5, color="#cccccc", linewidth=0.6)
    axes.set_xscale("log")
    axes.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axes.set_ylim(len(results) - 0.5, -0.5)
    axes.set_yticks(range(len(results)))
    axes.set_yticklabels([scene.replace("_", " ") for scene in results], fontsize=8)
    axes.set_xlabel("collisions until the goal (crosses: given up)")
    axes.grid(axis="x", which="major", alpha=0.3)
    axes.legend(loc="lower center", bbox_to_anchor=(0.4, 1.0), ncol=3, fontsize=8, frameon=False)
    return figure


def report(records, _directory):
    """The table as text, and the figure by its name."""
    results = methods.results_of(records)
    return table(results), {"rivals": draw(results)}
