// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"

#include <CGAL/Real_timer.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <sstream>

namespace {

// A line of /proc/self/status in bytes, such as "VmRSS:"; 0 if there is none.
double status_bytes(const std::string& key)
{
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.compare(0, key.size(), key) == 0)
      return 1024 * std::stod(line.substr(key.size()));
  return 0;
}

// Gives freed memory back, so that it does not serve the next call unseen, and forgets the peak so far.
void reset_peak()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5;
}

void print_row(const std::vector<std::string>& cells)
{
  for (const std::string& cell : cells)
    std::cout << "| " << cell << " ";
  std::cout << "|" << std::endl;
}

} // namespace

double median(std::vector<double> values)
{
  if (values.empty())
    return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

double seconds_of(std::size_t repetitions, const std::function<void()>& call, Clock clock)
{
  std::vector<double> seconds;
  for (std::size_t i = 0; i < repetitions; ++i)
  {
    CGAL::Real_timer timer;
    timer.start();
    const std::clock_t begin = std::clock();
    call();
    const double processor = double(std::clock() - begin) / CLOCKS_PER_SEC;
    seconds.push_back(clock == Clock::WALL ? timer.time() : processor);
  }
  return median(seconds);
}

double peak_bytes_of(const std::function<void()>& call)
{
  reset_peak();
  const double before = status_bytes("VmRSS:");
  call();
  return (std::max)(0., status_bytes("VmHWM:") - before);
}

std::string number(double value, int digits)
{
  const int before_point = value > 0 ? int(std::floor(std::log10(value))) + 1 : 1;
  std::ostringstream out;
  out << std::fixed << std::setprecision((std::max)(0, digits - before_point)) << value;
  return out.str();
}

Markdown_table::Markdown_table(const std::vector<std::string>& header) : m_number_of_columns(header.size())
{
  print_row(header);
  print_row(std::vector<std::string>(header.size(), "---"));
}

void Markdown_table::row(std::vector<std::string> cells) const
{
  cells.resize(m_number_of_columns);
  print_row(cells);
}
