#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""House rules that no other tool knows: licence line, include guard, size, and what libraries print."""
import re

from project import code_files, report, say

LICENCE = "// SPDX-License-Identifier: BSD-3-Clause"
LONGEST_FILE = 300
PRINTS = re.compile(r"\bstd::(cout|cerr|clog)\b|\b(printf|puts|fprintf)\s*\(")
PENDING = re.compile(r"\b(TODO|FIXME|XXX)\b")


def is_program(path):
    """Programs may write to the terminal, libraries may not."""
    return path.stem.endswith("_main") or not {"test", "benchmark", "examples"}.isdisjoint(path.parts)


def problems(path):
    lines = path.read_text().splitlines()
    if not lines or lines[0] != LICENCE:
        yield 1, f"the first line is not '{LICENCE}'"
    if path.suffix == ".h" and "#pragma once" not in lines[:3]:
        yield 1, "#pragma once is missing below the licence line"
    if len(lines) > LONGEST_FILE:
        yield len(lines), f"{len(lines)} lines: more than {LONGEST_FILE}, split it by ideas"
    for number, line in enumerate(lines, 1):
        code = line.split("//")[0]
        if PRINTS.search(code) and not is_program(path):
            yield number, "a library prints; return the text or use the caller's log"
        if PENDING.search(line):
            yield number, "unfinished work is no comment"


def main():
    paths = code_files()
    report([say(path, *problem) for path in paths for problem in problems(path)], len(paths))


if __name__ == "__main__":
    main()
