// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/json.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace tool
{
namespace
{

using Json = nlohmann::ordered_json;

// Added one by one: the compiler takes many times as long for nested lists in braces.
class Object
{
public:
  template <typename T>
  Object& add(const char* key, const T& value)
  {
    add_json(key, Json(value));
    return *this;
  }

  template <typename T>
  Object& add_if(bool is_known, const char* key, const T& value)
  {
    add_json(key, is_known ? Json(value) : Json(nullptr));
    return *this;
  }

  Json take() { return std::move(m_json); }

private:
  void add_json(const char* key, Json value);

  Json m_json = Json::object();
};

void Object::add_json(const char* key, Json value) { m_json.emplace(key, std::move(value)); }

Json describe(const Protrusion& protrusion)
{
  Object object;
  object.add("segment", protrusion.segment)
      .add("parent", protrusion.parent)
      .add("tip", std::size_t(protrusion.tip))
      .add_if(protrusion.border_slot != Protrusion::no_slot(), "border_slot", protrusion.border_slot)
      .add("border_distance", protrusion.border_distance)
      .add("value", protrusion.value)
      .add("area", protrusion.area)
      .add("border_length", protrusion.border_length)
      .add("distance_histogram", protrusion.distance_histogram)
      .add("sectional_diameter_histogram", protrusion.sectional_diameter_histogram);
  return object.take();
}

Json describe(const Stage_record& stage)
{
  return Object().add("stage", stage.name).add("seconds", stage.seconds).take();
}

template <typename Range>
Json describe_all(const Range& range)
{
  Json array = Json::array();
  for (const auto& element : range)
    array.push_back(describe(element));
  return array;
}

Json describe_subtree(std::size_t segment, const std::vector<std::vector<std::size_t>>& children)
{
  Json array = Json::array();
  for (std::size_t child : children[segment])
    array.push_back(describe_subtree(child, children));
  return Object().add("segment", segment).add("children", array).take();
}

// The nested protrusions as a tree for each connected component, whose body is the root. The children
// are in the order in which their borders were chosen.
Json describe_hierarchy(const Segmentation& segmentation)
{
  const std::vector<Protrusion>& protrusions = segmentation.record.protrusions();
  std::vector<std::vector<std::size_t>> children(segmentation.number_of_segments);
  for (const Protrusion& protrusion : protrusions)
    children[protrusion.parent].push_back(protrusion.segment);
  Json roots = Json::array();
  for (std::size_t body = 0; body < segmentation.number_of_segments - protrusions.size(); ++body)
    roots.push_back(describe_subtree(body, children));
  return roots;
}

} // namespace

Json describe(const Findings& findings)
{
  const Segmentation_options& options = findings.options;
  const Segmentation& segmentation = findings.segmentation;
  const Recorder& record = segmentation.record;
  Object object;
  object.add("input", findings.input)
      .add("faces", segmentation.segment_ids.size())
      .add_if(options.number_of_segments.has_value(), "segments_requested",
              options.number_of_segments.value_or(0))
      .add("segments", segmentation.number_of_segments)
      .add_if(!findings.note.empty(), "note", findings.note)
      .add("method", options.method)
      .add_if(!options.distance.empty(), "distance", options.distance) // none: the method's own
      .add_if(options.distance == "landmark", "landmarks", options.landmarks)
      .add_if(options.distance == "diffusion", "eigenpairs", options.eigenpairs)
      .add_if(options.distance == "diffusion", "time", options.time)
      .add("seed", options.seed)
      .add("seconds", segmentation.seconds)
      .add("dijkstra_runs", record.number_of_runs())
      .add("tips_eliminated", record.number_of_eliminated_tips())
      .add("stages", describe_all(record.stages()))
      .add("protrusions", describe_all(record.protrusions()))
      .add("hierarchy", describe_hierarchy(segmentation));
  return object.take();
}

void write_json(std::ostream& out, const Findings& findings)
{
  // A name that is no UTF-8 must not keep the rest from being written.
  out << describe(findings).dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

} // namespace tool
