// SPDX-License-Identifier: GPL-3.0-or-later

#include "protrusion_methods.h"

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

} // namespace

std::vector<Segmentation_method> protrusion_methods()
{
  const PS::Geodesic_distance geodesic;
  const PS::Minimum_cut_border minimum_cut;
  const PS::Histogram_border histogram;
  return {method("Minimum-cut", geodesic, minimum_cut),
          automatic("Minimum-cut-automatic", geodesic, minimum_cut),
          method("Paper-GD", geodesic, histogram),
          method("Paper-GD-no-intervals", geodesic,
                 PS::Histogram_border().uses_candidate_intervals(false)),
          automatic("Paper-GD-automatic", geodesic, histogram),
          method("Paper-LGD(1)", PS::Landmark_geodesic_distance(0.01), histogram),
          method("Paper-LGD(5)", PS::Landmark_geodesic_distance(0.05), histogram),
          method("Paper-LGD(10)", PS::Landmark_geodesic_distance(0.1), histogram)};
}
