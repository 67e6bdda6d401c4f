#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""roslaunch resolves every launch file, and every node of this package that they name is a program.

    check_launch.py PROGRAM_FOLDER      (in the environment of the build)
"""
import pathlib
import subprocess
import sys
import xml.etree.ElementTree

from project import files, report, say

SCENARIO = "scenario:=s_shape_two_pegs"


def unresolved(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    declared = {argument.get("name") for argument in root.findall("arg")}
    arguments = [SCENARIO] if "scenario" in declared else []
    command = ["roslaunch", "--nodes", str(path), *arguments]
    result = subprocess.run(command, capture_output=True, text=True)
    return [say(path, 1, result.stderr.strip())] if result.returncode else []


def missing_programs(path, programs):
    for node in xml.etree.ElementTree.parse(path).getroot().iter("node"):
        if node.get("pkg") == "smore" and not (programs / node.get("type")).is_file():
            yield say(path, 1, f"there is no program {node.get('type')}")


def main():
    programs = pathlib.Path(sys.argv[1])
    paths = files(("launch",), "*.launch")
    findings = [text for path in paths for text in unresolved(path)]
    findings += [text for path in paths for text in missing_programs(path, programs)]
    report(findings, len(paths))


if __name__ == "__main__":
    main()
