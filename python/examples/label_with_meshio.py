# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""label_with_meshio.py INPUT OUTPUT: gives every polygon of a mesh of meshio its segment, as cell data."""

import sys

import meshio
import numpy as np

import protrusion_segmentation

POLYGONS = ("triangle", "quad", "polygon")


def label(mesh: meshio.Mesh) -> None:
    blocks = [block.data if block.type in POLYGONS else [] for block in mesh.cells]
    labels = protrusion_segmentation.segment(mesh.points, [face for block in blocks for face in block])
    begin = 0
    mesh.cell_data["segment"] = []
    for block, cells in zip(blocks, mesh.cells):
        of_block = labels[begin : begin + len(block)] if len(block) else np.full(len(cells), -1)  # no faces
        mesh.cell_data["segment"].append(of_block)
        begin += len(block)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    mesh = meshio.read(sys.argv[1])
    label(mesh)
    mesh.write(sys.argv[2])
