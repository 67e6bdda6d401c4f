# SPDX-License-Identifier: BSD-3-Clause
"""A chair reconstructed by touching it with a rod, at random and where touches tell most (paper, figure 10)."""
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scene_geometry import Scene

from experiments.recording import Recording
from experiments.surface import Surface
from experiments.trials import ROOT, evidence_of, recorded, reported_seeds

WHAT = "a chair reconstructed with a rod, by touches at random and informed ones (its figure 10)"
SCENE = ROOT / "config/scenarios/chair.yaml"
OPTIONS = {"random": ("--random-touches",), "informed": ("--informed-touches",)}
COLORS = {"random": "#d55e00", "informed": "#0072b2"}
STYLES = {"random": "--", "informed": "-"}
TOUCHES, QUICK_TOUCHES = 30, 10
COUNT, QUICK_COUNT = 2, 1
SHOWN = 4  # numbers of touches at which the maps are scored
SEED = reported_seeds(1)[0]  # of the trials that are drawn
OCCUPIED = 0.5
FARTHEST = 12  # distance that the histogram tells apart [cm]


def scene_with(touches, directory):
    directory.mkdir(parents=True, exist_ok=True)
    file = directory / f"chair_{touches}.yaml"
    file.write_text(re.sub(r"touches: \d+", f"touches: {touches}", SCENE.read_text()))
    return str(file)


def trials(directory, quick):
    scene = scene_with(QUICK_TOUCHES if quick else TOUCHES, directory / "scenes")
    return [
        recorded(f"{kind}_{seed}", scene, seed, "smore", directory, options)
        for kind, options in OPTIONS.items() for seed in reported_seeds(QUICK_COUNT if quick else COUNT)
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
    """Histograms of the occupied voxels' distances, all trials of a kind together."""
    figure, axes = plt.subplots(figsize=(3.5, 2.9), constrained_layout=True)
    for kind, of_kind in growths.items():
        found = [growth.last() for growth in of_kind]
        voxel = found[0][1]
        distances = np.concatenate([surface.distances(centers) for centers, _ in found])
        share = np.mean(distances <= voxel) if distances.size else np.nan
        axes.hist(
            np.minimum(100 * distances, FARTHEST), bins=np.arange(0, FARTHEST + 1, 0.5), histtype="step", linewidth=1.4, color=COLORS[kind],
            linestyle=STYLES[kind], label=f"{kind}: {share:.2f} within a voxel")
    axes.axvline(100 * voxel, color="#888888", linewidth=0.8)
    axes.set(xlabel="distance to the chair's surface [cm]", ylabel="occupied voxels")
    axes.set_xticks([0, 4, 8, FARTHEST + 0.25])
    axes.set_xticklabels(["0", "4", "8", f"{FARTHEST}+"])
    axes.legend(frameon=False, fontsize=8, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    return figure


def draw_voxels(axes, centers, voxel, triangles):
    """Occupied voxels as cubes, the highest lightest, around the chair's edges."""
    low = np.floor(centers.min(axis=0) / voxel).astype(int)
    cells = np.floor(centers / voxel).astype(int) - low
    filled = np.zeros(cells.max(axis=0) + 1, dtype=bool)
    filled[tuple(cells.T)] = True
    corners = [(np.arange(count + 1) + first) * voxel for count, first in zip(filled.shape, low)]
    height = np.broadcast_to(np.linspace(0.2, 0.9, filled.shape[2]), filled.shape)
    axes.voxels(
        *np.meshgrid(*corners, indexing="ij"), filled, facecolors=plt.cm.viridis(height), edgecolor="#333333",
        linewidth=0.2)
    for solid in triangles:
        for a, b in edges_of(solid):
            axes.plot(*np.stack([a, b]).T, color="black", linewidth=0.7)


def edges_of(triangles):
    """Edges between triangles that are not in one plane: what one draws of a box."""
    planes = {}
    for corners in triangles:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal = normal / np.linalg.norm(normal)
        for i in range(3):
            ends = sorted(tuple(corner.round(6)) for corner in (corners[i], corners[(i + 1) % 3]))
            planes.setdefault(tuple(ends), []).append(normal)
    return [np.array(ends) for ends, normals in planes.items() if len(normals) < 2 or normals[0] @ normals[1] < 0.99]


def draw_reconstructions(growths, scene):
    figure = plt.figure(figsize=(7.2, 4.2))
    figure.subplots_adjust(left=0.02, right=0.93, bottom=0.1, top=0.92, wspace=0.1)
    for number, (kind, of_kind) in enumerate(growths.items()):
        axes = figure.add_subplot(1, len(growths), number + 1, projection="3d")
        centers, voxel = of_kind[0].last()
        if len(centers):
            draw_voxels(axes, centers, voxel, scene.environment)
        shown = np.concatenate([np.concatenate(scene.environment).reshape(-1, 3), centers - voxel, centers + voxel])
        low, high = shown.min(axis=0), shown.max(axis=0)
        axes.set_box_aspect(high - low)
        axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]", xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axes.set_zlim(low[2], high[2])
        axes.view_init(elev=18, azim=-55)
        axes.tick_params(labelsize=7)
        axes.locator_params(nbins=3)
        axes.set_title(f"{of_kind[0].touches[-1]} {kind} touches: {len(centers)} voxels", fontsize=9)
    return figure


def table(growths):
    lines = ["| touches | trial | made | occupied voxels | accuracy | completeness |", "|---" * 6 + "|"]
    for kind, of_kind in growths.items():
        for number, growth in enumerate(of_kind):
            lines.append(
                f"| {kind} | {SEED + number} | {growth.touches[-1]} | {len(growth.last()[0])} | "
                f"{growth.accuracy[-1]:.2f} | {growth.completeness[-1]:.2f} |")
    return "\n".join(lines) + "\n"


def report(records, directory):
    """Accuracy and completeness as text; the reconstructions, the distances, and both against touches."""
    scene = Scene(next(iter(records.values()))["trial"]["scenario"])
    surface = Surface(scene.environment)
    growths = {
        kind: [Growth(record, surface, directory) for name, record in records.items() if name.startswith(kind)]
        for kind in OPTIONS
    }
    return table(growths), {
        "figure10_chair": draw_reconstructions(growths, scene), "figure10_distances": draw_distances(growths, surface),
        "figure10_growth": draw_growth(growths),
    }
