// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_RECORDER_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_RECORDER_H

#include "reading/Mesh.h"

#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tool
{

using Protrusion = CGAL::Protrusion_segmentation::Protrusion<Face>;

struct Stage_record
{
  std::string name;
  double seconds = 0; // of nested stages only the innermost counts
};

// A visitor that keeps what it is told.
class Recorder : public CGAL::Protrusion_segmentation::Segmentation_visitor<Mesh>
{
public:
  // is called with the share that is done, the stage and the number of protrusions so far
  using Progress = std::function<void(double, const std::string&, std::size_t)>;

  explicit Recorder(Progress progress = {}) : m_progress(std::move(progress)) {}

  const std::vector<Protrusion>& protrusions() const { return m_protrusions; }
  const std::array<Stage_record, 5>& stages() const { return m_stages; }
  std::size_t number_of_specks() const { return m_number_of_specks; }
  std::size_t number_of_runs() const { return m_number_of_runs; }
  std::size_t number_of_eliminated_tips() const { return m_number_of_eliminated_tips; }

  void on_reading_begin() override { begin(0); }
  void on_reading_end() override { end(); }
  void on_preparation_begin() override { begin(1); }
  void on_preparation_end() override { end(); }
  void on_tips_begin() override { begin(2); }
  void on_tips_end() override { end(); }
  void on_borders_begin() override { begin(3); }
  void on_borders_end() override { end(); }
  void on_labels_begin() override { begin(4); }
  void on_labels_end() override { end(); }
  void on_progress(double share) override
  {
    m_share = share;
    show();
  }
  void on_specks(std::size_t number_of_specks) override { m_number_of_specks = number_of_specks; }
  void on_eliminated_tip(Face) override { ++m_number_of_eliminated_tips; }
  void on_protrusion(const Protrusion& protrusion) override
  {
    m_protrusions.push_back(protrusion);
    show();
  }
  // Runs are told when a segment or all is done, so they belong to no stage.
  void on_distances(std::size_t number_of_runs) override { m_number_of_runs += number_of_runs; }

private:
  using Clock = std::chrono::steady_clock;

  void begin(std::size_t stage)
  {
    stop_clock();
    m_running.push_back(stage);
    show();
  }
  void end()
  {
    stop_clock();
    m_running.pop_back();
  }
  // Books the time since the last call on the innermost stage.
  void stop_clock()
  {
    const Clock::time_point now = Clock::now();
    if (!m_running.empty())
      m_stages[m_running.back()].seconds +=
          std::chrono::duration<double>(now - m_last_time).count();
    m_last_time = now;
  }
  void show() const
  {
    if (m_progress)
      m_progress(m_share, m_running.empty() ? "" : m_stages[m_running.back()].name,
                 m_protrusions.size());
  }

  Progress m_progress;
  std::array<Stage_record, 5> m_stages = {{{"reading"}, {"preparation"}, {"tips"}, {"borders"}, {"labels"}}};
  std::vector<std::size_t> m_running; // stages, the innermost last
  Clock::time_point m_last_time;
  std::vector<Protrusion> m_protrusions;
  std::size_t m_number_of_runs = 0;
  std::size_t m_number_of_specks = 0;
  std::size_t m_number_of_eliminated_tips = 0;
  double m_share = 0;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_RECORDER_H
