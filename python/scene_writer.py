# SPDX-License-Identifier: BSD-3-Clause
"""Scenes by shapes, the scenario files that they make, and whether a planar one has a way out."""
import math
import os

import numpy

from lattice import circle, flood

BAR = 0.06  # width of a bar and height of each planar object [m]
PEG_RADIUS = 0.03
PEG_LENGTH = 0.30
GOAL = (-1.0, 0.0)
WORKSPACE = ((-1.3, -0.7), (0.4, 0.7))  # the reference's
FAR_SIDE = 0.6  # x up to where other objects may be pulled out on the far side [m]


def text_of(value):
    """A length or angle with as many digits as matter (0.01 mm)."""
    return f"{round(value, 5) + 0.0:g}"


def triple(values):
    return "[" + ", ".join(text_of(v) for v in values) + "]"


def times(scale, values):
    return tuple(scale * value for value in values)


class Shape:
    """A box (its size), a cylinder (its radius and length) or a sphere (its radius), where it stands."""

    def __init__(self, kind, lengths, position, rpy=(0, 0, 0)):
        self.kind, self.lengths, self.position, self.rpy = kind, lengths, position, rpy

    def scaled(self, scale):
        return Shape(self.kind, times(scale, self.lengths), times(scale, self.position), self.rpy)

    def __str__(self):
        if self.kind == "box":
            lengths = f"size: {triple(self.lengths)}"
        else:
            lengths = ", ".join(f"{name}: {text_of(value)}" for name, value in zip(("radius", "length"), self.lengths))
        turned = f", rpy: {triple(self.rpy)}" if any(self.rpy) else ""
        return f"{{type: {self.kind}, {lengths}, position: {triple(self.position)}{turned}}}"


def box(size, position, rpy=(0, 0, 0)):
    return Shape("box", size, position, rpy)


def cylinder(radius, length, position, rpy=(0, 0, 0)):
    return Shape("cylinder", (radius, length), position, rpy)


def sphere(radius, position):
    return Shape("sphere", (radius,), position)


class Planar:
    """A planar scene: the object is made of bars, the environment of pegs and walls with round ends."""

    def __init__(self, far_side=FAR_SIDE):
        self.workspace = (WORKSPACE[0], (far_side, WORKSPACE[1][1]))
        self.bars = []  # centre x, y, angle, length, width
        self.walls = []  # from x, y, to x, y, radius; a peg is a wall of no length

    def bar(self, start, end, width=BAR, beyond=None):
        """A bar between two points that reaches `beyond` them at both ends (half its width)."""
        beyond = width / 2 if beyond is None else beyond
        dx, dy = end[0] - start[0], end[1] - start[1]
        center = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
        self.bars.append((*center, math.atan2(dy, dx), math.hypot(dx, dy) + 2 * beyond, width))
        return self

    def chain(self, *points, width=BAR):
        for start, end in zip(points, points[1:]):
            self.bar(start, end, width)
        return self

    def peg(self, x, y, radius=PEG_RADIUS):
        return self.wall((x, y), (x, y), radius)

    def wall(self, start, end, radius=0.02):
        self.walls.append((*start, *end, radius))
        return self

    def place_among(self, obstacles):
        """Among those of another scene, in place of its own."""
        self.walls = obstacles.walls

    def object_shapes(self):
        return [box((length, width, BAR), (x, y, 0), (0, 0, angle)) for x, y, angle, length, width in self.bars]

    def environment_shapes(self):
        shapes = []
        for x0, y0, x1, y1, radius in self.walls:
            shapes.append(cylinder(radius, PEG_LENGTH, (x0, y0, 0)))
            length = math.hypot(x1 - x0, y1 - y0)
            if length > 0:
                shapes.append(cylinder(radius, PEG_LENGTH, (x1, y1, 0)))
                center = ((x0 + x1) / 2, (y0 + y1) / 2, 0)
                shapes.append(box((length, 2 * radius, PEG_LENGTH), center, (0, 0, math.atan2(y1 - y0, x1 - x0))))
        return shapes

    def discs(self):
        """The environment as discs: x, y, radius, every centimetre of a wall."""
        for x0, y0, x1, y1, radius in self.walls:
            count = max(1, math.ceil(math.hypot(x1 - x0, y1 - y0) / 0.01))
            for i in range(count + 1 if (x0, y0) != (x1, y1) else 1):
                yield x0 + (x1 - x0) * i / count, y0 + (y1 - y0) * i / count, radius

    def reach(self):
        """From the object's origin to its farthest point [m]."""
        return max(math.hypot(x, y) + math.hypot(length, width) / 2 for x, y, _, length, width in self.bars)

    def clearance(self, x, y, angle, discs=None):
        """Least distance between object and environment (or some discs of it) at poses (arrays of one shape) [m]."""
        least = numpy.full(numpy.broadcast(x, y, angle).shape, numpy.inf)
        for disc_x, disc_y, radius in self.discs() if discs is None else discs:
            u = numpy.cos(angle) * (disc_x - x) + numpy.sin(angle) * (disc_y - y)
            v = numpy.cos(angle) * (disc_y - y) - numpy.sin(angle) * (disc_x - x)
            for bar_x, bar_y, turn, length, width in self.bars:
                along = math.cos(turn) * (u - bar_x) + math.sin(turn) * (v - bar_y)
                across = math.cos(turn) * (v - bar_y) - math.sin(turn) * (u - bar_x)
                beyond_x = numpy.abs(along) - length / 2
                beyond_y = numpy.abs(across) - width / 2
                outside = numpy.hypot(numpy.maximum(beyond_x, 0), numpy.maximum(beyond_y, 0))
                inside = numpy.minimum(numpy.maximum(beyond_x, beyond_y), 0)
                least = numpy.minimum(least, outside + inside - radius)
        return least

    def clearance_of_ends(self):
        """Distance between object and environment at the start or the goal, the lesser of the two [m]."""
        return min(self.clearance(0.0, 0.0, 0.0), self.clearance(*GOAL, 0.0))

    def straight_way_is_blocked(self):
        x = numpy.linspace(0, GOAL[0], 401)
        return bool((self.clearance(x, 0.0, 0.0) <= 0).any())

    def detour(self, margin=0.006):
        """Length of a shortest way on a lattice of 1.5 cm and 3 degrees with `margin` [m]; None if there is none."""
        step, turns = 0.015, 120
        low, high = self.workspace
        x = numpy.arange(round(low[0] / step), round(high[0] / step) + 1) * step
        y = numpy.arange(round(low[1] / step), round(high[1] / step) + 1) * step
        angle = numpy.arange(turns) * (2 * math.pi / turns)
        free = numpy.ones((turns, len(x), len(y)), dtype=bool)
        for disc in self.discs():
            far = self.reach() + disc[2] + margin
            near = [slice(*numpy.searchsorted(axis, (at - far, at + far))) for axis, at in zip((x, y), disc)]
            poses = x[None, near[0], None], y[None, None, near[1]], angle[:, None, None]
            free[:, near[0], near[1]] &= self.clearance(*poses, [disc]) > margin
        cell = [(0, numpy.argmin(abs(x - px)), numpy.argmin(abs(y - py))) for px, py in ((0, 0), GOAL)]
        steps = flood(free, *cell, circle(turns))
        return None if steps is None else steps * step

    def retrieval(self):
        """The task."""
        return planar(self)


def write(directory, name, comment, lines):
    os.makedirs(directory, exist_ok=True)
    path = os.path.join(directory, name + ".yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write("# " + comment + "\n" + "\n".join(["name: " + name, *lines]) + "\n")
    return path


def shape_list(key, shapes, scale=1):
    return [key + ":", "  shapes:", *(f"    - {shape.scaled(scale)}" for shape in shapes)]


def pose(position):
    return f"{{position: {triple(position)}, rpy: [0, 0, 0]}}"


def perturb(scale=1):
    return f"perturb: {{position: {text_of(0.015 * scale)}, angle: 0.05}}"


class Retrieval:
    """A task of retrieval by the cartesian robot, from the origin to `goal`."""

    def __init__(self, motion, bodies, environment, goal, workspace, voxel_size=0.03):
        self.motion, self.bodies, self.environment = motion, bodies, environment
        self.goal, self.workspace, self.voxel_size = goal, workspace, voxel_size

    def lines(self, scale=1, more=None):
        """With each length that the task states times `scale`, what it states by default among them."""
        low, high = (triple(times(scale, corner)) for corner in self.workspace)
        told = []
        if scale != 1:
            told = [f"goal_tolerance: {{position: {text_of(0.02 * scale)}, angle: 0.1}}"]
            told.append(f"speed: {{linear: {text_of(0.1 * scale)}, angular: 0.5}}")
        return [
            "task: retrieve",
            f"voxel_size: {text_of(self.voxel_size * scale)}",
            f"motion: {self.motion}",
            "robot: cartesian",
            *shape_list("object", self.bodies, scale),
            *shape_list("environment", self.environment, scale),
            f"start: {pose((0, 0, 0))}",
            f"goal: {pose(times(scale, self.goal))}",
            f"workspace: {{min: {low}, max: {high}}}",
            *told,
            *((perturb(scale),) if more is None else more),
        ]


def planar(scene, voxel_size=0.03, widened=1):
    """The task of a planar scene, in a workspace `widened` about its middle."""
    low, high = numpy.array(scene.workspace)
    middle, half = (low + high) / 2, widened * (high - low) / 2
    workspace = ((*(middle - half), -0.01), (*(middle + half), 0.01))
    goal = (*GOAL, 0)
    return Retrieval("planar", scene.object_shapes(), scene.environment_shapes(), goal, workspace, voxel_size)
