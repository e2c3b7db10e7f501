# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""--tips: the protrusions of some faces only, as the page of --report saves them."""

import json

import pytest

from mesh_files import labels
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
