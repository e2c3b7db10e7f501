# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of small meshes whose coordinates are known, of parts, and beside others."""

import numpy as np
import pytest

from mesh_files import GltfFile, OffFile, PlyFile, labels, usda_list
from tool import names_in

# A box with a handle on it, of quads: off the origin, so that files show where it is.
QUADS = """OFF
12 10 0
10 20 30
12 20 30
12 22 30
10 22 30
10 20 32
12 20 32
12 22 32
10 22 32
10 20 37
12 20 37
12 22 37
10 22 37
4 0 3 2 1
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
4 4 5 9 8
4 5 6 10 9
4 6 7 11 10
4 7 4 8 11
4 8 9 10 11
"""


def test_flat_faces_have_their_normals_in_gltf(segment, tmp_path):
    (tmp_path / "a.off").write_text(QUADS)
    segment("a.off", *"-k 1 -o a.gltf".split())
    gltf = GltfFile(tmp_path / "a.gltf")
    normals = gltf.array(gltf.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"])
    assert np.array_equal(np.sort(np.abs(normals), axis=1), [[0, 0, 1]] * len(normals))


def test_far_from_the_origin_in_gltf(segment, tmp_path):
    """Single precision does not round it away: a node moves it, and nothing is scaled."""
    far = OffFile.of(OffFile.parse(QUADS).points + [5e5, 5e6, 0], OffFile.parse(QUADS).faces)
    far.write(tmp_path / "a.off")
    segment("a.off", *"-k 2 -o a.gltf".split())
    gltf = GltfFile(tmp_path / "a.gltf")
    root = gltf.json["nodes"][gltf.json["scenes"][0]["nodes"][0]]
    assert "scale" not in root
    positions = [gltf.array(mesh["primitives"][0]["attributes"]["POSITION"]) for mesh in gltf.json["meshes"]]
    assert np.allclose(np.vstack(positions).min(axis=0) + np.array(root["translation"]),
                       far.points.min(axis=0), rtol=0, atol=1e-6)


def test_polygons_stay(segment, tmp_path):
    (tmp_path / "a.off").write_text(QUADS)
    segment("a.off", *"-k 2 -o a.obj -o a.usda -o b.off".split())
    assert OffFile(tmp_path / "b.off").faces == OffFile(tmp_path / "a.off").faces
    assert (tmp_path / "a.obj").read_text().count(" 12\n") > 0
    assert usda_list((tmp_path / "a.usda").read_text(), "int[] faceVertexCounts") == 10 * [4]


def test_triangulate(segment, tmp_path):
    (tmp_path / "a.off").write_text(QUADS)
    segment("a.off", *"-k 2 --triangulate -o a.obj -o a.ply -o a.seg -o b.off -o p%d.obj".split())
    assert len(labels(tmp_path / "a.seg")) == 10
    assert [len(face) for face in OffFile(tmp_path / "b.off").faces] == 20 * [3]
    assert OffFile(tmp_path / "b.off").volume() == 28
    assert PlyFile(tmp_path / "a.ply").faces["old_face"].tolist() == [i // 2 for i in range(20)]
    for name in ("a.obj", "p0.obj", "p1.obj"):
        assert {len(line.split()) for line in (tmp_path / name).read_text().splitlines()
                if line.startswith("f ")} == {4}


@pytest.mark.parametrize("extension", ["off", "obj", "ply", "stl", "3mf", "glb", "usda", "vtp"])
def test_parts_of_any_format(segment, teddy, tmp_path, extension):
    """No file but those of the parts."""
    segment(teddy, "-k", 2, "-o", f"parts/%d.{extension}")
    assert names_in(tmp_path / "parts") == [f"0.{extension}", f"1.{extension}"]


@pytest.mark.parametrize("extension, library", [
    ("off", ""), ("obj", ""), ("ply", ""), ("stl", ""), ("3mf", "lib3mf"), ("glb", "tinygltf"), ("vtp", "vtk")])
@pytest.mark.parametrize("options", [[], ["--close"]])
def test_parts_land_in_place(segment, tmp_path, libraries, extension, library, options):
    """Files of parts, read one by one, are together where the mesh is."""
    if library and library not in libraries:
        pytest.skip(f"{library} was not found")
    (tmp_path / "a.off").write_text(QUADS)
    segment("a.off", "-k", 2, "-o", f"%d.{extension}", *options)
    points = []
    for number in range(2):
        segment(f"{number}.{extension}", *"-k 1 -o b.off".split())
        points.append(OffFile(tmp_path / "b.off").points)
    expected = OffFile.parse(QUADS).points
    assert {tuple(point) for point in np.vstack(points)} == {tuple(point) for point in expected}


def test_materials_cannot_be_written(segment, teddy, tmp_path):
    (tmp_path / "a.mtl").mkdir()
    segment.refuses(teddy, "-o", "a.obj", message="a.mtl: cannot be written")
    assert names_in(tmp_path) == ["a.mtl", "teddy.off"] or names_in(tmp_path) == ["a.mtl"]


@pytest.mark.parametrize("options", ["-o a.obj -o a.OBJ", "-o a.obj --tips a.mtl"])
def test_materials_in_the_place_of_another_file(segment, teddy, tmp_path, options):
    (tmp_path / "a.mtl").write_text('{"tips": [0]}')
    segment.refuses(teddy, *options.split(), code=2, message="a.mtl' is named twice")


def test_coordinates_beyond_single_precision(segment, data, tmp_path):
    segment.refuses(data / "huge_coordinates.off", "-o", "a.stl", message="a.stl: cannot be written: ")
    segment(data / "huge_coordinates.off", *"-o a.glb -o a.3mf -o a.usda -o a.obj".split())
