# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Methods and distances with options."""

import math
from dataclasses import dataclass
from typing import Any, Callable, Dict, Literal, NamedTuple, Optional, Tuple, Union, get_args

import numpy as np
import numpy.typing as npt

from ._arguments import checked_choice, checked_integer, checked_number


@dataclass(frozen=True)
class LandmarkDistance:
    """Shortest paths by way of random landmarks, the distance LGD of the paper, for `distance`.

    `LandmarkDistance(0.01)`, `LandmarkDistance(0.05)` and `LandmarkDistance(0.1)` are LGD(1), LGD(5) and LGD(10).

    Parameters
    ----------
    share : the share of the faces that are landmarks, above 0 and at most 1; default 0.05
    number : the number of landmarks, at least 1, in place of a share
    """

    share: float = 0.05
    number: Optional[int] = None

    def __post_init__(self) -> None:
        if not 0 < checked_number("share", self.share) <= 1:
            raise ValueError(f"share is {self.share}, but it must be above 0 and at most 1")
        if self.number is not None and checked_integer("number", self.number) < 1:
            raise ValueError(f"number is {self.number}, but it must be at least 1")


@dataclass(frozen=True)
class DiffusionDistance:
    """How differently two random walks spread, the distance DD of the paper, for `distance`.

    `DiffusionDistance(terms=k)` is DD(k).

    Parameters
    ----------
    terms : the number of eigenvectors, from 1 to 300; default 10
    time : the time of the walk, at least 0; after a time of 1 the slowest term has decayed to 1/e; default 0.5
    """

    terms: int = 10
    time: float = 0.5

    def __post_init__(self) -> None:
        if not 1 <= checked_integer("terms", self.terms) <= 300:
            raise ValueError(f"terms is {self.terms}, but it must be from 1 to 300")
        if not 0 <= checked_number("time", self.time) < math.inf:
            raise ValueError(f"time is {self.time}, but it must be at least 0")


@dataclass(frozen=True)
class PaperMethod:
    """The method of Aono, Wakida and Tatsuma (2012), for `method`.

    Parameters
    ----------
    minimum_prominence : the least prominence of a border, above 0: the natural logarithm of the ratio of the diameters
        behind and at it. Less gives more segments; a sphere has 0.33; default 0.4. If fewer segments than asked for are
        found, it is halved until there are enough.
    uses_candidate_intervals : whether a border must lie where the histogram of distances changes, as in Section III.D.3;
        default True
    """

    minimum_prominence: float = 0.4
    uses_candidate_intervals: bool = True

    def __post_init__(self) -> None:
        if not 0 < checked_number("minimum_prominence", self.minimum_prominence) < math.inf:
            raise ValueError(f"minimum_prominence is {self.minimum_prominence}, but it must be above 0")


class DualGraph(NamedTuple):
    """The face dual graph of a connected piece of the mesh, for a distance of one's own.

    The faces of the piece are numbered from 0. `scipy.sparse.csr_matrix((lengths, neighbors, first_arcs))` is the graph.
    Coordinates are moved, turned and scaled so that the whole fits into [-1, 1] in each direction.
    """

    centroids: npt.NDArray[np.float64]
    areas: npt.NDArray[np.float64]
    first_arcs: npt.NDArray[np.int64]
    neighbors: npt.NDArray[np.int64]
    lengths: npt.NDArray[np.float64]


DualGraph.centroids.__doc__ = "(m, 3) array: the centre of gravity of each face"
DualGraph.areas.__doc__ = "(m,) array: the area of each face"
DualGraph.first_arcs.__doc__ = "(m + 1,) array: the arcs of face f are first_arcs[f] to first_arcs[f + 1] - 1"
DualGraph.neighbors.__doc__ = "(a,) array: the face that each arc leads to"
DualGraph.lengths.__doc__ = "(a,) array: the distance between the centroids of the two faces of each arc"

MethodName = Literal["minimum-cut", "paper"]
DistanceName = Literal["geodesic", "landmark", "diffusion", "heat", "exact"]
OwnDistance = Callable[[DualGraph], Callable[[int], npt.ArrayLike]]
Method = Union[MethodName, PaperMethod]
Distance = Union[DistanceName, LandmarkDistance, DiffusionDistance, OwnDistance]


def options_of_method(method: Method) -> Dict[str, Any]:
    """The options as C++ calls them."""
    if isinstance(method, PaperMethod):
        return {
            "method": "paper",
            "minimum_prominence": float(method.minimum_prominence),
            "uses_candidate_intervals": bool(method.uses_candidate_intervals),
        }
    if checked_choice("method", method, get_args(MethodName)) == "paper":
        return options_of_method(PaperMethod())
    return {"method": method}


def options_of_distance(distance: Optional[Distance]) -> Dict[str, Any]:
    """The options as C++ calls them."""
    if distance is None:
        return {}
    if distance == "landmark":
        distance = LandmarkDistance()
    if distance == "diffusion":
        distance = DiffusionDistance()
    if isinstance(distance, LandmarkDistance):
        share, number = float(distance.share), distance.number
        return {"distance": "landmark", "share_of_landmarks": share, "number_of_landmarks": number}
    if isinstance(distance, DiffusionDistance):
        return {"distance": "diffusion", "number_of_terms": distance.terms, "time": float(distance.time)}
    if callable(distance):
        return {"own_distance": _on_arrays(distance), "is_metric": bool(getattr(distance, "is_metric", False))}
    return {"distance": checked_choice("distance", distance, get_args(DistanceName))}


def _on_arrays(distance: OwnDistance) -> Callable[..., Callable[[int], npt.NDArray[np.float64]]]:
    """The distance as C++ calls it: with the arrays of the graph."""

    def on_arrays(*arrays: Any) -> Callable[[int], npt.NDArray[np.float64]]:
        graph = DualGraph(*arrays)
        from_face = distance(graph)
        if not callable(from_face):
            raise ValueError(f"distance: what it gives for a graph is no function, but {from_face!r}")

        def checked(face: int) -> npt.NDArray[np.float64]:
            return _checked_distances(from_face(face), graph.areas.shape)

        return checked

    return on_arrays


def _checked_distances(distances: npt.ArrayLike, shape: Tuple[int, ...]) -> npt.NDArray[np.float64]:
    array = np.asarray(distances)
    if array.dtype.kind not in "iuf":
        raise ValueError("distance: what it gives for a face is no array of numbers")
    if array.shape != shape:
        raise ValueError(f"distance: what it gives for a face has the shape {array.shape}, not {shape}")
    return array.astype(np.float64)
