# SPDX-License-Identifier: BSD-3-Clause
"""What the lint tests share: the project's files, and how findings are told."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77  # exit status, as CTest is told
CODE_FOLDERS = ("include", "src", "test", "benchmark", "examples")


def files(folders, *patterns):
    """All files below the folders of the project that match one of the patterns, sorted."""
    found = set()
    for folder in folders:
        for pattern in patterns:
            found.update((ROOT / folder).rglob(pattern))
    return sorted(path for path in found if path.is_file())


def code_files(folders=CODE_FOLDERS):
    return files(folders, "*.h", "*.cpp")


def python_files():
    return files(("python", "test", "cmake", "scripts", "cfg"), "*.py", "*.cfg")


def shell_scripts():
    """Files of scripts/ and .ci/ that start with a shell's shebang line."""
    return [
        path
        for path in files(("scripts", ".ci"), "*")
        if path.read_bytes().startswith((b"#!/usr/bin/env bash", b"#!/bin/sh", b"#!/bin/bash"))
    ]


def say(path, line, problem):
    return f"{path.relative_to(ROOT)}:{line}: {problem}"


def only_with(tool, version):
    """Ends the program with SKIPPED where `tool` is of another version than the one that the sources follow
    (Debian 12's): each finds something else."""
    said = subprocess.run([tool, "--version"], capture_output=True, text=True).stdout
    if not re.search(rf"version:? {re.escape(version)}\b", said):
        print(f"skipped: this is not {tool} {version}")
        sys.exit(SKIPPED)


def report(findings, checked):
    """Ends the program: status 1 with the findings, or 0; nothing checked is an error too."""
    for finding in findings:
        print(finding)
    if not checked:
        sys.exit("found no file to check")
    print(f"{checked} checked, {len(findings)} findings")
    sys.exit(1 if findings else 0)
