# SPDX-License-Identifier: BSD-3-Clause
"""A chair reconstructed by touching it with a rod, at random, along a sweep as a hand would do it, and where touches
tell most (paper, figure 10)."""
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from octree_file import OCCUPIED
from scene_geometry import Scene

from experiments import best_touches, in_space, sweep
from experiments.recording import Recording
from experiments.surface import Surface
from experiments.trials import ROOT, evidence_of, recorded, reported_seeds

WHAT = "a chair reconstructed with a rod, by touches at random, along a sweep, and informed ones (its figure 10)"
SCENE = ROOT / "config/scenarios/chair.yaml"
KINDS = ("random", "sweep", "informed")
COLORS = {"random": "#d55e00", "sweep": "#009e73", "informed": "#0072b2"}
TOUCHES_OF = {"random": "random touches", "sweep": "touches of a sweep", "informed": "informed touches"}
STYLES = {"random": "--", "sweep": ":", "informed": "-"}
TOUCHES, QUICK_TOUCHES = 30, 10
COUNT, QUICK_COUNT = 2, 1
SHOWN = 4  # numbers of touches at which the maps are scored
SEED = reported_seeds(1)[0]  # of the trials that are drawn
FARTHEST = 12  # distance that the histogram tells apart [cm]


def scene_with(touches, directory):
    directory.mkdir(parents=True, exist_ok=True)
    file = directory / f"chair_{touches}.yaml"
    file.write_text(re.sub(r"touches: \d+", f"touches: {touches}", SCENE.read_text()))
    return str(file)


def options_of(kind, directory):
    """Of smore_experiment."""
    if kind == "random":
        return ("--random-touches",)
    if kind == "sweep":
        return ("--touch-poses", sweep.write(Scene(SCENE), directory / "sweep.yaml"))
    return ("--informed-touches",)


def trials(directory, quick):
    scenes = directory / "scenes"
    scene = scene_with(QUICK_TOUCHES if quick else TOUCHES, scenes)
    return [
        recorded(f"{kind}_{seed}", scene, seed, "smore", directory, options_of(kind, scenes))
        for kind in KINDS for seed in reported_seeds(QUICK_COUNT if quick else COUNT)
    ]


class Growth:
    """How good the world's map is after so many touches of a trial."""

    def __init__(self, record, surface, directory):
        self.recording = Recording(evidence_of(record))
        self.directory = directory / "maps" / record["trial"]["name"]
        touched = np.flatnonzero([motion.touched for motion in self.recording.motions])
        chosen = np.unique(np.linspace(0, len(touched) - 1, SHOWN).round().astype(int))
        self.touches = chosen + 1
        befores = [*touched[chosen[:-1]] + 1, len(self.recording.motions)]  # all that came after the last touch counts
        self.accuracy, self.completeness = np.array([self._score(surface, before) for before in befores]).T

    def occupied(self, index):
        """Centres of the occupied voxels before a motion [m], and their edge [m]."""
        centers, _sizes, probabilities, voxel = self.recording.maps_before(index, self.directory)[0]
        return centers[probabilities >= OCCUPIED], voxel

    def places(self):
        """Where each contact truly was, in the world [m]."""
        return [motion.places.mean(axis=0) for motion in self.recording.motions if motion.places is not None and motion.places.size]

    def last(self):
        return self.occupied(len(self.recording.motions))

    def _score(self, surface, index):
        centers, voxel = self.occupied(index)
        near = surface.distances(centers) <= voxel
        return near.mean() if near.size else np.nan, surface.share_near(centers, voxel)


def draw_growth(growths):
    """Accuracy and completeness against touches, each trial a curve."""
    figure, panels = plt.subplots(1, 2, figsize=(7.2, 2.8), constrained_layout=True)
    for kind, of_kind in growths.items():
        for number, growth in enumerate(of_kind):
            style = {"color": COLORS[kind], "linestyle": STYLES[kind], "marker": "o", "markersize": 3, "linewidth": 1.2}
            label = kind if number == 0 else None
            panels[0].plot(growth.touches, growth.accuracy, label=label, **style)
            panels[1].plot(growth.touches, growth.completeness, label=label, **style)
    panels[0].set_title("accuracy: occupied voxels within a voxel\nof the chair's surface", fontsize=9)
    panels[1].set_title("completeness: surface within a voxel\nof an occupied one", fontsize=9)
    for axes in panels:
        axes.set(xlabel="touches", ylabel="share", ylim=(0, 1.03), xlim=(0, None))
        axes.grid(alpha=0.3)
    panels[1].legend(frameon=False, title="touches", fontsize=8, loc="upper left")
    return figure


def draw_distances(growths, surface):
    """Histograms of the occupied voxels' distances, as shares, all trials of a kind together."""
    figure, axes = plt.subplots(figsize=(3.5, 2.9), constrained_layout=True)
    for kind, of_kind in growths.items():
        found = [growth.last() for growth in of_kind]
        voxel = found[0][1]
        distances = np.concatenate([surface.distances(centers) for centers, _ in found])
        share = np.mean(distances <= voxel) if distances.size else np.nan
        axes.hist(
            np.minimum(100 * distances, FARTHEST), bins=np.arange(0, FARTHEST + 1, 0.5), histtype="step",
            weights=np.full(len(distances), 1 / max(1, len(distances))),
            linewidth=1.4, color=COLORS[kind], linestyle=STYLES[kind], label=f"{kind}: {share:.2f} within a voxel")
    axes.axvline(100 * voxel, color="#888888", linewidth=0.8)
    axes.set(xlabel="distance to the chair's surface [cm]", ylabel="share of the occupied voxels")
    axes.set_xticks([0, 4, 8, FARTHEST + 0.25])
    axes.set_xticklabels(["0", "4", "8", f"{FARTHEST}+"])
    axes.legend(frameon=False, fontsize=8, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    return figure


def draw_reconstructions(growths, scene):
    figure = plt.figure(figsize=(7.2, 3.4))
    figure.subplots_adjust(left=0.0, right=0.93, bottom=0.18, top=0.93, wspace=0.15)
    corners = np.concatenate(scene.environment).reshape(-1, 3)
    for number, (kind, of_kind) in enumerate(growths.items()):
        axes = figure.add_subplot(1, len(growths), number + 1, projection="3d")
        centers, voxel = of_kind[0].last()
        in_space.draw_voxels(axes, centers, voxel)
        in_space.draw_edges(axes, scene.environment)
        in_space.set_up(axes, np.concatenate([corners, centers - voxel, centers + voxel]), 18, -55)
        axes.set_title(f"{of_kind[0].touches[-1]} {TOUCHES_OF[kind]}: {len(centers)} voxels", fontsize=8)
    return figure


def table(growths):
    lines = ["| touches | trial | made | occupied voxels | accuracy | completeness |", "|---" * 6 + "|"]
    for kind, of_kind in growths.items():
        for number, growth in enumerate(of_kind):
            lines.append(
                f"| {kind} | {SEED + number} | {growth.touches[-1]} | {len(growth.last()[0])} | "
                f"{growth.accuracy[-1]:.2f} | {growth.completeness[-1]:.2f} |")
    return "\n".join(lines) + "\n"


def best_choice(growths, surface):
    """How many touches would do at least for the completeness of the random ones."""
    random = [growth.places() for growth in growths["random"]]
    complete = np.mean([growth.completeness[-1] for growth in growths["random"]])
    distance = best_touches.distance_for(surface, random, complete)
    everywhere = [place for of_kind in growths.values() for growth in of_kind for place in growth.places()]
    fewest = best_touches.fewest(surface, everywhere, distance, complete)
    return (
        f"\nThe random touches found {complete:.2f} of the surface, as much as lies within {100 * distance:.1f} cm of their "
        f"places. Of all {len(everywhere)} touches made, the best {fewest} would find as much, were each known beforehand.\n")


def report(records, directory):
    """Accuracy and completeness as text; the reconstructions, the distances, and both against touches."""
    scene = Scene(next(iter(records.values()))["trial"]["scenario"])
    surface = Surface(scene.environment)
    growths = {
        kind: [Growth(record, surface, directory) for name, record in records.items() if name.startswith(kind)]
        for kind in KINDS
    }
    return table(growths) + best_choice(growths, surface), {
        "figure10_chair": draw_reconstructions(growths, scene), "figure10_distances": draw_distances(growths, surface),
        "figure10_growth": draw_growth(growths),
    }
