#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a command for at most SECONDS, then ends it together with every process it started.

    run_with_limit.py SECONDS COMMAND [ARGUMENT ...]

roslaunch gives each node a process group of its own, so killing the command alone would leave its nodes
behind. Exits with the command's status, or 124 where the limit ended it.
"""
import os
import signal
import subprocess
import sys
import time

GRACE_S = 10.0  # for rostest to end its nodes before they are killed


def descendants(root):
    """Process ids of everything below `root`, itself included."""
    table = subprocess.run(["ps", "-eo", "pid=,ppid="], capture_output=True, text=True, check=True)
    children = {}
    for line in table.stdout.splitlines():
        pid, parent = map(int, line.split())
        children.setdefault(parent, []).append(pid)
    found = [root]
    for pid in found:
        found.extend(children.get(pid, []))
    return found


def send(pids, signal_number):
    for pid in pids:
        try:
            os.kill(pid, signal_number)
        except ProcessLookupError:
            pass


def end_tree(process):
    tree = descendants(process.pid)
    send(tree[:1], signal.SIGINT)
    deadline = time.monotonic() + GRACE_S
    while process.poll() is None and time.monotonic() < deadline:
        tree = sorted(set(tree + descendants(process.pid)))
        time.sleep(0.2)
    send(tree, signal.SIGKILL)
    process.wait()


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    process = subprocess.Popen(arguments[1:])
    try:
        return process.wait(timeout=float(arguments[0]))
    except subprocess.TimeoutExpired:
        print(f"ended after {arguments[0]} s", file=sys.stderr)
        end_tree(process)
        return 124


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
