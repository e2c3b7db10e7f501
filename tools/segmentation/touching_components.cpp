// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/touching_components.h"

#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tool {
namespace {

namespace internal = CGAL::Protrusion_segmentation::internal;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

struct Triangle_of_component
{
  Kernel::Triangle_3 triangle;
  std::uint32_t component;
};

// The triangles of all components that may touch another one.
std::vector<Triangle_of_component> triangles_in_question(const internal::Surface_arrays& surface,
                                                         const std::vector<std::uint32_t>& components,
                                                         const std::vector<bool>& is_in_question)
{
  std::vector<Triangle_of_component> result;
  for (std::uint32_t f = 0; f < surface.number_of_faces(); ++f)
    if (is_in_question[components[f]])
      for (std::uint32_t c = surface.first_corner(f) + 1; c + 1 < surface.first_corner(f + 1); ++c)
      {
        const auto point = [&](std::uint32_t corner)
        {
          const Point& p = surface.point(surface.vertex(corner));
          return Kernel::Point_3(p.x(), p.y(), p.z());
        };
        const Kernel::Triangle_3 triangle(point(surface.first_corner(f)), point(c), point(c + 1));
        if (!triangle.is_degenerate())
          result.push_back({triangle, components[f]});
      }
  return result;
}

// Those whose bounding boxes meet.
std::vector<bool> may_touch(const internal::Surface_arrays& surface,
                            const std::vector<std::uint32_t>& components,
                            std::size_t number)
{
  std::vector<CGAL::Bbox_3> of_components(number);
  for (std::uint32_t f = 0; f < surface.number_of_faces(); ++f)
    for (std::uint32_t c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      of_components[components[f]] += surface.point(surface.vertex(c)).bbox();
  std::vector<Box> boxes;
  for (std::uint32_t c = 0; c < number; ++c)
    boxes.emplace_back(of_components[c], c);
  std::vector<bool> result(number, false);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const Box& a, const Box& b)
                                { result[a.info()] = result[b.info()] = true; });
  return result;
}

} // namespace

Touching_components touching_components(const Mesh& mesh)
{
  internal::Surface_arrays surface = internal::read_arrays(mesh, CGAL::parameters::default_values());
  internal::scale_to_unit(surface.points);
  const std::vector<std::uint32_t> components = internal::components_of_faces(surface);
  const std::size_t number = 1 + *std::max_element(components.begin(), components.end());
  const auto triangles = triangles_in_question(surface, components,
                                               may_touch(surface, components, number));
  std::vector<Box> boxes;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    boxes.emplace_back(triangles[t].triangle.bbox(), t);
  std::vector<bool> touches(number, false);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const Box& a, const Box& b)
                                {
                                  const auto &s = triangles[a.info()], &t = triangles[b.info()];
                                  if (s.component == t.component ||
                                      (touches[s.component] && touches[t.component]))
                                    return;
                                  if (CGAL::do_intersect(s.triangle, t.triangle))
                                    touches[s.component] = touches[t.component] = true;
                                });
  return {std::size_t(std::count(touches.begin(), touches.end(), true)), number};
}

} // namespace tool
