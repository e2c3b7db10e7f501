// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stands for report.cpp where three.js was not found.

#include "report/report.h"

#include "command_line/Error.h"

namespace tool
{

bool can_write_report() { return false; }

void write_report(std::ostream&, const Findings&)
{
  throw Error("--report: this program was built without three.js");
}

} // namespace tool
