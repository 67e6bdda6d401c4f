# SPDX-License-Identifier: BSD-3-Clause
"""Contacts whose lines of action all pass through one voxel of the world, and the maps that the paper's laws make of
them: evidence is written here, the maps come from smore_rebuild."""
import json
import math
import subprocess

import matplotlib
import matplotlib.colors
import numpy as np
import octree_file

from experiments import trials

VOXEL = 0.03  # [m], the paper's
TOUCHED = (0.5 * VOXEL, 0.5 * VOXEL)  # centre of the voxel of the world that all lines pass through [m]
CONTACTS = 6
LEAST = 0.005  # probability that the program gives a voxel, and where the colours begin
SHOWN = 10  # voxels to each side of the middle of a picture


def pose(number):
    """x and y of the object at a contact [m]; it is not turned."""
    return (-0.15 + 2 * VOXEL * number, -0.06 - VOXEL * (number % 3))


def row_major(x, y):
    return [1.0, 0.0, 0.0, x, 0.0, 1.0, 0.0, y, 0.0, 0.0, 1.0, 0.0]


def observation(number):
    """A contact as a record of evidence; the line is in the object's frame."""
    x, y = pose(number)
    # Once all directions have been, those between them follow.
    angle = math.radians(15.0 + 180.0 / CONTACTS * (number + 0.5 * (number // CONTACTS)))
    line = {
        "point": [TOUCHED[0] - x, TOUCHED[1] - y, 0.0], "direction": [math.cos(angle), math.sin(angle), 0.0],
        "force": 5.0, "pitch": 0.0, "direction_stddev": 0.0, "offset_stddev": 0.0,
    }
    return {
        "record": "observation", "time": float(number), "state": "contact", "contact": number + 1,
        "pose": row_major(x, y), "line": line,
    }


def free_observation(x, y):
    """The object stands at a place and touches nothing."""
    return {"record": "observation", "time": 100.0, "state": "free", "contact": 0, "pose": row_major(x, y)}


def evidence(observations):
    """The text of a file of evidence (docs/evidence.md) of the method paper in the plane."""
    task = {
        "record": "task", "name": "lines_through_a_voxel", "task": "retrieve", "voxel_size": VOXEL, "motion": "planar",
        "robot": "cartesian", "start": row_major(0.0, 0.0), "goal": row_major(-0.5, 0.0), "on_contact": "reset",
        "goal_tolerance": {"position": 0.02, "angle": 0.1}, "touches": 300, "contact_force": 5.0, "free_force": 0.5,
        "workspace": {"min": [-1.0, -1.0, -0.01], "max": [1.0, 1.0, 0.01]}, "speed": {"linear": 0.1, "angular": 0.5},
        "wrench_noise": {"force_stddev": 0.0, "torque_stddev": 0.0, "force_drift": 0.0},
        "line_noise": {"direction": 0.0, "offset": 0.0},
    }
    header = {"format": "smore evidence", "version": 2, "program": "scripts/experiments"}
    records = [header, task, {"record": "method", "method": "paper", "seed": 1}, *observations]
    return "".join(json.dumps(record) + "\n" for record in records)


def square(file, middle):
    """Probabilities of the voxels around `middle` [m] as an array over y and x; NaN where nothing is known."""
    centers, _, probabilities, _ = octree_file.read_octree(file)
    values = np.full((2 * SHOWN + 1, 2 * SHOWN + 1), np.nan)
    for (x, y, _z), probability in zip(centers, probabilities):
        column, line = (int(round((at - of) / VOXEL)) + SHOWN for at, of in zip((x, y), middle))
        if 0 <= column <= 2 * SHOWN and 0 <= line <= 2 * SHOWN:
            values[line, column] = probability
    return values


def middles():
    """The middles of the pictures of the world's and the object's map [m]: centres of voxels."""
    places = np.array([pose(number) for number in range(CONTACTS)])
    touched_on_object = np.array(TOUCHED) - places
    middle = touched_on_object.mean(axis=0)
    return TOUCHED, tuple((np.floor(middle / VOXEL) + 0.5) * VOXEL)


def maps_of(observations, name, directory):
    """Both maps, the world's first, as arrays."""
    directory.mkdir(parents=True, exist_ok=True)
    file, output = directory / f"{name}.evidence", directory / name
    file.write_text(evidence(observations))
    program = trials.PROGRAM.parent / "smore_rebuild"
    subprocess.run([str(program), "--evidence", str(file), "--output", str(output)], check=True)
    return [square(output / f"{side}.ot", middle) for side, middle in zip(("world", "object"), middles())]


def draw(axes, values, middle):
    """One map as a picture in centimetres; returns what a colour bar needs."""
    half = 100.0 * (SHOWN + 0.5) * VOXEL
    x, y = (100.0 * coordinate for coordinate in middle)
    axes.set_facecolor("#dbe4ee")  # unknown
    axes.tick_params(labelsize=7, length=2)
    return axes.imshow(
        np.ma.masked_invalid(values), origin="lower", cmap="inferno_r", interpolation="nearest",
        norm=matplotlib.colors.LogNorm(LEAST, 1.0),
        extent=(x - half, x + half, y - half, y + half),
    )


def add_color_bar(figure, axes, picture):
    bar = figure.colorbar(picture, ax=axes.ravel().tolist(), shrink=0.9, ticks=(0.01, 0.1, 1.0))
    bar.ax.set_yticklabels(("0.01", "0.1", "1"))
    bar.set_label("P(occupied); blue: unknown", fontsize=8)
    bar.ax.tick_params(labelsize=7)
