# SPDX-License-Identifier: BSD-3-Clause
"""What tells one build of a program from another: its results are kept with it, and not taken for another's."""
import hashlib
import pathlib
import subprocess
import sys


def fingerprint(program):
    """A hash of the program's file and of the package's own libraries that it loads."""
    listed = subprocess.run(["ldd", str(program)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    words = (word for word in listed.split() if word.startswith("/"))
    libraries = sorted(word for word in words if pathlib.Path(word).name.startswith("libsmore_"))
    whole = hashlib.sha1()
    for file in (program, *libraries):
        whole.update(hashlib.sha1(pathlib.Path(file).read_bytes()).digest())
    return whole.hexdigest()


if __name__ == "__main__":
    print(fingerprint(sys.argv[1]))
