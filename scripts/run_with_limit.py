#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a command for at most SECONDS and ends it together with every process it started.

    run_with_limit.py SECONDS COMMAND [ARGUMENT ...]

roslaunch gives each node a session of its own, so killing the command alone would leave its nodes behind.
Exits with the command's status, with 124 where the limit ended it, with 130 where a signal did.
"""
import os
import signal
import subprocess
import sys
import time

GRACE_S = 15.0  # for roslaunch to end its nodes before they are killed
POLL_S = 0.1
LIMIT_STATUS = 124
INTERRUPTED_STATUS = 130


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
    """Asks the command to end, as Ctrl-C would, then kills whatever is left of it."""
    tree = set(descendants(process.pid))
    send([process.pid], signal.SIGINT)
    deadline = time.monotonic() + GRACE_S
    while process.poll() is None and time.monotonic() < deadline:
        tree.update(descendants(process.pid))
        time.sleep(POLL_S)
    send(tree - {process.pid} if process.poll() is not None else tree, signal.SIGKILL)
    process.wait()


def run(limit_s, command):
    interrupts = []
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda received, _: interrupts.append(received))
    # A session of its own: Ctrl-C reaches it once, through end_tree.
    process = subprocess.Popen(command, start_new_session=True)
    deadline = time.monotonic() + limit_s
    while process.poll() is None:
        if interrupts:
            end_tree(process)
            return INTERRUPTED_STATUS
        if time.monotonic() > deadline:
            print(f"{command[0]}: ended after {limit_s:g} s", file=sys.stderr)
            end_tree(process)
            return LIMIT_STATUS
        time.sleep(POLL_S)
    return process.returncode


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    return run(float(arguments[0]), arguments[1:])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
