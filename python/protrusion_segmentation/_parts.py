# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is made of the segments of a mesh."""

from typing import Any, Dict, List, Literal, Optional, Tuple, get_args

import numpy.typing as npt

from . import _core
from ._arguments import (
    Faces,
    Labels,
    checked_choice,
    checked_tolerance,
    faces_of_corners,
    integer_from,
    integers,
    mesh_arrays,
)
from ._meshes import Mesh, Skeleton
from ._results import Segmentation

Caps = Literal["flat", "faired"]


def closed_segments(
    vertices: npt.ArrayLike,
    faces: Faces,
    found: Segmentation,
    caps: Caps = "flat",
    snapping_tolerance: Optional[float] = None,
) -> List[Mesh]:
    """Make a mesh of each segment, closed where it was cut off, as for printing.

    Parameters
    ----------
    vertices, faces, snapping_tolerance : those of `segmentation()`; not with joined pieces
    found : its result. `dataclasses.replace(found, labels=...)` is one with other labels
    caps : "flat", caps that two segments share, so that volumes add up; or "faired", rounded caps of each segment, which are
        slow for long borders. With these, polygons become triangles

    Returns
    -------
    list of Mesh
        The faces of each segment and behind them the triangles that close it. Those of a closed mesh are closed; at the
        boundary of an open one they stay open.
    """
    are_faired = checked_choice("caps", caps, get_args(Caps)) == "faired"
    options, tree = _arguments(found, snapping_tolerance)
    parts = _core.closed_segments(*mesh_arrays(vertices, faces), options, *tree, are_faired)
    return [Mesh(points, faces_of_corners(corners, sizes)) for points, corners, sizes in parts]


def skeleton(
    vertices: npt.ArrayLike,
    faces: Faces,
    found: Segmentation,
    inner_joints: int = 4,
    snapping_tolerance: Optional[float] = None,
) -> Skeleton:
    """Make a curve skeleton, or a rig: joints at the centres of bodies, at borders and tips, and in between.

    Parameters
    ----------
    vertices, faces, snapping_tolerance : those of `segmentation()`; not with joined pieces
    found : its result
    inner_joints : how many there are at most between the border and the tip of a protrusion, at least 0. With 0, there is one
        joint for each segment, which moves it with all that sticks out of it, besides the tips
    """
    number = integer_from("inner_joints", inner_joints, 0, 10000)
    options, tree = _arguments(found, snapping_tolerance)
    return Skeleton(**_core.skeleton(*mesh_arrays(vertices, faces), options, *tree, number))


def _arguments(
    found: Segmentation, snapping_tolerance: Optional[float]
) -> Tuple[Dict[str, Any], Tuple[Labels, Labels, Labels]]:
    """The options and the segments as C++ takes them."""
    if not isinstance(found, Segmentation):
        raise ValueError(f"found is no Segmentation, but {type(found).__name__}")
    if found.repairs.joined_pieces:
        raise ValueError("found: pieces were joined; segments of the surface around them are made by the tool only")
    tree = integers("found.labels", found.labels), integers("found.parents", found.parents), integers("found.tips", found.tips)
    if tree[1].shape != tree[2].shape:
        raise ValueError("found: there are not as many tips as parents")
    return {"snapping_tolerance": checked_tolerance(snapping_tolerance)}, tree
