#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""package.xml, launch, rostest and URDF files are well-formed; each launch argument is explained."""
import subprocess
import xml.etree.ElementTree

from project import ROOT, files, report, say


def malformed(paths):
    result = subprocess.run(["xmllint", "--noout", *paths], capture_output=True, text=True)
    return result.stderr.splitlines() if result.returncode else []


def unexplained_arguments(path):
    for argument in xml.etree.ElementTree.parse(path).getroot().findall("arg"):
        if not argument.get("doc"):
            yield say(path, 1, f"argument '{argument.get('name')}' has no doc attribute")


def tests_nothing(path):
    if not list(xml.etree.ElementTree.parse(path).getroot().iter("test")):
        yield say(path, 1, "a rostest file without a <test>")


def main():
    launch_files = files(("launch",), "*.launch")
    rostests = files(("test",), "*.test")
    paths = [ROOT / "package.xml", *launch_files, *rostests, *files(("urdf",), "*.urdf")]
    findings = malformed(paths)
    if not findings:
        findings = [text for path in launch_files for text in unexplained_arguments(path)]
        findings += [text for path in rostests for text in tests_nothing(path)]
    report(findings, len(paths))


if __name__ == "__main__":
    main()
