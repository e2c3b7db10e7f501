# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import protrusion_segmentation as ps
from meshes import TETRAHEDRON, arms, ball_with_arms, icosahedron

POINTS, TRIANGLES = ball_with_arms()
METHODS = ("minimum-cut", "paper")
DISTANCES = (None, "geodesic", "landmark", "diffusion", "heat", "exact")


def is_same_segmentation(labels, others):
    """Equal up to the names of the segments."""
    pairs = np.unique(np.stack([labels, others]), axis=1)
    return pairs.shape[1] == np.unique(labels).size == np.unique(others).size


def write_off(path, points, triangles):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        np.savetxt(file, points, fmt="%.17g")
        np.savetxt(file, np.insert(triangles, 0, 3, axis=1), fmt="%d")


@pytest.mark.parametrize(
    "method, distance", [("minimum-cut", distance) for distance in DISTANCES] + [("paper", None), ("paper", "geodesic")]
)
def test_every_arm_is_a_segment(method, distance):
    points, triangles = ball_with_arms(3) if distance == "exact" else (POINTS, TRIANGLES)
    labels = ps.segment(points, triangles, 7, method, distance)
    assert labels.shape == (len(triangles),)
    assert labels.dtype == np.int64
    known = arms(points, triangles)
    names = [np.unique(labels[known == arm]) for arm in range(6)]
    assert all(name.size == 1 for name in names)
    assert sorted(int(name[0]) for name in names) == [1, 2, 3, 4, 5, 6]
    assert np.bincount(labels[known == 6]).argmax() == 0


def test_no_number_is_as_many_as_found():
    known = arms(POINTS, TRIANGLES)
    labels = ps.segment(POINTS, TRIANGLES)
    longest = [np.unique(labels[known == arm]) for arm in range(4)]
    assert all(name.size == 1 for name in longest)
    assert len({int(name[0]) for name in longest}) == 4


@pytest.mark.parametrize(
    "faces",
    [
        TRIANGLES.tolist(),
        [tuple(face) for face in TRIANGLES],
        list(TRIANGLES),
        TRIANGLES.astype(np.uint32),
        TRIANGLES.astype(np.int16),
        np.asfortranarray(TRIANGLES),
        TRIANGLES.repeat(2, axis=0)[::2],
    ],
    ids=["lists", "tuples", "rows", "unsigned", "short", "Fortran", "strided"],
)
def test_faces_of_any_form(faces):
    assert (ps.segment(POINTS, faces) == ps.segment(POINTS, TRIANGLES)).all()


@pytest.mark.parametrize("type_of_coordinates", [np.float16, np.float32, np.longdouble, np.int8, np.int64, np.uint32, object])
def test_coordinates_of_any_type(type_of_coordinates):
    points, triangles = ball_with_arms(3)
    points = (100 + 3 * points).astype(type_of_coordinates)
    expected = ps.segment(points.astype(float), triangles, 7)
    assert (ps.segment(points, triangles, 7) == expected).all()
    assert (ps.segment(points.tolist(), triangles, 7) == expected).all()
    assert (ps.segment(np.asfortranarray(points), triangles, 7) == expected).all()


@pytest.mark.parametrize("type_of_corners", "bBhHiIlLqQ")
def test_corners_and_labels_of_any_integer_type(type_of_corners):
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    faces = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]], type_of_corners)
    assert (ps.segment(cube, faces, 1) == 0).all()
    assert (ps.segment(cube, faces.astype(faces.dtype.newbyteorder()), 1) == 0).all()
    labels = np.array([0, 1, 0, 1, 0, 1], type_of_corners)
    assert ps.rand_index_error(cube, faces, labels, labels[::-1]) == 0


def test_the_arguments_stay_as_they_are():
    points, triangles = POINTS.copy(), TRIANGLES.copy()
    points.flags.writeable = triangles.flags.writeable = False
    ps.segment(points, triangles)


def test_polygons_of_several_sizes():
    # Two triangles that are neighbours become a quadrangle.
    first = TRIANGLES[0]
    corners = [set(face) for face in TRIANGLES.tolist()]
    second = next(i for i in range(1, len(corners)) if len(corners[i] & set(first)) == 2)
    far = (corners[second] - set(first)).pop()
    lonely = next(i for i in range(3) if first[i] not in corners[second])
    quadrangle = [first[lonely], first[(lonely + 1) % 3], far, first[(lonely + 2) % 3]]
    polygons = [quadrangle] + [face for i, face in enumerate(TRIANGLES.tolist()) if i not in (0, second)]
    labels = ps.segment(POINTS, polygons, 7)
    assert labels.shape == (len(TRIANGLES) - 1,)
    assert labels.max() == 6


def test_an_array_of_quadrangles():
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    faces = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    assert (ps.segment(cube, faces, 1) == 0).all()


def test_quadrangles_that_look_like_another_layout():
    around_vertex_3 = [[3, 0, 4, 1], [3, 1, 5, 2], [3, 2, 6, 0]]
    collapsed = [[0, 1, 2, 2], [0, 2, 3, 3], [0, 3, 1, 1]]
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 2], [2, 1, 1], [1, 2, 1]], float)
    for faces in (around_vertex_3, collapsed):
        for values in (faces, np.array(faces)):
            assert (ps.segment(corners, values, 1) == 0).all()


def test_labels_follow_the_order_of_the_faces():
    order = np.random.default_rng(1).permutation(len(TRIANGLES))
    assert (ps.segment(POINTS, TRIANGLES[order], 7) == ps.segment(POINTS, TRIANGLES, 7)[order]).all()


def test_every_face_has_a_label_whatever_it_is_like():
    broken = np.concatenate([TRIANGLES[:1, [0, 0, 1]], TRIANGLES, TRIANGLES[:5], TRIANGLES[7:9, ::-1]])
    labels = ps.segment(POINTS, broken, 7)
    assert labels.shape == (len(broken),)
    assert is_same_segmentation(labels[1 : len(TRIANGLES) + 1], ps.segment(POINTS, TRIANGLES, 7))
    assert (labels[-7:-2] == labels[1:6]).all()
    assert (labels[-2:] == labels[8:10]).all()


def test_soup_without_common_vertices():
    soup = POINTS[TRIANGLES].reshape(-1, 3)
    labels = ps.segment(soup, np.arange(len(soup)).reshape(-1, 3), 7)
    assert (labels == ps.segment(POINTS, TRIANGLES, 7)).all()


@pytest.mark.filterwarnings("ignore::protrusion_segmentation.RepairWarning")
def test_corners_that_nearly_agree_are_one():
    soup = POINTS[TRIANGLES].reshape(-1, 3)
    faces = np.arange(len(soup)).reshape(-1, 3)
    labels = ps.segment(POINTS, TRIANGLES, 7)
    for distance, tolerance in ((1e-7, None), (1e-4, 1e-3)):
        shaken = soup + np.random.default_rng(0).uniform(-distance, distance, soup.shape)
        found = ps.segment(shaken, faces, 7, snapping_tolerance=tolerance)
        assert ps.evaluate(POINTS, TRIANGLES, found, labels).rand_index_error < .02
        assert len(ps.tips(shaken, faces, 6, snapping_tolerance=tolerance)) == 6
        tree = ps.hierarchy(shaken, faces, 7, snapping_tolerance=tolerance)
        assert tree.minimum_number_of_segments == 1
    assert np.unique(ps.segment(shaken[:300], faces[:100], 1, snapping_tolerance=0)).size == 100


def test_solids_that_touch_and_hollow_ones():
    points, triangles = TETRAHEDRON
    n = len(points)
    mirrored = points * [1, 1, -1]
    labels = ps.segment(np.concatenate([points, mirrored]), np.concatenate([triangles, triangles[:, ::-1] + n]))
    assert sorted(labels.tolist()) == [0] * 4 + [1] * 4
    inner = .2 + .2 * points
    hollow = np.concatenate([points, inner]), np.concatenate([triangles, triangles[:, ::-1] + n])
    assert (ps.segment(*hollow) == 0).all()


def test_pieces_are_joined():
    points, triangles = icosahedron()
    ball, arm = points, .3 * points + [2.2, 0, 0]
    pieces = [ball, arm, arm * [-1, 1, 1], .2 * points]
    vertices = np.concatenate(pieces)
    faces = np.concatenate([triangles + i * len(points) for i in range(len(pieces))])
    assert np.unique(ps.segment(vertices, faces)).size == 4
    for join in (True, .2):
        labels = ps.segment(vertices, faces, 3, join_pieces=join)
        n = len(triangles)
        assert [labels[i * n] for i in (0, 3)] == [0, 0]
        assert set(labels.tolist()) == {0, 1, 2}
        assert ps.hierarchy(vertices, faces, 3, join_pieces=join).minimum_number_of_segments == 1


def test_components_are_segments():
    points, triangles = TETRAHEDRON
    two = np.concatenate([points, points + 5]), np.concatenate([triangles, triangles + 4])
    labels = ps.segment(*two)
    assert sorted(labels.tolist()) == [0] * 4 + [1] * 4


def test_the_same_seed_gives_the_same_labels():
    results = [ps.segment(POINTS, TRIANGLES, 7, "paper", "landmark", seed) for seed in (3, 3)]
    assert (results[0] == results[1]).all()


@pytest.mark.parametrize("method", METHODS)
def test_hierarchy_has_all_segmentations(method):
    found = ps.hierarchy(POINTS, TRIANGLES, 7, method)
    assert (found.minimum_number_of_segments, found.maximum_number_of_segments) == (1, 7)
    assert found.parents[0] == 0
    finer = found.labels(7)
    assert (finer == ps.segment(POINTS, TRIANGLES, 7, method)).all()
    for number in range(6, 0, -1):
        labels = found.labels(number)
        assert sorted(set(labels.tolist())) == list(range(number))
        kept = finer < number
        assert (labels[kept] == finer[kept]).all()
        assert (labels[~kept] == found.parents[number]).all() or found.parents[number] >= number
        finer = labels


@pytest.mark.parametrize("number", [0, 8, -1])
def test_hierarchy_of_a_number_out_of_range(number):
    found = ps.hierarchy(POINTS, TRIANGLES, 7)
    with pytest.raises(ValueError, match=f"^number_of_segments is {number}, but the hierarchy has 1 to 7 segments$"):
        found.labels(number)


def test_tips_lie_on_arms_and_cut_them_off():
    known = arms(POINTS, TRIANGLES)
    tips = ps.tips(POINTS, TRIANGLES, 6)
    assert sorted(known[tips].tolist()) == [0, 1, 2, 3, 4, 5]
    some = tips[:2]
    labels = ps.segment_from_tips(POINTS, TRIANGLES, some)
    assert set(labels.tolist()) == {0, 1, 2}
    assert set(labels[some].tolist()) == {1, 2}
    assert (labels == ps.segment_from_tips(POINTS, TRIANGLES, some.tolist())).all()
    assert (ps.segment_from_tips(POINTS, TRIANGLES, []) == 0).all()


def test_tips_are_numbers_of_the_faces_given():
    broken = np.concatenate([TRIANGLES[:1, [0, 0, 1]], TRIANGLES])
    tips = ps.tips(POINTS, TRIANGLES, 6)
    assert (ps.tips(POINTS, broken, 6) == tips + 1).all()
    labels = ps.segment_from_tips(POINTS, broken, tips + 1)
    assert (labels[1:] == ps.segment_from_tips(POINTS, TRIANGLES, tips)).all()


def test_evaluate_by_hand():
    # Of the six pairs of faces, three are together in one segmentation only. Three of the faces have area 1/2.
    points, triangles = TETRAHEDRON
    slanted = 3**0.5 / 2
    metrics = ps.evaluate(points, triangles, [5, 5, 5, 5], [1, 1, 7, 1])
    assert metrics.rand_index_error == pytest.approx(3 / 6)
    assert metrics.missing_rate == pytest.approx(0)
    assert metrics.false_alarm_rate == pytest.approx(slanted / (1.5 + slanted))
    assert metrics.hamming_distance == pytest.approx(metrics.false_alarm_rate / 2)
    assert metrics.cut_discrepancy is None
    assert metrics.global_consistency_error == 0
    assert metrics.mean_best_intersection_over_union == pytest.approx((3 / 4 + 1 / 4) / 2)
    same = ps.evaluate(points, triangles, [0, 0, 1, 1], [9, 9, -3, -3])
    assert same.rand_index_error == 0
    assert same.cut_discrepancy == 0


def test_version():
    assert ps.__version__.count(".") == 2


@pytest.mark.skipif("PROTRUSION_SEGMENTATION_TOOLS" not in os.environ, reason="the tools were not built")
@pytest.mark.parametrize("shape", ["ball with arms", "octopus"])
@pytest.mark.parametrize(
    "options",
    [{}, {"number_of_segments": 5}]
    + [{"number_of_segments": 5, "method": "paper", "distance": distance} for distance in DISTANCES[1:-1]],
)
def test_labels_are_those_of_the_tool(tmp_path, shape, options):
    tools = Path(os.environ["PROTRUSION_SEGMENTATION_TOOLS"])
    mesh, segments = tmp_path / "mesh.off", tmp_path / "mesh.seg"
    if shape == "ball with arms":
        write_off(mesh, POINTS, TRIANGLES)
    else:
        subprocess.run([tools / "make_example_mesh", shape, mesh], check=True)
    flags = [f"--{name.replace('number_of_', '')}={value}" for name, value in options.items()]
    subprocess.run([tools / "segment_by_protrusions", mesh, "-o", segments, "--quiet", *flags], check=True)
    lines = [line for line in mesh.read_text().split("\n")[1:] if line and not line.startswith("#")]
    n, m = map(int, lines[0].split()[:2])
    points = np.loadtxt(lines[1 : n + 1])
    faces = np.loadtxt(lines[n + 1 : n + m + 1], dtype=int)[:, 1:4]
    assert (ps.segment(points, faces, **options) == np.loadtxt(segments, dtype=int)).all()


def test_hierarchies_are_compared_as_objects():
    found, other = ps.hierarchy(POINTS, TRIANGLES, 2), ps.hierarchy(POINTS, TRIANGLES, 2)
    assert found == found and found != other
    assert len({found, other}) == 2
