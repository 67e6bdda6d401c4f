#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of a tutorial as a user would type them, one block after another.

    run_tutorial.py DEVEL_FOLDER PAGE.md

A block ```shell is typed into one terminal and must succeed; ```shell background into another, where it goes on to the
end of the page, once all nodes of its roslaunch are there. A block with a file's name after its language is that
file. Others are not run. All happens in a scratch copy of the repository's root, which is made of links.
"""
import contextlib
import os
import pathlib
import re
import shlex
import signal
import socket
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.DOTALL | re.MULTILINE)
COMMAND_DEADLINE = 200.0  # of a block [s]
NODES_DEADLINE = 60.0  # of a launch, until all its nodes are there [s]


def scratch_root(folder, devel):
    for entry in ROOT.iterdir():
        if entry.name not in ("build", "results") and not entry.name.startswith("."):
            (folder / entry.name).symlink_to(entry)
    (folder / "build").mkdir()
    (folder / "build/devel").symlink_to(devel)


def environment(devel):
    """That of a terminal after `source build/devel/setup.bash`, with a ROS master of its own."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    said = subprocess.run(["bash", "-c", f"source {devel}/setup.bash && env -0"], capture_output=True, check=True)
    variables = dict(entry.split("=", 1) for entry in said.stdout.decode().split("\0") if "=" in entry)
    return {**variables, "ROS_MASTER_URI": f"http://localhost:{port}", "ROS_HOSTNAME": "localhost"}


def shell(command, folder, variables):
    return subprocess.Popen(
        ["bash", "-euxo", "pipefail", "-c", command], cwd=folder, env=variables, start_new_session=True
    )


def end(process):
    """With everything that it has started."""
    for signal_number, patience in ((signal.SIGINT, 15.0), (signal.SIGKILL, 5.0)):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal_number)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(patience)
            return


def lines(command, folder, variables):
    done = subprocess.run(command, cwd=folder, env=variables, capture_output=True, text=True)
    return set(done.stdout.split())


def wait_for_nodes(command, launch, folder, variables):
    words = shlex.split(command)
    expected = lines([words[0], "--nodes", *words[1:]], folder, variables)
    assert expected, f"no nodes in '{command}'"
    deadline = time.monotonic() + NODES_DEADLINE
    while not expected <= lines(["rosnode", "list"], folder, variables):
        assert launch.poll() is None, f"'{command}' has ended"
        assert time.monotonic() < deadline, f"not all of {sorted(expected)} came"


def run(page, folder, variables, launches):
    for language, name, text in BLOCK.findall(page.read_text()):
        if language == "shell" and name == "background":
            launches.append(shell("exec " + text, folder, variables))
            wait_for_nodes(text, launches[-1], folder, variables)
        elif language == "shell":
            process = shell(text, folder, variables)
            launches.append(process)
            assert process.wait(COMMAND_DEADLINE) == 0, f"these commands ended with {process.returncode}:\n{text}"
        elif name:
            (folder / name).write_text(text)


def main():
    devel, page = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    launches = []
    with tempfile.TemporaryDirectory() as folder:
        scratch_root(pathlib.Path(folder), devel)
        try:
            run(page, pathlib.Path(folder), environment(devel), launches)
        finally:
            for process in reversed(launches):
                end(process)


if __name__ == "__main__":
    main()
