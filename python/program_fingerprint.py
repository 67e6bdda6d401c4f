# SPDX-License-Identifier: BSD-3-Clause
"""What tells one build of a program from another: its results are kept with it, and not taken for another's."""
import pathlib
import subprocess
import sys

from file_hash import file_hash


def fingerprint(program):
    """A hash of the program's file and of the package's own libraries that it loads."""
    listed = subprocess.run(["ldd", str(program)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    words = (word for word in listed.split() if word.startswith("/"))
    libraries = sorted(word for word in words if pathlib.Path(word).name.startswith("libsmore_"))
    return file_hash((program, *libraries))


if __name__ == "__main__":
    print(fingerprint(sys.argv[1]))
