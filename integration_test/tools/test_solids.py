# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids that touch, hollow ones, and such whose borders nearly agree."""

import itertools
import random
import struct
import zipfile

import pytest

from mesh_files import OffFile, labels

# The faces of a box, with corners numbered 4 x + 2 y + z, seen from outside.
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def box(low, high):
    """The triangles of a box, three points each."""
    corners = list(itertools.product(*zip(low, high)))
    return [tuple(corners[side[i]] for i in triangle)
            for side in SIDES for triangle in ((0, 1, 2), (0, 2, 3))]


def write_stl(path, triangles):
    facets = (struct.pack("<12fH", 0, 0, 0, *itertools.chain(*triangle), 0)
              for triangle in triangles)
    path.write_bytes(bytes(80) + struct.pack("<I", len(triangles)) + b"".join(facets))


def write_obj(path, triangles):
    """With points of their own for every face."""
    lines = [f"v {x} {y} {z}" for triangle in triangles for x, y, z in triangle]
    lines += [f"f {i} {i + 1} {i + 2}" for i in range(1, 3 * len(triangles), 3)]
    path.write_text("\n".join(lines) + "\n")


WRITERS = pytest.mark.parametrize("name, write", [("a.stl", write_stl), ("a.obj", write_obj)])


def closed_volumes(segment, folder, name, *options):
    """The volumes of the closed parts; each must be closed."""
    segment(name, *options, "--close", "-o", "parts/%d.off", "-o", "a.seg")
    parts = [OffFile(folder / f"parts/{i}.off") for i in range(len(set(labels(folder / "a.seg"))))]
    assert all(part.is_closed() for part in parts)
    return [part.volume() for part in parts]


@WRITERS
def test_stack_of_cubes(segment, tmp_path, name, write):
    cubes = [box(low, [x + 1 for x in low]) for low in itertools.product(range(10), repeat=3)]
    write(tmp_path / name, [triangle for cube in cubes for triangle in cube])
    result = segment(name, "-o", "a.seg")
    assert "12000 faces, 1000 segments," in result.out
    assert "no protrusion" not in result.err
    found = labels(tmp_path / "a.seg")
    assert len(set(found)) == 1000
    assert all(len(set(found[i:i + 12])) == 1 for i in range(0, 12000, 12))


@WRITERS
def test_boxes_of_different_sizes(segment, tmp_path, name, write):
    boxes = [box((0, 0, 0), (1, 1, 1)), box((1, 0, 0), (4, 1, 1)), box((0, 1, 0), (1, 3, 1))]
    write(tmp_path / name, [triangle for box_ in boxes for triangle in box_])
    volumes = closed_volumes(segment, tmp_path, name)
    assert sorted(volumes) == pytest.approx([1, 2, 3])


def turned(triangles):
    return [(a, c, b) for a, b, c in triangles]


@WRITERS
def test_cavities(segment, tmp_path, name, write):
    hollow = box((0, 0, 0), (9, 9, 9)) + turned(box((1, 1, 1), (4, 4, 4))) + turned(box((5, 5, 5), (8, 8, 8)))
    write(tmp_path / name, hollow)
    assert closed_volumes(segment, tmp_path, name) == pytest.approx([729 - 54])
    solid = box((2, 2, 2), (3, 3, 3))
    write(tmp_path / name, solid + hollow)
    assert closed_volumes(segment, tmp_path, name, "-k", 2) == pytest.approx([729 - 54, 1])


@WRITERS
def test_inside_out(segment, tmp_path, name, write):
    inner, outer, beside = box((1, 1, 1), (2, 2, 2)), box((0, 0, 0), (3, 3, 3)), box((5, 0, 0), (6, 2, 2))
    write(tmp_path / name, turned(outer))
    assert "1 component is inside out" in segment(name).err
    assert closed_volumes(segment, tmp_path, name) == pytest.approx([27])
    write(tmp_path / name, inner + turned(outer) + beside)
    assert segment.record(name)["surface"]["inside_out_components"] == 2
    assert sorted(closed_volumes(segment, tmp_path, name)) == pytest.approx([4, 26])
    write(tmp_path / name, turned(inner) + outer + beside)
    assert "inside out" not in segment(name).err
    assert sorted(closed_volumes(segment, tmp_path, name)) == pytest.approx([4, 26])


def shaken(triangles, distance):
    generator = random.Random(0)
    return [tuple(tuple(x + generator.uniform(-distance, distance) for x in point) for point in triangle)
            for triangle in triangles]


@WRITERS
def test_corners_that_nearly_agree(segment, tmp_path, name, write):
    write(tmp_path / name, shaken(box((0, 0, 0), (1, 1, 1)), 1e-6))
    assert "nearly agree" in segment(name).err
    assert closed_volumes(segment, tmp_path, name) == pytest.approx([1], abs=1e-4)
    assert segment.record(name, "--weld", 0)["segments"] == 12


@WRITERS
def test_weld(segment, tmp_path, name, write):
    write(tmp_path / name, shaken(box((0, 0, 0), (1, 1, 1)), 1e-3))
    assert "hardly any faces share edges; --weld DISTANCE" in segment(name).err
    assert closed_volumes(segment, tmp_path, name, "--weld", .01) == pytest.approx([1], abs=.01)
    assert segment.record(name, "--weld", .01)["weld_distance"] == .01
    for wrong in ("-1", "wide", "inf", "nan"):
        segment.refuses(name, "--weld", wrong, code=2, message=f"'{wrong}' is no distance")


@WRITERS
def test_cracks(segment, tmp_path, name, write):
    a, b, c = (0, 0, 0), (0, 1, 1), (0, 1, 0)  # a triangle of the first side, cut at the middle of an edge
    middle = (1e-6, .5, .5)
    triangles = [t for t in box((0, 0, 0), (1, 1, 1)) if set(t) != {a, b, c}]
    write(tmp_path / name, triangles + [(a, middle, c), (middle, b, c)])
    assert segment.record(name)["surface"]["split_edges"] == 1
    assert closed_volumes(segment, tmp_path, name) == pytest.approx([1], abs=1e-4)


def creature():
    """A box with four legs that cut into it, each a piece, and a box inside."""
    legs = [box((x, y, -4), (x + 1, y + 1, .5)) for x in (0, 5) for y in (0, 2)]
    return [box((-.5, -.5, 0), (6.5, 3.5, 3)), *legs, box((2, 1, 1), (3, 2, 2))]


@WRITERS
def test_join_pieces(segment, tmp_path, name, write):
    pieces = creature()
    write(tmp_path / name, [triangle for piece in pieces for triangle in piece])
    result = segment(name)
    assert "5 of 6 components touch each other; --join-pieces makes one shape of them" in result.err
    assert "6 segments," in result.out
    for options in (["--join-pieces"], ["--join-pieces", "-k", 5], ["--join-pieces=.3"]):
        volumes = closed_volumes(segment, tmp_path, name, *options)
        found = labels(tmp_path / "a.seg")
        assert len(found) == 12 * len(pieces)
        assert found[0] == found[-1] == 0
        assert [found[12 * i] for i in (1, 2, 3, 4)] in \
            [list(order) for order in itertools.permutations((1, 2, 3, 4))]
        assert all(len(set(found[i:i + 12])) == 1 for i in range(0, len(found), 12))
        assert sum(volumes) == pytest.approx(7 * 4 * 3 + 4 * 4, rel=.25)
    record = segment.record(name, "--join-pieces")
    assert record["join_pieces"] is True and record["gap"] is None
    assert record["surface"]["components"] == 1
    assert sum(measure["faces"] for measure in record["measures"]) == len(found)
    assert "6 pieces are joined to 1 shape" in segment(name, "--join-pieces").err


def test_all_outputs_of_joined_pieces(segment, tmp_path, libraries):
    write_obj(tmp_path / "a.obj", [triangle for piece in creature() for triangle in piece])
    outputs = "-o b.seg -o b.ply -o b.glb -o b.vtp --json b.json --borders c.vtp --smooth-borders"
    report = ["--report", "b.html"] * ("three.js" in libraries)
    segment("a.obj", "--join-pieces", *outputs.split(), *report)
    assert len(labels(tmp_path / "b.seg")) == 72


def test_gaps(segment, tmp_path):
    write_obj(tmp_path / "a.obj", box((0, 0, 0), (1, 1, 1)) + box((1.2, 0, 0), (2, 1, 1)))
    assert "touch" not in segment("a.obj").err
    assert segment.record("a.obj", "--join-pieces=.1")["surface"]["components"] == 2
    assert segment.record("a.obj", "--join-pieces=.3")["surface"]["components"] == 1
    segment.refuses("a.obj", "--join-pieces=9", message="--join-pieces: gap: ")
    segment.refuses("a.obj", "--join-pieces=wide", code=2, message="'wide' is no distance")
    segment.refuses("a.obj", "--join-pieces", "--weld", "1", code=2, message="--weld")


def write_ply(path, triangles):
    """With points of their own for every face."""
    head = (f"ply\nformat ascii 1.0\nelement vertex {3 * len(triangles)}\n"
            "property float x\nproperty float y\nproperty float z\n"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header")
    lines = [f"{x} {y} {z}" for triangle in triangles for x, y, z in triangle]
    lines += [f"3 {i} {i + 1} {i + 2}" for i in range(0, 3 * len(triangles), 3)]
    path.write_text("\n".join([head, *lines]) + "\n")


def write_vtp(path, triangles):
    points = " ".join(str(x) for triangle in triangles for point in triangle for x in point)
    number = len(triangles)
    path.write_text(f"""<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="{3 * number}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0"
 NumberOfPolys="{number}"><Points>
<DataArray type="Float32" NumberOfComponents="3" format="ascii">{points}</DataArray></Points><Polys>
<DataArray type="Int32" Name="connectivity" format="ascii">{" ".join(map(str, range(3 * number)))}</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">{" ".join(map(str, range(3, 3 * number + 1, 3)))}</DataArray>
</Polys></Piece></PolyData></VTKFile>
""")


def write_3mf(path, triangles):
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>'
                       for triangle in triangles for x, y, z in triangle)
    faces = "".join(f'<triangle v1="{i}" v2="{i + 1}" v3="{i + 2}"/>'
                    for i in range(0, 3 * len(triangles), 3))
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("[Content_Types].xml", TYPES_3MF)
        archive.writestr("_rels/.rels", RELATIONS_3MF)
        archive.writestr("3D/3dmodel.model", f"""<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
<object id="1" type="model"><mesh><vertices>{vertices}</vertices><triangles>{faces}</triangles></mesh></object>
</resources><build><item objectid="1"/></build></model>
""")


TYPES_3MF = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
"""
RELATIONS_3MF = """<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
"""


def reversed_triangles(triangles):
    return [triangle[::-1] for triangle in triangles]


def shifted_corners(triangles):
    """With corners that differ by the last bits of single precision."""
    numbers = itertools.count()
    return [tuple(tuple(x * (1 + next(numbers) % 3 * 1.2e-7) for x in point) for point in triangle)
            for triangle in triangles]


SOUPS = {
    "touching": box((0, 0, 0), (1, 1, 1)) + box((1, 0, 0), (2, 1, 1)) + box((2, 1, 0), (3, 2, 1)),
    "hollow": box((0, 0, 0), (4, 4, 4)) + reversed_triangles(box((1, 1, 1), (3, 3, 3))),
    "inside out": reversed_triangles(box((0, 0, 0), (1, 1, 1))),
    "nearly agreeing": shifted_corners(box((1, 2, 3), (4, 5, 6)) + box((4, 2, 3), (6, 5, 6))),
}


@pytest.mark.parametrize("soup", SOUPS)
@pytest.mark.parametrize("options", [[], ["--join-pieces"]])
def test_formats_have_the_same_labels(segment, tmp_path, libraries, soup, options):
    writers = {"stl": write_stl, "obj": write_obj, "ply": write_ply}
    writers.update({"vtp": write_vtp} if "vtk" in libraries else {})
    writers.update({"3mf": write_3mf} if "lib3mf" in libraries else {})
    found = {}
    for extension, write in writers.items():
        write(tmp_path / f"a.{extension}", SOUPS[soup])
        result = segment(f"a.{extension}", *options, "-o", "a.seg")
        found[extension] = labels(tmp_path / "a.seg"), result.err.replace(extension, "")
    assert all(one == found["stl"] for one in found.values())
