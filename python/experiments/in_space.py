# SPDX-License-Identifier: BSD-3-Clause
"""Solids and occupied voxels in three dimensions."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

TICKS = 3  # of the longest axis
FLAT = 0.99  # cosine of the angle between two triangles that are drawn as one face


def edges_of(triangles):
    """Edges between triangles that are not in one plane: what one draws of a box."""
    planes = {}
    for corners in triangles:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal = normal / np.linalg.norm(normal)
        for i in range(3):
            ends = sorted(tuple(corner.round(6)) for corner in (corners[i], corners[(i + 1) % 3]))
            planes.setdefault(tuple(ends), []).append(normal)
    return [np.array(ends) for ends, normals in planes.items() if len(normals) < 2 or normals[0] @ normals[1] < FLAT]


def draw_edges(axes, solids, color="black", width=0.7):
    """The edges of solids, each a list of triangles."""
    edges = [edge for solid in solids for edge in edges_of(solid)]
    axes.add_collection3d(Line3DCollection(edges, colors=color, linewidths=width))


def draw_solids(axes, solids, color, opacity):
    """Solids that let through what is behind them, and their edges."""
    for solid in solids:
        axes.add_collection3d(Poly3DCollection(solid, facecolors=color, alpha=opacity, linewidths=0))
    draw_edges(axes, solids, color)


def draw_voxels(axes, centers, voxel):
    """Occupied voxels as cubes, the highest lightest."""
    if not len(centers):
        return
    low = np.floor(centers.min(axis=0) / voxel).astype(int)
    cells = np.floor(centers / voxel).astype(int) - low
    filled = np.zeros(cells.max(axis=0) + 1, dtype=bool)
    filled[tuple(cells.T)] = True
    corners = [(np.arange(count + 1) + first) * voxel for count, first in zip(filled.shape, low)]
    height = np.broadcast_to(np.linspace(0.2, 0.9, filled.shape[2]), filled.shape)
    axes.voxels(
        *np.meshgrid(*corners, indexing="ij"), filled, facecolors=plt.cm.viridis(height), edgecolor="#333333",
        linewidth=0.2)


def set_up(axes, points, elevation, azimuth):
    """Axes in metres, equally long units, around some points."""
    low, high = points.min(axis=0), points.max(axis=0)
    axes.set_box_aspect(high - low)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    for name, label in (("x", axes.set_xlabel), ("y", axes.set_ylabel), ("z", axes.set_zlabel)):
        label(f"{name} [m]", fontsize=8)
    axes.view_init(elev=elevation, azim=azimuth)
    axes.tick_params(labelsize=6.5, pad=1)
    shares = (high - low) / (high - low).max()
    for axis, share in zip((axes.xaxis, axes.yaxis, axes.zaxis), shares):
        axis.set_major_locator(MaxNLocator(max(1, round(TICKS * share))))
    rest = [tick for tick in axes.get_yticks() if low[1] <= tick <= high[1]][1:]
    if rest:  # where y begins x ends, and their numbers would meet
        axes.set_yticks(rest)
