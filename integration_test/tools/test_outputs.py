# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of one call: what is in them, and that they say the same."""

import struct

import pytest

from mesh_files import labels, obj_labels, vtp_array
from records import read_record
from tool import Tool, names_in

PARTS = [f"parts/{i}.ply" for i in range(4)] + [f"parts/part{i}.off" for i in range(4)]


@pytest.fixture(scope="module")
def outputs(programs, example_meshes, tmp_path_factory):
    """The folder of all outputs of one call."""
    folder = tmp_path_factory.mktemp("outputs")
    segment = Tool(programs / "segment_by_protrusions", folder)
    files = ("a.ply a.off a.seg parts/%d.ply parts/part%d.off a.glb a.vtp a.obj").split()
    result = segment(example_meshes / "teddy.off", *"-k 4 --method paper --json a.json".split(),
                     *(word for name in files for word in ("-o", name)))
    assert "4 segments" in result.out
    return folder


@pytest.fixture(scope="module")
def number_of_faces(example_meshes):
    return int((example_meshes / "teddy.off").read_text().split()[2])


def test_nothing_else_is_written(outputs):
    single = ["a.ply", "a.off", "a.seg", "a.glb", "a.vtp", "a.obj", "a.mtl", "a.json"]
    assert names_in(outputs) == sorted(single + ["parts"] + PARTS)


def test_seg(outputs, number_of_faces):
    assert len(labels(outputs / "a.seg")) == number_of_faces
    assert set(labels(outputs / "a.seg")) == {0, 1, 2, 3}


def test_ply(outputs, number_of_faces):
    header = (outputs / "a.ply").read_bytes().split(b"end_header")[0].decode()
    assert "format binary" in header
    assert f"element face {number_of_faces}" in header
    assert header.count("property uchar red") == 2  # of vertices and of faces
    assert "property uint segment" in header


def test_vtp(outputs, number_of_faces):
    assert f'NumberOfPolys="{number_of_faces}"' in (outputs / "a.vtp").read_text()
    assert vtp_array(outputs / "a.vtp", "segment") == labels(outputs / "a.seg")


def test_obj(outputs):
    assert obj_labels(outputs / "a.obj") == sorted(labels(outputs / "a.seg"))


def test_glb(outputs):
    content = (outputs / "a.glb").read_bytes()
    assert content[:4] == b"glTF"
    assert struct.unpack("<I", content[8:12])[0] == len(content)
    for number in range(4):
        assert f"segment {number}".encode() in content


def test_json(outputs, number_of_faces):
    record = read_record(outputs / "a.json")
    expected = {"faces": number_of_faces, "segments_requested": 4, "segments": 4, "threads": 1,
                "method": "paper", "distance": "geodesic", "seed": 0, "note": None}
    assert {key: record[key] for key in expected} == expected
    for key in ("dijkstra_runs", "seconds", "writing_seconds", "peak_memory", "input"):
        assert key in record
    assert record["stages"]
    assert record["hierarchy"][0]["children"]
    for protrusion in record["protrusions"]:
        assert protrusion["border_slot"] is not None
        assert protrusion["distance_histogram"]
        assert protrusion["sectional_diameter_histogram"]


@pytest.mark.parametrize("extension", ["ply", "off", "obj"])
def test_labels_fit_the_mesh_that_was_written(outputs, evaluate, extension):
    evaluate(outputs / f"a.{extension}", outputs / "a.seg", outputs / "a.seg")


@pytest.mark.parametrize("part", PARTS)
def test_quiet_call_on_a_part(outputs, segment, part):
    result = segment(outputs / part, "-k", 1, "--quiet")
    assert result.out == "" and result.err == ""


def test_json_of_minimum_cut(segment, teddy, tmp_path):
    segment(teddy, "-k", 4, "--json", "a.json")
    assert '"distance_histogram": null' in (tmp_path / "a.json").read_text()
    read_record(tmp_path / "a.json")


def test_json_of_paper_with_diffusion(segment, teddy):
    segment.record(teddy, *"-k 4 --method paper --distance diffusion".split())


def test_json_on_the_standard_output(segment, teddy):
    assert segment.record(teddy)["segments_requested"] is None  # which fails on anything but JSON


def test_padded_numbers_of_segments(segment, teddy, tmp_path):
    result = segment(teddy, "-k", 4, "-o", "numbered/%03d.off")
    assert "wrote numbered/%03d.off (4 files)" in result.out
    assert names_in(tmp_path / "numbered") == ["000.off", "001.off", "002.off", "003.off"]


def test_smooth_borders_in_json(segment, teddy):
    assert segment.record(teddy, "-k", 5, "--smooth-borders")["smooth_borders"]


def test_shortest_digits(segment, tmp_path):
    """Coordinates are written as they were read."""
    points = ["-0.601581618 0.1 1e-07", "12345678.9 0.3 0", "0 1 2.5", "1 1 1"]
    (tmp_path / "small.off").write_text("\n".join(["OFF", "4 4 0", *points, "3 0 1 2", "3 0 3 1", "3 1 3 2", "3 0 2 3"]))
    segment("small.off", *"-k 2 -o a.off -o a.obj -o a.vtp".split())
    assert (tmp_path / "a.off").read_text().splitlines()[2:6] == points
    assert (tmp_path / "a.obj").read_text().splitlines()[1:5] == [f"v {point}" for point in points]
    assert set(points) <= set((tmp_path / "a.vtp").read_text().splitlines())
