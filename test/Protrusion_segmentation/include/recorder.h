// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor that keeps what it is told, and stops at a question of choice.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_RECORDER_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_RECORDER_H

#include "check.h"

#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_meshes {

template <typename FaceGraph>
struct Recorder : CGAL::Protrusion_segmentation::Segmentation_visitor<FaceGraph>
{
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;
  using Protrusion = CGAL::Protrusion_segmentation::Protrusion<face_descriptor>;

  void begin(const std::string& stage)
  {
    open.push_back(stage);
    ++stages[stage];
  }
  void end(const std::string& stage)
  {
    CHECK(!open.empty() && open.back() == stage);
    open.pop_back();
  }
  void on_reading_begin() override { begin("reading"); }
  void on_reading_end() override { end("reading"); }
  void on_preparation_begin() override { begin("preparation"); }
  void on_preparation_end() override { end("preparation"); }
  void on_tips_begin() override { begin("tips"); }
  void on_tips_end() override { end("tips"); }
  void on_borders_begin() override { begin("borders"); }
  void on_borders_end() override { end("borders"); }
  void on_labels_begin() override { begin("labels"); }
  void on_labels_end() override { end("labels"); }
  void on_progress(double share) override
  {
    CHECK(share >= 0 && share <= 1);
    shares.push_back(share);
  }
  bool go_further() override { return ++questions != stop_at; }
  void on_tip(face_descriptor face) override { tips.insert(face); }
  void on_protrusion(const Protrusion& protrusion) override { protrusions.push_back(protrusion); }
  void on_distances(std::size_t number_of_runs) override { runs += number_of_runs; }

  std::vector<std::string> open;
  std::map<std::string, int> stages;
  std::vector<double> shares;
  std::size_t questions = 0, stop_at = 0, runs = 0;
  std::set<face_descriptor> tips;
  std::vector<Protrusion> protrusions;
};

// All stages, each within another one or beside it, and a share that never falls and ends at 1.
template <typename FaceGraph>
void check_stages_and_progress(const Recorder<FaceGraph>& recorder)
{
  CHECK(recorder.open.empty());
  for (const char* stage : {"reading", "preparation", "tips", "borders", "labels"})
    CHECK_EQUAL(stage + std::string(recorder.stages.count(stage) > 0 ? "" : " is missing"), stage);
  CHECK(std::is_sorted(recorder.shares.begin(), recorder.shares.end()));
  CHECK_EQUAL(recorder.shares.back(), 1);
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_RECORDER_H
