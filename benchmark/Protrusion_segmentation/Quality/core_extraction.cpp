// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core_extraction.h"

#include "Face_distance_graph.h"
#include "Segment_network.h"
#include "decimation.h"
#include "hierarchical_cuts.h"

#include <CGAL/centroid.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Core>
#include <Spectra/MatOp/DenseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

namespace {

using Distances = std::vector<std::vector<double>>; // between all faces

constexpr std::size_t core = 0; // its label

Distances all_distances(const Face_distance_graph& graph)
{
  Distances result;
  for (std::size_t f = 0; f < graph.number_of_faces(); ++f)
    result.push_back(graph.distances({f}));
  return result;
}

// Classical multidimensional scaling in space.
std::vector<Point> layout(const Distances& distances)
{
  const int n = int(distances.size());
  Eigen::MatrixXd squares(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      squares(i, j) = distances[std::size_t(i)][std::size_t(j)] *
                      distances[std::size_t(j)][std::size_t(i)];
  const Eigen::RowVectorXd means = squares.colwise().mean();
  const Eigen::MatrixXd products =
    -0.5 * (squares - means.replicate(n, 1) - means.transpose().replicate(1, n)).array() -
    0.5 * means.mean();
  Spectra::DenseSymMatProd<double> operation(products);
  Spectra::SymEigsSolver<Spectra::DenseSymMatProd<double>> solver(operation, 3, (std::min)(n, 20));
  solver.init();
  if (solver.compute(Spectra::SortRule::LargestAlge) < 3)
    throw std::runtime_error("the scaling does not converge");
  std::vector<Point> points;
  const Eigen::MatrixXd vectors = solver.eigenvectors();
  const Eigen::VectorXd lengths = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  for (int i = 0; i < n; ++i)
    points.emplace_back(vectors(i, 0) * lengths[0], vectors(i, 1) * lengths[1],
                        vectors(i, 2) * lengths[2]);
  return points;
}

std::vector<std::size_t> on_convex_hull(const std::vector<Point>& points)
{
  std::map<Point, std::size_t> number;
  for (std::size_t i = 0; i < points.size(); ++i)
    number.emplace(points[i], i);
  Mesh hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  std::vector<std::size_t> result;
  for (const Vertex v : hull.vertices())
    result.push_back(number.at(hull.point(v)));
  std::sort(result.begin(), result.end());
  return result;
}

// Turns the points inside out in the least sphere around their centre: what was in the middle is outermost.
std::vector<Point> mirrored(const std::vector<Point>& points)
{
  const Point centre = CGAL::centroid(points.begin(), points.end());
  double radius = 0;
  for (const Point& p : points)
    radius = (std::max)(radius, std::sqrt(CGAL::squared_distance(p, centre)));
  std::vector<Point> result;
  for (const Point& p : points)
  {
    const double distance = (std::max)(std::sqrt(CGAL::squared_distance(p, centre)), 1e-6 * radius);
    result.push_back(centre + (2 * radius - distance) / distance * (p - centre));
  }
  return result;
}

class Core_extractor
{
public:
  Core_extractor(const Mesh& mesh, const Core_extraction_options& options)
    : m_options(options),
      m_graph(mesh, [&](Halfedge h) { return centroid_distance(mesh, h); }),
      m_distances(all_distances(m_graph)),
      m_seams(all_seams(mesh, options.exponent)),
      m_areas(face_areas(mesh))
  {
    for (const std::vector<double>& from : m_distances)
      for (const double distance : from)
      {
        if (!std::isfinite(distance))
          throw std::runtime_error("the mesh is not connected");
        m_largest = (std::max)(m_largest, distance);
      }
  }

  Labels segments(std::size_t number_of_segments)
  {
    const std::vector<Point> points = layout(m_distances);
    choose_features(points);
    m_from_core.assign(m_areas.size(), std::numeric_limits<double>::infinity());
    for (const std::size_t f : on_convex_hull(mirrored(points)))
      for (std::size_t g = 0; g < m_areas.size(); ++g)
        m_from_core[g] = (std::min)(m_from_core[g], m_distances[f][g]);
    Labels labels = grown_core();
    merge_smallest(labels, number_of_segments);
    refine(labels);
    return labels;
  }

private:
  // The highest first, and none too near to a higher one.
  void choose_features(const std::vector<Point>& points)
  {
    std::vector<double> sums;
    for (const std::vector<double>& from : m_distances)
      sums.push_back(std::accumulate(from.begin(), from.end(), 0.));
    std::vector<bool> is_highest(sums.size(), true);
    for (const Seam& seam : m_seams)
      is_highest[sums[seam.a] < sums[seam.b] ? seam.a : seam.b] = false;
    std::vector<std::size_t> candidates = on_convex_hull(points);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
    for (const std::size_t f : candidates)
      if (is_highest[f] &&
          std::all_of(m_features.begin(), m_features.end(),
                      [&](std::size_t feature)
                      { return m_distances[f][feature] >= m_options.least_distance * m_largest; }))
        m_features.push_back(f);
  }

  // The pieces of the segment with this label, outside the core as grown by a distance, that have a feature point: numbered
  // from 1; all else is 0.
  Labels pieces_at(const Labels& labels, std::size_t label, double distance) const
  {
    const auto is_outside = [&](std::size_t f)
    { return labels[f] == label && m_from_core[f] > distance; };
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph(m_areas.size());
    for (const Seam& seam : m_seams)
      if (is_outside(seam.a) && is_outside(seam.b))
        add_edge(seam.a, seam.b, graph);
    std::vector<std::size_t> pieces(m_areas.size());
    connected_components(graph, pieces.data());
    std::map<std::size_t, std::size_t> number_of_piece;
    for (const std::size_t f : m_features)
      if (is_outside(f))
        number_of_piece.emplace(pieces[f], number_of_piece.size() + 1);
    Labels result(m_areas.size(), 0);
    for (std::size_t f = 0; f < result.size(); ++f)
      if (const auto found = number_of_piece.find(pieces[f]);
          found != number_of_piece.end() && is_outside(f))
        result[f] = found->second;
    return result;
  }

  // Parts the feature points of a segment by the least growth of the core that can. What the core takes keeps the label,
  // pieces get new ones, and are split in turn.
  void split(Labels& labels, std::size_t label, std::size_t first_step) const
  {
    for (std::size_t step = first_step; step <= m_options.steps; ++step)
    {
      const Labels pieces = pieces_at(
        labels, label, m_options.largest_growth * m_largest * double(step) / double(m_options.steps));
      const std::size_t number = *std::max_element(pieces.begin(), pieces.end());
      if (number < 2)
        continue;
      const std::size_t first_new = *std::max_element(labels.begin(), labels.end());
      for (std::size_t f = 0; f < labels.size(); ++f)
        if (pieces[f] > 0)
          labels[f] = first_new + pieces[f];
      for (std::size_t i = 1; i <= number; ++i)
        split(labels, first_new + i, step);
      return;
    }
  }

  Labels grown_core() const
  {
    Labels labels(m_areas.size(), core);
    split(labels, core, 0);
    return labels;
  }

  // The other segment that shares most of the border; the segment itself if there is no other.
  std::size_t neighbor(const Labels& labels, std::size_t label) const
  {
    std::map<std::size_t, double> lengths;
    for (const Seam& seam : m_seams)
      if (labels[seam.a] != labels[seam.b] && (labels[seam.a] == label || labels[seam.b] == label))
        lengths[labels[seam.a] == label ? labels[seam.b] : labels[seam.a]] += seam.length;
    const auto longest = std::max_element(
      lengths.begin(), lengths.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return longest == lengths.end() ? label : longest->first;
  }

  // The smallest goes to its neighbor, until there are no more than asked for.
  void merge_smallest(Labels& labels, std::size_t number_of_segments) const
  {
    std::map<std::size_t, double> areas;
    for (std::size_t f = 0; f < labels.size(); ++f)
      areas[labels[f]] += m_areas[f];
    while (areas.size() > (std::max)(number_of_segments, std::size_t(1)))
    {
      const auto smallest = std::min_element(
        areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
      const std::size_t old_label = smallest->first, new_label = neighbor(labels, old_label);
      areas[new_label] += smallest->second;
      areas.erase(old_label);
      std::replace(labels.begin(), labels.end(), old_label, new_label);
    }
  }

  void refine(Labels& labels) const
  {
    const std::size_t number = *std::max_element(labels.begin(), labels.end());
    for (std::size_t label = 0; label <= number; ++label)
      if (label != core && std::count(labels.begin(), labels.end(), label) > 0)
        refine_border(labels, label);
  }

  // By a minimum cut among the faces of the segment and of its neighbor that are near to their border.
  void refine_border(Labels& labels, std::size_t label) const
  {
    const std::size_t other = neighbor(labels, label);
    const auto is_either = [&](std::size_t f) { return labels[f] == label || labels[f] == other; };
    std::vector<std::size_t> at_border;
    std::vector<Segment_network::Link> links;
    for (const Seam& seam : m_seams)
      if (is_either(seam.a) && is_either(seam.b))
      {
        links.push_back({seam.a, seam.b, seam.cost});
        if (labels[seam.a] != labels[seam.b])
          at_border.insert(at_border.end(), {seam.a, seam.b});
      }
    if (at_border.empty())
      return;
    const std::vector<double> distances = m_graph.distances(at_border);
    double depth = 0;
    for (std::size_t f = 0; f < labels.size(); ++f)
      depth = labels[f] == label ? (std::max)(depth, distances[f]) : depth;
    std::vector<std::size_t> inside, outside;
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (distances[f] > m_options.band * depth && is_either(f))
        (labels[f] == label ? inside : outside).push_back(f);
    if (inside.empty() || outside.empty())
      return;
    const std::vector<bool> side = Segment_network(labels.size(), links).side_of(inside, outside);
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (is_either(f))
        labels[f] = side[f] ? label : other;
  }

  const Core_extraction_options& m_options;
  Face_distance_graph m_graph;
  Distances m_distances;
  std::vector<Seam> m_seams;
  std::vector<double> m_areas;
  double m_largest = 0; // distance
  std::vector<std::size_t> m_features;
  std::vector<double> m_from_core; // distances
};

} // namespace

Labels core_extraction_segmentation(const Mesh& mesh,
                                    std::size_t number_of_segments,
                                    const Core_extraction_options& options)
{
  const Mesh small = decimated(mesh, options.faces);
  return labels_from_decimated(mesh, small, Core_extractor(small, options).segments(number_of_segments));
}
