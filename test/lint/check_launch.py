#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""roslaunch resolves every launch file, every node of this package that they name is a program, a
scenario's name stays the text that was typed, and rviz gets it.

    check_launch.py PROGRAM_FOLDER      (in the environment of the build)
"""
import pathlib
import subprocess
import sys
import xml.etree.ElementTree

from project import ROOT, files, report, say

SCENARIO = "1.10"  # roslaunch makes a number of what looks like one, but for parameters of type str


def unresolved(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    declared = {argument.get("name") for argument in root.findall("arg")}
    arguments = [f"scenario:={SCENARIO}"] if "scenario" in declared else []
    command = ["roslaunch", "--dump-params", str(path), *arguments]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode:
        yield say(path, 1, result.stderr.strip())
    for line in result.stdout.splitlines():
        name, _, value = line.partition(": ")
        if name.endswith("/scenario") and value != f"'{SCENARIO}'":
            yield say(path, 1, f"the parameter {name} is {value}, not the text '{SCENARIO}'")


def without_view(path):
    """Where there is rviz its view fits the scenario."""
    declared = {argument.get("name") for argument in xml.etree.ElementTree.parse(path).getroot().findall("arg")}
    if not {"rviz", "scenario"} <= declared:
        return
    command = ["roslaunch", "--args", "/smore/rviz", str(path), f"scenario:={SCENARIO}", "rviz:=true"]
    required = ["bag:=/run.bag"] if "bag" in declared else []
    result = subprocess.run(command + required, capture_output=True, text=True)
    if f"--scenario {SCENARIO}" not in result.stdout.replace("'", ""):
        yield say(path, 1, f"rviz does not get scenario:={SCENARIO}: {result.stdout}{result.stderr}".strip())


def missing_programs(path, programs):
    for node in xml.etree.ElementTree.parse(path).getroot().iter("node"):
        if node.get("pkg") == "smore" and not any((f / node.get("type")).is_file() for f in (programs, ROOT / "python")):
            yield say(path, 1, f"there is no program {node.get('type')}")


def main():
    programs = pathlib.Path(sys.argv[1])
    paths = files(("launch",), "*.launch")
    findings = [text for path in paths for text in unresolved(path)]
    findings += [text for path in paths for text in without_view(path)]
    findings += [text for path in paths for text in missing_programs(path, programs)]
    report(findings, len(paths))


if __name__ == "__main__":
    main()
