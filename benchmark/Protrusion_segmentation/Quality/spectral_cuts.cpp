// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "spectral_cuts.h"

#include "decimation.h"
#include "hierarchical_cuts.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace {

using Matrix = Eigen::SparseMatrix<double>;

// The graph's Laplacian, divided on both sides by the roots of the areas.
Matrix normalized_laplacian(const Segment_faces& segment)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (const Seam& seam : segment.seams)
  {
    const double areas[] = {segment.areas[seam.a], segment.areas[seam.b]};
    const int a = int(seam.a), b = int(seam.b);
    entries.emplace_back(a, a, seam.cost / areas[0]);
    entries.emplace_back(b, b, seam.cost / areas[1]);
    for (const auto& [row, column] : {std::make_pair(a, b), std::make_pair(b, a)})
      entries.emplace_back(row, column, -seam.cost / std::sqrt(areas[0] * areas[1]));
  }
  Matrix matrix(int(segment.faces.size()), int(segment.faces.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// The eigenvector of the second least eigenvalue; empty if the iteration fails.
std::vector<double> fiedler_vector(const Segment_faces& segment)
{
  const Matrix matrix = normalized_laplacian(segment);
  // Zero is an eigenvalue: the shift is below it, by little for a matrix of this size.
  const double shift = -1e-6 * matrix.diagonal().mean();
  const int wanted = 2, space = (std::min)(20, int(segment.faces.size()));
  Spectra::SparseSymShiftSolve<double> operation(matrix);
  Spectra::SymEigsShiftSolver<Spectra::SparseSymShiftSolve<double>> solver(operation, wanted, space,
                                                                           shift);
  solver.init();
  if (solver.compute() < wanted)
    return {};
  // Their inverses are sorted from large to small, the constant vector's first.
  const Eigen::VectorXd vector = solver.eigenvectors().col(1);
  std::vector<double> result(segment.faces.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = vector[int(i)] / std::sqrt(segment.areas[i]);
  return result;
}

// The faces that come first in an order, as many as make the normalized cut least.
std::vector<bool> best_beginning(const Segment_faces& segment, const std::vector<double>& values)
{
  std::vector<std::size_t> order(values.size()), rank(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  for (std::size_t i = 0; i < order.size(); ++i)
    rank[order[i]] = i;
  std::vector<double> changes(values.size(), 0.); // of the cost, when a face is taken in
  for (const Seam& seam : segment.seams)
  {
    changes[(std::min)(rank[seam.a], rank[seam.b])] += seam.cost;
    changes[(std::max)(rank[seam.a], rank[seam.b])] -= seam.cost;
  }
  double cost = 0, area = 0, least = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
  {
    cost += changes[i];
    area += segment.areas[order[i]];
    const double normalized = cost / area + cost / (segment.area - area);
    if (normalized < least)
    {
      least = normalized;
      best = i;
    }
  }
  std::vector<bool> side(values.size());
  for (std::size_t i = 0; i < side.size(); ++i)
    side[i] = rank[i] <= best;
  return side;
}

// Pieces of a side that are apart from its largest one change over.
void make_connected(const Segment_faces& segment, std::vector<bool>& side, bool which)
{
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph(side.size());
  for (const Seam& seam : segment.seams)
    if (side[seam.a] == side[seam.b])
      add_edge(seam.a, seam.b, graph);
  std::vector<std::size_t> pieces(side.size());
  std::vector<double> areas(connected_components(graph, pieces.data()), 0.);
  for (std::size_t i = 0; i < side.size(); ++i)
    areas[pieces[i]] += side[i] == which ? segment.areas[i] : 0;
  const std::size_t largest = std::size_t(std::max_element(areas.begin(), areas.end()) - areas.begin());
  for (std::size_t i = 0; i < side.size(); ++i)
    if (side[i] == which && pieces[i] != largest)
      side[i] = !which;
}

Split spectral_split(const Segment_faces& segment)
{
  const std::vector<double> values = fiedler_vector(segment);
  if (values.empty())
    return {};
  std::vector<bool> side = best_beginning(segment, values);
  make_connected(segment, side, true);
  make_connected(segment, side, false);
  Split split;
  for (std::size_t i = 0; i < side.size(); ++i)
    if (side[i])
      split.faces.push_back(segment.faces[i]);
  split.value = -normalized_cost(segment, side);
  return split;
}

} // namespace

Labels spectral_cuts_segmentation(const Mesh& mesh,
                                  std::size_t number_of_segments,
                                  const Spectral_cuts_options& options)
{
  const Mesh small = decimated(mesh, options.faces);
  const std::vector<Seam> seams = all_seams(small, options.exponent);
  std::vector<double> areas = face_areas(small);
  const double mean_area = std::accumulate(areas.begin(), areas.end(), 0.) / double(areas.size());
  for (double& area : areas)
    area = (std::max)(area, 1e-6 * mean_area); // what is divided by
  const auto split_of = [&](const Labels& labels, std::size_t label)
  {
    const Segment_faces segment(seams, areas, labels, label);
    return segment.faces.size() < options.least_faces ? Split() : spectral_split(segment);
  };
  return labels_from_decimated(mesh, small, split_best_first(small, number_of_segments, split_of));
}
