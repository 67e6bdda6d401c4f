# SPDX-License-Identifier: BSD-3-Clause
"""The law for contact in two dimensions: six lines through one voxel (paper, figure 3)."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from experiments import lines_through_a_voxel as lines

WHAT = "the law for contact in the plane: six lines through one voxel, both maps after each (its figure 3)"


def trials(_directory, _quick):
    """None: the maps are made of six contacts that are written down."""
    return []


def draw(maps):
    figure, axes = plt.subplots(2, len(maps), figsize=(7.2, 2.7), constrained_layout=True)
    for column, both in enumerate(maps):
        for line, (values, middle, side) in enumerate(zip(both, lines.middles(), ("world", "object"))):
            here = axes[line][column]
            picture = lines.draw(here, values, middle)
            if column == 0:
                here.set_ylabel(f"{side}: y [cm]", fontsize=8)
            else:
                here.set_yticklabels([])
        axes[0][column].set_title(f"{column + 1} line{'s' if column else ''}", fontsize=8)
        axes[1][column].set_xlabel("x [cm]", fontsize=8)
    lines.add_color_bar(figure, axes, picture)
    return figure


def report(_records, directory):
    """The probability of the voxel that all lines pass through after each of them, and the figure."""
    contacts = [lines.observation(number) for number in range(lines.CONTACTS)]
    maps = [lines.maps_of(contacts[: count + 1], f"{count + 1}_lines", directory) for count in range(len(contacts))]
    lines_of_text = ["| lines | touched voxel of the world | most likely voxel of the object |", "|---|---|---|"]
    for count, (world, held) in enumerate(maps):
        touched = world[lines.SHOWN, lines.SHOWN]
        lines_of_text.append(f"| {count + 1} | {touched:.3f} | {np.nanmax(held):.3f} |")
    return "\n".join(lines_of_text) + "\n", {"figure3": draw(maps)}
