# SPDX-License-Identifier: BSD-3-Clause
"""The task of a scenario as a Gymnasium environment: small motions of the object, felt at the wrist."""
import gymnasium
import numpy as np

from smore_gym.map_image import map_image
from smore_gym.simulator import LARGEST_SHIFT, LARGEST_TURN, SteppedTrial

# The publication says "small". As much as a step a metre away from the goal.
CONTACT_PENALTY = 1.0
SEEDS = 2**32


def paper_reward(observation, info):
    """Minus the Euclidean distance between object pose and goal pose (metres and radians alike), less a small penalty
    where something was touched."""
    return -float(np.linalg.norm(observation)) - CONTACT_PENALTY * info["contact"]


class RetrieveEnv(gymnasium.Env):
    """Any scenario with a scene, by its name in config/scenarios or as a file (docs/gym.md).

    reset(seed=S) begins the trial S of smore_experiment: its perturbation of the scene, its noise, maps that know
    nothing. reset() only sets the object back to the start.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}

    def __init__(self, scenario="s_shape_two_pegs", reward=paper_reward, maps="smore", render_mode=None):
        """reward: a function of observation and info; maps: 'smore' or 'paper', those that render() shows."""
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ValueError(f"render_mode '{render_mode}'; use rgb_array, or None for no maps and no pictures")
        self.scenario, self.reward, self.render_mode = scenario, reward, render_mode
        self._maps = maps if render_mode else None
        self._begun = False
        self._trial = self._make_trial(0)  # refuses a bad scenario here, and knows the numbers of an action
        turns = {3: 1, 6: 3}[self._trial.dimensions]
        shifts = self._trial.dimensions - turns
        diagonal = np.linalg.norm(np.subtract(*self._trial.workspace))
        self.action_space = box([LARGEST_SHIFT] * shifts + [LARGEST_TURN] * turns)
        self.observation_space = box([diagonal] * shifts + [np.pi] * turns)

    def _make_trial(self, seed):
        return SteppedTrial(self.scenario, seed, self._maps)

    def _observation(self):
        return self._trial.difference().astype(np.float32)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        if seed is None and self._begun:
            self._trial.restart()
        else:
            drawn = int(self.np_random.integers(SEEDS))
            self._trial = self._make_trial(drawn if seed is None else seed)
        self._begun = True
        return self._observation(), {"collisions": self._trial.collisions, "pose": self._trial.pose}

    def step(self, action):
        outcome = self._trial.step(np.asarray(action, dtype=float))
        info = {
            "contact": outcome.contact, "collisions": self._trial.collisions, "is_success": outcome.at_goal,
            "pose": outcome.pose, "wrench": outcome.wrench, "reason": outcome.reason,
        }
        observation = self._observation()
        return observation, self.reward(observation, info), outcome.at_goal, False, info

    def render(self):
        if self.render_mode is None:
            raise ValueError("no maps are kept; make the environment with render_mode='rgb_array'")
        return map_image(self._trial)


def box(magnitudes):
    magnitudes = np.array(magnitudes, dtype=np.float32)
    return gymnasium.spaces.Box(-magnitudes, magnitudes)
