// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Face_distance_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

Face_distance_graph::Face_distance_graph(const Mesh& mesh, const std::function<double(Halfedge)>& length)
{
  std::vector<std::pair<std::size_t, std::size_t>> arcs;
  std::vector<double> lengths;
  for (const Halfedge h : mesh.halfedges())
    if (!mesh.is_border(edge(h, mesh)))
    {
      arcs.emplace_back(mesh.face(h), mesh.face(mesh.opposite(h)));
      lengths.push_back(length(h));
    }
  m_graph = Graph(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(), lengths.begin(),
                  mesh.number_of_faces());
}

// A queue of its own, as Boost's search neither stops at the rim of a segment nor starts from many
// sources with a say in who owns a face.
std::vector<double> Face_distance_graph::search(const std::vector<std::size_t>& sources,
                                                const std::function<bool(std::size_t)>& may_enter,
                                                const Settled& settled) const
{
  const auto lengths = get(boost::edge_weight, m_graph);
  std::vector<double> result(number_of_faces(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> reached_from(number_of_faces());
  std::priority_queue<Weighted_face, std::vector<Weighted_face>, std::greater<Weighted_face>> queue;
  for (const std::size_t source : sources)
  {
    result[source] = 0;
    reached_from[source] = source;
    queue.emplace(0., source);
  }
  while (!queue.empty())
  {
    const auto [distance, f] = queue.top();
    queue.pop();
    if (distance > result[f])
      continue;
    settled(f, reached_from[f]);
    for (const auto arc : boost::make_iterator_range(out_edges(f, m_graph)))
    {
      const std::size_t neighbor = target(arc, m_graph);
      const double through_f = distance + get(lengths, arc);
      if (through_f < result[neighbor] && may_enter(neighbor))
      {
        result[neighbor] = through_f;
        reached_from[neighbor] = f;
        queue.emplace(through_f, neighbor);
      }
    }
  }
  return result;
}

std::vector<double> Face_distance_graph::distances(const std::vector<std::size_t>& sources) const
{
  const auto may_enter = [](std::size_t) { return true; };
  return search(sources, may_enter, [](std::size_t, std::size_t) {});
}

std::vector<double> Face_distance_graph::distances_within(const Labels& labels, std::size_t source) const
{
  const auto may_enter = [&](std::size_t f) { return labels[f] == labels[source]; };
  return search({source}, may_enter, [](std::size_t, std::size_t) {});
}

Labels Face_distance_graph::nearest(const std::vector<std::size_t>& seeds) const
{
  Labels labels(number_of_faces(), 0);
  for (std::size_t i = 0; i < seeds.size(); ++i)
    labels[seeds[i]] = i;
  const auto may_enter = [](std::size_t) { return true; };
  search(seeds, may_enter, [&](std::size_t f, std::size_t from) { labels[f] = labels[from]; });
  return labels;
}

std::vector<std::size_t> Face_distance_graph::farthest_points(std::size_t first, std::size_t number) const
{
  std::vector<std::size_t> points = {first};
  std::vector<double> nearest = distances(points);
  while (points.size() < number)
  {
    points.push_back(std::size_t(std::max_element(nearest.begin(), nearest.end()) - nearest.begin()));
    const std::vector<double> from_new = distances({points.back()});
    for (std::size_t f = 0; f < nearest.size(); ++f)
      nearest[f] = (std::min)(nearest[f], from_new[f]);
  }
  return points;
}

Point face_centroid(const Mesh& mesh, Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                        mesh.point(mesh.target(mesh.next(h))));
}

double centroid_distance(const Mesh& mesh, Halfedge h)
{
  return std::sqrt(CGAL::squared_distance(face_centroid(mesh, mesh.face(h)),
                                          face_centroid(mesh, mesh.face(mesh.opposite(h)))));
}
