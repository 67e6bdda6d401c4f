#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Trains Soft Actor-Critic on a scenario until the goal is first reached, and writes the trial as JSON.

    train_sac.py --scenario NAME_OR_FILE --seed S [--max-interactions N (20000)] --output FILE.json

An interaction is an action that was carried out. `episodes` has interactions and collisions so far, and the return,
at the end of each episode. The interpreter is that of `scripts/experiments --setup`.
"""
import argparse
import json
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import gymnasium  # noqa: E402
import torch  # noqa: E402
from stable_baselines3 import SAC  # noqa: E402
from stable_baselines3.common.callbacks import BaseCallback  # noqa: E402
from stable_baselines3.common.monitor import Monitor  # noqa: E402

# T. Haarnoja et al., Soft Actor-Critic Algorithms and Applications, 2018 (arXiv 1812.05905), table 1; the target of the
# entropy is minus the number of an action's dimensions, as there.
PUBLISHED = {
    "learning_rate": 3e-4, "gamma": 0.99, "buffer_size": 1_000_000, "batch_size": 256, "tau": 0.005,
    "target_update_interval": 1, "gradient_steps": 1, "train_freq": 1, "ent_coef": "auto", "target_entropy": "auto",
    "policy_kwargs": {"net_arch": [256, 256], "activation_fn": torch.nn.ReLU},
}
RANDOM_ACTIONS = 100  # at first; Stable-Baselines3's choice, since that table gives none


class UntilGoal(BaseCallback):
    """Notes the end of each episode, and ends the training at the goal."""

    def __init__(self):
        super().__init__()
        self.episodes, self.reached, self.collisions = [], False, 0

    def _on_step(self):
        info = self.locals["infos"][0]
        self.collisions = info["collisions"]
        self.reached = info["is_success"]
        if "episode" in info:
            self.episodes.append([self.num_timesteps, self.collisions, info["episode"]["r"]])
        return not self.reached


def train(scenario, seed, most_interactions):
    torch.set_num_threads(1)
    environment = Monitor(gymnasium.make("smore_gym:smore/Retrieve-v0", scenario=scenario))
    progress = UntilGoal()
    model = SAC("MlpPolicy", environment, learning_starts=RANDOM_ACTIONS, seed=seed, device="cpu", **PUBLISHED)
    begin = time.monotonic()
    model.learn(most_interactions, callback=progress)
    reason = "the object is at the goal" if progress.reached else f"reached the limit of {most_interactions} interactions"
    return {
        "seed": seed, "success": progress.reached, "reason": reason, "collisions": progress.collisions,
        "interactions": progress.num_timesteps, "episodes": progress.episodes, "wall_s": time.monotonic() - begin,
    }


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenario", required=True)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--max-interactions", type=int, default=20000)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    try:
        trial = train(arguments.scenario, arguments.seed, arguments.max_interactions)
    except ValueError as problem:
        sys.exit(f"train_sac: {problem}")
    arguments.output.write_text(json.dumps({"method": "sac", "trials": [trial]}) + "\n")


if __name__ == "__main__":
    main()
