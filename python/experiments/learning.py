# SPDX-License-Identifier: BSD-3-Clause
"""A Python of its own for what learns: packages from PyPI, pinned, over Debian's."""
import subprocess
import sys

from experiments.trials import ROOT

FOLDER = ROOT / "build/learning"
PYTHON = FOLDER / "bin/python"
PACKAGES = ROOT / "scripts/packages_pypi.txt"
SKIPPED = 77  # exit status, as CTest knows it
PIP = ("-m", "pip", "--disable-pip-version-check", "--timeout", "20", "--retries", "2")


def pip(*arguments):
    return subprocess.run([PYTHON, *PIP, *arguments], capture_output=True, text=True)


def is_set_up():
    return PYTHON.exists() and pip("show", "--quiet", "stable-baselines3").returncode == 0


def set_up():
    """Makes or completes it; the exit status, SKIPPED where Debian or PyPI does not give its packages."""
    if subprocess.run([ROOT / "scripts/install_dependencies", "--experiments"]).returncode != 0:
        return SKIPPED
    subprocess.run(["/usr/bin/python3", "-m", "venv", "--system-site-packages", FOLDER], check=True)
    done = pip("install", "--no-deps", "--requirement", PACKAGES)
    if done.returncode == 0:
        print(f"{PYTHON} has what {PACKAGES.relative_to(ROOT)} lists.")
        return 0
    print(f"What learns is not set up, since PyPI does not give it:\n{done.stderr.strip()}", file=sys.stderr)
    return SKIPPED
