# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of labels. For meshes there are meshio, trimesh and pyvista: the examples show how."""

import os
from typing import Union

import numpy as np
import numpy.typing as npt

from ._arguments import Labels, integers

Path = Union[str, "os.PathLike[str]"]


def read_seg(path: Path) -> Labels:
    """Read a file of the Princeton Segmentation Benchmark: one label a line, in the order of the faces.

    Parameters
    ----------
    path : the name of the file
    """
    with open(path, encoding="ascii", errors="replace") as file:
        lines = file.read().split("\n")
    while lines and not lines[-1].strip():
        lines.pop()
    labels = []
    for number, line in enumerate(lines, start=1):
        if not line.strip().isdecimal():
            raise ValueError(f"{os.fspath(path)}: line {number} is no integer from 0, but {line[:30]!r}")
        labels.append(int(line))
    return np.array(labels, dtype=np.int64)


def write_seg(path: Path, labels: npt.ArrayLike) -> None:
    """Write a file of the Princeton Segmentation Benchmark: one label a line, in the order of the faces.

    Parameters
    ----------
    path : the name of the file
    labels : (m,) array of integers from 0
    """
    numbers = integers("labels", labels)
    if (numbers < 0).any():
        raise ValueError(f"labels: {numbers.min()} is no label, an integer from 0")
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.writelines(f"{label}\n" for label in numbers.tolist())
