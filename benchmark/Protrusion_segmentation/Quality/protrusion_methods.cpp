// SPDX-License-Identifier: GPL-3.0-or-later

#include "protrusion_methods.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/protrusion_segmentation.h>

namespace {

namespace PS = CGAL::Protrusion_segmentation;

template <typename Distance, typename Border>
Segmentation_method method(const std::string& name, const Distance& distance, const Border& border)
{
  return {name, [distance, border](const Mesh& mesh, std::size_t k, unsigned int seed)
          {
            Labels labels(mesh.number_of_faces());
            CGAL::segmentation_via_protrusion_tips(mesh, CGAL::make_property_map(labels), k, distance,
                                                   border, CGAL::parameters::random_seed(seed));
            return labels;
          }};
}

template <typename Distance, typename Border>
Segmentation_method automatic(const std::string& name, const Distance& distance, const Border& border)
{
  return {name, [distance, border](const Mesh& mesh, std::size_t, unsigned int seed)
          {
            Labels labels(mesh.number_of_faces());
            CGAL::segmentation_via_protrusion_tips(mesh, CGAL::make_property_map(labels), distance, border,
                                                   CGAL::parameters::random_seed(seed));
            return labels;
          }};
}

// DD(k): as many eigenpairs as segments are asked for.
Segmentation_method diffusion_of_segments(const std::string& name)
{
  return {name, [name](const Mesh& mesh, std::size_t k, unsigned int seed)
          {
            return method(name, PS::Diffusion_distance(k), PS::Histogram_method()).segment(mesh, k, seed);
          }};
}

Segmentation_method if_named(Segmentation_method method)
{
  method.runs_by_default = false;
  return method;
}

} // namespace

std::vector<Segmentation_method> protrusion_methods()
{
  const PS::Geodesic_distance geodesic;
  const PS::Minimum_cut_method minimum_cut;
  const PS::Histogram_method histogram;
  const PS::Heat_distance heat;
  const PS::Exact_geodesic_distance exact;
  return {method("Minimum-cut", geodesic, minimum_cut),
          automatic("Minimum-cut-automatic", geodesic, minimum_cut),
          method("Minimum-cut-DD(10)", PS::Diffusion_distance(10), minimum_cut),
          method("Minimum-cut-heat", heat, minimum_cut),
          if_named(method("Minimum-cut-exact", exact, minimum_cut)),
          method("Paper-GD", geodesic, histogram),
          method("Paper-GD-no-intervals", geodesic,
                 PS::Histogram_method().uses_candidate_intervals(false)),
          automatic("Paper-GD-automatic", geodesic, histogram),
          method("Paper-LGD(1)", PS::Landmark_geodesic_distance(0.01), histogram),
          method("Paper-LGD(5)", PS::Landmark_geodesic_distance(0.05), histogram),
          method("Paper-LGD(10)", PS::Landmark_geodesic_distance(0.1), histogram),
          method("Paper-DD(5)", PS::Diffusion_distance(5), histogram),
          method("Paper-DD(10)", PS::Diffusion_distance(10), histogram),
          diffusion_of_segments("Paper-DD(k)"),
          method("Paper-heat", heat, histogram),
          if_named(method("Paper-exact", exact, histogram))};
}
