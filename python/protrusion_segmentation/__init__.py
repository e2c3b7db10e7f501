# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segmentation of surface meshes into a body and its protrusions.

    >>> labels = protrusion_segmentation.segment(vertices, faces)

A mesh is given as vertices, an array of shape (n, 3), and faces: an array of shape (m, 3) for triangles, of shape
(m, k) for polygons of k corners, or a sequence of polygons of any sizes. Corners are numbers of vertices, from 0.

Every face gets a label, in the order of the faces given. Faces that are no surface are repaired: vertices at one place
count as one, wrong orientations are reversed, and at edges of more than two faces those that bound the same solid are
joined. Degenerate faces get the label of a neighbour, duplicate faces that of the first copy. Corners on borders that
differ by rounding are joined. Closed components are turned outward.

Arguments that make no sense raise ValueError, which names the argument and what it may be. While a function computes,
other threads run, and Ctrl-C stops it with KeyboardInterrupt.
"""

import itertools
import operator
from dataclasses import dataclass
from typing import Any, List, Literal, NamedTuple, Optional, Sequence, Tuple, Union, get_args

import numpy as np
import numpy.typing as npt

from . import _core

__all__ = ["Hierarchy", "Metrics", "evaluate", "hierarchy", "segment", "segment_from_tips", "tips"]
__version__: str = _core.version

Labels = npt.NDArray[np.int64]
Faces = Union[npt.ArrayLike, Sequence[Sequence[int]], Sequence[npt.NDArray[Any]]]
Method = Literal["minimum-cut", "paper"]
Distance = Literal["geodesic", "landmark", "diffusion", "heat", "exact"]


def segment(
    vertices: npt.ArrayLike,
    faces: Faces,
    number_of_segments: Optional[int] = None,
    method: Method = "minimum-cut",
    distance: Optional[Distance] = None,
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
) -> Labels:
    """Split a mesh into a body and its protrusions.

    Parameters
    ----------
    vertices : (n, 3) array of coordinates
    faces : (m, 3) or (m, k) array of corners, or sequence of m polygons
    number_of_segments : from 1 to m, where duplicate faces count once; without it, segmentation stops
        where no further cut is good enough
    method : "minimum-cut", minimum cuts along concave seams; or "paper", that of Aono, Wakida and Tatsuma
    distance : on the surface. By default that of the method: geodesic for "paper", and for "minimum-cut" one of its
        own. "geodesic": shortest paths in the face dual graph; "landmark": shortest paths by way of random
        landmarks; "diffusion": how differently random walks spread; "heat": paths over the faces, by the heat method;
        "exact": exact paths over the faces, which take long on more than a few thousand faces
    random_seed : seed of all random choices; the same seed gives the same labels
    snapping_tolerance : the distance up to which corners on borders count as one, and lie on an edge; 0 joins equal
        corners only. Without it, those are joined that differ by rounding, about a millionth of the size
    join_pieces : True segments loose pieces as one shape: pieces that touch, overlap or are less than a gap apart.
        Hidden pieces go with what covers them. A number is the gap; True means a fortieth of the size

    Returns
    -------
    (m,) array of integers
        The segment of every face, from 0 on. The first segments are the bodies, one for each connected component; the
        others are protrusions, those that `hierarchy()` joins first last. There may be fewer segments than
        asked for if no more borders are found, and there are as many as components at least.

    Raises
    ------
    ValueError
        If the mesh or an argument makes no sense.
    """
    count = None if number_of_segments is None else _integer("number_of_segments", number_of_segments)
    choices = _choices(method, distance)
    seed, tolerance, gap = _seed(random_seed), _tolerance(snapping_tolerance), _gap(join_pieces)
    return _core.segment(*_arrays(vertices, faces), count, *choices, seed, tolerance, gap)


def segment_from_tips(
    vertices: npt.ArrayLike,
    faces: Faces,
    tips: Union[Sequence[int], npt.NDArray[Any]],
    method: Method = "minimum-cut",
    distance: Optional[Distance] = None,
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
) -> Labels:
    """Cut off the protrusions at given tips, such as those of `tips()`, edited or picked by a user.

    Parameters
    ----------
    tips : the faces at the tips, as numbers from 0. A tip for which no border is found makes no segment.
    vertices, faces, method, distance, random_seed, snapping_tolerance, join_pieces : as for `segment()`

    Returns
    -------
    (m,) array of integers
        As `segment()`.
    """
    picked = _integers("tips", tips).tolist()
    choices = _choices(method, distance)
    seed, tolerance, gap = _seed(random_seed), _tolerance(snapping_tolerance), _gap(join_pieces)
    return _core.segment_from_tips(*_arrays(vertices, faces), picked, *choices, seed, tolerance, gap)


@dataclass(frozen=True, eq=False)  # arrays have no one answer to whether they are equal
class Hierarchy:
    """The nested protrusions of a mesh as a tree, and its segmentations for every number of segments.

    The segmentation with one segment less is found by giving the last segment to its parent.
    """

    parents: Labels
    """The segment out of which each segment sticks; the segment itself for the body of a component."""
    finest_labels: Labels
    """The segment of every face if there are as many segments as possible."""

    @property
    def minimum_number_of_segments(self) -> int:
        """The number of connected components."""
        return int(np.count_nonzero(self.parents == np.arange(self.parents.size)))

    @property
    def maximum_number_of_segments(self) -> int:
        return int(self.parents.size)

    def labels(self, number_of_segments: int) -> Labels:
        """The segment of every face, from 0 to number_of_segments - 1."""
        count = _integer("number_of_segments", number_of_segments)
        least, most = self.minimum_number_of_segments, self.maximum_number_of_segments
        if not least <= count <= most:
            raise ValueError(f"number_of_segments is {count}, but the hierarchy has {least} to {most} segments")
        ancestors = np.arange(most)
        while (ancestors >= count).any():
            ancestors = np.where(ancestors >= count, self.parents[ancestors], ancestors)
        return ancestors[self.finest_labels]


def hierarchy(
    vertices: npt.ArrayLike,
    faces: Faces,
    maximum_number_of_segments: int,
    method: Method = "minimum-cut",
    distance: Optional[Distance] = None,
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
) -> Hierarchy:
    """Compute the nested protrusions of a mesh, to choose the number of segments afterwards.

    Parameters
    ----------
    maximum_number_of_segments : where to stop; the hierarchy ends earlier if no more borders are found
    vertices, faces, method, distance, random_seed, snapping_tolerance, join_pieces : as for `segment()`
    """
    count = _integer("maximum_number_of_segments", maximum_number_of_segments)
    choices = _choices(method, distance)
    seed, tolerance, gap = _seed(random_seed), _tolerance(snapping_tolerance), _gap(join_pieces)
    labels, parents = _core.hierarchy(*_arrays(vertices, faces), count, *choices, seed, tolerance, gap)
    return Hierarchy(parents=parents, finest_labels=labels)


def tips(
    vertices: npt.ArrayLike,
    faces: Faces,
    number_of_tips: int,
    distance: Distance = "geodesic",
    random_seed: int = 0,
    snapping_tolerance: Optional[float] = None,
    join_pieces: Union[bool, float] = False,
) -> Labels:
    """Select the tips of protrusions: a face far from all others, then again and again the face farthest from all.

    Parameters
    ----------
    number_of_tips : at most the number of faces
    vertices, faces, distance, random_seed, snapping_tolerance, join_pieces : as for `segment()`

    Returns
    -------
    array of integers
        The faces at the tips, in the order of selection in each connected component.
    """
    count = _integer("number_of_tips", number_of_tips)
    seed, tolerance, gap = _seed(random_seed), _tolerance(snapping_tolerance), _gap(join_pieces)
    choice = _choice("distance", distance, get_args(Distance))
    return _core.tips(*_arrays(vertices, faces), count, choice, seed, tolerance, gap)


class Metrics(NamedTuple):
    """How far two segmentations are from each other; smaller is better, but for the last one."""

    rand_index_error: float
    """The share of the pairs of faces on which the segmentations disagree."""
    hamming_distance: float
    """The mean of the two rates that follow."""
    missing_rate: float
    """The share of the area that the best segments miss of those of the reference."""
    false_alarm_rate: float
    """The share of the area by which segments exceed the best ones of the reference."""
    cut_discrepancy: Optional[float]
    """The mean distance between the borders, in average radii; None where one side has none."""
    global_consistency_error: float
    local_consistency_error: float
    global_consistency_error_by_area: float
    local_consistency_error_by_area: float
    mean_best_intersection_over_union: float
    """The mean over the parts of the reference of the largest intersection over union; larger is better."""


def evaluate(vertices: npt.ArrayLike, faces: Faces, labels: npt.ArrayLike, reference: npt.ArrayLike) -> Metrics:
    """Compare a segmentation with another one, by the metrics of the Princeton Segmentation Benchmark.

    The last metric is that of learned methods.

    Parameters
    ----------
    vertices, faces : as for `segment()`
    labels : (m,) array of integers, the segment of every face
    reference : (m,) array of integers, those that they are compared with. For the last metric, faces with
        negative ones are in no part.
    """
    ids, others = _integers("labels", labels), _integers("reference", reference)
    return Metrics(*_core.evaluate(*_arrays(vertices, faces), ids, others))


def _arrays(vertices: npt.ArrayLike, faces: Faces) -> Tuple[npt.NDArray[np.float64], Labels, Labels]:
    """The coordinates, the corners of all faces, and the number of corners of each."""
    try:
        points = np.ascontiguousarray(vertices, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"vertices: {error}") from None
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"vertices: the shape is {points.shape}, not (n, 3)")
    if isinstance(faces, np.ndarray) and faces.dtype != object:
        if faces.dtype.kind in "iu":
            _check_layout(faces)
        if faces.ndim != 2:
            raise ValueError(f"faces: the shape is {faces.shape}, not (m, 3)")
        return points, _integers("faces", faces.reshape(-1)), np.full(faces.shape[0], faces.shape[1], np.int64)
    try:
        polygons: List[Sequence[int]] = list(faces)  # type: ignore[arg-type]
        sizes = np.fromiter(map(len, polygons), np.int64, len(polygons))
        corners = list(itertools.chain.from_iterable(polygons))
    except TypeError:
        raise ValueError("faces: neither an array of shape (m, 3) nor a sequence of polygons") from None
    numbers = _integers("faces", corners)
    if sizes.size > 0 and sizes[0] > 0 and (sizes == sizes[0]).all():
        _check_layout(numbers.reshape(-1, sizes[0]))
    return points, numbers, sizes


def _check_layout(faces: npt.NDArray[Any]) -> None:
    """Other layouts of triangles, named as such: what they would mean here makes no sense."""
    rows = faces.reshape(-1, 4) if faces.ndim == 1 and faces.size % 4 == 0 else faces
    if rows.ndim == 2 and rows.shape[0] > 1 and (rows[:, :1] == rows.shape[1] - 1).all() and rows.shape[1] > 3:
        raise ValueError(
            f"faces: in VTK's layout, with the number of corners, {rows.shape[1] - 1}, before each face; "
            f"faces.reshape(-1, {rows.shape[1]})[:, 1:] are the corners"
        )
    if faces.ndim == 2 and faces.shape[0] == 3 and faces.shape[1] > 3:
        if any(np.unique(row).size < row.size for row in faces):
            raise ValueError(f"faces: the shape is {faces.shape}, not (m, 3); faces.T has it")


def _integers(name: str, values: npt.ArrayLike) -> Labels:
    """A row of integers, whatever it was. Numbers of no integer type are no integers, even if they are whole."""
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name}: not all of them are integers") from None
    if array.ndim != 1:
        raise ValueError(f"{name}: the shape is {array.shape}, not that of a row")
    if array.size > 0 and array.dtype.kind not in "iu":
        raise ValueError(f"{name}: not all of them are integers")
    if array.dtype.kind == "u" and array.size > 0 and int(array.max()) > np.iinfo(np.int64).max:
        raise ValueError(f"{name}: {array.max()} is too large")
    return np.ascontiguousarray(array, dtype=np.int64)


def _integer(name: str, value: int) -> int:
    """The number, if it is an integer of a size that C++ knows."""
    if isinstance(value, (bool, np.bool_)):
        raise ValueError(f"{name} is no integer, but {value}")
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(f"{name} is no integer, but {value!r}") from None
    if abs(number) > np.iinfo(np.int64).max:
        raise ValueError(f"{name} is {number}, which does not fit into 64 bits")
    return number


def _choice(name: str, value: Optional[str], choices: Tuple[str, ...]) -> str:
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name} is {value!r}, but it must be {', '.join(choices[:-1])} or {choices[-1]}")
    return value


def _choices(method: str, distance: Optional[str]) -> Tuple[str, Optional[str]]:
    chosen = None if distance is None else _choice("distance", distance, get_args(Distance))
    return _choice("method", method, get_args(Method)), chosen


def _seed(random_seed: int) -> int:
    seed = _integer("random_seed", random_seed)
    largest = np.iinfo(np.uint32).max
    if not 0 <= seed <= largest:
        raise ValueError(f"random_seed is {seed}, but it must be from 0 to {largest}")
    return seed


def _tolerance(value: Optional[float]) -> Optional[float]:
    if value is None:
        return None
    try:
        tolerance = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"snapping_tolerance is no number, but {value!r}") from None
    if not 0 <= tolerance < float("inf"):
        raise ValueError(f"snapping_tolerance is {value}, but it must be a distance, at least 0")
    return tolerance


def _gap(value: Union[bool, float]) -> Optional[float]:
    """None if pieces are not joined, and 0 if they are by the gap of the package."""
    if isinstance(value, (bool, np.bool_)):
        return 0.0 if value else None
    try:
        gap = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"join_pieces is neither true nor false nor a number, but {value!r}") from None
    if not 0 < gap < float("inf"):
        raise ValueError(f"join_pieces is {value}, but a gap must be a distance above 0")
    return gap
