# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and skeletons that functions return."""

from dataclasses import dataclass
from typing import List, Union

import numpy as np
import numpy.typing as npt

Integers = npt.NDArray[np.int64]
Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Mesh:
    """A mesh.

    Attributes
    ----------
    vertices : (n, 3) array
        The coordinates.
    faces : (m, 3) array of integers, or list of arrays
        The corners of the faces; a list if not all of them are triangles.
    """

    vertices: Floats
    faces: Union[Integers, List[Integers]]


@dataclass(frozen=True, eq=False)
class Connector:
    """A peg and a socket on the cap between a segment and its parent, or why there is none.

    Attributes
    ----------
    segment : int
        The protrusion that is cut off.
    parent : int
        What it sticks out of.
    status : str
        "placed"; or "cap too small", "cap not flat", "no room". Then only `cap_radius` has a meaning below.
    cap_radius : float
        The radius of the largest circle in the cap.
    peg_segment : int
        The segment that has the peg; the other one has the socket.
    base : (3,) array
        The centre of the peg at its cap.
    end : (3,) array
        The centre of its end, inside of the other segment.
    radius : float
        The distance of its corners from its axis.
    depth : float
        Its length.
    tolerance : float
        The distance between the sides of peg and socket.
    """

    segment: int
    parent: int
    status: str
    cap_radius: float
    peg_segment: int
    base: Floats
    end: Floats
    radius: float
    depth: float
    tolerance: float


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Joints and the bones between them: lines from each joint to its parent.

    Attributes
    ----------
    points : (j, 3) array
        Where the joints are.
    parents : (j,) array of integers
        The joint that each joint hangs on, which has a lower number; a root has its own.
    segments : (j,) array of integers
        The segment that each joint is in, or whose border to the parent it is in.
    are_tips : (j,) array of bools
        Whether a joint is at the tip of its segment.
    """

    points: Floats
    parents: Integers
    segments: Integers
    are_tips: npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class SmoothedMesh:
    """A mesh whose faces were cut along smooth borders.

    Attributes
    ----------
    vertices : (n, 3) array
        The coordinates: those of the old mesh that are used, and new ones on old edges and faces.
    faces : (m, 3) array of integers, or list of arrays
        The corners of the new faces; a list if not all of them are triangles.
    labels : (m,) array of integers
        The label of every new face.
    old_faces : (m,) array of integers
        The old face that each new face is, or is a piece of.
    number_of_fixed_segments : int
        How many segments keep their faces, since they would have been lost or torn.
    """

    vertices: Floats
    faces: Union[Integers, List[Integers]]
    labels: Integers
    old_faces: Integers
    number_of_fixed_segments: int
