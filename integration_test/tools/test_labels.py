# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""--labels: segments from a file, in place of finding them; --names: what they are called."""

import json

import numpy as np
import pytest

from mesh_files import labels, volume_of_closed
from records import read_record
from tool import names_in


@pytest.fixture
def found(segment, teddy, tmp_path):
    """What the tool finds: the record of a.seg and a.ply."""
    segment(teddy, *"-k 8 -o a.seg -o a.ply --json a.json".split())
    return read_record(tmp_path / "a.json")


def test_labels_come_back(segment, teddy, tmp_path, found):
    record = segment.record(teddy, "--labels", "a.seg", "-o", "b.seg")
    assert (tmp_path / "b.seg").read_text() == (tmp_path / "a.seg").read_text()
    assert (record["labels"], record["method"], record["note"]) == ("a.seg", None, None)
    assert found["labels"] is None
    assert {p["segment"]: p["parent"] for p in record["protrusions"]} == \
        {p["segment"]: p["parent"] for p in found["protrusions"]}
    of_segment = {p["segment"]: p for p in record["protrusions"]}
    for protrusion in found["protrusions"]:
        same = of_segment[protrusion["segment"]]
        assert same["value"] is None and same["probability"] is None
        assert labels(tmp_path / "a.seg")[same["tip"]] == protrusion["segment"]
        for key in ("area", "border_length"):
            assert same[key] == pytest.approx(protrusion[key], rel=1e-5)
        assert same["border_distance"] == pytest.approx(protrusion["border_distance"], rel=0.1)
    areas = [protrusion["area"] for protrusion in record["protrusions"]]
    assert areas == sorted(areas, reverse=True)


@pytest.mark.parametrize("array", ["<i8", "|u1", ">i2", "<u4"])
def test_numpy_arrays(segment, teddy, tmp_path, found, array):
    np.save(tmp_path / "a.npy", np.array(labels(tmp_path / "a.seg")).astype(array))
    segment(teddy, "--labels", "a.npy", "-o", "b.seg")
    assert labels(tmp_path / "b.seg") == labels(tmp_path / "a.seg")


def test_numpy_array_of_no_bytes(segment, teddy, tmp_path):
    header = b"{'descr': '<i0', 'fortran_order': False, 'shape': (3000,), }\n"
    (tmp_path / "a.npy").write_bytes(b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header)
    segment.refuses(teddy, "--labels", "a.npy", "-o", "b.seg", message="a.npy: has integers of 0 bytes")


def test_labels_of_the_mesh_itself(segment, tmp_path, found):
    segment("a.ply", "--labels", "a.ply", "-o", "b.seg")
    assert labels(tmp_path / "b.seg") == labels(tmp_path / "a.seg")


def test_segments_are_in_the_order_of_the_labels(segment, teddy, tmp_path, found):
    (tmp_path / "gaps.seg").write_text("".join(f"{10 * i + 3}\n" for i in labels(tmp_path / "a.seg")))
    record = segment.record(teddy, "--labels", "gaps.seg", "-o", "b.seg")
    assert labels(tmp_path / "b.seg") == labels(tmp_path / "a.seg")
    assert record["note"] == "the labels of the file, up to 73, are numbered from 0 to 7 in their order"


def test_all_outputs_of_other_peoples_segments(segment, teddy, tmp_path, libraries):
    """Four quarters of the teddy, no matter what is connected."""
    points = [line.split() for line in teddy.read_text().splitlines() if line][2:]
    faces = [line for line in points if line[0] == "3" and len(line) == 4]
    side = [(float(points[int(f[1])][1]) > 0) + 2 * (float(points[int(f[2])][2]) > 1) for f in faces]
    (tmp_path / "mine.seg").write_text("".join(f"{i}\n" for i in side))
    report = ["--report", "r.html"] if "three.js" in libraries else []
    segment(teddy, *"--labels mine.seg -o parts/%d.off --close -o a.glb -o a.vtp -o a.obj --borders b.vtp".split(),
            "--json", "a.json", *report)
    whole = volume_of_closed([teddy])
    assert volume_of_closed([tmp_path / f"parts/{i}.off" for i in range(4)]) == pytest.approx(whole)
    assert read_record(tmp_path / "a.json")["segments"] == 4
    smooth = segment.record(teddy, "--labels", "mine.seg", "--smooth-borders", "-o", "smooth.ply")
    assert smooth["smooth_borders"]


@pytest.mark.parametrize("name, content, message", [
    ("a.seg", b"1\n", "there are only 1 segment ids"),
    ("a.npy", b"1", "is no .npy file"),
    ("a.txt", b"1\n", "labels are read from"),
    ("a.off", b"1\n", "labels are read from"),
])
def test_labels_that_cannot_be_read(segment, teddy, tmp_path, name, content, message):
    (tmp_path / name).write_bytes(content)
    segment.refuses(teddy, "--labels", name, "-o", "b.seg", message=message)
    assert names_in(tmp_path) == sorted([name, "teddy.off"])


@pytest.mark.parametrize("array, message", [
    (np.zeros(5, int), "has 5 labels, but the mesh has"),
    (np.zeros(5), "is no array of integers"),
    (np.zeros((5, 1), int), "is no array of integers"),
    (None, "the label of face 0 is no integer"),
])
def test_arrays_that_are_no_labels(segment, teddy, tmp_path, found, array, message):
    np.save(tmp_path / "a.npy", np.full(found["faces"], -1) if array is None else array)
    segment.refuses(teddy, "--labels", "a.npy", message=message)


def test_the_record_is_no_file_of_labels(segment, teddy, found):
    segment.refuses(teddy, "--labels", "a.json", message="a.json: is a record as of --json, which has no labels")


def test_mesh_without_labels(segment, make_mesh, tmp_path):
    make_mesh("hand", "hand.ply", "--faces", 1000)
    segment.refuses("hand.ply", "--labels", "hand.ply", message="no data named segment or label")


def write_names(file, *names):
    file.write_text(json.dumps({"names": names}))


def test_names(segment, teddy, tmp_path, found):
    head = labels(tmp_path / "a.seg").index(1)
    write_names(tmp_path / "n.json", {"face": head, "name": "the head"}, {"segment": 6, "name": "ear"},
                {"segment": 7, "name": "ear"})
    record = segment.record(teddy, *"--labels a.seg --names n.json -o a.obj -o a.glb -o parts/%s.off".split())
    assert names_in(tmp_path / "parts") == sorted(
        ["the_head.off", "ear.off", "ear_7.off"] + [f"segment_{i}.off" for i in (0, 2, 3, 4, 5)])
    assert [m["name"] for m in record["measures"]] == [None, "the head", *[None] * 4, "ear", "ear"]
    assert {"g the_head", "g ear", "g ear_7", "g segment_0"} <= set((tmp_path / "a.obj").read_text().splitlines())
    assert b'"the head"' in (tmp_path / "a.glb").read_bytes()


def test_two_names_of_one_segment(segment, teddy, tmp_path, found):
    write_names(tmp_path / "n.json", *({"segment": 1, "name": name} for name in ["top", "head", "head"]))
    record = segment.record(teddy, *"--labels a.seg --names n.json -o a.obj".split())
    assert record["measures"][1]["name"] == "head"
    assert record["note"] == "segment 1 has two names; top is not used"


def test_names_cannot_leave_the_folder(segment, teddy, tmp_path, found):
    write_names(tmp_path / "n.json", *({"segment": i, "name": name} for i, name in enumerate(["../up", ".", "a/b", " "])))
    segment(teddy, *"--labels a.seg --names n.json -o parts/%s.off".split())
    assert names_in(tmp_path / "parts") == sorted(
        ["_._up.off", "_.off", "a_b.off", "__3.off"] + [f"segment_{i}.off" for i in range(4, 8)])


@pytest.mark.parametrize("content, message", [
    ("[", "is no JSON"), ('{"names": 1}', "has no array of names"), ('{"name": []}', "has no array of names"),
    ('[{"segment": 1, "name": "a"}]', "has no array of names"),
    ('{"names": [{"face": 1}]}', "has a name without text"), ('{"names": [{"name": "a"}]}', "has a name without text"),
    ('{"names": [1]}', "has a name without text"), ('{"names": [{"face": 99999999, "name": "a"}]}', "face 99999999"),
    ('{"names": [{"segment": 8, "name": "a"}]}', "names segment 8"),
])
def test_wrong_names(segment, teddy, tmp_path, found, content, message):
    (tmp_path / "n.json").write_text(content)
    segment.refuses(teddy, *"--labels a.seg --names n.json -o b.seg".split(), message=message)
    assert not (tmp_path / "b.seg").exists()
