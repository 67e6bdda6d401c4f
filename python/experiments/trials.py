# SPDX-License-Identifier: BSD-3-Clause
"""Trials of smore_experiment, side by side, each kept as one line as soon as it is finished."""
import concurrent.futures
import dataclasses
import json
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import time

from experiments import workers
from program_fingerprint import fingerprint
from scene_fingerprint import scene_fingerprint

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

    def settings(self, directory, build):
        """All that its result depends on: equal wherever `directory` lies, and another one when a scene, a file of
        parameters or the program, whose fingerprint is `build`, has changed."""
        told = json.dumps(dataclasses.asdict(self), ensure_ascii=False).replace(str(directory), "DIR")
        return {**json.loads(told), "contents": scene_fingerprint(self.scenario, self.options), "program": build}

    def evidence(self):
        """The file that it records, or None."""
        if "--record" not in self.options:
            return None
        return pathlib.Path(self.options[self.options.index("--record") + 1], f"seed_{self.seed}.evidence")


def recorded(name, scenario, seed, method, directory, options=()):
    """A trial that records its evidence below `directory`."""
    return Trial(name, scenario, seed, method, ("--record", str(directory / "evidence" / name), *options))


def scene_with(scene, values):
    """The text of a scene of config/scenarios with other values of these keys."""
    text = (ROOT / f"config/scenarios/{scene}.yaml").read_text()
    for key, value in values.items():
        text = re.sub(rf"^{key}:.*\n", "", text, flags=re.MULTILINE).rstrip("\n") + f"\n{key}: {value}\n"
    return text


def unperturbed(scene, directory):
    """The path of a file with a scene of config/scenarios as it stands there, written to `directory`: a trial's own
    shift of it is not in what pictures know of a scene."""
    directory.mkdir(parents=True, exist_ok=True)
    file = directory / f"{scene}.yaml"
    text = (ROOT / f"config/scenarios/{scene}.yaml").read_text()
    file.write_text(re.sub(r"^perturb:.*\n", "", text, flags=re.MULTILINE))
    return str(file)


def evidence_of(record):
    """The file that a trial recorded, by its line in the store."""
    return Trial(**record["trial"]).evidence()


class TrialError(RuntimeError):
    """A trial that did not run; the message is the program's."""


class Store:
    """Finished trials in a file of JSON lines. A line that was cut while it was written does not count, nor does one
    that is damaged."""

    def __init__(self, directory):
        directory.mkdir(parents=True, exist_ok=True)
        self.directory = directory
        self.build = fingerprint(PROGRAM)
        self.file = directory / "trials.jsonl"
        self.finished = {}
        text = self.file.read_text(encoding="utf-8", errors="replace") if self.file.exists() else ""
        whole = text[: text.rfind("\n") + 1]
        for number, line in enumerate(whole.splitlines(), 1):
            try:
                record = json.loads(line)
                self.finished[record["trial"]["name"]] = record
            except (ValueError, KeyError, TypeError):
                print(f"{self.file}: line {number} is damaged; its trial is run again", file=sys.stderr)
        if whole != text:
            self.file.write_text(whole)

    def settings(self, trial):
        return trial.settings(self.directory, self.build)

    def knows(self, trial):
        """Whether this very trial is finished: another of its name, of other settings, is not, nor is one whose record
        is gone."""
        record = self.finished.get(trial.name)
        if record is None or record.get("settings") != self.settings(trial):
            return False
        return trial.evidence() is None or trial.evidence().exists()

    def add(self, trial, settings, result):
        line = json.dumps({"trial": dataclasses.asdict(trial), "settings": settings, "result": result})
        with self.file.open("a") as stream:
            stream.write(line + "\n")
        self.finished[trial.name] = json.loads(line)


class Progress:
    """How far it is, and about how long it will take, on standard error."""

    def __init__(self, done, count):
        self.first, self.done, self.count, self.begin = done, done, count, time.monotonic()
        if done < count:
            self._show("")

    def step(self):
        self.done += 1
        rate = (time.monotonic() - self.begin) / (self.done - self.first)
        self._show(f", about {rate * (self.count - self.done) / 60.0:.0f} min left ")

    def _show(self, left):
        filled = 30 * self.done // self.count
        bar = "#" * filled + "." * (30 - filled)
        end = "\n" if self.done == self.count or not sys.stderr.isatty() else ""
        print(f"\r[{bar}] {self.done} of {self.count} trials{left}", end=end, file=sys.stderr)


def why_not(done, output):
    """Why a trial has no result: a trial that broke off says so in its output, all else is the program's last word."""
    try:
        return json.loads(output.read_text())["trials"][0]["reason"]
    except (OSError, ValueError, LookupError):
        said = done.stderr.strip().splitlines()
        return said[-1] if said else f"exit code {done.returncode}"


def require_same(trial, directory, settings):
    """TrialError where program or scene are not those that the trial was asked for with."""
    if trial.settings(directory, fingerprint(PROGRAM)) != settings:
        raise TrialError(f"{trial.name}: program or scene on {socket.gethostname()} differ from those that it was asked "
                         "for with; give all machines the same build, change nothing meanwhile, and run this again")


def run_one(trial, directory, settings):
    """The result of a trial of these settings, before it and after. Its evidence is there when it is whole: of a
    machine that is lost another one repeats the trial, while the first may still be writing."""
    require_same(trial, directory, settings)
    evidence = trial.evidence()
    if evidence:
        evidence.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=evidence and evidence.parent) as folder:
        output = pathlib.Path(folder) / "result.json"
        command = [folder if evidence and word == str(evidence.parent) else word for word in trial.command(output)]
        done = subprocess.run(command, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise TrialError(f"{trial.name}: {why_not(done, output)}")
        require_same(trial, directory, settings)
        if evidence:
            (pathlib.Path(folder) / evidence.name).replace(evidence)
        return json.loads(output.read_text())["trials"][0]


def collect(asked, store, progress):
    """Adds to the store what is found, as soon as it is; what the others said."""
    problems = []
    try:
        for future in concurrent.futures.as_completed(asked):
            if future.exception():
                problems.append(str(future.exception()))
            else:
                store.add(*asked[future], future.result())
            progress.step()
    finally:
        for future in asked:
            future.cancel()  # interrupted, only what is running ends
    return problems


def keep_finished(asked, store):
    """Adds to the store what has been found and is not there yet."""
    for future, (trial, settings) in asked.items():
        if future.done() and not future.cancelled() and not future.exception() and not store.knows(trial):
            store.add(trial, settings, future.result())


def run(trials, directory, jobs, scheduler=None):
    """Records of all trials by their names. Those in `directory` already are not run again; where some fail the others
    are finished first, then TrialError. ClusterError where there is no such scheduler (experiments/workers.py)."""
    store = Store(directory)
    left = [trial for trial in trials if not store.knows(trial)]
    progress = Progress(len(trials) - len(left), len(trials))
    asked = {}
    try:
        with workers.executor(jobs, scheduler) as executor:
            for trial in left:
                settings = store.settings(trial)
                asked[executor.submit(run_one, trial, directory, settings)] = (trial, settings)
            problems = collect(asked, store, progress)
    finally:
        keep_finished(asked, store)  # interrupted, some may have ended unseen
    if problems:
        raise TrialError("\n".join(problems))
    # With the paths that are now: the directory may have been moved.
    return {trial.name: {**store.finished[trial.name], "trial": dataclasses.asdict(trial)} for trial in trials}
