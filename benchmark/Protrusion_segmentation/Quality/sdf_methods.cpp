// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sdf_methods.h"

#include "processor_seconds.h"

#include <CGAL/mesh_segmentation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

// The shape diameters of the last mesh on this thread. They take nearly all of the time and are the same for all
// settings; what the later ones save is counted for them too.
class Shape_diameters
{
public:
  static Shape_diameters& of(const Mesh& mesh)
  {
    thread_local Shape_diameters the_last;
    const std::vector<Point> points(mesh.points().begin(), mesh.points().end());
    the_last.m_is_reused = points == the_last.m_points &&
                           mesh.number_of_faces() == the_last.m_values.size();
    if (!the_last.m_is_reused)
      the_last.compute(mesh, points);
    return the_last;
  }

  const std::vector<double>& values() const { return m_values; }
  static double seconds_saved() { return the_seconds_saved(); }

  Labels segmentation(const Mesh& mesh, std::size_t number_of_clusters, double smoothness)
  {
    Labels labels(mesh.number_of_faces(), 0);
    CGAL::segmentation_from_sdf_values(mesh, CGAL::make_property_map(m_values),
                                       CGAL::make_property_map(labels), number_of_clusters, smoothness);
    the_seconds_saved() = m_is_reused ? m_seconds : 0;
    return labels;
  }

private:
  static double& the_seconds_saved()
  {
    thread_local double seconds = 0;
    return seconds;
  }

  void compute(const Mesh& mesh, const std::vector<Point>& points)
  {
    const double begin = processor_seconds();
    m_points = points;
    m_values.assign(mesh.number_of_faces(), 0.);
    CGAL::sdf_values(mesh, CGAL::make_property_map(m_values));
    // A face without area has none, and not a number would spread to all others.
    for (double& diameter : m_values)
      if (!std::isfinite(diameter))
        diameter = 0;
    m_seconds = processor_seconds() - begin;
  }

  std::vector<Point> m_points;
  std::vector<double> m_values;
  double m_seconds = 0;
  bool m_is_reused = false;
};

std::size_t number_of_segments(const Labels& labels)
{
  return *std::max_element(labels.begin(), labels.end()) + 1;
}

// Of two numbers of segments that are as far from `k`, the first that is found is taken: the least smoothing first,
// as shapes are left in one piece otherwise.
Labels segmentation_nearest_to(const Mesh& mesh, std::size_t k)
{
  constexpr std::size_t most_clusters =
    10; // at 10 and a smoothness of 0.26, two models in five are one segment
  Labels best;
  std::size_t least = (std::numeric_limits<std::size_t>::max)();
  Shape_diameters& diameters = Shape_diameters::of(mesh);
  for (const double smoothness : {0.1, 0.26, 0.5})
    for (std::size_t clusters = 2; clusters <= most_clusters; ++clusters)
    {
      Labels labels = diameters.segmentation(mesh, clusters, smoothness);
      const std::size_t number = number_of_segments(labels);
      const std::size_t difference = number > k ? number - k : k - number;
      if (difference >= least)
        continue;
      least = difference;
      best = std::move(labels);
    }
  return best;
}

Segmentation_method fixed(const std::string& name, std::size_t number_of_clusters, double smoothness)
{
  return {name,
          [=](const Mesh& mesh, std::size_t, unsigned int)
          { return Shape_diameters::of(mesh).segmentation(mesh, number_of_clusters, smoothness); },
          true, &Shape_diameters::seconds_saved};
}

} // namespace

std::vector<Segmentation_method> sdf_methods()
{
  return {fixed("SDF-5-0.26", 5, 0.26),
          fixed("SDF-3-0.1", 3, 0.1),
          {"SDF-k",
           [](const Mesh& mesh, std::size_t k, unsigned int) { return segmentation_nearest_to(mesh, k); },
           true, &Shape_diameters::seconds_saved}};
}
