// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes that show another mesh, or a part of it, without a copy.

#include "mesh_types.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/Seam_mesh.h>

namespace mesh_types {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// The body alone out of a mesh with a second component.
void a_filtered_graph_is_the_part_that_it_shows()
{
  const Mesh mesh = to_graph<Mesh>(merged({body(), translated(icosphere(2), {9, 0, 0})}));
  std::vector<Mesh::Face_index> shown;
  for (std::size_t f = 0; f < body().faces.size(); ++f)
    shown.emplace_back(static_cast<Mesh::size_type>(f));
  const CGAL::Face_filtered_graph<Mesh> part(mesh, shown);
  gives_the_same_labels(part);
}

using Seam_edges = Mesh::Property_map<Mesh::Edge_index, bool>;
using Seam_vertices = Mesh::Property_map<Mesh::Vertex_index, bool>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Seam_edges, Seam_vertices>;

void a_seam_mesh_without_seams_is_the_mesh()
{
  Mesh mesh = to_graph<Mesh>(body());
  const Seam_mesh seam_mesh(mesh, mesh.add_property_map<Mesh::Edge_index, bool>("", false).first,
                            mesh.add_property_map<Mesh::Vertex_index, bool>("", false).first);
  gives_the_same_labels(seam_mesh);
}

// A seam is a border: all around, it makes two components of one.
void a_seam_cuts_the_mesh()
{
  const Test_mesh soup = box();
  Mesh mesh = to_graph<Mesh>(soup);
  Seam_mesh seam_mesh(mesh, mesh.add_property_map<Mesh::Edge_index, bool>("", false).first,
                      mesh.add_property_map<Mesh::Vertex_index, bool>("", false).first);
  const Face& around = soup.faces[0];
  for (std::size_t i = 0; i < around.size(); ++i)
    CGAL_CHECK(seam_mesh.add_seam(Mesh::Vertex_index(Mesh::size_type(around[i])),
                             Mesh::Vertex_index(Mesh::size_type(around[(i + 1) % around.size()]))));
  const Segmentation found = default_segmentation(seam_mesh, 1);
  CGAL_CHECK_EQUAL(found.number, 2);
  CGAL_CHECK_EQUAL(std::count(found.labels.begin(), found.labels.end(), found.labels[0]), 1);
}

void test_views_of_meshes()
{
  a_filtered_graph_is_the_part_that_it_shows();
  a_seam_mesh_without_seams_is_the_mesh();
  a_seam_cuts_the_mesh();
}

} // namespace mesh_types
