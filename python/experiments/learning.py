# SPDX-License-Identifier: BSD-3-Clause
"""A Python of its own for what learns: packages from PyPI, pinned, over Debian's."""
import subprocess
import sys

from experiments.trials import ROOT

FOLDER = ROOT / "build/learning"
PYTHON = FOLDER / "bin/python"
PACKAGES = ROOT / "scripts/packages_pypi.txt"
SMALLEST = "farama-notifications==0.0.4"  # of them: three kilobytes, to see whether PyPI answers
SKIPPED = 77  # exit status, as CTest knows it
PIP = ("-m", "pip", "--disable-pip-version-check", "--timeout", "20", "--retries", "2")


def pip(*arguments):
    return subprocess.run([PYTHON, *PIP, *arguments], capture_output=True, text=True)


def is_set_up():
    return PYTHON.exists() and pip("show", "--quiet", "stable-baselines3").returncode == 0


def answers():
    """Whether PyPI can be reached."""
    done = pip("download", "--quiet", "--no-deps", "--no-cache-dir", "--dest", FOLDER / "reached", SMALLEST)
    return done.returncode == 0


def set_up():
    """Makes or completes it; the exit status, SKIPPED where Debian's packages or PyPI cannot be reached."""
    if subprocess.run([ROOT / "scripts/install_dependencies", "--experiments"]).returncode != 0:
        return SKIPPED
    subprocess.run(["/usr/bin/python3", "-m", "venv", "--system-site-packages", FOLDER], check=True)
    done = pip("install", "--no-deps", "--requirement", PACKAGES)
    if done.returncode == 0:
        print(f"{PYTHON} has what {PACKAGES.relative_to(ROOT)} lists.")
        return 0
    if not answers():
        print("PyPI cannot be reached: what learns is not set up.", file=sys.stderr)
        return SKIPPED
    print(done.stderr.strip(), file=sys.stderr)
    return 1
