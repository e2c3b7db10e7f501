// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks that the other tests and the benchmarks rely on find what they are for.

#include "check.h"
#include "test_meshes.h"
#include "validation.h"


#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using validation::problem_with_segmentation;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// The problem of labels given in the order of the faces; empty if there is none.
template <typename FaceGraph>
std::string problem(const FaceGraph& mesh, const std::vector<int>& labels, std::size_t number)
{
  std::map<typename boost::graph_traits<FaceGraph>::face_descriptor, int> ids;
  std::size_t i = 0;
  for (const auto f : faces(mesh))
    ids[f] = labels.at(i++);
  return problem_with_segmentation(mesh, boost::make_assoc_property_map(ids), number).value_or("");
}

template <typename FaceGraph>
void finds_each_problem()
{
  const FaceGraph mesh = to_graph<FaceGraph>(sheet(3, 2));
  CGAL_CHECK_EQUAL(problem(mesh, {0, 0, 0, 0, 0, 0}, 1), "");
  CGAL_CHECK_EQUAL(problem(mesh, {0, 0, 1, 2, 2, 1}, 3), "");
  CGAL_CHECK_EQUAL(problem(mesh, {5, 4, 3, 2, 1, 0}, 6), "");
  CGAL_CHECK_EQUAL(problem(mesh, {0, 0, 1, 0, 3, 1}, 3), "face 4 has segment 3, but there are 3 segments");
  CGAL_CHECK(problem(mesh, {0, 0, -1, 0, 0, 0}, 1).find("face 2 has segment") == 0);
  CGAL_CHECK_EQUAL(problem(mesh, {0, 0, 0, 0, 0, 0}, 0), "face 0 has segment 0, but there are 0 segments");
  CGAL_CHECK_EQUAL(problem(mesh, {0, 0, 2, 0, 2, 2}, 3), "segment 1 of 3 has no face");
  CGAL_CHECK_EQUAL(problem(mesh, {0, 0, 0, 0, 0, 0}, 2), "segment 1 of 2 has no face");
  // a common corner does not connect
  CGAL_CHECK_EQUAL(problem(mesh, {0, 1, 1, 2, 0, 1}, 3),
              "segment 0 is not connected: faces 0 and 4 are in different pieces");
  CGAL_CHECK_EQUAL(problem(FaceGraph(), {}, 0), "");
  CGAL_CHECK_EQUAL(problem(FaceGraph(), {}, 1), "segment 0 of 1 has no face");
}

void components_cannot_share_a_segment()
{
  const auto mesh = to_graph<Surface_mesh>(
    merged({single_triangle(), translated(single_triangle(), {2, 0, 0})}));
  CGAL_CHECK_EQUAL(problem(mesh, {0, 1}, 2), "");
  CGAL_CHECK_EQUAL(problem(mesh, {0, 0}, 1),
              "segment 0 is not connected: faces 0 and 1 are in different pieces");
}

void removed_faces_are_left_out()
{
  auto mesh = to_graph<Surface_mesh>(sheet(3, 1));
  CGAL::Euler::remove_face(halfedge(Surface_mesh::Face_index(1), mesh), mesh);
  CGAL_CHECK_EQUAL(problem(mesh, {0, 1}, 2), "");
  CGAL_CHECK(problem(mesh, {0, 0}, 1) != "");
}

int main()
{
  finds_each_problem<Surface_mesh>();
  finds_each_problem<Polyhedron>();
  components_cannot_share_a_segment();
  removed_faces_are_left_out();
  return check::result();
}
