#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""All C++ is formatted as .clang-format says. To repair: clang-format -i FILE."""
import subprocess

from project import code_files, only_with, report


def main():
    only_with("clang-format", "14")
    paths = code_files()
    result = subprocess.run(
        ["clang-format", "--dry-run", "-Werror", *paths], capture_output=True, text=True
    )
    first_lines = [line for line in result.stderr.splitlines() if ": error: " in line]
    report(first_lines if result.returncode else [], len(paths))


if __name__ == "__main__":
    main()
