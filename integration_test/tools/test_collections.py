# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes in one call."""

import gzip
import os
import shutil
import time

import pytest

from mesh_files import labels, volume_of_closed
from records import read_record
from tool import names_in, obey_permissions


def files_of(*names, extensions=("json", "ply", "seg")):
    return sorted(f"{name}.{extension}" for name in names for extension in extensions)


def make_newer(path):
    an_hour_from_now = time.time() + 3600
    os.utime(path, (an_hour_from_now, an_hour_from_now))


@pytest.fixture
def meshes(data, teddy, tmp_path):
    """A folder of five meshes, one of them broken, and one in a folder within."""
    folder = tmp_path / "meshes"
    (folder / "inner").mkdir(parents=True)
    teddy.rename(folder / "a.off")
    (folder / "inner/b.stl.gz").write_bytes(gzip.compress((data / "tetrahedron.stl").read_bytes()))
    shutil.copy(data / "truncated.off.gz", folder / "broken.off.gz")
    for name in ("tetrahedron.obj", "tetrahedron.ply"):
        shutil.copy(data / name, folder)
    return folder


def test_collection(segment, data, meshes, tmp_path):
    call = ["meshes", data / "quads.off",
            *"--output-folder out --jobs 2 --format seg --format ply -k 2".split()]
    result = segment.run(*call)
    assert result.code == 1
    assert "meshes/a.off: " in result.out
    assert "meshes/broken.off.gz: is gzip, but broken" in result.err
    assert "6 meshes: 5 segmented, 0 already there, 1 failed" in result.err
    good = ["a", "inner/b", "quads", "tetrahedron.obj", "tetrahedron.ply"]
    assert names_in(tmp_path / "out") == sorted(files_of(*good) + ["broken.json", "inner"])
    for name in good:
        assert "error" not in read_record(tmp_path / f"out/{name}.json")
    assert "error" in read_record(tmp_path / "out/broken.json")

    (meshes / "broken.off.gz").unlink()
    shutil.copy(data / "tetrahedron.off", meshes / "broken.off")
    (tmp_path / "out/a.ply").unlink()
    make_newer(meshes / "tetrahedron.obj")
    assert "6 meshes: 3 segmented, 3 already there, 0 failed" in segment(*call).out
    (meshes / "tetrahedron.obj").touch()
    call += ["--seed", 1]
    assert "6 meshes: 6 segmented, 0 already there, 0 failed" in segment(*call).out
    assert "6 meshes: 0 segmented, 6 already there, 0 failed" in segment(*call).out
    assert segment(*call, "--again", "--quiet").out == ""


@pytest.fixture
def good_meshes(meshes):
    (meshes / "broken.off.gz").unlink()
    return meshes


def test_outputs_are_no_inputs(segment, good_meshes):
    segment.refuses("meshes", *"--output-folder meshes --format off".split(),
                    message="would be a mesh among those to be segmented")
    for _ in range(2):
        result = segment("meshes", *"--output-folder meshes/inner/out --format ply".split())
        assert "4 meshes: " in result.out


def test_mesh_that_is_named_twice(segment, tetrahedron):
    segment.refuses(tetrahedron, tetrahedron, "--output-folder", "out",
                    message="has the same name as another mesh")


def test_folder_without_meshes(segment, tmp_path):
    (tmp_path / "nothing").mkdir()
    segment.refuses("nothing", "--output-folder", "out", message="nothing: has no mesh in it")


@pytest.mark.parametrize("options", ["-o a.seg", "--json a.json", "--format xyz", "--jobs 0",
                                     "--jobs 0x2"])
def test_meaningless_options(segment, tetrahedron, options):
    segment.refuses(tetrahedron, "--output-folder", "out", *options.split(), code=2)


def test_mesh_that_is_not_there(segment, tetrahedron, tmp_path):
    result = segment.run(tetrahedron, "missing", "--output-folder", "out")
    assert result.code == 1
    assert "missing: cannot be opened: No such file or directory" in result.err
    assert names_in(tmp_path / "out") == ["tetrahedron.json", "tetrahedron.seg"]


def test_no_folder_is_made_for_nothing(segment, tmp_path):
    assert segment.run("missing", "--output-folder", "out").code == 1
    assert names_in(tmp_path) == []


def test_files_of_another_run(segment, teddy, tmp_path):
    """They are told of, and not taken for a part of this run."""
    (tmp_path / "in").mkdir()
    mesh = teddy.rename(tmp_path / "in/a.off")
    call = "in --output-folder out".split()
    segment(*call, *"-k 3 --format ply --format seg".split())
    assert "ply" in read_record(tmp_path / "out/a.json")["formats"]
    result = segment(*call, *"-k 3 --format seg".split())
    assert "1 already there" in result.out
    assert result.err == ""  # the file is of the same segments
    for _ in range(2):  # done, and done already
        result = segment(*call, "-k", 2)
        assert result.err.count("\n") == 1
        assert "in/a.off: out/a.ply is of another run than out/a.json" in result.err
    assert "1 already there" in result.out
    assert segment(*call, *"-k 2 --quiet".split()).err == ""
    # That there is a file is not enough: it is of other segments.
    assert "0 already there" in segment(*call, *"-k 2 --format ply".split()).out

    mesh.write_text("broken\n")
    make_newer(mesh)
    result = segment.run(*call, "-k", 2)
    assert result.code == 1
    assert "; out/a.seg, out/a.ply are of another run than out/a.json" in result.err
    assert names_in(tmp_path / "out") == files_of("a")
    read_record(tmp_path / "out/a.json")


def test_fewer_segments_than_asked_for(segment, teddy):
    """It is told also if nothing else is."""
    call = [teddy, *"--output-folder out --again -k 500".split()]
    result = segment(*call)
    assert "of 500 segments: no further border was found" in result.out and result.err == ""
    result = segment(*call, "--quiet")
    assert "of 500 segments: no further border was found" in result.err and result.out == ""


def test_parts_of_another_run(segment, teddy, tmp_path):
    (tmp_path / "in").mkdir()
    teddy.rename(tmp_path / "in/a%d.off")
    call = "in --output-folder out --format stl --close".split()
    segment(*call, "-k", 4)
    for _ in range(2):  # done, and done already
        result = segment(*call, "-k", 2)
        assert result.err.count("\n") == 1
        assert "in/a%d.off: out/a%d/2.stl to out/a%d/3.stl, 2 files, are not of this run" in result.err
    for name in ("2.stl", "3.stl"):
        (tmp_path / "out/a%d" / name).unlink()
    assert segment(*call, "-k", 2).err == ""


def test_mesh_beside_its_outputs(segment, teddy):
    assert segment(teddy, "--output-folder", teddy.parent).err == ""


@pytest.fixture
def same_name(segment, teddy, tetrahedron, tmp_path):
    """Two meshes of one name, the first of which is segmented."""
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
    teddy.rename(tmp_path / "a/x.off")
    shutil.copy(tetrahedron, tmp_path / "b/x.off")
    segment(*"a/x.off -k 2 --output-folder out".split())


@pytest.mark.parametrize("options", [[], ["--again"]])
def test_mesh_of_the_same_name(segment, same_name, tmp_path, options):
    before = labels(tmp_path / "out/x.seg")
    result = segment.run(*"b/x.off -k 2 --output-folder out".split(), *options)
    assert result.code == 1
    assert "b/x.off: out/x.json tells of a/x.off" in result.err
    assert labels(tmp_path / "out/x.seg") == before


def test_same_mesh_by_another_name(segment, same_name, tmp_path):
    assert "1 already there" in segment(*"a/x.off -k 2 --output-folder out".split()).out
    segment.in_folder(tmp_path / "a")(*"x.off -k 2 --output-folder ../out".split())


def test_names_with_a_percent_sign(segment, teddy, tetrahedron, tmp_path):
    (tmp_path / "in").mkdir()
    teddy.rename(tmp_path / "in/m0.off")
    shutil.copy(tetrahedron, tmp_path / "in/m%d.off")
    call = "in -k 2 --format ply --format seg --output-folder out".split()
    segment(*call)
    assert names_in(tmp_path / "out") == files_of("m0", "m%d")
    assert len(labels(tmp_path / "out/m%d.seg")) == 4
    assert "2 already there" in segment(*call).out


def test_folder_that_cannot_be_read(segment, tetrahedron, tmp_path):
    shut = tmp_path / "in/shut"
    shut.mkdir(parents=True)
    shutil.copy(tetrahedron, tmp_path / "in")
    shut.chmod(0)
    try:
        segment.refuses("in", "--output-folder", "out", message="in/shut: cannot be read",
                        preexec_fn=obey_permissions)
    finally:
        shut.chmod(0o700)


def test_closed_parts_and_pages(segment, example_meshes, tmp_path, libraries):
    folder = tmp_path / "meshes"
    folder.mkdir()
    shutil.copy(example_meshes / "teddy.off", folder / "a%d.off")
    page = ["--format", "html"] if "three.js" in libraries else []
    call = ["meshes", *"--output-folder out -k 3 --format seg --format off --close".split(), *page]
    segment(*call)
    names = ["a%d", "a%d.json", "a%d.seg"] + [f"a%d/{i}.off" for i in range(3)] + ["a%d.html"] * bool(page)
    assert names_in(tmp_path / "out") == sorted(names)
    record = read_record(tmp_path / "out/a%d.json")
    assert record["caps"] == "flat"
    assert volume_of_closed([tmp_path / f"out/a%d/{i}.off" for i in range(3)]) == \
        pytest.approx(volume_of_closed([folder / "a%d.off"]))
    assert "0 segmented, 1 already there" in segment(*call).out
    assert "1 segmented, 0 already there" in segment(*call[:-len(page) - 1], "--close=faired", *page).out
    (tmp_path / "out/a%d/0.off").unlink()
    assert "1 segmented, 0 already there" in segment(*call[:-len(page) - 1], "--close=faired", *page).out


def test_options_of_formats_in_capitals(segment, teddy, tmp_path):
    segment(teddy, *"-k 2 --output-folder out --format VTP --array-name Label".split())
    assert b"Label" in (tmp_path / "out/teddy.VTP").read_bytes()


@pytest.mark.parametrize("options, message", [
    ("--close", "--close has no meaning without"),
    ("--close --format seg", "--close has no meaning without"),
    ("--report a.html", "--format html writes a page for each mesh"),
    ("--format txt", "'txt' is none of html, .seg, "),
])
def test_wrong_formats(segment, meshes, options, message):
    segment.refuses("meshes", "--output-folder", "out", *options.split(), code=2, message=message)
