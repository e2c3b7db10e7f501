// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Model_evaluator.h"
#include "rand_index_error_of_benchmark.h"


#include <algorithm>

namespace engine = CGAL::Protrusion_segmentation::internal;

Model_evaluator::Model_evaluator(const Model& model)
  : m_model(model),
    m_face_areas(engine::face_areas(model.mesh, model.mesh.points())),
    m_radius(engine::average_radius(engine::face_areas_and_centroids(model.mesh, model.mesh.points()))),
    m_vertex_graph(
      engine::vertex_graph(model.mesh, model.mesh.points(), get(boost::vertex_index, model.mesh)))
{
  for (const Labels& human : model.humans)
    m_humans.push_back(prepared(human));
}

Model_evaluator::Segmentation Model_evaluator::prepared(const Labels& labels) const
{
  Segmentation result;
  result.numbers = engine::compact_segment_ids(m_model.mesh, label_map(labels));
  result.number_of_segments = *std::max_element(result.numbers.begin(), result.numbers.end()) + 1;
  result.border.points = engine::border_vertices(m_model.mesh, label_map(labels),
                                                 get(boost::vertex_index, m_model.mesh));
  result.border.distances = engine::distances_to_border(m_vertex_graph, result.border.points);
  return result;
}

engine::Segment_overlap Model_evaluator::overlap_of(const Segmentation& a, const Segmentation& b) const
{
  return engine::Segment_overlap(a.numbers, b.numbers, m_face_areas);
}

// As the program of the benchmark divides, whose figures ours are compared with.
double Model_evaluator::rand_index_error(const engine::Segment_overlap& overlap) const
{
  return rand_index_error_of_benchmark(engine::rand_index_error(overlap), m_face_areas.size());
}

CGAL::Protrusion_segmentation::Segmentation_metrics
Model_evaluator::metrics(const Segmentation& segmentation, const Segmentation& reference) const
{
  const engine::Segment_overlap overlap = overlap_of(segmentation, reference);
  CGAL::Protrusion_segmentation::Segmentation_metrics result;
  result.rand_index_error = rand_index_error(overlap);
  result.hamming_distance = engine::hamming_distance(overlap);
  result.cut_discrepancy = engine::cut_discrepancy(segmentation.border, reference.border, m_radius);
  result.consistency_error = engine::consistency_error(overlap);
  return result;
}

Scores Model_evaluator::scores(const Labels& labels) const
{
  const Segmentation segmentation = prepared(labels);
  Mean_scores mean;
  for (const Segmentation& human : m_humans)
    mean.add(Scores(metrics(segmentation, human), segmentation.number_of_segments));
  return mean.value();
}

Scores Model_evaluator::human_scores() const
{
  Mean_scores mean;
  for (std::size_t i = 0; i < m_humans.size(); ++i)
    for (std::size_t j = i + 1; j < m_humans.size(); ++j)
      mean.add(Scores(metrics(m_humans[i], m_humans[j]), m_humans[i].number_of_segments));
  Scores result = mean.value();

  double segments = 0; // not weighted by the number of pairs that a human is the first of
  for (const Segmentation& human : m_humans)
    segments += double(human.number_of_segments);
  result[Score::segments] = segments / double(m_humans.size());
  return result;
}

std::size_t Model_evaluator::most_typical_human() const
{
  std::vector<double> errors(m_humans.size(), 0.);
  for (std::size_t i = 0; i < m_humans.size(); ++i)
    for (std::size_t j = i + 1; j < m_humans.size(); ++j)
    {
      const double error = rand_index_error(overlap_of(m_humans[i], m_humans[j]));
      errors[i] += error;
      errors[j] += error;
    }
  return std::size_t(std::min_element(errors.begin(), errors.end()) - errors.begin());
}
