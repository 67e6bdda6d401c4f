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


def cell(result):
    reached = sum(trial["success"] for trial in result["trials"])
    count = len(result["trials"])
    text = f"{result['summary']['collisions']['mean']:.1f}"
    return text if reached == count else f"{text} ({reached} of {count})"


def read(directory, names):
    results = [json.loads(pathlib.Path(directory, name).read_text()) for name in names]
    return {result["scenario"]: cell(result) for result in results}


def main():
    if "--" not in sys.argv[2:-1]:
        sys.exit("usage: table_of_ablation.py DIRECTORY [DIRECTORY ...] -- RESULT [RESULT ...]")
    end = sys.argv.index("--")
    rows = {pathlib.Path(name).name: read(name, sys.argv[end + 1:]) for name in sys.argv[1:end]}
    scenes = list(next(iter(rows.values())))
    print("| without | " + " | ".join(scenes) + " |")
    print("|" + "---|" * (len(scenes) + 1))
    for name, cells in rows.items():
        print(f"| {name} | " + " | ".join(cells.get(scene, "") for scene in scenes) + " |")


if __name__ == "__main__":
    main()
