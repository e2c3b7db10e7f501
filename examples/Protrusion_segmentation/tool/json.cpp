// SPDX-License-Identifier: GPL-3.0-or-later

#include "json.h"

#include <nlohmann/json.hpp>

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
  return {{"stage", stage.name}, {"seconds", stage.seconds}, {"dijkstra_runs", stage.runs}};
}

template <typename Range>
Json describe_all(const Range& range)
{
  Json array = Json::array();
  for (const auto& element : range)
    array.push_back(describe(element));
  return array;
}

} // namespace

void write_json(std::ostream& out,
                const std::string& input,
                const Segmentation_options& options,
                const Segmentation& segmentation,
                const std::string& note)
{
  const Recorder& record = segmentation.record;
  const Json json = {{"input", input},
                     {"faces", segmentation.segment_ids.size()},
                     {"segments_requested", or_null(options.number_of_segments.has_value(),
                                                    options.number_of_segments.value_or(0))},
                     {"segments", segmentation.number_of_segments},
                     {"note", or_null(!note.empty(), note)},
                     {"method", options.method},
                     {"distance", options.distance},
                     {"landmarks", or_null(options.distance == "landmark", options.landmarks)},
                     {"seed", options.seed},
                     {"seconds", segmentation.seconds},
                     {"dijkstra_runs", record.number_of_runs()},
                     {"tips_eliminated", record.number_of_eliminated_tips()},
                     {"stages", describe_all(record.stages())},
                     {"protrusions", describe_all(record.protrusions())}};
  // A name that is no UTF-8 must not keep the rest from being written.
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

} // namespace tool
