// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_FACE_NUMBERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_FACE_NUMBERS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <boost/graph/graph_traits.hpp>

#include <map>
#include <stdexcept>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The positions of the given faces in the order of `faces(mesh)`.
template <typename FaceGraph, typename FaceRange>
std::vector<Indexed_surface::Index> face_numbers(const FaceGraph& mesh, const FaceRange& range)
{
  using Index = Indexed_surface::Index;
  std::map<typename boost::graph_traits<FaceGraph>::face_descriptor, Index> numbers;
  for (const auto f : range)
    numbers[f] = Indexed_surface::no_face();
  Index i = 0;
  for (const auto f : faces(mesh))
  {
    const auto found = numbers.find(f);
    if (found != numbers.end())
      found->second = i;
    ++i;
  }
  std::vector<Index> result;
  for (const auto f : range)
  {
    if (numbers[f] == Indexed_surface::no_face())
      throw std::invalid_argument("tips: a face is not in pmesh");
    result.push_back(numbers[f]);
  }
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_FACE_NUMBERS_H
