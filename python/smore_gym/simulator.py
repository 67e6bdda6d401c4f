# SPDX-License-Identifier: BSD-3-Clause
"""Finds the compiled module smore_simulator where the package's programs are."""
import sys

from program_folders import PROGRAM_FOLDERS

sys.path += [str(folder) for folder in PROGRAM_FOLDERS if folder.is_dir()]
try:
    import smore_simulator
except ImportError as problem:
    raise ImportError(
        f"no module smore_simulator for this Python in {PROGRAM_FOLDERS[0]} ({problem}); install pybind11-dev, run "
        "scripts/build or source the setup.bash of the catkin workspace, and use the Python that it was built for, "
        "/usr/bin/python3"
    ) from problem

InputError = smore_simulator.InputError
LARGEST_SHIFT = smore_simulator.LARGEST_SHIFT
LARGEST_TURN = smore_simulator.LARGEST_TURN
SteppedTrial = smore_simulator.SteppedTrial
