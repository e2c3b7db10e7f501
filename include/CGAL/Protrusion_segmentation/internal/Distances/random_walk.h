// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_RANDOM_WALK_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_RANDOM_WALK_H

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Edge_conductances.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The random walk on the faces of Section III.B.1, with transition matrix P = D^-1 W.
struct Random_walk
{
  Eigen::VectorXd degrees;               // the diagonal of D
  Eigen::SparseMatrix<double> laplacian; // I - D^-1/2 W D^-1/2: similar to I - P, but symmetric
};

// The weight of staying, for a face of mean area. The weights of leaving add up to about 5 for a regular
// triangle, whatever its size, so that this makes the walk rest nearly in proportion to the areas.
constexpr double resting_weight = 50;

// The weights W. A face is left over an edge with the weight of its conductance. To stay has a weight proportional to
// the area, so that small faces are left sooner and the walk spreads over the surface alike wherever its faces are
// small or large, as heat does; a face without area is left at once.
inline Random_walk make_random_walk(const Indexed_surface& surface)
{
  using Index = Indexed_surface::Index;
  const Index n = surface.number_of_faces();
  const double mean_area = surface.area() / n;
  const Edge_conductances conductance(surface);

  std::vector<Eigen::Triplet<double>> weights;
  weights.reserve(surface.number_of_corners() + n);
  Eigen::VectorXd leaving = Eigen::VectorXd::Zero(n);
  for (Index f = 0; f < n; ++f)
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face())
      {
        const double weight = conductance(f, c);
        weights.emplace_back(f, g, -weight);
        leaving[f] += weight;
      }
  Random_walk walk;
  walk.degrees.resize(n);
  for (Index f = 0; f < n; ++f)
    walk.degrees[f] = leaving[f] + resting_weight * (mean_area > 0 ? surface.area(f) / mean_area : 1);
  for (Index f = 0; f < n; ++f)
    weights.emplace_back(f, f, leaving[f]);
  for (auto& w : weights)
    w = {w.row(), w.col(), w.value() / std::sqrt(walk.degrees[w.row()] * walk.degrees[w.col()])};
  walk.laplacian.resize(n, n);
  walk.laplacian.setFromTriplets(weights.begin(), weights.end()); // adds up edges between the same faces
  return walk;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_RANDOM_WALK_H
