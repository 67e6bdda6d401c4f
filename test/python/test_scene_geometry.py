#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Outlines of solids, as the program reads them, against their areas in closed form.

    test_scene_geometry.py      (with smore_experiment on PATH)
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from scene_file import SceneFileError, find_program  # noqa: E402
from scene_geometry import Scene, View, fullest_depth, outline_mask  # noqa: E402

TOP = View(np.array([1.0, 0, 0]), np.array([0, 1.0, 0]))
SIDE = View(np.array([0, 1.0, 0]), np.array([0, 0, 1.0]))
CASES = ROOT / "test/data/cases"

SCENE = """
name: shapes
task: retrieve
voxel_size: 3e-2
motion: planar
robot: cartesian
object: {{shapes: [{{type: sphere, radius: 1e-2, position: [0, 0, 0]}}]}}
environment: {{shapes: [{shapes}]}}
start: {{position: [0, -5, 0]}}
goal: {{position: [0, -6, 0], rpy: [0, 0, 0.5]}}
workspace: {{min: [-1, -7, -1], max: [1, -4, 1]}}
"""


def scene_of(*shapes):
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        file.write(SCENE.format(shapes=", ".join(shapes)))
        file.flush()
        return Scene(file.name)


def solids_of(*shapes):
    return scene_of(*shapes).environment


def area(solids, view, depth):
    right, up, mask = outline_mask(solids, view, depth)
    return mask.sum() * (right[1] - right[0]) * (up[1] - up[0])


class SceneGeometryTest(unittest.TestCase):
    def test_turned_box(self):
        solids = solids_of("{type: box, size: [0.4, 0.1, 0.2], position: [0.3, 0, 0], rpy: [0, 0, 0.7]}")
        self.assertAlmostEqual(area(solids, TOP, 0.0), 0.04, delta=0.001)
        self.assertAlmostEqual(area(solids, TOP, None), 0.04, delta=0.001)
        self.assertEqual(area(solids, TOP, 0.11), 0.0)

    def test_tipped_cylinder(self):
        upright = solids_of("{type: cylinder, radius: 0.1, length: 0.5, position: [0, 0, 0]}")
        lying = solids_of("{type: cylinder, radius: 0.1, length: 0.5, position: [0, 0, 0], rpy: [1.5708, 0, 0]}")
        self.assertAlmostEqual(area(upright, TOP, 0.0), np.pi * 0.01, delta=0.0005)
        self.assertAlmostEqual(area(lying, TOP, 0.0), 0.1, delta=0.002)
        self.assertAlmostEqual(area(upright, SIDE, None), 0.1, delta=0.002)

    def test_sphere_cut_above_its_centre(self):
        solids = solids_of("{type: sphere, radius: 0.1, position: [0, 0, 0.2]}")
        self.assertAlmostEqual(area(solids, TOP, 0.26), np.pi * 0.08**2, delta=0.0005)

    def test_union_counts_an_overlap_once(self):
        boxes = [f"{{type: box, size: [0.2, 0.2, 0.2], position: [{x}, 0, 0]}}" for x in (0.0, 0.1)]
        self.assertAlmostEqual(area(solids_of(*boxes), TOP, 0.0), 0.06, delta=0.001)

    def test_at_any_size_a_cut_has_its_area(self):
        for size in (0.01, 1.0, 8.0):
            solids = solids_of(f"{{type: box, size: [{size}, {0.5 * size}, {size}], position: [0, 0, 0]}}")
            self.assertAlmostEqual(area(solids, TOP, 0.0) / (0.5 * size**2), 1.0, delta=0.02)

    def test_a_thin_wall_is_cut_where_it_stands(self):
        wall = "{type: box, size: [0.004, 1, 1], position: [-0.31, 0, 0]}"
        rod = "{type: cylinder, radius: 0.02, length: 0.5, position: [0.4, 0, 0]}"
        self.assertAlmostEqual(fullest_depth(solids_of(rod, wall), SIDE), -0.31, delta=0.002)

    def test_poses_and_the_kind_of_motion(self):
        scene = scene_of("{type: sphere, radius: 0.1, position: [0, 0, 0]}")
        self.assertTrue(scene.planar)
        self.assertEqual(scene.start[1, 3], -5.0)
        self.assertAlmostEqual(np.arctan2(scene.goal[1, 0], scene.goal[0, 0]), 0.5)

    def test_a_concave_polygon_is_cut_where_there_is_matter(self):
        # A U of 0.4 x 0.4 m with a notch of 0.2 x 0.3 m, whose caps are polygons of eight corners.
        for name in ("u_plate", "u_plate_from_notch", "u_plate_triangulated"):
            solids = Scene(CASES / f"ngon/{name}.yaml").environment
            self.assertAlmostEqual(area(solids, TOP, 0.0), 0.1, delta=0.002)

    def test_numbers_are_those_of_the_program(self):
        solids = Scene(CASES / "numbers/sci.yaml").environment
        self.assertAlmostEqual(np.ptp(solids[0][..., 0]), 0.06, delta=1e-4)

    def test_what_the_program_refuses_is_told_in_its_words(self):
        with self.assertRaisesRegex(SceneFileError, "looks like degrees"):
            Scene(CASES / "degrees/degrees.yaml")

    def test_a_task_has_nothing_to_draw(self):
        with self.assertRaisesRegex(SceneFileError, "ur5e is a task"):
            Scene(ROOT / "config/tasks/ur5e.yaml")

    def test_a_scene_written_before_is_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "scene.json")
            subprocess.run([find_program(), "--scenario", "one_peg", "--validate", "--output", str(file)],
                           check=True, capture_output=True)
            written, read = Scene(file), Scene("one_peg")
        self.assertEqual(written.name, "one_peg")
        self.assertEqual(len(written.object), 5)
        for a, b in zip(written.object + written.environment, read.object + read.environment):
            np.testing.assert_array_equal(a, b)


if __name__ == "__main__":
    unittest.main()
