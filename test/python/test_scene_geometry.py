#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Outlines of solids against their areas in closed form."""
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from scene_geometry import MASK_CELL, View, outline_mask, triangles_of  # noqa: E402

TOP = View(np.array([1.0, 0, 0]), np.array([0, 1.0, 0]))
SIDE = View(np.array([0, 1.0, 0]), np.array([0, 0, 1.0]))


def area(solids, view, depth):
    return outline_mask(solids, view, depth)[2].sum() * MASK_CELL**2


class SceneGeometryTest(unittest.TestCase):
    def test_turned_box(self):
        box = {"type": "box", "size": [0.4, 0.1, 0.2], "position": [0.3, 0, 0], "rpy": [0, 0, 0.7]}
        solid = triangles_of(box, ".")
        self.assertAlmostEqual(area([solid], TOP, 0.0), 0.04, delta=0.001)
        self.assertAlmostEqual(area([solid], TOP, None), 0.04, delta=0.001)
        self.assertEqual(area([solid], TOP, 0.11), 0.0)

    def test_tipped_cylinder(self):
        shape = {"type": "cylinder", "radius": 0.1, "length": 0.5, "position": [0, 0, 0]}
        upright = triangles_of(shape, ".")
        lying = triangles_of({**shape, "rpy": [np.pi / 2.0, 0, 0]}, ".")
        self.assertAlmostEqual(area([upright], TOP, 0.0), np.pi * 0.01, delta=0.0005)
        self.assertAlmostEqual(area([lying], TOP, 0.0), 0.1, delta=0.002)
        self.assertAlmostEqual(area([upright], SIDE, None), 0.1, delta=0.002)

    def test_sphere_cut_above_its_centre(self):
        solid = triangles_of({"type": "sphere", "radius": 0.1, "position": [0, 0, 0.2]}, ".")
        self.assertAlmostEqual(area([solid], TOP, 0.26), np.pi * 0.08**2, delta=0.0005)

    def test_union_counts_an_overlap_once(self):
        boxes = [
            triangles_of({"type": "box", "size": [0.2, 0.2, 0.2], "position": [x, 0, 0]}, ".")
            for x in (0.0, 0.1)
        ]
        self.assertAlmostEqual(area(boxes, TOP, 0.0), 0.06, delta=0.001)


if __name__ == "__main__":
    unittest.main()
