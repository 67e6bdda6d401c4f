# SPDX-License-Identifier: BSD-3-Clause
"""Scenes in space by shapes, and whether there is a way out. Lengths in metres."""
import math

import numpy

from lattice import circle, flood
from scene_geometry import rotation_of
from scene_writer import GOAL, Retrieval, cylinder, sphere

WORKSPACE = ((-1.3, -0.5, -0.5), (0.5, 0.5, 0.5))
BALLS_APART = 0.01  # of the balls that stand for a bar
STEP = 0.03  # of the lattice of places
PARTS = 4  # of a step, in which distances are looked up
TURNS = 60  # about each axis


def distance_to(shape, points):
    """Signed distance of points (.., 3) to a box or a cylinder."""
    local = (points - numpy.array(shape.position)) @ rotation_of(shape.rpy)
    if shape.kind == "box":
        beyond = numpy.abs(local) - numpy.array(shape.lengths) / 2
    else:
        radius, length = shape.lengths
        around = numpy.hypot(local[..., 0], local[..., 1]) - radius
        beyond = numpy.stack([around, numpy.abs(local[..., 2]) - length / 2], axis=-1)
    return numpy.linalg.norm(numpy.maximum(beyond, 0), axis=-1) + numpy.minimum(beyond.max(axis=-1), 0)


def half_extent(shape):
    """Of the smallest box along the axes that holds a box or a cylinder."""
    half = [0.5 * length for length in shape.lengths]
    if shape.kind == "cylinder":
        half = [shape.lengths[0], shape.lengths[0], half[1]]
    return numpy.abs(rotation_of(shape.rpy)) @ half


def turned_about(axis, angle):
    """The rotation about axis 0, 1 or 2."""
    return rotation_of([angle if axis == each else 0.0 for each in range(3)])


def rotations_of_lattice():
    """No turn, then all turns about each axis alone; and the neighbours of each, a row with repetitions."""
    rotations, beside = [numpy.eye(3)], numpy.zeros((1 + 3 * (TURNS - 1), 6), dtype=int)
    beside[:] = numpy.arange(len(beside))[:, None]
    for axis in range(3):
        members = numpy.array([0, *(len(rotations) + numpy.arange(TURNS - 1))])
        rotations += [turned_about(axis, 2 * math.pi * turn / TURNS) for turn in range(1, TURNS)]
        beside[members, 2 * axis:2 * axis + 2] = members[circle(TURNS)]
    return rotations, beside


class Spatial:
    """A scene in space: the object is made of round bars with round ends, all of one radius, the environment of boxes
    and cylinders. Object and world have the same frame at the start."""

    def __init__(self, radius=0.02):
        self.radius = radius
        self.bars = []  # from, to
        self.solids = []  # shapes of the environment

    def bar(self, start, end):
        self.bars.append((tuple(start), tuple(end)))
        return self

    def chain(self, *points):
        for start, end in zip(points, points[1:]):
            self.bar(start, end)
        return self

    def place_among(self, obstacles):
        """Among those of another scene, in place of its own."""
        self.solids = obstacles.solids

    def object_shapes(self):
        ends = dict.fromkeys(end for bar in self.bars for end in bar)
        return [rod(*bar, self.radius) for bar in self.bars] + [sphere(self.radius, end) for end in ends]

    def balls(self):
        """Centres of balls along the bars (n, 3), in the object's frame."""
        centers = []
        for start, end in numpy.array(self.bars):
            count = math.ceil(numpy.linalg.norm(end - start) / BALLS_APART) + 1
            centers.append(start + numpy.linspace(0, 1, count)[:, None] * (end - start))
        return numpy.concatenate(centers)

    def reach(self):
        """From the object's origin to the farthest end of a bar's axis."""
        return numpy.linalg.norm(self.bars, axis=-1).max()

    def clearance(self, places):
        """Least distance between object and environment where it stands at places (n, 3), not turned."""
        points = numpy.array(places)[:, None] + self.balls()
        return numpy.min([distance_to(solid, points).min(axis=1) for solid in self.solids], axis=0) - self.radius

    def clearance_of_ends(self):
        """Distance between object and environment at the start or the goal, the lesser of the two."""
        return self.clearance([(0, 0, 0), (*GOAL, 0)]).min()

    def straight_way_is_blocked(self):
        x = numpy.linspace(0, GOAL[0], 401)
        return bool((self.clearance(x[:, None] * (1, 0, 0)) <= 0).any())

    def detour(self, margin):
        """Length of the translations of a shortest way with `margin` on a lattice of 3 cm and 6 degrees, on which the
        object turns about one axis at a time; None if there is none. The margin is at least what any point of the
        object moves in half a step, so that the way is free between the nodes as well."""
        axes = [numpy.arange(round(low / STEP), round(high / STEP) + 1) * STEP for low, high in zip(*WORKSPACE)]
        shape = tuple(len(axis) for axis in axes)
        rotations, beside = rotations_of_lattice()
        blocked = BlockedPlaces(self, axes, max(margin, STEP / 2, math.pi / TURNS * self.reach()))
        free = numpy.stack([blocked.places_without(self.balls() @ turn.T, shape) for turn in rotations])
        cell = [(0, *(numpy.argmin(abs(axis - at)) for axis, at in zip(axes, end))) for end in ((0, 0, 0), (*GOAL, 0))]
        steps = flood(free, *cell, beside)
        return None if steps is None else steps * STEP

    def retrieval(self):
        """The task."""
        return Retrieval("spatial", self.object_shapes(), self.solids, (*GOAL, 0), WORKSPACE)


def rod(start, end, radius):
    """A cylinder between two points."""
    start, end = numpy.array(start), numpy.array(end)
    along = end - start
    rpy = (0, math.atan2(math.hypot(along[0], along[1]), along[2]), math.atan2(along[1], along[0]))
    return cylinder(radius, numpy.linalg.norm(along), tuple((start + end) / 2), rpy)


class BlockedPlaces:
    """Where the middle of a ball of the object is too near to the environment, on a grid finer than the lattice."""

    def __init__(self, scene, axes, margin):
        self.around = math.ceil(scene.reach() / STEP) * PARTS  # cells of the grid beyond the lattice
        cell = STEP / PARTS
        near = scene.radius + margin + cell * math.sqrt(3) / 2  # a ball stands half a diagonal beside its cell at most
        counts = [PARTS * (len(axis) - 1) + 1 + 2 * self.around for axis in axes]
        grid = [axis[0] + (numpy.arange(count) - self.around) * cell for axis, count in zip(axes, counts)]
        taken = numpy.zeros([len(axis) for axis in grid], dtype=bool)
        for solid in scene.solids:
            half = half_extent(solid) + near
            ends = zip(grid, solid.position - half, solid.position + half)
            part = tuple(slice(*numpy.searchsorted(axis, (low, high))) for axis, low, high in ends)
            points = numpy.stack(numpy.meshgrid(*(axis[s] for axis, s in zip(grid, part)), indexing="ij"), axis=-1)
            taken[part] |= distance_to(solid, points) <= near
        # Every fourth cell along each axis, together: what one ball of the object meets at all places of the lattice.
        self.phases = {
            phase: numpy.ascontiguousarray(taken[tuple(slice(begin, None, PARTS) for begin in phase)])
            for phase in numpy.ndindex(PARTS, PARTS, PARTS)
        }

    def places_without(self, balls, shape):
        """At which places of the lattice no ball, given relative to the object's origin, is too near."""
        met = numpy.zeros(shape, dtype=bool)
        for offset in numpy.unique(numpy.rint(balls * (PARTS / STEP)).astype(int) + self.around, axis=0):
            first, phase = offset // PARTS, tuple(offset % PARTS)
            met |= self.phases[phase][tuple(slice(at, at + count) for at, count in zip(first, shape))]
        return ~met
