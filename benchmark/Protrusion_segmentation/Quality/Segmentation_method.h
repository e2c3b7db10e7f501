// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the benchmark measures: the one interface behind which methods of ours and peers stand.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENTATION_METHOD_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENTATION_METHOD_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// The kernel of CGAL's own examples: with another one its segmentation by shape diameters differs.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = boost::graph_traits<Mesh>::face_descriptor;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;
using Halfedge = boost::graph_traits<Mesh>::halfedge_descriptor;

// The segment of each face, by index of the face. The meshes have no removed faces.
using Labels = std::vector<std::size_t>;

// Labels as a property map.
inline auto label_map(const Labels& labels)
{
  return CGAL::make_property_map(labels);
}

struct Segmentation_method
{
  std::string name; // as the option --methods and the tables write it: no blanks, no commas
  std::function<Labels(const Mesh&, std::size_t number_of_segments, unsigned int seed)> segment;
  bool runs_by_default = true; // too slow for most of the benchmark's models otherwise
  // Seconds that the last call on this thread did not take because it used a result of another method's call; they
  // count as if it had taken them.
  std::function<double()> seconds_saved = []() { return 0.; };
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENTATION_METHOD_H
