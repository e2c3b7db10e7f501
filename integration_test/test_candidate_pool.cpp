// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program that fits weights takes as the error of a model, beside the segmentation itself, pair of faces by pair.

#include "check.h"
#include "Candidate_pool.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_segmentation.h>
#include <CGAL/protrusion_segmentation.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

namespace {

namespace PS = CGAL::Protrusion_segmentation;

using PS::internal::Cut_weights;

struct Method
{
  PS::internal::Cut_options options;

  PS::internal::Nested_segments segment(const PS::Indexed_surface& surface,
                                        std::optional<std::size_t> number_of_segments,
                                        PS::Execution& execution) const
  {
    const std::optional<PS::internal::Any_distance> no_distance;
    PS::internal::Cut_segmentation segmentation(surface, no_distance, execution, options);
    return number_of_segments ? segmentation.with_number_of_segments(*number_of_segments) : segmentation.with_automatic_number();
  }
};

double share_of_pairs_divided_otherwise(const Labels& a, const Labels& b)
{
  std::size_t number = 0;
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t g = 0; g < f; ++g)
      number += (a[f] == a[g]) != (b[f] == b[g]);
  return 2 * double(number) / (double(a.size()) * double(a.size() - 1));
}

double error(const Model& model, const Labels& labels)
{
  double sum = 0;
  for (const Labels& human : model.humans)
    sum += share_of_pairs_divided_otherwise(labels, human);
  return sum / double(model.humans.size());
}

void check_errors(Candidate_pool& pool, const Model& model, const Cut_weights& weights)
{
  Method method;
  method.options.moves_borders_on_faces = false;
  method.options.weights = weights;
  Labels labels(model.mesh.number_of_faces());
  CGAL::segmentation_via_protrusion_tips(model.mesh, CGAL::make_property_map(labels), model.number_of_segments, method);
  const Candidate_pool::Errors errors = pool.errors(weights);
  CGAL_CHECK_CLOSE(errors.with_number, error(model, labels), 1e-12);
  const std::size_t found = CGAL::segmentation_via_protrusion_tips(model.mesh, CGAL::make_property_map(labels), method);
  CGAL_CHECK_CLOSE(errors.automatic, error(model, labels), 1e-12);
  CGAL_CHECK_EQUAL(errors.is_number_found, found == model.number_of_segments);
}

// People see the true parts, one segment, or every part in four.
Model star_model(std::size_t arms, std::size_t number_of_segments)
{
  const test_meshes::Test_mesh star = test_meshes::star(arms);
  Model model;
  model.class_name = "Star";
  model.number_of_segments = number_of_segments;
  model.mesh = test_meshes::to_graph<Mesh>(star);
  Labels quarters;
  for (std::size_t f = 0; f < star.faces.size(); ++f)
    quarters.push_back(4 * star.parts[f] + f % 4);
  model.humans = {star.parts, Labels(star.faces.size(), 7), quarters};
  return model;
}

// With the default weights, also after others have been tried.
void test_error(std::size_t arms, std::size_t number_of_segments)
{
  const Model model = star_model(arms, number_of_segments);
  const Cut_weights weights;
  Cut_weights others;
  others.segment_size = -2;
  Candidate_pool pool(model);
  check_errors(pool, model, weights);
  pool.errors(others);
  check_errors(pool, model, weights);
}

// Long cuts away from seams are no arms of a star.
void test_other_weights()
{
  const Model model = star_model(5, 6);
  Cut_weights weights;
  weights.concave_share = -6;
  weights.relative_length = 6;
  weights.widening = -2;
  Candidate_pool pool(model);
  CGAL_CHECK(pool.errors(weights).with_number > pool.errors(Cut_weights()).with_number);
  check_errors(pool, model, weights);
}

void test_components()
{
  Model model = star_model(3, 4);
  const Mesh other = model.mesh;
  model.number = 17;
  model.mesh += other;
  for (Labels& human : model.humans)
    human.resize(model.mesh.number_of_faces(), 1);
  CGAL_CHECK_THROWS_WITH(Candidate_pool{model}, std::invalid_argument, "model 17 is not connected");
}

} // namespace

int main()
{
  test_error(5, 6);
  test_error(5, 3);
  test_error(3, 40);
  test_other_weights();
  test_components();
  return check::result();
}
