# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of segments that --close closes, and smooth borders."""

import math

import pytest

from mesh_files import OffFile, labels, volume_of_closed, vtp_array
from records import read_record
from tool import Tool


def parts(folder, number):
    return [folder / f"{i}.off" for i in range(number)]


@pytest.mark.parametrize("method", ["minimum-cut", "paper"])
def test_close(segment, teddy, tmp_path, method):
    call = [teddy, "-k", 6, "--method", method]
    assert segment(*call, "--close", "-o", "flat/%d.off").err == ""
    volume = volume_of_closed([teddy])
    assert volume > 0
    assert math.isclose(volume_of_closed(parts(tmp_path / "flat", 6)), volume, rel_tol=1e-6)

    assert segment(*call, "-o", "open/%d.off").err == ""
    assert not OffFile(tmp_path / "open/0.off").is_closed()

    assert segment(*call, "--close=faired", "-o", "faired/%d.off").err == ""
    volume_of_closed(parts(tmp_path / "faired", 6))
    assert (tmp_path / "flat/1.off").read_bytes() != (tmp_path / "faired/1.off").read_bytes()


def test_close_segments_of_an_open_mesh(segment, data):
    result = segment(data / "open_sheet.off", "--close", "-o", "sheet/%d.off")
    assert "meshes of segments stay open" in result.err


@pytest.fixture(scope="module")
def smooth(programs, example_meshes, tmp_path_factory):
    """The folder of a call with smooth borders and, named ragged, of one without."""
    folder = tmp_path_factory.mktemp("smooth")
    segment = Tool(programs / "segment_by_protrusions", folder)
    teddy = example_meshes / "teddy.off"
    segment(teddy, *"-k 5 -o ragged.seg -o ragged.ply --borders ragged.vtp".split())
    segment(teddy, *"-k 5 --smooth-borders -o %d.off --close --borders borders.vtp".split(),
            *"-o teddy.seg -o teddy.off -o teddy.ply -o teddy.vtp -o teddy.glb".split(),
            *"--json smooth.json --quiet".split())
    read_record(folder / "smooth.json")
    return folder


def test_volume_with_smooth_borders(smooth, example_meshes):
    volume = volume_of_closed([example_meshes / "teddy.off"])
    assert math.isclose(volume_of_closed([smooth / "teddy.off"]), volume, rel_tol=1e-6)
    assert math.isclose(volume_of_closed(parts(smooth, 5)), volume, rel_tol=1e-6)


def test_labels_of_old_faces_with_smooth_borders(smooth):
    old, new = labels(smooth / "ragged.seg"), labels(smooth / "teddy.seg")
    assert len(new) == len(old)
    assert len(set(new)) == 5
    assert sum(a != b for a, b in zip(old, new)) < len(old) / 20


def test_numbers_of_old_faces_with_smooth_borders(smooth):
    assert b"property uint old_face" in (smooth / "teddy.ply").read_bytes()
    assert b"old_face" not in (smooth / "ragged.ply").read_bytes()
    assert 'Name="old_face"' in (smooth / "teddy.vtp").read_text()


def test_lines_of_smooth_borders(smooth):
    for name in ("segment_1", "segment_2", "length", "value", "probability"):
        assert f'Name="{name}"' in (smooth / "borders.vtp").read_text()
    assert sum(vtp_array(smooth / "borders.vtp", "length")) < \
        sum(vtp_array(smooth / "ragged.vtp", "length"))
