# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segmentation of surface meshes into a body and its protrusions.

    >>> labels = protrusion_segmentation.segment(vertices, faces)
    >>> found = protrusion_segmentation.segmentation(vertices, faces)  # all that is known of the segments, too

A mesh is given as vertices, an array of shape (n, 3), and faces: an array of shape (m, 3) for triangles, of shape
(m, k) for polygons of k corners, or a sequence of polygons of any sizes. Corners are numbers of vertices, from 0.
Coordinates may have any float or integer type, corners any integer type.

Every face gets a label, in the order of the faces given. Faces that are no surface are repaired: vertices at one place
count as one, wrong orientations are reversed, and at edges of more than two faces those that bound the same solid are
joined. Degenerate faces get the label of a neighbour, duplicate faces that of the first copy. Corners on borders that
differ by rounding are joined. Closed components are turned outward. `Segmentation.repairs` tells what was done, and
`RepairWarning` is given if it was much.

Arguments that make no sense raise ValueError, which names the argument and what it may be. While a function computes,
other threads run, and Ctrl-C stops it with KeyboardInterrupt.
"""

from . import _core
from ._borders import smooth_borders
from ._files import read_seg, write_seg
from ._meshes import Connector, Mesh, Skeleton, SmoothedMesh
from ._metrics import (
    consistency_error,
    cut_discrepancy,
    evaluate,
    evaluate_against,
    hamming_distance,
    mean_best_intersection_over_union,
    rand_index_error,
)
from ._options import DiffusionDistance, DualGraph, LandmarkDistance, PaperMethod
from ._parts import closed_segments, closed_segments_with_connectors, skeleton
from ._results import (
    Border,
    Hierarchy,
    Metrics,
    RepairWarning,
    Repairs,
    Segmentation,
    SegmentationStopped,
)
from ._segment import hierarchy, segment, segment_from_tips, segmentation, tips

__all__ = [
    "Border",
    "Connector",
    "DiffusionDistance",
    "DualGraph",
    "Hierarchy",
    "LandmarkDistance",
    "Mesh",
    "Metrics",
    "PaperMethod",
    "RepairWarning",
    "Repairs",
    "Segmentation",
    "SegmentationStopped",
    "Skeleton",
    "SmoothedMesh",
    "closed_segments",
    "closed_segments_with_connectors",
    "consistency_error",
    "cut_discrepancy",
    "evaluate",
    "evaluate_against",
    "hamming_distance",
    "hierarchy",
    "mean_best_intersection_over_union",
    "rand_index_error",
    "read_seg",
    "segment",
    "segment_from_tips",
    "segmentation",
    "skeleton",
    "smooth_borders",
    "tips",
    "write_seg",
]
__version__: str = _core.version
