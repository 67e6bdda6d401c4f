# SPDX-License-Identifier: BSD-3-Clause
"""A Gymnasium environment over the simulator of smore_experiment (docs/gym.md)."""
import gymnasium

from smore_gym.environment import RetrieveEnv, paper_reward

__all__ = ["RetrieveEnv", "paper_reward"]

# The publication gives no length of an episode. This is six times the way out of its scene.
gymnasium.register("smore/Retrieve-v0", entry_point=RetrieveEnv, max_episode_steps=200)
