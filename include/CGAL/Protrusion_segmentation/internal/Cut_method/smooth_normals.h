// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SMOOTH_NORMALS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SMOOTH_NORMALS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Edge_conductances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Diffuses vectors on the faces: solves (M + time * L) x = M x_0 for each coordinate, where M holds the areas
// and L is the finite-volume Laplacian of the face dual graph, by conjugate gradients with a diagonal
// preconditioner. On a mesh of N faces that needs about sqrt(time * N / area) iterations, each linear.
//
// The three systems are solved side by side, since an iteration waits for memory more than it computes.
class Diffusion
{
public:
  using Index = Indexed_surface::Index;
  using Triple = std::array<double, 3>;
  using Values = std::vector<Triple>;

  Diffusion(const Indexed_surface& surface, double time)
    : m_surface(surface), m_diagonal(surface.number_of_faces()), m_preconditioner(surface.number_of_faces())
  {
    const Edge_conductances conductance(surface);
    m_weights.assign(surface.number_of_corners(), 0);
    for (Index f = 0; f < surface.number_of_faces(); ++f)
    {
      m_diagonal[f] = mass(f);
      for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
        if (surface.neighbor(c) != Indexed_surface::no_face())
        {
          m_weights[c] = static_cast<float>(time * conductance(f, c));
          m_diagonal[f] += m_weights[c];
        }
      m_preconditioner[f] = 1 / m_diagonal[f];
    }
  }

  // Replaces `x` by the diffused values.
  void operator()(Values& x, Execution& execution)
  {
    constexpr double tolerance = 1e-4; // relative residual; normals need no more
    constexpr int max_iterations = 200;
    const Triple right_hand_side = start(x);
    Triple rho = advance({0, 0, 0}, x);
    const auto is_solved = [&](int i) { return !(rho[i] > tolerance * tolerance * right_hand_side[i]); };
    for (int iteration = 0; iteration < max_iterations; ++iteration)
    {
      execution.check();
      if (is_solved(0) && is_solved(1) && is_solved(2))
        return;
      const Triple curvature = multiply(m_direction, m_product);
      Triple step, share;
      for (int i = 0; i < 3; ++i)
        step[i] = is_solved(i) ? 0 : rho[i] / curvature[i];
      const Triple before = rho;
      rho = advance(step, x);
      for (int i = 0; i < 3; ++i)
        share[i] = before[i] > 0 ? rho[i] / before[i] : 0;
      for (Index f = 0; f < x.size(); ++f)
        for (int i = 0; i < 3; ++i)
          m_direction[f][i] = m_residual[f][i] * m_preconditioner[f] + share[i] * m_direction[f][i];
    }
  }

private:
  // a face without area still must not make the matrix singular
  double mass(Index f) const
  {
    return m_surface.area(f) + 1e-9 * m_surface.area() / m_surface.number_of_faces();
  }

  // Residuals and first directions; returns the norms of the right hand sides.
  Triple start(const Values& x)
  {
    m_residual.resize(x.size());
    m_direction.resize(x.size());
    m_product.resize(x.size());
    multiply(x, m_product);
    Triple norms = {0, 0, 0};
    for (Index f = 0; f < x.size(); ++f)
      for (int i = 0; i < 3; ++i)
      {
        const double b = mass(f) * x[f][i];
        m_residual[f][i] = b - m_product[f][i];
        m_direction[f][i] = m_residual[f][i] * m_preconditioner[f];
        norms[i] += b * b * m_preconditioner[f];
      }
    return norms;
  }

  // Goes `step` along the direction; returns the norms of the new residuals.
  Triple advance(const Triple& step, Values& x)
  {
    Triple sums = {0, 0, 0};
    for (std::size_t f = 0; f < x.size(); ++f)
      for (int i = 0; i < 3; ++i)
      {
        x[f][i] += step[i] * m_direction[f][i];
        m_residual[f][i] -= step[i] * m_product[f][i];
        sums[i] += m_residual[f][i] * m_residual[f][i] * m_preconditioner[f];
      }
    return sums;
  }

  // Returns the scalar products of the values with the result.
  Triple multiply(const Values& x, Values& result) const
  {
    Triple sums = {0, 0, 0};
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
    {
      Triple row;
      for (int i = 0; i < 3; ++i)
        row[i] = m_diagonal[f] * x[f][i];
      for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
        if (m_surface.neighbor(c) != Indexed_surface::no_face())
          for (int i = 0; i < 3; ++i)
            row[i] -= m_weights[c] * x[m_surface.neighbor(c)][i];
      result[f] = row;
      for (int i = 0; i < 3; ++i)
        sums[i] += x[f][i] * row[i];
    }
    return sums;
  }

  const Indexed_surface& m_surface;
  std::vector<double> m_diagonal, m_preconditioner; // each other's inverse
  std::vector<float> m_weights;                     // of every corner's edge
  Values m_residual, m_direction, m_product;
};

// Unit normals of the faces, averaged over about `radius` on the surface. A face whose average vanishes gets
// the zero vector.
inline std::vector<Indexed_surface::Vector_3> smooth_normals(const Indexed_surface& surface,
                                                             double radius,
                                                             Execution& execution)
{
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;
  // Two steps of diffusion have together the variance of the mean over a disc of that radius.
  constexpr int steps = 2;
  const double time = radius * radius / (8 * steps);
  Diffusion::Values normals(surface.number_of_faces(), {0, 0, 0});
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (surface.area(f) > 0)
    {
      const Vector_3 normal = surface.area_vector(f);
      normals[f] = {normal.x() / surface.area(f), normal.y() / surface.area(f), normal.z() / surface.area(f)};
    }
  {
    Diffusion diffuse(surface, time);
    for (int step = 0; step < steps; ++step)
    {
      execution.progress(static_cast<double>(step) / steps);
      diffuse(normals, execution);
    }
  }
  std::vector<Vector_3> result;
  result.reserve(surface.number_of_faces());
  for (const Diffusion::Triple& normal : normals)
  {
    const Vector_3 vector(normal[0], normal[1], normal[2]);
    const double length = std::sqrt(vector.squared_length());
    result.push_back(length > 0 ? vector / length : Vector_3(0, 0, 0));
  }
  return result;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SMOOTH_NORMALS_H
