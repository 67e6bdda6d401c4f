# SPDX-License-Identifier: BSD-3-Clause
"""The methods that experiments compare, and the scenes in which some of them are told the object's shape."""
import dataclasses
import statistics

from experiments.trials import ROOT, Trial


@dataclasses.dataclass(frozen=True)
class Method:
    """A method of smore_experiment; `told`: with the object's true shape known beforehand."""

    name: str
    what: str
    told: bool = False


METHODS = {
    "smore": Method("smore", "joint belief over all contacts, least risk"),
    "paper": Method("paper", "the paper's laws in sequence, RRT (in space RRT-Connect) around occupied voxels"),
    "cspace": Method("cspace", "the paper's baseline: RRT around the poses of contacts"),
    "blocked": Method("blocked", "a probability map over configurations (Pajarinen et al., 2020)"),
    "chs": Method("chs", "collision hypothesis sets, told the object (Saund and Berenson, 2018)", told=True),
    "smore_told": Method("smore", "smore, told the object as well", told=True),
}


def label(method, form="{}"):
    """What tables and figures call a method of this list, its name in a form of its own."""
    chosen = METHODS[method]
    return form.format(chosen.name) + (", told the object" if chosen.told else "")


# Of collisions, at which methods are given up: chs finds no further way, plans of blocked take ever longer.
LIMITS = {"chs": 100, "blocked": 100}


def limited(method, most=None):
    """Options of smore_experiment for a trial of a method of this list: given up at `most` collisions, where there is
    such a number, and at its own limit."""
    limits = [limit for limit in (most, LIMITS.get(method)) if limit]
    return ("--max-collisions", str(min(limits))) if limits else ()


def told_scene(directory, scene):
    """The path of a file that says of a scene of config/scenarios that its object is known, written to `directory`."""
    directory.mkdir(parents=True, exist_ok=True)
    file = directory / f"{scene}_told.yaml"
    text = (ROOT / f"config/scenarios/{scene}.yaml").read_text()
    file.write_text(text.rstrip("\n") + "\nprior: {object: [{source: truth}]}\n")
    return str(file)


def trial(directory, scene, method, seed, options=()):
    """A trial of a method of this list on a scene of config/scenarios."""
    chosen = METHODS[method]
    scenario = told_scene(directory / "scenes", scene) if chosen.told else scene
    return Trial(f"{scene}/{method}/{seed}", scenario, seed, chosen.name, tuple(options))


def results_of(records):
    """The results of such trials by scene and method, in the order of the trials."""
    results = {}
    for name, record in records.items():
        scene, method, _seed = name.split("/")
        results.setdefault(scene, {}).setdefault(method, []).append(record["result"])
    return results


def row(results):
    """Mean, median, least and most collisions of the trials that reached the goal, and how many did."""
    reached = [result["collisions"] for result in results if result["success"]]
    share = f"{len(reached)} of {len(results)}"
    if not reached:
        return f"- | - | - | - | {share}"
    mean, median = statistics.mean(reached), statistics.median(reached)
    return f"{mean:.1f} | {median:.0f} | {min(reached)} | {max(reached)} | {share}"


ROW_HEAD = "mean | median | least | most | at the goal"
