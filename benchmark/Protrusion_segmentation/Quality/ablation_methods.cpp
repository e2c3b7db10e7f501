// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ablation_methods.h"

#include <CGAL/protrusion_segmentation.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace {

namespace PS = CGAL::Protrusion_segmentation;
using PS::internal::Cut_clues;
using PS::internal::Cut_policy;

// The cut method with another policy.
struct Method_with_policy
{
  std::shared_ptr<const Cut_policy> policy;

  PS::internal::Nested_segments segment(const PS::Indexed_surface& surface,
                                        std::optional<std::size_t> number_of_segments,
                                        PS::Execution& execution) const
  {
    const std::optional<PS::internal::Any_distance> no_distance;
    return PS::internal::Cut_segmentation(surface, no_distance, execution, *policy)
      .with_number_of_segments(*number_of_segments);
  }
};

struct Without_cost_of_seams : Cut_policy
{
  double cost(double border_length, double) const override { return border_length; }
  double length_of_angle() const override { return 0; }
};

struct Without_regions : Cut_policy
{
  std::size_t number_of_regions() const override { return 0; }
};

struct Without_minimum_cuts : Cut_policy
{
  bool prefers_minimum_cut(double, double) const override { return false; }
};

struct Without_choice_of_cheaper : Cut_policy
{
  bool prefers_minimum_cut(double, double) const override { return true; }
};

// One best cut after the other.
struct Without_choosing_together : Cut_policy
{
  std::size_t number_of_sets() const override { return 1; }
};

struct Without_minimum_cut_on_faces : Cut_policy
{
  bool moves_borders_on_faces() const override { return false; }
};

// Some clues have their means over the candidate cuts of development models; flatness does not count where a number of
// segments is given.
struct Without_clues : Cut_policy
{
  explicit Without_clues(std::vector<double Cut_clues::*> clues) : m_left_out(std::move(clues)) {}

  double log_odds(const Cut_clues& clues) const override
  {
    constexpr Cut_clues mean = {0.58, 0.69, -1.50, 0.13, -0.25, 0.18, -0.26, -0.25,
                                0.32, 1.22, -0.93, -0.68, 3.97, 0.09, 0};
    Cut_clues others = clues;
    for (double Cut_clues::*clue : m_left_out)
      others.*clue = mean.*clue;
    return Cut_policy::log_odds(others);
  }

private:
  std::vector<double Cut_clues::*> m_left_out;
};

Segmentation_method without(const std::string& ingredient, std::shared_ptr<const Cut_policy> policy)
{
  return {"Without-" + ingredient,
          [policy](const Mesh& mesh, std::size_t k, unsigned int seed)
          {
            Labels labels(mesh.number_of_faces());
            CGAL::segmentation_via_protrusion_tips(mesh, CGAL::make_property_map(labels), k,
                                                   Method_with_policy{policy}, CGAL::parameters::random_seed(seed));
            return labels;
          },
          false};
}

Segmentation_method without_clues(const std::string& ingredient, std::vector<double Cut_clues::*> clues)
{
  return without(ingredient, std::make_shared<Without_clues>(std::move(clues)));
}

} // namespace

std::vector<Segmentation_method> ablation_methods()
{
  return {without("cost-of-seams", std::make_shared<Without_cost_of_seams>()),
          without("regions", std::make_shared<Without_regions>()),
          without("minimum-cuts", std::make_shared<Without_minimum_cuts>()),
          without("choice-of-cheaper", std::make_shared<Without_choice_of_cheaper>()),
          without("choosing-together", std::make_shared<Without_choosing_together>()),
          without("minimum-cut-on-faces", std::make_shared<Without_minimum_cut_on_faces>()),
          without_clues("concave-share", {&Cut_clues::concave_share}),
          without_clues("relative-length", {&Cut_clues::relative_length}),
          without_clues("segment-size", {&Cut_clues::segment_size}),
          without_clues("widening", {&Cut_clues::larger_widening, &Cut_clues::smaller_widening}),
          without_clues("shoulder", {&Cut_clues::larger_shoulder, &Cut_clues::smaller_shoulder}),
          without_clues("roundness", {&Cut_clues::roundness}),
          without_clues("neighbors", {&Cut_clues::neighbors}),
          without_clues("contrast", {&Cut_clues::contrast}),
          without_clues("mean-cost", {&Cut_clues::mean_cost}),
          without_clues("thickness", {&Cut_clues::thickness}),
          without_clues("inner-concavity", {&Cut_clues::inner_concavity}),
          without_clues("several-loops", {&Cut_clues::several_loops})};
}
