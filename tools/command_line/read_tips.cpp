// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/read_tips.h"

#include "command_line/Error.h"
#include "reading/read_bytes.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace tool
{

namespace
{

using Json = nlohmann::ordered_json;

Json read_object(const std::string& file)
{
  const Json content = Json::parse(read_bytes(file), nullptr, false);
  if (content.is_discarded())
    throw Error(file, "is no JSON");
  return content.is_object() ? content : Json::object();
}

std::vector<std::size_t> tips_in(const Json& list, const std::string& file)
{
  if (!list.is_array())
    throw Error(file, "has no array of tips, as in {\"tips\": [12, 345]}");
  if (list.empty())
    throw Error(file, "has no tips in it");
  std::vector<std::size_t> tips;
  for (const Json& tip : list)
  {
    if (!tip.is_number_unsigned())
      throw Error(file, "has a tip that is no number of a face: " + tip.dump());
    tips.push_back(tip.get<std::size_t>());
  }
  return tips;
}

std::vector<Named_segment> names_in(const Json& list, const std::string& file)
{
  if (!list.is_array())
    throw Error(file, "has no array of names, as in {\"names\": [{\"face\": 12, \"name\": \"tail\"}]}");
  std::vector<Named_segment> names;
  for (const Json& entry : list)
  {
    Named_segment named;
    for (const auto& [key, number] : {std::pair("face", &named.face), std::pair("segment", &named.segment)})
      if (entry.is_object() && entry.contains(key) && entry[key].is_number_unsigned())
        *number = entry[key].get<std::size_t>();
    if (!(named.face || named.segment) || !entry.contains("name") || !entry["name"].is_string())
      throw Error(file, "has a name without text, face or segment: " + entry.dump());
    named.name = entry["name"].get<std::string>();
    names.push_back(named);
  }
  return names;
}

} // namespace

Picked_tips read_tips_and_names(const std::string& tips, const std::string& names)
{
  Picked_tips result;
  if (!tips.empty())
  {
    const Json content = read_object(tips);
    result = {tips_in(content.value("tips", Json()), tips), names_in(content.value("names", Json::array()), tips), tips};
  }
  if (!names.empty())
  {
    result.names = names_in(read_object(names).value("names", Json()), names);
    result.file_of_names = names;
  }
  return result;
}

} // namespace tool
