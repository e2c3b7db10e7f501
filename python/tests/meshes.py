# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with known parts."""

import numpy as np

TETRAHEDRON = (np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float),
               np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))


def icosahedron():
    golden = (1 + 5**0.5) / 2
    points = np.array([(0, y, z) for y in (-1, 1) for z in (-golden, golden)])
    points = np.concatenate([np.roll(points, shift, axis=1) for shift in range(3)])
    triangles = []
    for a in range(12):
        for b in range(a):
            for c in range(b):
                corners = points[[a, b, c]]
                lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1)
                if np.allclose(lengths, 2):
                    is_outward = np.linalg.det(corners) > 0
                    triangles.append((a, b, c) if is_outward else (a, c, b))
    return points, np.array(triangles)


def subdivided(points, triangles):
    """Every triangle becomes four."""
    n = len(triangles)
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges, numbers = np.unique(edges, axis=0, return_inverse=True)
    a, b, c = triangles.T
    d, e, f = len(points) + numbers.reshape(3, n)
    result = np.concatenate([np.stack(three, axis=1) for three in ((a, d, f), (d, b, e), (f, e, c), (d, e, f))])
    return np.concatenate([points, points[edges].mean(axis=1)]), result


def ball_with_arms(number_of_subdivisions=4):
    """A ball with an arm on each of the six ends of the axes, those of x the longest, those of z the shortest."""
    points, triangles = icosahedron()
    for _ in range(number_of_subdivisions):
        points, triangles = subdivided(points, triangles)
    normals = points / np.linalg.norm(points, axis=1, keepdims=True)
    height = (normals**32 * (6, 5, 4)).sum(axis=1, keepdims=True)
    return (1 + height) * normals, triangles


def arms(points, triangles):
    """For every face the arm that it is certainly on, from 0 to 5, or 6 for the ball, or -1 for what lies between."""
    centroids = points[triangles].mean(axis=1)
    axis = np.abs(centroids).argmax(axis=1)
    side = np.take_along_axis(centroids, axis[:, None], axis=1)[:, 0] > 0
    radius = np.linalg.norm(centroids, axis=1)
    return np.where(radius > 2.5, 2 * axis + side, np.where(radius < 1.05, 6, -1))
