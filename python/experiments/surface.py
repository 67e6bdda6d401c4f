# SPDX-License-Identifier: BSD-3-Clause
"""The true surface of a body, against which occupied voxels are measured."""
import numpy as np

APART = 0.01  # of the points that stand for the surface, at most [m]
OUTSIDE = 1e-4  # how far before the surface it is asked whether another solid is there [m]


def points_of(triangle, apart):
    """Centres of the small triangles that a triangle is divided into, and the area of each."""
    a, b, c = triangle
    count = max(1, int(np.ceil(max(np.linalg.norm(b - a), np.linalg.norm(c - b), np.linalg.norm(a - c)) / apart)))
    i, j = np.indices((count, count)).reshape(2, -1)
    upright, turned = i + j < count, i + j < count - 1
    shares = np.concatenate([
        np.stack([i[upright], j[upright]], axis=1) + 1 / 3, np.stack([i[turned], j[turned]], axis=1) + 2 / 3,
    ]) / count
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a)) / count**2
    return a + shares @ np.stack([b - a, c - a]), area


def winding(points, triangles):
    """How often closed triangles turn around each point: 1 inside, 0 outside."""
    total = np.zeros(len(points))
    for corners in triangles:
        a, b, c = (corner - points for corner in corners)
        la, lb, lc = (np.linalg.norm(side, axis=1) for side in (a, b, c))
        volume = np.einsum("ij,ij->i", a, np.cross(b, c))
        dots = (np.einsum("ij,ij->i", *pair) for pair in ((a, b), (b, c), (c, a)))
        ab, bc, ca = dots
        total += 2 * np.arctan2(volume, la * lb * lc + ab * lc + bc * la + ca * lb)
    return total / (4 * np.pi)


def is_inside(points, solid):
    """Whether each point is inside a solid of closed triangles."""
    low, high = solid.min(axis=(0, 1)), solid.max(axis=(0, 1))
    inside = np.all((points >= low) & (points <= high), axis=1)
    inside[inside] = winding(points[inside], solid) > 0.5
    return inside


class Surface:
    """Of some solids, each a list of triangles, together: what lies between two solids is not surface."""

    def __init__(self, solids):
        points, areas = [], []
        for number, solid in enumerate(solids):
            others = [other for each, other in enumerate(solids) if each != number]
            for triangle in solid:
                normal = np.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
                found, area = points_of(triangle, APART)
                before = found + OUTSIDE * normal / np.linalg.norm(normal)
                free = np.ones(len(found), dtype=bool)
                for other in others:
                    free &= ~is_inside(before, other)
                points.append(found[free])
                areas.append(np.full(len(found[free]), area))
        self.points, self.areas = np.concatenate(points), np.concatenate(areas)

    def distances(self, places):
        """From each place to the nearest point of the surface [m]."""
        return np.array([np.linalg.norm(self.points - place, axis=1).min() for place in places])

    def near(self, place, distance):
        """Whether each point of the surface is within a distance [m] of a place."""
        return np.linalg.norm(self.points - place, axis=1) <= distance

    def share(self, chosen):
        """Of the surface, by area, that the chosen of its points stand for."""
        return self.areas[chosen].sum() / self.areas.sum()

    def share_near(self, places, distance):
        """Share of the surface with one of the places within a distance [m]."""
        near = np.zeros(len(self.points), dtype=bool)
        for place in places:
            near |= self.near(place, distance)
        return self.share(near)
