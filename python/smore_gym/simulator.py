# SPDX-License-Identifier: BSD-3-Clause
"""Finds the compiled module smore_simulator where it is built, or beside an installed share/smore/python."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
BUILT = (HERE.parents[1] / "build/devel/lib/smore", HERE.parents[3] / "lib/smore")
sys.path += [str(folder) for folder in BUILT if folder.is_dir()]
try:
    import smore_simulator
except ImportError as problem:
    raise ImportError(
        f"no module smore_simulator for this Python in {BUILT[0]} or {BUILT[1]} ({problem}); install pybind11-dev, run "
        "scripts/build, and use the Python that it was built for, /usr/bin/python3"
    ) from problem

InputError = smore_simulator.InputError
LARGEST_SHIFT = smore_simulator.LARGEST_SHIFT
LARGEST_TURN = smore_simulator.LARGEST_TURN
SteppedTrial = smore_simulator.SteppedTrial
