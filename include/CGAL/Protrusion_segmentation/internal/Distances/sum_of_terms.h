// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SUM_OF_TERMS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SUM_OF_TERMS_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The sum of `term(0)` to `term(n - 1)`, as four sums that need not wait for each other. In a fixed order, which that of
// `std::reduce()` is not: it may be another one with another standard library.
template <typename Term>
double sum_of_terms(std::size_t n, Term term)
{
  std::array<double, 4> sums{};
  std::size_t i = 0;
  for (; i + sums.size() <= n; i += sums.size())
    for (std::size_t k = 0; k < sums.size(); ++k)
      sums[k] += term(i + k);
  for (; i < n; ++i)
    sums[0] += term(i);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SUM_OF_TERMS_H
