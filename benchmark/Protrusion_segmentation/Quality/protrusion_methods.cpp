// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "protrusion_methods.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/protrusion_segmentation.h>

namespace {

namespace PS = CGAL::Protrusion_segmentation;

template <typename Method>
Segmentation_method method(const std::string& name, const Method& method)
{
  return {name, [method](const Mesh& mesh, std::size_t k, unsigned int seed)
          {
            Labels labels(mesh.number_of_faces());
            CGAL::segmentation_via_protrusion_tips(mesh, CGAL::make_property_map(labels), k, method,
                                                   CGAL::parameters::random_seed(seed));
            return labels;
          }};
}

template <typename Method>
Segmentation_method automatic(const std::string& name, const Method& method)
{
  return {name, [method](const Mesh& mesh, std::size_t, unsigned int seed)
          {
            Labels labels(mesh.number_of_faces());
            CGAL::segmentation_via_protrusion_tips(mesh, CGAL::make_property_map(labels), method,
                                                   CGAL::parameters::random_seed(seed));
            return labels;
          }};
}

// DD(k): as many eigenpairs as segments.
Segmentation_method diffusion_of_segments(const std::string& name)
{
  return {name, [name](const Mesh& mesh, std::size_t k, unsigned int seed)
          { return method(name, PS::Histogram_method(PS::Diffusion_distance(k))).segment(mesh, k, seed); }};
}

Segmentation_method if_named(Segmentation_method method)
{
  method.runs_by_default = false;
  return method;
}

} // namespace

std::vector<Segmentation_method> protrusion_methods()
{
  const PS::Heat_distance heat;
  const PS::Exact_geodesic_distance exact;
  return {method("Minimum-cut", PS::Minimum_cut_method()),
          automatic("Minimum-cut-automatic", PS::Minimum_cut_method()),
          method("Minimum-cut-GD", PS::Minimum_cut_method(PS::Geodesic_distance())),
          method("Minimum-cut-DD(10)", PS::Minimum_cut_method(PS::Diffusion_distance(10))),
          method("Minimum-cut-heat", PS::Minimum_cut_method(heat)),
          if_named(method("Minimum-cut-exact", PS::Minimum_cut_method(exact))),
          method("Paper-GD", PS::Histogram_method()),
          method("Paper-GD-no-intervals", PS::Histogram_method().uses_candidate_intervals(false)),
          automatic("Paper-GD-automatic", PS::Histogram_method()),
          method("Paper-LGD(1)", PS::Histogram_method(PS::Landmark_geodesic_distance(0.01))),
          method("Paper-LGD(5)", PS::Histogram_method(PS::Landmark_geodesic_distance(0.05))),
          method("Paper-LGD(10)", PS::Histogram_method(PS::Landmark_geodesic_distance(0.1))),
          method("Paper-DD(5)", PS::Histogram_method(PS::Diffusion_distance(5))),
          method("Paper-DD(10)", PS::Histogram_method(PS::Diffusion_distance(10))),
          diffusion_of_segments("Paper-DD(k)"),
          method("Paper-heat", PS::Histogram_method(heat)),
          if_named(method("Paper-exact", PS::Histogram_method(exact)))};
}
