// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_STOPWATCH_VISITOR_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_STOPWATCH_VISITOR_H

#include "Segmentation_method.h"

#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>

#include <cstddef>
#include <ctime>
#include <map>
#include <string>
#include <vector>

// How long a call goes on without asking whether to stop, in seconds of processor time: other load on the
// machine hardly matters. Stops the call after a limit.
class Stopwatch_visitor : public CGAL::Protrusion_segmentation::Segmentation_visitor<Mesh>
{
public:
  explicit Stopwatch_visitor(double limit) : m_limit(limit) {}

  void on_reading_begin() { begin_stage("reading"); }
  void on_reading_end() { end_stage(); }
  void on_preparation_begin() { begin_stage("preparation"); }
  void on_preparation_end() { end_stage(); }
  void on_tips_begin() { begin_stage("tips"); }
  void on_tips_end() { end_stage(); }
  void on_borders_begin() { begin_stage("borders"); }
  void on_borders_end() { end_stage(); }
  void on_labels_begin() { begin_stage("labels"); }
  void on_labels_end() { end_stage(); }

  bool go_further()
  {
    ++m_number_of_questions;
    end_gap();
    return seconds() < m_limit;
  }
  // to be called when the call has returned
  void end() { end_gap(); }

  double seconds() const { return m_last - m_begin; }
  std::size_t number_of_questions() const { return m_number_of_questions; }
  double longest_gap() const { return m_longest_gap; }
  const std::string& stage_of_longest_gap() const { return m_stage_of_longest_gap; }

private:
  static double now() { return double(std::clock()) / CLOCKS_PER_SEC; }

  void begin_stage(const std::string& stage)
  {
    pass_time();
    m_stages.push_back(stage);
  }
  void end_stage()
  {
    pass_time();
    m_stages.pop_back();
  }

  void pass_time()
  {
    const double time = now();
    m_gap[m_stages.back()] += time - m_last;
    m_last = time;
  }

  void end_gap()
  {
    pass_time();
    double gap = 0, longest_share = -1;
    std::string stage;
    for (const auto& share : m_gap)
    {
      gap += share.second;
      if (share.second > longest_share)
      {
        longest_share = share.second;
        stage = share.first;
      }
    }
    m_gap.clear();
    if (gap > m_longest_gap)
    {
      m_longest_gap = gap;
      m_stage_of_longest_gap = stage;
    }
  }

  double m_limit;
  double m_begin = now(), m_last = m_begin;
  std::size_t m_number_of_questions = 0;
  std::vector<std::string> m_stages = {"none"}; // the innermost last
  std::map<std::string, double> m_gap;          // since the last question, by stages
  double m_longest_gap = 0;
  std::string m_stage_of_longest_gap;
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_STOPWATCH_VISITOR_H
