# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Metrics of segmentations: those of the Princeton Segmentation Benchmark, and one of learned methods."""

from typing import List, Optional, Sequence, Union

import numpy.typing as npt

from . import _core
from ._arguments import Faces, Labels, integers, mesh_arrays
from ._results import Metrics


def evaluate(vertices: npt.ArrayLike, faces: Faces, labels: npt.ArrayLike, reference: npt.ArrayLike) -> Metrics:
    """Compare a segmentation with another one by all metrics.

    Parameters
    ----------
    vertices, faces : as for `segmentation()`
    labels : (m,) array of integers, the segment of every face
    reference : (m,) array of integers, those that they are compared with
    """
    return _rows(vertices, faces, labels, [reference], "all")[0]


def evaluate_against(
    vertices: npt.ArrayLike, faces: Faces, labels: npt.ArrayLike, references: Union[npt.ArrayLike, Sequence[npt.ArrayLike]]
) -> List[Metrics]:
    """Compare a segmentation with several others, such as those of several people.

    `numpy.mean([m.rand_index_error for m in result])` is the mean of a metric.

    Parameters
    ----------
    vertices, faces, labels : as for `evaluate()`
    references : (r, m) array of integers, or sequence of r arrays

    Returns
    -------
    list of Metrics
        One for each reference.
    """
    return _rows(vertices, faces, labels, references, "all")


def rand_index_error(vertices: npt.ArrayLike, faces: Faces, labels: npt.ArrayLike, reference: npt.ArrayLike) -> float:
    """The share of the pairs of faces on which two segmentations disagree, from 0 to 1.

    Parameters
    ----------
    vertices, faces, labels, reference : as for `evaluate()`
    """
    return _rows(vertices, faces, labels, [reference], "rand_index_error")[0].rand_index_error


def hamming_distance(vertices: npt.ArrayLike, faces: Faces, labels: npt.ArrayLike, reference: npt.ArrayLike) -> float:
    """The area on which the segments differ from the best ones of the other segmentation, as a share, from 0 to 1.

    The mean of both directions; `evaluate()` has both, as `missing_rate` and `false_alarm_rate`.

    Parameters
    ----------
    vertices, faces, labels, reference : as for `evaluate()`
    """
    return _rows(vertices, faces, labels, [reference], "hamming_distance")[0].hamming_distance


def cut_discrepancy(
    vertices: npt.ArrayLike, faces: Faces, labels: npt.ArrayLike, reference: npt.ArrayLike
) -> Optional[float]:
    """The mean distance between the borders of two segmentations, in average radii of the mesh; None without borders.

    Parameters
    ----------
    vertices, faces, labels, reference : as for `evaluate()`
    """
    return _rows(vertices, faces, labels, [reference], "cut_discrepancy")[0].cut_discrepancy


def consistency_error(vertices: npt.ArrayLike, faces: Faces, labels: npt.ArrayLike, reference: npt.ArrayLike) -> float:
    """How far one segmentation is from being a refinement of the other, from 0 to 1: the global error.

    `evaluate()` has the local error, and both by area, too.

    Parameters
    ----------
    vertices, faces, labels, reference : as for `evaluate()`
    """
    return _rows(vertices, faces, labels, [reference], "consistency_error")[0].global_consistency_error


def mean_best_intersection_over_union(
    vertices: npt.ArrayLike, faces: Faces, labels: npt.ArrayLike, reference: npt.ArrayLike
) -> float:
    """How well the parts of a reference are found, from 0 to 1, the metric of learned methods. Larger is better.

    The mean over the parts of the largest intersection over union with a segment. Faces are counted. Faces of the reference
    with a negative number are in no part.

    Parameters
    ----------
    vertices, faces, labels, reference : as for `evaluate()`
    """
    name = "mean_best_intersection_over_union"
    return _rows(vertices, faces, labels, [reference], name)[0].mean_best_intersection_over_union


def _rows(
    vertices: npt.ArrayLike,
    faces: Faces,
    labels: npt.ArrayLike,
    references: Union[npt.ArrayLike, Sequence[npt.ArrayLike]],
    metrics: str,
) -> List[Metrics]:
    ids = integers("labels", labels)
    try:
        others: List[Labels] = [integers("reference", reference) for reference in references]  # type: ignore
    except TypeError:
        raise ValueError("references: no sequence of arrays") from None
    return [Metrics(*row) for row in _core.evaluate(*mesh_arrays(vertices, faces), ids, others, metrics)]
