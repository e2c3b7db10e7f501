# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What other programs find in the files: segments, coordinates, names, colours."""

import json
import math
import xml.etree.ElementTree
import zipfile

import numpy as np
import pytest

from mesh_files import (GltfFile, OffFile, PlyFile, labels, obj_labels, read_stl, usda_list, vtp_array)
from tool import Tool

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
SETS = "{http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07}"
PRUSA = "{http://schemas.slic3r.org/3mf/2017/06}"
PAINTINGS = ["4", "8", "0C", "1C", "2C"]

@pytest.fixture(scope="module")
def teddy(example_meshes):
    return example_meshes / "teddy.off"


@pytest.fixture(scope="module")
def outputs(programs, teddy, tmp_path_factory):
    """The folder of all formats of one segmentation with five segments and names."""
    folder = tmp_path_factory.mktemp("formats")
    (folder / "names.json").write_text(json.dumps(
        {"names": [{"segment": 1, "name": 'left <ear> "1"'}, {"segment": 2, "name": "2 legs"}]}))
    names = "a.seg a.npy a.ply a.obj a.stl a.3mf a.glb a.gltf a.usda a.vtp".split()
    Tool(programs / "segment_by_protrusions", folder)(
        teddy, "-k", 5, "--names", "names.json", *(word for name in names for word in ("-o", name)))
    return folder


@pytest.fixture(scope="module")
def mesh(teddy):
    return OffFile(teddy)


def model_of(path):
    """The XML of a 3MF file."""
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        assert archive.namelist() == ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"]
        return xml.etree.ElementTree.fromstring(archive.read("3D/3dmodel.model"))


def mesh_of_object(element):
    points = [[float(vertex.get(axis)) for axis in "xyz"] for vertex in element.iter(CORE + "vertex")]
    return OffFile.of(points, [[int(triangle.get(f"v{i}")) for i in (1, 2, 3)]
                               for triangle in element.iter(CORE + "triangle")])


def test_npy(outputs):
    array = np.load(outputs / "a.npy")
    assert array.dtype == np.int32
    assert array.tolist() == labels(outputs / "a.seg")


def test_labels_from_npy(outputs, segment, teddy):
    segment(teddy, "--labels", outputs / "a.npy", "-o", "b.seg")


def test_ply(outputs, mesh):
    ply = PlyFile(outputs / "a.ply")
    segments = labels(outputs / "a.seg")
    assert ply.faces["segment"].tolist() == segments == ply.faces["quality"].tolist()
    assert np.array_equal(ply.points(), mesh.points)
    around = [set() for _ in mesh.points]
    for face, label in zip(mesh.faces, segments):
        for corner in face:
            around[corner].add(label)
    assert all(label in of_point for label, of_point in zip(ply.vertices["segment"], around))


def test_obj(outputs, mesh):
    """Faces are there segment by segment, in their order in each, with materials of the file beside."""
    segments = labels(outputs / "a.seg")
    assert obj_labels(outputs / "a.obj", ["segment_0", "left__ear___1_", "2_legs"]) == sorted(segments)
    lines = (outputs / "a.obj").read_text().splitlines()
    faces = [[int(word) - 1 for word in line.split()[1:]] for line in lines if line.startswith("f ")]
    assert faces == [mesh.faces[i] for i in np.argsort(segments, kind="stable")]
    assert lines[0] == "mtllib a.mtl"
    used = [line.split()[1] for line in lines if line.startswith("usemtl ")]
    assert used == [line.split()[1] for line in lines if line.startswith("g ")]
    assert used == [line.split()[1] for line in (outputs / "a.mtl").read_text().splitlines()
                    if line.startswith("newmtl ")]


def test_stl(outputs, mesh):
    triangles = read_stl(outputs / "a.stl")
    assert np.array_equal(triangles["corners"], mesh.points[np.array(mesh.faces)].astype("f4"))
    a, b, c = triangles["corners"].transpose(1, 0, 2).astype(float)
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    assert np.allclose(triangles["normal"], normals, atol=1e-5)


def test_stl_of_closed_parts(outputs, segment, teddy, mesh, tmp_path):
    segment(teddy, "--labels", outputs / "a.seg", "--close", "-o", "%d.stl")
    volume = 0
    for number in range(5):
        corners = read_stl(tmp_path / f"{number}.stl")["corners"].astype(float)
        volume += np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert math.isclose(volume, mesh.volume(), rel_tol=1e-4)


def test_triangles_and_sets_of_3mf(outputs, mesh):
    model = model_of(outputs / "a.3mf")
    segments = labels(outputs / "a.seg")
    written = mesh_of_object(model)
    assert np.array_equal(written.points, mesh.points) and written.faces == mesh.faces
    triangles = list(model.iter(CORE + "triangle"))
    assert [int(triangle.get("p1")) for triangle in triangles] == segments
    for attribute in ("paint_color", PRUSA + "mmu_segmentation"):
        assert [triangle.get(attribute) for triangle in triangles] == [PAINTINGS[s] for s in segments]
    in_sets = [None] * len(segments)
    sets = list(model.iter(SETS + "triangleset"))
    for number, triangle_set in enumerate(sets):
        for run in triangle_set:
            for triangle in range(int(run.get("startindex")), int(run.get("endindex")) + 1):
                assert in_sets[triangle] is None
                in_sets[triangle] = number
    assert in_sets == segments
    names = [element.get("name") for element in sets]
    assert names == ["segment 0", 'left <ear> "1"', "2 legs", "segment 3", "segment 4"]
    assert [base.get("name") for base in model.iter(CORE + "base")] == names


def test_parts_in_3mf(outputs, segment, teddy, mesh, tmp_path):
    """A closed object for each segment, all of them components of one."""
    segment(teddy, "--labels", outputs / "a.seg", "--close", "-o", "a.3mf")
    objects = list(model_of(tmp_path / "a.3mf").iter(CORE + "object"))
    assert [element.get("objectid") for element in objects[-1].iter(CORE + "component")] == \
        [element.get("id") for element in objects[:-1]]
    assert [element.get("name") for element in objects] == \
        [f"segment {i}" for i in range(5)] + ["mesh"]
    assert [element.get("pindex") for element in objects[:-1]] == list("01234")
    parts = [mesh_of_object(element) for element in objects[:-1]]
    assert all(part.is_closed() for part in parts)
    assert math.isclose(sum(part.volume() for part in parts), mesh.volume(), rel_tol=1e-6)


def test_3mf_is_read_as_it_was_written(outputs, segment, tmp_path, mesh, libraries):
    if "lib3mf" not in libraries:
        pytest.skip("lib3mf was not found")
    segment(outputs / "a.3mf", "-k", 5, "-o", "b.off")
    written = OffFile(tmp_path / "b.off")
    assert np.allclose(written.points, mesh.points, atol=1e-6) and written.faces == mesh.faces


@pytest.mark.parametrize("name", ["a.glb", "a.gltf"])
def test_gltf(outputs, mesh, name):
    """A node for each segment, with the coordinates of the mesh and normals that fit the faces."""
    gltf = GltfFile(outputs / name)
    assert [node["name"] for node in gltf.json["nodes"]] == \
        ["segment 0", 'left <ear> "1"', "2 legs", "segment 3", "segment 4"]
    assert "scale" not in str(gltf.json["nodes"])
    segments = np.array(labels(outputs / "a.seg"))
    for number, node in enumerate(gltf.json["nodes"]):
        (primitive,) = gltf.json["meshes"][node["mesh"]]["primitives"]
        arrays = {key: gltf.array(index) for key, index in primitive["attributes"].items()}
        triangles = gltf.array(primitive["indices"]).reshape(-1, 3)
        corners = arrays["POSITION"][triangles]
        assert np.array_equal(corners, mesh.points[np.array(mesh.faces)[segments == number]].astype("f4"))
        assert set(arrays["_SEGMENT"].flat) == {number}
        assert np.allclose(np.linalg.norm(arrays["NORMAL"], axis=1), 1, atol=1e-5)
        a, b, c = corners.transpose(1, 0, 2).astype(float)
        normals = np.cross(b - a, c - a)
        assert (np.einsum("ik,ijk->ij", normals, arrays["NORMAL"][triangles]) > 0).all()


def test_one_object_upright_in_gltf(outputs, segment, teddy, mesh, tmp_path):
    segment(teddy, "--labels", outputs / "a.seg", "-o", "a.gltf", *"--one-object --up z".split())
    gltf = GltfFile(tmp_path / "a.gltf")
    (node,) = gltf.json["nodes"]
    x, y, z, w = node["rotation"]
    assert np.allclose([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], [0, 1, 0])
    primitives = gltf.json["meshes"][node["mesh"]]["primitives"]
    assert [primitive["material"] for primitive in primitives] == list(range(5))
    positions = np.vstack([gltf.array(p["attributes"]["POSITION"]) for p in primitives])
    assert np.allclose(positions.min(axis=0), mesh.points.min(axis=0), atol=1e-6)
    assert np.allclose(positions.max(axis=0), mesh.points.max(axis=0), atol=1e-6)


def test_usda(outputs, mesh):
    text = (outputs / "a.usda").read_text()
    segments = labels(outputs / "a.seg")
    assert 'upAxis = "Y"' in text
    assert usda_list(text, "int[] faceVertexIndices") == [corner for face in mesh.faces for corner in face]
    assert np.array_equal(usda_list(text, "point3f[] points"), mesh.points.flatten())
    assert usda_list(text, "int[] primvars:segment") == segments
    subsets = text.split("def GeomSubset ")[1:]
    assert [subset.split('"')[1] for subset in subsets] == \
        ["segment_0", "left__ear___1_", "_2_legs", "segment_3", "segment_4"]
    assert 'displayName = "left <ear> \\"1\\""' in text
    for number, subset in enumerate(subsets):
        assert usda_list(subset, "int[] indices") == [i for i, s in enumerate(segments) if s == number]


def test_name_of_the_array_in_vtp(outputs, segment, teddy, tmp_path, libraries):
    segment(teddy, "--labels", outputs / "a.seg", *"-o a.vtp --array-name Label".split())
    assert vtp_array(tmp_path / "a.vtp", "Label") == labels(outputs / "a.seg")
    assert 'Name="segment"' not in (tmp_path / "a.vtp").read_text()
    if "vtk" in libraries:
        segment(teddy, "--labels", "a.vtp")


@pytest.mark.parametrize("name", ["a b", 'a"b', "color"])
def test_bad_name_of_the_array(segment, teddy, name):
    segment.refuses(teddy, f"--array-name={name}", code=2, message=f"--array-name: '{name}' is ")


def test_meshio(outputs, mesh):
    """It knows no PLY in binary whose faces have more than corners."""
    meshio = pytest.importorskip("meshio")
    for extension in ("obj", "stl"):
        read = meshio.read(outputs / f"a.{extension}")
        assert sum(len(block.data) for block in read.cells) == len(mesh.faces), extension


def test_stl_far_from_the_origin(segment, teddy, tmp_path):
    """Sides of faces that single precision loses are told."""
    mesh = OffFile(teddy)
    OffFile.of(mesh.points + 1e7, mesh.faces).write(tmp_path / "far.off")
    note = "STL has single precision"
    assert note in segment("far.off", *"-k 3 -o a.stl".split()).err
    assert note in segment("far.off", *"-k 3 -o parts/%d.stl --close".split()).err
    assert note not in segment("far.off", *"-k 3 -o a.ply".split()).err
    assert note not in segment(teddy, *"-k 3 -o b.stl".split()).err
