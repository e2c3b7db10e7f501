# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of segments, distances, and that two calls do the same."""

import math

import pytest

from mesh_files import OffFile, labels
from tool import names_in


@pytest.mark.parametrize("options", [
    "", "--method paper", "--distance landmark", "--distance landmark --landmarks 20 --seed 7",
    "--distance diffusion", "--distance heat"])
def test_two_runs_are_the_same(segment, teddy, tmp_path, options):
    for name in ("a", "b"):
        segment(teddy, "-k", 6, *options.split(),
                *f"-o {name}.seg -o {name}.ply -o {name}.glb".split())
    for extension in ("seg", "ply", "glb"):
        first, second = (tmp_path / f"{name}.{extension}" for name in ("a", "b"))
        assert first.read_bytes() == second.read_bytes()


@pytest.mark.parametrize("options", ["", "--method paper", "--method paper --distance landmark"])
def test_two_threads_find_the_same(segment, teddy, tmp_path, libraries, options):
    if "tbb" not in libraries:
        segment.refuses(teddy, "--threads", 2, code=2, message="oneTBB was not found")
        return
    for threads in (1, 2):
        record = segment.record(teddy, "-k", 6, *options.split(), "--threads", threads,
                                "-o", f"{threads}.seg")
        assert record["threads"] == threads
    assert (tmp_path / "1.seg").read_bytes() == (tmp_path / "2.seg").read_bytes()


@pytest.mark.parametrize("distance", ["geodesic", "landmark", "diffusion", "heat", "exact"])
def test_distance(segment, example_meshes, distance):
    record = segment.record(example_meshes / "horse.off", "-k", 3, "--distance", distance)
    assert record["distance"] == distance
    assert record["segments"] == 3
    assert (record["landmarks"] is None) == (distance != "landmark")
    assert (record["eigenpairs"] is None) == (distance != "diffusion")
    assert (record["diffusion_time"] is None) == (distance != "diffusion")


def test_minimum_cut_has_a_distance_of_its_own(segment, example_meshes):
    record = segment.record(example_meshes / "horse.off", "-k", 3)
    assert record["method"] == "minimum-cut"
    assert record["distance"] is None
    assert "preparation" in [stage["stage"] for stage in record["stages"]]
    for protrusion in record["protrusions"]:
        assert protrusion["border_slot"] is None
        assert "value" in protrusion


def test_options_of_the_diffusion_distance(segment, example_meshes):
    record = segment.record(example_meshes / "horse.off",
                            *"-k 3 --distance diffusion --eigenpairs 5 --time 0".split())
    assert record["eigenpairs"] == 5
    assert record["diffusion_time"] == 0


def test_more_eigenpairs_than_faces(segment, tetrahedron):
    segment(tetrahedron, *"--distance diffusion --eigenpairs 300".split())
    segment.refuses(tetrahedron, *"--distance diffusion --eigenpairs 1000000".split(), code=2)


def test_note_on_many_eigenpairs(segment, teddy):
    result = segment(teddy, *"-k 4 --distance diffusion --eigenpairs 101".split())
    assert "101 eigenpairs on " in result.err


def test_fewer_segments_than_components(segment, data):
    result = segment(data / "two_components.off", "-k", 1, "--json", "-")
    assert "found 2 segments instead of 1" in result.err
    record = segment.record(data / "two_components.off", "-k", 1)
    assert record["segments"] == 2
    assert record["note"].startswith("found 2 segments instead of 1")


def test_as_many_segments_as_faces(segment, tetrahedron):
    result = segment(tetrahedron, "-k", 4, "--json", "-")
    record = segment.record(tetrahedron, "-k", 4)
    assert record["segments_requested"] == 4
    assert record["segments"] == 4 or "of 4 segments" in result.err


def test_more_segments_than_faces(segment, tetrahedron, tmp_path):
    segment.refuses(tetrahedron, "-k", 5, "-o", "five.seg", message="tetrahedron.off: has 4 faces")
    assert names_in(tmp_path) == []


def test_no_protrusion(segment, tetrahedron):
    note = "found no protrusion"
    assert note in segment(tetrahedron).err
    assert segment.record(tetrahedron)["note"].startswith(note)


def write_ball(path, rings=30):
    around = 2 * rings
    points = [(0, 0, 1), (0, 0, -1)]
    for ring in range(1, rings):
        polar = math.pi * ring / rings
        points += [(math.sin(polar) * math.cos(2 * math.pi * i / around),
                    math.sin(polar) * math.sin(2 * math.pi * i / around), math.cos(polar)) for i in range(around)]
    faces = []
    for i in range(around):
        rows = [[2 + ring * around + (i + step) % around for ring in range(rings - 1)] for step in (0, 1)]
        faces += [(0, rows[0][0], rows[1][0]), (1, rows[1][-1], rows[0][-1])]
        faces += [(rows[0][ring], rows[0][ring + 1], rows[1][ring + 1], rows[1][ring]) for ring in range(rings - 2)]
    OffFile.of(points, faces).write(path)


def test_more_segments_than_the_shape_shows(segment, teddy, tmp_path):
    note = "cut off where the shape shows no border"
    write_ball(tmp_path / "ball.off")
    assert "found no protrusion" in segment("ball.off").err
    assert note not in segment(teddy, "-k", 3).err
    assert f"2 segments were {note}" in segment("ball.off", "-k", 3).err
    assert f"1 segment was {note}" in segment.record("ball.off", "-k", 2)["note"]


@pytest.mark.parametrize("unit, area", [("e100", 6e200), ("e-100", 6e-200)])
def test_squares_of_areas_beyond_double(segment, tmp_path, unit, area):
    content = f"OFF\n3 1 0\n0 0 0\n3{unit} 0 0\n0 4{unit} 0\n3 0 1 2\n"
    (tmp_path / "triangle.off").write_text(content)
    record = segment.record("triangle.off", "-o", "triangle.seg")
    assert record["measures"][0]["area"] == area


@pytest.mark.parametrize("method", ["minimum-cut", "paper"])
def test_number_of_a_hierarchy(segment, teddy, tmp_path, method):
    """Each segmentation has one border less than the one before, and the finest is that of -k."""
    record = segment.record(teddy, "-k", 7, "--method", method, "-o", "7.seg")
    finest = labels(tmp_path / "7.seg")
    for number in range(7, 0, -1):
        joined = segment.record(teddy, "-k", number, "--of", 7, "--method", method, "-o", "a.seg")
        found = labels(tmp_path / "a.seg")
        assert (joined["segments"], joined["segments_requested"], joined["hierarchy_requested"]) == (number, number, 7)
        assert joined["note"] is None
        assert len(set(zip(finest, found))) == 7  # they are nested
        assert [(p["segment"], p["tip"], p["area"]) for p in joined["protrusions"]] == \
            [(p["segment"], p["tip"], p["area"]) for p in record["protrusions"]][:number - 1]
        assert [measure["segment"] for measure in joined["measures"]] == list(range(number))


def test_number_of_a_hierarchy_that_is_not_reached(segment, teddy):
    record = segment.record(teddy, *"-k 600 --of 700".split())
    assert record["segments"] < 600
    assert "of 600 segments" in record["note"]


def test_number_of_a_hierarchy_below_the_number_of_components(segment, data):
    record = segment.record(data / "two_components.off", *"-k 1 --of 4".split())
    assert record["segments"] == 2
    assert "2 connected components" in record["note"]
