// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever a mesh holds, the result is a valid segmentation or an exception that says why.

#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// Valid for numbers of segments from one to all faces and without a number, with the distances and
// border methods of the package.
template <typename Distance, typename Border>
void check_valid(const Mesh& mesh, const Distance& distance, const Border& border)
{
  const std::size_t n = mesh.number_of_faces();
  std::set<std::size_t> numbers = {1, 2, 5, 20};
  if(n <= 100)
    numbers.insert(n);
  for(const std::size_t k : numbers)
    if(k >= 1 && k <= n)
    {
      const Segmentation found = checked(mesh, [&](auto ids)
      {
        return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, distance, border);
      });
      CHECK(found.number >= 1);
    }
  const Segmentation found = checked(mesh, [&](auto ids)
  {
    return CGAL::segmentation_via_protrusion_tips(mesh, ids, distance, border);
  });
  CHECK_EQUAL(found.number > 0, n > 0);
}

void check_valid(const Mesh& mesh)
{
  check_valid(mesh, Geodesic_distance(), Histogram_border());
  check_valid(mesh, Landmark_geodesic_distance(), Histogram_border());
  check_valid(mesh, Geodesic_distance(), Histogram_border().uses_candidate_intervals(false)
                                                           .minimum_prominence(1e-6));
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, std::min<std::size_t>(4, mesh.number_of_faces()),
                        std::back_inserter(tips), Geodesic_distance());
  CHECK_EQUAL(checked(mesh, [&](auto ids)
  {
    return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, Geodesic_distance(),
                                                   Histogram_border());
  }).number > 0, mesh.number_of_faces() > 0);
}

void check_valid(const Test_mesh& mesh)
{
  check_valid(to_graph<Mesh>(mesh));
}

void meshes_of_few_faces()
{
  check_valid(single_triangle());
  check_valid(thin_strip(1));
  check_valid(sheet(1, 1));
  check_valid(tetrahedron());
  check_valid(box());
}

// Without faces there is nothing to segment, whatever vertices there are.
void a_mesh_without_faces_has_no_segments()
{
  check_valid(Mesh());
  Mesh vertices;
  vertices.add_vertex({1, 2, 3});
  check_valid(vertices);
  Segment_ids<Mesh> ids(vertices);
  CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(vertices, ids.map(), 1,
                                                           Geodesic_distance(), Histogram_border()),
                    std::invalid_argument, "only 0 faces");
}

void bodies_without_protrusions()
{
  for(const Test_mesh& mesh : {icosphere(2), sheet(15, 15), torus(2, 0.5, 24, 10),
                               open_cylinder(1, 1), uv_sphere(1, 0.3), regular_prism(40)})
    check_valid(mesh);
}

void polygons_holes_and_handles()
{
  check_valid(football());
  check_valid(dodecahedron());
  check_valid(l_prism());
  check_valid(pierced_plate(3, 2));
  check_valid(height_field(12, 9, 1));
  check_valid(with_reversed_orientation(bumpy_sphere(2, 1)));
  check_valid(merged({icosphere(1), translated(sheet(3, 2), {3, 0, 0}),
                      translated(single_triangle(), {0, 5, 0})}));
}

void needles_and_slivers()
{
  check_valid(thin_strip(200, 1e-9));
  check_valid(thin_strip(200, 1e-200));
  check_valid(scaled(bumpy_sphere(2, 2), 1e-12, 1, 1e6));
  check_valid(scaled(icosphere(2), 1e-300, 1e-300, 1));
}

// Flattened to a plane, a line and a point: faces without area, edges without length.
void collapsed_bodies()
{
  for(const Test_mesh& mesh : {bumpy_sphere(2, 5), torus(2, 0.5, 20, 8)})
  {
    check_valid(scaled(mesh, 1, 1, 0));
    check_valid(scaled(mesh, 1, 0, 0));
    check_valid(scaled(mesh, 0));
  }
}

void repeated_points()
{
  Test_mesh mesh = bumpy_sphere(2, 6);
  Random random(1);
  for(int i = 0; i < 80; ++i)
  {
    const std::size_t from = random.index(mesh.points.size());
    mesh.points[random.index(mesh.points.size())] = mesh.points[from];
  }
  check_valid(mesh);
}

void points_at_random()
{
  for(std::uint_fast32_t seed = 0; seed < 5; ++seed)
    check_valid(jittered(random_surface(seed), 10, seed));
}

void tiny_and_huge_coordinates()
{
  for(const double factor : {1e-300, 1e-100, 1e100, 1e300})
    check_valid(scaled(bumpy_sphere(2, 7), factor));
  check_valid(translated(bumpy_sphere(2, 7), {1e12, 0, 0}));
  check_valid(translated(bumpy_sphere(2, 7), {1e300, 0, 0})); // all digits lost: one point
}

void isolated_vertices_and_removed_faces()
{
  Test_mesh soup = bumpy_sphere(2, 8);
  soup.add_point({100, 0, 0});
  soup.add_point({std::nan(""), 0, 0});
  Mesh mesh = to_graph<Mesh>(soup);
  check_valid(mesh);
  for(unsigned int f = 0; f < 120; f += 3)
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(f), mesh), mesh);
  CHECK(mesh.has_garbage());
  check_valid(mesh);
}

void coordinates_that_are_not_finite_are_refused()
{
  for(const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
  {
    Test_mesh soup = icosphere(2);
    soup.points[20][1] = bad;
    const Mesh mesh = to_graph<Mesh>(soup);
    Segment_ids<Mesh> ids(mesh);
    CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), 3, Geodesic_distance(),
                                                             Histogram_border()),
                      std::invalid_argument, "vertex 20 has a coordinate that is not finite");
    CHECK(is_untouched({0, ids.labels()}));
    std::vector<Mesh::Face_index> tips;
    CHECK_THROWS_WITH(CGAL::protrusion_tips(mesh, 3, std::back_inserter(tips), Geodesic_distance()),
                      std::invalid_argument, "not finite");
    CHECK(tips.empty());
  }
}

// As many segments as faces are asked for.
void more_segments_than_can_be_found_come_to_an_end()
{
  const Mesh mesh = to_graph<Mesh>(bumpy_sphere(2, 9));
  const Segmentation found = paper_segmentation(mesh, mesh.number_of_faces());
  CHECK(found.number >= 1 && found.number <= mesh.number_of_faces());
}

int main()
{
  meshes_of_few_faces();
  a_mesh_without_faces_has_no_segments();
  bodies_without_protrusions();
  polygons_holes_and_handles();
  needles_and_slivers();
  collapsed_bodies();
  repeated_points();
  points_at_random();
  tiny_and_huge_coordinates();
  isolated_vertices_and_removed_faces();
  coordinates_that_are_not_finite_are_refused();
  more_segments_than_can_be_found_come_to_an_end();
  return check::result();
}
