# SPDX-License-Identifier: BSD-3-Clause
"""Maps, plan and scene at moments of one retrieval, with the methods paper and smore (paper, figure 5)."""
from scene_geometry import Scene

from experiments import animation, strip
from experiments.recording import Recording, moments
from experiments.trials import evidence_of, recorded, reported_seeds

WHAT = "maps, plan and scene at moments of a retrieval with paper and smore (its figure 5), and an animation"
SCENE = "s_shape_two_pegs"
SEED = reported_seeds(1)[0]
METHODS = ("paper", "smore")
SHOWN = 4  # moments
QUICK_LIMIT = 30  # of collisions, of which paper needs hundreds


def trials(directory, quick):
    options = ("--max-collisions", str(QUICK_LIMIT)) if quick else ()
    return [recorded(method, SCENE, SEED, method, directory, options) for method in METHODS]


def report(records, directory):
    """Collisions as text, a strip for each method, and the animation of smore."""
    planar = strip.PlanarScene(Scene(SCENE))
    lines, figures = ["| method | collisions | at the goal |", "|---|---|---|"], {}
    for method in METHODS:
        result = records[method]["result"]
        lines.append(f"| {method} | {result['collisions']} | {'yes' if result['success'] else 'given up'} |")
        recording = Recording(evidence_of(records[method]))
        maps = directory / "maps" / method

        def draw_known(axes, index, recording=recording, maps=maps):
            strip.draw_maps(axes, planar, recording.maps_before(index, maps), planar.scene.start)

        legend = strip.MAP_LEGEND + strip.SCENE_LEGEND
        figures[f"figure5_{method}"] = strip.draw(planar, recording, moments(recording, SHOWN), draw_known, legend)
        if method == "smore":
            figures["figure5"] = animation.of(planar, recording, maps)
    return "\n".join(lines) + "\n", figures
