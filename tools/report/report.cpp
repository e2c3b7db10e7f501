// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/report.h"

#include "report/report_data.h"
#include "report_page.h"

#include <cstddef>
#include <string>

namespace tool
{
namespace
{

// No text in a page may look like the end of a script.
std::string without_tags(std::string json)
{
  for (std::size_t i = json.find('<'); i != std::string::npos; i = json.find('<', i))
    json.replace(i, 1, "\\u003c");
  return json;
}

template <std::size_t n>
void write(std::ostream& out, const char* const (&pieces)[n])
{
  for (const char* piece : pieces)
    out << piece;
}

} // namespace

bool can_write_report() { return true; }

void write_report(std::ostream& out, const Findings& findings)
{
  write(out, report_page_begin);
  out << without_tags(report_data(findings));
  write(out, report_page_end);
}

} // namespace tool
