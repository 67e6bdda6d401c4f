#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the two maps of a run beside the true outlines.

    plot_maps.py --scenario FILE --maps DIR [--output FILE.png] [--path FILE.json]

DIR holds world.ot and object.ot. A planar scene is shown from above, in the plane of motion; a spatial
one from three sides, each cut where most of the true solids is. Of the voxels within three of the cut the
most probable are on top. Black to white is the world from free to occupied, as in the paper's figures, pale
yellow to dark red the object; what is not stored is unknown and stays blank.
"""
import argparse
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.gridspec import GridSpec, GridSpecFromSubplotSpec
from matplotlib.lines import Line2D

from octree_file import OctreeFileError, read_octree
from scene_file import SceneFileError
from scene_geometry import Scene, View, fullest_depth, outline_mask, transform
from user_files import save_picture

UNKNOWN = "#c3cedb"
WORLD_COLORS = "gray"
OBJECT_COLORS = LinearSegmentedColormap.from_list("object", ["#fff0a0", "#f58a2e", "#7a0010"])  # told apart without green and red
PATH_COLORS = LinearSegmentedColormap.from_list("path", ["#00d5e0", "#8e24aa"])
WORLD_OUTLINE = "#e0691a"
OBJECT_OUTLINE = "#1f3fae"
OBJECT_AT_START = "#6f93ff"
SLICE_HALF_VOXELS = 3  # voxels on either side of a cut that a view shows
MARGIN = 0.15  # around what a panel shows, of the longest side of what is shown
WIDTH = 14.0  # of a figure [inch]
BESIDE = 1.0  # of it taken by the ticks and labels of each panel, and by a colour bar [inch]
LOWEST, HIGHEST = 2.2, 6.0  # of a row of panels [inch]
AROUND = 1.0  # the title and the labels of a row [inch]
LINE = 0.4  # the title of a figure, and its legend [inch]
TOP = View(np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), ("x", "y"), "z")
FRONT = View(np.array([1.0, 0, 0]), np.array([0, 0, 1.0]), ("x", "z"), "-y")
SIDE = View(np.array([0, 1.0, 0]), np.array([0, 0, 1.0]), ("y", "z"), "x")
LEAST_SCALE = 0.5  # colours end at the largest probability of a map, but not below this


def arguments():
    parser = argparse.ArgumentParser(description="Draws the maps of a run beside the true outlines.")
    parser.add_argument("--scenario", required=True, help="name in config/scenarios, scenario file, or its scene as JSON")
    parser.add_argument("--maps", required=True, help="directory of world.ot and object.ot")
    parser.add_argument("--output", help="picture to write (default: DIR/maps.png)")
    parser.add_argument("--path", help="JSON file whose 'path' lists poses [x, y, z, ...] to draw")
    parser.add_argument("--title", help="first line above the picture")
    return parser.parse_args()


def read_path(file):
    """Positions (n, 3) [m] of the poses of a run's last path; none without a file."""
    if file is None:
        return np.zeros((0, 3))
    poses = json.loads(pathlib.Path(file).read_text()).get("path", [])
    return np.array([pose[:3] for pose in poses], dtype=float).reshape(-1, 3)


def scale_of(octree):
    """Colours of a map: free to its most probable voxel, so that weak evidence is seen as well."""
    highest = octree[2].max(initial=0.0)
    return Normalize(0.0, max(LEAST_SCALE, np.ceil(highest * 20.0) / 20.0))


class Panel:
    """One map in one view."""

    def __init__(self, axes, view, colors, depth):
        self.axes = axes
        self.view = view
        self.colors = colors
        self.depth = depth
        axes.set_facecolor(UNKNOWN)
        axes.set_aspect("equal")
        axes.locator_params(nbins=6)
        axes.set_xlabel(f"{view.labels[0]} [m]")
        axes.set_ylabel(f"{view.labels[1]} [m]")

    def voxels(self, octree):
        centers, sizes, probabilities, voxel_size = octree
        seen = self.view.project(centers)
        reach = (SLICE_HALF_VOXELS + 0.5) * voxel_size + sizes / 2.0
        near = np.abs(seen[:, 2] - self.depth) < reach
        seen, sizes, probabilities = seen[near], sizes[near], probabilities[near]
        order = np.argsort(probabilities, kind="stable")
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / 2.0
        squares = seen[order, None, :2] + corners * sizes[order, None, None]
        drawn = PolyCollection(squares, cmap=self.colors, norm=scale_of(octree), linewidths=0.0, rasterized=True)
        drawn.set_array(probabilities[order])
        drawn.set_antialiased(False)
        return self.axes.add_collection(drawn)

    def outline(self, solids, color, style="-", width=1.8):
        grid = outline_mask(solids, self.view, self.depth)
        if grid is not None and grid[2].any():
            self.axes.contour(*grid, levels=[0.5], colors=color, linestyles=style, linewidths=width)

    def path(self, positions, start, goal):
        if len(positions) > 1:
            points = self.view.project(positions)[:, :2]
            lines = LineCollection(
                np.stack([points[:-1], points[1:]], axis=1), cmap=PATH_COLORS, linewidths=2.2, zorder=4
            )
            lines.set_array(np.linspace(0.0, 1.0, len(points) - 1))
            self.axes.add_collection(lines)
        for pose, marker in ((start, "o"), (goal, "*")):
            right, up, _ = self.view.project(pose[:3, 3])
            size = 45 if marker == "o" else 130
            self.axes.scatter(
                right, up, s=size, marker=marker, color="#8e24aa", edgecolors="white", zorder=5
            )

    def frame(self, points):
        low, high = limits(points, self.view)
        self.axes.set_xlim(low[0], high[0])
        self.axes.set_ylim(low[1], high[1])


def corners_of(solids):
    return np.concatenate(solids).reshape(-1, 3) if solids else np.zeros((0, 3))


def placed(solids, pose):
    return [transform(pose, t.reshape(-1, 3)).reshape(-1, 3, 3) for t in solids]


def plane_view(scene):
    """View onto the plane of motion and its depth along the line of sight."""
    rotation, position = scene.start[:3, :3], scene.start[:3, 3]
    if abs(rotation[2, 2]) > 1.0 - 1e-9:
        return TOP, position[2]
    view = View(rotation[:, 0], rotation[:, 1], ("along plane", "across plane"))
    return view, view.project(position)[2]


def limits(points, view):
    """Lower left and upper right of a panel that shows the points [m]."""
    seen = view.project(points)[:, :2]
    margin = MARGIN * np.ptp(points, axis=0).max()  # a rod has room in each view
    return seen.min(axis=0) - margin, seen.max(axis=0) + margin


def title_of(kind, octree):
    probabilities = octree[2]
    count, highest = np.count_nonzero(probabilities >= 0.5), probabilities.max(initial=0.0)
    return f"{kind} map\n{count} voxels at P ≥ 0.5, highest P {highest:.2f}"


def cut_of(view, depth):
    """Where a view is cut, in words."""
    along = -depth if view.depth[0] == "-" else depth
    return f"cut at {view.depth.lstrip('-')} = {round(along, 2) + 0.0:.2f} m"  # never -0.00


def world_points(scene, path):
    """What the world's panels must show [m]."""
    solids = scene.environment + placed(scene.object, scene.start)
    ends = np.stack([scene.start[:3, 3], scene.goal[:3, 3]])
    return np.concatenate([corners_of(solids), ends, path])


def world_panel(axes, scene, octree, path, view, depth):
    panel = Panel(axes, view, WORLD_COLORS, depth)
    drawn = panel.voxels(octree)
    at_start = placed(scene.object, scene.start)
    panel.outline(at_start, OBJECT_AT_START, ":", 1.3)
    panel.outline(scene.environment, WORLD_OUTLINE)
    panel.path(path, scene.start, scene.goal)
    panel.frame(world_points(scene, path))
    return drawn


def object_panel(axes, scene, octree, view, depth):
    panel = Panel(axes, view, OBJECT_COLORS, depth)
    drawn = panel.voxels(octree)
    panel.outline(scene.object, OBJECT_OUTLINE)
    panel.frame(corners_of(scene.object))
    return drawn


def looks_at(scene, solids, alone):
    """Views of a map and their depths: of the object alone, or of the scene."""
    if scene.planar:
        return [(TOP, 0.0)] if alone else [plane_view(scene)]
    return [(view, fullest_depth(solids, view)) for view in (TOP, FRONT, SIDE)]


def shape_of(points, looks):
    """Width over height of each panel, and the height of a row of them [inch]."""
    sizes = [np.subtract(*reversed(limits(points, view))) for view, _ in looks]
    ratios = [size[0] / size[1] for size in sizes]
    height = (WIDTH - BESIDE * (len(looks) + 1)) / sum(ratios)
    return ratios, float(np.clip(height, LOWEST, HIGHEST))


def fill(figure, part, ratios, looks, draw_panel, title, label):
    """A row of panels with a title and a colour bar."""
    grid = GridSpecFromSubplotSpec(1, len(looks), part, width_ratios=ratios)
    row = [figure.add_subplot(grid[0, i]) for i in range(len(looks))]
    for axes, look in zip(row, looks):
        drawn = draw_panel(axes, *look)
        if len(looks) > 1:
            axes.set_title(cut_of(*look), fontsize=10, loc="left")
    if len(looks) > 1:
        title = title.replace("\n", ": ") + "\n" + cut_of(*looks[0])
    row[0].set_title(title, fontsize=10, loc="left")
    figure.colorbar(drawn, ax=row, shrink=0.9, pad=0.02).set_label(label)


def layout_of(scene, world_shape, object_shape):
    """The figure, the parts of it for both maps, side by side or one below the other, and that of the legend."""
    if scene.planar:
        ratios = world_shape[0] + object_shape[0]
        rows = [float(np.clip((WIDTH - 4.0 * BESIDE) / sum(ratios), LOWEST, HIGHEST)) + AROUND]
        columns = [rows[0] * ratio + 2.0 * BESIDE for ratio in ratios]
    else:
        rows, columns = [world_shape[1] + AROUND, object_shape[1] + AROUND], [1.0]
    figure = plt.figure(figsize=(WIDTH, sum(rows) + 2.0 * LINE), constrained_layout=True)
    grid = GridSpec(len(rows) + 1, len(columns), figure, height_ratios=[*rows, LINE], width_ratios=columns)
    return figure, grid[0, 0], grid[len(rows) - 1, len(columns) - 1], grid[len(rows), :]


def draw(scene, world, found, path):
    """The figure: the world's panels, and the object's beside or below them."""
    solids = scene.environment or placed(scene.object, scene.start)
    world_looks, object_looks = looks_at(scene, solids, False), looks_at(scene, scene.object, True)
    world_shape = shape_of(world_points(scene, path), world_looks)
    object_shape = shape_of(corners_of(scene.object), object_looks)
    figure, world_part, object_part, legend_part = layout_of(scene, world_shape, object_shape)
    fill(figure, world_part, world_shape[0], world_looks,
         lambda axes, *look: world_panel(axes, scene, world, path, *look), title_of("world", world), "P(occupied), world")
    fill(figure, object_part, object_shape[0], object_looks,
         lambda axes, *look: object_panel(axes, scene, found, *look), title_of("object", found), "P(occupied), object")
    below = figure.add_subplot(legend_part)
    below.set_axis_off()
    legend(below, len(path) > 1)
    return figure


def legend(axes, has_path):
    entries = [
        Line2D([], [], color=WORLD_OUTLINE, lw=1.8, label="true environment"),
        Line2D([], [], color=OBJECT_OUTLINE, lw=1.8, label="true object"),
        Line2D([], [], color=OBJECT_AT_START, ls=":", lw=1.3, label="object at the start"),
        Line2D([], [], color="w", marker="o", markerfacecolor="#8e24aa", ms=8, label="start"),
        Line2D([], [], color="w", marker="*", markerfacecolor="#8e24aa", ms=14, label="goal"),
        plt.Rectangle((0, 0), 1, 1, color=UNKNOWN, label="unknown"),
    ]
    if has_path:
        entries.insert(3, Line2D([], [], color=PATH_COLORS(0.5), lw=2.2, label="last path"))
    axes.legend(handles=entries, loc="center", ncol=len(entries), frameon=False)


def main():
    options = arguments()
    maps = pathlib.Path(options.maps)
    output = pathlib.Path(options.output) if options.output else maps / "maps.png"
    try:
        scene = Scene(options.scenario)
        world, found = read_octree(maps / "world.ot"), read_octree(maps / "object.ot")
        figure = draw(scene, world, found, read_path(options.path))
    except (OSError, OctreeFileError, KeyError, ValueError, SceneFileError) as problem:
        sys.exit(f"plot_maps: {problem}")
    figure.suptitle(options.title or f"{scene.name}: what was learnt by touch", fontsize=13)
    save_picture(figure, output, dpi=160)
    print(output)


if __name__ == "__main__":
    main()
