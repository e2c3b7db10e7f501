# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of methods and distances, distances of one's own, threads, progress."""

import heapq
import threading

import numpy as np
import pytest

import protrusion_segmentation as ps
from meshes import arms, ball_with_arms

POINTS, TRIANGLES = ball_with_arms(3)


def is_every_arm_a_segment(labels):
    known = arms(POINTS, TRIANGLES)
    names = [np.unique(labels[known == arm]) for arm in range(6)]
    return all(name.size == 1 for name in names) and sorted(int(n[0]) for n in names) == [1, 2, 3, 4, 5, 6]


def shortest_paths(graph):
    """The geodesic distance of the package."""

    def from_face(face):
        distances = np.full(graph.areas.size, np.inf)
        distances[face] = 0
        queue = [(0.0, face)]
        while queue:
            distance, nearest = heapq.heappop(queue)
            if distance > distances[nearest]:
                continue
            for arc in range(graph.first_arcs[nearest], graph.first_arcs[nearest + 1]):
                further = distance + graph.lengths[arc]
                if further < distances[graph.neighbors[arc]]:
                    distances[graph.neighbors[arc]] = further
                    heapq.heappush(queue, (further, int(graph.neighbors[arc])))
        return distances

    return from_face


shortest_paths.is_metric = True


@pytest.mark.parametrize("distance", [
    *(ps.LandmarkDistance(share) for share in (0.01, 0.05, 0.1)),
    ps.LandmarkDistance(number=20),
    *(ps.DiffusionDistance(terms) for terms in (5, 10)),
    ps.DiffusionDistance(time=0.2),
])
def test_the_distances_of_the_paper(distance):
    labels = ps.segment(POINTS, TRIANGLES, 7, "paper", distance)
    assert labels.max() == 6
    if distance == ps.LandmarkDistance():
        assert (labels == ps.segment(POINTS, TRIANGLES, 7, "paper", "landmark")).all()
    if distance == ps.DiffusionDistance():
        assert (labels == ps.segment(POINTS, TRIANGLES, 7, "paper", "diffusion")).all()


def test_options_of_distances_matter():
    tips = [ps.tips(POINTS, TRIANGLES, 9, distance).tolist() for distance in (
        ps.LandmarkDistance(0.01), ps.LandmarkDistance(1), ps.DiffusionDistance(2), ps.DiffusionDistance(20),
        ps.DiffusionDistance(20, 3))]
    assert len({tuple(some) for some in tips}) == len(tips)


def test_prominence():
    few = ps.segmentation(POINTS, TRIANGLES, method=ps.PaperMethod(5.0))
    many = ps.segmentation(POINTS, TRIANGLES, method=ps.PaperMethod(minimum_prominence=0.2))
    plain = ps.segmentation(POINTS, TRIANGLES, method="paper")
    assert few.number_of_segments < plain.number_of_segments <= many.number_of_segments
    assert plain.values[1:].min() >= 0.4
    everywhere = ps.PaperMethod(uses_candidate_intervals=False)
    assert ps.segment(POINTS, TRIANGLES, 7, everywhere).max() == 6


@pytest.mark.parametrize("method", ["minimum-cut", "paper"])
def test_a_distance_of_ones_own(method):
    labels = ps.segment(POINTS, TRIANGLES, 7, method, shortest_paths)
    assert (labels == ps.segment(POINTS, TRIANGLES, 7, method, "geodesic")).all()
    assert (ps.tips(POINTS, TRIANGLES, 6, shortest_paths) == ps.tips(POINTS, TRIANGLES, 6)).all()


def test_the_graph_of_a_distance():
    graphs = []

    def straight(graph):
        graphs.append(graph)
        return lambda face: np.linalg.norm(graph.centroids - graph.centroids[face], axis=1)

    labels = ps.segment(POINTS, TRIANGLES, 7, distance=straight)
    assert is_every_arm_a_segment(labels)
    whole = max(graphs, key=lambda graph: graph.areas.size)
    n = len(TRIANGLES)
    assert whole.centroids.shape == (n, 3) and whole.areas.shape == (n,)
    assert (np.diff(whole.first_arcs) == 3).all()
    sources = np.repeat(np.arange(n), 3)
    lengths = np.linalg.norm(whole.centroids[sources] - whole.centroids[whole.neighbors], axis=1)
    assert whole.lengths == pytest.approx(lengths)
    assert np.abs(whole.centroids).max() <= 1


def gives(value):
    return lambda graph: lambda face: value(graph, face)


WRONG_DISTANCES = [
    (lambda graph: 3, "^distance: what it gives for a graph is no function, but 3$"),
    (gives(lambda graph, face: np.zeros(3)), r"^distance: what it gives for a face has the shape \(3,\), not \(1280,\)$"),
    (gives(lambda graph, face: "far"), "^distance: what it gives for a face is no array of numbers$"),
    (gives(lambda graph, face: graph.areas * np.nan), "^the distance from face .* is -?nan$"),
    (gives(lambda graph, face: graph.areas - 9), "^the distance from face 0 to face 0 is -"),
    (gives(lambda graph, face: graph.areas + 1), "^the distance from face 0 to itself is 1"),
]


@pytest.mark.parametrize("distance, words", WRONG_DISTANCES, ids=[words for _, words in WRONG_DISTANCES])
def test_wrong_distances(distance, words):
    with pytest.raises(ValueError, match=words):
        ps.segment(POINTS, TRIANGLES, 7, "paper", distance)


def test_exceptions_of_a_distance_come_back():
    def failing(graph):
        raise KeyError("mine")

    for call in (lambda: ps.segment(POINTS, TRIANGLES, 7, distance=failing), lambda: ps.tips(POINTS, TRIANGLES, 7, failing)):
        with pytest.raises(KeyError, match="mine"):
            call()


@pytest.mark.parametrize("method", ["minimum-cut", "paper", ps.PaperMethod()])
def test_threads_do_not_matter(method):
    for distance in (None, "landmark", shortest_paths):
        one, four = (ps.segmentation(POINTS, TRIANGLES, 7, method, distance, threads=n) for n in (1, 4))
        assert (one.labels == four.labels).all()
        assert np.array_equal(one.values, four.values, equal_nan=True)
    assert (ps.tips(POINTS, TRIANGLES, 9, "landmark", threads=3) == ps.tips(POINTS, TRIANGLES, 9, "landmark")).all()


def test_progress_is_told():
    shares = []
    labels = ps.segment(POINTS, TRIANGLES, 7, progress=shares.append)
    assert (labels == ps.segment(POINTS, TRIANGLES, 7)).all()
    assert shares == sorted(shares)
    assert 0 <= shares[0] and shares[-1] == 1
    in_thread = []
    thread = threading.Thread(target=ps.hierarchy, args=(POINTS, TRIANGLES, 7), kwargs={"progress": in_thread.append})
    thread.start()
    thread.join()
    assert in_thread[-1] == 1


def test_progress_stops():
    for call in (ps.segmentation, ps.segment, ps.hierarchy, ps.tips):
        with pytest.raises(ps.SegmentationStopped):
            call(POINTS, TRIANGLES, 7, progress=lambda share: False)
    with pytest.raises(ZeroDivisionError):
        ps.segment(POINTS, TRIANGLES, 7, progress=lambda share: 1 / 0)
    assert ps.segment(POINTS, TRIANGLES, 7, progress=lambda share: share < 2).max() == 6
