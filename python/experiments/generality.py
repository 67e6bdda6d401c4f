# SPDX-License-Identifier: BSD-3-Clause
"""Random planar scenes that nobody has chosen, as shares of them solved within so many collisions."""
import json
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from experiments.trials import ROOT, Trial, reported_seeds

WHAT = "100 random planar scenes of four kinds of objects and of obstacles, half of them of 0.2 to 3 times the size"
FIRST_SEED = 2001  # on 1001 to 1100 a fault of the belief was found and mended
COUNT, QUICK_COUNT = 100, 10
MOST_COLLISIONS = 40
LIMITS = (0, 1, 2, 3, 5, 10, 20, MOST_COLLISIONS)
COLORS = {"all": "#222222", "common size": "#1a9641", "other sizes": "#8e24aa"}


def trials(directory, quick):
    scenes = directory / "scenes"
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT, FIRST_SEED)
    command = [ROOT / "scripts/random_scenes", "--seed", str(FIRST_SEED), "--count", str(len(seeds))]
    print("drawing the scenes", file=sys.stderr)
    subprocess.run([*command, "--output", str(scenes)], check=True, stdout=subprocess.DEVNULL)
    options = ("--max-collisions", str(MOST_COLLISIONS))
    return [Trial(f"planar_{seed}", str(scenes / f"planar_{seed}.yaml"), seed, options=options) for seed in seeds]


def kinds_of(scene):
    """Object, obstacles and size."""
    return scene["object"], scene["obstacles"], "common size" if scene["scale"] == 1 else "other sizes"


def share_within(group, limit):
    return np.mean([result["success"] and result["collisions"] <= limit for result in group])


def row(name, group):
    reached = [result["collisions"] for result in group if result["success"]]
    shares = " | ".join(f"{share_within(group, limit):.2f}" for limit in LIMITS)
    mean = f"{np.mean(reached):.1f}" if reached else "-"
    return f"| {name} | {len(group)} | {shares} | {mean} |"


def table(groups, scenes):
    lines = ["| scenes | | " + " | ".join(f"<= {limit}" for limit in LIMITS) + " | mean of those at the goal |"]
    lines.append("|---" * (len(LIMITS) + 3) + "|")
    lines += [row(name, group) for name, group in groups.items()]
    rejected = {}
    for scene in scenes:
        for reason, count in scene["rejected"].items():
            rejected[reason] = rejected.get(reason, 0) + count
    told = ", ".join(f"{count}: {reason}" for reason, count in sorted(rejected.items()))
    return "\n".join(lines) + f"\n\nDrafts of scenes that were rejected: {told or 'none'}.\n"


def figure(groups):
    drawn, axes = plt.subplots(figsize=(4.8, 3.4), constrained_layout=True)
    for name, color in COLORS.items():
        group = groups.get(name)
        if group:
            limits = np.arange(MOST_COLLISIONS + 1)
            shares = [share_within(group, limit) for limit in limits]
            axes.step(limits, shares, where="post", color=color, label=f"{name} ({len(group)} scenes)")
    axes.set(xlabel="collisions", ylabel="share of scenes at the goal", xlim=(0, MOST_COLLISIONS), ylim=(0, 1.02))
    axes.grid(alpha=0.3)
    axes.legend(loc="lower right", frameon=False)
    return drawn


def report(records, directory):
    """The tables as text, and the figures by their names."""
    drawn = json.loads((directory / "scenes/scenes.json").read_text())
    groups = {"all": [record["result"] for record in records.values()]}
    for name, record in records.items():
        for kind in reversed(kinds_of(drawn[name])):
            groups.setdefault(kind, []).append(record["result"])
    return table(groups, [drawn[name] for name in records]), {"generality": figure(groups)}
