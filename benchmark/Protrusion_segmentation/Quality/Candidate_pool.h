// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A model with all cuts that the default method has found in it so far. With other weights of the clues it is segmented
// again in milliseconds: the cuts get their values by these weights, and only new segments are searched.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CANDIDATE_POOL_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CANDIDATE_POOL_H

#include "Benchmark_folder.h"

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Beam_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Segment_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class Candidate_pool
{
public:
  using Cut_weights = CGAL::Protrusion_segmentation::internal::Cut_weights;

  // Throws `std::invalid_argument` if the mesh is not connected: between components cuts do not compete by their clues only.
  explicit Candidate_pool(const Model& model);
  Candidate_pool(const Candidate_pool&) = delete;
  Candidate_pool& operator=(const Candidate_pool&) = delete;

  const std::string& class_name() const { return m_class_name; }

  // The mean Rand index error against people's segmentations, with the number of segments of the model; borders stay
  // where they are on the coarse graph.
  double rand_index_error(const Cut_weights& weights);

private:
  using Index = CGAL::Protrusion_segmentation::Indexed_surface::Index;

  // Faces of one node that a human gave the same label.
  struct Share
  {
    std::size_t human, label;
    double faces;
  };

  void count_shares(const std::vector<Labels>& humans);
  void begin_again(const Cut_weights& weights);

  std::string m_class_name;
  std::size_t m_number_of_segments;
  CGAL::Protrusion_segmentation::internal::Canonical_surface m_surface;
  CGAL::Protrusion_segmentation::Execution m_execution;
  std::optional<CGAL::Protrusion_segmentation::internal::Any_distance> m_no_distance;
  CGAL::Protrusion_segmentation::internal::Cut_options m_options;
  CGAL::Protrusion_segmentation::internal::Graphs_of_surface m_graphs;
  CGAL::Protrusion_segmentation::internal::Segment_search m_search;
  // its memo has all searched segments
  std::unique_ptr<CGAL::Protrusion_segmentation::internal::Beam_search> m_beam;
  std::vector<std::vector<Share>> m_shares;          // of every node
  std::vector<std::vector<double>> m_faces_of_human; // of every human and label
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CANDIDATE_POOL_H
