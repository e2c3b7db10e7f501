# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

from typing import Any, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

Integers = npt.NDArray[np.int64]
Coordinates = npt.NDArray[np.float64]
Row = Tuple[float, float, float, float, Optional[float], float, float, float, float, float]

version: str

def segment(vertices: Coordinates, corners: Integers, sizes: Integers, options: Dict[str, Any]) -> Dict[str, Any]: ...
def tips(vertices: Coordinates, corners: Integers, sizes: Integers, options: Dict[str, Any]) -> Integers: ...
def smooth_borders(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    options: Dict[str, Any],
    labels: Integers,
    number_of_iterations: int,
) -> Dict[str, Any]: ...
def closed_segments(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    options: Dict[str, Any],
    labels: Integers,
    parents: Integers,
    tips: Integers,
    are_caps_faired: bool,
) -> List[Tuple[Coordinates, Integers, Integers]]: ...
def closed_segments_with_connectors(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    options: Dict[str, Any],
    labels: Integers,
    parents: Integers,
    tips: Integers,
    connectors: Tuple[int, float, float, float, Optional[float], Optional[float]],
) -> Tuple[List[Tuple[Coordinates, Integers, Integers]], List[Tuple[Any, ...]]]: ...
def skeleton(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    options: Dict[str, Any],
    labels: Integers,
    parents: Integers,
    tips: Integers,
    number_of_inner_joints: int,
) -> Dict[str, Any]: ...
def evaluate(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    labels: Integers,
    references: List[Integers],
    metrics: str,
) -> List[Row]: ...
