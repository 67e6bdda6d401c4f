# SPDX-License-Identifier: BSD-3-Clause
"""A retrieval in a plane as an animation: what is known beside the true scene, motion after motion."""
import matplotlib.pyplot as plt
from matplotlib.animation import FuncAnimation

from experiments import strip

FRAMES_OF_A_MOTION = 6
FRAMES_AT_ITS_END = 3
PICTURES_A_SECOND = 5
SIZE = (6.4, 2.8)  # [inch]


def frames(recording):
    """Of each picture the motion and how many poses of its way are behind."""
    shown = []
    for index, motion in enumerate(recording.motions):
        count = len(motion.way)
        shown += [(index, 1 + count * step // FRAMES_OF_A_MOTION) for step in range(FRAMES_OF_A_MOTION)]
        shown += [(index, count)] * FRAMES_AT_ITS_END
    return shown


def of(planar, recording, maps_directory):
    """The animation; its maps are made in `maps_directory`."""
    limits = strip.limits_of(planar, recording.motions)
    figure, panels = plt.subplots(1, 2, figsize=SIZE, dpi=100, constrained_layout=True)

    def draw(frame):
        index, behind = frame
        motion = recording.motions[index]
        for axes in panels:
            axes.clear()
        strip.draw_maps(panels[0], planar, recording.maps_before(index, maps_directory), planar.scene.start)
        strip.draw_plan(panels[0], planar, motion)
        strip.draw_truth(panels[1], planar, motion, motion.way[:behind])
        for axes, title in zip(panels, ("known by touch, and the plan", "true scene")):
            strip.set_up(axes, limits, axes is panels[0], True, "")
            axes.set_title(title, fontsize=9)
        figure.suptitle(strip.contacts_in_words(recording.contacts_before(index)), fontsize=10)

    return FuncAnimation(figure, draw, frames=frames(recording), interval=1000 / PICTURES_A_SECOND)
