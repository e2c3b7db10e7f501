# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each file of ../data as the table in its README.md demands."""

import pathlib
import re

import pytest

from mesh_files import labels
from records import read_record
from tool import names_in

TABLE = re.findall(r"^\| `([^`]*)`.*\| (accept|repair|reject) \|$",
                   (pathlib.Path(__file__).parents[1] / "data/README.md").read_text(), re.MULTILINE)
MESHES = [row for row in TABLE if not row[0].endswith(".seg")]
SEGMENTATIONS = [row for row in TABLE if row[0].endswith(".seg")]
REPAIRS = "degenerate|duplicate|more than two faces|no two sides|turned over"


def rows(table, *duties):
    return pytest.mark.parametrize("name, duty", [row for row in table if row[1] in duties],
                                   ids=lambda word: word.replace(".", "_"))


@pytest.fixture
def outputs(libraries):
    result = "-o a.seg -o a.ply -o a.glb -o a.vtp -o parts/%d.ply --json a.json".split()
    return result + ["--report", "a.html"] * ("three.js" in libraries)


@rows(MESHES, "accept", "repair")
def test_good_mesh(segment, data, tmp_path, outputs, name, duty):
    result = segment(data / name, *outputs)
    assert len(labels(tmp_path / "a.seg")) == read_record(tmp_path / "a.json")["faces"] > 0
    if duty == "repair":
        assert re.search(REPAIRS, result.err), f"repaired without a word\n{result}"


@rows(MESHES, "accept", "repair")
@pytest.mark.parametrize("distance", ["landmark", "diffusion", "heat", "exact"])
def test_good_mesh_with_distance(segment, data, name, duty, distance):
    segment(data / name, "--method", "paper", "--distance", distance)


@rows(MESHES, "reject")
def test_bad_mesh(segment, data, tmp_path, outputs, name, duty):
    segment.refuses(data / name, *outputs, message=f"{data / name}: ")
    assert names_in(tmp_path) == []


@rows(SEGMENTATIONS, "accept")
def test_good_segmentation(evaluate, data, tmp_path, name, duty):
    evaluate(data / "tetrahedron.off", data / name, data / "good.seg", "--json", "a.json")
    assert names_in(tmp_path) == ["a.json"]


@rows(SEGMENTATIONS, "reject")
def test_bad_segmentation(evaluate, data, tmp_path, name, duty):
    evaluate.refuses(data / "tetrahedron.off", data / name, data / "good.seg", "--json", "a.json",
                     message=f"{data / name}: ")
    assert names_in(tmp_path) == []


def test_table_has_every_file(data):
    files = {path.name for path in data.iterdir()} - {"README.md"}
    # What is demanded of these depends on the libraries that were found.
    assert files - {name for name, _ in TABLE} == {"strips.vtp", "three_tetrahedra.3mf", "tetrahedron.gltf"}
