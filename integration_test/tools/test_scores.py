# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""evaluate_segmentation: several references, their means, folders."""

import json

import pytest


@pytest.fixture
def references(tetrahedron, tmp_path):
    """Three segmentations of a tetrahedron, as the benchmark's archive names them."""
    folder = tmp_path / "1"
    folder.mkdir()
    for number, content in ((0, "0 0 1 1"), (2, "0 0 0 1"), (10, "0 1 2 3")):
        (folder / f"1_{number}.seg").write_text(content.replace(" ", "\n") + "\n")
    (folder / "notes.txt").write_text("no segmentation")
    return folder


def test_mean_in_json(evaluate, tetrahedron, references):
    files = [references / f"1_{i}.seg" for i in (0, 2, 10)]
    scores = json.loads(evaluate(tetrahedron, files[0], *files, "--json").out)
    assert [entry["reference"] for entry in scores["references"]] == [str(file) for file in files]
    for name, mean in scores["mean"].items():
        values = [entry[name] for entry in scores["references"] if entry[name] is not None]
        assert mean == pytest.approx(sum(values) / len(values))
    assert scores["references"][0]["hamming_distance"] == 0


def test_folder_of_references(evaluate, tetrahedron, references):
    files = [references / f"1_{i}.seg" for i in (0, 2, 10)]  # in the order of their numbers
    assert evaluate(tetrahedron, files[0], references).out == evaluate(tetrahedron, files[0], *files).out


def test_folder_without_references(evaluate, tetrahedron, references, tmp_path):
    (tmp_path / "empty").mkdir()
    evaluate.refuses(tetrahedron, references / "1_0.seg", "empty", message="empty: has no .seg files in it")
