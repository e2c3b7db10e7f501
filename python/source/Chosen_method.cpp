// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Chosen_method.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Protrusion_segmentation/Landmark_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Minimum_cut_method.h>

namespace python {
namespace {

PS::Landmark_geodesic_distance landmark_distance(const Method_options& options)
{
  return options.number_of_landmarks
           ? PS::Landmark_geodesic_distance::with_number_of_landmarks(*options.number_of_landmarks)
           : PS::Landmark_geodesic_distance(options.share_of_landmarks.value());
}

PS::internal::Any_distance distance_of_name(const Method_options& options)
{
  using PS::internal::Any_distance;
  if (options.distance == "landmark")
    return Any_distance(landmark_distance(options));
  if (options.distance == "diffusion")
    return Any_distance(PS::Diffusion_distance(options.number_of_terms, options.time));
  if (options.distance == "heat")
    return Any_distance(PS::Heat_distance());
  if (options.distance == "exact")
    return Any_distance(PS::Exact_geodesic_distance());
  return Any_distance(PS::Geodesic_distance());
}

template <typename Method>
Method make_method(const Method_options& options)
{
  const std::optional<Chosen_distance> distance = choose_distance(options);
  return distance ? Method(*distance) : Method();
}

} // namespace

std::optional<Chosen_distance> choose_distance(const Method_options& options)
{
  if (options.own_distance)
    return options.own_distance;
  if (options.distance.empty())
    return std::nullopt;
  return Chosen_distance(distance_of_name(options));
}

template <typename Method>
void Chosen_method::set(const Method& method)
{
  m_segment = [method](const auto& surface, auto number_of_segments, auto& execution)
  { return method.segment(surface, number_of_segments, execution); };
  m_segment_from_tips = [method](const auto& surface, const auto& tips, auto& execution)
  { return method.segment_from_tips(surface, tips, execution); };
}

Chosen_method::Chosen_method(const Method_options& options)
{
  if (options.method == "paper")
    set(make_method<PS::Histogram_method>(options)
          .minimum_prominence(options.minimum_prominence)
          .uses_candidate_intervals(options.uses_candidate_intervals));
  else
    set(make_method<PS::Minimum_cut_method>(options));
}

} // namespace python
