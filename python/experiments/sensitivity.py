# SPDX-License-Identifier: BSD-3-Clause
"""What voxel size, contact threshold, friction, the sensor's errors, the rate of samples and the order of motions do to
collisions and maps (named and not investigated in the paper)."""
import functools
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from octree_file import OCCUPIED, read_octree
from plot_results import COLORS, LEAST
from scene_geometry import Scene
from table_of_scores import number

from experiments import replays
from experiments.surface import Surface, is_inside
from experiments.trials import Trial, evidence_of, recorded, reported_seeds, scene_with, unperturbed

WHAT = "voxel size, contact threshold, friction, errors, rate and order of samples against collisions and maps"
SCENES = {"smore": "s_shape_perturbed", "paper": "one_peg"}  # paper needs hundreds of collisions elsewhere
MOST_COLLISIONS = {"smore": 60, "paper": 200}
COUNT, QUICK_COUNT = 10, 1
# Key of a scenario, the form of its value, the values, and the axis' label.
SWEEPS = (
    ("voxel_size", "{}", (0.01, 0.02, 0.03, 0.05, 0.08), "voxel size [m]"),
    ("contact_force", "{}", (2, 5, 10, 20), "force at which\nit is a contact [N]"),
    ("friction", "{}", (0, 0.3, 0.6, 0.9), "friction coefficient"),
    ("line_noise", "{{direction: {}}}", (0, 0.05, 0.1, 0.2), "error of a line's\ndirection [rad]"),
    ("wrench_noise", "{{force_stddev: {}}}", (0, 0.5, 1.75, 3.5), "noise of a\nforce sample [N]"),
)
MARKERS = {"object": "o", "world": "^"}  # of the maps' precision
RECORDED_COUNT, QUICK_RECORDED_COUNT = 5, 1  # trials whose evidence is told anew
RATE = 500  # of the samples [1/s]
ONE_IN = (1, 10, 50, 250)  # of them kept
ORDERS = 4


def trials(directory, quick):
    scenes = directory / "scenes"
    scenes.mkdir(parents=True, exist_ok=True)
    asked = []
    for method, base in SCENES.items():
        options = ("--max-collisions", str(MOST_COLLISIONS[method]))
        for key, form, values, _ in SWEEPS:
            for value in values:
                scene = scenes / f"{method}_{key}_{value}.yaml"
                scene.write_text(scene_with(base, {key: form.format(value)}))
                for seed in reported_seeds(QUICK_COUNT if quick else COUNT):
                    asked.append(Trial(f"{method}/{key}={value}/{seed}", str(scene), seed, method, options))
        scene = unperturbed(base, scenes)
        for seed in reported_seeds(QUICK_RECORDED_COUNT if quick else RECORDED_COUNT):
            asked.append(recorded(f"recorded_{method}_{seed}", scene, seed, method, directory, options))
    return asked


def mean_or_none(values):
    known = [value for value in values if value is not None]
    return statistics.mean(known) if known else None


def results_of(records, name):
    return [record["result"] for trial, record in records.items() if trial.startswith(f"{name}/")]


def precisions(results):
    """Of the object's and the world's map, in the mean."""
    return [mean_or_none([result[f"{side}_map"]["precision"] for result in results]) for side in MARKERS]


def draw_collisions(axes, place, results, color):
    """Each trial a point, a cross where it was given up, a bar at the mean of all."""
    counts = np.maximum([result["collisions"] for result in results], LEAST)
    reached = np.array([result["success"] for result in results])
    axes.scatter(np.full(reached.sum(), place), counts[reached], s=9, color=color, alpha=0.4)
    axes.scatter(np.full((~reached).sum(), place), counts[~reached], s=14, marker="x", linewidths=0.8, color=color, alpha=0.6)
    axes.scatter([place], [counts.mean()], s=90, marker="_", color=color)


def draw_sweep(panels, records, key, values, label):
    """Collisions above, precision of both maps below; the methods side by side."""
    for shift, method in zip((-0.14, 0.14), SCENES):
        for place, value in enumerate(values):
            results = results_of(records, f"{method}/{key}={value}")
            draw_collisions(panels[0], place + shift, results, COLORS[method])
            for precision, marker in zip(precisions(results), MARKERS.values()):
                if precision is not None:
                    panels[1].scatter([place + shift], [precision], s=22, marker=marker, color=COLORS[method], alpha=0.8)
    panels[0].set_yscale("log")
    panels[0].yaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    panels[1].set(xlabel=label, ylim=(0, 1.05), xlim=(-0.5, len(values) - 0.5))
    panels[1].set_xticks(range(len(values)))
    panels[1].set_xticklabels([f"{value:g}".replace("0.", ".") for value in values], fontsize=8)
    for axes in panels:
        axes.grid(axis="y", alpha=0.3)


def draw_sweeps(records):
    figure, panels = plt.subplots(
        2, len(SWEEPS), figsize=(7.2, 4.4), sharex="col", sharey="row", constrained_layout=True)
    for column, (key, _, values, label) in zip(panels.T, SWEEPS):
        draw_sweep(column, records, key, values, label)
    panels[0, 0].set_ylabel("collisions until the goal\n(crosses: given up)")
    panels[1, 0].set_ylabel("mean precision\nof the maps")
    for method, scene in SCENES.items():
        name = f"{method}, {scene}".replace("_", " ")
        panels[0, 0].scatter([], [], s=90, marker="_", color=COLORS[method], label=name)
    for side, marker in MARKERS.items():
        panels[0, 0].scatter([], [], s=22, marker=marker, color="#555555", label=side)
    figure.suptitle(" ", fontsize=22)  # room for the legend
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="upper center", ncol=4, frameon=False, fontsize=8)
    return figure


class Solids:
    """Of one side, true."""

    def __init__(self, solids):
        self.solids, self.surface = solids, Surface(solids)

    def are_near(self, centers, distance):
        """Whether each point is within a distance of the solids, or inside."""
        if not len(centers):
            return np.zeros(0, dtype=bool)
        near = self.surface.distances(centers) <= distance
        return near | np.any([is_inside(centers, solid) for solid in self.solids], axis=0)


class Maps:
    """Both maps of a directory beside the true solids of each side."""

    def __init__(self, directory, truth):
        self.occupied, right = set(), []
        for side, solids in truth.items():
            centers, _sizes, probabilities, voxel = read_octree(directory / f"{side}.ot")
            centers = centers[probabilities >= OCCUPIED]
            self.occupied |= {(side, *(center / voxel).round(1)) for center in centers}
            right += list(solids.are_near(centers, voxel))
        self.precision = float(np.mean(right)) if right else None

    def agreement(self, other):
        """Share of the voxels that are occupied in one of both that are so in both."""
        either = self.occupied | other.occupied
        return len(self.occupied & other.occupied) / len(either) if either else None


class Retold:
    """The maps of one recorded trial, at all rates and in all orders."""

    def __init__(self, record, truth, directory):
        evidence = evidence_of(record)

        def maps(name, change):
            output = directory / "maps" / record["trial"]["name"] / name
            return Maps(replays.maps_of(evidence, change, output), truth)

        self.by_rate = [maps(f"one_in_{n}", functools.partial(replays.thinned, one_in=n)) for n in ONE_IN]
        self.by_order = [maps(f"order_{n}", functools.partial(replays.reordered, seed=n)) for n in range(ORDERS)]

    def agreements(self):
        """With the maps of all samples in their order: by rate, and the mean of the other orders."""
        first = self.by_rate[0]
        others = [first.agreement(maps) for maps in self.by_order]
        return [first.agreement(maps) for maps in self.by_rate], mean_or_none(others)


def table_of_sweeps(records):
    lines = ["| method | key | value | mean | most | at the goal | object: precision | world: precision |", "|---" * 8 + "|"]
    for method in SCENES:
        for key, _, values, _ in SWEEPS:
            for value in values:
                results = results_of(records, f"{method}/{key}={value}")
                counts = [result["collisions"] for result in results]
                reached, maps = sum(result["success"] for result in results), precisions(results)
                lines.append(
                    f"| {method} | {key} | {value} | {statistics.mean(counts):.1f} | {max(counts)} | "
                    f"{reached} of {len(counts)} | {number(maps[0], 2)} | {number(maps[1], 2)} |"
                )
    return "\n".join(lines) + "\n"


def table_of_retold(by_method):
    lines = ["| method | samples told | precision of the maps | voxels as with all, in order |", "|---" * 4 + "|"]
    for method, some in by_method.items():
        for place, one_in in enumerate(ONE_IN):
            precision = mean_or_none([each.by_rate[place].precision for each in some])
            agreement = mean_or_none([each.agreements()[0][place] for each in some])
            lines.append(f"| {method} | {RATE / one_in:g} a second | {number(precision, 2)} | {number(agreement, 2)} |")
        precision = mean_or_none([maps.precision for each in some for maps in each.by_order])
        agreement = mean_or_none([each.agreements()[1] for each in some])
        lines.append(f"| {method} | all, motions in another order | {number(precision, 2)} | {number(agreement, 2)} |")
    return "\n".join(lines) + "\n"


def retold(records, method, directory):
    """All recorded trials of a method, in one scene."""
    some = [record for name, record in records.items() if name.startswith(f"recorded_{method}_")]
    scene = Scene(some[0]["trial"]["scenario"])
    truth = {"world": Solids(scene.environment), "object": Solids(scene.object)}
    return [Retold(record, truth, directory) for record in some]


def report(records, directory):
    """The tables as text, and the figure by its name."""
    by_method = {method: retold(records, method, directory) for method in SCENES}
    return table_of_sweeps(records) + "\n" + table_of_retold(by_method), {"sensitivity": draw_sweeps(records)}
