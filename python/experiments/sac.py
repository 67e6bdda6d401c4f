# SPDX-License-Identifier: BSD-3-Clause
"""Soft Actor-Critic as one more method: its trials run in a Python of their own (experiments/learning.py)."""
import dataclasses

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from experiments import learning
from experiments.trials import ROOT, Trial
from file_hash import file_hash

WHAT = "Soft Actor-Critic, published hyperparameters (figure7 only; first scripts/experiments --setup)"
PROGRAM = ROOT / "python/smore_gym/train_sac.py"
MODULES = ROOT / "build/devel/lib/smore"  # with the compiled environment
MISSING = "`sac` is not here: it needs packages from PyPI, by `scripts/experiments --setup`.\n"


@dataclasses.dataclass(frozen=True)
class SacTrial(Trial):
    """One training from nothing, until the goal is first reached."""

    def command(self, output):
        return [
            str(learning.PYTHON), str(PROGRAM), "--scenario", self.scenario, "--seed", str(self.seed), *self.options,
            "--output", str(output),
        ]

    def settings(self, directory, build):
        """Of the environment, what learns in it and the packages as well."""
        modules = sorted(MODULES.glob("smore_simulator*.so"))
        learner = file_hash((*sorted(PROGRAM.parent.glob("*.py")), learning.PACKAGES, *modules))
        return {**super().settings(directory, build), "learner": learner}


def trials(scene, seeds, most_interactions):
    """None where there is no Python for them."""
    if not learning.is_set_up():
        return []
    options = ("--max-interactions", str(most_interactions))
    return [SacTrial(f"{scene}/sac/{seed}", scene, seed, "sac", options) for seed in seeds]


def table(results):
    lines = ["| sac, seed | interactions | collisions | |", "|---" * 4 + "|"]
    lines += [f"| {trial['seed']} | {trial['interactions']} | {trial['collisions']} | {trial['reason']} |"
              for trial in results]
    return "\n".join(lines) + "\n"


def draw(results):
    """Return of each episode against the interactions by its end; a star where the goal was reached."""
    figure, axes = plt.subplots(figsize=(3.5, 2.5), constrained_layout=True)
    for trial in results:
        ends, returns = [end for end, *_ in trial["episodes"]], [last for *_, last in trial["episodes"]]
        (line,) = axes.plot(ends, returns, linewidth=1.0, alpha=0.8, label=f"seed {trial['seed']}")
        if trial["success"] and ends:
            axes.plot(ends[-1], returns[-1], "*", markersize=9, color=line.get_color())
    axes.set_xlabel("interactions (star: the goal is reached)", fontsize=8)
    axes.set_ylabel("return of an episode", fontsize=8)
    axes.tick_params(labelsize=8)
    axes.grid(alpha=0.3)
    if results:
        axes.legend(fontsize=7, frameon=False)
    return figure
