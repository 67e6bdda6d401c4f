# SPDX-License-Identifier: BSD-3-Clause
"""What the choices where the paper is silent do to its method's collisions on its scene, one at a time."""
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from plot_results import COLORS

from experiments import figure7, methods
from experiments.trials import Trial, reported_seeds, scene_with

WHAT = "what the choices where the paper is silent do to its method's collisions on its scene, one at a time"
SCENE = "s_shape_two_pegs"
COUNT, QUICK_COUNT = 5, 1
LIMIT, QUICK_LIMIT = 600, 40  # of collisions
# A name, the parameters of the method (docs/laws.md), and keys of the scene.
CHOICES = (
    ("as it is", {}, {}),
    ("free pose each 1 cm", {"free_distance": 0.01, "free_angle": 0.033}, {}),
    ("free pose each 10 cm", {"free_distance": 0.1, "free_angle": 0.33}, {}),
    ("step of half a voxel", {"step_in_voxels": 0.5}, {}),
    ("step of two voxels", {"step_in_voxels": 2.0}, {}),
    ("line reaches 0.5 m", {"line_half_length": 0.5}, {}),
    ("line reaches 0.25 m", {"line_half_length": 0.25}, {}),
    ("contact from 2 N", {}, {"contact_force": 2}),
    ("contact from 10 N", {}, {"contact_force": 10}),
)


def file_name(choice):
    return choice.replace(" ", "_").replace(".", "")


def trials(directory, quick):
    """Seed after seed, so that what is finished of an interrupted run compares all choices."""
    files = directory / "choices"
    files.mkdir(parents=True, exist_ok=True)
    limit = str(QUICK_LIMIT if quick else LIMIT)
    asked = []
    for choice, parameters, keys in CHOICES:
        scene, told = (files / f"{file_name(choice)}{ending}.yaml" for ending in ("", "_parameters"))
        scene.write_text(scene_with(SCENE, keys))
        values = ", ".join(f"{key}: {value}" for key, value in parameters.items())
        told.write_text(f"paper: {{{values}}}\n")
        options = ("--parameters", str(told), "--max-collisions", limit)
        for seed in reported_seeds(QUICK_COUNT if quick else COUNT):
            asked.append(Trial(f"{choice}/{seed}", str(scene), seed, "paper", options))
    return sorted(asked, key=lambda trial: trial.seed)


def draw(by_choice):
    """A line for each choice, each trial a point, a bar at the median."""
    figure, axes = plt.subplots(figsize=(5.5, 0.9 + 0.3 * len(by_choice)), constrained_layout=True)
    for line, results in enumerate(by_choice.values()):
        counts = [result["collisions"] for result in results]
        for reached, marker in ((True, "o"), (False, "x")):
            shown = [result["collisions"] for result in results if result["success"] == reached]
            axes.scatter(shown, [line] * len(shown), s=14, marker=marker, color=COLORS["paper"], alpha=0.7)
        axes.scatter([statistics.median(counts)], [line], s=160, marker="|", color="black")
    published = figure7.PAPER["paper"]
    axes.axvline(published, color="#c62828", linestyle="--", linewidth=1)
    axes.annotate("publication", (published, -0.6), (3, 0), textcoords="offset points", fontsize=7, color="#c62828")
    axes.set_ylim(len(by_choice) - 0.5, -0.9)
    axes.set_yticks(range(len(by_choice)))
    axes.set_yticklabels(by_choice)
    axes.set_xlim(0, None)
    axes.set_xlabel("collisions until the goal (crosses: given up; bar: median)")
    axes.grid(axis="x", alpha=0.3)
    return figure


def report(records, _directory):
    """The table as text, and the figure by its name."""
    by_choice = {}
    for name, record in records.items():
        by_choice.setdefault(name.split("/")[0], []).append(record["result"])
    lines = [f"| choice | {methods.ROW_HEAD} |", "|---" * 6 + "|"]
    lines += [f"| {choice} | {methods.row(results)} |" for choice, results in by_choice.items()]
    return "\n".join(lines) + "\n", {"choices": draw(by_choice)}
