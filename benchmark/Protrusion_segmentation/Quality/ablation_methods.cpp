// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ablation_methods.h"

#include <CGAL/protrusion_segmentation.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace PS = CGAL::Protrusion_segmentation;
using PS::internal::Cut_options;
using PS::internal::Cut_weights;

// The cut method with other options.
struct Method_with_options
{
  Cut_options options;

  PS::internal::Nested_segments segment(const PS::Indexed_surface& surface,
                                        std::optional<std::size_t> number_of_segments,
                                        PS::Execution& execution) const
  {
    const std::optional<PS::internal::Any_distance> no_distance;
    return PS::internal::Cut_segmentation(surface, no_distance, execution, options)
      .with_number_of_segments(*number_of_segments);
  }
};

Segmentation_method without(const std::string& ingredient, const Cut_options& options)
{
  return {"Without-" + ingredient,
          [options](const Mesh& mesh, std::size_t k, unsigned int seed)
          {
            Labels labels(mesh.number_of_faces());
            CGAL::segmentation_via_protrusion_tips(mesh, CGAL::make_property_map(labels), k,
                                                   Method_with_options{options},
                                                   CGAL::parameters::random_seed(seed));
            return labels;
          },
          false};
}

template <typename Value>
Segmentation_method without(const std::string& ingredient, Value Cut_options::*option, Value value)
{
  Cut_options options;
  options.*option = value;
  return without(ingredient, options);
}

struct Clue
{
  double Cut_weights::*weight;
  double mean; // over the candidate cuts of development models
};

// Clues without a weight still count by their means: the bias is for what the others say.
Segmentation_method without_clues(const std::string& ingredient, const std::vector<Clue>& clues)
{
  Cut_options options;
  for (const Clue& clue : clues)
  {
    options.weights.bias += options.weights.*clue.weight * clue.mean;
    options.weights.*clue.weight = 0;
  }
  return without(ingredient, options);
}

} // namespace

std::vector<Segmentation_method> ablation_methods()
{
  return {without("cost-of-seams", &Cut_options::cost_decay, 0.),
          without("level-sets", &Cut_options::level_sets, std::size_t(0)),
          without("regions", &Cut_options::regions, std::size_t(0)),
          without("sure-cuts-at-once", &Cut_options::sure_log_odds, std::numeric_limits<double>::infinity()),
          without("minimum-cut-on-faces", &Cut_options::moves_borders_on_faces, false),
          without_clues("concave-share", {{&Cut_weights::concave_share, 0.58}}),
          without_clues("relative-length", {{&Cut_weights::relative_length, 0.69}}),
          without_clues("segment-size", {{&Cut_weights::segment_size, -1.50}}),
          without_clues("widening", {{&Cut_weights::widening, 0.13}}),
          without_clues("shoulder",
                        {{&Cut_weights::larger_shoulder, 0.18}, {&Cut_weights::smaller_shoulder, -0.26}}),
          without_clues("roundness", {{&Cut_weights::roundness, -0.25}}),
          without_clues("neighbors", {{&Cut_weights::neighbors, 0.32}, {&Cut_weights::surrounded, 0}}),
          without_clues("mean-cost", {{&Cut_weights::mean_cost, -0.93}}),
          without_clues("thickness", {{&Cut_weights::thickness, -0.68}}),
          without_clues("pocket", {{&Cut_weights::pocket, 0}}),
          without_clues("several-loops", {{&Cut_weights::several_loops, 0.09}}),
          without_clues("flatness", {{&Cut_weights::flatness, 0}}),
          without_clues("like-part", {{&Cut_weights::like_part, 0}})};
}
