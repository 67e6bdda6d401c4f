#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A Dask cluster of a scheduler and two workers, one of which is killed in the middle of a trial, gives what this
machine gives alone, each trial once.

    test_cluster.py       needs python3-distributed
"""
import json
import os
import pathlib
import select
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from experiments import trials, workers  # noqa: E402
from experiments.trials import recorded, run  # noqa: E402

DEADLINE = 60.0  # for what takes some seconds [s]
HELD = 1003  # seed of the trial that hangs when it is run first on the cluster

# Stands for smore_experiment. FOLDER/hold makes the trial HELD tell who runs it and then wait for ever.
PROGRAM = """#!/usr/bin/python3
import json, os, pathlib, sys
here = pathlib.Path(sys.argv[0]).parent
arguments = dict(zip(sys.argv[1:], sys.argv[2:] + [""]))
seed = int(arguments["--seed"])
evidence = pathlib.Path(arguments["--record"], "seed_%d.evidence" % seed)
evidence.write_text("half")
if seed == {held} and (here / "hold").exists():
    (here / "hold").unlink()
    (here / "started").open("w").write("%d %d" % (os.getppid(), os.getpid()))
    (here / "never").open().read()
evidence.write_text("whole %d" % seed)
pathlib.Path(arguments["--output"]).write_text(json.dumps({{"trials": [{{"seed": seed, "collisions": seed % 5}}]}}))
"""
# Has a worker take this program for smore_experiment.
PRELOAD = """from experiments import trials
import pathlib
trials.PROGRAM = pathlib.Path({program!r})
"""


class ClusterTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "program"
        self.program.write_text(PROGRAM.format(held=HELD))
        self.program.chmod(0o755)
        (self.folder / "preload.py").write_text(PRELOAD.format(program=str(self.program)))
        self.addCleanup(setattr, trials, "PROGRAM", trials.PROGRAM)
        trials.PROGRAM = self.program
        for pipe in ("started", "never"):
            os.mkfifo(self.folder / pipe)

    def start(self, module, *arguments):
        """A process of the cluster, and what it says."""
        environment = {**os.environ, "PYTHONPATH": str(ROOT / "python")}
        process = subprocess.Popen(
            [sys.executable, "-m", module, *arguments], cwd=self.folder, env=environment, stderr=subprocess.PIPE,
            text=True)
        self.addCleanup(process.wait)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        return process

    def start_cluster(self):
        """The scheduler's address, once it has two workers."""
        scheduler = self.start(
            "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")
        said = next(line for line in scheduler.stderr if "Scheduler at:" in line)
        address = said.split("Scheduler at:")[1].strip()
        threading.Thread(target=scheduler.stderr.read, daemon=True).start()
        for _ in range(2):
            worker = self.start(
                "distributed.cli.dask_worker", address, "--no-nanny", "--nthreads", "1", "--no-dashboard", "--preload",
                str(self.folder / "preload.py"))
            threading.Thread(target=worker.stderr.read, daemon=True).start()
        from distributed import Client

        with Client(address) as client:
            client.wait_for_workers(2, timeout=DEADLINE)
        return address

    def asked(self, where):
        return [recorded(f"t{seed}", "scene", seed, "smore", self.folder / where) for seed in range(1001, 1009)]

    def kill_who_holds(self, pipe):
        """Kills the worker that runs the trial that waits."""
        self.assertTrue(select.select([pipe], [], [], DEADLINE)[0], "no worker took the trial")
        worker, program = map(int, os.read(pipe, 100).split())
        self.addCleanup(os.kill, program, signal.SIGKILL)  # the worker's end leaves it waiting
        os.kill(worker, signal.SIGKILL)

    def test_a_worker_that_is_killed_costs_no_trial_and_doubles_none(self):
        alone = run(self.asked("alone"), self.folder / "alone", 2)
        address = self.start_cluster()
        (self.folder / "hold").touch()
        pipe = os.open(self.folder / "started", os.O_RDWR)
        self.addCleanup(os.close, pipe)
        killer = threading.Thread(target=self.kill_who_holds, args=(pipe,))
        killer.start()
        together = run(self.asked("together"), self.folder / "together", 2, address)
        killer.join()

        self.assertEqual(
            {name: record["result"] for name, record in together.items()},
            {name: record["result"] for name, record in alone.items()})
        lines = (self.folder / "together/trials.jsonl").read_text().splitlines()
        names = [json.loads(line)["trial"]["name"] for line in lines]
        self.assertEqual(sorted(names), sorted(alone))
        for trial in self.asked("together"):
            self.assertEqual(trial.evidence().read_text(), f"whole {trial.seed}")

    def test_a_scheduler_that_is_not_there_is_named(self):
        with self.assertRaisesRegex(workers.ClusterError, "tcp://127.0.0.1:1.*dask-scheduler"):
            run(self.asked("nowhere"), self.folder / "nowhere", 2, "tcp://127.0.0.1:1")


if __name__ == "__main__":
    unittest.main()
