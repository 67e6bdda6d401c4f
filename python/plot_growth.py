#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws how the cost of the joint belief grows with the number of contacts, from belief_growth's tables.

    plot_growth.py --output FILE.png NAME=TABLE.csv [NAME=TABLE.csv ...]
"""
import argparse
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from user_files import save_picture

COLORS = ("#1a9641", "#3b6fb6", "#b0763a", "#7a7a7a")
PANELS = (
    ("update_s", 1.0, "worlds and maps after a contact [s]"),
    ("free_pose_s", 1e3, "free pose [ms]"),
    ("memory_mb", 1.0, "memory [MB]"),
)


def arguments():
    parser = argparse.ArgumentParser(description="Plots the cost of the joint belief.")
    parser.add_argument("tables", nargs="+", metavar="NAME=TABLE.csv", help="tables of belief_growth")
    parser.add_argument("--output", required=True, help="picture to write")
    return parser.parse_args()


def read(argument):
    name, separator, file = argument.partition("=")
    if not separator:
        sys.exit(f"plot_growth: '{argument}' is not of the form NAME=TABLE.csv")
    return name, np.atleast_1d(np.genfromtxt(file, delimiter=",", names=True))


def main():
    options = arguments()
    tables = [read(table) for table in options.tables]
    figure, all_axes = plt.subplots(1, len(PANELS), figsize=(12, 3.6), constrained_layout=True)
    for axes, (column, scale, label) in zip(all_axes, PANELS):
        for (name, table), color in zip(tables, COLORS):
            axes.plot(table["contacts"], scale * table[column], "o-", color=color, label=name, markersize=4)
        axes.set_xlabel("contacts")
        axes.set_title(label, fontsize=10)
        axes.set_ylim(bottom=0.0)
        axes.grid(alpha=0.3)
    all_axes[0].legend(fontsize=9)
    save_picture(figure, options.output, dpi=110)


if __name__ == "__main__":
    main()
