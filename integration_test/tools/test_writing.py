# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where outputs cannot be written, or would take the place of something."""

import resource
import shutil
import signal
import stat
import subprocess
import time

import pytest

from mesh_files import labels
from tool import names_in, obey_permissions

EARLIER = "old\n"


@pytest.fixture
def earlier_output(tmp_path):
    """A file that a call that fails must leave as it is."""
    path = tmp_path / "a.seg"
    path.write_text(EARLIER)
    return path


@pytest.mark.parametrize("name", ["missing/a.ply", "folder.ply"])
def test_nothing_is_written_if_one_output_cannot_be(segment, tetrahedron, tmp_path, name):
    (tmp_path / "folder.ply").mkdir()
    segment.refuses(tetrahedron, "-o", "a.seg", "-o", name, "--json", "a.json",
                    message=f"{name}: cannot be written")
    assert names_in(tmp_path) == ["folder.ply"]


@pytest.mark.parametrize("options", ["-o a.seg", "-o a.ply", "--json a.json", "-o parts/%d.ply"])
def test_folder_that_is_not_writable(segment, tetrahedron, tmp_path, options):
    tmp_path.chmod(0o500)
    try:
        segment.refuses(tetrahedron, *options.split(), message=": Permission denied",
                        preexec_fn=obey_permissions)
        assert names_in(tmp_path) == []
    finally:
        tmp_path.chmod(0o700)


def test_permissions_of_a_file_that_is_replaced(segment, tetrahedron, earlier_output):
    earlier_output.chmod(0o640)
    segment(tetrahedron, "-o", "a.seg")
    assert stat.S_IMODE(earlier_output.stat().st_mode) == 0o640
    assert earlier_output.read_text() != EARLIER


def test_symbolic_links(segment, tetrahedron, tmp_path, earlier_output):
    link, link_to_nothing = tmp_path / "link.seg", tmp_path / "to_nothing.seg"
    link.symlink_to("a.seg")
    link_to_nothing.symlink_to("b.seg")
    segment(tetrahedron, "-o", link, "-o", link_to_nothing)
    assert names_in(tmp_path) == ["a.seg", "b.seg", "link.seg", "to_nothing.seg"]
    assert link.is_symlink() and link_to_nothing.is_symlink()
    assert earlier_output.read_text() == (tmp_path / "b.seg").read_text() != EARLIER


def test_circle_of_links(segment, tetrahedron, tmp_path):
    (tmp_path / "circle.seg").symlink_to("circle.seg")
    segment.refuses(tetrahedron, "-o", "circle.seg", message="circle.seg: cannot be written")


@pytest.mark.parametrize("mesh, options, message", [
    ("tetrahedron.off", "--json /dev/full",
     "/dev/full: cannot be written: No space left on device"),
    ("nan.off", "-o new/%d.ply", "nan.off: "),
    ("tetrahedron.off", "-o a.seg/parts/%d.ply", ""),
])
def test_failure_changes_no_file(segment, data, tmp_path, earlier_output, mesh, options, message):
    segment.refuses(data / mesh, "-o", "a.seg", *options.split(), message=message)
    assert names_in(tmp_path) == ["a.seg"]
    assert earlier_output.read_text() == EARLIER


def limit_file_sizes():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (16384, 16384))


def test_full_disc(segment, teddy, tmp_path, earlier_output):
    """A limit on file sizes is that of the disc: the second file fits, the first one does not."""
    segment.refuses(teddy, *"-k 2 -o new/%d.ply -o a.seg -o big.ply".split(),
                    message="cannot be written", preexec_fn=limit_file_sizes)
    assert names_in(tmp_path) == ["a.seg", "teddy.off"]
    assert earlier_output.read_text() == EARLIER


def test_full_standard_output(segment, tetrahedron):
    with open("/dev/full", "w", encoding="ascii") as full:
        assert segment.run(tetrahedron, stdout=full).code != 0
        assert segment.run("--help", stdout=full).code == 1


@pytest.fixture
def names(data, tmp_path):
    """A folder with meshes by several names."""
    folder = tmp_path / "names"
    (folder / "parts").mkdir(parents=True)
    shutil.copy(data / "tetrahedron.off", folder / "0.off")
    (folder / "tips.json").write_text('{"tips": [0]}\n')
    (folder / "link.off").symlink_to("0.off")
    (folder / "parts/7.ply").symlink_to("../0.off")
    return folder


@pytest.mark.parametrize("options", [
    "-o %d.off", "-o ./%d.off", "-o FOLDER/%d.off", "-o link.off", "-o parts/%d.ply",
    "--tips tips.json --json tips.json", "--tips tips.json --json ./tips.json",
    "-o %d.ply --json 12.ply", "-o d%d.ply -o d0.ply", "-o d%03d.ply -o d1000.ply",
    "-o d%3d.ply -o ../names/d123.ply", "-o d%d.ply -o d%02d.ply", "-o d%d.ply -o d1%d.ply",
    "-o 1%d.ply -o %d2.ply", "-o new.ply -o ./new.ply", "-o new/a.ply -o new/../new/a.ply",
])
def test_file_named_twice(segment, data, names, options):
    """No output takes the place of an input or of another output, by whatever name."""
    options = options.replace("FOLDER", str(names)).split()
    segment.in_folder(names).refuses("0.off", *options, code=2, message="' is named twice")
    assert names_in(names) == ["0.off", "link.off", "parts", "parts/7.ply", "tips.json"]
    assert (names / "0.off").read_bytes() == (data / "tetrahedron.off").read_bytes()


def test_names_that_only_look_alike(segment, names):
    segment.in_folder(names)("0.off", "-k", 2, *"-o d%d.off -o d%d.ply -o d00.off".split(),
                             *"-o %02d.off -o parts/0.off".split())


def test_longest_name(segment, tetrahedron, tmp_path):
    name = 250 * "a" + ".seg"
    segment(tetrahedron, "-k", 2, "-o", name)
    assert len(labels(tmp_path / name)) == 4


def test_standard_output_by_its_name(segment, tetrahedron, tmp_path):
    """What was written there before and after stays."""
    path = tmp_path / "out"
    with path.open("wb", buffering=0) as out:
        out.write(b"before\n")
        segment(tetrahedron, *"-k 2 --quiet --json /dev/stdout".split(), stdout=out)
        out.write(b"after\n")
    text = path.read_text()
    assert text.startswith("before\n") and text.endswith("after\n")
    assert '"faces": 4' in text


@pytest.mark.parametrize("attempt", range(3))
def test_ended_while_writing(segment, example_meshes, tmp_path, attempt):
    """No file is half written, and none stays under another name."""
    outputs = ["a.obj", "a.ply", "a.vtp", "b.obj", "b.vtp"]
    written = sorted([*outputs, "a.mtl", "b.mtl"])
    command = segment.command(example_meshes / "large.off", "-k", 2,
                              *(word for name in outputs for word in ("-o", name)))
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as process:
        while process.poll() is None and not any(tmp_path.glob("a.obj.*.part")):
            time.sleep(1e-4)
        process.terminate()
    if process.returncode == -signal.SIGTERM:
        # All of them if the signal came late.
        assert names_in(tmp_path) in ([], written)
    else:
        assert names_in(tmp_path) == written


def test_files_of_an_earlier_call(segment, teddy, tmp_path):
    """They are told of."""
    assert segment(teddy, "-k", 4, "-o", "earlier/%d.obj").err == ""
    result = segment(teddy, "-k", 3, "-o", "earlier/%d.obj")
    assert result.err.count("\n") == 1 and "earlier/3.obj is not of this run" in result.err
    result = segment(teddy, "-k", 2, "-o", "earlier/%d.obj")
    assert result.err.count("\n") == 1
    assert "earlier/2.obj to earlier/3.obj, 2 files, are not of this run" in result.err
    assert names_in(tmp_path / "earlier") == ["0.obj", "1.obj", "2.obj", "3.obj"]
