// SPDX-License-Identifier: GPL-3.0-or-later

#include "ablation_methods.h"

#include <CGAL/protrusion_segmentation.h>

#include <optional>
#include <utility>

namespace {

namespace PS = CGAL::Protrusion_segmentation;

// The default border method with some of its ingredients.
struct Border_with_ingredients
{
  PS::internal::Cut_ingredients ingredients;

  template <typename Distance, typename Visitor>
  PS::internal::Nested_segments segment(const PS::Indexed_surface& surface, const Distance& distance,
                                       std::optional<std::size_t> number_of_segments,
                                       PS::internal::Monitor<Visitor>& monitor) const
  {
    return PS::internal::Cut_segmentation<Distance, Visitor>(surface, distance, monitor, ingredients)
      .with_number_of_segments(*number_of_segments);
  }
};

} // namespace

std::vector<Segmentation_method> ablation_methods()
{
  using Ingredients = PS::internal::Cut_ingredients;
  const std::vector<std::pair<std::string, bool Ingredients::*>> ingredients = {
    {"cost-of-seams", &Ingredients::cost_of_seams},
    {"minimum-cuts", &Ingredients::minimum_cuts},
    {"choice-of-cheaper", &Ingredients::choice_of_cheaper},
    {"minimum-cut-on-faces", &Ingredients::minimum_cut_on_faces},
    {"concave-share", &Ingredients::concave_share},
    {"relative-length", &Ingredients::relative_length},
    {"part-size", &Ingredients::part_size},
    {"widening", &Ingredients::widening}};
  std::vector<Segmentation_method> methods;
  for(const auto& ingredient : ingredients)
  {
    Border_with_ingredients border;
    border.ingredients.*ingredient.second = false;
    methods.push_back({"Without-" + ingredient.first,
                       [border](const Mesh& mesh, std::size_t k, unsigned int seed)
                       {
                         Labels labels(mesh.number_of_faces());
                         CGAL::segmentation_via_protrusion_tips(mesh, CGAL::make_property_map(labels), k,
                                                                PS::Geodesic_distance(), border,
                                                                CGAL::parameters::random_seed(seed));
                         return labels;
                       },
                       false});
  }
  return methods;
}
