# SPDX-License-Identifier: BSD-3-Clause
"""Strips of pictures of a retrieval in a plane: above what is known and planned, below the true scene."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import plot_maps
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from octree_file import OCCUPIED
from scene_geometry import outline_mask, transform

WORLD_COLORS = LinearSegmentedColormap.from_list("world", ["#9a9a9a", "#000000"])
OBJECT_COLORS = LinearSegmentedColormap.from_list("object", ["#fdc58f", "#a63603"])
ENVIRONMENT, OBJECT, START, PLAN, WAY, LINE = "#4d4d4d", "#f2a65a", "#a63603", "#0072b2", "#56b4e9", "#cc79a7"
MARGIN = 0.05  # around what is shown, of its width
WIDTH = 7.2  # of a figure, at most [inch]
HIGHEST = 2.2  # of a panel [inch]
LABELS, GAP, LEGEND_LINE = 0.8, 0.12, 0.2  # left of all panels, between them, and of the legend [inch]


class PlanarScene:
    """The true outlines of a planar scene, as seen from above the plane of motion."""

    def __init__(self, scene):
        self.scene = scene
        self.view, depth = plot_maps.plane_view(scene)
        self.environment = outline_mask(scene.environment, self.view, depth)
        self.object = outline_mask(scene.object, self.view, 0.0)

    def fill_environment(self, axes):
        axes.contourf(*self.environment, levels=[0.5, 1.5], colors=[ENVIRONMENT])

    def _object_at(self, pose):
        right, up, mask = self.object
        points = np.stack([*np.meshgrid(right, up), np.zeros(mask.shape)], axis=-1)
        seen = self.view.project(transform(pose, points.reshape(-1, 3))).reshape(*mask.shape, 3)
        return seen[..., 0], seen[..., 1], mask.astype(float)

    def fill_object(self, axes, pose):
        axes.contourf(*self._object_at(pose), levels=[0.5, 1.5], colors=[OBJECT])

    def outline_object(self, axes, pose, style=":"):
        axes.contour(*self._object_at(pose), levels=[0.5], colors=START, linewidths=0.7, linestyles=style)

    def line(self, axes, positions, **style):
        seen = self.view.project(np.array(positions).reshape(-1, 3))
        axes.plot(seen[:, 0], seen[:, 1], **style)

    def outline_environment(self, axes):
        axes.contour(*self.environment, levels=[0.5], colors=ENVIRONMENT, linewidths=0.7, linestyles=":")

    def corners(self, poses):
        """Of the object at its start, its goal and some poses [m]."""
        placed = [plot_maps.placed(self.scene.object, pose) for pose in (self.scene.start, self.scene.goal, *poses)]
        return self.view.project(np.concatenate([plot_maps.corners_of(solids) for solids in placed]))[:, :2]


def positions_of(poses):
    return [pose[:3, 3] for pose in poses]


def draw_voxels(axes, view, octree, pose, colors):
    """The voxels of a map that are more likely occupied than not, the map's frame at a pose."""
    centers, sizes, probabilities, _ = octree
    order = np.argsort(probabilities, kind="stable")
    order = order[probabilities[order] >= OCCUPIED]
    square = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) / 2
    corners = centers[order, None] + square * sizes[order, None, None]
    seen = view.project(transform(pose, corners.reshape(-1, 3))).reshape(-1, 4, 3)[..., :2]
    drawn = PolyCollection(seen, cmap=colors, norm=Normalize(OCCUPIED, 1.0), linewidths=0)
    drawn.set_array(probabilities[order])
    axes.add_collection(drawn)


def draw_maps(axes, planar, maps, pose):
    """Both maps, the object's where the object stands, and the true outlines."""
    world, held = maps
    planar.outline_object(axes, pose)
    planar.outline_environment(axes)
    draw_voxels(axes, planar.view, held, pose, OBJECT_COLORS)
    draw_voxels(axes, planar.view, world, np.eye(4), WORLD_COLORS)


def draw_plan(axes, planar, motion):
    planar.line(axes, positions_of(motion.plan), color=PLAN, linewidth=1.4)
    draw_ends(axes, planar)


def draw_ends(axes, planar):
    for pose, marker, size in ((planar.scene.start, "o", 4), (planar.scene.goal, "*", 8)):
        planar.line(axes, pose[:3, 3], marker=marker, markersize=size, color=PLAN, markeredgecolor="white",
                    markeredgewidth=0.4, linestyle="")


def draw_truth(axes, planar, motion, poses):
    """The scene with the object at the last of some poses of a motion, and where it touches if that is the end."""
    planar.fill_object(axes, poses[-1])
    planar.fill_environment(axes)
    planar.outline_object(axes, planar.scene.start)
    planar.line(axes, positions_of([motion.plan[0], *poses]), color=WAY, linewidth=1.4)
    draw_ends(axes, planar)
    if motion.touched and motion.places is not None and poses[-1] is motion.way[-1]:
        for color, width in (("white", 3.0), ("black", 1.6)):
            planar.line(axes, motion.places, marker="x", markersize=6, markeredgewidth=width, color=color, linestyle="")


def draw_lines(axes, planar, motions, length):
    """Lines of action, so far to each side."""
    for motion in motions:
        if motion.line is not None:
            point, direction = motion.line
            planar.line(axes, [point - length * direction, point + length * direction], color=LINE, linewidth=1.0)


def limits_of(planar, motions):
    """Left, right, lower and upper end of what all panels show [m]."""
    plans = [planar.view.project(np.array(positions_of(motion.plan)))[:, :2] for motion in motions]
    points = np.concatenate([planar.corners([motion.way[-1] for motion in motions]), *plans])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = MARGIN * (high - low).max()
    return low[0] - margin, high[0] + margin, low[1] - margin, high[1] + margin


def set_up(axes, limits, first, lowest, what):
    axes.set_aspect("equal")
    axes.set_xlim(limits[:2])
    axes.set_ylim(limits[2:])
    axes.tick_params(labelsize=7, length=2)
    axes.locator_params(nbins=4)
    if first:
        axes.set_ylabel(f"{what}\ny [m]", fontsize=8)
    else:
        axes.set_yticklabels([])
    if lowest:
        axes.set_xlabel("x [m]", fontsize=8)
    else:
        axes.set_xticklabels([])


def contacts_in_words(count):
    return f"{count} contact{'' if count == 1 else 's'}"


def draw(planar, recording, indices, draw_known, legend, known="maps and plan"):
    """The strip: a column for each motion of `indices`. draw_known(axes, index) draws what is known before it."""
    limits = limits_of(planar, [recording.motions[index] for index in indices])
    ratio = (limits[3] - limits[2]) / (limits[1] - limits[0])
    height = min(((WIDTH - LABELS) / len(indices) - GAP) * ratio, HIGHEST)
    width = LABELS + len(indices) * (height / ratio + GAP)
    columns = 4 if width > 6 else 3
    below = LEGEND_LINE * -(-len(legend) // columns)
    figure = plt.figure(figsize=(width, 2 * height + below + LABELS), constrained_layout=True)
    grid = figure.add_gridspec(3, len(indices), height_ratios=[height, height, below])
    for column, index in enumerate(indices):
        above, lower = (figure.add_subplot(grid[line, column]) for line in range(2))
        draw_known(above, index)
        draw_plan(above, planar, recording.motions[index])
        draw_truth(lower, planar, recording.motions[index], recording.motions[index].way)
        above.set_title(contacts_in_words(recording.contacts_before(index)), fontsize=9)
        set_up(above, limits, column == 0, False, known)
        set_up(lower, limits, column == 0, True, "scene")
    last = figure.add_subplot(grid[2, :])
    last.set_axis_off()
    last.legend(handles=legend, loc="center", ncol=columns, fontsize=7.5, frameon=False)
    return figure


SCENE_LEGEND = [
    Line2D([], [], color=PLAN, lw=1.4, label="planned way"),
    Line2D([], [], color=WAY, lw=1.4, label="executed way"),
    Patch(color=OBJECT, label="object at its end"),
    Line2D([], [], color=START, lw=0.7, ls=":", label="object at the start"),
    Line2D([], [], color="black", marker="x", ls="", mew=1.6, label="where it touches"),
]
MAP_LEGEND = [
    Patch(color=WORLD_COLORS(0.7), label="world, P ≥ 0.5"),
    Patch(color=OBJECT_COLORS(0.5), label="object, P ≥ 0.5"),
]
LINE_LEGEND = Line2D([], [], color=LINE, lw=1.0, label="line of action")
