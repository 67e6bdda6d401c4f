# SPDX-License-Identifier: BSD-3-Clause
"""Folders that may hold the package's programs and its compiled module of Python."""
import os
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
# Where the source tree is built, beside an installed share/smore/python, in the catkin workspaces that are sourced.
PROGRAM_FOLDERS = (
    HERE.parent / "build/devel/lib/smore",
    HERE.parent.parent.parent / "lib/smore",
    *(pathlib.Path(space, "lib/smore") for space in os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if space),
)
