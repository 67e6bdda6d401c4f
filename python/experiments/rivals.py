# SPDX-License-Identifier: BSD-3-Clause
"""All methods on all scenes, the planar ones and those in space; a trial is given up after 100 or 200 collisions."""
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


def table(results):
    lines = [f"| scene | method | {methods.ROW_HEAD} |", "|---" * 7 + "|"]
    for scene, by_method in results.items():
        lines += [f"| {scene} | {method} | {methods.row(some)} |" for method, some in by_method.items()]
    return "\n".join(lines) + "\n"


def draw(results):
    """Each trial a point, a cross where it was given up; a column for each scene."""
    figure, axes = plt.subplots(figsize=(2.0 + 0.75 * len(results), 4.6), constrained_layout=True)
    shifts = np.linspace(-0.3, 0.3, len(methods.METHODS))
    for column, by_method in enumerate(results.values()):
        for shift, (method, some) in zip(shifts, by_method.items()):
            counts = np.maximum([result["collisions"] for result in some], plot_results.LEAST)
            reached = np.array([result["success"] for result in some])
            place, color = np.full(len(some), column + shift), plot_results.COLORS[method]
            label = method if column == 0 else None
            axes.scatter(place[reached], counts[reached], s=18, color=color)
            axes.scatter(place[~reached], counts[~reached], s=22, marker="x", color=color)
            axes.plot([], [], "o", color=color, label=label)
    for edge in range(1, len(results)):
        axes.axvline(edge - 0.5, color="#cccccc", linewidth=0.6)
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axes.set_xlim(-0.5, len(results) - 0.5)
    axes.set_xticks(range(len(results)))
    axes.set_xticklabels([scene.replace("_", " ") for scene in results], rotation=45, ha="right", fontsize=8)
    axes.set_ylabel("collisions until the goal\n(crosses: given up)")
    axes.grid(axis="y", which="major", alpha=0.3)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3, fontsize=8, frameon=False)
    return figure


def report(records, _directory):
    """The table as text, and the figure by its name."""
    results = methods.results_of(records)
    return table(results), {"rivals": draw(results)}
