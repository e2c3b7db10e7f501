# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the functions return."""

from dataclasses import dataclass
from typing import Any, List, NamedTuple, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._arguments import checked_integer

Integers = npt.NDArray[np.int64]
Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)  # arrays have no one answer to whether they are equal
class Hierarchy:
    """The nested protrusions of a mesh as a tree, and its segmentations for every number of segments.

    The segmentation with one segment less is found by giving the last segment to its parent.

    Attributes
    ----------
    parents : (k,) array of integers
        The segment out of which each segment sticks, which may have a higher number; the segment itself for the body of a
        component.
    finest_labels : (m,) array of integers
        The segment of every face if there are as many segments as possible.
    """

    parents: Integers
    finest_labels: Integers

    @property
    def minimum_number_of_segments(self) -> int:
        """The number of connected components."""
        return int(np.count_nonzero(self.parents == np.arange(self.parents.size)))

    @property
    def maximum_number_of_segments(self) -> int:
        """The number of segments of `finest_labels`."""
        return int(self.parents.size)

    def labels(self, number_of_segments: int) -> Integers:
        """The segment of every face, from 0 to number_of_segments - 1.

        Parameters
        ----------
        number_of_segments : from `minimum_number_of_segments` to `maximum_number_of_segments`
        """
        count = checked_integer("number_of_segments", number_of_segments)
        least, most = self.minimum_number_of_segments, self.maximum_number_of_segments
        if not least <= count <= most:
            raise ValueError(f"number_of_segments is {count}, but the hierarchy has {least} to {most} segments")
        ancestors = np.arange(most)
        while (ancestors >= count).any():
            ancestors = np.where(ancestors >= count, self.parents[ancestors], ancestors)
        return ancestors[self.finest_labels]


@dataclass(frozen=True, eq=False)
class Border:
    """A line of edges between two segments: closed, or from where segments meet or the mesh ends to another such place.

    Attributes
    ----------
    segments : pair of integers
        The two segments, the smaller number first. That one is on the left, seen from outside.
    points : (p, 3) array
        The coordinates along the line; of a closed line, the first point is not repeated.
    is_closed : bool
        Whether the first point follows the last.
    length : float
        The length, in the unit of the mesh.
    value : float
        How good the border is, as in `Segmentation.values`; NaN between connected components.
    probability : float
        That people draw the border, from 0 to 1; NaN if the method does not estimate it.
    """

    segments: Tuple[int, int]
    points: Floats
    is_closed: bool
    length: float
    value: float
    probability: float


class Repairs(NamedTuple):
    """What had to be repaired so that the faces make up a surface, as counts. The arrays given stay unchanged."""

    degenerate_faces: int
    duplicate_faces: int
    non_manifold_edges: int
    unorientable_edges: int
    reversed_faces: int
    joined_corners: int
    split_edges: int
    small_components: int
    inside_out_components: int
    joined_pieces: int
    components: int

    @property
    def is_nothing(self) -> bool:
        """Whether nothing had to be repaired."""
        return not any(self[:-1])


_describe = {
    "degenerate_faces": "faces with fewer than three different corners; they get the label of a neighbour",
    "duplicate_faces": "faces with the corners of another one; they get its label",
    "non_manifold_edges": "edges of more than two faces",
    "unorientable_edges": "edges where the surface was cut open, since it has no two sides",
    "reversed_faces": "faces that were turned over to be oriented as their neighbours are",
    "joined_corners": "corners on borders that nearly agree with another one, and became one with it",
    "split_edges": "corners on borders that lie on an edge, and were set into it",
    "small_components": "tiny components that touch the rest; they get the label of a neighbour",
    "inside_out_components": "closed components that were turned outward",
    "joined_pieces": "pieces, if `join_pieces` was given; else 0",
    "components": "connected components of the surface; no repair",
}
for _name, _text in _describe.items():
    getattr(Repairs, _name).__doc__ = _text


@dataclass(frozen=True, eq=False)
class Segmentation:
    """A mesh that is split into a body and its protrusions, and all that is known of these.

    There are m faces, in the order in which they were given, and k segments, from 0 on. The first segments are the
    bodies, one for each connected component; the others are protrusions, those that a hierarchy joins first last.
    Lengths are in the unit of the mesh, areas in its square. Bodies have no tip and no border to a parent: their number is
    -1 or NaN.

    Attributes
    ----------
    labels : (m,) array of integers
        The segment of every face.
    parents : (k,) array of integers
        The segment out of which each segment sticks; the segment itself for a body.
    tips : (k,) array of integers
        The face at the tip of each protrusion; -1 for a body.
    areas : (k,) array
        The area of each segment. If pieces were joined, that on the surface around them.
    protruding_areas : (k,) array
        The area beyond the border: of the segment and of all that sticks out of it.
    border_lengths : (k,) array
        The length of the border between the protrusion, with all that sticks out of it, and the rest.
    border_distances : (k,) array
        The distance of the border from the tip.
    values : (k,) array
        How good the border to the parent is. For "minimum-cut" from -0.5 to 0.5: how much the cut brings, which is less for
        small parts and, of equal parts, for those that were cut off last. For "paper", the prominence, above 0.
    probabilities : (k,) array
        The probability, from 0 to 1, that people put both sides of the border into different segments. NaN for "paper",
        which does not estimate it.
    confidences : (k,) array
        The least probability of a border of the segment, or the least value for "paper"; infinity without a border.
    border_slots : (k,) array of integers
        The slot of the histograms in which the border lies; -1 for a body and for "minimum-cut".
    distance_histograms : (k, 100) array of integers
        The number of faces in each slot of the distance from the tip; of shape (0, 0) for "minimum-cut".
    diameter_histograms : (k, 100) array
        The diameter of the section in each slot; of shape (0, 0) for "minimum-cut".
    borders : list of `Border`
        The borders between segments as lines, sorted by their segments.
    border_edges : (e, 2) array of integers
        The edges between segments, as pairs of vertices; none if pieces were joined.
    selected_tips : array of integers
        The faces at all tips that were selected, also those without a segment.
    number_of_small_components : int
        How many components, such as the dust of a scanner, got no segments of their own.
    repairs : `Repairs`
        What had to be repaired.
    """

    labels: Integers
    parents: Integers
    tips: Integers
    areas: Floats
    protruding_areas: Floats
    border_lengths: Floats
    border_distances: Floats
    values: Floats
    probabilities: Floats
    confidences: Floats
    border_slots: Integers
    distance_histograms: Integers
    diameter_histograms: Floats
    borders: List[Border]
    border_edges: Integers
    selected_tips: Integers
    number_of_small_components: int
    repairs: Repairs

    @property
    def number_of_segments(self) -> int:
        """The number of segments, k."""
        return int(self.parents.size)

    @property
    def label_confidence(self) -> Floats:
        """(m,) array: for every face how sure its label is, that is, the `confidences` of its segment."""
        return self.confidences[self.labels]

    @property
    def hierarchy(self) -> Hierarchy:
        """The segmentations with fewer segments, in which the last ones are joined to their parents."""
        return Hierarchy(parents=self.parents, finest_labels=self.labels)

    def __repr__(self) -> str:
        bodies = self.hierarchy.minimum_number_of_segments
        return f"<Segmentation: {self.labels.size} faces, {self.number_of_segments} segments, {bodies} of them bodies>"


class Metrics(NamedTuple):
    """How far two segmentations are from each other; smaller is better, but for the last one."""

    rand_index_error: float
    hamming_distance: float
    missing_rate: float
    false_alarm_rate: float
    cut_discrepancy: Optional[float]
    global_consistency_error: float
    local_consistency_error: float
    global_consistency_error_by_area: float
    local_consistency_error_by_area: float
    mean_best_intersection_over_union: float


_describe = {
    "rand_index_error": "the share of the pairs of faces on which the segmentations disagree, from 0 to 1",
    "hamming_distance": "the mean of missing_rate and false_alarm_rate, from 0 to 1",
    "missing_rate": "the share of the area that the best segments miss of those of the reference, from 0 to 1",
    "false_alarm_rate": "the share of the area by which segments exceed the best ones of the reference, from 0 to 1",
    "cut_discrepancy": "the mean distance between the borders, in average radii; None where one side has none",
    "global_consistency_error": "how far one is from being a refinement of the other, from 0 to 1",
    "local_consistency_error": "the same, where either may be the finer one at each face, from 0 to 1",
    "global_consistency_error_by_area": "the global error with parts of segments measured by area, from 0 to 1",
    "local_consistency_error_by_area": "the local error with parts of segments measured by area, from 0 to 1",
    "mean_best_intersection_over_union": "that of learned methods, larger is better: the mean over the parts of the reference, "
    "which are not negative, of the largest intersection over union with a segment, from 0 to 1",
}
for _name, _text in _describe.items():
    getattr(Metrics, _name).__doc__ = _text


class SegmentationStopped(Exception):
    """Raised by a call whose `progress` function returned False."""


class RepairWarning(UserWarning):
    """Much of a mesh had to be repaired, so that its faces may not mean what was intended."""


def segmentation_of(found: Any) -> Segmentation:
    """The result from what C++ found."""
    borders = [Border(*border) for border in found.pop("borders")]
    repairs = Repairs(*found.pop("repairs"))
    return Segmentation(borders=borders, repairs=repairs, **found)
