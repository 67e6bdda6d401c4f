# SPDX-License-Identifier: BSD-3-Clause
"""Files that a user names, read and written with one line for what is wrong."""
import json
import pathlib
import sys


def read_result(name):
    """A result file of smore_experiment; ends the program where it is none."""
    try:
        result = json.loads(pathlib.Path(name).read_text())
    except OSError as problem:
        sys.exit(f"{name}: cannot be read: {problem.strerror}")
    except ValueError:
        result = None
    if not isinstance(result, dict) or not {"scenario", "method", "trials"} <= result.keys():
        sys.exit(f"{name}: no result of smore_experiment; give what its --output wrote")
    return result


def save_picture(figure, file, dpi):
    """Writes a figure; ends the program where the file cannot be written, or its name's end says no kind of picture."""
    try:
        figure.savefig(file, dpi=dpi)
    except OSError as problem:
        sys.exit(f"{file}: cannot be written: {problem.strerror}")
    except ValueError:
        sys.exit(f"{file}: no kind of picture; give a name that ends in .png, .svg or .pdf")
