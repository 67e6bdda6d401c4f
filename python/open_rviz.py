#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens rviz with a view and a grid that fit a scene or a task, of whatever size.

    open_rviz.py --config FILE.rviz [--scenario NAME_OR_PATH] [--world-frame FRAME] [ARGUMENT_OF_RVIZ ...]

rviz gets a copy of the configuration: what is saved from it is kept under another name only.
"""
import argparse
import copy
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import yaml

from scene_file import SceneFileError, read_scene
from scene_geometry import pose_of, transform, triangles_of

# Shares of the diagonal of what is shown. Our choice: they fill the view, and the grid has some ten cells across.
DISTANCE, WORLD_AXES, OBJECT_AXES, AXES_RADIUS = 1.2, 0.05, 0.03, 0.0024
CELLS, GRID_CELLS = 10, 24


def arguments():
    parser = argparse.ArgumentParser(description="Opens rviz with a view that fits a scene.")
    parser.add_argument("--config", required=True, help="configuration of rviz (config/rviz)")
    parser.add_argument("--scenario", default="none", help="scenario or task; none: the configuration's own view")
    parser.add_argument("--world-frame", default="world", help="frame that is fixed")
    return parser.parse_known_args()


def box_of(scene):
    """Least and largest coordinates [m] of where the object's origin may be, of the object at its start and goal, and of
    an arm's base."""
    points = [np.array(scene["workspace"][end], dtype=float)[None] for end in ("min", "max")]
    object_triangles = triangles_of(scene["object"]) if "object" in scene else []
    for pose in (pose_of(scene["start"]), pose_of(scene["goal"])):
        points.append(pose[None, :3, 3])
        points += [transform(pose, triangles.reshape(-1, 3)) for triangles in object_triangles]
    if scene["robot"] != "cartesian":
        points.append(np.array(scene["robot_base"]["position"], dtype=float)[None])
    points = np.concatenate(points)
    return points.min(axis=0), points.max(axis=0)


def round_length(length):
    """The nearest below of 1, 2 and 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(length))
    return power * max(step for step in (1, 2, 5) if step * power <= length * (1 + 1e-9))


def framed(config, box):
    """The configuration with its view, its grid and its axes fitted to a box (least and largest coordinates [m])."""
    config = copy.deepcopy(config)
    low, high = box
    center, diagonal = (low + high) / 2, float(np.linalg.norm(high - low))
    manager = config["Visualization Manager"]
    view = manager["Views"]["Current"]
    view["Distance"] = DISTANCE * diagonal
    view["Near Clip Distance"] = 0.005 * diagonal
    view["Focal Point"] = dict(zip("XYZ", map(float, center)))
    cell = round_length(diagonal / CELLS)
    for display in manager["Displays"]:
        if display["Class"] == "rviz/Grid":
            display["Cell Size"], display["Plane Cell Count"] = cell, GRID_CELLS
            at = [cell * round(center[0] / cell), cell * round(center[1] / cell), low[2] - 0.1 * cell]
            display["Offset"] = dict(zip("XYZ", map(float, at)))
        if display["Class"] == "rviz/Axes":
            length = WORLD_AXES if display["Name"] == "World frame" else OBJECT_AXES
            display["Length"], display["Radius"] = length * diagonal, AXES_RADIUS * diagonal
    return config


def config_for(file, scenario):
    config = yaml.safe_load(pathlib.Path(file).read_text(encoding="utf-8"))
    if scenario == "none":
        return config
    try:
        return framed(config, box_of(read_scene(scenario)))
    except SceneFileError as error:
        print(f"open_rviz: the view does not fit the scene: {error}", file=sys.stderr)
        return config


def main():
    options, others = arguments()
    with tempfile.TemporaryDirectory(prefix="smore_rviz_") as folder:
        file = pathlib.Path(folder, pathlib.Path(options.config).name)
        file.write_text(yaml.safe_dump(config_for(options.config, options.scenario), sort_keys=False), encoding="utf-8")
        rviz = subprocess.Popen(["rviz", "-d", str(file), "-f", options.world_frame, *others])
        while True:
            try:
                return rviz.wait()
            except KeyboardInterrupt:  # roslaunch's Ctrl-C reaches rviz too
                pass


if __name__ == "__main__":
    sys.exit(main())
