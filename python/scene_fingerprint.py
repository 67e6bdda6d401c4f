#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints a hash of a scene: of its file, of the files that it names (meshes, clouds, maps, a robot's description), and of
further files. What cannot be read adds nothing: the program says so.

    scene_fingerprint.py SCENE [FILE ...]

A scene is a name in config/scenarios or the path of a file.
"""
import pathlib
import sys

import yaml
from file_hash import file_hash

SCENARIOS = pathlib.Path(__file__).resolve().parent.parent / "config/scenarios"


def texts_in(node):
    """All strings in nested lists and dictionaries."""
    if isinstance(node, str):
        yield node
    elif isinstance(node, (list, dict)):
        for value in node.values() if isinstance(node, dict) else node:
            yield from texts_in(value)


def named_in(file):
    """The files that a file in YAML names; relative ones lie beside it."""
    try:
        texts = set(texts_in(yaml.safe_load(file.read_text(encoding="utf-8"))))
    except (OSError, ValueError, yaml.YAMLError):
        return []
    return [file.parent / text for text in sorted(texts)]


def is_file(path):
    try:
        return path.is_file()
    except (OSError, ValueError):  # no text is too odd to stand in a scene: too long for a path, a zero in it
        return False


def scene_fingerprint(name_or_path, files=()):
    """A hash of all that a scene and further files hold."""
    shipped = SCENARIOS / f"{name_or_path}.yaml"
    scene = shipped if is_file(shipped) else pathlib.Path(name_or_path)
    return file_hash(file for file in (scene, *named_in(scene), *map(pathlib.Path, files)) if is_file(file))


if __name__ == "__main__":
    print(scene_fingerprint(sys.argv[1], sys.argv[2:]))
