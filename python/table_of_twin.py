#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what scripts/evaluate_twin left as a table in Markdown, and how each failure ended.

    table_of_twin.py DIRECTORY [DIRECTORY ...]
"""
import json
import pathlib
import statistics
import sys

NO_SUMMARY = {"success": False, "collisions": None, "wall_s": None, "reason": "no summary; see launch.log"}


def read(directory):
    directory = pathlib.Path(directory)
    summary = directory / "summary.json"
    trial = json.loads(summary.read_text()) if summary.exists() else dict(NO_SUMMARY)
    trial["name"] = directory.name
    limit = directory / "time_limit"  # which ends a retrieval as its user would
    if limit.exists():
        trial["reason"] = limit.read_text().strip()
    force = directory / "peak_force.json"  # not there where nothing was listened to
    trial["peak_force"] = json.loads(force.read_text())["peak_force"] if force.exists() else None
    log = (directory / "launch.log").read_text(errors="replace")
    trial["waits"] = log.count("the motion waits")
    return trial


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: table_of_twin.py DIRECTORY [DIRECTORY ...]")
    trials = [read(name) for name in sys.argv[1:]]
    collisions = [trial["collisions"] for trial in trials if trial["collisions"] is not None]
    forces = [trial["peak_force"] for trial in trials if trial["peak_force"] is not None] or [0]
    print("| at the goal | collisions, mean | most | peak force, median | most | waits told |")
    print("|---|---|---|---|---|---|")
    print(f"| {sum(trial['success'] for trial in trials)} of {len(trials)}"
          f" | {statistics.mean(collisions or [0]):.1f} | {max(collisions or [0])}"
          f" | {statistics.median(forces):.0f} N | {max(forces):.0f} N | {sum(trial['waits'] for trial in trials)} |")
    for trial in trials:
        if not trial["success"]:
            print(f"{trial['name']}: {trial['reason']}")


if __name__ == "__main__":
    main()
