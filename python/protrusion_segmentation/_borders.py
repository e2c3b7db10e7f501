# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth borders."""

from typing import Optional

import numpy.typing as npt

from . import _core
from ._arguments import Faces, checked_tolerance, faces_of_corners, integer_from, integers, mesh_arrays
from ._meshes import SmoothedMesh


def smooth_borders(
    vertices: npt.ArrayLike,
    faces: Faces,
    labels: npt.ArrayLike,
    iterations: int = 3,
    snapping_tolerance: Optional[float] = None,
) -> SmoothedMesh:
    """Cut faces along smooth borders between segments, which makes a new mesh. The surface stays the same.

    Segments keep their labels and stay connected. No border between two segments gets longer.

    Parameters
    ----------
    vertices, faces, snapping_tolerance : as for `segmentation()`
    labels : (m,) array of integers, the segment of every face
    iterations : how often borders are smoothed, at least 0. With more, they get straighter and move farther, up to about as
        many edges as the square root of the number; default 3

    Returns
    -------
    SmoothedMesh
        The new mesh, with the label and the old face of each new face. Faces that were repaired away are not in it.
    """
    count = integer_from("iterations", iterations, 0, 1000000)
    options = {"snapping_tolerance": checked_tolerance(snapping_tolerance)}
    found = _core.smooth_borders(*mesh_arrays(vertices, faces), options, integers("labels", labels), count)
    corners, sizes = found.pop("corners"), found.pop("sizes")
    return SmoothedMesh(faces=faces_of_corners(corners, sizes), **found)
