#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The simulator as a module of Python: repeatable, without leaks, its errors clear, its contacts those of
smore_experiment. Needs nothing but NumPy.

    test_simulator_module.py
"""
import json
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "python/smore_gym")]
from map_image import GOAL, ORIGIN, UNKNOWN, WORLD_COLORS, map_image  # noqa: E402
from simulator import LARGEST_SHIFT, LARGEST_TURN, InputError, SteppedTrial  # noqa: E402

LARGEST = np.array([LARGEST_SHIFT, LARGEST_SHIFT, LARGEST_TURN])
LEAK = 1024  # KiB that eight trials of 1000 steps may add: 130 bytes a step


def trajectory(seed, actions):
    trial = SteppedTrial("s_shape_perturbed", seed)
    return [(*trial.difference(), *trial.step(action).wrench) for action in actions]


def resident_memory():
    """Of this process [KiB]."""
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize() // 1024


def row_major(record):
    return np.vstack([np.reshape(record, (3, 4)), [0, 0, 0, 1]])


def steps_along(trial, pose):
    """Actions that move straight to a pose of the plane."""
    shift = pose[:2, 3] - trial.pose[:2, 3]
    turn = pose[:3, :3] @ trial.pose[:3, :3].T
    way = np.array([*shift, np.arctan2(turn[1, 0], turn[0, 0])])
    count = max(1, int(np.ceil(np.max(np.abs(way) / LARGEST))))
    return [way / count] * count


class SimulatorModuleTest(unittest.TestCase):
    def test_the_same_seed_gives_the_same_trajectory(self):
        actions = np.random.default_rng(3).uniform(-LARGEST, LARGEST, (40, 3))
        self.assertEqual(trajectory(1, actions), trajectory(1, actions))
        self.assertNotEqual(trajectory(1, actions), trajectory(2, actions))

    def test_ten_thousand_steps_leave_no_memory_behind(self):
        random = np.random.default_rng(5)
        contacts, resident = 0, []
        for seed in range(10):
            trial = None  # its memory is for the next one
            trial = SteppedTrial("one_peg", seed)
            for step in range(1000):
                if step % 200 == 0:
                    trial.restart()
                contacts += trial.step(random.uniform(-LARGEST, LARGEST)).contact
            resident.append(resident_memory())
        self.assertGreater(contacts, 100)
        self.assertLess(resident[-1] - resident[1], LEAK, resident)

    def test_errors_name_what_is_wrong(self):
        trial = SteppedTrial("one_peg", 1)
        for action, words in (([0, 0], "2 numbers.*takes 3"), ([0, np.nan, 0], "not finite")):
            with self.assertRaisesRegex(InputError, words):
                trial.step(np.array(action, dtype=float))
        with self.assertRaisesRegex(ValueError, "no_such_scene"):
            SteppedTrial("no_such_scene", 1)
        with self.assertRaisesRegex(ValueError, "cspace keeps no maps"):
            SteppedTrial("one_peg", 1, "cspace")
        with self.assertRaisesRegex(ValueError, "keeps no maps"):
            trial.world_map()

    def test_a_scenario_in_space_takes_six_numbers(self):
        trial = SteppedTrial("slit", 1)
        self.assertEqual(trial.dimensions, 6)
        self.assertEqual(trial.step(np.zeros(6)).contact, False)

    def test_an_arm_takes_actions_too(self):
        trial = SteppedTrial("ur5e_one_peg_quiet", 1)
        before = trial.pose
        action = np.zeros(trial.dimensions)
        action[0] = -0.01
        outcome = trial.step(action)
        self.assertEqual((outcome.refused, outcome.reason), (False, ""))
        self.assertGreater(np.linalg.norm(outcome.pose[:3, 3] - before[:3, 3]), 0.005)

    def test_the_first_contact_of_an_experiment_is_felt_again(self):
        with tempfile.TemporaryDirectory() as folder:
            command = ["smore_experiment", "--scenario", "one_peg", "--method", "paper", "--seed", "4"]
            command += ["--max-collisions", "1", "--record", folder, "--output", f"{folder}/result.json"]
            subprocess.run(command, check=True, capture_output=True)
            lines = pathlib.Path(folder, "seed_4.evidence").read_text().splitlines()
        records = [json.loads(line) for line in lines]
        path = next(record["path"] for record in records if record.get("record") == "motion")
        touched = next(record for record in records if "line" in record)
        trial = SteppedTrial("one_peg", 4)
        for pose in map(row_major, path[1:]):
            for action in steps_along(trial, pose):
                outcome = trial.step(action)
                if outcome.contact:
                    break
            if outcome.contact:
                break
        self.assertTrue(outcome.contact)
        np.testing.assert_allclose(outcome.pose, row_major(touched["pose"]), atol=2e-3)
        force, torque = outcome.wrench[:3], outcome.wrench[3:]
        direction = force / np.linalg.norm(force)
        point = np.cross(force, torque) / (force @ force)
        recorded = np.array(touched["line"]["direction"])
        self.assertGreater(abs(direction @ recorded), np.cos(0.1))
        self.assertLess(np.linalg.norm(np.cross(point - touched["line"]["point"], recorded)), 5e-3)

    def test_a_picture_shows_what_both_maps_know(self):
        trial = SteppedTrial("one_peg", 1, "paper")
        self.assertEqual(colors(map_image(trial)) - {UNKNOWN, (255, 255, 255)}, {ORIGIN, GOAL})
        for _ in range(3):
            while not trial.step(np.array([-LARGEST_SHIFT, 0.0, 0.0])).contact:
                pass
        picture = map_image(trial)
        self.assertEqual(picture.dtype, np.uint8)
        self.assertEqual(picture.shape[2], 3)
        self.assertGreaterEqual(picture.shape[0], 240)
        shown = colors(picture)
        free = np.array(WORLD_COLORS[0])
        self.assertLess(min(np.abs(np.array(color) - free).max() for color in shown), 0.1 * 255)
        self.assertGreater(len(shown), 6)


def colors(picture):
    return {tuple(color) for color in picture.reshape(-1, 3)}


if __name__ == "__main__":
    assert shutil.which("smore_experiment"), "smore_experiment is not on PATH"
    unittest.main()
