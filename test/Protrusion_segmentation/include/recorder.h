// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A record that keeps stages and shares, too, and stops at a question of choice.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_RECORDER_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_RECORDER_H

#include "check.h"

#include <CGAL/Protrusion_segmentation/Segmentation_record.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace test_meshes {

template <typename FaceGraph>
struct Recorder : CGAL::Protrusion_segmentation::Segmentation_record<FaceGraph>
{
  using Record = CGAL::Protrusion_segmentation::Segmentation_record<FaceGraph>;

  void begin(const std::string& stage)
  {
    open.push_back(stage);
    ++stages[stage];
  }
  void end(const std::string& stage)
  {
    CGAL_CHECK(!open.empty() && open.back() == stage);
    open.pop_back();
  }
  void on_reading_begin()
  {
    Record::on_reading_begin();
    begin("reading");
  }
  void on_reading_end() { end("reading"); }
  void on_preparation_begin() { begin("preparation"); }
  void on_preparation_end() { end("preparation"); }
  void on_tips_begin() { begin("tips"); }
  void on_tips_end() { end("tips"); }
  void on_borders_begin() { begin("borders"); }
  void on_borders_end() { end("borders"); }
  void on_labels_begin() { begin("labels"); }
  void on_labels_end() { end("labels"); }
  void on_progress(double share)
  {
    CGAL_CHECK(share >= 0 && share <= 1);
    shares.push_back(share);
  }
  bool go_further() { return ++questions != stop_at; }

  std::vector<std::string> open;
  std::map<std::string, int> stages;
  std::vector<double> shares;
  std::size_t questions = 0, stop_at = 0;
};

// All stages, each within another one or beside it, and a share that never falls and ends at 1.
template <typename FaceGraph>
void check_stages_and_progress(const Recorder<FaceGraph>& recorder)
{
  CGAL_CHECK(recorder.open.empty());
  for (const char* stage : {"reading", "preparation", "tips", "borders", "labels"})
    CGAL_CHECK_EQUAL(stage + std::string(recorder.stages.count(stage) > 0 ? "" : " is missing"), stage);
  CGAL_CHECK(std::is_sorted(recorder.shares.begin(), recorder.shares.end()));
  CGAL_CHECK_EQUAL(recorder.shares.back(), 1);
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_RECORDER_H
