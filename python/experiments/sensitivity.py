# SPDX-License-Identifier: BSD-3-Clause
"""What voxel size, contact threshold, friction and the sensor's errors do to collisions and maps (named and not
investigated in the paper)."""
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from experiments.trials import Trial, reported_seeds, scene_with

WHAT = "voxel size, contact threshold, friction, errors of lines and noise of the sensor against collisions and maps"
SCENE = "s_shape_perturbed"
COUNT, QUICK_COUNT = 10, 1
MOST_COLLISIONS = 60
# Key of a scenario, the form of its value, the values, and the axis' label.
SWEEPS = (
    ("voxel_size", "{}", (0.01, 0.02, 0.03, 0.05, 0.08), "voxel size [m]"),
    ("contact_force", "{}", (2, 5, 10, 20), "force at which it is a contact [N]"),
    ("friction", "{}", (0, 0.3, 0.6, 0.9), "friction coefficient"),
    ("line_noise", "{{direction: {}}}", (0, 0.05, 0.1, 0.2), "error of a line's direction [rad]"),
    ("wrench_noise", "{{force_stddev: {}}}", (0, 0.5, 1.75, 3.5), "noise of a force sample [N]"),
)
COLOR = "#1a9641"


def trials(directory, quick):
    scenes = directory / "scenes"
    scenes.mkdir(parents=True, exist_ok=True)
    options = ("--max-collisions", str(MOST_COLLISIONS))
    asked = []
    for key, form, values, _ in SWEEPS:
        for value in values:
            scene = scenes / f"{key}_{value}.yaml"
            scene.write_text(scene_with(SCENE, {key: form.format(value)}))
            for seed in reported_seeds(QUICK_COUNT if quick else COUNT):
                asked.append(Trial(f"{key}={value}/{seed}", str(scene), seed, options=options))
    return asked


def mean_or_none(values):
    known = [value for value in values if value is not None]
    return statistics.mean(known) if known else None


def told(value):
    return "-" if value is None else f"{value:.2f}"


def measured(records, key, value):
    """Collisions, how many reached the goal, and precision of the object's and the world's map."""
    results = [record["result"] for name, record in records.items() if name.startswith(f"{key}={value}/")]
    maps = [mean_or_none([result[side]["precision"] for result in results]) for side in ("object_map", "world_map")]
    return [result["collisions"] for result in results], sum(result["success"] for result in results), maps


def report(records, _directory):
    """The table as text, and the figure by its name."""
    lines = ["| key | value | mean | most | at the goal | object: precision | world: precision |", "|---" * 7 + "|"]
    size = (3.0 * len(SWEEPS), 3.2)
    figure, panels = plt.subplots(1, len(SWEEPS), figsize=size, sharey=True, constrained_layout=True)
    for axes, (key, _, values, label) in zip(panels, SWEEPS):
        for place, value in enumerate(values):
            counts, reached, maps = measured(records, key, value)
            lines.append(
                f"| {key} | {value} | {statistics.mean(counts):.1f} | {max(counts)} | {reached} of {len(counts)} | "
                f"{told(maps[0])} | {told(maps[1])} |"
            )
            axes.scatter([place] * len(counts), counts, s=12, color=COLOR, alpha=0.5)
            axes.scatter([place], [statistics.mean(counts)], s=60, marker="_", color=COLOR)
        axes.set_xticks(range(len(values)))
        axes.set_xticklabels(values)
        axes.set(xlabel=label, ylim=(0, None))
        axes.grid(axis="y", alpha=0.3)
    panels[0].set_ylabel("collisions until the goal")
    return "\n".join(lines) + "\n", {"sensitivity": figure}
