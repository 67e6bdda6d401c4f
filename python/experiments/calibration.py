# SPDX-License-Identifier: BSD-3-Clause
"""Whether as many motions touch as their plans said, and as many voxels are occupied as both maps say, in the plane and
in space."""
import json
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import plot_reliability
from table_of_scores import number

from experiments import trials as running
from experiments.trials import Trial, evidence_of, recorded, reported_seeds

WHAT = "reliability of the risk that plans state and of both maps' voxels, in the plane and in space"
SCENES = {
    "plane": ("s_shape_perturbed", "hook_on_peg", "c_on_peg", "t_in_slot", "comb", "spiral"),
    "space": ("slit", "window", "hook_on_rail"),
}
COUNT, QUICK_COUNT = 10, 1
RECORDED_COUNT = 3  # of these trials the maps are scored
MOST_COLLISIONS = 60
COLORS = {"world": "#b2182b", "object": "#3b6fb6"}
ENOUGH = 200  # voxels of a bin that says something


def trials(directory, quick):
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT)
    options = ("--max-collisions", str(MOST_COLLISIONS))
    asked = []
    for where, scenes in SCENES.items():
        for scene in scenes:
            for seed in seeds:
                name = f"{where}/{scene}_{seed}"
                if seed < seeds[0] + RECORDED_COUNT:
                    asked.append(recorded(name, scene, seed, "smore", directory, options))
                else:
                    asked.append(Trial(name, scene, seed, options=options))
    return asked


def scores(files, output):
    """Of smore_score, all files together; subprocess.CalledProcessError where that fails."""
    program = running.PROGRAM.parent / "smore_score"
    subprocess.run([str(program), "--quick", "--output", str(output), *map(str, files)], check=True)
    return json.loads(output.read_text())["groups"][-1]


def draw_voxels(by_place):
    """Of each bin the share that is occupied over what the map states; hollow where its voxels are few."""
    figure, panels = plt.subplots(1, len(by_place), figsize=(7.2, 3.6), sharey=True, constrained_layout=True)
    for axes, (where, score) in zip(panels, by_place.items()):
        axes.plot([0, 1], [0, 1], color="#7a7a7a", linestyle="--", linewidth=1.0)
        for side, color in COLORS.items():
            bins = score[f"{side}_voxels"]["bins"]
            stated, found = ([each[key] for each in bins] for key in ("stated", "true"))
            axes.plot(stated, found, color=color, linewidth=1.2, label=f"of the {side}")
            faces = [color if each["count"] >= ENOUGH else "white" for each in bins]
            axes.scatter(stated, found, color=faces, edgecolor=color, s=24, zorder=3)
        axes.set(xlabel="probability that the map states", xlim=(0, 1), ylim=(-0.02, 1.02))
        axes.set_title(f"voxels in the {where}" if where == "plane" else f"voxels in {where}", fontsize=10)
        axes.grid(alpha=0.3)
    panels[0].set_ylabel("share that is occupied")
    panels[0].legend(frameon=False, fontsize=8)
    return figure


def table_of_voxels(by_place):
    head = f"| | map | voxels | calibration error | largest in bins of {ENOUGH} and more |"
    lines = [head, "|---|---|---|---|---|"]
    for where, score in by_place.items():
        for side in COLORS:
            voxels = score[f"{side}_voxels"]
            lines.append(
                f"| {where} | {side} | {voxels['voxels']} | {voxels['calibration_error']:.3f} | "
                f"{number(voxels['largest_error'], 2)} |")
    return "\n".join(lines) + "\n"


def report(records, directory):
    """The tables as text; figures of the risk in the plane and in space, and of the voxels."""
    lines = ["| | motions | touched | log-loss | of a constant | calibration error |", "|---|---|---|---|---|---|"]
    figures, by_place = {}, {}
    for where in SCENES:
        of_place = [record for name, record in records.items() if name.startswith(where + "/")]
        motions = [motion for record in of_place for motion in record["result"]["motions"]]
        risk = np.array([motion["risk"] for motion in motions])
        touched = np.array([motion["touched"] for motion in motions], dtype=float)
        figures["calibration_" + where], error = plot_reliability.draw(risk, touched)
        loss, base = plot_reliability.log_losses(risk, touched)
        lines.append(f"| {where} | {len(motions)} | {touched.mean():.2f} | {loss:.3f} | {base:.3f} | {error:.3f} |")
        files = [file for file in map(evidence_of, of_place) if file]
        by_place[where] = scores(files, directory / f"scores_{where}.json")
    figures["calibration_voxels"] = draw_voxels(by_place)
    return "\n".join(lines) + "\n\n" + table_of_voxels(by_place), figures
