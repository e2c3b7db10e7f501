// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/read_tips.h"

#include "command_line/Error.h"
#include "reading/read_bytes.h"

#include <nlohmann/json.hpp>

namespace tool
{

std::vector<std::size_t> read_tips(const std::string& file)
{
  using Json = nlohmann::json;
  const Json content = Json::parse(read_bytes(file), nullptr, false);
  if (content.is_discarded())
    throw Error(file, "is no JSON");
  if (!content.is_object() || !content.contains("tips") || !content["tips"].is_array())
    throw Error(file, "has no array of tips, as in {\"tips\": [12, 345]}");
  if (content["tips"].empty())
    throw Error(file, "has no tips in it");
  std::vector<std::size_t> tips;
  for (const Json& tip : content["tips"])
  {
    if (!tip.is_number_unsigned())
      throw Error(file, "has a tip that is no number of a face: " + tip.dump());
    tips.push_back(tip.get<std::size_t>());
  }
  return tips;
}

} // namespace tool
