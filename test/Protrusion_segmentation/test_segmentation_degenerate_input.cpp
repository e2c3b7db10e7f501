// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever a mesh holds, the result is a valid segmentation or an exception that says why.

#include "awkward_meshes.h"
#include "optional_distances.h"
#include "segmentations.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// Valid for numbers of segments from one to all faces and without a number, and from tips.
template <typename Method>
void check_method(const Mesh& mesh, const std::vector<Mesh::Face_index>& tips, const Method& method)
{
  const std::size_t n = mesh.number_of_faces();
  std::set<std::size_t> numbers = {1, 2, 5, 20};
  if (n <= 100)
    numbers.insert(n);
  for (const std::size_t k : numbers)
    if (k > 0 && k <= n)
    {
      const Segmentation found = checked(
        mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, method); });
      CGAL_CHECK(found.number >= 1);
    }
  const Segmentation found = checked(
    mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, method); });
  CGAL_CHECK_EQUAL(found.number > 0, n > 0);

  const Segmentation from_tips = checked(
    mesh, [&](auto ids) { return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, method); });
  CGAL_CHECK_EQUAL(from_tips.number > 0, n > 0);
}

template <typename Distance>
std::vector<Mesh::Face_index> tips_of(const Mesh& mesh, const Distance& distance)
{
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, std::min<std::size_t>(4, mesh.number_of_faces()), std::back_inserter(tips),
                        distance);
  return tips;
}

void check_valid(const Mesh& mesh)
{
  const auto check_both = [&](const auto& distance)
  {
    const std::vector<Mesh::Face_index> tips = tips_of(mesh, distance);
    check_method(mesh, tips, Minimum_cut_method(distance));
    check_method(mesh, tips, Histogram_method(distance));
  };
  check_both(Geodesic_distance());
  check_both(Landmark_geodesic_distance());
  with_diffusion_distance(check_both);
  const std::vector<Mesh::Face_index> tips = tips_of(mesh, Geodesic_distance());
  check_method(mesh, tips, Minimum_cut_method());
  check_method(mesh, tips, Histogram_method().uses_candidate_intervals(false).minimum_prominence(1e-6));
}

void awkward_meshes_have_valid_segmentations()
{
  for (const Awkward_mesh& awkward : awkward_meshes())
  {
    const std::size_t failures = check::counters().failures;
    check_valid(to_graph<Mesh>(awkward.mesh));
    if (check::counters().failures > failures)
      std::cerr << "that was: " << awkward.name << std::endl;
  }
}

// Without faces there is nothing to segment, whatever vertices there are.
void a_mesh_without_faces_has_no_segments()
{
  check_valid(Mesh());
  Mesh vertices;
  vertices.add_vertex({1, 2, 3});
  check_valid(vertices);
  Segment_ids<Mesh> ids(vertices);
  CGAL_CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(vertices, ids.map(), 1), std::invalid_argument,
                    "number_of_segments is 1, but it must be from 1 to 0, the number of faces of pmesh");
}

void isolated_vertices_and_removed_faces()
{
  Test_mesh soup = bumpy_sphere(2, 8);
  soup.add_point({100, 0, 0});
  soup.add_point({std::nan(""), 0, 0});
  Mesh mesh = to_graph<Mesh>(soup);
  check_valid(mesh);
  for (unsigned int f = 0; f < 120; f += 3)
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(f), mesh), mesh);
  CGAL_CHECK(mesh.has_garbage());
  check_valid(mesh);
}

// Where nothing sticks out, there is one segment if no number asks for more.
void bodies_without_protrusions_are_one_segment()
{
  const std::set<std::string> smooth = {"sphere", "flat sheet", "coarse sphere"};
  for (const Awkward_mesh& body : bodies_without_protrusions())
    if (smooth.count(body.name) > 0)
    {
      const Mesh mesh = to_graph<Mesh>(body.mesh);
      const Segmentation found = checked(mesh, [&](auto ids)
                                         { return CGAL::segmentation_via_protrusion_tips(mesh, ids); });
      CGAL_CHECK_EQUAL(body.name + ": " + std::to_string(found.number), body.name + ": 1");
    }
}

// The segments do not depend on whether the normals point outward.
void orientation_does_not_matter()
{
  const Test_mesh soup = star(4, 1, 0.15, 0.04, 0.2);
  for (const bool reversed : {false, true})
  {
    const Mesh mesh = to_graph<Mesh>(reversed ? with_reversed_orientation(soup) : soup);
    const Segmentation found = checked(mesh, [&](auto ids)
                                       { return CGAL::segmentation_via_protrusion_tips(mesh, ids, 5); });
    CGAL_CHECK_EQUAL(found.number, 5);
    CGAL_CHECK(share_in_true_parts(soup, found.labels) > 0.95);
    CGAL_CHECK(share_in_true_parts(soup, paper_segmentation(mesh, 5).labels) > 0.9);
  }
}

template <typename Number>
void check_not_finite(const Number& bad)
{
  using Kernel = CGAL::Simple_cartesian<Number>;
  using Bad_mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Bad_mesh mesh = to_graph<Bad_mesh>(icosphere(2));
  mesh.point(typename Bad_mesh::Vertex_index(20)) = {1, bad, 0};
  Segment_ids<Bad_mesh> ids(mesh);
  CGAL_CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), 3), std::invalid_argument,
                    "vertex 20 has a coordinate that is not finite");
  CGAL_CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), 3, Histogram_method()),
                    std::invalid_argument, "not finite");
  CGAL_CHECK(is_untouched({0, ids.labels()}));
  std::vector<typename Bad_mesh::Face_index> tips;
  CGAL_CHECK_THROWS_WITH(CGAL::protrusion_tips(mesh, 3, std::back_inserter(tips), Geodesic_distance()),
                    std::invalid_argument, "not finite");
  CGAL_CHECK(tips.empty());
}

// A number of an exact kernel may be finite and yet no double.
void coordinates_that_are_not_finite_are_refused()
{
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
  {
    check_not_finite(bad);
    check_not_finite(float(bad));
  }
  CGAL::Exact_predicates_exact_constructions_kernel::FT beyond_double = 1e300;
  check_not_finite(CGAL::exact(beyond_double * beyond_double));
}

void the_number_of_segments_must_be_possible()
{
  const Mesh mesh = to_graph<Mesh>(tetrahedron());
  Segment_ids<Mesh> ids(mesh);
  CGAL_CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), 0), std::invalid_argument,
                    "number_of_segments is 0");
  CGAL_CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), 5), std::invalid_argument,
                    "number_of_segments is 5, but it must be from 1 to 4, the number of faces of pmesh");
  CGAL_CHECK(is_untouched({0, ids.labels()}));
}

// As many segments as faces are asked for.
void more_segments_than_can_be_found_come_to_an_end()
{
  const Mesh mesh = to_graph<Mesh>(bumpy_sphere(2, 9));
  const Segmentation found = paper_segmentation(mesh, mesh.number_of_faces());
  CGAL_CHECK(found.number >= 1 && found.number <= mesh.number_of_faces());
}

// Components have the first ids; the others go where the best protrusions are: all eight arms of two equal
// bodies, none of a small ball.
void components_share_the_segments()
{
  const Test_mesh body = star(4, 1, 0.15, 0.04, 0.2);
  const Mesh mesh = to_graph<Mesh>(merged({translated(body, {9, 0, 0}), icosphere(1), body}));
  for (std::size_t k : {1, 2, 3, 11})
  {
    const Segmentation found = checked(mesh, [&](auto ids)
                                       { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k); });
    CGAL_CHECK_EQUAL(found.number, std::max<std::size_t>(k, 3));
    std::vector<std::set<std::size_t>> segments(3);
    for (std::size_t f = 0; f < found.labels.size(); ++f)
      segments[f < body.faces.size() ? 0 : f < body.faces.size() + 80 ? 1 : 2].insert(found.labels[f]);
    for (std::size_t component = 0; component < 3; ++component)
    {
      CGAL_CHECK(*segments[component].begin() < 3);
      CGAL_CHECK_EQUAL(segments[component].size(), component == 1 || k <= 3 ? 1 : 5);
    }
  }
}

int main()
{
  awkward_meshes_have_valid_segmentations();
  a_mesh_without_faces_has_no_segments();
  isolated_vertices_and_removed_faces();
  bodies_without_protrusions_are_one_segment();
  orientation_does_not_matter();
  coordinates_that_are_not_finite_are_refused();
  the_number_of_segments_must_be_possible();
  more_segments_than_can_be_found_come_to_an_end();
  components_share_the_segments();
  return check::result();
}
