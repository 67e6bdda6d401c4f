# SPDX-License-Identifier: BSD-3-Clause
"""Collisions until the object is out on the paper's scene, every trial a point (paper, figure 7)."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np
from matplotlib.lines import Line2D
from plot_results import COLORS, LEAST

from experiments import methods, sac
from experiments.trials import reported_seeds

WHAT = "collisions until the object is out on the paper's scene, all methods beside the paper's (its figure 7)"
SCENE = "s_shape_two_pegs"
METHODS = ("smore", "smore_told", "chs", "blocked", "paper", "cspace")
COUNT, QUICK_COUNT = 10, 2
SAC_COUNT, SAC_INTERACTIONS = 5, 20000
QUICK_SAC_COUNT, QUICK_SAC_INTERACTIONS = 1, 1000
QUICK_LIMIT = 40  # of collisions, of which the slower methods need hundreds: crosses in the figure
PAPER = {"paper": 96, "cspace": 548, "sac": 3136}  # its means
SPREAD = 0.3  # of the points around their method's line
RESAMPLED = 10000


def sac_trials(quick):
    if quick:
        return sac.trials(SCENE, reported_seeds(QUICK_SAC_COUNT), QUICK_SAC_INTERACTIONS)
    return sac.trials(SCENE, reported_seeds(SAC_COUNT), SAC_INTERACTIONS)


def trials(directory, quick):
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT)
    most = QUICK_LIMIT if quick else None
    ours = [
        methods.trial(directory, SCENE, method, seed, methods.limited(method, most))
        for method in METHODS for seed in seeds
    ]
    return ours + sac_trials(quick)


def interval_of_mean(counts):
    """Within which the mean of such trials is with 95 %, by resampling them."""
    drawn = np.random.default_rng(0).choice(counts, (RESAMPLED, len(counts)))
    return np.percentile(drawn.mean(axis=1), (2.5, 97.5))


def draw_method(axes, line, method, results):
    counts = np.maximum([result["collisions"] for result in results], LEAST)
    reached = np.array([result["success"] for result in results])
    places = line + SPREAD * np.linspace(-1, 1, len(counts) + 2)[1:-1]
    color = COLORS[method]
    axes.scatter(counts[reached], places[reached], s=9, color=color, alpha=0.6, linewidths=0)
    axes.scatter(counts[~reached], places[~reached], s=14, marker="x", color=color, linewidths=0.9)
    if reached.any():
        mean = counts[reached].mean()
        low, high = interval_of_mean(counts[reached])
        axes.errorbar(mean, line, xerr=[[mean - low], [high - mean]], fmt="|", color="black", markersize=11, capsize=2,
                      linewidth=1.1)
        digits = 0 if mean >= 100 else 1
        axes.annotate(f"{mean:.{digits}f}", (mean, line), (0, 9), textcoords="offset points", ha="center", fontsize=7)
    else:
        within = results[0].get("interactions")  # of one method, which is given up by these
        none = f"none in {within:,} interactions" if within else "none arrives"
        axes.annotate(none, (counts.min(), line), (-5, 0), textcoords="offset points", ha="right", va="center", fontsize=6.5)
    if method in PAPER:
        axes.plot(PAPER[method], line, "D", markersize=5, markerfacecolor="none", markeredgecolor="#c62828")


def name_of(method):
    return methods.label(method).replace(" the", "\nthe") if method in methods.METHODS else method


def draw(by_method):
    """A line for each method; wide enough for one column of print."""
    figure, axes = plt.subplots(figsize=(3.5, 0.9 + 0.38 * len(by_method)), constrained_layout=True)
    for line, (method, results) in enumerate(by_method.items()):
        draw_method(axes, line, method, results)
    axes.set_xscale("log")
    axes.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axes.set_ylim(len(by_method) - 0.5, -0.5)
    axes.set_yticks(range(len(by_method)))
    axes.set_yticklabels([name_of(method) for method in by_method], fontsize=8)
    axes.tick_params(axis="x", labelsize=8)
    axes.set_xlabel("collisions until the goal", fontsize=8)
    axes.grid(axis="x", which="major", alpha=0.3)
    legend = [
        Line2D([], [], color="#555555", marker="o", markersize=3, ls="", label="trial"),
        Line2D([], [], color="#555555", marker="x", markersize=4, ls="", label="given up"),
        Line2D([], [], color="black", marker="|", markersize=9, label="mean, 95 %"),
        Line2D([], [], color="#c62828", marker="D", markersize=4, markerfacecolor="none", ls="", label="publication"),
    ]
    axes.legend(handles=legend, loc="lower center", bbox_to_anchor=(0.4, 1.0), ncol=4, fontsize=6.5, frameon=False,
                handletextpad=0.3, columnspacing=0.9)
    return figure


def report(records, _directory):
    """The tables as text, and the figures by their names."""
    by_method = methods.results_of(records)[SCENE]
    lines = [f"| method | {methods.ROW_HEAD} |", "|---" * 6 + "|"]
    lines += [f"| {method} | {methods.row(results)} |" for method, results in by_method.items()]
    figures = {"figure7": draw(by_method)}
    learnt = by_method.get("sac")
    if learnt:
        figures["figure7_sac"] = sac.draw(learnt)
    return "\n".join(lines) + "\n\n" + (sac.table(learnt) if learnt else sac.MISSING), figures
