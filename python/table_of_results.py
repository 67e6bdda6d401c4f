#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints result files of smore_experiment as one table in Markdown; those of the same scene and method with their names.

    table_of_results.py RESULT.json [RESULT.json ...]
"""
import collections
import pathlib
import sys

from table_of_scores import number
from user_files import read_result


def key(result):
    return result["scenario"], result["method"]


def row(result, name):
    """`name` tells it from others of the same scene and method; empty where there are none."""
    method = f"{result['method']} ({name})" if name else result["method"]
    collisions = result["summary"]["collisions"]
    trials = result["trials"]
    reached = sum(trial["success"] for trial in trials)
    plans = sum(trial["plans"] for trial in trials)
    planning = sum(trial["planning_s"] for trial in trials) / max(plans, 1)
    return (f"| {result['scenario']} | {method} | {number(collisions['mean'], 1)} | "
            f"{number(collisions['median'], 0)} | {number(collisions['min'], 0)} | {number(collisions['max'], 0)} | "
            f"{reached} of {len(trials)} | {planning:.2f} |")


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: table_of_results.py RESULT.json [RESULT.json ...]")
    results = {name: read_result(name) for name in sys.argv[1:]}
    print("| scene | method | mean | median | least | most | at the goal | s a plan |")
    print("|---|---|---|---|---|---|---|---|")
    alike = collections.Counter(map(key, results.values()))
    for name, result in results.items():
        print(row(result, pathlib.Path(name).stem if alike[key(result)] > 1 else ""))


if __name__ == "__main__":
    main()
