// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/segment.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/protrusion_segmentation.h>

#include <boost/property_map/property_map.hpp>

#include <charconv>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <variant>

namespace tool
{
namespace
{

namespace PS = CGAL::Protrusion_segmentation;

// A further method or distance is one more alternative here and one more line in a table below.
using Border = std::variant<PS::Minimum_cut_method, PS::Histogram_method>;
using Distance = std::variant<PS::Geodesic_distance, PS::Landmark_geodesic_distance,
                              PS::Diffusion_distance, PS::Heat_distance, PS::Exact_geodesic_distance>;

template <typename T>
std::optional<T> parse(const std::string& text)
{
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_parsed = error == std::errc() && end == text.data() + text.size();
  return is_parsed ? std::optional<T>(value) : std::nullopt;
}

PS::Landmark_geodesic_distance landmark_distance(const std::string& landmarks)
{
  if (!landmarks.empty() && landmarks.back() == '%')
  {
    const auto percent = parse<double>(landmarks.substr(0, landmarks.size() - 1));
    if (percent && *percent > 0 && *percent <= 100)
      return PS::Landmark_geodesic_distance(*percent / 100);
  }
  else if (const auto number = parse<std::size_t>(landmarks); number && *number > 0)
    return PS::Landmark_geodesic_distance::with_number_of_landmarks(*number);
  throw std::invalid_argument("--landmarks: '" + landmarks +
                              "' is neither a number above 0 nor a share from above 0% to 100%");
}

template <typename Strategy>
struct Entry
{
  Choice choice;
  std::function<Strategy(const Segmentation_options&)> make;
};

const std::vector<Entry<Border>>& border_table()
{
  static const std::vector<Entry<Border>> table = {
      {{"minimum-cut", "minimum cuts along concave seams", {}},
       [](const Segmentation_options&) { return PS::Minimum_cut_method(); }},
      {{"paper", "histograms of distances and of sectional diameters", {}},
       [](const Segmentation_options&) { return PS::Histogram_method(); }}};
  return table;
}

const std::vector<Entry<Distance>>& distance_table()
{
  static const std::vector<Entry<Distance>> table = {
      {{"geodesic", "shortest paths in the face dual graph", {}},
       [](const Segmentation_options&) { return PS::Geodesic_distance(); }},
      {{"landmark", "the same by way of random landmarks", {"--landmarks"}},
       [](const Segmentation_options& options) { return landmark_distance(options.landmarks); }},
      {{"diffusion", "how differently random walks spread", {"--eigenpairs", "--time"}},
       [](const Segmentation_options& options)
       { return PS::Diffusion_distance(options.eigenpairs, options.time); }},
      {{"heat", "over the faces, by the heat method", {}},
       [](const Segmentation_options&) { return PS::Heat_distance(); }},
      {{"exact", "over the faces, exactly; slow, for small meshes", {}},
       [](const Segmentation_options&) { return PS::Exact_geodesic_distance(); }}};
  return table;
}

template <typename Strategy>
std::vector<Choice> choices(const std::vector<Entry<Strategy>>& table)
{
  std::vector<Choice> result;
  for (const Entry<Strategy>& entry : table)
    result.push_back(entry.choice);
  return result;
}

template <typename Strategy>
Strategy make(const std::vector<Entry<Strategy>>& table,
              const std::string& name,
              const Segmentation_options& options)
{
  for (const Entry<Strategy>& entry : table)
    if (entry.choice.name == name)
      return entry.make(options);
  throw std::invalid_argument("there is no '" + name + "'");
}

} // namespace

std::size_t default_number_of_eigenpairs()
{
  return PS::Diffusion_distance::default_number_of_eigenpairs();
}

double default_diffusion_time() { return PS::Diffusion_distance::default_time(); }

std::vector<Choice> methods() { return choices(border_table()); }
std::vector<Choice> distances() { return choices(distance_table()); }

void check_options(const Segmentation_options& options)
{
  make(border_table(), options.method, options);
  make(distance_table(), options.distance, options);
}

Segmentation
segment(const Mesh& mesh, const Segmentation_options& options, const Recorder::Progress& progress)
{
  Segmentation result;
  result.record = Recorder(progress);
  result.segment_ids.resize(mesh.number_of_faces());
  const auto ids =
      boost::make_iterator_property_map(result.segment_ids.begin(), get(boost::face_index, mesh));
  const auto run = [&](const auto& border, const auto& distance)
  {
    const auto np = CGAL::parameters::random_seed(options.seed).visitor(std::ref(result.record));
    return options.number_of_segments
               ? CGAL::segmentation_via_protrusion_tips(mesh, ids, *options.number_of_segments,
                                                        distance, border, np)
               : CGAL::segmentation_via_protrusion_tips(mesh, ids, distance, border, np);
  };
  const Border border = make(border_table(), options.method, options);
  const Distance distance = make(distance_table(), options.distance, options);

  const auto start = std::chrono::steady_clock::now();
  result.number_of_segments = std::visit(run, border, distance);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace tool
