# SPDX-License-Identifier: BSD-3-Clause
"""The law for free space in two dimensions (paper, figure 4)."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from experiments import lines_through_a_voxel as lines

WHAT = "the law for free space in the plane: both maps before and after one free pose (its figure 4)"
CONTACTS = 9  # of the lines of figure 3 and three more, until the touched voxel is about as likely as the paper's
PAPER_BEFORE, PAPER_AFTER = (0.79, 0.21), (0.75, 0.05)


def trials(_directory, _quick):
    """None: the maps are made of contacts and one free pose that are written down."""
    return []


def free_law(world, held):
    """Both probabilities of two coincident voxels where nothing touches (paper, equation 11)."""
    neither = 1.0 - world * held
    return world * (1.0 - held) / neither, held * (1.0 - world) / neither


def doubtful_voxel(held):
    """Index of the object's voxel that is about as likely as that of the paper's example."""
    return np.unravel_index(np.nanargmin(np.abs(held - PAPER_BEFORE[1])), held.shape)


def place_of(index, middle):
    """x and y of a voxel of a picture [m]."""
    line, column = index
    return tuple(of + (at - lines.SHOWN) * lines.VOXEL for of, at in zip(middle, (column, line)))


def free_pose(index):
    """Where the object stands when this voxel of it lies on the voxel of the world that the lines pass through."""
    return tuple(np.array(lines.TOUCHED) - place_of(index, lines.middles()[1]))


def circle(axes, index, middle, value):
    place = [100.0 * coordinate for coordinate in place_of(index, middle)]
    axes.plot(*place, "o", markersize=9, markerfacecolor="none", markeredgecolor="#0b8a3a", markeredgewidth=1.4)
    axes.annotate(
        f"{value:.2f}", place, xytext=(7, 7), textcoords="offset points", fontsize=8, color="#0b6b2e",
        bbox={"facecolor": "white", "alpha": 0.85, "edgecolor": "none", "pad": 0.8},
    )


def draw(before, after, indices):
    figure, axes = plt.subplots(2, 2, figsize=(3.6, 3.0), constrained_layout=True)
    for column, (both, when) in enumerate(((before, "before"), (after, "after"))):
        for line, (values, middle, side) in enumerate(zip(both, lines.middles(), ("world", "object"))):
            here = axes[line][column]
            picture = lines.draw(here, values, middle)
            circle(here, indices[line], middle, values[indices[line]])
            here.set_ylabel(f"{side}: y [cm]" if column == 0 else "", fontsize=8)
        axes[0][column].set_title(when, fontsize=9)
        axes[1][column].set_xlabel("x [cm]", fontsize=8)
    lines.add_color_bar(figure, axes, picture)
    return figure


def report(_records, directory):
    """Both probabilities of the circled voxels, by the program and by the law, and the figure."""
    contacts = [lines.observation(number) for number in range(CONTACTS)]
    before = lines.maps_of(contacts, "before", directory)
    indices = ((lines.SHOWN, lines.SHOWN), doubtful_voxel(before[1]))
    free = lines.free_observation(*free_pose(indices[1]))
    after = lines.maps_of([*contacts, free], "after", directory)
    was, became = ([both[side][indices[side]] for side in (0, 1)] for both in (before, after))
    rows = [
        ("circled voxels", was, became, free_law(*was)),
        ("the paper's example", PAPER_BEFORE, PAPER_AFTER, free_law(*PAPER_BEFORE)),
    ]
    text = ["| world, object | before | after | by equation 11 |", "|---|---|---|---|"]
    for name, *pairs in rows:
        text.append(f"| {name} | " + " | ".join(f"{world:.3f}, {held:.3f}" for world, held in pairs) + " |")
    return "\n".join(text) + "\n", {"figure4": draw(before, after, indices)}
