# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""glTF as input: all triangles of a scene, where its nodes put them."""

import base64
import json

import numpy as np
import pytest

from mesh_files import OffFile, PlyFile, labels

TRIANGLES, STRIP, FAN = 4, 5, 6
FLOAT, UNSIGNED_BYTE, UNSIGNED_SHORT, SHORT = 5126, 5121, 5123, 5122
TYPES = {FLOAT: "<f4", UNSIGNED_BYTE: "u1", UNSIGNED_SHORT: "<u2", SHORT: "<i2"}

TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
CORNERS = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]


@pytest.fixture(autouse=True)
def with_tinygltf(libraries):
    if "tinygltf" not in libraries:
        pytest.skip("tinygltf was not found")


class Scene:
    """A glTF file that is being made."""

    def __init__(self):
        self.bytes = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}]}

    def add(self, kind, element):
        self.json.setdefault(kind, []).append(element)
        return len(self.json[kind]) - 1

    def accessor(self, numbers, kind, of_numbers, **more):
        array = np.array(numbers).astype(TYPES[of_numbers])
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        view = self.add("bufferViews", {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": array.nbytes})
        self.bytes += array.tobytes()
        return self.add("accessors", {"bufferView": view, "componentType": of_numbers, "type": kind,
                                      "count": len(array), **more})

    def mesh(self, points=TETRAHEDRON, corners=CORNERS, mode=TRIANGLES, of_points=FLOAT, **more):
        primitive = {"attributes": {"POSITION": self.accessor(points, "VEC3", of_points, **more)}, "mode": mode}
        if corners is not None:
            primitive["indices"] = self.accessor(corners, "SCALAR", UNSIGNED_SHORT)
        return self.add("meshes", {"primitives": [primitive]})

    def node(self, is_root=True, **node):
        index = self.add("nodes", node)
        if is_root:
            self.json["scenes"][0]["nodes"].append(index)
        return index

    def write(self, path, buffer=None):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
        if buffer:
            (path.parent / buffer).write_bytes(self.bytes)
        self.json["buffers"] = [{"byteLength": len(self.bytes), "uri": buffer or uri}]
        path.write_text(json.dumps(self.json))


def read(segment, tmp_path, scene, **options):
    scene.write(tmp_path / "a.gltf", **options)
    segment("a.gltf", "-k", 1, "-o", "b.off")
    return OffFile(tmp_path / "b.off")


@pytest.mark.parametrize("extension", ["glb", "gltf"])
@pytest.mark.parametrize("options", [[], ["--one-object"], ["--up", "z"]])
def test_what_was_written(segment, teddy, tmp_path, extension, options):
    """The same labels as from PLY, whatever the nodes are; turned with --up z."""
    points = OffFile(teddy).points.astype("f4").astype(float) # as glTF has them
    OffFile.of(points, OffFile(teddy).faces).write(tmp_path / "a.off")
    segment("a.off", *"-k 5 -o a.seg -o".split(), f"b.{extension}", *options)
    segment(f"b.{extension}", *"-k 5 -o b.seg -o b.ply".split())
    assert labels(tmp_path / "b.seg") == sorted(labels(tmp_path / "a.seg"))
    ply = PlyFile(tmp_path / "b.ply")
    expected = points @ [[1, 0, 0], [0, 0, -1], [0, 1, 0]] if "--up" in options else points
    for bound in (np.min, np.max):
        assert np.allclose(bound(ply.points(), axis=0), bound(expected, axis=0), atol=1e-6)
    segment("b.ply", *"-k 5 -o c.seg".split())
    assert labels(tmp_path / "c.seg") == labels(tmp_path / "b.seg")


def test_nodes_move_meshes(segment, tmp_path):
    """Scaled, then turned from x to y, then moved; and moved by the matrix of the node around it."""
    scene = Scene()
    half = .5**.5
    inner = scene.node(is_root=False, mesh=scene.mesh(), translation=[10, 0, 0], rotation=[0, 0, half, half],
                       scale=[2, 3, 4])
    scene.node(children=[inner], matrix=[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 100, 1])
    mesh = read(segment, tmp_path, scene)
    assert np.allclose(mesh.points, [[10, 0, 100], [10, 2, 100], [7, 0, 100], [10, 0, 104]], atol=1e-6)
    assert mesh.volume() == pytest.approx(2 * 3 * 4 / 6)


def test_one_mesh_in_two_nodes_one_mirrored(segment, tmp_path):
    scene = Scene()
    mesh = scene.mesh()
    scene.node(mesh=mesh, translation=[5, 0, 0])
    scene.node(mesh=mesh, scale=[-1, 1, 1])
    written = read(segment, tmp_path, scene)
    assert len(written.faces) == 8
    assert written.is_closed() and written.volume() == pytest.approx(2 / 6)


def test_only_nodes_of_the_scene(segment, tmp_path):
    scene = Scene()
    scene.node(mesh=scene.mesh())
    scene.node(is_root=False, mesh=0, translation=[9, 9, 9])
    assert len(read(segment, tmp_path, scene).faces) == 4
    del scene.json["scenes"], scene.json["scene"]
    assert len(read(segment, tmp_path, scene).faces) == 8


def test_strips_fans_and_no_indices(segment, tmp_path):
    scene = Scene()
    scene.node(mesh=scene.mesh(corners=[0, 1, 2, 3], mode=STRIP))
    scene.node(mesh=scene.mesh(corners=[0, 1, 2, 3], mode=FAN), translation=[5, 0, 0])
    scene.node(mesh=scene.mesh(points=TETRAHEDRON[CORNERS], corners=None), translation=[9, 0, 0])
    scene.node(mesh=scene.mesh(mode=1)) # lines
    faces = read(segment, tmp_path, scene).faces
    assert faces[:4] == [[0, 1, 2], [2, 1, 3], [4, 5, 6], [4, 6, 7]]
    assert len(faces) == 8


def test_quantized_positions(segment, tmp_path):
    scene = Scene()
    scene.json["extensionsRequired"] = scene.json["extensionsUsed"] = ["KHR_mesh_quantization"]
    scene.node(mesh=scene.mesh(points=32767 * TETRAHEDRON, of_points=SHORT, normalized=True))
    assert np.allclose(read(segment, tmp_path, scene).points, TETRAHEDRON)


def test_buffer_in_a_file_of_its_own(segment, tmp_path):
    scene = Scene()
    scene.node(mesh=scene.mesh())
    assert len(read(segment, tmp_path, scene, buffer="a.bin").faces) == 4
    (tmp_path / "folder").mkdir()
    scene.write(tmp_path / "folder/a.gltf", buffer="a.bin")
    segment("folder/a.gltf")


def test_seams_are_no_borders(segment, tmp_path):
    """Each triangle has vertices of its own, as at seams of textures; the surface is closed."""
    scene = Scene()
    scene.node(mesh=scene.mesh(points=TETRAHEDRON[CORNERS], corners=None))
    scene.write(tmp_path / "a.gltf")
    assert segment.record("a.gltf", "-k", 1)["surface"]["components"] == 1
    assert "stay open" not in segment("a.gltf", *"-k 2 --close -o %d.off".split()).err


@pytest.mark.parametrize("name", ["tetrahedron.gltf"])
def test_pipe(segment, data, name):
    assert len(segment("-", *"-k 2 -o -".split(), input=(data / name).read_bytes()).out.splitlines()) == 4
