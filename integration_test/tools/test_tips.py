# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""--tips: the protrusions of some faces only, as the page of --report saves them."""

import json

import numpy as np
import pytest

from mesh_files import OffFile, labels
from records import read_record
from tool import names_in


def test_one_tip(segment, teddy, tmp_path):
    segment(teddy, *"-k 5 --json all.json -o all.seg".split())
    tip = read_record(tmp_path / "all.json")["protrusions"][0]["tip"]
    (tmp_path / "one.json").write_text(json.dumps({"tips": [tip], "names": []}))
    record = segment.record(teddy, "--tips", "one.json", "-o", "one.seg")
    assert record["tips_requested"] == [tip]
    found = labels(tmp_path / "one.seg")
    assert set(found) == {0, 1}
    assert found[tip] == 1


@pytest.mark.parametrize("content, message", [
    ('{"tips": [99999999]}', "has no face 99999999"),
    ("", "tips.json"),
    ("[1]", "tips.json"),
    ('{"tips": 1}', "tips.json"),
    ('{"tips": []}', "tips.json"),
    ('{"tips": [-1]}', "tips.json"),
    ('{"tips": [1.5]}', "tips.json"),
    ('{"tips": ["a"]}', "tips.json"),
    ('{"tips": [0], "names": 1}', "tips.json: has no array of names"),
])
def test_wrong_tips(segment, teddy, tmp_path, content, message):
    (tmp_path / "tips.json").write_text(content + "\n")
    segment.refuses(teddy, "--tips", "tips.json", "-o", "a.seg", message=message)
    assert names_in(tmp_path) == ["teddy.off", "tips.json"]


@pytest.mark.parametrize("name, message", [("none.json", "none.json"),
                                           ("folder", "folder: is a folder")])
def test_tips_that_cannot_be_read(segment, teddy, tmp_path, name, message):
    (tmp_path / "folder").mkdir()
    segment.refuses(teddy, "--tips", name, "-o", "a.seg", message=message)
    assert names_in(tmp_path) == ["folder", "teddy.off"]


@pytest.mark.parametrize("shape, faces", [("teddy", 3000), ("octopus", 6000), ("horse", 4000), ("chair", 4000)])
def test_tips_of_a_result_give_the_result(segment, make_mesh, tmp_path, shape, faces):
    make_mesh(shape, "a.off", "--faces", faces)
    record = segment.record("a.off", "-o", "a.seg")
    tips = [protrusion["tip"] for protrusion in record["protrusions"]]
    (tmp_path / "tips.json").write_text(json.dumps({"tips": tips[::-1]}))
    assert segment.record("a.off", "--tips", "tips.json", "-o", "b.seg")["note"] is None
    assert labels(tmp_path / "b.seg") == labels(tmp_path / "a.seg")


@pytest.mark.parametrize("number", [4, 5, 6])
def test_a_further_tip_keeps_the_other_protrusions(segment, make_mesh, tmp_path, number):
    """The thumb of a hand, where it is in the body."""
    make_mesh("hand", "a.off", "--faces", 8000)
    hand = OffFile(tmp_path / "a.off")
    thumb = int(np.linalg.norm(hand.points[np.array(hand.faces)].mean(axis=1) - [0.3, 1.95, 1.65], axis=1).argmin())
    found = segment.record("a.off", "-k", number, "-o", "a.seg")
    before = np.array(labels(tmp_path / "a.seg"))
    if before[thumb] != 0:
        pytest.skip("the thumb is found")
    tips = [thumb] + [protrusion["tip"] for protrusion in found["protrusions"]]
    (tmp_path / "tips.json").write_text(json.dumps({"tips": tips}))
    assert segment.record("a.off", "--tips", "tips.json", "-o", "b.seg")["note"] is None
    after = np.array(labels(tmp_path / "b.seg"))
    assert len(set(after)) == number + 1
    for protrusion in found["protrusions"]:
        old, new = before == protrusion["segment"], after == after[protrusion["tip"]]
        assert np.count_nonzero(old != new) < 0.05 * np.count_nonzero(old)


def test_tip_without_a_border(segment, make_mesh, tmp_path):
    """Two tips of one arm that share no vertex."""
    make_mesh("octopus", "a.off", "--faces", 4000)
    record = segment.record("a.off", "-k", 9, "-o", "a.seg")
    first = record["protrusions"][0]
    same = [face for face, segment in enumerate(labels(tmp_path / "a.seg")) if segment == first["segment"]]
    (tmp_path / "tips.json").write_text(json.dumps({"tips": [first["tip"], same[0], same[1]]}))
    result = segment("a.off", "--tips", "tips.json")
    assert "found no border for the tip" in result.err


def test_tips_from_a_pipe(segment, teddy, tmp_path):
    tips = [protrusion["tip"] for protrusion in segment.record(teddy, "-k", 3)["protrusions"]]
    names = [{"face": tips[0], "name": "head"}]
    segment(teddy, *"--tips - -o a.seg --json a.json".split(), input=json.dumps({"tips": tips, "names": names}).encode())
    assert len(set(labels(tmp_path / "a.seg"))) == 3
    assert "head" in [measure.get("name") for measure in read_record(tmp_path / "a.json")["measures"]]


def test_names_of_tips(segment, teddy, tmp_path):
    record = segment.record(teddy, "-k", 8)
    tips = [protrusion["tip"] for protrusion in record["protrusions"]]
    names = [{"face": tip, "name": f"part {i}"} for i, tip in enumerate(tips)]
    (tmp_path / "tips.json").write_text(json.dumps({"tips": tips, "names": names}))
    found = segment.record(teddy, "--tips", "tips.json", "-o", "parts/%s.off")
    assert [measure["name"] for measure in found["measures"]][1:] == [f"part {i}" for i in range(7)]
    assert names_in(tmp_path / "parts") == [f"part_{i}.off" for i in range(7)] + ["segment_0.off"]
