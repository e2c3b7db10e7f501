// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One test for all mesh types: the same body gets the same labels by both methods.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_MESH_TYPES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_MESH_TYPES_H

#include "segmentations.h"
#include "test_mesh.h"

namespace mesh_types {

using namespace test_meshes;

constexpr std::size_t number_of_segments = 5;

// A ball with four arms, with coordinates that a float holds: the same with every kernel.
const Test_mesh& body();

// Of the faces of `body()` in their order, on the simplest mesh type.
const Labels& expected_paper_labels();
const Labels& expected_default_labels();

// With the default method.
template <typename FaceGraph>
Segmentation default_segmentation(const FaceGraph& mesh, std::size_t k)
{
  return checked(mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k); });
}

// The edges between two segments, as the function marks them and as the labels have them.
template <typename FaceGraph>
void marks_the_borders(const FaceGraph& mesh)
{
  const auto is_border = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  Segment_ids<FaceGraph> ids(mesh);
  CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), number_of_segments,
                                         CGAL::parameters::edge_is_constrained_map(is_border));
  for (const auto e : edges(mesh))
  {
    const auto f = face(halfedge(e, mesh), mesh), g = face(opposite(halfedge(e, mesh), mesh), mesh);
    CGAL_CHECK_EQUAL(get(is_border, e), get(ids.map(), f) != get(ids.map(), g));
  }
}

// `mesh` holds `body()` with its faces in their order.
template <typename FaceGraph>
void gives_the_same_labels(const FaceGraph& mesh)
{
  const Segmentation of_paper = paper_segmentation(mesh, number_of_segments);
  CGAL_CHECK_EQUAL(of_paper.number, number_of_segments);
  CGAL_CHECK(of_paper.labels == expected_paper_labels());
  const Segmentation by_default = default_segmentation(mesh, number_of_segments);
  CGAL_CHECK_EQUAL(by_default.number, number_of_segments);
  CGAL_CHECK(by_default.labels == expected_default_labels());
  marks_the_borders(mesh);
}

template <typename FaceGraph>
void gives_the_same_labels()
{
  gives_the_same_labels(to_graph<FaceGraph>(body()));
}

// One translation unit each: so many mesh types in one would take gigabytes to compile.
void test_surface_meshes();
void test_polyhedra();
void test_linear_cell_complex();
void test_views_of_meshes();
void test_openmesh();

} // namespace mesh_types

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_MESH_TYPES_H
