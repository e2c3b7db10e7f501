# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""label_with_trimesh.py INPUT OUTPUT: gives every face of a mesh of trimesh its segment and a colour."""

import sys

import trimesh

import protrusion_segmentation


def label(mesh: trimesh.Trimesh) -> None:
    labels = protrusion_segmentation.segment(mesh.vertices, mesh.faces)
    mesh.face_attributes["segment"] = labels
    colors = trimesh.visual.interpolate(labels, color_map="viridis")
    mesh.visual = trimesh.visual.ColorVisuals(mesh, face_colors=colors)  # in place of a texture, if there is one


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    mesh = trimesh.load(sys.argv[1], force="mesh")
    label(mesh)
    mesh.export(sys.argv[2])
