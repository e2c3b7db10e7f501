# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what the tools write, and measures it."""

import base64
import json
import re
import struct

import numpy as np


class OffFile:
    """The points and faces of a text OFF file."""

    def __init__(self, path):
        self.read(path.read_text(), path)

    @classmethod
    def of(cls, points, faces):
        result = cls.__new__(cls)
        result.keyword, result.points, result.faces = "OFF", np.array(points, float), faces
        return result

    @classmethod
    def parse(cls, text):
        result = cls.__new__(cls)
        result.read(text, "text")
        return result

    def write(self, path):
        lines = ["OFF", f"{len(self.points)} {len(self.faces)} 0"]
        lines += [" ".join(map(repr, map(float, point))) for point in self.points]
        lines += [" ".join(map(str, [len(face), *face])) for face in self.faces]
        path.write_text("\n".join(lines) + "\n")

    def read(self, text, path):
        words = []
        for line in text.splitlines():
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


def obj_labels(path, names=()):
    """For each face of an OBJ file the number in the name of its group, or that of the name."""
    result = []
    for line in path.read_text().splitlines():
        if line.startswith("g "):
            name = line.removeprefix("g ")
            label = names.index(name) if name in names else int(name.removeprefix("segment_"))
        elif line.startswith("f "):
            result.append(label)
    return result


class PlyFile:
    """The numbers of a PLY file of triangles in binary, as structured arrays."""

    TYPES = {"uchar": "u1", "int": "<i4", "uint": "<u4", "float": "<f4", "double": "<f8"}

    def __init__(self, path):
        content = path.read_bytes()
        begin = content.index(b"end_header\n") + len("end_header\n")
        arrays, fields = {}, {}
        for words in map(str.split, content[:begin].decode().splitlines()):
            if words[0] == "element":
                fields[words[1]] = (int(words[2]), [])
                current = fields[words[1]][1]
            elif words[0] == "property" and words[1] == "list":
                current += [("count", self.TYPES[words[2]]), ("corners", self.TYPES[words[3]], 3)]
            elif words[0] == "property":
                current.append((words[2], self.TYPES[words[1]]))
        for name, (count, types) in fields.items():
            arrays[name] = np.frombuffer(content, np.dtype(types), count, begin)
            begin += arrays[name].nbytes
        assert begin == len(content), f"{path}: has not the size that its header says"
        self.vertices, self.faces = arrays["vertex"], arrays["face"]

    def points(self):
        return np.column_stack([self.vertices[axis] for axis in "xyz"])


def read_stl(path):
    """The triangles of a binary STL file."""
    content = path.read_bytes()
    dtype = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    (number,) = struct.unpack("<I", content[80:84])
    assert len(content) == 84 + number * dtype.itemsize
    return np.frombuffer(content, dtype, number, 84)


class GltfFile:
    """The JSON and the buffer of a glTF file, binary or as text."""

    def __init__(self, path):
        content = path.read_bytes()
        if content[:4] == b"glTF":
            assert struct.unpack("<2I", content[4:12]) == (2, len(content))
            (size,) = struct.unpack("<I", content[12:16])
            assert content[16:20] == b"JSON" and content[24 + size:28 + size] == b"BIN\0"
            self.json, self.buffer = json.loads(content[20:20 + size]), content[28 + size:]
        else:
            self.json = json.loads(content)
            self.buffer = base64.b64decode(self.json["buffers"][0]["uri"].split(",")[1])
        assert self.json["buffers"][0]["byteLength"] == len(self.buffer)

    def array(self, index):
        accessor = self.json["accessors"][index]
        dimension = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[accessor["type"]]
        dtype = {5123: "<u2", 5125: "<u4", 5126: "<f4"}[accessor["componentType"]]
        view = self.json["bufferViews"][accessor["bufferView"]]
        assert view["byteOffset"] % np.dtype(dtype).itemsize == 0
        numbers = np.frombuffer(self.buffer, dtype, accessor["count"] * dimension, view["byteOffset"])
        array = numbers.reshape(-1, dimension)
        for key, bound in (("min", array.min(axis=0)), ("max", array.max(axis=0))):
            assert key not in accessor or np.allclose(accessor[key], bound)
        return array


def usda_list(text, name):
    """The numbers of the first list of that name in USD text."""
    begin = text.index(f"{name} = [") + len(f"{name} = [")
    return [float(number) if "." in number or "e" in number else int(number)
            for number in re.findall(r"[-+0-9.e]+", text[begin:text.index("]", begin)])]
