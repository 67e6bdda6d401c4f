# SPDX-License-Identifier: BSD-3-Clause
"""Invalid poses, plan and scene at moments of one retrieval with the method cspace (paper, figure 6)."""
from matplotlib.lines import Line2D
from scene_geometry import Scene

from experiments import strip
from experiments.recording import Recording, moments
from experiments.trials import evidence_of, recorded, reported_seeds

WHAT = "invalid poses, plan and scene at moments of a retrieval with cspace (its figure 6)"
SCENE = "s_shape_two_pegs"
SEED = reported_seeds(1)[0]
SHOWN = 4  # moments
QUICK_LIMIT = 100  # of collisions, of which cspace needs more than a thousand
AXIS = 0.03  # length of a pose's axes [m]
X_COLOR, Y_COLOR = "#d55e00", "#009e73"


def trials(directory, quick):
    options = ("--max-collisions", str(QUICK_LIMIT)) if quick else ()
    return [recorded("cspace", SCENE, SEED, "cspace", directory, options)]


def draw_poses(axes, planar, motions):
    """The axes of the object's frame where motions touched."""
    for motion in motions:
        pose = motion.way[-1]
        for direction, color in zip(pose[:3, :2].T, (X_COLOR, Y_COLOR)):
            planar.line(axes, [pose[:3, 3], pose[:3, 3] + AXIS * direction], color=color, linewidth=0.4)


def report(records, _directory):
    """Collisions as text, and the strip."""
    result = records["cspace"]["result"]
    planar, recording = strip.PlanarScene(Scene(SCENE)), Recording(evidence_of(records["cspace"]))

    def draw_known(axes, index):
        planar.outline_object(axes, planar.scene.start)
        draw_poses(axes, planar, recording.touches(index))

    legend = [
        Line2D([], [], color=X_COLOR, lw=1, label="x axis of an invalid pose"),
        Line2D([], [], color=Y_COLOR, lw=1, label="y axis"), *strip.SCENE_LEGEND,
    ]
    text = f"| method | collisions | at the goal |\n|---|---|---|\n| cspace | {result['collisions']} | "
    text += f"{'yes' if result['success'] else 'given up'} |\n"
    figure = strip.draw(planar, recording, moments(recording, SHOWN), draw_known, legend, "poses and plan")
    return text, {"figure6": figure}
