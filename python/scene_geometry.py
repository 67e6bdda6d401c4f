# SPDX-License-Identifier: BSD-3-Clause
"""The solids of a scenario as triangles, and their outlines in a plane."""
import numpy as np

from scene_file import SceneFileError, read_scene

MASK_CELLS = 400  # along the longer side of the grids that outlines are drawn from
DEPTHS = 8  # evenly through a body, at which its cuts are compared
COARSE_CELLS = 60  # of the grids of these cuts


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
    pose[:3, :3] = rotation_of(mapping["rpy"])
    pose[:3, 3] = mapping["position"]
    return pose


def transform(pose, points):
    return points @ pose[:3, :3].T + pose[:3, 3]


def triangles_of(body):
    """Triangles (n, 3, 3) of each solid of a body in its parent frame [m]."""
    return [np.array(shape["triangles"], dtype=float).reshape(-1, 3, 3) for shape in body["shapes"]]


class Scene:
    """A scenario, as far as pictures need it: a name in config/scenarios, a scenario file, or the file
    that smore_experiment --validate --output wrote of one."""

    def __init__(self, name_or_path):
        settings = read_scene(name_or_path)
        self.name = settings["name"]
        self.planar = settings["motion"] == "planar"
        self.start = pose_of(settings["start"])
        self.goal = pose_of(settings["goal"])
        self.workspace = tuple(np.array(settings["workspace"][end], dtype=float) for end in ("min", "max"))
        if "object" not in settings:
            raise SceneFileError(f"{self.name} is a task: it has no object and no environment to draw")
        self.object = triangles_of(settings["object"])
        self.environment = triangles_of(settings["environment"])


class View:
    """An orthogonal look at a scene: coordinates to the right, upwards and along the line of sight. `depth` names
    the last: an axis, with a minus where it comes towards the viewer."""

    def __init__(self, right, up, labels=("x", "y"), depth=""):
        self.depth = depth
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


def _seen(solids, view):
    return [view.project(triangles.reshape(-1, 3)).reshape(-1, 3, 3) for triangles in solids]


def fullest_depth(solids, view):
    """Depth along the line of sight at which most of the solids is cut [m]."""
    ranges = [(seen[:, :, 2].min(), seen[:, :, 2].max()) for seen in _seen(solids, view)]
    low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
    depths = [0.5 * (r[0] + r[1]) for r in ranges]
    depths += [low + (high - low) * (i + 0.5) / DEPTHS for i in range(DEPTHS)]
    return max(depths, key=lambda depth: outline_mask(solids, view, depth, COARSE_CELLS)[2].sum())


def outline_mask(solids, view, depth=None, cells=MASK_CELLS):
    """Grid coordinates (right, up) and a mask of the union of the solids: their cut at `depth` along the
    line of sight, or their silhouette where it is None. `cells` along the longer side. None for no solids."""
    if not solids:
        return None
    seen = _seen(solids, view)
    corners = np.concatenate(seen).reshape(-1, 3)[:, :2]
    cell = np.ptp(corners, axis=0).max() / cells
    low, high = corners.min(axis=0) - 3 * cell, corners.max(axis=0) + 3 * cell
    right, up = (np.arange(low[i], high[i], cell) for i in range(2))
    points = np.stack(np.meshgrid(right, up), -1).reshape(-1, 2)
    mask = np.zeros(len(points), dtype=bool)
    for triangles in seen:
        if depth is None:
            mask |= _inside_silhouette(points, triangles)
        else:
            mask |= _inside_slice(points, _slice(triangles, depth))
    return right, up, mask.reshape(len(up), len(right))
