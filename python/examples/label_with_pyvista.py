# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""label_with_pyvista.py INPUT: gives every face of a mesh of pyvista its segment, and shows them."""

import sys

import pyvista

import protrusion_segmentation


def label(mesh: pyvista.PolyData) -> None:
    mesh.cell_data["segment"] = protrusion_segmentation.segment(mesh.points, mesh.irregular_faces)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    mesh = pyvista.read(sys.argv[1])
    label(mesh)
    mesh.plot(scalars="segment", cmap="tab20")
