# SPDX-License-Identifier: BSD-3-Clause
"""Random scenes that nobody has chosen, in the plane and in space, as shares of them solved within so many
collisions."""
import dataclasses
import json
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from experiments.trials import ROOT, Trial, reported_seeds

WHAT = "100 random planar and 40 random spatial scenes of four kinds of objects and of obstacles, and 20 random slits"
MOST_COLLISIONS = 40
LIMITS = (0, 1, 2, 3, 5, 10, 20, MOST_COLLISIONS)
COLORS = {"all": "#222222", "common size": "#1a9641", "other sizes": "#8e24aa"}


@dataclasses.dataclass(frozen=True)
class Scenes:
    """Random scenes of one kind."""

    where: str
    options: tuple  # of scripts/random_scenes
    first_seed: int
    count: int
    quick_count: int


# By what their names begin with.
KINDS = {
    # On planar scenes of seeds 1001 to 1100 a fault of the belief was found and mended.
    "planar": Scenes("the plane", ("--motion", "planar"), 2001, 100, 10),
    "spatial": Scenes("space", ("--motion", "spatial"), 1001, 40, 4),
    "spatial_slit": Scenes("space, all with a slit", ("--motion", "spatial", "--obstacles", "slit"), 3001, 20, 2),
}


def kind_of(name):
    return name.rpartition("_")[0]


def trials_of(kind, directory, quick):
    some = KINDS[kind]
    seeds = reported_seeds(some.quick_count if quick else some.count, some.first_seed)
    print(f"drawing {len(seeds)} scenes in {some.where}", file=sys.stderr)
    command = [
        ROOT / "scripts/random_scenes", *some.options, "--seed", str(seeds[0]), "--count", str(len(seeds)),
        "--output", str(directory),
    ]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    options = ("--max-collisions", str(MOST_COLLISIONS))
    names = [(f"{kind}_{seed}", seed) for seed in seeds]
    return [Trial(name, str(directory / f"{name}.yaml"), seed, options=options) for name, seed in names]


def trials(directory, quick):
    return [trial for kind in KINDS for trial in trials_of(kind, directory / "scenes", quick)]


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
    """A curve for each size."""
    drawn, axes = plt.subplots(figsize=(4.8, 3.4), constrained_layout=True)
    limits = np.arange(MOST_COLLISIONS + 1)
    for name, color in COLORS.items():
        group = groups.get(name)
        if group:
            shares = [share_within(group, limit) for limit in limits]
            style = "--" if name == "other sizes" else "-"
            axes.step(limits, shares, style, where="post", color=color, label=f"{name} ({len(group)} scenes)")
    axes.set(xlabel="collisions", ylabel="share of scenes at the goal", xlim=(0, MOST_COLLISIONS), ylim=(0, 1.02))
    axes.grid(alpha=0.3)
    axes.legend(loc="lower right", frameon=False)
    return drawn


def groups_of(records, drawn):
    """Results of all scenes, and of each kind of them."""
    groups = {"all": [record["result"] for record in records.values()]}
    for name, record in records.items():
        for kind in reversed(kinds_of(drawn[name])):
            groups.setdefault(kind, []).append(record["result"])
    return groups


def report(records, directory):
    """The tables as text, and the figures by their names."""
    drawn = json.loads((directory / "scenes/scenes.json").read_text())
    tables, figures = [], {}
    for kind, scenes in KINDS.items():
        some = {name: record for name, record in records.items() if kind_of(name) == kind}
        if some:
            groups = groups_of(some, drawn)
            told = table(groups, [drawn[name] for name in some])
            tables.append(told.replace("| scenes |", f"| scenes in {scenes.where} |", 1))
            figures[f"generality_{kind}"] = figure(groups)
    return "\n".join(tables), figures
