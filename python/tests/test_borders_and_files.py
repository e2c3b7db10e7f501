# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth borders, metrics, files, and what help() says."""

import inspect
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import protrusion_segmentation as ps
from meshes import TETRAHEDRON, ball_with_arms
from test_segmentation import areas_of

POINTS, TRIANGLES = ball_with_arms(3)
LABELS = ps.segment(POINTS, TRIANGLES, 7)


def length_of_borders(points, faces, labels):
    sides = {}
    for face, label in zip(faces.tolist(), labels.tolist()):
        for a, b in zip(face, face[1:] + face[:1]):
            sides.setdefault((min(a, b), max(a, b)), []).append(label)
    assert all(len(pair) == 2 for pair in sides.values())
    edges = np.array([edge for edge, pair in sides.items() if pair[0] != pair[1]])
    return np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1).sum()


def test_smooth_borders():
    smooth = ps.smooth_borders(POINTS, TRIANGLES, LABELS)
    assert smooth.faces.shape == (len(smooth.labels), 3) and len(smooth.labels) > len(TRIANGLES)
    assert set(smooth.labels) == set(LABELS) and smooth.number_of_fixed_segments == 0
    new, old = areas_of(smooth.vertices, smooth.faces), areas_of(POINTS, TRIANGLES)
    assert np.bincount(smooth.old_faces, new) == pytest.approx(old)
    assert length_of_borders(smooth.vertices, smooth.faces, smooth.labels) < length_of_borders(POINTS, TRIANGLES, LABELS)
    unchanged = ps.smooth_borders(POINTS, TRIANGLES, LABELS, 0)
    assert (unchanged.old_faces == np.arange(len(TRIANGLES))).all() and (unchanged.labels == LABELS).all()
    assert (np.sort(unchanged.faces) == np.sort(TRIANGLES)).all() and (unchanged.vertices == POINTS).all()


def test_smooth_borders_of_polygons_and_broken_faces():
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    faces = [[0, 0, 1], [0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    smooth = ps.smooth_borders(cube, faces, [0, 5, 5, 5, 5, 5, -7], iterations=1)
    assert isinstance(smooth.faces, list) and len(smooth.faces) == len(smooth.labels)
    assert set(smooth.labels) == {5, -7} and smooth.old_faces.min() == 1
    for words, labels in (("labels: there are 2", [0, 0]), ("labels: not all", [0.5] * 7)):
        with pytest.raises(ValueError, match="^" + words):
            ps.smooth_borders(cube, faces, labels)
    with pytest.raises(ValueError, match="^iterations is -1, but it must be from 0"):
        ps.smooth_borders(cube, faces, [0] * 7, -1)


def test_metrics_one_by_one_and_against_several():
    references = [ps.segment(POINTS, TRIANGLES, k) for k in (1, 3, 6)]
    several = ps.evaluate_against(POINTS, TRIANGLES, LABELS, references)
    assert several == ps.evaluate_against(POINTS, TRIANGLES, LABELS, np.array(references))
    assert several[0].cut_discrepancy is None
    for metrics, reference in zip(several, references):
        arguments = (POINTS, TRIANGLES, LABELS, reference)
        assert metrics == ps.evaluate(*arguments)
        assert metrics.rand_index_error == ps.rand_index_error(*arguments)
        assert metrics.hamming_distance == ps.hamming_distance(*arguments)
        assert metrics.cut_discrepancy == ps.cut_discrepancy(*arguments)
        assert metrics.mean_best_intersection_over_union == ps.mean_best_intersection_over_union(*arguments)
        assert metrics.global_consistency_error == ps.consistency_error(*arguments)
    assert ps.evaluate_against(POINTS, TRIANGLES, LABELS, []) == []
    with pytest.raises(ValueError, match="^reference: the shape is"):
        ps.evaluate_against(POINTS, TRIANGLES, LABELS, [3])
    with pytest.raises(ValueError, match="^references: no sequence"):
        ps.evaluate_against(POINTS, TRIANGLES, LABELS, 3)


def test_files_of_labels(tmp_path):
    path = tmp_path / "mesh.seg"
    ps.write_seg(path, LABELS)
    assert path.read_text().startswith(f"{LABELS[0]}\n")
    assert (ps.read_seg(str(path)) == LABELS).all()
    path.write_bytes(b"3\r\n 4 \r\n\r\n")
    assert ps.read_seg(path).tolist() == [3, 4]
    for word in ["four", "-1", "1_0"]:
        path.write_text(f"3\n{word}\n")
        with pytest.raises(ValueError, match=f"mesh.seg: line 2 is no integer from 0, but '{word}'$"):
            ps.read_seg(path)
    with pytest.raises(ValueError, match="^labels: not all"):
        ps.write_seg(path, [0.5])
    with pytest.raises(ValueError, match="^labels: -1 is no label"):
        ps.write_seg(path, [0, -1])
    with pytest.raises(FileNotFoundError):
        ps.read_seg(tmp_path / "none.seg")


@pytest.mark.skipif("PROTRUSION_SEGMENTATION_TOOLS" not in os.environ, reason="the tools were not built")
def test_the_tool_takes_files_of_labels(tmp_path):
    tools = Path(os.environ["PROTRUSION_SEGMENTATION_TOOLS"])
    mesh, mine, others = (tmp_path / name for name in ("mesh.off", "mine.seg", "others.seg"))
    rows = "\n".join([f"{len(POINTS)} {len(TRIANGLES)} 0", *("%.17g %.17g %.17g" % tuple(p) for p in POINTS)])
    mesh.write_text("OFF\n" + rows + "\n" + "".join("3 %d %d %d\n" % tuple(t) for t in TRIANGLES))
    ps.write_seg(mine, LABELS)
    command = [tools / "segment_by_protrusions", mesh, "--labels", mine, "-o", others, "--quiet"]
    subprocess.run(command, check=True)
    assert (ps.read_seg(others) == LABELS).all()


def described(text, names):
    return all(name in (text or "") for name in names)


@pytest.mark.parametrize("name", ps.__all__)
def test_everything_is_documented(name):
    thing = getattr(ps, name)
    assert inspect.getdoc(thing), name
    if inspect.isfunction(thing):
        parameters = inspect.signature(thing).parameters
        assert name == "segment" or described(thing.__doc__, parameters), name
    for field in getattr(thing, "_fields", ()):
        assert "Alias" not in getattr(thing, field).__doc__
    for field in getattr(thing, "__dataclass_fields__", ()):
        assert f"    {field} : " in thing.__doc__, field
    for field, value in vars(thing).items() if inspect.isclass(thing) else ():
        if isinstance(value, property):
            assert value.__doc__, field


def test_tetrahedra_have_all_functions():
    assert ps.cut_discrepancy(*TETRAHEDRON, [0, 0, 1, 1], [9, 9, 3, 3]) == 0
    assert ps.rand_index_error(*TETRAHEDRON, [0, 0, 0, 0], [1, 1, 7, 1]) == pytest.approx(3 / 6)
