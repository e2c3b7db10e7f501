// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SMOOTH_NORMALS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SMOOTH_NORMALS_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Diffuses values on the faces: solves (M + time * L) x = M x_0, where M holds the areas and L is the
// finite-volume Laplacian of the face dual graph, by conjugate gradients with a diagonal preconditioner.
// On a mesh of N faces that needs about sqrt(time * N / area) iterations, each linear.
class Diffusion
{
public:
  using Index = Surface_part::Index;
  using Values = std::vector<double>;

  Diffusion(const Surface_part& part, double time) : m_part(part), m_diagonal(part.number_of_faces())
  {
    // slivers: centroids that nearly coincide would make a huge weight and a slow solver
    const double mean_edge = std::sqrt(part.area() / (std::max)(part.number_of_faces(), Index(1)));
    const double shortest = 0.01 * mean_edge;
    m_weights.assign(part.number_of_corners(), 0);
    for (Index f = 0; f < part.number_of_faces(); ++f)
    {
      m_diagonal[f] = mass(f);
      for (Index c = part.first_corner(f); c < part.first_corner(f + 1); ++c)
        if (part.neighbor(c) != Surface_part::no_face())
        {
          const double distance =
            std::sqrt(squared_distance(part.centroid(f), part.centroid(part.neighbor(c))));
          m_weights[c] = static_cast<float>(time * part.edge_length(f, c) /
                                            (std::max)(distance, shortest));
          m_diagonal[f] += m_weights[c];
        }
    }
  }

  // Replaces `x` by the diffused values.
  void operator()(Values& x)
  {
    constexpr double tolerance = 1e-4; // relative residual; normals need no more
    constexpr int max_iterations = 200;
    const std::size_t n = x.size();
    m_residual.resize(n);
    m_direction.resize(n);
    m_product.resize(n);
    double right_hand_side = 0;
    multiply(x, m_product);
    for (Index f = 0; f < n; ++f)
    {
      const double b = mass(f) * x[f];
      m_residual[f] = b - m_product[f];
      m_direction[f] = m_residual[f] / m_diagonal[f];
      right_hand_side += b * b / m_diagonal[f];
    }
    double rho = preconditioned_norm();
    for (int i = 0; i < max_iterations && rho > tolerance * tolerance * right_hand_side; ++i)
    {
      multiply(m_direction, m_product);
      double curvature = 0;
      for (std::size_t f = 0; f < n; ++f)
        curvature += m_direction[f] * m_product[f];
      const double step = rho / curvature;
      for (std::size_t f = 0; f < n; ++f)
      {
        x[f] += step * m_direction[f];
        m_residual[f] -= step * m_product[f];
      }
      const double next_rho = preconditioned_norm();
      for (std::size_t f = 0; f < n; ++f)
        m_direction[f] = m_residual[f] / m_diagonal[f] + (next_rho / rho) * m_direction[f];
      rho = next_rho;
    }
  }

private:
  // a face without area still must not make the matrix singular
  double mass(Index f) const
  {
    return m_part.area(f) + 1e-9 * m_part.area() / m_part.number_of_faces();
  }
  double preconditioned_norm() const
  {
    double sum = 0;
    for (std::size_t f = 0; f < m_residual.size(); ++f)
      sum += m_residual[f] * m_residual[f] / m_diagonal[f];
    return sum;
  }
  void multiply(const Values& x, Values& result) const
  {
    for (Index f = 0; f < m_part.number_of_faces(); ++f)
    {
      double sum = m_diagonal[f] * x[f];
      for (Index c = m_part.first_corner(f); c < m_part.first_corner(f + 1); ++c)
        if (m_part.neighbor(c) != Surface_part::no_face())
          sum -= m_weights[c] * x[m_part.neighbor(c)];
      result[f] = sum;
    }
  }

  const Surface_part& m_part;
  Values m_diagonal, m_residual, m_direction, m_product;
  std::vector<float> m_weights; // of every corner's edge
};

// Unit normals of the faces, averaged over about `radius` on the surface. A face whose average vanishes gets
// the zero vector.
inline std::vector<Surface_part::Vector_3> smooth_normals(const Surface_part& part, double radius)
{
  using Index = Surface_part::Index;
  using Vector_3 = Surface_part::Vector_3;
  // Two steps of diffusion have together the variance of the mean over a disc of that radius.
  constexpr int steps = 2;
  const double time = radius * radius / (8 * steps);
  Diffusion diffuse(part, time);
  std::array<std::vector<double>, 3> coordinates;
  for (int i = 0; i < 3; ++i)
    coordinates[i].assign(part.number_of_faces(), 0);
  for (Index f = 0; f < part.number_of_faces(); ++f)
    if (part.area(f) > 0)
      for (int i = 0; i < 3; ++i)
        coordinates[i][f] = part.area_vector(f)[i] / part.area(f);
  for (int i = 0; i < 3; ++i)
    for (int step = 0; step < steps; ++step)
      diffuse(coordinates[i]);
  std::vector<Vector_3> normals;
  normals.reserve(part.number_of_faces());
  for (Index f = 0; f < part.number_of_faces(); ++f)
  {
    const Vector_3 normal(coordinates[0][f], coordinates[1][f], coordinates[2][f]);
    const double length = std::sqrt(normal.squared_length());
    normals.push_back(length > 0 ? normal / length : Vector_3(0, 0, 0));
  }
  return normals;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SMOOTH_NORMALS_H
