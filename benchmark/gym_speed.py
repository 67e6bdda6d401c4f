#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Steps a second of the Gymnasium environment on one core, at random actions.

    gym_speed.py [--scenario NAME_OR_FILE (s_shape_two_pegs)] [--steps N (20000)]

Free motion are the steps that touched nothing. The time is the processor's, so that other programs do not count. The
interpreter is that of `scripts/experiments --setup`: build/learning/bin/python.
"""
import argparse
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
import gymnasium  # noqa: E402


def measure(scenario, steps):
    """Seconds spent in free steps and in those with a contact, and how many touched."""
    environment = gymnasium.make("smore_gym:smore/Retrieve-v0", scenario=scenario)
    environment.action_space.seed(1)
    environment.reset(seed=1)
    spent, touched = {False: 0.0, True: 0.0}, 0
    for _ in range(steps):
        action = environment.action_space.sample()
        begin = time.process_time()
        _, _, terminated, truncated, info = environment.step(action)
        spent[info["contact"]] += time.process_time() - begin
        touched += info["contact"]
        if terminated or truncated:
            environment.reset()
    return spent[False], spent[True], touched


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenario", default="s_shape_two_pegs")
    parser.add_argument("--steps", type=int, default=20000)
    arguments = parser.parse_args()
    free, in_contact, touched = measure(arguments.scenario, arguments.steps)
    print(f"{arguments.scenario}: {arguments.steps} steps, {100.0 * touched / arguments.steps:.1f} % with a contact")
    print(f"free motion: {(arguments.steps - touched) / free:.0f} steps a second")
    print(f"all: {arguments.steps / (free + in_contact):.0f} steps a second")


if __name__ == "__main__":
    main()
