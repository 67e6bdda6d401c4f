#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints folders of result files of smore_experiment as one table in Markdown: a row for each folder, a
column for each scene, mean collisions and, where not all trials reached the goal, how many did.

    table_of_ablation.py DIRECTORY [DIRECTORY ...] -- RESULT [RESULT ...]

Each folder holds result files of these names.
"""
import json
import pathlib
import sys

from table_of_scores import number


def cell(result):
    reached = sum(trial["success"] for trial in result["trials"])
    count = len(result["trials"])
    text = number(result["summary"]["collisions"]["mean"], 1)  # nothing where all broke off
    return text if reached == count else f"{text} ({reached} of {count})"


def main():
    if "--" not in sys.argv[2:-1]:
        sys.exit("usage: table_of_ablation.py DIRECTORY [DIRECTORY ...] -- RESULT [RESULT ...]")
    end = sys.argv.index("--")
    names = sys.argv[end + 1:]
    scenes = [pathlib.Path(name).stem.partition("_")[2] for name in names]  # evaluate's METHOD_SCENE
    print("| without | " + " | ".join(scenes) + " |")
    print("|" + "---|" * (len(scenes) + 1))
    for directory in map(pathlib.Path, sys.argv[1:end]):
        cells = [cell(json.loads((directory / name).read_text())) for name in names]
        print(f"| {directory.name} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
