// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/segment.h"

#include "command_line/number.h"
#include "repair/face_patch_map.h"
#include "segmentation/join_segments.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/protrusion_segmentation.h>

#include <boost/property_map/property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tool
{
namespace
{

namespace PS = CGAL::Protrusion_segmentation;

// Any method with its distance. A further one is one more line in a table below.
using Segment = std::function<std::size_t(const Mesh&, const std::vector<std::size_t>&, std::vector<std::size_t>&,
                                          const Segmentation_options&, Recorder&)>;

PS::Landmark_geodesic_distance landmark_distance(const std::string& landmarks)
{
  if (!landmarks.empty() && landmarks.back() == '%')
  {
    const auto percent = number<double>(landmarks.substr(0, landmarks.size() - 1));
    if (percent && *percent > 0 && *percent <= 100)
      return PS::Landmark_geodesic_distance(*percent / 100);
  }
  else if (const auto count = number<std::size_t>(landmarks); count && *count > 0)
    return PS::Landmark_geodesic_distance::with_number_of_landmarks(*count);
  throw std::invalid_argument("--landmarks: '" + landmarks +
                              "' is neither a number above 0 nor a share from above 0% to 100%");
}

// What is chosen by name, made from the options.
template <typename Made>
struct Entry
{
  Choice choice;
  Made make;
};

template <typename Concurrency_tag, typename Method>
std::size_t segment_by(const Method& method, const Mesh& mesh, const std::vector<std::size_t>& patches,
                       std::vector<std::size_t>& segment_ids, const Segmentation_options& options, Recorder& record)
{
  const auto ids = boost::make_iterator_property_map(segment_ids.begin(), get(boost::face_index, mesh));
  const auto np =
    CGAL::parameters::random_seed(options.seed).visitor(std::ref(record)).face_patch_map(face_patch_map(patches));
  if (options.tips)
  {
    std::vector<Face> tips;
    for (const std::size_t tip : *options.tips)
      tips.emplace_back(static_cast<Face::size_type>(tip));
    return CGAL::segmentation_from_protrusion_tips<Concurrency_tag>(mesh, tips, ids, method, np);
  }
  if (options.hierarchy)
    return CGAL::segmentation_via_protrusion_tips<Concurrency_tag>(mesh, ids, *options.hierarchy, method, np);
  return options.number_of_segments
             ? CGAL::segmentation_via_protrusion_tips<Concurrency_tag>(mesh, ids, *options.number_of_segments, method, np)
             : CGAL::segmentation_via_protrusion_tips<Concurrency_tag>(mesh, ids, method, np);
}

template <typename Method>
Segment segment_by(const Method& method)
{
  return [method](const Mesh& mesh, const std::vector<std::size_t>& patches, std::vector<std::size_t>& segment_ids,
                  const Segmentation_options& options, Recorder& record)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if (options.threads > 1)
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, options.threads);
      return segment_by<CGAL::Parallel_tag>(method, mesh, patches, segment_ids, options, record);
    }
#endif
    return segment_by<CGAL::Sequential_tag>(method, mesh, patches, segment_ids, options, record);
  };
}

// A method with a distance, or with its own.
template <typename Method>
struct Method_maker
{
  template <typename Distance>
  Segment operator()(const Distance& distance) const
  {
    return segment_by(Method(distance));
  }
  Segment operator()() const { return segment_by(Method()); }
};

template <typename Method>
Segment with_distance(const Segmentation_options& options)
{
  const Method_maker<Method> make;
  if (options.distance.empty())
    return make();
  if (options.distance == "geodesic")
    return make(PS::Geodesic_distance());
  if (options.distance == "landmark")
    return make(landmark_distance(options.landmarks));
  if (options.distance == "diffusion")
    return make(PS::Diffusion_distance(options.eigenpairs, options.time));
  if (options.distance == "heat")
    return make(PS::Heat_distance());
  return make(PS::Exact_geodesic_distance());
}

using Maker = std::function<Segment(const Segmentation_options&)>;

const std::vector<Entry<Maker>>& method_table()
{
  static const std::vector<Entry<Maker>> table = {
      {{"minimum-cut", "minimum cuts along concave seams", {}}, with_distance<PS::Minimum_cut_method>},
      {{"paper", "histograms of distances and of sectional diameters", {}}, with_distance<PS::Histogram_method>}};
  return table;
}

Segment make(const Segmentation_options& options)
{
  for (const Entry<Maker>& entry : method_table())
    if (entry.choice.name == options.method)
      return entry.make(options);
  throw std::invalid_argument("there is no '" + options.method + "'");
}

// Gives the last protrusions back to their parents, as `CGAL::Protrusion_segmentation::Segment_hierarchy` does.
void join_last_segments(Segmentation& segmentation, std::size_t number_of_segments)
{
  std::vector<bool> is_joined(segmentation.number_of_segments, false);
  const std::size_t least = segmentation.number_of_segments - segmentation.record.protrusions().size();
  for (std::size_t s = (std::max)(number_of_segments, least); s < is_joined.size(); ++s)
    is_joined[s] = true;
  join_segments(segmentation, is_joined);
}

} // namespace

std::size_t default_number_of_eigenpairs()
{
  return PS::Diffusion_distance::default_number_of_eigenpairs();
}

double default_diffusion_time() { return PS::Diffusion_distance::default_time(); }

std::vector<Choice> methods()
{
  std::vector<Choice> result;
  for (const Entry<Maker>& entry : method_table())
    result.push_back(entry.choice);
  return result;
}

std::vector<Choice> distances()
{
  return {{"geodesic", "shortest paths in the face dual graph", {}},
          {"landmark", "shortest paths by way of random landmarks", {"--landmarks"}},
          {"diffusion", "how differently random walks from two faces spread", {"--eigenpairs", "--time"}},
          {"heat", "paths over the faces, by the heat method", {}},
          {"exact", "exact paths over the faces; slow, for small meshes", {}}};
}

bool can_use_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  return true;
#else
  return false;
#endif
}

void check_options(const Segmentation_options& options)
{
  make(options);
  if (options.threads > 1 && !can_use_threads())
    throw std::invalid_argument("--threads: oneTBB was not found when this program was built, which has one thread");
}

Segmentation
segment(const Mesh& mesh,
        const std::vector<std::size_t>& patches,
        const Segmentation_options& options,
        const Recorder::Progress& progress)
{
  Segmentation result;
  result.record = Recorder(progress);
  result.segment_ids.resize(mesh.number_of_faces());
  const Segment run = make(options);
  const auto start = std::chrono::steady_clock::now();
  result.number_of_segments = run(mesh, patches, result.segment_ids, options, result.record);
  if (options.hierarchy)
    join_last_segments(result, *options.number_of_segments);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace tool
