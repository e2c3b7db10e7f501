# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

from typing import List, Optional, Tuple

import numpy as np
import numpy.typing as npt

Integers = npt.NDArray[np.int64]
Coordinates = npt.NDArray[np.float64]

version: str

def segment(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    number_of_segments: Optional[int],
    method: str,
    distance: Optional[str],
    random_seed: int,
    snapping_tolerance: Optional[float],
    joining_gap: Optional[float],
) -> Integers: ...
def segment_from_tips(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    tips: List[int],
    method: str,
    distance: Optional[str],
    random_seed: int,
    snapping_tolerance: Optional[float],
    joining_gap: Optional[float],
) -> Integers: ...
def hierarchy(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    maximum_number_of_segments: int,
    method: str,
    distance: Optional[str],
    random_seed: int,
    snapping_tolerance: Optional[float],
    joining_gap: Optional[float],
) -> Tuple[Integers, Integers]: ...
def tips(
    vertices: Coordinates,
    corners: Integers,
    sizes: Integers,
    number_of_tips: int,
    distance: str,
    random_seed: int,
    snapping_tolerance: Optional[float],
    joining_gap: Optional[float],
) -> Integers: ...
def evaluate(
    vertices: Coordinates, corners: Integers, sizes: Integers, labels: Integers, reference: Integers
) -> Tuple[float, float, float, float, Optional[float], float, float, float, float, float]: ...
