# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""evaluate_segmentation: several references, their means, folders."""

import json

import numpy as np
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
    scores = json.loads(evaluate(tetrahedron, files[0], *files, "--json", "-").out)
    assert [entry["reference"] for entry in scores["references"]] == [str(file) for file in files]
    for name, mean in scores["mean"].items():
        values = [entry[name] for entry in scores["references"] if entry[name] is not None]
        assert mean == pytest.approx(sum(values) / len(values))
    assert scores["references"][0]["hamming_distance"] == 0


def test_json_in_a_file(evaluate, tetrahedron, references, tmp_path):
    first, second = references / "1_0.seg", references / "1_2.seg"
    scores = json.loads(evaluate(tetrahedron, first, first, second, "--json", "-").out)
    assert evaluate(tetrahedron, first, first, second, "--json", "a.json").out == ""
    assert json.loads((tmp_path / "a.json").read_text()) == scores
    evaluate.refuses(tetrahedron, first, first, "--json", "missing/a.json",
                     message="missing/a.json: cannot be written: No such file or directory")
    for name in (first, second):  # by itself, or in a folder of references
        before = name.read_text()
        evaluate.refuses(tetrahedron, first, references, "--json", name, message="would replace a file that is read")
        assert name.read_text() == before


def test_folder_of_references(evaluate, tetrahedron, references):
    files = [references / f"1_{i}.seg" for i in (0, 2, 10)]  # in the order of their numbers
    assert evaluate(tetrahedron, files[0], references).out == evaluate(tetrahedron, files[0], *files).out


def test_folder_without_references(evaluate, tetrahedron, references, tmp_path):
    (tmp_path / "empty").mkdir()
    evaluate.refuses(tetrahedron, references / "1_0.seg", "empty", message="empty: has no .seg or .npy files in it")


def test_formats_of_learned_methods(evaluate, tetrahedron, tmp_path):
    """The same scores, whatever the labels come in."""
    (tmp_path / "a.seg").write_text("0\n0\n3\n1\n")
    np.save(tmp_path / "a.npy", np.array([0, 0, 3, 1]))
    (tmp_path / "list.json").write_text("[0, 0, 3, 1]")
    (tmp_path / "face2label.json").write_text('{"3": 1, "0": 0, "1": 0, "2": 3}')
    np.save(tmp_path / "true.npy", np.array([0, 0, 1, 1]))
    (scores,) = {evaluate(tetrahedron, name, "true.npy", "--json", "-").out
                 for name in ("a.seg", "a.npy", "list.json", "face2label.json")}
    mean = json.loads(scores)["mean"]
    assert mean["mean_best_intersection_over_union"] == pytest.approx((1 + 1 / 2) / 2)


def test_faces_in_no_part(evaluate, tetrahedron, tmp_path):
    np.save(tmp_path / "a.npy", np.array([0, 0, 3, 1]))
    np.save(tmp_path / "true.npy", np.array([5, 5, -1, -1]))
    scores = json.loads(evaluate(tetrahedron, "a.npy", "true.npy", "--json", "-").out)
    assert scores["mean"]["mean_best_intersection_over_union"] == 1
    assert evaluate(tetrahedron, "a.npy", "true.npy").out.splitlines()[1].split()[-2:] == ["1.0000", "true.npy"]


@pytest.mark.parametrize("content, message", [
    ("{", "is no JSON with an array of labels"),
    ("3", "is no JSON with an array of labels"),
    ("[0, 0, 1]", "has 3 labels, but the mesh has 4 faces"),
    ("[0, 0, 1, 0.5]", "has a label that is no integer: 0.5"),
    ("[0, 0, 1, 1e300]", "has a label that is no integer: 1e+300"),
    ("[0, 0, 1, 12345678901]", "the label of face 3 is no integer of 32 bits"),
    ('{"0": 0, "1": 0, "2": 0, "7": 0}', "one of them is for face '7'"),
    ('{"0": 0, "1": 0, "2": 0, "01": 0}', "has no label for face 3"),
    ('{"0": 0, "1": 0, "2": 0, "x": 0}', "one of them is for face 'x'"),
])
def test_json_that_is_no_labels(evaluate, tetrahedron, tmp_path, content, message):
    (tmp_path / "a.json").write_text(content)
    evaluate.refuses(tetrahedron, "a.json", "a.json", message=message)
