#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shell scripts pass shellcheck, Python files pyflakes; both are executable where they have a shebang."""
import os
import subprocess

from project import python_files, report, say, shell_scripts


def findings_of(command, paths):
    if not paths:
        return []
    result = subprocess.run([*command, *paths], capture_output=True, text=True)
    return (result.stdout + result.stderr).splitlines() if result.returncode else []


def not_executable(paths):
    return [
        say(path, 1, "starts with #! but is not executable")
        for path in paths
        if path.read_bytes().startswith(b"#!") and not os.access(path, os.X_OK)
    ]


def main():
    shell, python = shell_scripts(), python_files()
    findings = findings_of(["shellcheck", "--format=gcc"], shell)
    findings += findings_of(["/usr/bin/python3", "-m", "pyflakes"], python)
    findings += not_executable(shell + python)
    report(findings, len(shell) + len(python))


if __name__ == "__main__":
    main()
