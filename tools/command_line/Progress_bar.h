// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_PROGRESS_BAR_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_PROGRESS_BAR_H

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace tool
{

inline bool is_standard_error_a_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// One line on the standard error that is written over and over, and is gone in the end. What is done before
// anybody grows impatient shows none. It never goes back, and never says that all is done.
class Progress_bar
{
public:
  explicit Progress_bar(bool is_shown, std::chrono::seconds patience = std::chrono::seconds(2))
    : m_is_shown(is_shown), m_patience(patience), m_start(Clock::now())
  {}
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;
  ~Progress_bar() { clear(); }

  // `share` of the work is done, in [0, 1]
  void show(double share, const std::string& text)
  {
    const Clock::time_point now = Clock::now();
    const bool is_due = now - m_last_time > std::chrono::milliseconds(50) && now - m_start > m_patience;
    if (!m_is_shown || !is_due)
      return;
    m_last_time = now;
    m_share = std::clamp(share, m_share, most);
    const std::size_t filled = static_cast<std::size_t>(std::lround(m_share * width));
    const std::string line = "[" + std::string(filled, '#') + std::string(width - filled, ' ') +
                             "] " + std::to_string(std::lround(100 * m_share)) + " %  " + estimate(now) + text;
    overwrite(line);
  }

  void clear()
  {
    if (m_line_length > 0)
    {
      overwrite("");
      std::cerr << '\r' << std::flush;
    }
  }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::size_t width = 30;
  static constexpr double most = .99;

  // Of the time that is left, as if the rest took as long as what is done.
  std::string estimate(Clock::time_point now) const
  {
    constexpr double enough = .02; // of the work, to estimate from
    if (m_share < enough || m_share >= most)
      return "";
    const double elapsed = std::chrono::duration<double>(now - m_start).count();
    return "about " + std::to_string(std::lround(elapsed * (1 - m_share) / m_share)) + " s left  ";
  }

  void overwrite(const std::string& line)
  {
    const std::size_t rest = m_line_length > line.size() ? m_line_length - line.size() : 0;
    std::cerr << '\r' << line << std::string(rest, ' ') << std::flush;
    m_line_length = line.size();
  }

  bool m_is_shown;
  std::chrono::seconds m_patience;
  double m_share = 0;
  std::size_t m_line_length = 0;
  Clock::time_point m_start;
  Clock::time_point m_last_time;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_PROGRESS_BAR_H
