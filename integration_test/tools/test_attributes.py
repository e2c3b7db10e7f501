# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a file says besides points and faces comes out again: texture coordinates, normals, colours, materials."""

import base64
import json

import numpy as np
import pytest

from mesh_files import GltfFile, OffFile, PlyFile, labels

# Whatever is not planar or symmetric would do: a coordinate tells which corner it is of.
def texture_of(points):
    return np.column_stack([points @ [.25, .5, 0], points @ [0, .5, .125]])


def normal_of(points):
    return points / np.linalg.norm(points, axis=1)[:, None]


def color_of(points):
    return np.clip(np.rint(128 + 40 * points), 0, 255).astype(int)


class ObjFile:
    """An OBJ file with corners as triples of vertex, texture and normal, and what is used for each face."""

    def __init__(self, path):
        self.points, self.textures, self.normals, self.colors = [], [], [], []
        self.faces, self.materials, self.groups, self.files = [], [], [], []
        material = group = None
        for line in path.read_text().splitlines():
            keyword, *words = line.split()
            if keyword == "v":
                self.points.append(list(map(float, words[:3])))
                self.colors.append(list(map(float, words[3:])))
            elif keyword in ("vt", "vn"):
                (self.textures if keyword == "vt" else self.normals).append(list(map(float, words)))
            elif keyword == "usemtl":
                material = words[0]
            elif keyword == "g":
                group = words[0]
            elif keyword == "mtllib":
                self.files.append(words[0])
            elif keyword == "f":
                self.faces.append([[int(i) - 1 if i else None for i in word.split("/")] for word in words])
                self.materials.append(material)
                self.groups.append(group)
        self.points = np.array(self.points)

    def corners(self):
        """Point, texture coordinates and normal of each corner of each face."""
        return [np.concatenate([self.points[v], self.textures[t], self.normals[n]])
                for face in self.faces for v, t, n in face]


def check_corners(obj):
    corners = np.array(obj.corners())
    points = corners[:, :3]
    assert np.allclose(corners[:, 3:5], texture_of(points), atol=1e-5)
    assert np.allclose(corners[:, 5:], normal_of(points), atol=2e-2) # linear between corners


@pytest.fixture
def textured(teddy, tmp_path):
    """a.obj with a texture, normals and two materials; every second texture coordinate is there twice, as at seams."""
    mesh = OffFile(teddy)
    textures, normals = texture_of(mesh.points), normal_of(mesh.points)
    lines = ["mtllib of_artist.mtl"]
    lines += ["v " + " ".join(map(repr, map(float, point))) for point in mesh.points]
    lines += ["vt " + " ".join(map(repr, map(float, value))) for value in np.vstack([textures, textures])]
    lines += ["vn " + " ".join(map(repr, map(float, value))) for value in normals]
    for number, face in enumerate(mesh.faces):
        if number in (0, 1000):
            lines.append(f"usemtl {'fur' if number == 0 else 'leather'}")
        seam = number % 2 * len(mesh.points)
        lines.append("f " + " ".join(f"{i + 1}/{i + 1 + seam}/{i + 1}" for i in face))
    (tmp_path / "a.obj").write_text("\n".join(lines) + "\n")
    return tmp_path / "a.obj"


def test_seams_are_no_borders(segment, textured, teddy, tmp_path):
    segment(teddy, *"-k 5 -o a.seg".split())
    segment(textured, *"-k 5 -o b.seg".split())
    assert labels(tmp_path / "a.seg") == labels(tmp_path / "b.seg")


def test_texture_and_normals_from_obj_to_obj(segment, textured, tmp_path):
    """With the materials of segments."""
    segment(textured, *"-k 5 -o a.seg -o b.obj".split())
    before, after = ObjFile(textured), ObjFile(tmp_path / "b.obj")
    order = np.argsort(labels(tmp_path / "a.seg"), kind="stable")
    assert after.faces == [before.faces[i] for i in order]
    assert after.textures == before.textures and after.normals == before.normals
    assert after.files == ["b.mtl"] and after.materials == after.groups


def test_material_library_of_the_input_is_kept(segment, textured, tmp_path):
    library = tmp_path / "of_artist.mtl"
    library.write_text("newmtl fur\nnewmtl leather\n")
    for name in ("of_artist.obj", "parts/../of_artist.obj"):
        (tmp_path / "parts").mkdir(exist_ok=True)
        segment.refuses(textured, "-k", 5, "-o", name, "-o", "c.seg", message="of_artist.mtl: is a material library of the input")
    assert library.read_text() == "newmtl fur\nnewmtl leather\n" and not (tmp_path / "c.seg").exists()
    assert "wrote b.obj and b.mtl\n" in segment(textured, *"-k 5 -o b.obj".split()).out


def test_closed_parts_replace_no_material_library(segment, textured, tmp_path):
    """In a collection they are a folder, without a library beside it."""
    (tmp_path / "out").mkdir()
    library = tmp_path / "out/a.mtl"
    library.write_text("newmtl fur\nnewmtl leather\n")
    textured.write_text(textured.read_text().replace("mtllib of_artist.mtl", "mtllib out/a.mtl"))
    collection = f"{textured.name} -k 5 --output-folder out --format obj".split()
    assert "is a material library of the input" in segment.run(*collection).err
    segment(*collection, "--close")
    assert library.read_text() == "newmtl fur\nnewmtl leather\n"


def test_materials_from_obj_to_obj(segment, textured, tmp_path):
    segment(textured, *"-k 5 --colors input -o a.seg -o b.obj -o parts/%d.obj".split())
    before, after = ObjFile(textured), ObjFile(tmp_path / "b.obj")
    order = np.argsort(labels(tmp_path / "a.seg"), kind="stable")
    assert after.materials == [before.materials[i] for i in order]
    assert after.files == ["of_artist.mtl"] and not (tmp_path / "b.mtl").exists()
    assert len(set(after.groups)) == 5
    parts = [ObjFile(tmp_path / f"parts/{i}.obj") for i in range(5)]
    assert [part.files for part in parts] == 5 * [["../of_artist.mtl"]]
    assert [material for part in parts for material in part.materials] == after.materials
    for part in parts:
        check_corners(part)
        assert {t for face in part.faces for _, t, _ in face} == set(range(len(part.textures)))


def test_pieces_of_faces_at_smooth_borders(segment, textured, tmp_path):
    """New corners have what is between those of their face."""
    segment(textured, *"-k 5 --smooth-borders --colors input -o b.obj".split())
    before, after = ObjFile(textured), ObjFile(tmp_path / "b.obj")
    assert len(after.points) > len(before.points)
    check_corners(after)
    assert set(after.materials) == {"fur", "leather"}


def test_polygons_and_triangles(segment, tmp_path):
    """A cube with a square of a texture on each side."""
    cube = ["v " + " ".join(point) for point in ("000", "100", "110", "010", "001", "101", "111", "011")]
    sides = ["1432", "5678", "1265", "2376", "3487", "4158"]
    (tmp_path / "a.obj").write_text("\n".join(
        cube + ["vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1"] +
        ["f " + " ".join(f"{v}/{-4 + i}" for i, v in enumerate(side)) for side in sides]))
    segment("a.obj", *"-k 1 --triangulate -o b.obj".split())
    assert ObjFile(tmp_path / "b.obj").faces == [
        [[int(side[i]) - 1, i] for i in triangle] for side in sides for triangle in ([0, 1, 2], [0, 2, 3])]


@pytest.mark.parametrize("corner", ["1/9", "1/0", "1/-9", "1//9", "1/1/0", "1/"])
def test_corners_that_name_what_is_not_there(segment, tmp_path, corner):
    """They are left out, and the file is read."""
    (tmp_path / "a.obj").write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf {corner} 2 3\n")
    segment("a.obj", *"-k 1 -o b.obj".split())
    assert ObjFile(tmp_path / "b.obj").faces == [[[0], [1], [2]]]


@pytest.fixture
def painted(teddy, tmp_path):
    """a.ply with normals, texture coordinates and colours of vertices, as text."""
    mesh = OffFile(teddy)
    header = ["ply", "format ascii 1.0", f"element vertex {len(mesh.points)}"]
    header += [f"property double {name}" for name in "x y z nx ny nz u v".split()]
    header += [f"property uchar {name}" for name in ("red", "green", "blue")]
    header += [f"element face {len(mesh.faces)}", "property list uchar int vertex_indices", "end_header"]
    rows = np.column_stack([mesh.points, normal_of(mesh.points), texture_of(mesh.points)])
    lines = [" ".join(map(repr, map(float, row))) + " " + " ".join(map(str, color))
             for row, color in zip(rows, color_of(mesh.points))]
    lines += ["3 " + " ".join(map(str, face)) for face in mesh.faces]
    (tmp_path / "a.ply").write_text("\n".join(header + lines) + "\n")
    return tmp_path / "a.ply"


def check_vertices(ply, colors=True):
    points = ply.points()
    assert np.allclose(np.column_stack([ply.vertices[name] for name in ("nx", "ny", "nz")]), normal_of(points))
    assert np.allclose(np.column_stack([ply.vertices[name] for name in "st"]), texture_of(points))
    if colors:
        assert np.array_equal(np.column_stack([ply.vertices[name] for name in ("red", "green", "blue")]),
                              color_of(points))


def test_from_ply_to_ply(segment, painted, teddy, tmp_path):
    segment(painted, *"-k 5 --colors input -o a.seg -o b.ply -o parts/%d.ply".split())
    ply = PlyFile(tmp_path / "b.ply")
    check_vertices(ply)
    assert "red" not in ply.faces.dtype.names
    assert ply.faces["segment"].tolist() == labels(tmp_path / "a.seg")
    for number in range(5):
        check_vertices(PlyFile(tmp_path / f"parts/{number}.ply"))
    segment(painted, *"-k 5 -o c.ply".split())
    ply = PlyFile(tmp_path / "c.ply")
    check_vertices(ply, colors=False)
    assert len({tuple(color) for color in ply.vertices[["red", "green", "blue"]]}) == 5
    segment(teddy, *"-k 5 -o d.seg".split())
    assert labels(tmp_path / "a.seg") == labels(tmp_path / "d.seg")


def test_from_ply_to_obj_and_back(segment, painted, tmp_path):
    segment(painted, *"-k 5 --colors input -o b.obj".split())
    obj = ObjFile(tmp_path / "b.obj")
    check_corners(obj)
    assert np.allclose(obj.colors, color_of(obj.points) / 255, atol=1e-4)
    assert obj.files == [] and obj.materials == [None] * len(obj.faces)
    segment("b.obj", *"-k 5 --colors input -o c.ply".split())
    check_vertices(PlyFile(tmp_path / "c.ply"))


def test_from_ply_to_gltf_and_back(segment, painted, tmp_path, libraries):
    segment(painted, *"-k 5 --colors input -o b.gltf".split())
    gltf = GltfFile(tmp_path / "b.gltf")
    for mesh in gltf.json["meshes"]:
        arrays = {key: gltf.array(index).astype(float)
                  for key, index in mesh["primitives"][0]["attributes"].items()}
        points = arrays["POSITION"]
        assert np.allclose(arrays["NORMAL"], normal_of(points), atol=1e-5)
        assert np.allclose(arrays["TEXCOORD_0"], texture_of(points) * [1, -1] + [0, 1], atol=1e-5)
        linear = ((color_of(points) / 255 + .055) / 1.055)**2.4
        assert np.allclose(arrays["COLOR_0"][:, :3], linear, atol=1e-5)
    if "tinygltf" not in libraries:
        return
    segment("b.gltf", *"-k 5 --colors input -o c.ply".split())
    ply = PlyFile(tmp_path / "c.ply")
    points = ply.points()
    assert np.allclose(np.column_stack([ply.vertices[name] for name in "st"]), texture_of(points), atol=1e-5)
    assert np.allclose(np.column_stack([ply.vertices[name] for name in ("nx", "ny", "nz")]), normal_of(points), atol=1e-5)
    assert np.array_equal(np.column_stack([ply.vertices[name] for name in ("red", "green", "blue")]), color_of(points))


def test_no_place_in_ply(segment, tmp_path):
    """A point with two texture coordinates has none in PLY."""
    (tmp_path / "a.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/3 3/2 4/1\n")
    segment("a.obj", *"-k 1 -o b.ply".split())
    assert "s" not in PlyFile(tmp_path / "b.ply").vertices.dtype.names


def test_wrong_colors(segment, teddy):
    segment.refuses(teddy, "--colors", "red", code=2, message="--colors")


PNG = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


def used_materials(gltf):
    """The materials and texture coordinates of the primitives of each mesh."""
    return [[(gltf.json["materials"][primitive["material"]]["name"], primitive["attributes"].get("TEXCOORD_0"))
             for primitive in mesh["primitives"]] for mesh in gltf.json["meshes"]]


def check_picture(gltf, bytes_of_picture=PNG):
    (image,) = gltf.json["images"]
    view = gltf.json["bufferViews"][image["bufferView"]]
    begin = view["byteOffset"]
    assert image["mimeType"] == "image/png"
    assert gltf.buffer[begin:begin + view["byteLength"]] == bytes_of_picture


@pytest.fixture
def with_materials(textured, tmp_path):
    """The material file of a.obj: fur has a picture, leather is half transparent."""
    (tmp_path / "of_artist.mtl").write_text(
        "newmtl fur\nKd 1 0.5 0.25\nmap_Kd fur.png\nnewmtl leather\nKd 0 0 1\nd 0.5\n")
    (tmp_path / "fur.png").write_bytes(PNG)
    return textured


def test_materials_from_obj_to_gltf_and_on(segment, with_materials, tmp_path, libraries):
    segment(with_materials, *"-k 5 --colors input -o b.glb -o one.gltf --one-object --rig rig.glb".split())
    for name in ("one.gltf", "b.glb", "rig.glb"):
        gltf = GltfFile(tmp_path / name)
        fur, leather = (next(m for m in gltf.json["materials"] if m["name"] == n) for n in ("fur", "leather"))
        assert fur["pbrMetallicRoughness"]["baseColorFactor"] == [1, .5, .25, 1]
        assert leather["pbrMetallicRoughness"]["baseColorFactor"] == [0, 0, 1, .5] and leather["alphaMode"] == "BLEND"
        texture = gltf.json["textures"][fur["pbrMetallicRoughness"]["baseColorTexture"]["index"]]
        assert texture["source"] == 0
        check_picture(gltf)
        used = [material for mesh in used_materials(gltf) for material in mesh]
        assert {name for name, _ in used} == {"fur", "leather"} and all(t is not None for _, t in used)
        assert 5 <= len(used) <= 10
    if "tinygltf" not in libraries:
        pytest.skip("tinygltf was not found")
    segment("one.gltf", *"-k 5 --colors input -o c.glb".split())
    check_picture(GltfFile(tmp_path / "c.glb"))
    segment("one.gltf", *"-k 5 -o d.glb".split())
    assert "images" not in GltfFile(tmp_path / "d.glb").json


def test_names_of_materials_with_a_hash(segment, tmp_path):
    (tmp_path / "a.mtl").write_text("newmtl M#1\nKd 1 0 0\nnewmtl M#2\nKd 0 0 1\n")
    (tmp_path / "a.obj").write_text("# a comment\nmtllib a.mtl\nv 0 0 0 # first\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                    "usemtl M#1\nf 1 2 3\nusemtl M#2\nf 1 3 4 # last\n")
    segment("a.obj", *"-k 1 --colors input -o b.glb -o b.obj".split())
    colors = {m["name"]: m["pbrMetallicRoughness"]["baseColorFactor"] for m in GltfFile(tmp_path / "b.glb").json["materials"]}
    assert colors == {"M#1": [1, 0, 0, 1], "M#2": [0, 0, 1, 1]}
    assert ObjFile(tmp_path / "b.obj").materials == ["M#1", "M#2"]


def test_rig_in_colors_of_the_input(segment, with_materials, tmp_path):
    segment(with_materials, *"-k 5 --colors input --rig rig.glb".split())
    assert {"fur", "leather"} <= {m["name"] for m in GltfFile(tmp_path / "rig.glb").json["materials"]}


def test_closed_parts_keep_materials(segment, with_materials, tmp_path):
    """Caps have none."""
    segment(with_materials, *"-k 3 --close --colors input -o parts/%d.gltf -o parts/%d.obj".split())
    for i in range(3):
        (primitives,) = used_materials(GltfFile(tmp_path / f"parts/{i}.gltf"))
        assert {name for name, _ in primitives} <= {"fur", "leather", f"segment {i}"}
        assert len(primitives) >= 2 and primitives[-1][1] is None # the caps
        faces = ObjFile(tmp_path / f"parts/{i}.obj").faces
        has_texture = [len(face[0]) > 1 for face in faces]
        assert any(has_texture) and not all(has_texture)


def test_textures_of_any_gltf(segment, with_materials, tmp_path, libraries):
    """Samplers, extensions and several pictures stay; a second set of coordinates, and what is not there, does not."""
    if "tinygltf" not in libraries:
        pytest.skip("tinygltf was not found")
    segment(with_materials, *"-k 2 --colors input -o b.gltf".split())
    gltf = json.loads((tmp_path / "b.gltf").read_text())
    (fur,) = (i for i, m in enumerate(gltf["materials"]) if m["name"] == "fur")
    (tmp_path / "beside.png").write_bytes(PNG)
    gltf["images"] += [{"uri": "beside.png"}, {"uri": "lost.png"}]
    gltf["samplers"] = [{"wrapS": 33071}, {"wrapS": 33648}]
    gltf["textures"] += [{"source": 1, "sampler": 1}, {"source": 2}, {"source": 99}]
    gltf["materials"][fur]["normalTexture"] = {"index": 1, "scale": 0.5}
    gltf["materials"][fur]["occlusionTexture"] = {"index": 0, "texCoord": 1}
    gltf["materials"][fur]["emissiveTexture"] = {"index": 2}
    gltf["materials"][fur]["extensions"] = {
        "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatTexture": {"index": 3}}}
    gltf["extensionsUsed"] = ["KHR_materials_clearcoat", "KHR_something_else"]
    (tmp_path / "b.gltf").write_text(json.dumps(gltf))
    segment("b.gltf", *"-k 2 --colors input -o c.gltf".split())
    after = json.loads((tmp_path / "c.gltf").read_text())
    (fur,) = (m for m in after["materials"] if m["name"] == "fur")
    normal = after["textures"][fur["normalTexture"]["index"]]
    assert fur["normalTexture"]["scale"] == 0.5 and after["samplers"][normal["sampler"]] == {"wrapS": 33648}
    assert "bufferView" in after["images"][normal["source"]]
    assert "occlusionTexture" not in fur
    emissive = after["textures"][fur["emissiveTexture"]["index"]]
    assert after["images"][emissive["source"]] == {"uri": "lost.png"}
    assert fur["extensions"] == {"KHR_materials_clearcoat": {"clearcoatFactor": 1}}
    assert after["extensionsUsed"] == ["KHR_materials_clearcoat"]
