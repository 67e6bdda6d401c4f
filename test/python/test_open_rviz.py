#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The view of rviz fits scenes of any size."""
import copy
import math
import pathlib
import sys
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from open_rviz import box_of, config_for, framed, round_length  # noqa: E402
from scene_file import read_scene  # noqa: E402

CONFIGS = sorted((ROOT / "config/rviz").glob("*.rviz"))
FIELD_OF_VIEW = 0.785  # of the configurations, upwards [rad]


def scaled(box, factor):
    return box[0] * factor, box[1] * factor


def view_of(config):
    view = config["Visualization Manager"]["Views"]["Current"]
    return view["Distance"], np.array([view["Focal Point"][axis] for axis in "XYZ"])


def display(config, name):
    return next(d for d in config["Visualization Manager"]["Displays"] if d["Name"] == name)


class OpenRvizTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.box = box_of(read_scene("s_shape_two_pegs"))

    def test_the_box_holds_the_workspace_and_the_object_at_start_and_goal(self):
        scene = read_scene("mug_on_hook")
        low, high = box_of(scene)
        self.assertTrue(np.all(low <= scene["workspace"]["min"]) and np.all(high >= scene["workspace"]["max"]))
        self.assertLess(low[0], scene["goal"]["position"][0] - 0.03)  # half of the mug

    def test_of_a_task_the_box_holds_the_arms_base(self):
        scene = read_scene(ROOT / "config/tasks/ur5e.yaml")
        low, high = box_of(scene)
        base = scene["robot_base"]["position"]
        self.assertTrue(np.all(low <= base) and np.all(high >= base))
        self.assertTrue(np.all(high >= scene["workspace"]["max"]))

    def test_every_configuration_is_framed_alike_at_every_size(self):
        self.assertEqual(len(CONFIGS), 4)
        for file in CONFIGS:
            config = config_for(file, "none")
            whole = copy.deepcopy(config)
            for factor in (0.01, 1.0, 300.0):
                low, high = scaled(self.box, factor)
                distance, focus = view_of(framed(config, (low, high)))
                np.testing.assert_allclose(focus, (low + high) / 2)
                seen = 2 * distance * math.tan(FIELD_OF_VIEW / 2)  # at the focus, upwards
                share = np.linalg.norm(high - low) / seen
                self.assertTrue(0.9 < share < 1.3, f"{file.name}: {share}")
            self.assertEqual(config, whole, "changed in place")

    def test_the_grid_has_round_cells_and_lies_below_the_scene(self):
        for factor in (0.01, 1.0, 300.0):
            low, high = scaled(self.box, factor)
            grid = display(framed(config_for(CONFIGS[0], "none"), (low, high)), "Grid")
            self.assertLess(grid["Offset"]["Z"], low[2])
            half = grid["Cell Size"] * grid["Plane Cell Count"] / 2
            center = np.array([grid["Offset"]["X"], grid["Offset"]["Y"]])
            self.assertTrue(np.all(center - half < low[:2]) and np.all(center + half > high[:2]))

    def test_lengths_are_rounded_down_to_one_two_or_five(self):
        for length, rounded in ((1.0, 1.0), (1.9, 1.0), (0.2, 0.2), (0.049, 0.02), (77.0, 50.0), (0.001, 0.001)):
            self.assertAlmostEqual(round_length(length) / rounded, 1.0)

    def test_a_scenario_that_cannot_be_read_leaves_the_view_as_it_is(self):
        self.assertEqual(config_for(CONFIGS[0], "/no/such.yaml"), config_for(CONFIGS[0], "none"))


if __name__ == "__main__":
    unittest.main()
