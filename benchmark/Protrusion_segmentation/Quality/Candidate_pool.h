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
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Greedy_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_search.h>
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
  // `folder`: number of the folder that it comes from
  explicit Candidate_pool(const Model& model, std::size_t folder = 0);
  Candidate_pool(const Candidate_pool&) = delete;
  Candidate_pool& operator=(const Candidate_pool&) = delete;

  const std::string& class_name() const { return m_class_name; }
  std::size_t folder() const { return m_folder; }
  bool has_known_parts() const { return m_faces_of_human.size() == 1; } // people's segmentations come in numbers

  // Mean Rand index errors against people's segmentations; borders stay where they are on the coarse graph.
  struct Errors
  {
    double with_number, automatic;
    bool is_number_found; // without it
  };
  Errors errors(const Cut_weights& weights);

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
  double rand_index_error(std::size_t number_of_segments);

  std::string m_class_name;
  std::size_t m_folder, m_number_of_segments;
  CGAL::Protrusion_segmentation::internal::Canonical_surface m_surface;
  CGAL::Protrusion_segmentation::Execution m_execution;
  std::optional<CGAL::Protrusion_segmentation::internal::Any_distance> m_no_distance;
  CGAL::Protrusion_segmentation::internal::Cut_options m_options;
  CGAL::Protrusion_segmentation::internal::Graphs_of_surface m_graphs;
  CGAL::Protrusion_segmentation::internal::Segment_search m_search;
  // its memo has all searched segments
  std::unique_ptr<CGAL::Protrusion_segmentation::internal::Greedy_search> m_greedy;
  std::vector<std::vector<Share>> m_shares;          // of every node
  std::vector<std::vector<double>> m_faces_of_human; // of every human and label
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CANDIDATE_POOL_H
