# SPDX-License-Identifier: BSD-3-Clause
"""Random objects and obstacles in space, each from `draw`, a function that gives numbers from 0 to 1. Lengths in
metres."""
import math

import numpy

from random_shapes import between
from scene_geometry import rotation_of
from scene_writer import box
from spatial_scene import Spatial, rod

AXES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))


def random_turn(draw):
    """Roll, pitch and yaw of a rotation of uniform distribution."""
    return 2 * math.pi * draw(), math.asin(2 * draw() - 1), 2 * math.pi * draw()


def random_direction(draw):
    """A unit vector of uniform distribution."""
    return rotation_of(random_turn(draw))[:, 0]


def centered(points):
    points = numpy.array(points)
    return points - points.mean(axis=0)


def object_of_cells(draw):
    """Eight edges of a cubic lattice, each new one with an end that nothing else has."""
    edge, scene = between(draw, 0.08, 0.13), Spatial(between(draw, 0.01, 0.025))
    nodes, edges = [(0, 0, 0)], []
    while len(edges) < 8:
        start = nodes[int(draw() * len(nodes))]
        end = tuple(numpy.add(start, AXES[int(draw() * 6)]).tolist())
        if end not in nodes and max(map(abs, end)) <= 2:
            nodes.append(end)
            edges.append((start, end))
    places = dict(zip(nodes, edge * centered(nodes)))
    for start, end in edges:
        scene.bar(places[start], places[end])
    return scene


def object_of_a_wire(draw):
    """Three to five straight pieces, each bent from the one before by 40 to 140 degrees in any direction."""
    points, along = [numpy.zeros(3)], random_direction(draw)
    for _ in range(3 + int(3 * draw())):
        points.append(points[-1] + between(draw, 0.1, 0.25) * along)
        side = numpy.cross(along, random_direction(draw))
        bend = math.radians(between(draw, 40, 140))
        along = math.cos(bend) * along + math.sin(bend) * side / numpy.linalg.norm(side)
    return Spatial(between(draw, 0.01, 0.03)).chain(*centered(points))


def object_of_an_arc(draw):
    """A ring with a gap and a stem square to it."""
    radius, sweep, turn = between(draw, 0.1, 0.22), between(draw, 3.2, 5.4), rotation_of(random_turn(draw))
    angles = sweep * numpy.arange(9) / 8
    corners = radius * numpy.stack([numpy.cos(angles), numpy.sin(angles), numpy.zeros(9)], axis=1)
    stem = corners[4] + (0, 0, between(draw, 0.1, 0.25))
    scene = Spatial(between(draw, 0.01, 0.03)).chain(*(corners @ turn.T))
    return scene.bar(turn @ corners[4], turn @ stem)


def object_of_a_star(draw):
    """Four to six arms of unequal length from one point, at least 50 degrees apart."""
    scene, arms, directions = Spatial(between(draw, 0.01, 0.03)), 4 + int(3 * draw()), []
    while len(directions) < arms:
        new = random_direction(draw)
        if all(new @ other < math.cos(math.radians(50)) for other in directions):
            directions.append(new)
            scene.bar((0, 0, 0), between(draw, 0.12, 0.34) * new)
    return scene


def obstacles_of_rods(draw):
    """Three to six round rods across all of the space, in any direction."""
    scene = Spatial()
    for _ in range(3 + int(4 * draw())):
        middle = numpy.array([between(draw, -0.6, 0.2), between(draw, -0.3, 0.3), between(draw, -0.3, 0.3)])
        along = random_direction(draw)
        scene.solids.append(rod(middle - along, middle + along, between(draw, 0.01, 0.03)))
    return scene


def obstacles_of_a_slit(draw):
    """A wall across the way with a slit in it of any width, place and direction."""
    scene, reach, thickness = Spatial(), 2.4, 0.04
    width, length, roll = between(draw, 0.1, 0.3), between(draw, 0.5, 0.9), math.pi * draw()
    middle = numpy.array([between(draw, -0.6, -0.45), between(draw, -0.2, 0.2), between(draw, -0.2, 0.2)])
    turn, side, end = rotation_of((roll, 0, 0)), (reach - width) / 2, (reach - length) / 2
    for sign in (1, -1):
        beside = middle + turn @ (0, sign * (width + side) / 2, 0)
        beyond = middle + turn @ (0, 0, sign * (length + end) / 2)
        scene.solids.append(box((thickness, side, reach), tuple(beside), (roll, 0, 0)))
        scene.solids.append(box((thickness, width, end), tuple(beyond), (roll, 0, 0)))
    return scene


def obstacles_of_a_bracket(draw):
    """Three sides of a box, a floor between two walls, turned in any way, inside or around the object."""
    scene, rpy, thickness = Spatial(), random_turn(draw), 0.03
    width, depth, length = between(draw, 0.1, 0.45), between(draw, 0.1, 0.35), between(draw, 0.15, 0.6)
    middle = numpy.array([between(draw, -0.3, 0.1), between(draw, -0.2, 0.2), between(draw, -0.2, 0.2)])
    turn = rotation_of(rpy)
    scene.solids.append(box((thickness, width, length), tuple(middle), rpy))
    for sign in (1, -1):
        beside = middle + turn @ (depth / 2, sign * width / 2, 0)
        scene.solids.append(box((depth, thickness, length), tuple(beside), rpy))
    return scene


def obstacles_of_a_frame(draw):
    """Four rods around a rectangle, turned in any way, which the object may hang in."""
    scene, turn, radius = Spatial(), rotation_of(random_turn(draw)), between(draw, 0.01, 0.025)
    width, height = between(draw, 0.2, 0.5), between(draw, 0.2, 0.5)
    middle = numpy.array([between(draw, -0.3, 0.1), between(draw, -0.2, 0.2), between(draw, -0.2, 0.2)])
    corners = [
        middle + turn @ (0, y * width / 2, z * height / 2) for y, z in ((1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1))
    ]
    scene.solids += [rod(start, end, radius) for start, end in zip(corners, corners[1:])]
    return scene


OBJECTS = (object_of_cells, object_of_a_wire, object_of_an_arc, object_of_a_star)
OBSTACLES = (obstacles_of_rods, obstacles_of_a_slit, obstacles_of_a_bracket, obstacles_of_a_frame)
