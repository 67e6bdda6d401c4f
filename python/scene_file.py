# SPDX-License-Identifier: BSD-3-Clause
"""Scenarios as smore_experiment reads them: it alone knows their files and those of meshes."""
import json
import pathlib
import shutil
import subprocess
import tempfile

from program_folders import PROGRAM_FOLDERS


class SceneFileError(Exception):
    """A scenario cannot be read; the message is the program's own."""


def find_program(name="smore_experiment"):
    """Path of one of the package's programs: on PATH, else in one of its folders."""
    candidates = [shutil.which(name), *(shutil.which(name, path=str(folder)) for folder in PROGRAM_FOLDERS)]
    for candidate in candidates:
        if candidate:
            return candidate
    raise SceneFileError(
        f"no program {name} on PATH or in {PROGRAM_FOLDERS[0]}; run scripts/build, or source the setup.bash of the "
        "catkin workspace, first"
    )


def read_scene(name_or_path):
    """The scenario with all its keys and its solids' triangles (docs/scenarios.md), as nested
    dictionaries. Takes the name of a shipped scenario, a scenario file, or such a scene's JSON."""
    if pathlib.Path(name_or_path).suffix == ".json":
        return json.loads(pathlib.Path(name_or_path).read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder, "scene.json")
        command = [find_program(), "--scenario", str(name_or_path), "--validate", "--output", str(output)]
        result = subprocess.run(command, capture_output=True, text=True)
        if result.returncode:
            raise SceneFileError(result.stderr.strip())
        return json.loads(output.read_text(encoding="utf-8"))
