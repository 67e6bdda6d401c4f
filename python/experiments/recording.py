# SPDX-License-Identifier: BSD-3-Clause
"""A recorded retrieval (docs/evidence.md): its motions, and the maps as they were before each of them."""
import dataclasses
import json
import subprocess

import numpy as np
import octree_file

from experiments import trials

POSES_APART = 25  # samples between poses that are kept of a motion: 5 mm at 0.1 m/s
FREE = b'"state":"free"'  # most lines of a file: only those that are kept are parsed


def pose_of(numbers):
    """4 x 4 matrix of the twelve numbers of a record."""
    return np.vstack([np.array(numbers).reshape(3, 4), (0, 0, 0, 1)])


@dataclasses.dataclass
class Motion:
    """A planned motion and what came of it. Poses are those of the object in the world."""

    plan: list  # poses
    begins_at: int  # bytes of the file before its record
    way: list = dataclasses.field(default_factory=list)  # poses, up to the last one
    touched: bool = False
    line: tuple = None  # of action: a point and a direction, in the world
    places: np.ndarray = None  # true points of the contact, in the world


class Recording:
    """What a file of evidence says, motion by motion."""

    def __init__(self, file):
        self.file = file
        self.motions = []
        self._under_way = False
        self._samples = 0
        self._pose = None  # of the last observation that was parsed
        offset = 0
        with open(file, "rb") as stream:
            for line in stream:
                self._take(line, offset)
                offset += len(line)
        self.size = offset

    def _take(self, line, offset):
        if FREE in line:
            self._samples += 1
            if not self._under_way or self._samples % POSES_APART:
                return
        record = json.loads(line)
        kind = record.get("record")
        if kind == "motion":
            self.motions.append(Motion([pose_of(pose) for pose in record["path"]], offset))
            self._under_way = True
        elif kind == "motion_end":
            motion = self.motions[-1]
            motion.way.append(pose_of(record["pose"]))
            motion.touched = record["end"] == "contact"
            self._under_way = False
        elif kind == "observation" and self.motions:
            self._observe(record, self.motions[-1])
        elif kind == "truth" and "contact" in record and self.motions:
            self.motions[-1].places = np.array([point["position"] for point in record["points"]])

    def _observe(self, record, motion):
        pose = pose_of(record["pose"])
        if self._under_way:
            motion.way.append(pose)
        if "line" in record:
            point, direction = (np.array(record["line"][key]) for key in ("point", "direction"))
            motion.line = pose[:3, :3] @ point + pose[:3, 3], pose[:3, :3] @ direction

    def contacts_before(self, index):
        """How many motions before this one touched."""
        return sum(motion.touched for motion in self.motions[:index])

    def touches(self, index):
        """The motions before this one that touched."""
        return [motion for motion in self.motions[:index] if motion.touched]

    def maps_before(self, index, directory):
        """World and object as octree_file reads them, from all that had been observed before this motion, or in all
        where there is none of this number."""
        end = self.motions[index].begins_at if index < len(self.motions) else self.size
        output = directory / f"before_motion_{index}"
        directory.mkdir(parents=True, exist_ok=True)
        if not is_newer(output / "summary.json", self.file):
            cut = directory / f"before_motion_{index}.evidence"
            with open(self.file, "rb") as whole, open(cut, "wb") as part:
                part.write(whole.read(end))
            rebuild(cut, output)
            cut.unlink()
        return [octree_file.read_octree(output / f"{side}.ot") for side in ("world", "object")]


def is_newer(file, than):
    return file.exists() and file.stat().st_mtime > than.stat().st_mtime


def rebuild(evidence, output):
    """Makes the maps of a file of evidence; subprocess.CalledProcessError where that fails."""
    program = trials.PROGRAM.parent / "smore_rebuild"
    subprocess.run([str(program), "--evidence", str(evidence), "--output", str(output)], check=True)


def moments(recording, count):
    """Indices of so many motions: the first, the last, and between them ever farther apart."""
    last = len(recording.motions) - 1
    later = np.geomspace(1, max(last, 1), count)[1:].round().astype(int)
    return sorted({0, *(min(int(index), last) for index in later)})
