// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same labels on every mesh type and with every kernel.

#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;

using Double_kernel = CGAL::Simple_cartesian<double>;
using Float_kernel = CGAL::Simple_cartesian<float>;
using Inexact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

// Coordinates that a float holds: the same with every kernel.
const Test_mesh& body()
{
  static const Test_mesh the_body = transformed(star(4, 2, 0.15, 0.04, 0.2), [](const Point& p)
  {
    return Point{float(p[0]), float(p[1]), float(p[2])};
  });
  return the_body;
}

const Labels& expected_labels()
{
  static const Labels labels =
    paper_segmentation(to_graph<CGAL::Surface_mesh<Double_kernel::Point_3>>(body()), 5).labels;
  return labels;
}

template <typename FaceGraph>
void gives_the_same_labels(const FaceGraph& mesh)
{
  const Segmentation found = paper_segmentation(mesh, 5);
  CHECK_EQUAL(found.number, 5);
  CHECK(found.labels == expected_labels());
}

template <typename FaceGraph>
void gives_the_same_labels()
{
  gives_the_same_labels(to_graph<FaceGraph>(body()));
}

// The ids of Polyhedron_items_with_id_3 may hold anything: they are not used.
void ids_of_a_polyhedron_may_be_unset()
{
  using Polyhedron = CGAL::Polyhedron_3<Double_kernel, CGAL::Polyhedron_items_with_id_3>;
  Polyhedron mesh = to_graph<Polyhedron>(body());
  gives_the_same_labels(mesh);
  for(auto f : faces(mesh))
    f->id() = 7;
  for(auto v : vertices(mesh))
    v->id() = 7;
  gives_the_same_labels(mesh);
}

// A map that is part of the mesh.
void property_maps_of_a_surface_mesh_take_the_labels()
{
  using Mesh = CGAL::Surface_mesh<Double_kernel::Point_3>;
  Mesh mesh = to_graph<Mesh>(body());
  auto ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment", 0).first;
  const Mesh& constant_mesh = mesh;
  CHECK_EQUAL(CGAL::segmentation_via_protrusion_tips(
                constant_mesh, ids, 5, CGAL::Protrusion_segmentation::Geodesic_distance(),
                CGAL::Protrusion_segmentation::Histogram_border()), 5);
  for(const auto f : faces(mesh))
    CHECK_EQUAL(ids[f], expected_labels()[std::size_t(f)]);
}

int main()
{
  gives_the_same_labels<CGAL::Surface_mesh<Double_kernel::Point_3>>();
  gives_the_same_labels<CGAL::Surface_mesh<Float_kernel::Point_3>>();
  gives_the_same_labels<CGAL::Surface_mesh<Inexact_kernel::Point_3>>();
  gives_the_same_labels<CGAL::Surface_mesh<Exact_kernel::Point_3>>();
  gives_the_same_labels<CGAL::Polyhedron_3<Double_kernel>>();
  gives_the_same_labels<CGAL::Polyhedron_3<Exact_kernel>>();
  ids_of_a_polyhedron_may_be_unset();
  property_maps_of_a_surface_mesh_take_the_labels();
  return check::result();
}
