# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of arguments, which name them, and arrays as C++ takes them."""

import itertools
import operator
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

Labels = npt.NDArray[np.int64]
Faces = Union[npt.ArrayLike, Sequence[Sequence[int]], Sequence[npt.NDArray[Any]]]
Arrays = Tuple[npt.NDArray[np.float64], Labels, Labels]


def mesh_arrays(vertices: npt.ArrayLike, faces: Faces) -> Arrays:
    """The coordinates, the corners of all faces, and the number of corners of each."""
    return (_points(vertices), *_corners_and_sizes(faces))


def faces_of_corners(corners: Labels, sizes: Labels) -> Union[Labels, List[Labels]]:
    """An array if all faces are triangles, else a list."""
    if (sizes == 3).all():
        return corners.reshape(-1, 3)
    return np.split(corners, np.cumsum(sizes)[:-1])


def _points(vertices: npt.ArrayLike) -> npt.NDArray[np.float64]:
    _check_no_mask("vertices", vertices)
    try:
        points = np.asarray(vertices)
        if points.dtype.kind not in "fiuO":
            raise ValueError(f"coordinates are no real numbers, but of type {points.dtype}")
        points = np.ascontiguousarray(points, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"vertices: {error}") from None
    if points.ndim != 2 or points.shape[1] != 3:
        is_transposed = points.ndim == 2 and points.shape[0] == 3
        raise ValueError(f"vertices: the shape is {points.shape}, not (n, 3){'; vertices.T has it' if is_transposed else ''}")
    return points


def _corners_and_sizes(faces: Faces) -> Tuple[Labels, Labels]:
    _check_no_mask("faces", faces)
    if isinstance(faces, np.ndarray) and faces.dtype != object:
        if faces.dtype.kind in "iu":
            _check_layout(faces)
        if faces.ndim != 2:
            raise ValueError(f"faces: the shape is {faces.shape}, not (m, 3)")
        return integers("faces", faces.reshape(-1)), np.full(faces.shape[0], faces.shape[1], np.int64)
    try:
        polygons: List[Sequence[int]] = list(faces)  # type: ignore[arg-type]
        sizes = np.fromiter(map(len, polygons), np.int64, len(polygons))
        corners = list(itertools.chain.from_iterable(polygons))
    except TypeError:
        raise ValueError("faces: neither an array of shape (m, 3) nor a sequence of polygons") from None
    numbers = integers("faces", corners)
    if sizes.size > 0 and sizes[0] > 0 and (sizes == sizes[0]).all():
        _check_layout(numbers.reshape(-1, sizes[0]))
    return numbers, sizes


def _check_layout(faces: npt.NDArray[Any]) -> None:
    """Other layouts of triangles, named as such: what they would mean here makes no sense."""
    rows = faces.reshape(-1, 4) if faces.ndim == 1 and faces.size % 4 == 0 else faces
    if rows.ndim == 2 and rows.shape[1] > 3 and _begin_with_size(rows):
        raise ValueError(
            f"faces: in VTK's layout, with the number of corners, {rows.shape[1] - 1}, before each face; "
            f"faces.reshape(-1, {rows.shape[1]})[:, 1:] are the corners"
        )
    if faces.ndim == 2 and faces.shape[0] == 3 and faces.shape[1] > 3:
        if any(_repeats(row) for row in faces) and not any(_repeats(column) for column in faces.T):
            raise ValueError(f"faces: the shape is {faces.shape}, not (m, 3); faces.T has it")


def _begin_with_size(rows: npt.NDArray[Any]) -> bool:
    """Whether each row is a number of corners and as many corners. Polygons around one vertex have that once each."""
    size = rows.shape[1] - 1
    return bool(rows.shape[0] > 1 and (rows[:, 0] == size).all() and (rows[:, 1:] == size).any())


def _repeats(row: npt.NDArray[Any]) -> bool:
    return bool(np.unique(row).size < row.size)


def _check_no_mask(name: str, values: Any) -> None:
    """A value under a mask is no value, and nothing else is told of it."""
    if isinstance(values, np.ma.MaskedArray):
        raise ValueError(f"{name}: a masked array; use {name}.compressed() or {name}.filled()")


def integers(name: str, values: npt.ArrayLike) -> Labels:
    """A row of integers, whatever it was. Numbers of no integer type are no integers, even if they are whole."""
    _check_no_mask(name, values)
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


def checked_integer(name: str, value: int) -> int:
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


def integer_from(name: str, value: int, least: int, most: int) -> int:
    """The number, if it is an integer from `least` to `most`."""
    number = checked_integer(name, value)
    if not least <= number <= most:
        raise ValueError(f"{name} is {number}, but it must be from {least} to {most}")
    return number


def checked_number(name: str, value: float) -> float:
    """The number, which may be infinite."""
    if isinstance(value, (bool, np.bool_)):
        raise ValueError(f"{name} is no number, but {value}")
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is no number, but {value!r}") from None


def checked_choice(name: str, value: Any, choices: Tuple[str, ...]) -> str:
    """The value, if it is one of the choices."""
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name} is {value!r}, but it must be {', '.join(choices[:-1])} or {choices[-1]}")
    return value


def checked_tolerance(value: Optional[float]) -> Optional[float]:
    """None if the tolerance is that of the package."""
    if value is None:
        return None
    tolerance = checked_number("snapping_tolerance", value)
    if not 0 <= tolerance < float("inf"):
        raise ValueError(f"snapping_tolerance is {value}, but it must be a distance, at least 0")
    return tolerance


def checked_gap(value: Union[bool, float]) -> Tuple[bool, Optional[float]]:
    """Whether pieces are joined, and the gap, which is None if it is that of the package."""
    if isinstance(value, (bool, np.bool_)):
        return bool(value), None
    try:
        gap = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"join_pieces is neither true nor false nor a number, but {value!r}") from None
    if not 0 < gap < float("inf"):
        raise ValueError(f"join_pieces is {value}, but a gap must be a distance above 0")
    return True, gap
