# SPDX-License-Identifier: BSD-3-Clause
"""Reads OctoMap's full tree files (.ot) without OctoMap.

A file is a text header (id, size, resolution) and the nodes in depth-first order: the log odds of each
as a 32-bit float, then a byte that tells by its bits which of the eight children follow. Bit 0 of a
child's number is its half along x, bit 1 along y, bit 2 along z.
"""
import struct

import numpy as np

TREE_DEPTH = 16
KEY_ORIGIN = 1 << (TREE_DEPTH - 1)
NODE = struct.Struct("<fB")
FIRST_LINE = b"# Octomap OcTree file"
OCCUPIED = 0.5  # probability from which a voxel counts as matter, as in the paper


class OctreeFileError(Exception):
    """The file is no tree that this reader knows; the message names the file and what is wrong."""


def _header(file, name):
    if file.readline().rstrip() != FIRST_LINE:
        raise OctreeFileError(f"{name}: not an OctoMap tree file (.ot)")
    fields = {}
    for raw in file:
        line = raw.decode("ascii", errors="replace").split("#")[0].split()
        if line == ["data"]:
            break
        if len(line) == 2:
            fields[line[0]] = line[1]
    try:
        kind, size, resolution = fields["id"], int(fields["size"]), float(fields["res"])
    except (KeyError, ValueError) as problem:
        raise OctreeFileError(f"{name}: the header lacks id, size or res") from problem
    if kind != "OcTree" or resolution <= 0.0:
        raise OctreeFileError(f"{name}: a tree of type {kind}, resolution {resolution}; expected OcTree")
    return size, resolution


def _leaves(data, size, name):
    """Lowest key, span in voxels and log odds of each leaf. Keys count from the tree's corner."""
    leaves = []
    # (key, depth) of the nodes to come, the next one last.
    pending = [((0, 0, 0), 0)] if size else []
    offset = 0
    while pending:
        key, depth = pending.pop()
        if offset + NODE.size > len(data) or depth > TREE_DEPTH:
            raise OctreeFileError(f"{name}: cut short or damaged at node {offset // NODE.size}")
        log_odds, children = NODE.unpack_from(data, offset)
        offset += NODE.size
        span = 1 << (TREE_DEPTH - depth)
        if not children:
            leaves.append((key, span, log_odds))
        half = span // 2
        for child in range(7, -1, -1):
            if children >> child & 1:
                corner = tuple(key[axis] + half * (child >> axis & 1) for axis in range(3))
                pending.append((corner, depth + 1))
    if offset != len(data) or offset != size * NODE.size:
        raise OctreeFileError(f"{name}: {len(data) // NODE.size} nodes, but the header says {size}")
    return leaves


def read_octree(name):
    """Centres [m] (n, 3), edge lengths [m] (n,) and probabilities (n,) of the leaves, and the voxel size."""
    with open(name, "rb") as file:
        size, resolution = _header(file, name)
        leaves = _leaves(file.read(), size, name)
    keys = np.array([key for key, _, _ in leaves], dtype=float).reshape(-1, 3)
    spans = np.array([span for _, span, _ in leaves], dtype=float)
    log_odds = np.array([value for _, _, value in leaves], dtype=float)
    centers = (keys - KEY_ORIGIN + spans[:, None] / 2.0) * resolution
    return centers, spans * resolution, 1.0 / (1.0 + np.exp(-log_odds)), resolution
