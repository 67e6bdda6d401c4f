#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the result file of smore_score as tables in Markdown (docs/scoring.md).

    table_of_scores.py SCORES.json
"""
import json
import pathlib
import sys


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}f}"


def row(*cells):
    return "| " + " | ".join(cells) + " |"


def header(*cells):
    return "\n".join(["", row(*cells), "|" + "---|" * len(cells)])


def motions(group):
    risk, touch = group["risk"], group["first_touch"]
    return row(
        group["group"], str(group["trials"]), f"{risk['touched']} of {risk['motions']}",
        number(risk["log_loss"]), number(risk["constant_log_loss"]), number(risk["auc"], 2),
        number(risk["calibration_error"]), number(touch["log_score"], 2), number(touch["uniform_log_score"], 2),
    )


def worlds(group):
    places, drawn, way, order = group["places"], group["worlds"], group["way_out"], group["order"] or {}
    return row(
        group["group"], str(places["contacts"]), number(places["log_score_before_motions"], 2),
        number(places["log_score_at_the_end"], 2), ", ".join(number(n, 0) for n in drawn["effective"]) + f" of {drawn['drawn']}",
        number(way["touching"], 2), number(order.get("largest"), 2), number(order.get("mean")),
    )


def voxels(group):
    cells = [group["group"]]
    for name in ("world_voxels", "object_voxels"):
        scores = group[name]
        cells += [str(scores["voxels"]), number(scores["calibration_error"]), number(scores["largest_error"], 2)]
    return row(*cells)


def tables(scores):
    groups = scores["groups"]
    yield header("scene", "trials", "touched", "log-loss", "of a constant", "AUC", "calibration error",
                 "first touch", "uniform")
    yield from map(motions, groups)
    yield header("scene", "contacts", "places before motions", "at the end", "effective worlds", "way out touches",
                 "shuffled: largest", "mean")
    yield from map(worlds, groups)
    yield header("scene", "world voxels", "calibration error", "largest", "object voxels", "calibration error", "largest")
    yield from map(voxels, groups)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: table_of_scores.py SCORES.json")
    print("\n".join(tables(json.loads(pathlib.Path(sys.argv[1]).read_text()))))


if __name__ == "__main__":
    main()
