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
    checked_number,
    checked_tolerance,
    faces_of_corners,
    integer_from,
    integers,
    mesh_arrays,
)
from ._meshes import Connector, Mesh, Skeleton
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


def closed_segments_with_connectors(
    vertices: npt.ArrayLike,
    faces: Faces,
    found: Segmentation,
    tolerance: Optional[float] = None,
    *,
    radius: float = 0.5,
    depth: float = 0.75,
    sides: int = 6,
    chamfer: float = 0.2,
    smallest_radius: Optional[float] = None,
    snapping_tolerance: Optional[float] = None,
) -> Tuple[List[Mesh], List[Connector]]:
    """Make a closed mesh of each segment, with pegs and sockets on the flat caps that two segments share.

    Parameters
    ----------
    vertices, faces, snapping_tolerance : those of `segmentation()`; not with joined pieces
    found : its result
    tolerance : the distance between the sides of peg and socket; without it, a twentieth of the radius of each peg
    radius, depth : of a peg, as shares of the radius of the largest circle in the cap. Where there is less room, pegs are thinner,
        down to a half of this, and shorter
    sides : of a peg: few keep the parts from turning, many make it round
    chamfer : its width at the end of a peg, as a share of the radius of the peg, from 0 to 0.5
    smallest_radius : that of a peg; without it, a hundredth of the radius of a ball around the mesh

    Returns
    -------
    list of Mesh
        Those of `closed_segments()`, with pegs and sockets.
    list of Connector
        One for each cap, also for those that have none, with the reason.
    """
    numbers = (
        integer_from("sides", sides, 3, 1000),
        checked_number("radius", radius),
        checked_number("depth", depth),
        checked_number("chamfer", chamfer),
        None if tolerance is None else checked_number("tolerance", tolerance),
        None if smallest_radius is None else checked_number("smallest_radius", smallest_radius),
    )
    options, tree = _arguments(found, snapping_tolerance)
    parts, connectors = _core.closed_segments_with_connectors(*mesh_arrays(vertices, faces), options, *tree, numbers)
    meshes = [Mesh(points, faces_of_corners(corners, sizes)) for points, corners, sizes in parts]
    return meshes, [Connector(*connector) for connector in connectors]


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
