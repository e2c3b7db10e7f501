// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stands for report.cpp where three.js was not found.

#include "report.h"

namespace tool
{

bool can_write_report() { return false; }

void write_report(std::ostream&, nlohmann::ordered_json, const Mesh&, const std::vector<std::size_t>&)
{
  throw Error("--report: this program was built without three.js");
}

} // namespace tool
