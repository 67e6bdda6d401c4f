# SPDX-License-Identifier: BSD-3-Clause
"""Whether as many motions touch as their plans said, in the plane and in space."""
import numpy as np
import plot_reliability

from experiments.trials import Trial, reported_seeds

WHAT = "reliability of the risk that plans state, in the plane and in space"
SCENES = {
    "plane": ("s_shape_perturbed", "hook_on_peg", "c_on_peg", "t_in_slot", "comb", "spiral"),
    "space": ("slit", "window", "hook_on_rail"),
}
COUNT, QUICK_COUNT = 10, 1
MOST_COLLISIONS = 60


def trials(_directory, quick):
    seeds = reported_seeds(QUICK_COUNT if quick else COUNT)
    options = ("--max-collisions", str(MOST_COLLISIONS))
    return [
        Trial(f"{where}/{scene}_{seed}", scene, seed, options=options)
        for where, scenes in SCENES.items() for scene in scenes for seed in seeds
    ]


def report(records, _directory):
    """The table as text, and a figure for the plane and for space."""
    lines = ["| | motions | touched | log-loss | of a constant | calibration error |", "|---|---|---|---|---|---|"]
    figures = {}
    for where in SCENES:
        results = [record["result"] for name, record in records.items() if name.startswith(where + "/")]
        motions = [motion for result in results for motion in result["motions"]]
        risk = np.array([motion["risk"] for motion in motions])
        touched = np.array([motion["touched"] for motion in motions], dtype=float)
        figures["calibration_" + where], error = plot_reliability.draw(risk, touched)
        loss, base = plot_reliability.log_losses(risk, touched)
        lines.append(f"| {where} | {len(motions)} | {touched.mean():.2f} | {loss:.3f} | {base:.3f} | {error:.3f} |")
    return "\n".join(lines) + "\n", figures
