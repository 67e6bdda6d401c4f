# SPDX-License-Identifier: BSD-3-Clause
"""Trials of smore_experiment, side by side, each kept as one line as soon as it is finished."""
import concurrent.futures
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/devel/lib/smore/smore_experiment"


def reported_seeds(count, first=1001):
    """Seeds of results that are reported: below 1000 parameters are chosen."""
    return range(first, first + count)


@dataclasses.dataclass(frozen=True)
class Trial:
    """One trial; `name` tells it from the others of its experiment."""

    name: str
    scenario: str
    seed: int
    method: str = "smore"
    options: tuple = ()

    def command(self, output):
        return [
            str(PROGRAM), "--scenario", self.scenario, "--seed", str(self.seed), "--method", self.method,
            *self.options, "--output", str(output),
        ]

    def evidence(self):
        """The file that it records, or None."""
        if "--record" not in self.options:
            return None
        return pathlib.Path(self.options[self.options.index("--record") + 1], f"seed_{self.seed}.evidence")


def recorded(name, scenario, seed, method, directory, options=()):
    """A trial that records its evidence below `directory`."""
    return Trial(name, scenario, seed, method, ("--record", str(directory / "evidence" / name), *options))


def evidence_of(record):
    """The file that a trial recorded, by its line in the store."""
    return Trial(**record["trial"]).evidence()


class TrialError(RuntimeError):
    """A trial that did not run; the message is the program's."""


class Store:
    """Finished trials in a file of JSON lines. A line that was cut while it was written does not count."""

    def __init__(self, directory):
        directory.mkdir(parents=True, exist_ok=True)
        self.file = directory / "trials.jsonl"
        self.lock = threading.Lock()
        self.finished = {}
        text = self.file.read_text() if self.file.exists() else ""
        whole = text[: text.rfind("\n") + 1]
        for line in whole.splitlines():
            record = json.loads(line)
            self.finished[record["trial"]["name"]] = record
        if whole != text:
            self.file.write_text(whole)

    def knows(self, trial):
        """Whether this very trial is finished: another of its name, of other settings, is not, nor is one whose record
        is gone."""
        record = self.finished.get(trial.name)
        if record is None or record["trial"] != json.loads(json.dumps(dataclasses.asdict(trial))):
            return False
        return trial.evidence() is None or trial.evidence().exists()

    def add(self, trial, result):
        record = {"trial": dataclasses.asdict(trial), "result": result}
        with self.lock, self.file.open("a") as stream:
            stream.write(json.dumps(record) + "\n")
            self.finished[trial.name] = record


class Progress:
    """How far it is, and about how long it will take, on standard error."""

    def __init__(self, done, count):
        self.first, self.done, self.count, self.begin = done, done, count, time.monotonic()

    def step(self):
        self.done += 1
        rate = (time.monotonic() - self.begin) / (self.done - self.first)
        left = rate * (self.count - self.done) / 60.0
        filled = 30 * self.done // self.count
        bar = "#" * filled + "." * (30 - filled)
        end = "\n" if self.done == self.count or not sys.stderr.isatty() else ""
        print(f"\r[{bar}] {self.done} of {self.count} trials, about {left:.0f} min left ", end=end, file=sys.stderr)


def run_one(trial):
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "result.json"
        done = subprocess.run(trial.command(output), stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            said = done.stderr.strip().splitlines()
            raise TrialError(f"{trial.name}: {said[-1] if said else f'exit code {done.returncode}'}")
        return json.loads(output.read_text())["trials"][0]


def run(trials, directory, jobs):
    """Records of all trials by their names. Those in `directory` already are not run again; where some fail the others
    are finished first, then TrialError."""
    store = Store(directory)
    left = [trial for trial in trials if not store.knows(trial)]
    progress = Progress(len(trials) - len(left), len(trials))
    problems = []

    def work(trial):
        store.add(trial, run_one(trial))

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for future in concurrent.futures.as_completed([pool.submit(work, trial) for trial in left]):
            if future.exception():
                problems.append(str(future.exception()))
            progress.step()
    if problems:
        raise TrialError("\n".join(problems))
    return {trial.name: store.finished[trial.name] for trial in trials}
