#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints folders of result files of smore_experiment as one table in Markdown: a row for each folder, a
column for each scene, mean collisions and, where not all trials reached the goal, how many did.

    table_of_ablation.py DIRECTORY [DIRECTORY ...]
"""
import json
import pathlib
import sys


def cell(result):
    reached = sum(trial["success"] for trial in result["trials"])
    count = len(result["trials"])
    text = f"{result['summary']['collisions']['mean']:.1f}"
    return text if reached == count else f"{text} ({reached} of {count})"


def read(directory):
    results = [json.loads(file.read_text()) for file in sorted(pathlib.Path(directory).glob("*.json"))]
    return {result["scenario"]: cell(result) for result in results}


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: table_of_ablation.py DIRECTORY [DIRECTORY ...]")
    rows = {pathlib.Path(name).name: read(name) for name in sys.argv[1:]}
    scenes = list(next(iter(rows.values())))
    print("| without | " + " | ".join(scenes) + " |")
    print("|" + "---|" * (len(scenes) + 1))
    for name, cells in rows.items():
        print(f"| {name} | " + " | ".join(cells.get(scene, "") for scene in scenes) + " |")


if __name__ == "__main__":
    main()
