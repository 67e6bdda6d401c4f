# SPDX-License-Identifier: BSD-3-Clause
"""A slit in space: the object's way through it, and what was learnt of the object (paper, figure 8)."""
import itertools

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from octree_file import OCCUPIED
from scene_geometry import Scene, transform

from experiments import in_space, methods
from experiments.recording import Recording
from experiments.trials import evidence_of, recorded, reported_seeds, unperturbed

WHAT = "an object passes a slit in space, with paper by RRT-Connect and with smore; its reconstruction (its figure 8)"
SCENES = ("slit", "slit_wide")
METHODS = ("paper", "smore")
COUNT, QUICK_COUNT = 2, 1
LIMIT, QUICK_LIMIT = 400, 20  # collisions
SEED = reported_seeds(1)[0]  # of the trials that are drawn
POSES = 4  # of a way that are drawn
WORLD, WAY = "#777777", plt.cm.plasma
PLACE = 0.03  # edge of the cubes that contacts are sorted into [m]
BEHIND = 0.1  # margin around what is shown [m]


def trials(directory, quick):
    options = ("--max-collisions", str(QUICK_LIMIT if quick else LIMIT))
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT)
    return [
        recorded(f"{scene}/{method}/{seed}", unperturbed(scene, directory / "scenes"), seed, method, directory, options)
        for scene in SCENES for method in METHODS for seed in seeds
    ]


def chosen_poses(way):
    return [way[index] for index in np.linspace(0, len(way) - 1, POSES).round().astype(int)]


def near(solids, low, high):
    """What of boxes along the axes is between two corners."""
    cut = [np.clip(solid, low, high) for solid in solids]
    cut = [solid for solid in cut if np.all(np.ptp(solid.reshape(-1, 3), axis=0) > 0)]
    return [solid[has_area(solid)] for solid in cut]


def has_area(triangles):
    sides = triangles[:, 1:] - triangles[:, :1]
    return np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) > 0


def draw_way(axes, scene, motion):
    """The last motion: the object at some of its poses, from dark to light, and the wall near it."""
    poses = chosen_poses(motion.way)
    placed = [[transform(pose, solid.reshape(-1, 3)).reshape(solid.shape) for solid in scene.object] for pose in poses]
    for number, solids in enumerate(placed):
        in_space.draw_solids(axes, solids, WAY(0.85 * number / (POSES - 1)), 0.25)
    corners = np.concatenate([solid.reshape(-1, 3) for solids in placed for solid in solids])
    low, high = corners.min(axis=0) - BEHIND, corners.max(axis=0) + BEHIND
    in_space.draw_solids(axes, near(scene.environment, low, high), WORLD, 0.15)
    in_space.set_up(axes, np.stack([low, high]), 22, -60)


def draw_object(axes, scene, octree):
    """What is occupied of the object, and its true edges, in its own frame."""
    centers, _sizes, probabilities, voxel = octree
    occupied = centers[probabilities >= OCCUPIED]
    in_space.draw_voxels(axes, occupied, voxel)
    in_space.draw_edges(axes, scene.object, "#d55e00", 1.0)
    corners = np.concatenate(scene.object).reshape(-1, 3)
    in_space.set_up(axes, np.concatenate([corners, occupied - voxel, occupied + voxel]), 50, -60)


def draw(scene, records, directory):
    """A line for each method: the last way, and the object's map beside the truth."""
    figure = plt.figure(figsize=(7.2, 6.2))
    figure.subplots_adjust(left=0.02, right=0.95, bottom=0.05, top=0.95, wspace=0.1, hspace=0.15)
    for line, method in enumerate(METHODS):
        record = records[f"{scene.name}/{method}/{SEED}"]
        recording = Recording(evidence_of(record))
        world_and_object = recording.maps_before(len(recording.motions), directory / "maps" / scene.name / method)
        left, right = (figure.add_subplot(2, 2, 2 * line + column, projection="3d") for column in (1, 2))
        draw_way(left, scene, recording.motions[-1])
        draw_object(right, scene, world_and_object[1])
        count, end = record["result"]["collisions"], "out" if record["result"]["success"] else "not out"
        left.set_title(f"{method}: {end} after {count} collisions", fontsize=9)
        right.set_title("what it knows of the object, and the truth", fontsize=9)
    return figure


def angles_between_lines(motions):
    """Between each two lines of action whose contacts were at one place of the world [rad]."""
    of_place = {}
    for motion in motions:
        if motion.line is not None and motion.places is not None:
            key = tuple(np.floor(motion.places.mean(axis=0) / PLACE).astype(int))
            of_place.setdefault(key, []).append(motion.line[1] / np.linalg.norm(motion.line[1]))
    return [
        np.arccos(np.clip(abs(one @ other), 0.0, 1.0))
        for directions in of_place.values() for one, other in itertools.combinations(directions, 2)
    ]


def mean_of(values, digits):
    known = [value for value in values if value is not None]
    return f"{np.mean(known):.{digits}f}" if known else "-"


def row(records):
    """Collisions, the object's map, and how much the lines of one place differ, all trials of a kind together."""
    results = [record["result"] for record in records]
    maps = [result["object_map"] for result in results]
    voxels, precision = mean_of([each["occupied"] for each in maps], 0), mean_of([each["precision"] for each in maps], 2)
    recordings = [Recording(evidence_of(record)) for record in records]
    angles = [angle for recording in recordings for angle in angles_between_lines(recording.motions)]
    between = f"{np.median(angles):.2f}" if angles else "-"
    return f"{methods.row(results)} | {voxels} | {precision} | {between}"


def table(records):
    head = f"| slit | method | {methods.ROW_HEAD} | object: voxels | precision | between lines [rad] |"
    lines = [head, "|---" * 10 + "|"]
    for scene in SCENES:
        for method in METHODS:
            some = [record for name, record in records.items() if name.startswith(f"{scene}/{method}/")]
            lines.append(f"| {scene} | {method} | {row(some)} |")
    return "\n".join(lines) + "\n"


def report(records, directory):
    """Collisions as text, and a figure for each slit."""
    figures = {f"figure8_{scene}": draw(Scene(scene), records, directory) for scene in SCENES}
    return table(records), figures
