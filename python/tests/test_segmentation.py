# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""All that is known of the segments."""

import warnings

import numpy as np
import pytest

import protrusion_segmentation as ps
from meshes import TETRAHEDRON, arms, ball_with_arms, icosahedron

POINTS, TRIANGLES = ball_with_arms()


def edges_between(labels, triangles):
    """The edges whose two faces have different labels, as sorted pairs."""
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    sides.sort(axis=1)
    order = np.lexsort(sides.T)
    first, second = order[::2], order[1::2]  # the mesh is closed
    assert (sides[first] == sides[second]).all()
    of_faces = np.tile(labels, 3)
    return {tuple(edge) for edge in sides[first][of_faces[first] != of_faces[second]].tolist()}


def areas_of(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


@pytest.mark.parametrize("method", ["minimum-cut", "paper"])
def test_segments_and_labels_agree(method):
    found = ps.segmentation(POINTS, TRIANGLES, 7, method)
    assert (found.labels == ps.segment(POINTS, TRIANGLES, 7, method)).all()
    assert found.number_of_segments == 7
    assert repr(found) == f"<Segmentation: {len(TRIANGLES)} faces, 7 segments, 1 of them bodies>"
    assert found.parents[0] == 0 and found.tips[0] == -1
    assert (found.labels[found.tips[1:]] == np.arange(1, 7)).all()
    known = arms(POINTS, TRIANGLES)
    assert sorted(known[found.tips[1:]].tolist()) == [0, 1, 2, 3, 4, 5]
    assert set(found.tips[1:]) <= set(found.selected_tips)
    assert found.areas == pytest.approx(np.bincount(found.labels, areas_of(POINTS, TRIANGLES)))
    for name in ("protruding_areas", "border_lengths", "border_distances", "values"):
        values = getattr(found, name)
        assert np.isnan(values[0]) and (values[1:] > 0).all(), name
    children = found.parents == 0
    children[0] = False
    beyond = found.protruding_areas[children].sum()
    assert found.areas[0] + beyond == pytest.approx(areas_of(POINTS, TRIANGLES).sum())
    assert found.number_of_small_components == 0
    assert found.repairs.is_nothing and found.repairs.components == 1


def test_probabilities_are_those_of_the_minimum_cut_method():
    found = ps.segmentation(POINTS, TRIANGLES, 7)
    assert ((found.probabilities[1:] > 0.5) & (found.probabilities[1:] <= 1)).all()
    assert found.confidences[1:] == pytest.approx(found.probabilities[1:])
    assert found.confidences[0] == found.probabilities[1:].min()
    assert (found.label_confidence == found.confidences[found.labels]).all()
    assert found.distance_histograms.shape == found.diameter_histograms.shape == (0, 0)
    assert (found.border_slots == -1).all()


def test_histograms_are_those_of_the_paper():
    found = ps.segmentation(POINTS, TRIANGLES, 7, "paper")
    assert np.isnan(found.probabilities).all()
    assert found.confidences[1:] == pytest.approx(found.values[1:])
    assert found.distance_histograms.shape == found.diameter_histograms.shape == (7, 100)
    assert (found.distance_histograms[1:].sum(axis=1) <= len(TRIANGLES)).all()
    assert (found.distance_histograms[0] == 0).all()
    assert ((found.border_slots[1:] >= 0) & (found.border_slots[1:] < 100)).all()


def test_borders_are_the_edges_between_segments():
    found = ps.segmentation(POINTS, TRIANGLES, 7)
    edges = edges_between(found.labels, TRIANGLES)
    assert {tuple(sorted(edge)) for edge in found.border_edges.tolist()} == edges
    ends = POINTS[found.border_edges]
    length = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum()
    assert sum(border.length for border in found.borders) == pytest.approx(length)
    for border in found.borders:
        line = np.concatenate([border.points, border.points[:1]]) if border.is_closed else border.points
        assert np.linalg.norm(np.diff(line, axis=0), axis=1).sum() == pytest.approx(border.length)
        s, t = border.segments
        assert s < t
        protrusion = t if found.parents[t] == s else s
        if found.parents[protrusion] == s + t - protrusion:
            assert border.value == found.values[protrusion]
            assert border.probability == found.probabilities[protrusion]


def test_hierarchy_is_that_of_the_function():
    found, tree = ps.segmentation(POINTS, TRIANGLES, 7).hierarchy, ps.hierarchy(POINTS, TRIANGLES, 7)
    assert (found.parents == tree.parents).all()
    for k in range(1, 8):
        assert (found.labels(k) == tree.labels(k)).all()


def test_tips():
    tips = ps.tips(POINTS, TRIANGLES, 6)[:2]
    found = ps.segmentation(POINTS, TRIANGLES, tips=tips)
    assert (found.labels == ps.segment_from_tips(POINTS, TRIANGLES, tips)).all()
    assert found.number_of_segments == 3
    whole = ps.segmentation(POINTS, TRIANGLES, 7)
    assert (ps.segment_from_tips(POINTS, TRIANGLES, whole.tips[1:]) >= 0).all()
    with pytest.raises(ValueError, match="^number_of_segments and tips cannot be given together$"):
        ps.segmentation(POINTS, TRIANGLES, 3, tips=tips)


def test_bodies_of_components_and_small_components():
    points, triangles = icosahedron()
    dust = TETRAHEDRON[0] * 1e-4 + 9
    vertices = np.concatenate([points, points + 5, dust])
    faces = np.concatenate([triangles, triangles + 12, TETRAHEDRON[1] + 24])
    found = ps.segmentation(vertices, faces)
    assert found.number_of_small_components == 1
    assert found.parents.tolist() == [0, 1]
    assert (found.tips == -1).all() and np.isinf(found.confidences).all()
    assert found.repairs.components == 3
    assert found.borders == [] and found.border_edges.shape == (0, 2)


def test_numbers_are_those_of_what_was_given():
    """Also where faces and vertices come before that are not in the mesh."""
    points = np.concatenate([[[9, 9, 9]], POINTS])
    broken = np.concatenate([[[1, 1, 2]], TRIANGLES + 1])
    found, plain = ps.segmentation(points, broken, 7), ps.segmentation(POINTS, TRIANGLES, 7)
    assert (found.tips[1:] == plain.tips[1:] + 1).all()
    assert (np.sort(found.border_edges, axis=None) == np.sort(plain.border_edges + 1, axis=None)).all()
    assert found.repairs.degenerate_faces == 1 and not found.repairs.is_nothing


def test_joined_pieces():
    points, triangles = icosahedron()
    pieces = [points, 0.3 * points + [2.2, 0, 0]]
    vertices = np.concatenate(pieces)
    faces = np.concatenate([triangles, triangles + len(points)])
    found = ps.segmentation(vertices, faces, 2, join_pieces=True)
    assert found.repairs.joined_pieces == 2 and found.repairs.components == 1
    assert found.border_edges.shape == (0, 2)
    assert found.labels[found.tips[1]] == 1


@pytest.mark.parametrize("exponent", [-120, 120])
def test_areas_at_any_scale(exponent):
    scale = 10.0**exponent
    found = ps.segmentation(POINTS * scale, TRIANGLES, 7)
    assert found.areas == pytest.approx(ps.segmentation(POINTS, TRIANGLES, 7).areas * scale * scale, rel=1e-6)


def test_much_repaired_is_a_warning():
    soup = np.random.default_rng(0).random((60, 3))
    loose = np.arange(60).reshape(20, 3)
    for call in (ps.segment, ps.segmentation):
        with pytest.warns(ps.RepairWarning, match="^faces: among 20 there are hardly any faces that share edges") as seen:
            call(soup, loose)
        assert seen[0].filename == __file__  # the line of the caller
    with pytest.warns(ps.RepairWarning, match=f"^faces: among {2 * len(TRIANGLES)} there are {len(TRIANGLES)} duplicate"):
        ps.segment(POINTS, np.concatenate([TRIANGLES, TRIANGLES]), 7)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ps.segment(POINTS, np.concatenate([TRIANGLES, TRIANGLES[:9]]), 7)
        ps.segment(*TETRAHEDRON)


def test_repairs_are_counted():
    points, triangles = icosahedron()
    turned = np.array(triangles)
    turned[:3] = turned[:3, ::-1]
    with_double = np.concatenate([turned, turned[4:5], [[0, 0, 1]]])
    repairs = ps.segmentation(points, with_double).repairs
    assert (repairs.reversed_faces, repairs.duplicate_faces, repairs.degenerate_faces) == (3, 1, 1)
    inside_out = ps.segmentation(points, triangles[:, ::-1]).repairs
    assert inside_out.inside_out_components == 1
