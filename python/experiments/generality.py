# SPDX-License-Identifier: BSD-3-Clause
"""Random planar scenes that nobody has chosen, as shares of them solved within so many collisions."""
import json
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from experiments.trials import ROOT, Trial

WHAT = "100 random planar scenes of four kinds of objects and of obstacles, half of them of 0.2 to 3 times the size"
FIRST_SEED = 2001
COUNT, QUICK_COUNT = 100, 10
MOST_COLLISIONS = 40
LIMITS = (0, 1, 2, 3, 5, 10, 20, MOST_COLLISIONS)
COLORS = {"all": "#222222", "common size": "#1a9641", "other sizes": "#8e24aa"}


def trials(directory, quick):
    scenes = directory / "scenes"
    command = [ROOT / "scripts/random_scenes", "--seed", str(FIRST_SEED), "--output", str(scenes)]
    print("drawing the scenes", file=sys.stderr)
    subprocess.run([*command, "--count", str(QUICK_COUNT if quick else COUNT)], check=True, stdout=subprocess.DEVNULL)
    seeds = range(FIRST_SEED, FIRST_SEED + (QUICK_COUNT if quick else COUNT))
    options = ("--max-collisions", str(MOST_COLLISIONS))
    return [Trial(f"planar_{seed}", str(scenes / f"planar_{seed}.yaml"), seed, options=options) for seed in seeds]


def kinds_of(record):
    """Object, obstacles and size, as the scene's first line tells them."""
    with open(record["trial"]["scenario"], encoding="utf-8") as file:
        made, placed, size = file.readline().strip("# .\n").lower().split(", ")
    return made, placed, "common size" if size.startswith("1 times") else "other sizes"


def share_within(group, limit):
    return np.mean([result["success"] and result["collisions"] <= limit for result in group])


def row(name, group):
    reached = [result["collisions"] for result in group if result["success"]]
    shares = " | ".join(f"{share_within(group, limit):.2f}" for limit in LIMITS)
    mean = f"{np.mean(reached):.1f}" if reached else "-"
    return f"| {name} | {len(group)} | {shares} | {mean} |"


def table(groups, drafts):
    lines = ["| scenes | | " + " | ".join(f"<= {limit}" for limit in LIMITS) + " | mean of those at the goal |"]
    lines.append("|---" * (len(LIMITS) + 3) + "|")
    lines += [row(name, group) for name, group in groups.items()]
    rejected = {}
    for reasons in drafts.values():
        for reason, count in reasons.items():
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
    groups = {"all": [record["result"] for record in records.values()]}
    for record in records.values():
        made, placed, size = kinds_of(record)
        for kind in (size, made, placed):
            groups.setdefault(kind, []).append(record["result"])
    drafts = json.loads((directory / "scenes/drafts.json").read_text())
    return table(groups, {name: drafts[name] for name in records}), {"generality": figure(groups)}
