// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_BLOCK_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_BLOCK_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Loops over many indices, in blocks that do not depend on the number of threads. A block takes some tens of
// microseconds, to start one takes less than one.
constexpr std::size_t indices_of_block = 4096;

inline std::size_t number_of_blocks(std::size_t n)
{
  return (n + indices_of_block - 1) / indices_of_block;
}

// Calls `body(begin, end, block)` for every block of the indices from 0 to n - 1; if parallel, several threads do so,
// in any order.
template <typename Body>
void for_each_block(std::size_t n, bool parallel, Body body)
{
  const auto call = [&](std::size_t block)
  { body(block * indices_of_block, (std::min)(n, (block + 1) * indices_of_block), block); };
#ifdef CGAL_LINKED_WITH_TBB
  if (parallel)
  {
    tbb::parallel_for(std::size_t(0), number_of_blocks(n), call);
    return;
  }
#endif
  static_cast<void>(parallel);
  for (std::size_t block = 0; block < number_of_blocks(n); ++block)
    call(block);
}

// Calls `visit(i)` for every number i from 0 to n - 1, in any order if parallel. For many short calls.
template <typename Visit>
void for_each_number(std::size_t n, bool parallel, Visit visit)
{
  for_each_block(n, parallel,
                 [&](std::size_t begin, std::size_t end, std::size_t)
                 {
                   for (std::size_t i = begin; i < end; ++i)
                     visit(static_cast<std::uint32_t>(i));
                 });
}

// The sum of what `add(sum, i)` adds to `zero` for every number i from 0 to n - 1, rounded alike with any number of threads.
template <typename Sum, typename Add>
Sum add_numbers(std::size_t n, bool parallel, Sum zero, Add add)
{
  std::vector<Sum> of_blocks(number_of_blocks(n), zero);
  for_each_block(n, parallel,
                 [&](std::size_t begin, std::size_t end, std::size_t block)
                 {
                   Sum sum = zero;
                   for (std::size_t i = begin; i < end; ++i)
                     add(sum, static_cast<std::uint32_t>(i));
                   of_blocks[block] = sum;
                 });
  Sum sum = zero;
  for (const Sum& of_block : of_blocks)
    sum = sum + of_block;
  return sum;
}

// Sorts values of which no two are equivalent, so that their order is the same however it is found.
template <typename T, typename Less>
void sort_different(std::vector<T>& values, bool parallel, Less less)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (parallel)
  {
    tbb::parallel_sort(values.begin(), values.end(), less);
    return;
  }
#endif
  static_cast<void>(parallel);
  std::sort(values.begin(), values.end(), less);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_BLOCK_H
