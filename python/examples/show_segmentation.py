# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""show_segmentation.py INPUT OUTPUT.png: a picture of the segments of a mesh of triangles, their borders and their tree."""

import sys

import matplotlib
import meshio
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection  # noqa: E402

import protrusion_segmentation


def draw_mesh(axes, vertices, faces, found, colors):
    """The segments in their colours, with light from above, and the borders as lines."""
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    light = 0.6 + 0.4 * normals @ (0.36, -0.48, 0.8)
    rgb = colors[found.labels] * light[:, None]
    axes.add_collection3d(Poly3DCollection(corners, facecolors=rgb, edgecolors=rgb, linewidths=0.2))
    lines = [np.concatenate([b.points, b.points[:1]]) if b.is_closed else b.points for b in found.borders]
    axes.add_collection3d(Line3DCollection(lines, colors="black", linewidths=1.5))
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    for set_limits, a, b in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), low, high):
        set_limits(a, b)
    axes.set_box_aspect(high - low)
    axes.set_axis_off()


def draw_tree(axes, found, colors):
    """Each segment above what it sticks out of, with the probability of the border between them."""
    parents = found.parents
    depths = np.zeros(parents.size, int)
    for _ in range(parents.size):
        depths = np.where(parents == np.arange(parents.size), 0, depths[parents] + 1)
    places = np.zeros(parents.size)
    for depth in range(depths.max() + 1):
        here = np.flatnonzero(depths == depth)
        here = here[np.argsort(places[parents[here]], kind="stable")]
        places[here] = (np.arange(here.size) + 0.5) / here.size
    for s, parent in enumerate(parents):
        if parent != s:
            axes.plot(places[[parent, s]], depths[[parent, s]], color="grey", zorder=1)
            near = 0.3 * places[parent] + 0.7 * places[s], 0.3 * depths[parent] + 0.7 * depths[s]
            axes.annotate(f"{found.probabilities[s]:.2f}", near, ha="center", fontsize=8)
    axes.scatter(places, depths, c=colors, s=400, zorder=2)
    for s in range(parents.size):
        axes.annotate(str(s), (places[s], depths[s]), ha="center", va="center", zorder=3)
    axes.set_xlim(0, 1)
    axes.margins(y=0.2)
    axes.set_axis_off()


def show(vertices, faces, output, number_of_segments=None):
    found = protrusion_segmentation.segmentation(vertices, faces, number_of_segments)
    colors = pyplot.get_cmap("tab20")(np.arange(found.number_of_segments) % 20)[:, :3]
    figure = pyplot.figure(figsize=(11, 5))
    draw_mesh(figure.add_subplot(1, 2, 1, projection="3d"), vertices, faces, found, colors)
    draw_tree(figure.add_subplot(1, 2, 2), found, colors)
    figure.savefig(output, dpi=120)
    pyplot.close(figure)
    return found


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    mesh = meshio.read(sys.argv[1])
    print(show(mesh.points, mesh.cells_dict["triangle"], sys.argv[2]))
