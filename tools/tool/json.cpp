// SPDX-License-Identifier: GPL-3.0-or-later

#include "json.h"

namespace tool
{
namespace
{

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(bool is_set, const T& value)
{
  return is_set ? Json(value) : Json(nullptr);
}

Json describe(const Protrusion& protrusion)
{
  return {{"segment", protrusion.segment},
          {"parent", protrusion.parent},
          {"tip", protrusion.tip},
          {"border_slot",
           or_null(protrusion.border_slot != Protrusion::no_slot(), protrusion.border_slot)},
          {"border_distance", protrusion.border_distance},
          {"score", protrusion.score},
          {"area", protrusion.area},
          {"border_length", protrusion.border_length},
          {"distance_histogram", protrusion.distance_histogram},
          {"sectional_diameter_histogram", protrusion.sectional_diameter_histogram}};
}

Json describe(const Stage_record& stage)
{
  return {{"stage", stage.name}, {"seconds", stage.seconds}};
}

template <typename Range>
Json describe_all(const Range& range)
{
  Json array = Json::array();
  for (const auto& element : range)
    array.push_back(describe(element));
  return array;
}

// The nested protrusions as a tree for each connected component, whose body is the root. The children
// are in the order in which they were cut off; a parent has a lower number than its children.
Json describe_hierarchy(const Segmentation& segmentation)
{
  std::vector<Json> nodes;
  for (std::size_t s = 0; s < segmentation.number_of_segments; ++s)
    nodes.push_back({{"segment", s}, {"children", Json::array()}});
  const std::vector<Protrusion>& protrusions = segmentation.record.protrusions();
  for (auto protrusion = protrusions.rbegin(); protrusion != protrusions.rend(); ++protrusion)
  {
    Json& siblings = nodes.at(protrusion->parent)["children"];
    siblings.insert(siblings.begin(), std::move(nodes.at(protrusion->segment)));
  }
  nodes.resize(nodes.size() - protrusions.size());
  return nodes;
}

} // namespace

Json describe(const std::string& input,
              const Segmentation_options& options,
              const Segmentation& segmentation,
              const std::string& note)
{
  const Recorder& record = segmentation.record;
  return Json{{"input", input},
                     {"faces", segmentation.segment_ids.size()},
                     {"segments_requested", or_null(options.number_of_segments.has_value(),
                                                    options.number_of_segments.value_or(0))},
                     {"segments", segmentation.number_of_segments},
                     {"note", or_null(!note.empty(), note)},
                     {"method", options.method},
                     {"distance", options.distance},
                     {"landmarks", or_null(options.distance == "landmark", options.landmarks)},
                     {"eigenpairs", or_null(options.distance == "diffusion", options.eigenpairs)},
                     {"time", or_null(options.distance == "diffusion", options.time)},
                     {"seed", options.seed},
                     {"seconds", segmentation.seconds},
                     {"dijkstra_runs", record.number_of_runs()},
                     {"tips_eliminated", record.number_of_eliminated_tips()},
                     {"stages", describe_all(record.stages())},
                     {"protrusions", describe_all(record.protrusions())},
                     {"hierarchy", describe_hierarchy(segmentation)}};
}

void write_json(std::ostream& out, const Json& record)
{
  // A name that is no UTF-8 must not keep the rest from being written.
  out << record.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

} // namespace tool
