// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: no error

#include "mesh.h"

struct Visitor : Segmentation_visitor<Mesh>
{
  bool go_further() { return false; }
};

// What the others do wrong, done right: so they fail for nothing else.
std::size_t segment(const Mesh& mesh,
                    Segment_map ids,
                    const std::vector<Mesh::Face_index>& tips,
                    Mesh::Property_map<Mesh::Edge_index, bool> is_border)
{
  std::vector<Mesh::Face_index> found;
  CGAL::protrusion_tips(mesh, 5, std::back_inserter(found), Landmark_geodesic_distance());
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, 5,
                                                Histogram_method(Landmark_geodesic_distance()),
                                                CGAL::parameters::visitor(Visitor()).edge_is_constrained_map(is_border)) +
         CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, Minimum_cut_method()) +
         CGAL::protrusion_hierarchy(mesh, 5, Minimum_cut_method()).maximum_number_of_segments();
}
