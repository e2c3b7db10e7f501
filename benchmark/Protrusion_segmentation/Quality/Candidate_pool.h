// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A model with all cuts that the default method has found in it so far. With other weights of the clues it is segmented
// again in milliseconds: cuts are valued anew, and only segments that have not come up before are searched.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CANDIDATE_POOL_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CANDIDATE_POOL_H

#include "Benchmark_folder.h"

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class Candidate_pool
{
public:
  using Cut_policy = CGAL::Protrusion_segmentation::internal::Cut_policy;

  // The policy must outlive the object and may change how it weighs clues meanwhile. Throws `std::invalid_argument` if the
  // mesh is not connected: between components cuts do not compete by their clues only.
  Candidate_pool(const Model& model, const Cut_policy& policy);
  Candidate_pool(const Candidate_pool&) = delete;
  Candidate_pool& operator=(const Candidate_pool&) = delete;

  const std::string& class_name() const { return m_class_name; }

  // The mean Rand index error against people's segmentations, by the policy as it is now, with the number of segments of
  // the model; borders stay where they are on the coarse graph.
  double rand_index_error();

private:
  using Index = CGAL::Protrusion_segmentation::Indexed_surface::Index;

  // Faces of one node that a human gave the same label.
  struct Share
  {
    std::size_t human, label;
    double faces;
  };

  void count_shares(const std::vector<Labels>& humans);

  std::string m_class_name;
  std::size_t m_number_of_segments;
  CGAL::Protrusion_segmentation::internal::Canonical_surface m_surface;
  CGAL::Protrusion_segmentation::Execution m_execution;
  std::optional<CGAL::Protrusion_segmentation::internal::Any_distance> m_no_distance;
  CGAL::Protrusion_segmentation::internal::Component_cuts m_cuts;
  std::vector<std::vector<Share>> m_shares;                // of every node
  std::vector<std::vector<double>> m_faces_of_human; // of every human and label
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CANDIDATE_POOL_H
