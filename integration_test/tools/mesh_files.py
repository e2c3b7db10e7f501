# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what the tools write, and measures it."""

import numpy as np


class OffFile:
    """The points and faces of a text OFF file."""

    def __init__(self, path):
        words = []
        for line in path.read_text().splitlines():
            content = line.split("#")[0].split()
            if content:
                words.append(content)
        self.keyword = words[0][0]
        number_of_points, number_of_faces = map(int, words[1][:2])
        points, faces = words[2:2 + number_of_points], words[2 + number_of_points:]
        assert len(faces) == number_of_faces, f"{path}: has not {number_of_faces} faces"
        self.points = np.array(points, float)[:, :3]
        self.faces = [[int(corner) for corner in face[1:1 + int(face[0])]] for face in faces]

    def is_closed(self):
        """Whether each edge is that of one face in either direction."""
        edges = [edge for face in self.faces for edge in zip(face, face[1:] + face[:1])]
        different = set(edges)
        return len(edges) == len(different) and all((b, a) in different for a, b in edges)

    def volume(self):
        triangles = np.array([(face[0], face[i], face[i + 1])
                              for face in self.faces for i in range(1, len(face) - 1)])
        a, b, c = self.points[triangles].transpose(1, 0, 2)
        return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def volume_of_closed(paths):
    """The volume of all together; each must be closed."""
    meshes = [OffFile(path) for path in paths]
    for path, mesh in zip(paths, meshes):
        assert mesh.is_closed(), f"{path}: is not closed"
    return sum(mesh.volume() for mesh in meshes)


def labels(path):
    return [int(line) for line in path.read_text().splitlines()]


def vtp_array(path, name):
    """The numbers of a data array of a VTP file in text."""
    text = path.read_text()
    begin = text.index(">", text.index(f'Name="{name}"')) + 1
    return [float(word) for word in text[begin:text.index("</DataArray>", begin)].split()]


def obj_labels(path):
    """For each face of an OBJ file the number in the name of its group."""
    result = []
    for line in path.read_text().splitlines():
        if line.startswith("g segment_"):
            label = int(line.removeprefix("g segment_"))
        elif line.startswith("f "):
            result.append(label)
    return result
