# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed segments and skeletons."""

import dataclasses

import numpy as np
import pytest

import protrusion_segmentation as ps
from meshes import TETRAHEDRON, ball_with_arms, icosahedron

POINTS, TRIANGLES = ball_with_arms(3)
FOUND = ps.segmentation(POINTS, TRIANGLES, 7)


def volume(points, triangles):
    return np.linalg.det(points[triangles]).sum() / 6


def is_closed(triangles):
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return set(map(tuple, sides.tolist())) == set(map(tuple, sides[:, ::-1].tolist()))


@pytest.mark.parametrize("caps", ["flat", "faired"])
def test_segments_are_closed(caps):
    parts = ps.closed_segments(POINTS, TRIANGLES, FOUND, caps)
    assert len(parts) == 7
    volumes = [volume(part.vertices, part.faces) for part in parts]
    for s, part in enumerate(parts):
        assert is_closed(part.faces) and volumes[s] > 0
        own = POINTS[TRIANGLES[FOUND.labels == s]]
        assert np.allclose(part.vertices[part.faces[: len(own)]].sum(axis=(0, 1)), own.sum(axis=(0, 1)))
    whole = volume(POINTS, TRIANGLES)
    assert sum(volumes) == pytest.approx(whole, rel=1e-9 if caps == "flat" else 0.2)


def test_connectors():
    flat = [volume(part.vertices, part.faces) for part in ps.closed_segments(POINTS, TRIANGLES, FOUND)]
    parts, connectors = ps.closed_segments_with_connectors(POINTS, TRIANGLES, FOUND, 0.01, sides=4, smallest_radius=0)
    assert [(c.segment, c.parent) for c in connectors] == [(s, FOUND.parents[s]) for s in range(1, 7)]
    for part in parts:
        assert is_closed(part.faces)
    placed = [c for c in connectors if c.status == "placed"]
    assert len(placed) == 6
    for c in placed:
        assert c.tolerance == 0.01 and c.base.shape == (3,)
        assert np.linalg.norm(c.end - c.base) == pytest.approx(c.depth)
        assert c.peg_segment == c.segment and volume(parts[c.segment].vertices, parts[c.segment].faces) > flat[c.segment]
    assert volume(parts[0].vertices, parts[0].faces) < flat[0]


def test_wrong_connectors():
    for wrong, message in (
        ({"sides": 2}, "^sides is 2"),
        ({"radius": 1}, "^connectors: radius is out of range$"),
        ({"tolerance": -1}, "^connectors: tolerance is out of range$"),
        ({"depth": "deep"}, "^depth is no number, but 'deep'$"),
    ):
        with pytest.raises(ValueError, match=message):
            ps.closed_segments_with_connectors(POINTS, TRIANGLES, FOUND, **wrong)


def test_other_labels():
    two = dataclasses.replace(FOUND, labels=np.minimum(FOUND.labels, 1), parents=[0, 0], tips=[-1, FOUND.tips[1]])
    assert len(ps.closed_segments(POINTS, TRIANGLES, two)) == 2


def test_skeleton():
    rig = ps.skeleton(POINTS, TRIANGLES, FOUND, 0)
    assert rig.points.shape == (13, 3) and rig.are_tips.sum() == 6
    assert rig.parents[0] == 0 and (rig.parents[1:] < np.arange(1, 13)).all()
    assert np.linalg.norm(rig.points[0]) < 0.1
    tips = POINTS[TRIANGLES[FOUND.tips[1:]]].mean(axis=1)
    of_tips = rig.points[rig.are_tips][np.argsort(rig.segments[rig.are_tips])]
    assert np.linalg.norm(of_tips - tips, axis=1).max() < 0.3
    curve = ps.skeleton(POINTS, TRIANGLES, FOUND)
    assert 13 < len(curve.points) <= 13 + 4 * 6


def test_wrong_arguments():
    calls = {
        "^caps is 'round', but it must be flat or faired$": lambda: ps.closed_segments(POINTS, TRIANGLES, FOUND, "round"),
        "^found is no Segmentation, but ndarray$": lambda: ps.skeleton(POINTS, TRIANGLES, FOUND.labels),
        "^found.labels: there are 1280, but the mesh has 4 faces$": lambda: ps.skeleton(*TETRAHEDRON, FOUND),
        "^inner_joints is -1, but": lambda: ps.skeleton(POINTS, TRIANGLES, FOUND, -1),
        "^found: there is no segment 7$": lambda: ps.skeleton(
            POINTS, TRIANGLES, dataclasses.replace(FOUND, labels=FOUND.labels + 1)),
        "^found: there is no segment -1$": lambda: ps.closed_segments(
            POINTS, TRIANGLES, dataclasses.replace(FOUND, parents=FOUND.parents - 1)),
        "^found: there is no face 1280$": lambda: ps.closed_segments(
            POINTS, TRIANGLES, dataclasses.replace(FOUND, tips=FOUND.tips * 0 + 1280)),
        "^found: there are not as many tips as parents$": lambda: ps.skeleton(
            POINTS, TRIANGLES, dataclasses.replace(FOUND, tips=[0])),
    }
    for words, call in calls.items():
        with pytest.raises(ValueError, match=words):
            call()


def test_joined_pieces_are_refused():
    points, triangles = icosahedron()
    vertices = np.concatenate([points, 0.3 * points + [2.2, 0, 0]])
    faces = np.concatenate([triangles, triangles + len(points)])
    joined = ps.segmentation(vertices, faces, 2, join_pieces=True)
    with pytest.raises(ValueError, match="^found: pieces were joined"):
        ps.closed_segments(vertices, faces, joined)
