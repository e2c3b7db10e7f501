// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the bar shows of the progress.

#include "check.h"
#include "command_line/Progress_bar.h"

#include <chrono>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

// What is written for a share each, after longer than the bar waits between two.
std::vector<std::string> lines_of(const std::vector<double>& shares, std::chrono::seconds patience)
{
  std::vector<std::string> lines;
  std::ostringstream out;
  std::streambuf* const before = std::cerr.rdbuf(out.rdbuf());
  {
    tool::Progress_bar bar(true, patience);
    for (const double share : shares)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
      bar.show(share, "stage");
      lines.push_back(out.str());
      out.str("");
    }
  }
  std::cerr.rdbuf(before);
  return lines;
}

bool has(const std::string& line, const std::string& text)
{
  return line.find(text) != std::string::npos;
}

int main()
{
  const std::vector<std::string> lines = lines_of({0, 0.5, 0.2, 0.7, 1}, std::chrono::seconds(0));
  CGAL_CHECK(has(lines[0], "] 0 %") && has(lines[0], "stage") && !has(lines[0], "left"));
  CGAL_CHECK(has(lines[1], "] 50 %") && has(lines[1], "about 0 s left"));
  CGAL_CHECK(has(lines[2], "] 50 %")); // it does not go back
  CGAL_CHECK(has(lines[3], "] 70 %"));
  CGAL_CHECK(has(lines[4], "] 99 %") && !has(lines[4], "left")); // something is left to be done
  for (const std::string& line : lines_of({0, 0.5}, std::chrono::seconds(60)))
    CGAL_CHECK(line.empty());
  return check::result();
}
