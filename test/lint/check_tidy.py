#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""clang-tidy finds nothing in the sources under src/, with the checks of .clang-tidy.

    check_tidy.py BUILD_FOLDER [SOURCE ...]

Reads the compile commands of the build. A source found clean is remembered in the build by a digest of
itself, all headers of the project and the checks, and is not parsed again until one of them changes.
"""
import concurrent.futures
import hashlib
import os
import pathlib
import subprocess
import sys

from project import ROOT, code_files, files, only_with, report

# Warnings that clang gives for what gcc's flags allow, or about headers that are not ours.
NOISE = ("warnings generated", "warning generated", "Suppressed ", "Use -header-filter")


def digest(paths):
    sha = hashlib.sha256()
    for path in paths:
        sha.update(path.read_bytes())
    return sha.hexdigest()


def tidy(build, source):
    # The generated headers of messages below the build are not ours to mend.
    own_headers = f"--header-filter=^{ROOT}/(include|src)/"
    command = ["clang-tidy", "-p", str(build), "--quiet", own_headers, str(source)]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode == 0:
        return []
    lines = (result.stdout + result.stderr).splitlines()
    return [line for line in lines if not any(text in line for text in NOISE)]


def check(build, memory, shared, source):
    mark = memory / digest([source, *shared])
    if mark.exists():
        return []
    findings = tidy(build, source)
    if not findings:
        mark.touch()
    return findings


def main():
    only_with("clang-tidy", "14")
    build = pathlib.Path(sys.argv[1])
    sources = [pathlib.Path(name).resolve() for name in sys.argv[2:]] or files(("src",), "*.cpp")
    shared = [ROOT / ".clang-tidy"] + [p for p in code_files(("include", "src")) if p.suffix == ".h"]
    memory = build / "clang_tidy_clean"
    memory.mkdir(exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = pool.map(lambda source: check(build, memory, shared, source), sources)
        findings = [line for lines in found for line in lines]
    report(findings, len(sources))


if __name__ == "__main__":
    main()
