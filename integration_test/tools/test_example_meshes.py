# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_example_mesh."""

import pytest

from mesh_files import OffFile


@pytest.mark.parametrize("shape, handles", [
    ("octopus", 0), ("teddy", 0), ("hand", 0), ("horse", 0),
    ("chair", 1),  # below the back
])
def test_shape(make_mesh, tmp_path, shape, handles):
    first, second = tmp_path / "1.off", tmp_path / "2.off"
    for path in (first, second):
        make_mesh(shape, path, "--faces", 2000)
    assert first.read_bytes() == second.read_bytes()
    mesh = OffFile(first)
    assert all(len(face) == 3 for face in mesh.faces)
    assert mesh.is_closed()
    assert 2000 <= len(mesh.faces) <= 2500
    assert len(mesh.points) - len(mesh.faces) / 2 == 2 - 2 * handles


def test_unknown_shape(make_mesh):
    make_mesh.refuses("snail", "snail.off", code=2)


def test_file_that_cannot_be_written(make_mesh):
    make_mesh.refuses("teddy", "missing/teddy.off", "--faces", 1000,
                      message="missing/teddy.off: cannot be written: No such file or directory")


def test_unknown_format(make_mesh):
    """It is told before a mesh is made."""
    make_mesh.refuses("teddy", "teddy.xyz", code=2,
                      message="teddy.xyz cannot be written: only .off, .ply, .obj and .stl are known")


def test_output_that_cannot_be_written(make_mesh):
    with open("/dev/full", "wb") as full:
        make_mesh.refuses("teddy", "teddy.off", "--faces", 1000, stdout=full,
                          message="the standard output: cannot be written")


@pytest.mark.parametrize("extension", ["off", "ply", "obj", "stl"])
def test_formats(make_mesh, segment, tmp_path, extension):
    make_mesh("chair", f"small.{extension}", "--faces", 1000)
    segment(f"small.{extension}", "-k", 2, "-o", "small.seg")
    (tmp_path / f"full.{extension}").symlink_to("/dev/full")
    make_mesh.refuses("chair", f"full.{extension}", "--faces", 1000,
                      message=f"full.{extension}: cannot be written")


@pytest.mark.parametrize("options", [[], ["--faces", 4000], ["--faces", 8000]])
def test_no_arm_has_the_underside_of_the_body(make_mesh, segment, options):
    make_mesh("octopus", "a.off", *options)
    areas = sorted(measure["area"] for measure in segment.record("a.off")["measures"])
    assert len(areas) == 10
    body, *arms, head = [area / sum(areas) for area in areas]
    assert 0.035 < body < 0.07 < min(arms) and max(arms) < 0.105
    assert head > 0.2


@pytest.mark.parametrize("shape, number, children", [
    ("octopus", 9, [8]),  # no arm sticks out of another one, though they touch
    ("teddy", 8, [2, 5]),  # the ears stick out of the head
    ("hand", 6, [5]),
    ("horse", 8, [1, 6]),  # the head sticks out of the neck
    ("chair", 7, [1, 1, 4]),  # both posts of the back stand on hind legs
])
def test_what_sticks_out_of_what(make_mesh, segment, shape, number, children):
    make_mesh(shape, "a.off")
    record = segment.record("a.off", "-k", number)
    parents = [protrusion["parent"] for protrusion in record["protrusions"]]
    assert sorted(parents.count(parent) for parent in set(parents)) == children
    assert max(parents, key=parents.count) == 0
