# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segmentation and what belongs to it."""

import warnings
from typing import Any, Callable, Dict, Optional, Sequence, Union, get_args

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import (
    Faces,
    Labels,
    checked_choice,
    checked_gap,
    checked_integer,
    checked_tolerance,
    integer_from,
    integers,
    mesh_arrays,
)
from ._options import Distance, DistanceName, Method, options_of_distance, options_of_method
from ._results import Hierarchy, Repairs, RepairWarning, Segmentation, SegmentationStopped, segmentation_of

Progress = Callable[[float], Optional[bool]]


def segmentation(
    vertices: npt.ArrayLike,
    faces: Faces,
    number_of_segments: Optional[int] = None,
    method: Method = "minimum-cut",
    distance: Optional[Distance] = None,
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
    threads: int = 1,
    progress: Optional[Progress] = None,
    tips: Union[Sequence[int], npt.NDArray[Any], None] = None,
) -> Segmentation:
    """Split a mesh into a body and its protrusions, and return all that is known of these.

    Parameters
    ----------
    vertices : (n, 3) array of coordinates
    faces : (m, 3) or (m, k) array of corners, or sequence of m polygons
    number_of_segments : from 1 to m, where duplicate faces count once; without it, segmentation stops
        where no further cut is good enough
    method : "minimum-cut", minimum cuts along concave seams; or "paper", that of Aono, Wakida and Tatsuma; or
        `PaperMethod` with options
    distance : on the surface. By default that of the method: geodesic for "paper", and for "minimum-cut" one of its
        own. "geodesic": shortest paths in the face dual graph; "landmark": shortest paths by way of random
        landmarks, or `LandmarkDistance` with options; "diffusion": how differently random walks spread, or
        `DiffusionDistance` with options; "heat": paths over the faces, by the heat method; "exact": exact paths over the
        faces, which take long on more than a few thousand faces.
        Or a function: it is called with the `DualGraph` of each connected piece that is divided, and returns a function
        from a face to an array of the distances of all faces from it, at least 0. If it has an attribute `is_metric`
        that is true, the triangle inequality saves most calls; otherwise there is one for every face.
    random_seed : seed of all random choices, from 0 to 4294967295; the same seed gives the same labels; default 0
    snapping_tolerance : the distance up to which corners on borders count as one, and lie on an edge; 0 joins equal
        corners only. Without it, those are joined that differ by rounding, about a millionth of the size
    join_pieces : True segments loose pieces as one shape: pieces that touch, overlap or are less than a gap apart.
        Hidden pieces go with what covers them. A number is the gap; True means a fortieth of the size
    threads : the number of threads, from 1 to 1024; no matter for the result; default 1. One is used if oneTBB was not
        there when the module was built
    progress : a function that is called several times a second with the share that is done, from 0 to 1. If it returns
        False, the call raises `SegmentationStopped`. It may raise any other exception, too
    tips : faces, as those of `tips()`: only their protrusions are cut off. A tip for which no border is found makes
        no segment. Not together with number_of_segments

    Returns
    -------
    Segmentation
        There may be fewer segments than asked for if no more borders are found, and there are as many as components at
        least.

    Raises
    ------
    ValueError
        If the mesh or an argument makes no sense.
    SegmentationStopped
        If `progress` returned False.
    """
    options = _options(method, distance, random_seed, snapping_tolerance, join_pieces, threads, progress)
    if tips is not None:
        if number_of_segments is not None:
            raise ValueError("number_of_segments and tips cannot be given together")
        options["tips"] = integers("tips", tips).tolist()
    if number_of_segments is not None:
        options.update(_number("number_of_segments", number_of_segments))
    return _found(vertices, faces, options)


def segment(
    vertices: npt.ArrayLike,
    faces: Faces,
    number_of_segments: Optional[int] = None,
    method: Method = "minimum-cut",
    distance: Optional[Distance] = None,
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Labels:
    """Split a mesh into a body and its protrusions.

    Parameters
    ----------
    All are as for `segmentation()`.

    Returns
    -------
    (m,) array of integers
        The segment of every face, from 0 on: `labels` of `segmentation()`.
    """
    options = _options(method, distance, random_seed, snapping_tolerance, join_pieces, threads, progress)
    if number_of_segments is not None:
        options.update(_number("number_of_segments", number_of_segments))
    return _found(vertices, faces, options).labels


def segment_from_tips(
    vertices: npt.ArrayLike,
    faces: Faces,
    tips: Union[Sequence[int], npt.NDArray[Any]],
    method: Method = "minimum-cut",
    distance: Optional[Distance] = None,
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Labels:
    """Cut off the protrusions at given tips, such as those of `tips()`, edited or picked by a user.

    Parameters
    ----------
    tips : the faces at the tips, as numbers from 0. A tip for which no border is found makes no segment.
    vertices, faces, method, distance, random_seed, snapping_tolerance, join_pieces, threads, progress : as for
        `segmentation()`

    Returns
    -------
    (m,) array of integers
        The segment of every face, from 0 on: `labels` of `segmentation()` with these tips.
    """
    options = _options(method, distance, random_seed, snapping_tolerance, join_pieces, threads, progress)
    options["tips"] = integers("tips", tips).tolist()
    return _found(vertices, faces, options).labels


def hierarchy(
    vertices: npt.ArrayLike,
    faces: Faces,
    maximum_number_of_segments: int,
    method: Method = "minimum-cut",
    distance: Optional[Distance] = None,
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Hierarchy:
    """Compute the nested protrusions of a mesh, to choose the number of segments afterwards.

    `segmentation()` returns them, too, as `Segmentation.hierarchy`.

    Parameters
    ----------
    maximum_number_of_segments : where to stop, from 1 to m; the hierarchy ends earlier if no more borders are found
    vertices, faces, method, distance, random_seed, snapping_tolerance, join_pieces, threads, progress : as for
        `segmentation()`
    """
    options = _options(method, distance, random_seed, snapping_tolerance, join_pieces, threads, progress)
    options.update(_number("maximum_number_of_segments", maximum_number_of_segments))
    return _found(vertices, faces, options).hierarchy


def tips(
    vertices: npt.ArrayLike,
    faces: Faces,
    number_of_tips: int,
    distance: Distance = "geodesic",
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Labels:
    """Select the tips of protrusions: a face far from all others, then again and again the face farthest from all.

    Parameters
    ----------
    number_of_tips : from 0 to m
    vertices, faces, distance, random_seed, snapping_tolerance, join_pieces, threads, progress : as for `segmentation()`

    Returns
    -------
    array of integers
        The faces at the tips, in the order of selection in each connected component.
    """
    if distance is None:
        checked_choice("distance", distance, get_args(DistanceName))
    options = _options("minimum-cut", distance, random_seed, snapping_tolerance, join_pieces, threads, progress)
    options.update(_number("number_of_tips", number_of_tips))
    return _core.tips(*mesh_arrays(vertices, faces), options)


def _options(
    method: Method,
    distance: Optional[Distance],
    random_seed: int,
    snapping_tolerance: Optional[float],
    join_pieces: Union[bool, float],
    threads: int,
    progress: Optional[Progress],
) -> Dict[str, Any]:
    """The options as C++ calls them."""
    are_joined, gap = checked_gap(join_pieces)
    return {
        **options_of_method(method),
        **options_of_distance(distance),
        "random_seed": integer_from("random_seed", random_seed, 0, int(np.iinfo(np.uint32).max)),
        "snapping_tolerance": checked_tolerance(snapping_tolerance),
        "are_pieces_joined": are_joined,
        "gap": gap,
        "threads": integer_from("threads", threads, 1, 1024),
        "progress": None if progress is None else _stopping(progress),
    }


def _number(name: str, value: int) -> Dict[str, Any]:
    return {"number": checked_integer(name, value), "name_of_number": name}


def _stopping(progress: Progress) -> Callable[[float], None]:
    """The function with an exception in place of False."""
    if not callable(progress):
        raise ValueError(f"progress is no function, but {progress!r}")

    def stopping(share: float) -> None:
        if progress(share) is False:
            raise SegmentationStopped("progress returned False")

    return stopping


def _found(vertices: npt.ArrayLike, faces: Faces, options: Dict[str, Any]) -> Segmentation:
    found = segmentation_of(_core.segment(*mesh_arrays(vertices, faces), options))
    _warn_of_repairs(found.repairs, found.labels.size)
    return found


def _warn_of_repairs(repairs: Repairs, number_of_faces: int) -> None:
    """If more than a tenth of the faces were concerned: then the faces are probably not what the caller means."""
    few_faces = 10  # of which one is a tenth
    counts = {
        "degenerate faces": repairs.degenerate_faces,
        "duplicate faces": repairs.duplicate_faces,
        "edges of more than two faces": repairs.non_manifold_edges,
    }
    much = [f"{count} {name}" for name, count in counts.items() if number_of_faces > few_faces and 10 * count > number_of_faces]
    if number_of_faces > few_faces and 2 * repairs.components > number_of_faces:
        much.append("hardly any faces that share edges (snapping_tolerance joins corners that nearly agree)")
    if much:
        message = f"faces: among {number_of_faces} there are {' and '.join(much)}"
        warnings.warn(message, RepairWarning, stacklevel=4)
