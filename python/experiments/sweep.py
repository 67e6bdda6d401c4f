# SPDX-License-Identifier: BSD-3-Clause
"""A sweep as a hand would do it: a rod led in straight strokes from above and from four sides through a workspace.

It knows the workspace, where the object is held at the start, and that the rod hangs down from there. It goes over the
workspace row by row and side by side, coarsely at first, then in between.
"""
import itertools
import json

import numpy as np

APART = 0.4  # of neighbouring strokes of a round [m]
# Of a round, by which part of that distance its strokes are shifted along both axes of a side.
ROUNDS = ((0.0, 0.0), (0.5, 0.5), (0.5, 0.0), (0.0, 0.5))
FIRST = 0.25  # part of the distance between the workspace's edge and the first stroke
HANGING = (0.0, 0.0, 0.0)
TILT = np.pi / 4  # from the side the rod goes ahead of the hand, downwards at so much from the vertical [rad]


class Side:
    """Strokes along an axis of the world, from one border of the workspace to the other."""

    def __init__(self, axis, forward, rpy):
        self.axis, self.forward, self.rpy = axis, forward, rpy

    def ends(self, workspace):
        low, high = (bound[self.axis] for bound in workspace)
        return (low, high) if self.forward else (high, low)

    def stroke(self, workspace, across):
        """Poses of a stroke: above its begin, the begin, the end, above the end. Between strokes the rod hangs."""
        begin, end = (np.insert(across, self.axis, place) for place in self.ends(workspace))
        top = workspace[1][2]
        above = [(np.array([*place[:2], top]), HANGING) for place in (begin, end)]
        return [above[0], (begin, self.rpy), (end, self.rpy), above[1]]


SIDES = (
    Side(2, False, HANGING), Side(0, False, (0.0, TILT, 0.0)), Side(1, False, (-TILT, 0.0, 0.0)),
    Side(0, True, (0.0, -TILT, 0.0)), Side(1, True, (TILT, 0.0, 0.0)),
)


def places(low, high, shift):
    """Of the strokes of a round along one axis."""
    return np.arange(low + (FIRST + shift) * APART, high, APART)


def rows(workspace, side, shifts):
    """Places of a round's strokes across their direction, row by row."""
    ranges = [
        places(*(bound[axis] for bound in workspace), shift)
        for axis, shift in zip((axis for axis in range(3) if axis != side.axis), shifts)
    ]
    return np.array(list(itertools.product(*ranges)))


def motions(workspace, start):
    """Of a sweep through a workspace (lowest and highest corner [m]), each a list of positions and rpy. Each begins
    above the place `start` [m], to which a contact puts the object back."""
    high_start = (np.array([*start[:2], workspace[1][2]]), HANGING)
    return [
        [high_start, *side.stroke(workspace, across)]
        for shifts in ROUNDS for side in SIDES for across in rows(workspace, side, shifts)
    ]


def write(scene, file):
    """The sweep of a scene, to a file as smore_experiment --touch-poses reads it (JSON is YAML); its path."""
    told = [
        {"poses": [{"position": place.tolist(), "rpy": list(rpy)} for place, rpy in motion]}
        for motion in motions(scene.workspace, scene.start[:3, 3])
    ]
    file.write_text(json.dumps({"motions": told}) + "\n")
    return str(file)
