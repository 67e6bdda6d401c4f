#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each field of each message, service and action says what it is on its own line.

Numbers carry their unit in square brackets ([m], [N], [1] for none), text and flags need words only.
"""
import re

from project import files, report, say

FIELD = re.compile(r"^(?P<type>[\w/]+(\[\d*\])?)\s+(?P<name>\w+)\s*(=[^#]*)?(?P<comment>#.*)?$")
WORDS = re.compile(r"#\s*\S+.*")
UNIT = re.compile(r"\[[^\]]+\]")
FLOATING = re.compile(r"^float(32|64)")


def problem(line):
    field = FIELD.match(line)
    if field is None:
        return "not a field"
    if not WORDS.match(field["comment"] or ""):
        return f"field {field['name']} has no comment"
    if FLOATING.match(field["type"]) and not UNIT.search(field["comment"]):
        return f"field {field['name']} states no unit in [brackets]"
    return None


def problems(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        text = line.strip()
        if text and text != "---" and not text.startswith("#"):
            found = problem(text)
            if found:
                yield say(path, number, found)


def main():
    paths = files(("msg", "srv", "action"), "*.msg", "*.srv", "*.action")
    report([finding for path in paths for finding in problems(path)], len(paths))


if __name__ == "__main__":
    main()
