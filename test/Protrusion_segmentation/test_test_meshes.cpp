// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The test meshes are what their descriptions say: the other tests rely on them.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

using namespace test_meshes;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// What holds for every mesh: faces in `parts` connected parts, and a valid graph in face order.
template <typename FaceGraph>
void check_graph(const Test_mesh& mesh)
{
  const FaceGraph graph = to_graph<FaceGraph>(mesh);
  CGAL_CHECK(CGAL::is_valid_polygon_mesh(graph));
  CGAL_CHECK_EQUAL(num_vertices(graph), mesh.points.size());
  CGAL_CHECK_EQUAL(num_faces(graph), mesh.faces.size());
  const auto parts = part_of_face_map(mesh, graph);
  const auto points = get(CGAL::vertex_point, graph);
  std::size_t f = 0;
  for (auto face : faces(graph))
  {
    CGAL_CHECK_EQUAL(parts.at(face), mesh.parts[f]);
    std::set<Point> in_graph, in_mesh;
    for (auto v : CGAL::vertices_around_face(halfedge(face, graph), graph))
      in_graph.insert({get(points, v).x(), get(points, v).y(), get(points, v).z()});
    for (std::size_t v : mesh.faces[f])
      in_mesh.insert(mesh.points[v]);
    CGAL_CHECK(in_graph == in_mesh);
    ++f;
  }
}

void check_mesh(const Test_mesh& mesh, std::size_t faces, std::size_t parts)
{
  CGAL_CHECK_EQUAL(mesh.faces.size(), faces);
  CGAL_CHECK_EQUAL(mesh.parts.size(), faces);
  CGAL_CHECK_EQUAL(number_of_parts(mesh), parts);
  CGAL_CHECK_EQUAL(number_of_pieces(mesh, mesh.parts), parts);
  for (const Face& face : mesh.faces)
    CGAL_CHECK(face_area(mesh, face) > 0);
  check_graph<Surface_mesh>(mesh);
  check_graph<Polyhedron>(mesh);
}

// Closed, oriented outward, and of the given genus, in one component.
void check_closed(const Test_mesh& mesh, std::size_t faces, std::size_t parts, long genus = 0)
{
  check_mesh(mesh, faces, parts);
  CGAL_CHECK_EQUAL(number_of_border_edges(mesh), 0);
  CGAL_CHECK_EQUAL(number_of_components(mesh), 1);
  CGAL_CHECK_EQUAL(euler_characteristic(mesh), 2 - 2 * genus);
  CGAL_CHECK(volume(mesh) > 0);
}

void polyhedra_have_their_analytic_areas_and_volumes()
{
  check_closed(tetrahedron(), 4, 1);
  CGAL_CHECK_CLOSE(volume(tetrahedron()), 8. / 3, 1e-12);
  CGAL_CHECK_CLOSE(area(tetrahedron()), 8 * std::sqrt(3.), 1e-12);

  const Test_mesh brick = box(4, 3, 2);
  check_closed(brick, 52, 6);
  CGAL_CHECK_CLOSE(volume(brick), 24, 1e-12);
  const std::array<double, 3> side_areas = {6, 8, 12};
  for (std::size_t part = 0; part < 6; ++part)
    CGAL_CHECK_CLOSE(area_of_part(brick, part), side_areas[part / 2], 1e-12);

  const Test_mesh plate = pierced_plate(2, 1);
  CGAL_CHECK_EQUAL(plate.faces.size(), 2 * 13 + 16 + 8);
  CGAL_CHECK_EQUAL(number_of_border_edges(plate), 0);
  CGAL_CHECK_EQUAL(euler_characteristic(plate), 2 - 2 * 2);
  CGAL_CHECK_CLOSE(volume(plate), 13, 1e-12);

  check_closed(regular_prism(7), 9, 3);
  CGAL_CHECK_CLOSE(area_of_part(regular_prism(6), 2), 1.5 * std::sqrt(3.), 1e-12);
  check_closed(l_prism(), 8, 3);
  CGAL_CHECK_CLOSE(volume(l_prism()), 3, 1e-12);
  CGAL_CHECK_CLOSE(area_of_part(l_prism(), 1), 3, 1e-12);
}

void spheres_are_round()
{
  check_closed(icosahedron(), 20, 1);
  check_closed(dodecahedron(), 12, 1);
  check_closed(icosphere(2), 320, 1);
  CGAL_CHECK_CLOSE(area(icosphere(4)), 4 * pi, 0.02);
  for (const Point& p : icosphere(2).points)
    CGAL_CHECK_CLOSE(length(p), 1, 1e-12);
  for (const Face& face : dodecahedron().faces)
    CGAL_CHECK_EQUAL(face.size(), 5);

  const Test_mesh ball = football();
  CGAL_CHECK_EQUAL(euler_characteristic(ball), 2);
  CGAL_CHECK_EQUAL(ball.faces.size(), 32);
  CGAL_CHECK_EQUAL(ball.faces.front().size(), 6);
  CGAL_CHECK_EQUAL(ball.faces.back().size(), 5);
  CGAL_CHECK(volume(ball) > 0);
  check_graph<Polyhedron>(ball);
}

void sheets_and_strips_are_open()
{
  check_mesh(single_triangle(), 1, 1);
  check_mesh(sheet(5, 3, 2, 0.5), 15, 1);
  CGAL_CHECK_EQUAL(number_of_border_edges(sheet(5, 3)), 16);
  CGAL_CHECK_CLOSE(area(sheet(5, 3, 2, 0.5)), 15, 1e-12);
  check_mesh(thin_strip(20), 40, 1);
  CGAL_CHECK_EQUAL(euler_characteristic(thin_strip(20)), 1);

  const Test_mesh moebius = moebius_strip(24);
  CGAL_CHECK_EQUAL(euler_characteristic(moebius), 0);
  CGAL_CHECK_EQUAL(number_of_components(moebius), 1);
  CGAL_CHECK_THROWS_WITH(to_graph<Surface_mesh>(moebius), std::runtime_error, "face 23");
}

void surfaces_of_revolution_have_their_analytic_areas()
{
  const Test_mesh tube = open_cylinder(1, 4, 0.1);
  check_mesh(tube, 63 * 40, 1);
  CGAL_CHECK_EQUAL(number_of_border_edges(tube), 2 * 63);
  CGAL_CHECK_CLOSE(area(tube), 8 * pi, 0.02);

  const Test_mesh can = closed_cylinder(1, 4, 0.1);
  check_closed(can, 63 * 60, 3);
  CGAL_CHECK_CLOSE(area_of_part(can, 0), 8 * pi, 0.02);
  CGAL_CHECK_CLOSE(area_of_part(can, 2), pi, 0.01);

  check_closed(uv_sphere(), 31 * 16, 1);
  check_closed(capsule(), 21 * 37, 1);
  CGAL_CHECK_CLOSE(area(capsule(0.5, 4, 0.05)), 5 * pi, 0.03);
  check_closed(torus(), 48 * 16, 1, 1);
  CGAL_CHECK_CLOSE(area(torus(2, 0.5, 200, 100)), 4 * pi * pi, 0.02);
}

void balls_on_bars_have_their_analytic_parts()
{
  const Test_mesh lolly = capsule_with_ball(0.3, 3, 1, 0.05);
  check_closed(lolly, lolly.faces.size(), 2);
  const double ball_area = 2 * pi * (1 + std::sqrt(1 - 0.09)); // a cap of that height
  CGAL_CHECK_CLOSE(area_of_part(lolly, 0), ball_area, 0.02);
  CGAL_CHECK_CLOSE(area_of_part(lolly, 1), 2 * pi * 0.3 * 3.3, 0.02);

  const Test_mesh weight = dumbbell(1, 1.5, 0.3, 3, 0.05);
  check_closed(weight, weight.faces.size(), 3);
  CGAL_CHECK_CLOSE(area_of_part(weight, 0), 2 * pi * 0.3 * 3, 0.02);
  CGAL_CHECK_CLOSE(area_of_part(weight, 1), ball_area, 0.02);
}

// The smallest height of a triangle over its longest edge, at least `bound` everywhere.
void check_no_slivers(const Test_mesh& mesh, double bound)
{
  for (const Face& face : mesh.faces)
  {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = (std::max)(longest, length(mesh.points[face[i]] - mesh.points[face[(i + 1) % 3]]));
    CGAL_CHECK(2 * face_area(mesh, face) > bound * longest * longest);
  }
}

void bodies_have_connected_parts_of_about_analytic_area()
{
  for (std::size_t arms = 0; arms <= 8; ++arms)
  {
    const Test_mesh mesh = star(arms);
    check_closed(mesh, mesh.faces.size(), arms + 1);
    check_no_slivers(mesh, 0.15);
    for (std::size_t i = 0; i < arms; ++i) // a stick with half a ball: 2 pi r * length
      CGAL_CHECK_CLOSE(area_of_part(mesh, i + 1) / (2 * pi * 0.25 * 2 * (1 + double(i) * 0.04)), 1, 0.1);
  }
  check_closed(creature(), creature().faces.size(), 6);
  check_no_slivers(creature(), 0.15);
  for (std::size_t fingers : {1, 3, 4})
  {
    const Test_mesh mesh = body_with_hands(fingers);
    check_closed(mesh, mesh.faces.size(), 1 + 2 * (1 + fingers));
    check_no_slivers(mesh, 0.1);
  }
}

void random_surfaces_are_connected_and_repeatable()
{
  std::set<long> characteristics;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const Test_mesh mesh = random_surface(seed);
    check_mesh(mesh, mesh.faces.size(), 1);
    CGAL_CHECK(mesh.faces.size() >= 40 && mesh.faces.size() <= 320);
    CGAL_CHECK(mesh.points == random_surface(seed).points && mesh.faces == random_surface(seed).faces);
    characteristics.insert(euler_characteristic(mesh));
  }
  CGAL_CHECK((characteristics == std::set<long>{0, 1, 2}));
  CGAL_CHECK(random_surface(1).points != random_surface(2).points);
  CGAL_CHECK_EQUAL(Random(5489).index(1000), 3499211612 % 1000); // the first number by the standard
}

void transformations_keep_parts_and_measures()
{
  const Test_mesh mesh = star(3);
  const Test_mesh moved = translated(scaled(rotated(mesh, {1, 2, 3}, 0.7), 2), {5, -6, 7});
  CGAL_CHECK_CLOSE(volume(moved), 8 * volume(mesh), 1e-9);
  CGAL_CHECK(moved.parts == mesh.parts);
  CGAL_CHECK_CLOSE(rotated(single_triangle(), {0, 0, 1}, pi / 2).points[1][1], 1, 1e-15);

  const Test_mesh permuted = with_face_order(mesh, random_permutation(mesh.faces.size(), 1));
  check_closed(permuted, mesh.faces.size(), 4);
  CGAL_CHECK(permuted.faces != mesh.faces);
  for (std::size_t part = 0; part < 4; ++part)
    CGAL_CHECK_CLOSE(area_of_part(permuted, part), area_of_part(mesh, part), 1e-9);

  CGAL_CHECK_CLOSE(volume(with_reversed_orientation(mesh)), -volume(mesh), 1e-12);
  check_closed(triangulated(box(2, 2, 2)), 48, 6);

  const Test_mesh both = merged({box(), translated(dumbbell(), {9, 9, 9})});
  CGAL_CHECK_EQUAL(number_of_components(both), 2);
  check_mesh(both, 6 + dumbbell().faces.size(), 9);
}

int main()
{
  polyhedra_have_their_analytic_areas_and_volumes();
  spheres_are_round();
  sheets_and_strips_are_open();
  surfaces_of_revolution_have_their_analytic_areas();
  balls_on_bars_have_their_analytic_parts();
  bodies_have_connected_parts_of_about_analytic_area();
  random_surfaces_are_connected_and_repeatable();
  transformations_keep_parts_and_measures();
  return check::result();
}
