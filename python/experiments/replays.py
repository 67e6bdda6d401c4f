# SPDX-License-Identifier: BSD-3-Clause
"""Recorded evidence (docs/evidence.md) told anew: with fewer free poses, or with its motions in another order."""
import random

from experiments.recording import FREE, is_newer, rebuild

MOTION = b'"record":"motion"'
OUTCOME = b'"record":"outcome"'


def thinned(lines, one_in):
    """Of the observations of free poses every `one_in`-th."""
    count, kept = 0, []
    for line in lines:
        if FREE in line:
            count += 1
            if count % one_in:
                continue
        kept.append(line)
    return kept


def reordered(lines, seed):
    """The motions, each with all that was observed until the next one, in an order that follows from a seed."""
    begins = [number for number, line in enumerate(lines) if MOTION in line]
    if not begins:
        return list(lines)
    ends = [*begins[1:], next((number for number, line in enumerate(lines) if OUTCOME in line), len(lines))]
    motions = list(zip(begins, ends))
    random.Random(seed).shuffle(motions)
    middle = [line for begin, end in motions for line in lines[begin:end]]
    return [*lines[: begins[0]], *middle, *lines[ends[-1]:]]


def maps_of(evidence, change, output):
    """Makes the maps of a file of evidence whose lines `change` has changed in the directory `output`, where they are
    not yet; returns it."""
    if not is_newer(output / "summary.json", evidence):
        output.mkdir(parents=True, exist_ok=True)
        told = output / "told.evidence"
        told.write_bytes(b"".join(change(evidence.read_bytes().splitlines(keepends=True))))
        rebuild(told, output)
        told.unlink()
    return output
