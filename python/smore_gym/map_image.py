# SPDX-License-Identifier: BSD-3-Clause
"""Both maps of a trial as one picture, along the normal of the plane of motion (in space: from above)."""
import numpy as np

LOWEST = 240  # of a picture [pixel]
OCCUPIED = 0.5  # probability from which voxels of the object are laid on the world, as in the paper
UNKNOWN, GAP = (195, 206, 219), (255, 255, 255)
# From free to occupied, as python/plot_maps.py has them.
WORLD_COLORS = np.array([(0, 0, 0), (255, 255, 255)])
OBJECT_COLORS = np.array([(255, 240, 160), (245, 138, 46), (122, 0, 16)])
OBJECT, ORIGIN, GOAL = (242, 166, 90), (31, 63, 174), (142, 36, 170)


class Canvas:
    """A pixel for each voxel between two corners (x, y) [m]."""

    def __init__(self, low, high, voxel_size):
        self.low, self.voxel_size = np.asarray(low), voxel_size
        self.columns, self.rows = np.ceil((np.asarray(high) - low) / voxel_size).astype(int) + 1
        self.pixels = np.full((self.rows, self.columns, 3), UNKNOWN, dtype=np.uint8)

    def _places(self, points):
        """Row and column of points (n, 3), and which of them are on the canvas."""
        column, row = np.floor((points[:, :2] - self.low) / self.voxel_size).astype(int).T
        row = self.rows - 1 - row  # y points up
        return row, column, (row >= 0) & (row < self.rows) & (column >= 0) & (column < self.columns)

    def mark(self, points, color):
        row, column, inside = self._places(points)
        self.pixels[row[inside], column[inside]] = color

    def paint(self, points, probabilities, colors):
        """The most probable of all voxels that lie behind one another."""
        row, column, inside = self._places(points)
        highest = np.full(self.pixels.shape[:2], -1.0)
        np.maximum.at(highest, (row[inside], column[inside]), probabilities[inside])
        known = highest >= 0.0
        stops = np.linspace(0.0, 1.0, len(colors))
        for channel in range(3):
            self.pixels[known, channel] = np.interp(highest[known], stops, colors[:, channel]).round()


def moved(transform, points):
    return points @ transform[:3, :3].T + transform[:3, 3]


def world_canvas(trial, held):
    low, high = trial.workspace
    to_axes = np.linalg.inv(trial.axes)
    corners = np.array(np.meshgrid(*zip(low, high))).reshape(3, -1).T
    seen = moved(to_axes, corners)[:, :2]
    canvas = Canvas(seen.min(axis=0) - trial.reach, seen.max(axis=0) + trial.reach, trial.voxel_size)
    points, probabilities = trial.world_map()
    canvas.paint(moved(to_axes, points), probabilities, WORLD_COLORS)
    canvas.mark(moved(to_axes @ trial.pose, held), OBJECT)
    for pose, color in ((trial.goal, GOAL), (trial.pose, ORIGIN)):
        canvas.mark(moved(to_axes, pose[None, :3, 3]), color)
    return canvas


def map_image(trial):
    """(height, width, 3), bytes: the world, with the object as far as it is known where it is now, its origin and the
    goal's; beside it the object in its own frame."""
    points, probabilities = trial.object_map()
    reach = np.full(2, trial.reach)
    object_canvas = Canvas(-reach, reach, trial.voxel_size)
    object_canvas.paint(points, probabilities, OBJECT_COLORS)
    panels = [world_canvas(trial, points[probabilities >= OCCUPIED]).pixels, object_canvas.pixels]
    height = max(len(panel) for panel in panels)
    width = sum(panel.shape[1] for panel in panels) + 1
    picture = np.full((height, width, 3), GAP, dtype=np.uint8)
    picture[: len(panels[0]), : panels[0].shape[1]] = panels[0]
    picture[: len(panels[1]), -panels[1].shape[1]:] = panels[1]
    scale = -(-LOWEST // height)
    return picture.repeat(scale, axis=0).repeat(scale, axis=1)
