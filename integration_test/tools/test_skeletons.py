# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletons, rigs and convex hulls."""

import numpy as np
import pytest

from mesh_files import GltfFile, OffFile, labels, vtp_array
from records import read_record
from tool import names_in


def global_places(gltf):
    """Of each node, as no node turns or scales."""
    places = [None] * len(gltf.json["nodes"])

    def visit(index, origin):
        node = gltf.json["nodes"][index]
        assert not {"scale", "matrix"} & node.keys()
        places[index] = origin + np.array(node.get("translation", [0, 0, 0]))
        for child in node.get("children", []):
            visit(child, places[index])

    for root in gltf.json["scenes"][0]["nodes"]:
        visit(root, np.zeros(3))
    return places


def test_skeleton_in_json(segment, octopus, tmp_path):
    record = segment.record(octopus, *"-k 9 -o a.seg".split())
    joints = record["skeleton"]
    assert [joint["segment"] for joint in joints if not joint["is_tip"]].count(0) == 1
    assert sorted(joint["segment"] for joint in joints) == sorted([0] + 2 * list(range(1, 9)))
    tips = {p["segment"]: p["tip_point"] for p in record["protrusions"]}
    for number, joint in enumerate(joints):
        assert joint["parent"] < number or number == joint["parent"] == 0
        if joint["is_tip"]:
            assert joint["point"] == pytest.approx(tips[joint["segment"]])
            assert joints[joint["parent"]]["segment"] == joint["segment"]
    parents = {p["segment"]: p["parent"] for p in record["protrusions"]}
    for joint in joints:
        if joint["segment"] in parents and not joint["is_tip"]:
            between = sorted([joint["segment"], parents[joint["segment"]]])
            points = np.array([point for border in record["borders"] if border["segments"] == between
                               for point in border["points"]])
            assert (points.min(axis=0) <= joint["point"]).all() and (joint["point"] <= points.max(axis=0)).all()


def test_skeleton_as_lines(segment, octopus, tmp_path):
    """More joints than in JSON: the arms are bent."""
    segment(octopus, *"-k 9 --skeleton a.vtp".split())
    corners = np.array(vtp_array(tmp_path / "a.vtp", "connectivity"), int).reshape(-1, 2)
    segments = vtp_array(tmp_path / "a.vtp", "segment")
    assert len(corners) == len(segments) == len(set(corners[:, 1])) == 8 * 10
    assert (corners[:, 0] < corners[:, 1]).all()
    assert sum(vtp_array(tmp_path / "a.vtp", "is_tip")) == 8


@pytest.mark.parametrize("name", ["a.glb", "a.gltf"])
def test_rig(segment, octopus, tmp_path, name):
    record = segment.record(octopus, *"-k 9 -o a.seg --rig".split(), name)
    gltf = GltfFile(tmp_path / name)
    (skin,) = gltf.json["skins"]
    places = global_places(gltf)
    assert np.allclose([places[joint] for joint in skin["joints"]],
                       [joint["point"] for joint in record["skeleton"]], atol=1e-5)
    matrices = gltf.array(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
    for joint, matrix in zip(skin["joints"], matrices):
        assert np.allclose(matrix[:3, 3], -places[joint], atol=1e-6)
        assert np.allclose(matrix[:3, :3], np.eye(3))
    of_segment = {joint["segment"]: number for number, joint in enumerate(record["skeleton"]) if not joint["is_tip"]}
    (node,) = [node for node in gltf.json["nodes"] if "mesh" in node]
    assert node["skin"] == 0
    mover = {} # of each place
    for number, primitive in enumerate(gltf.json["meshes"][node["mesh"]]["primitives"]):
        arrays = {key: gltf.array(index) for key, index in primitive["attributes"].items()}
        assert np.array_equal(arrays["WEIGHTS_0"], np.tile([1, 0, 0, 0], (len(arrays["POSITION"]), 1)))
        joints = arrays["JOINTS_0"][:, 0]
        assert np.median(joints) == of_segment[number]
        for place, joint in zip(map(tuple, arrays["POSITION"]), joints):
            assert mover.setdefault(place, joint) == joint, "the mesh tears at a border"


def test_names_of_joints(segment, octopus, tmp_path):
    (tmp_path / "n.json").write_text('{"names": [{"segment": 3, "name": "left arm"}]}')
    segment(octopus, *"-k 9 --names n.json --rig a.gltf".split())
    names = [node["name"] for node in GltfFile(tmp_path / "a.gltf").json["nodes"]]
    assert names.count("left arm") == names.count("left arm end") == 1
    assert names.count("armature") == names.count("mesh") == 1


def test_rig_upright(segment, octopus, tmp_path):
    """The armature is turned, not the mesh: a skin goes with its joints."""
    segment(octopus, *"-k 9 --rig a.gltf --up z".split())
    nodes = GltfFile(tmp_path / "a.gltf").json["nodes"]
    assert [node["name"] for node in nodes if "rotation" in node] == ["armature"]


def test_two_bodies(segment, data, tmp_path):
    segment(data / "two_surfaces.ts", "--rig", "a.gltf", "--skeleton", "a.vtp")
    nodes = GltfFile(tmp_path / "a.gltf").json["nodes"]
    (armature,) = [node for node in nodes if node["name"] == "armature"]
    assert len(armature["children"]) == 2


def test_rig_with_smooth_borders(segment, octopus, tmp_path):
    segment(octopus, *"-k 9 --smooth-borders --rig a.glb --skeleton a.vtp --json a.json".split())
    assert len(read_record(tmp_path / "a.json")["skeleton"]) == 17


def test_convex_hulls(segment, octopus, tmp_path):
    segment(octopus, *"-k 9 -o a.seg -o open/%d.off -o hulls/%d.off --close=hull".split())
    for number in range(9):
        hull = OffFile(tmp_path / f"hulls/{number}.off")
        assert hull.is_closed()
        faces = np.array(hull.faces)
        a, b, c = hull.points[faces].transpose(1, 0, 2)
        heights = np.einsum("ik,ijk->ij", np.cross(b - a, c - a), hull.points[None] - a[:, None])
        assert (heights < 1e-9).all()
    points = OffFile(octopus).points
    segments = np.array(labels(tmp_path / "a.seg"))
    for number in range(9):
        corners = {corner for face, s in zip(OffFile(octopus).faces, segments) if s == number for corner in face}
        of_segment = points[sorted(corners)]
        hull = OffFile(tmp_path / f"hulls/{number}.off").points
        assert np.array_equal(hull.min(axis=0), of_segment.min(axis=0))
        assert np.array_equal(hull.max(axis=0), of_segment.max(axis=0))


def test_hull_of_a_sheet(segment, data):
    result = segment(data / "open_sheet.off", *"-k 2 --close=hull -o %d.off".split())
    note = "1 segment was cut off where the shape shows no border, to reach the number asked for"
    assert result.err == f"segment_by_protrusions: {data / 'open_sheet.off'}: {note}\n"


@pytest.mark.parametrize("options, message", [
    ("--rig a.obj", "--rig: 'a.obj' has not the extension .glb or .gltf"),
    ("--skeleton a.json", "--skeleton: 'a.json' has not the extension .vtp"),
    ("--rig a.glb -o a.glb", "'a.glb' is named twice"),
    ("--skeleton a.vtp --borders a.vtp", "'a.vtp' is named twice"),
    ("--rig a.glb --output-folder b", "--rig has no meaning with --output-folder"),
])
def test_wrong_names(segment, octopus, tmp_path, options, message):
    segment.refuses(octopus, *options.split(), code=2, message=message)
    assert names_in(tmp_path) == ["octopus.off"]


def test_rig_that_cannot_be_written(segment, octopus, tmp_path):
    segment.refuses(octopus, "-o", "a.seg", "--rig", "missing/a.glb", message="missing/a.glb: cannot be written")
    assert names_in(tmp_path) == ["octopus.off"]
