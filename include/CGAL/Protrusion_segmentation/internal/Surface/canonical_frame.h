// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_FRAME_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_FRAME_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Protrusion_segmentation::internal {

using Matrix_3 = std::array<std::array<double, 3>, 3>;

// The eigenvectors of a symmetric matrix as rows, in the order of descending eigenvalues, by Jacobi's rotations. The
// default method needs no library for linear algebra, and gets the same digits with every one.
inline Matrix_3 principal_axes(Matrix_3 m)
{
  constexpr int number_of_sweeps = 8; // convergence is quadratic: five reach the last digit
  Matrix_3 axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  using Pair = std::pair<std::size_t, std::size_t>;
  for (int sweep = 0; sweep < number_of_sweeps; ++sweep)
    for (const auto& [p, q] : {Pair(0, 1), Pair(0, 2), Pair(1, 2)})
    {
      if (m[p][q] == 0)
        continue;
      const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
      const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(CGAL::square(theta) + 1));
      const double c = 1 / std::sqrt(CGAL::square(t) + 1), s = t * c;
      const auto rotate = [c = c, s = s](double& x, double& y)
      {
        const double old = x;
        x = c * old - s * y;
        y = s * old + c * y;
      };
      for (std::size_t i = 0; i < 3; ++i)
        rotate(m[p][i], m[q][i]);
      for (std::size_t i = 0; i < 3; ++i)
      {
        rotate(m[i][p], m[i][q]);
        rotate(axes[p][i], axes[q][i]);
      }
    }
  std::array<std::pair<double, std::size_t>, 3> order = {{{-m[0][0], 0}, {-m[1][1], 1}, {-m[2][2], 2}}};
  std::sort(order.begin(), order.end());
  return {axes[order[0].second], axes[order[1].second], axes[order[2].second]};
}

// A sum that keeps what each addition rounds off: as good as one with twice the digits, so that the order of its terms
// does not show.
class Compensated_sum
{
public:
  Compensated_sum& operator+=(double term)
  {
    const double sum = m_sum + term;
    const double added = sum - m_sum;
    m_rest += (m_sum - (sum - added)) + (term - added);
    m_sum = sum;
    return *this;
  }
  friend Compensated_sum operator+(Compensated_sum a, const Compensated_sum& b)
  {
    (a += b.m_sum).m_rest += b.m_rest;
    return a;
  }
  double value() const { return m_sum + m_rest; }

private:
  double m_sum = 0, m_rest = 0;
};

template <std::size_t N>
struct Compensated_sums : std::array<Compensated_sum, N>
{
  friend Compensated_sums operator+(Compensated_sums a, const Compensated_sums& b)
  {
    for (std::size_t i = 0; i < N; ++i)
      a[i] = a[i] + b[i];
    return a;
  }
};

// Where the points of a surface go so that they are the same however the surface is moved, turned, mirrored or scaled: about
// the centre of gravity, along the axes of inertia, the longest first, and each axis points to where the surface reaches
// far. Where two moments of inertia are the same, or the surface is symmetric, there is no such frame; then
// the result depends on how the surface lies.
class Canonical_frame
{
public:
  using Index = Indexed_surface::Index;
  using Point_3 = Indexed_surface::Point_3;
  using Vector_3 = Indexed_surface::Vector_3;

  // All coordinates of the surface are in [-1, 1].
  Canonical_frame(const Surface_arrays& surface, bool is_parallel)
    : m_surface(surface),
      m_is_parallel(is_parallel)
  {
    m_axes = principal_axes(find_centre_and_covariance());
    direct_axes();
  }

  Point_3 operator()(const Point_3& point) const
  {
    const Vector_3 v = point - m_centre;
    const auto along = [&v](const Triple& axis)
    { return axis[0] * v.x() + axis[1] * v.y() + axis[2] * v.z(); };
    return {along(m_axes[0]), along(m_axes[1]), along(m_axes[2])};
  }

  // whether a right hand becomes a left one
  bool mirrors() const
  {
    const auto vector = [](const Triple& axis) { return Vector_3(axis[0], axis[1], axis[2]); };
    return cross_product(vector(m_axes[0]), vector(m_axes[1])) * vector(m_axes[2]) < 0;
  }

private:
  using Triple = std::array<double, 3>;
  using Corners = Corners_of_face<Surface_arrays>;

  // `add(corners, measures, sums)` for every face
  template <std::size_t N, typename Add>
  Compensated_sums<N> sums_over_faces(Add add) const
  {
    return add_numbers(m_surface.number_of_faces(), m_is_parallel, Compensated_sums<N>(),
                       [&](Compensated_sums<N>& sums, Index f)
                       {
                         const Corners corners{m_surface, f};
                         add(corners, measure_polygon(corners), sums);
                       });
  }

  // The covariance is that of all points of the surface, whatever its triangles: over a triangle, the mean of a square
  // is three quarters of the one at the centroid and a quarter of the mean at the corners.
  Matrix_3 find_centre_and_covariance()
  {
    const auto sums = sums_over_faces<10>(
      [](const Corners& corners, const Polygon_measures& face, Compensated_sums<10>& result)
      {
        const double share_of_corner = 0.25 / static_cast<double>(corners.size());
        const Triple centroid = triple(face.centroid);
        std::size_t i = 4;
        result[0] += face.area;
        for (std::size_t a = 0; a < 3; ++a)
        {
          result[1 + a] += face.area * centroid[a];
          for (std::size_t b = 0; b <= a; ++b)
          {
            double square = 0.75 * centroid[a] * centroid[b];
            for (std::size_t c = 0; c < corners.size(); ++c)
              square += share_of_corner * triple(corners[c])[a] * triple(corners[c])[b];
            result[i++] += face.area * square;
          }
        }
      });
    const double area = sums[0].value();
    if (!(area > 0))
      return {};
    const Triple centre = {sums[1].value() / area, sums[2].value() / area, sums[3].value() / area};
    m_centre = Point_3(centre[0], centre[1], centre[2]);
    Matrix_3 covariance;
    std::size_t i = 4;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        covariance[a][b] = covariance[b][a] = sums[i++].value() / area - centre[a] * centre[b];
    return covariance;
  }

  // By the sign of the third moment, where the surface is not symmetric; there, by the direction in the mesh.
  void direct_axes()
  {
    // of the sum of the absolute values; rounding gives a symmetric surface some 1e-16
    constexpr double least_skewness = 1e-10;
    const auto sums = sums_over_faces<6>(
      [this](const Corners&, const Polygon_measures& face, Compensated_sums<6>& result)
      {
        const Triple x = triple((*this)(face.centroid));
        for (std::size_t a = 0; a < 3; ++a)
        {
          const double cube = face.area * x[a] * x[a] * x[a];
          result[a] += cube;
          result[3 + a] += std::abs(cube);
        }
      });
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double skewness = sums[a].value();
      const bool is_symmetric = !(std::abs(skewness) > least_skewness * sums[3 + a].value());
      if (is_symmetric ? largest_component(m_axes[a]) < 0 : skewness < 0)
        for (double& component : m_axes[a])
          component = -component;
    }
  }

  static Triple triple(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

  static double largest_component(const Triple& axis)
  {
    return *std::max_element(axis.begin(), axis.end(),
                             [](double x, double y) { return std::abs(x) < std::abs(y); });
  }

  const Surface_arrays& m_surface;
  bool m_is_parallel;
  Point_3 m_centre = Point_3(0, 0, 0);
  Matrix_3 m_axes;
};

// Starts every face at its lexicographically smallest point, after it has been turned over if `reversed`.
inline void start_faces_canonically(Surface_arrays& surface, bool reversed, bool is_parallel)
{
  for_each_number(surface.number_of_faces(), is_parallel,
                  [&](Indexed_surface::Index f)
                  {
                    const auto vertices = surface.corner_vertices.begin() + surface.corner_begin[f];
                    const auto neighbors = surface.corner_neighbors.begin() + surface.corner_begin[f];
                    const auto size = surface.corner_begin[f + 1] - surface.corner_begin[f];
                    if (reversed)
                    {
                      std::reverse(vertices + 1, vertices + size);
                      std::reverse(neighbors, neighbors + size);
                    }
                    const auto first = std::min_element(
                                         vertices, vertices + size,
                                         [&surface](Indexed_surface::Index u, Indexed_surface::Index v)
                                         { return surface.points[u] < surface.points[v]; }) -
                                       vertices;
                    std::rotate(vertices, vertices + first, vertices + size);
                    std::rotate(neighbors, neighbors + first, neighbors + size);
                  });
}

// Moves the points of a connected surface to its canonical frame, scaled to [-1, 1]^3 and rounded to multiples of a
// billionth, so that rounding on the way there leaves no trace; returns the factor that turns lengths back.
inline double move_to_canonical_frame(Surface_arrays& surface, bool is_parallel)
{
  constexpr double unit_of_rounding = 1. / (1 << 30);
  const double unit = normalize(surface.points);
  const Canonical_frame frame(surface, is_parallel);
  double largest = 0;
  for (Indexed_surface::Point_3& point : surface.points)
  {
    point = frame(point);
    largest = (std::max)({largest, std::abs(point.x()), std::abs(point.y()), std::abs(point.z())});
  }
  if (!(largest > 0))
    return unit;
  const auto rounded = [scale = 1 / (largest * unit_of_rounding)](double x)
  { return std::nearbyint(x * scale) * unit_of_rounding; };
  for (Indexed_surface::Point_3& p : surface.points)
    p = Indexed_surface::Point_3(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  start_faces_canonically(surface, frame.mirrors(), is_parallel);
  return unit * largest;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_FRAME_H
