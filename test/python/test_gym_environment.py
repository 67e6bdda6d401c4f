#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Gymnasium environment passes Gymnasium's checker, and Soft Actor-Critic learns on it until the goal is reached.

    test_gym_environment.py       with the interpreter of scripts/experiments --setup
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
import gymnasium  # noqa: E402
import numpy as np  # noqa: E402
from gymnasium.utils.env_checker import check_env  # noqa: E402

import smore_gym  # noqa: E402

TRAIN = ROOT / "python/smore_gym/train_sac.py"
OPEN_SCENE = """
name: open
task: retrieve
voxel_size: 0.03
motion: planar
robot: cartesian
object: {shapes: [{type: box, size: [0.1, 0.1, 0.1], position: [0, 0, 0]}]}
environment: {shapes: [{type: box, size: [0.1, 0.1, 0.1], position: [0.5, 0, 0]}]}
start: {position: [0, 0, 0]}
goal: {position: [-0.2, 0.1, 0], rpy: [0, 0, 0.5]}
workspace: {min: [-0.5, -0.5, -0.01], max: [0.5, 0.5, 0.01]}
"""


def make(**options):
    return gymnasium.make("smore/Retrieve-v0", **options)


def walk(environment, seed, steps):
    observation, _ = environment.reset(seed=seed)
    random = np.random.default_rng(seed)
    seen = [observation.tolist()]
    for _ in range(steps):
        action = random.uniform(environment.action_space.low, environment.action_space.high)
        observation, reward, *_, info = environment.step(action.astype(np.float32))
        seen.append((observation.tolist(), reward, info["wrench"].tolist()))
    return seen


class GymEnvironmentTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def open_scene(self, more=""):
        file = self.folder / "open.yaml"
        file.write_text(OPEN_SCENE + more)
        return str(file)

    def test_passes_gymnasiums_checker_in_the_plane_and_in_space(self):
        for options in ({"scenario": "one_peg", "render_mode": "rgb_array"}, {"scenario": "slit"}):
            with self.subTest(**options), warnings.catch_warnings():
                warnings.simplefilter("error")
                # Its advice on rescaled actions is for those who write an algorithm: ours have units.
                warnings.filterwarnings("ignore", message=".*action space.*")
                check_env(make(**options).unwrapped)

    def test_the_same_seed_gives_the_same_trajectory(self):
        first = walk(make(scenario="s_shape_perturbed"), 3, 30)
        self.assertEqual(first, walk(make(scenario="s_shape_perturbed"), 3, 30))
        self.assertNotEqual(first, walk(make(scenario="s_shape_perturbed"), 4, 30))

    def test_a_reset_without_a_seed_goes_on_in_the_same_scene(self):
        environment = make(scenario="one_peg")
        environment.reset(seed=1)
        while not environment.step(np.array([-0.03, 0, 0], dtype=np.float32))[4]["contact"]:
            pass
        self.assertEqual(environment.reset()[1]["collisions"], 1)
        self.assertEqual(environment.reset(seed=1)[1]["collisions"], 0)

    def test_what_touches_is_back_at_the_start_and_the_episode_goes_on(self):
        environment = make(scenario="one_peg")
        start, _ = environment.reset(seed=1)
        contact = False
        while not contact:
            observation, reward, terminated, truncated, info = environment.step(np.array([-0.03, 0, 0]))
            contact = info["contact"]
            self.assertAlmostEqual(reward, -np.linalg.norm(observation) - smore_gym.environment.CONTACT_PENALTY * contact, 5)
            self.assertFalse(terminated or truncated)
        np.testing.assert_array_equal(observation, start)
        self.assertGreater(np.linalg.norm(info["wrench"][:3]), 3.0)

    def test_the_goal_ends_the_episode(self):
        environment = make(scenario=self.open_scene())
        observation, _ = environment.reset(seed=1)
        terminated, steps = False, 0
        while not terminated:
            observation, _, terminated, truncated, info = environment.step(
                np.clip(observation, environment.action_space.low, environment.action_space.high))
            self.assertEqual(terminated, info["is_success"])
            self.assertFalse(truncated)
            steps += 1
        self.assertEqual(steps, 7)  # 0.2 m by steps of 0.03 m, to a tolerance of 0.02 m

    def test_an_episode_is_cut_after_200_steps(self):
        environment = make(scenario=self.open_scene())
        environment.reset(seed=1)
        cut = [environment.step(np.zeros(3, dtype=np.float32))[3] for _ in range(200)]
        self.assertEqual((cut[-1], any(cut[:-1])), (True, False))

    def test_rewards_of_ones_own_are_used(self):
        environment = make(scenario=self.open_scene(), reward=lambda observation, info: 7.0 + info["is_success"])
        environment.reset(seed=1)
        self.assertEqual(environment.step(np.zeros(3, dtype=np.float32))[1], 7.0)

    def test_pictures_have_one_size_and_need_the_maps(self):
        environment = make(scenario="one_peg", render_mode="rgb_array", maps="paper")
        environment.reset(seed=1)
        first = environment.render()
        for _ in range(5):  # a voxel, at least
            environment.step(np.array([-0.03, 0, 0], dtype=np.float32))
        self.assertEqual(environment.render().shape, first.shape)
        self.assertTrue((environment.render() != first).any())
        with self.assertRaisesRegex(ValueError, "rgb_array"):
            smore_gym.RetrieveEnv(render_mode="human")
        with self.assertRaisesRegex(ValueError, "no maps are kept"):
            smore_gym.RetrieveEnv(scenario="one_peg").render()

    def train(self, scenario, interactions):
        output = self.folder / "sac.json"
        command = [sys.executable, TRAIN, "--scenario", scenario, "--seed", "1", "--max-interactions", str(interactions)]
        subprocess.run([*command, "--output", output], check=True)
        (trial,) = json.loads(output.read_text())["trials"]
        return trial

    def test_soft_actor_critic_learns_as_long_as_it_may(self):
        trial = self.train("one_peg", 250)
        self.assertEqual((trial["success"], trial["interactions"]), (False, 250))
        self.assertEqual([episode[0] for episode in trial["episodes"]], [200])
        self.assertGreater(trial["collisions"], 0)

    def test_soft_actor_critic_ends_at_the_goal(self):
        trial = self.train(self.open_scene("goal_tolerance: {position: 0.2, angle: 3.0}\n"), 1000)
        self.assertTrue(trial["success"], trial["reason"])
        self.assertLess(trial["interactions"], 1000)
        self.assertEqual(trial["episodes"][-1][0], trial["interactions"])


if __name__ == "__main__":
    unittest.main()
