// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scores of segmentations of one model against those of humans. The same values as
// `CGAL::Protrusion_segmentation::segmentation_metrics()`, but for the Rand index error, which is the one of the benchmark's program.
// What depends on a single segmentation is computed once, not for each pair: a model has a dozen human
// segmentations, and humans are compared to each other.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MODEL_EVALUATOR_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MODEL_EVALUATOR_H

#include "Benchmark_folder.h"
#include "Scores.h"

#include <CGAL/Protrusion_segmentation/internal/Metrics/overlap_errors.h>
#include <CGAL/segmentation_metrics.h>

#include <optional>
#include <vector>

class Model_evaluator
{
public:
  explicit Model_evaluator(const Model& model);

  // Means over all humans.
  Scores scores(const Labels& labels) const;

  // Means over all pairs of humans.
  Scores human_scores() const;

  // The human who agrees best with the others: the least mean Rand index error.
  std::size_t most_typical_human() const;

private:
  using Border = CGAL::Protrusion_segmentation::internal::Border;

  struct Segmentation
  {
    Labels numbers; // compact
    std::size_t number_of_segments;
    Border border;
  };

  Segmentation prepared(const Labels& labels) const;
  CGAL::Protrusion_segmentation::internal::Segment_overlap overlap_of(const Segmentation& a,
                                                                      const Segmentation& b) const;
  double rand_index_error(const CGAL::Protrusion_segmentation::internal::Segment_overlap& overlap) const;
  CGAL::Protrusion_segmentation::Segmentation_metrics metrics(const Segmentation& segmentation,
                                                              const Segmentation& reference) const;

  const Model& m_model;
  std::vector<double> m_face_areas;
  double m_radius;
  CGAL::Protrusion_segmentation::internal::Vertex_graph m_vertex_graph;
  std::vector<Segmentation> m_humans;
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MODEL_EVALUATOR_H
