#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of solids against closed forms.

    test_surface.py
"""
import itertools
import pathlib
import sys
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from experiments import best_touches  # noqa: E402
from experiments.in_space import edges_of  # noqa: E402
from experiments.surface import Surface, points_of, winding  # noqa: E402


def box(size, middle):
    """Twelve triangles, counter-clockwise from outside."""
    triangles = []
    for axis, sign in itertools.product(range(3), (1, -1)):
        u, v = ((axis + 1) % 3, (axis + 2) % 3)[::sign]
        corners = np.zeros((4, 3))
        corners[:, axis] = sign
        corners[:, u], corners[:, v] = (-1, 1, 1, -1), (-1, -1, 1, 1)
        triangles += [corners[[0, 1, 2]], corners[[0, 2, 3]]]
    return np.array(triangles) * np.array(size) / 2 + middle


class SurfaceTest(unittest.TestCase):
    def test_small_triangles_have_the_area_and_the_middle_of_the_large_one(self):
        triangle = np.array([[0, 0, 0], [0.3, 0, 0], [0, 0.1, 0.2]])
        for apart in (1.0, 0.1, 0.03):
            points, area = points_of(triangle, apart)
            self.assertAlmostEqual(area * len(points), 0.5 * 0.3 * np.hypot(0.1, 0.2), places=12)
            np.testing.assert_allclose(points.mean(axis=0), triangle.mean(axis=0), atol=1e-12)

    def test_a_solid_winds_once_around_what_is_inside(self):
        solid = box((0.2, 0.4, 0.6), (1, 2, 3))
        points = np.random.default_rng(1).uniform((0.7, 1.6, 2.5), (1.3, 2.4, 3.5), (200, 3))
        inside = np.all(np.abs(points - (1, 2, 3)) < (0.1, 0.2, 0.3), axis=1)
        np.testing.assert_allclose(winding(points, solid), inside, atol=1e-9)
        self.assertTrue(0 < inside.sum() < 200)

    def test_what_lies_between_two_solids_is_no_surface(self):
        alone = Surface([box((0.2, 0.2, 0.2), (0, 0, 0))])
        self.assertAlmostEqual(alone.areas.sum(), 6 * 0.04, places=9)
        stacked = Surface([box((0.2, 0.2, 0.2), (0, 0, 0)), box((0.1, 0.1, 0.3), (0, 0, 0.25))])
        self.assertAlmostEqual(stacked.areas.sum(), 6 * 0.04 + 4 * 0.03 + 0.01 - 0.01, delta=0.002)

    def test_distances_and_shares_near_a_place(self):
        surface = Surface([box((0.2, 0.2, 0.2), (0, 0, 0))])
        found = surface.distances(np.array([[0.15, 0, 0], [0, 0, 0], [0.2, 0.2, 0.2]]))
        np.testing.assert_allclose(found, [0.05, 0.1, 0.1 * np.sqrt(3)], atol=0.007)
        self.assertAlmostEqual(surface.share_near([[0.1, 0, 0]], 0.08), np.pi * 0.08**2 / 0.24, delta=0.004)
        self.assertEqual(surface.share_near(np.zeros((0, 3)), 0.08), 0.0)

    def test_the_best_touches_are_one_in_the_middle_of_each_face(self):
        surface = Surface([box((0.2, 0.2, 0.2), (0, 0, 0))])
        middles = [sign * 0.1 * np.eye(3)[axis] for axis, sign in itertools.product(range(3), (1, -1))]
        corners = [np.array(corner) for corner in itertools.product((0.1, -0.1), repeat=3)]
        whole = best_touches.distance_for(surface, [middles], 1.0)
        self.assertAlmostEqual(whole, 0.1 * np.sqrt(2), delta=0.006)
        self.assertEqual(best_touches.fewest(surface, corners + middles, 0.06, 0.0), 0)
        for count in (1, 3, 6):
            wanted = 0.99 * count * np.pi * 0.06**2 / 0.24
            self.assertEqual(best_touches.fewest(surface, corners + middles, 0.06, wanted), count)
        self.assertIsNone(best_touches.fewest(surface, corners, 0.06, 1.0))

    def test_a_box_has_twelve_edges(self):
        self.assertEqual(len(edges_of(box((0.2, 0.4, 0.6), (0, 0, 0)))), 12)


if __name__ == "__main__":
    unittest.main()
