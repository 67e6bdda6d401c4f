#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints result files of smore_experiment as one table in Markdown.

    table_of_results.py RESULT.json [RESULT.json ...]
"""
import json
import pathlib
import sys

from table_of_scores import number


def row(result):
    collisions = result["summary"]["collisions"]
    trials = result["trials"]
    reached = sum(trial["success"] for trial in trials)
    plans = sum(trial["plans"] for trial in trials)
    planning = sum(trial["planning_s"] for trial in trials) / max(plans, 1)
    return (f"| {result['scenario']} | {result['method']} | {number(collisions['mean'], 1)} | "
            f"{number(collisions['median'], 0)} | {number(collisions['min'], 0)} | {number(collisions['max'], 0)} | "
            f"{reached} of {len(trials)} | {planning:.2f} |")


def main():
    missing = [name for name in sys.argv[1:] if not pathlib.Path(name).is_file()]
    if missing:
        sys.exit(f"{missing[0]}: there is no such file")
    if len(sys.argv) < 2:
        sys.exit("usage: table_of_results.py RESULT.json [RESULT.json ...]")
    print("| scene | method | mean | median | least | most | at the goal | s a plan |")
    print("|---|---|---|---|---|---|---|---|")
    for name in sys.argv[1:]:
        print(row(json.loads(pathlib.Path(name).read_text())))


if __name__ == "__main__":
    main()
