// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_TABLES_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_TABLES_H

#include "guarded_run.h"

#include <ostream>
#include <string>
#include <vector>

struct Run
{
  std::string method;
  std::string file;
  Outcome outcome;
};

// A line for each method.
void write_table(std::ostream& out, const std::vector<Run>& runs);

// A line for each run that is not valid.
void write_problems(std::ostream& out, const std::vector<Run>& runs);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_TABLES_H
