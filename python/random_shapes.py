# SPDX-License-Identifier: BSD-3-Clause
"""Random planar objects and obstacles, each from `draw`, a function that gives numbers from 0 to 1. Lengths in metres."""
import math

from scene_writer import Planar


def between(draw, low, high):
    return low + (high - low) * draw()


def polyomino(draw):
    """Nine cells on a 7 x 7 board: each new one shares an edge with just one other, so that it stays thin."""
    cells = [(0, 0)]
    while len(cells) < 9:
        x, y = cells[int(draw() * len(cells))]
        dx, dy = ((1, 0), (-1, 0), (0, 1), (0, -1))[int(draw() * 4)]
        new = (x + dx, y + dy)
        neighbours = sum(abs(new[0] - a) + abs(new[1] - b) == 1 for a, b in cells)
        if new not in cells and neighbours == 1 and max(abs(new[0]), abs(new[1])) <= 3:
            cells.append(new)
    return cells


def object_of_cells(draw):
    """A thin polyomino."""
    scene, cell = Planar(), between(draw, 0.07, 0.12)
    for x, y in polyomino(draw):
        scene.bars.append((x * cell, y * cell, 0.0, cell, cell))
    return scene


def object_of_a_chain(draw):
    """Three to five bars end to end, as a bent wire."""
    points, heading = [(0.0, 0.0)], 2 * math.pi * draw()
    for _ in range(3 + int(3 * draw())):
        length = between(draw, 0.12, 0.32)
        points.append((points[-1][0] + length * math.cos(heading), points[-1][1] + length * math.sin(heading)))
        heading += math.copysign(between(draw, 0.7, 2.4), draw() - 0.5)
    middle = [sum(axis) / len(points) for axis in zip(*points)]
    return Planar().chain(*((x - middle[0], y - middle[1]) for x, y in points), width=between(draw, 0.02, 0.08))


def object_of_an_arc(draw):
    """A ring with a gap."""
    radius, turn, sweep = between(draw, 0.12, 0.28), 2 * math.pi * draw(), between(draw, 3.2, 5.4)
    corners = [
        (radius * math.cos(turn + sweep * i / 8), radius * math.sin(turn + sweep * i / 8)) for i in range(9)
    ]
    return Planar().chain(*corners, width=between(draw, 0.02, 0.07))


def object_of_a_star(draw):
    """Three to five arms of unequal length from one point."""
    scene, arms, width = Planar(), 3 + int(3 * draw()), between(draw, 0.02, 0.08)
    for arm in range(arms):
        angle, length = 2 * math.pi * (arm + 0.6 * draw()) / arms, between(draw, 0.12, 0.36)
        scene.bar((0, 0), (length * math.cos(angle), length * math.sin(angle)), width)
    return scene


def obstacles_of_pegs(draw):
    scene = Planar()
    for _ in range(2 + int(4 * draw())):
        scene.peg(between(draw, -0.35, 0.35), between(draw, -0.35, 0.35), between(draw, 0.015, 0.05))
    return scene


def obstacles_of_walls(draw):
    scene = Planar()
    for _ in range(2 + int(2 * draw())):
        x, y, angle, length = between(draw, -0.4, 0.3), between(draw, -0.3, 0.3), math.pi * draw(), between(draw, 0.1, 0.4)
        along = (0.5 * length * math.cos(angle), 0.5 * length * math.sin(angle))
        scene.wall((x - along[0], y - along[1]), (x + along[0], y + along[1]))
    return scene


def obstacles_of_a_bracket(draw):
    """Three sides of a rectangle, somewhere inside or around the object."""
    width, depth = between(draw, 0.08, 0.4), between(draw, 0.08, 0.3)
    x, y, angle = between(draw, -0.3, 0.3), between(draw, -0.3, 0.3), 2 * math.pi * draw()
    corners = [
        (x + u * math.cos(angle) - v * math.sin(angle), y + u * math.sin(angle) + v * math.cos(angle))
        for u, v in ((depth, -width / 2), (0, -width / 2), (0, width / 2), (depth, width / 2))
    ]
    scene = Planar()
    for start, end in zip(corners, corners[1:]):
        scene.wall(start, end)
    return scene


def obstacles_of_a_gap(draw):
    """A wall across the way with a gap in it."""
    x, middle, half = between(draw, -0.6, -0.4), between(draw, -0.3, 0.3), between(draw, 0.09, 0.25)
    return Planar().wall((x, middle + half), (x, 1.2)).wall((x, middle - half), (x, -1.2))


OBJECTS = (object_of_cells, object_of_a_chain, object_of_an_arc, object_of_a_star)
OBSTACLES = (obstacles_of_pegs, obstacles_of_walls, obstacles_of_a_bracket, obstacles_of_a_gap)
