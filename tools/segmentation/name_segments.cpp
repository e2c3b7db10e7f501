// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/name_segments.h"

#include "command_line/Error.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {
namespace {

// The name of a picked tip whose protrusion was not found is not that of the body.
bool is_tip_in_body(const Findings& findings, std::size_t face, std::size_t segment)
{
  if (!findings.options.tips)
    return false;
  const auto& tips = *findings.options.tips;
  const auto& protrusions = findings.segmentation.record.protrusions();
  return std::find(tips.begin(), tips.end(), face) != tips.end() &&
         std::none_of(protrusions.begin(), protrusions.end(),
                      [&](const Protrusion& protrusion) { return protrusion.segment == segment; });
}

} // namespace

void name_segments(Findings& findings, const Picked_tips& picked)
{
  if (picked.names.empty())
    return;
  const std::string& file = picked.file_of_names;
  findings.names.resize(findings.segmentation.number_of_segments);
  const std::vector<std::size_t> segment_of_face = labels_of_file(findings.segmentation.segment_ids,
                                                                  findings.mesh);
  for (const Named_segment& named : picked.names)
  {
    if (named.face && *named.face >= segment_of_face.size())
      throw Error(file, "names the segment of face " + std::to_string(*named.face) + ", but there are " +
                          std::to_string(segment_of_face.size()) + " faces");
    const std::size_t segment = named.face ? segment_of_face[*named.face] : *named.segment;
    if (segment >= findings.names.size())
      throw Error(file, "names segment " + std::to_string(segment) + ", but there are " +
                          std::to_string(findings.names.size()));
    if (named.face && is_tip_in_body(findings, *named.face, segment))
      continue;
    if (std::string& name = findings.names[segment]; !name.empty() && name != named.name)
      findings.add_note("segment " + std::to_string(segment) + " has two names; " + name + " is not used");
    findings.names[segment] = named.name;
  }
}

} // namespace tool
