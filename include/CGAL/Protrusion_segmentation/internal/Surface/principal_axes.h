// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_PRINCIPAL_AXES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_PRINCIPAL_AXES_H

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

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

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_PRINCIPAL_AXES_H
