#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares collisions until the goal of several methods, from the JSON files of smore_experiment.

    plot_results.py --output FILE.png RESULT.json [RESULT.json ...]

Each trial is a dot, a box holds the middle half of a method's trials and a line marks their median; a
cross is a trial that did not reach the goal: it is in no mean. Files of one method, of scenes of one name
and of one set of parameters are put together; where a method has several such groups, each is named after
its first file. On the paper's own scene dashed lines are its counts.
"""
import argparse
import collections
import json
import os
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from user_files import read_result, save_picture

# Section IV of the paper: object with two pegs, mean of ten trials.
PAPER_SCENE = "s_shape_two_pegs"
PAPER = (("SMORE", 96, "#3b6fb6"), ("C-space planner", 548, "#7a7a7a"), ("Soft Actor-Critic", 3136, "#b0763a"))
COLORS = {"smore": "#1a9641", "smore_told": "#7fbf3f", "chs": "#8e24aa", "blocked": "#d9730d", "paper": "#3b6fb6", "cspace": "#7a7a7a", "sac": "#b0763a"}
ORDER = ("smore", "smore_told", "chs", "blocked", "paper", "cspace", "sac")
LEAST = 0.8  # where a trial without a collision stands on the logarithmic axis
SPREAD = 0.16  # of the dots around their method's place


def arguments():
    parser = argparse.ArgumentParser(description="Plots collisions until the goal per method.")
    parser.add_argument("results", nargs="+", help="JSON files of smore_experiment")
    parser.add_argument("--output", required=True, help="picture to write")
    parser.add_argument("--title", help="line above the picture (default: the scenarios' names)")
    return parser.parse_args()


def method_of(label):
    return label.split()[0]


def rank(label):
    method = method_of(label)
    return (ORDER.index(method) if method in ORDER else len(ORDER), label)


def task_of(result):
    """What results must have in common to be put together, besides their method."""
    return json.dumps([result["scenario"], result.get("parameters")], sort_keys=True)


def read(files):
    """Trials by method, with a file's name where the method alone does not tell; and the scenarios' names."""
    groups, named_after, scenarios = {}, {}, []
    for file in files:
        result = read_result(file)
        group = result["method"], task_of(result)
        groups.setdefault(group, []).extend(result["trials"])
        named_after.setdefault(group, str(pathlib.Path(file).with_suffix("")))
        if result["scenario"] not in scenarios:
            scenarios.append(result["scenario"])
    counts = collections.Counter(method for method, _ in groups)
    shared = os.path.commonpath([str(pathlib.Path(file).parent) for file in named_after.values()])
    trials = {}
    for group, of_group in groups.items():
        name = os.path.relpath(named_after[group], shared or ".")
        trials[group[0] if counts[group[0]] == 1 else f"{group[0]} ({name})"] = of_group
    return {label: trials[label] for label in sorted(trials, key=rank)}, scenarios


def mean_of(reached, count):
    """The mean of those trials that reached the goal, in words."""
    if not reached.size:
        return "none reached it"
    return f"mean {reached.mean():.3g}" if reached.size == count else f"mean of {reached.size}: {reached.mean():.3g}"


def draw_method(axes, place, trials, color):
    collisions = np.array([trial["collisions"] for trial in trials])
    counts = np.maximum(collisions, LEAST)
    reached = np.array([trial["success"] for trial in trials])
    axes.boxplot(
        counts, positions=[place], widths=0.5, showfliers=False, patch_artist=True,
        boxprops={"facecolor": color, "alpha": 0.25, "edgecolor": color},
        medianprops={"color": color, "linewidth": 2.0},
        whiskerprops={"color": color}, capprops={"color": color},
    )
    places = place + SPREAD * np.linspace(-1.0, 1.0, len(counts)) if len(counts) > 1 else np.array([place])
    axes.scatter(places[reached], counts[reached], s=16, color=color, zorder=3)
    axes.scatter(places[~reached], counts[~reached], s=30, marker="x", color="#c62828", zorder=3)
    axes.annotate(
        mean_of(collisions[reached], len(collisions)), (place, counts.max()), xytext=(0, 8), textcoords="offset points",
        ha="center", fontsize=9, color=color,
    )


def draw(trials, title, scenarios):
    figure, axes = plt.subplots(figsize=(2.6 + (1.7 if len(trials) < 4 else 1.1) * max(len(trials), 2), 4.8), constrained_layout=True)
    for name, count, color in PAPER if scenarios == [PAPER_SCENE] else ():
        axes.axhline(count, color=color, linestyle="--", linewidth=1.0, alpha=0.8)
        axes.annotate(
            f"{name} (publication): {count}", (1.0, count), xycoords=("axes fraction", "data"),
            xytext=(-4, 3), textcoords="offset points", ha="right", fontsize=8, color=color,
        )
    labels = []
    for place, (label, of_method) in enumerate(trials.items()):
        draw_method(axes, place, of_method, COLORS.get(method_of(label), "#8e24aa"))
        reached = sum(trial["success"] for trial in of_method)
        crosses = "" if reached == len(of_method) else "\n(crosses: given up)"
        labels.append(f"{label.replace(' ', chr(10), 1)}\n{reached} of {len(of_method)} at the goal{crosses}")
    axes.set_yscale("log")
    axes.set_ylim(0.7, 8000)
    axes.set_xlim(-0.6, len(trials) + 0.4)
    axes.set_xticks(range(len(trials)))
    axes.set_xticklabels(labels, fontsize=9 if len(trials) < 4 else 7.5)
    axes.set_ylabel("collisions until the goal")
    axes.grid(axis="y", which="major", alpha=0.3)
    axes.set_title(title, fontsize=11)
    return figure


def main():
    options = arguments()
    try:
        trials, scenarios = read(options.results)
    except (OSError, KeyError, TypeError, ValueError) as problem:
        sys.exit(f"plot_results: {problem}")
    if not any(trials.values()):
        sys.exit("plot_results: no trial in these files")
    save_picture(draw(trials, options.title or ", ".join(scenarios), scenarios), options.output, dpi=160)
    print(options.output)


if __name__ == "__main__":
    main()
