#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Relative links of the Markdown pages lead to files, and scripts and scenes that they name exist."""
import re

from project import ROOT, files, report, say

LINK = re.compile(r"\]\((?!https?:|#|mailto:)([^)#\s]+)")
NAMED = re.compile(r"\b(?:scripts|config|launch|python|docs|src|include|test|benchmark)/[\w./-]*\w")

PLACEHOLDER = re.compile(r"/[A-Z_]{2,}(\.\w+)?$")  # config/NODE.yaml: one of several


def exists(path):
    # Headers are named without their extension where the pair is meant.
    return path.exists() or any(path.parent.glob(path.name + ".*"))


def problems(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        for target in LINK.findall(line):
            if not (path.parent / target).exists():
                yield say(path, number, f"the link {target} leads nowhere")
        for name in NAMED.findall(LINK.sub("", line)):
            if not PLACEHOLDER.search(name) and not exists(ROOT / name):
                yield say(path, number, f"{name} does not exist")


def main():
    paths = sorted(ROOT.glob("*.md")) + files(("docs",), "*.md")
    report([finding for path in paths for finding in problems(path)], len(paths))


if __name__ == "__main__":
    main()
