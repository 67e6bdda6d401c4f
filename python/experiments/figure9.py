# SPDX-License-Identifier: BSD-3-Clause
"""A UR5e and one peg at voxels of 5 cm: lines of action, maps and plan at moments of a retrieval (paper, figure 9)."""
from scene_geometry import Scene

from experiments import strip
from experiments.recording import Recording, moments
from experiments.trials import evidence_of, recorded, reported_seeds, unperturbed

WHAT = "a UR5e frees an object from one peg: lines of action, maps and plan at voxels of 5 cm (its figure 9)"
SCENE = "ur5e_one_peg"
SEED = reported_seeds(1)[0]
SHOWN = 3  # moments
LINE = 0.25  # of a line of action, to each side [m]


def trials(directory, _quick):
    return [recorded(SCENE, unperturbed(SCENE, directory / "scenes"), SEED, "smore", directory)]


def report(records, directory):
    """Collisions as text, and the strip."""
    record = records[SCENE]
    planar, recording = strip.PlanarScene(Scene(record["trial"]["scenario"])), Recording(evidence_of(record))

    def draw_known(axes, index):
        strip.draw_maps(axes, planar, recording.maps_before(index, directory / "maps"), planar.scene.start)
        strip.draw_lines(axes, planar, recording.touches(index), LINE)

    figure = strip.draw(
        planar, recording, moments(recording, SHOWN), draw_known,
        [*strip.MAP_LEGEND, strip.LINE_LEGEND, *strip.SCENE_LEGEND])
    result = record["result"]
    text = "| robot | collisions | at the goal |\n|---|---|---|\n"
    text += f"| UR5e | {result['collisions']} | {'yes' if result['success'] else 'no'} |\n"
    return text, {"figure9": figure}
