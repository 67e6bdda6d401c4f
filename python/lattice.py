# SPDX-License-Identifier: BSD-3-Clause
"""Search on lattices of poses."""
import itertools

import numpy


def flood(free, start, goal, beside):
    """Number of unit steps from start to goal through free cells; None if there is no way.

    The first axis of `free` counts rotations: row i of `beside` lists those that are one step from rotation i. The
    others are places, where a step goes to the next cell.
    """
    shape = [free.shape[0], *(count + 2 for count in free.shape[1:])]
    left = numpy.pad(free, [(0, 0)] + [(1, 1)] * (free.ndim - 1)).ravel()  # free and not reached yet
    front, goal = ([numpy.ravel_multi_index((cell[0], *(at + 1 for at in cell[1:])), shape)] for cell in (start, goal))
    if not left[front[0]] or not left[goal[0]]:
        return None
    front, reached_by = numpy.array(front), numpy.empty(left.size, dtype=numpy.int32)
    left[front] = False
    places = numpy.prod(shape[1:])
    strides = [numpy.prod(shape[axis + 1:], dtype=int) for axis in range(1, free.ndim)]
    for step in itertools.count():
        if not left[goal[0]]:
            return step
        turned = beside[front // places] * places + (front % places)[:, None]
        near = numpy.concatenate([turned.ravel(), *(front + sign * stride for stride in strides for sign in (1, -1))])
        near = near[left[near]]
        if not near.size:
            return None
        left[near] = False
        reached_by[near] = numpy.arange(near.size)  # the last of those that reach one cell
        front = near[reached_by[near] == numpy.arange(near.size)]


def circle(count):
    """Neighbours of each of so many turns about one axis."""
    turns = numpy.arange(count)
    return numpy.stack([(turns + 1) % count, (turns - 1) % count], axis=1)
