// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_RECORDER_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_RECORDER_H

#include "reading/Mesh.h"

#include <CGAL/Protrusion_segmentation/Segmentation_record.h>

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

// A record that takes the time of the stages, too, and shows the progress.
class Recorder : public CGAL::Protrusion_segmentation::Segmentation_record<Mesh>
{
public:
  // is called with the share that is done, the stage and the number of protrusions so far
  using Progress = std::function<void(double, const std::string&, std::size_t)>;

  explicit Recorder(Progress progress = {}) : m_progress(std::move(progress)) {}

  const std::array<Stage_record, 5>& stages() const { return m_stages; }

  void on_reading_begin()
  {
    Segmentation_record::on_reading_begin();
    begin(0);
  }
  void on_reading_end() { end(); }
  void on_preparation_begin() { begin(1); }
  void on_preparation_end() { end(); }
  void on_tips_begin() { begin(2); }
  void on_tips_end() { end(); }
  void on_borders_begin() { begin(3); }
  void on_borders_end() { end(); }
  void on_labels_begin() { begin(4); }
  void on_labels_end() { end(); }
  void on_progress(double share)
  {
    m_share = share;
    show();
  }
  void on_protrusion(const Protrusion& protrusion)
  {
    Segmentation_record::on_protrusion(protrusion);
    show();
  }

  // In place of those that it was told of.
  void set_protrusions(const std::vector<Protrusion>& protrusions)
  {
    Segmentation_record record;
    for (const Face tip : tips())
      record.on_tip(tip);
    for (std::size_t i = 0; i < number_of_eliminated_tips(); ++i)
      record.on_eliminated_tip(Face());
    record.on_small_components(number_of_small_components());
    record.on_distances(number_of_runs());
    for (const Protrusion& protrusion : protrusions)
      record.on_protrusion(protrusion);
    Segmentation_record::operator=(record);
  }

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
                 protrusions().size());
  }

  Progress m_progress;
  std::array<Stage_record, 5> m_stages = {{{"reading"}, {"preparation"}, {"tips"}, {"borders"}, {"labels"}}};
  std::vector<std::size_t> m_running; // stages, the innermost last
  Clock::time_point m_last_time;
  double m_share = 0;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_RECORDER_H
