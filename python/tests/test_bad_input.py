# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever does not make sense raises ValueError, which names the argument."""

import numpy as np
import pytest

import protrusion_segmentation as ps
from meshes import TETRAHEDRON, ball_with_arms

POINTS, TRIANGLES = TETRAHEDRON


def with_value(array, place, value):
    result = np.array(array)
    result[place] = value
    return result


FINITE = "^vertices: vertex 2 has a coordinate that is not finite$"
VERTICES = [
    (with_value(POINTS, (2, 1), np.nan), FINITE),
    (with_value(POINTS, (2, 0), np.inf), FINITE),
    (with_value(POINTS, (2, 2), -np.inf), FINITE),
    (POINTS[:, :2], r"^vertices: the shape is \(4, 2\), not \(n, 3\)$"),
    (np.vstack([POINTS, POINTS]).T, r"^vertices: the shape is \(3, 8\), not \(n, 3\); vertices.T has it$"),
    (np.ma.masked_greater(POINTS, 0.5), "^vertices: a masked array; use vertices.compressed\\(\\)"),
    (POINTS + 1j, "^vertices: coordinates are no real numbers, but of type complex128$"),
    (POINTS > 0.5, "^vertices: coordinates are no real numbers, but of type bool$"),
    (POINTS.astype(str), "^vertices: coordinates are no real numbers, but of type <U"),
    (POINTS.reshape(-1), r"^vertices: the shape is \(12,\), not \(n, 3\)$"),
    (POINTS[None], "^vertices: the shape"),
    (1.5, "^vertices: the shape"),
    (None, "^vertices: the shape"),
    ([[0, 0, 0], [1, 0]], "^vertices: "),
    ([["a", "b", "c"]], "^vertices: "),
    (object(), "^vertices: "),
    ([], "^vertices: the shape"),
    (np.empty((0, 3)), "^faces: face 0 has the corner 0, but there are 0 vertices$"),
]
FACES = [
    (with_value(TRIANGLES, (1, 2), 4), "^faces: face 1 has the corner 4, but there are 4 vertices$"),
    (with_value(TRIANGLES, (1, 2), -1), "^faces: face 1 has the corner -1, but there are 4 vertices$"),
    ([[0, 1, 2], [0, 1, 2, 9]], "^faces: face 1 has the corner 9, but there are 4 vertices$"),
    (with_value(TRIANGLES.astype(np.uint64), (0, 0), 2**64 - 1), "^faces: 18446744073709551615 is too large$"),
    (with_value(TRIANGLES.astype(np.uint64), (0, 0), 2**63 + 5), "^faces: 9223372036854775813 is too large$"),
    ([[0, 1, 2**70]], "^faces: not all of them are integers$"),
    (TRIANGLES * 1.0, "^faces: not all of them are integers$"),
    (TRIANGLES > 1, "^faces: not all of them are integers$"),
    ([["a", "b", "c"]], "^faces: not all of them are integers$"),
    ([[0, 1, None]], "^faces: not all of them are integers$"),
    ([[[0, 1, 2]]], "^faces: the shape"),
    (["012"], "^faces: not all of them are integers$"),
    (np.ma.masked_greater(TRIANGLES, 2), "^faces: a masked array"),
    (TRIANGLES.reshape(-1), r"^faces: the shape is \(12,\), not \(m, 3\)$"),
    (TRIANGLES.reshape(-1).tolist(), "^faces: neither an array"),
    (np.insert(TRIANGLES, 0, 3, axis=1), r"^faces: in VTK's layout, .* faces.reshape\(-1, 4\)\[:, 1:\] are the corners$"),
    (np.insert(TRIANGLES, 0, 3, axis=1).reshape(-1), "^faces: in VTK's layout"),
    (np.insert(TRIANGLES, 0, 3, axis=1).tolist(), "^faces: in VTK's layout"),
    (TRIANGLES.T, r"^faces: the shape is \(3, 4\), not \(m, 3\); faces.T has it$"),
    (7, "^faces: neither an array"),
    (None, "^faces: neither an array"),
    ([], "^faces: there are none$"),
    (np.empty((0, 3), int), "^faces: there are none$"),
    ([[]], "^faces: the mesh has degenerate faces only"),
    ([[0], [1, 2]], "^faces: the mesh has degenerate faces only"),
    ([[0, 0, 1]], "^faces: the mesh has degenerate faces only"),
    (np.empty((5, 0), int), "^faces: the mesh has degenerate faces only"),
]


FUNCTIONS = {
    "segment": ps.segment,
    "segment_from_tips": lambda vertices, faces: ps.segment_from_tips(vertices, faces, [0]),
    "hierarchy": lambda vertices, faces: ps.hierarchy(vertices, faces, 1),
    "tips": lambda vertices, faces: ps.tips(vertices, faces, 1),
    "evaluate": lambda vertices, faces: ps.evaluate(vertices, faces, [0], [0]),
}


@pytest.mark.parametrize("call", FUNCTIONS.values(), ids=FUNCTIONS.keys())
def test_wrong_mesh(call):
    for vertices, words in VERTICES:
        with pytest.raises(ValueError, match=words):
            call(vertices, TRIANGLES)
    for faces, words in FACES:
        with pytest.raises(ValueError, match=words):
            call(POINTS, faces)


CALLS = [
    (lambda: ps.segment(POINTS, TRIANGLES, 0), "^number_of_segments is 0, but it must be from 1 to 4, the number of faces of the mesh$"),
    (lambda: ps.segment(POINTS, TRIANGLES, -2), "^number_of_segments is -2, but it must be from 1 to 4,"),
    (lambda: ps.segment(POINTS, TRIANGLES, 5), "^number_of_segments is 5, but it must be from 1 to 4,"),
    (lambda: ps.segment(POINTS, TRIANGLES, 2**80), f"^number_of_segments is {2**80}, which does not fit into 64 bits$"),
    (lambda: ps.segment(POINTS, TRIANGLES, 2.5), "^number_of_segments is no integer, but 2.5$"),
    (lambda: ps.segment(POINTS, TRIANGLES, True), "^number_of_segments is no integer, but True$"),
    (lambda: ps.segment(POINTS, TRIANGLES, "3"), "^number_of_segments is no integer, but '3'$"),
    (lambda: ps.segment(POINTS, TRIANGLES, method="x"), "^method is 'x', but it must be minimum-cut or paper$"),
    (lambda: ps.segment(POINTS, TRIANGLES, distance="far"), "^distance is 'far', but it must be geodesic, landmark"),
    (lambda: ps.segment(POINTS, TRIANGLES, method=None), "^method is None, but it must be minimum-cut or paper$"),
    (lambda: ps.segment(POINTS, TRIANGLES, distance=1), "^distance is 1, but it must be geodesic, landmark"),
    (lambda: ps.tips(POINTS, TRIANGLES, 2, None), "^distance is None, but it must be"),
    (lambda: ps.segment(POINTS, TRIANGLES, random_seed=-1), "^random_seed is -1, but it must be from 0 to 4294967295$"),
    (lambda: ps.segment(POINTS, TRIANGLES, snapping_tolerance=-1.0), "^snapping_tolerance is -1.0, but it must be a distance"),
    (lambda: ps.segment(POINTS, TRIANGLES, join_pieces=-1.0), "^join_pieces is -1.0, but a gap must be a distance above 0$"),
    (lambda: ps.segment(POINTS, TRIANGLES, join_pieces=100), "^gap: 100.0* is not between 0 and the size"),
    (lambda: ps.segment(POINTS, TRIANGLES, join_pieces="x"), "^join_pieces is neither true nor false nor a number, but 'x'$"),
    (lambda: ps.tips(POINTS, TRIANGLES, 3, snapping_tolerance="x"), "^snapping_tolerance is no number, but 'x'$"),
    (lambda: ps.segment(POINTS, TRIANGLES, random_seed=2**32), "^random_seed is 4294967296, but it must be from 0 to 4294967295$"),
    (lambda: ps.hierarchy(POINTS, TRIANGLES, 0), "^maximum_number_of_segments is 0, but it must be from 1 to 4, the number of faces of the mesh$"),
    (lambda: ps.hierarchy(POINTS, TRIANGLES, -1), "^maximum_number_of_segments is -1, but it must be from 1 to 4,"),
    (lambda: ps.tips(POINTS, TRIANGLES, 5), "^number_of_tips is 5, but it must be from 0 to 4, the number of faces of the mesh$"),
    (lambda: ps.tips(POINTS, TRIANGLES, -5), "^number_of_tips is -5, but it must be from 0 to 4,"),
    (lambda: ps.segment_from_tips(POINTS, TRIANGLES, [4]), "^tips: there is no face 4$"),
    (lambda: ps.segment_from_tips(POINTS, TRIANGLES, [-1]), "^tips: there is no face -1$"),
    (lambda: ps.segment_from_tips(POINTS, TRIANGLES, 3), "^tips: the shape"),
    (lambda: ps.segment_from_tips(POINTS, TRIANGLES, [0.5]), "^tips: not all of them are integers$"),
    (lambda: ps.evaluate(POINTS, TRIANGLES, [0, 1, 2], [0] * 4), "^labels: there are 3, but the mesh has 4 faces$"),
    (lambda: ps.evaluate(POINTS, TRIANGLES, [0] * 4, [0] * 5), "^reference: there are 5, but the mesh has 4 faces$"),
    (lambda: ps.evaluate(POINTS, TRIANGLES, np.ma.masked_equal([0] * 4, 1), [0] * 4), "^labels: a masked array"),
    (lambda: ps.LandmarkDistance(0), "^share is 0, but it must be above 0 and at most 1$"),
    (lambda: ps.LandmarkDistance("x"), "^share is no number, but 'x'$"),
    (lambda: ps.LandmarkDistance(number=0), "^number is 0, but it must be at least 1$"),
    (lambda: ps.DiffusionDistance(301), "^terms is 301, but it must be from 1 to 300$"),
    (lambda: ps.DiffusionDistance(time=-1), "^time is -1, but it must be at least 0$"),
    (lambda: ps.PaperMethod(0), "^minimum_prominence is 0, but it must be above 0$"),
    (lambda: ps.segment(POINTS, TRIANGLES, threads=0), "^threads is 0, but it must be from 1 to 1024$"),
    (lambda: ps.segment(POINTS, TRIANGLES, progress=3), "^progress is no function, but 3$"),
    (lambda: ps.evaluate(POINTS, TRIANGLES, [0.0] * 4, [0] * 4), "^labels: not all of them are integers$"),
]


@pytest.mark.parametrize("call, words", CALLS, ids=[words for _, words in CALLS])
def test_wrong_argument(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_coordinates_of_unused_vertices_do_not_matter():
    points = np.vstack([POINTS, [[np.nan, np.inf, 0]]])
    for call in FUNCTIONS.values():
        if call is not FUNCTIONS["evaluate"]:
            call(points, TRIANGLES)


SURFACES = {
    "an edge of three faces": [[0, 1, 2], [1, 0, 3], [0, 1, 4]],
    "faces that look the other way": [[0, 2, 1], [0, 3, 1], [1, 2, 3], [2, 0, 3]],
    "a vertex of two fans": [[0, 1, 2], [0, 3, 4]],
    "a face twice": [[0, 1, 2], [0, 1, 2], [2, 1, 0]],
    "a polygon that comes back": [[0, 1, 2, 1], [0, 2, 3]],
    "one triangle": [[0, 1, 2]],
}


@pytest.mark.parametrize("faces", SURFACES.values(), ids=SURFACES.keys())
def test_awkward_surfaces_are_segmented(faces):
    points = np.random.default_rng(5).random((5, 3))
    for method in ("minimum-cut", "paper"):
        labels = ps.segment(points, faces, method=method)
        assert labels.shape == (len(faces),)
        assert labels.min() == 0


@pytest.mark.filterwarnings("ignore::protrusion_segmentation.RepairWarning")
@pytest.mark.parametrize("seed", range(20))
def test_random_soups_give_labels_or_value_errors(seed):
    random = np.random.default_rng(seed)
    points = random.integers(-1, 2, (random.integers(1, 12), 3)) * 10.0 ** random.integers(-300, 300)
    faces = [random.integers(0, len(points), random.integers(0, 6)) for _ in range(random.integers(0, 30))]
    try:
        labels = ps.segment(points, faces, method=("minimum-cut", "paper")[seed % 2])
    except ValueError:
        return
    assert labels.shape == (len(faces),)
    assert sorted(set(labels.tolist())) == list(range(labels.max() + 1))


def test_huge_and_tiny_coordinates():
    points, triangles = ball_with_arms(3)
    expected = ps.segment(points, triangles, 7)
    for exponent in (-1000, 1000):
        assert (ps.segment(np.ldexp(points, exponent), triangles, 7) == expected).all()
