# SPDX-License-Identifier: BSD-3-Clause
"""The solids of a scenario file as triangles, and their outlines in a plane."""
import pathlib
import struct

import numpy as np
import yaml

ROUND_FACETS = 96  # of circles: their polygon is within 0.1 % of the radius
MASK_CELL = 0.002  # of the grids that outlines are drawn from [m]


def rotation_of(rpy):
    """Roll, pitch, yaw about the fixed axes x, y, z, as in scenario files and URDF."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(rpy), np.sin(rpy)
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def pose_of(mapping):
    """4 x 4 matrix of {position, rpy}."""
    pose = np.eye(4)
    pose[:3, :3] = rotation_of(mapping.get("rpy", [0, 0, 0]))
    pose[:3, 3] = mapping["position"]
    return pose


def transform(pose, points):
    return points @ pose[:3, :3].T + pose[:3, 3]


def _surface_of_rings(rings):
    """Triangles between neighbouring rings of equally many points, and fans that close both ends."""
    triangles = []
    for lower, upper in zip(rings[:-1], rings[1:]):
        for i in range(len(lower)):
            j = (i + 1) % len(lower)
            triangles += [(lower[i], lower[j], upper[j]), (lower[i], upper[j], upper[i])]
    for ring in (rings[0], rings[-1]):
        center = np.mean(ring, axis=0)
        triangles += [(center, ring[i], ring[(i + 1) % len(ring)]) for i in range(len(ring))]
    return np.array(triangles)


def _ring(radius, z, angles):
    return np.stack([radius * np.cos(angles), radius * np.sin(angles), np.full_like(angles, z)], 1)


def _box(shape):
    x, y, z = np.array(shape["size"], dtype=float) / 2.0
    corners = np.array([[x, y, 0], [-x, y, 0], [-x, -y, 0], [x, -y, 0]])
    return _surface_of_rings([corners - [0, 0, z], corners + [0, 0, z]])


def _cylinder(shape):
    angles = np.linspace(0.0, 2.0 * np.pi, ROUND_FACETS, endpoint=False)
    half = shape["length"] / 2.0
    return _surface_of_rings([_ring(shape["radius"], z, angles) for z in (-half, half)])


def _sphere(shape):
    angles = np.linspace(0.0, 2.0 * np.pi, ROUND_FACETS, endpoint=False)
    latitudes = np.linspace(-np.pi / 2.0, np.pi / 2.0, ROUND_FACETS // 2)
    radius = shape["radius"]
    return _surface_of_rings(
        [_ring(radius * np.cos(a), radius * np.sin(a), angles) for a in latitudes]
    )


def _read_obj(text):
    vertices, triangles = [], []
    for words in map(str.split, text.splitlines()):
        if words[:1] == ["v"]:
            vertices.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            numbers = [int(word.split("/")[0]) for word in words[1:]]
            corners = [number - 1 if number > 0 else number for number in numbers]
            fans = zip(corners[1:-1], corners[2:])
            triangles += [[vertices[i] for i in (corners[0], b, c)] for b, c in fans]
    return np.array(triangles)


def _read_stl(data):
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("extra", "<u2")])
        return np.frombuffer(data, facet, count, 84)["corners"].astype(float)
    words = data.decode("ascii", errors="replace").split()
    starts = [i for i, word in enumerate(words) if word == "vertex"]
    return np.array([[float(w) for w in words[i + 1 : i + 4]] for i in starts]).reshape(-1, 3, 3)


def _mesh(shape, folder):
    file = pathlib.Path(folder, shape["file"])
    is_obj = file.suffix.lower() == ".obj"
    triangles = _read_obj(file.read_text()) if is_obj else _read_stl(file.read_bytes())
    return triangles * np.array(shape.get("scale", [1, 1, 1]), dtype=float)


def triangles_of(shape, folder):
    """Triangles (n, 3, 3) of one solid in its parent frame [m]."""
    if shape["type"] == "mesh":
        local = _mesh(shape, folder)
    else:
        local = {"box": _box, "cylinder": _cylinder, "sphere": _sphere}[shape["type"]](shape)
    pose = pose_of({"position": shape.get("position", [0, 0, 0]), "rpy": shape.get("rpy", [0, 0, 0])})
    return transform(pose, local.reshape(-1, 3)).reshape(-1, 3, 3)


class Scene:
    """A scenario file, as far as pictures need it."""

    def __init__(self, file):
        self.settings = yaml.safe_load(pathlib.Path(file).read_text())
        folder = pathlib.Path(file).parent
        self.name = self.settings["name"]
        self.planar = self.settings.get("motion", "planar") == "planar"
        self.start = pose_of(self.settings["start"])
        self.goal = pose_of(self.settings["goal"])
        self.object = [triangles_of(s, folder) for s in self.settings["object"]["shapes"]]
        self.environment = [triangles_of(s, folder) for s in self.settings["environment"]["shapes"]]


class View:
    """An orthogonal look at a scene: coordinates to the right, upwards and along the line of sight."""

    def __init__(self, right, up, labels=("x", "y")):
        self.axes = np.stack([right, up, np.cross(right, up)])
        self.labels = labels

    def project(self, points):
        return points @ self.axes.T


def _slice(triangles, depth):
    """Segments (n, 2, 2) in which triangles, in the view's coordinates, cut the plane at `depth`."""
    segments = []
    for corners in triangles:
        heights = corners[:, 2] - depth
        ends = []
        for i in range(3):
            j = (i + 1) % 3
            if (heights[i] > 0.0) != (heights[j] > 0.0):
                share = heights[i] / (heights[i] - heights[j])
                ends.append((corners[i] + share * (corners[j] - corners[i]))[:2])
        if len(ends) == 2:
            segments.append(ends)
    return np.array(segments).reshape(-1, 2, 2)


def _inside_slice(points, segments):
    """Whether points are inside the closed curves of the segments (crossings of a ray upwards)."""
    inside = np.zeros(len(points), dtype=bool)
    for a, b in segments:
        spans = (a[0] > points[:, 0]) != (b[0] > points[:, 0])
        if np.any(spans):
            height = a[1] + (points[spans, 0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1])
            inside[spans] ^= height > points[spans, 1]
    return inside


def _inside_triangle(points, corners):
    a, b, c = corners
    sides = [
        (q[0] - p[0]) * (points[:, 1] - p[1]) - (q[1] - p[1]) * (points[:, 0] - p[0])
        for p, q in ((a, b), (b, c), (c, a))
    ]
    return np.all(np.array(sides) >= 0.0, axis=0) | np.all(np.array(sides) <= 0.0, axis=0)


def _inside_silhouette(points, triangles):
    inside = np.zeros(len(points), dtype=bool)
    for corners in triangles[:, :, :2]:
        low, high = corners.min(axis=0), corners.max(axis=0)
        near = np.flatnonzero(np.all((points >= low) & (points <= high) & ~inside[:, None], axis=1))
        inside[near] = _inside_triangle(points[near], corners)
    return inside


def outline_mask(solids, view, depth=None):
    """Grid coordinates (right, up) and a mask of the union of the solids: their cut at `depth` along the
    line of sight, or their silhouette where it is None. None for no solids."""
    if not solids:
        return None
    seen = [view.project(triangles.reshape(-1, 3)).reshape(-1, 3, 3) for triangles in solids]
    corners = np.concatenate(seen).reshape(-1, 3)[:, :2]
    low, high = corners.min(axis=0) - 3 * MASK_CELL, corners.max(axis=0) + 3 * MASK_CELL
    right, up = (np.arange(low[i], high[i], MASK_CELL) for i in range(2))
    points = np.stack(np.meshgrid(right, up), -1).reshape(-1, 2)
    mask = np.zeros(len(points), dtype=bool)
    for triangles in seen:
        if depth is None:
            mask |= _inside_silhouette(points, triangles)
        else:
            mask |= _inside_slice(points, _slice(triangles, depth))
    return right, up, mask.reshape(len(up), len(right))
