// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The face dual graph (Section III.B), areas and centroids of a surface in index arrays, and how a
// mesh becomes one.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>

#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation::internal;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

struct Surface_of_mesh
{
  Indexed_surface surface;
  double unit;
};

Surface_of_mesh surface_of(const Mesh& mesh)
{
  Arrays_of_mesh arrays = read_surface(mesh, CGAL::parameters::default_values());
  return {std::move(arrays.surface).to_surface(), arrays.unit};
}

Surface_of_mesh surface_of(const Test_mesh& mesh)
{
  return surface_of(to_graph<Mesh>(mesh));
}

void check_point(const Indexed_surface::Point_3& p, double x, double y, double z)
{
  CGAL_CHECK_CLOSE(p.x(), x, 1e-14);
  CGAL_CHECK_CLOSE(p.y(), y, 1e-14);
  CGAL_CHECK_CLOSE(p.z(), z, 1e-14);
}

void areas_and_centroids_of_triangles_and_polygons()
{
  const Indexed_surface triangle = to_surface(single_triangle());
  CGAL_CHECK_CLOSE(triangle.area(0), 0.5, 1e-15);
  check_point(triangle.centroid(0), 1. / 3, 1. / 3, 0);

  const Indexed_surface quad = to_surface(sheet(1, 1, 3, 2));
  CGAL_CHECK_CLOSE(quad.area(0), 6, 1e-14);
  check_point(quad.centroid(0), 1.5, 1, 0);

  // The L: a square of area 3 + 1 less a unit square; its corners' mean is elsewhere.
  const Indexed_surface l = to_surface(l_prism());
  CGAL_CHECK_CLOSE(l.area(6), 3, 1e-14);
  check_point(l.centroid(6), 5. / 6, 5. / 6, 0);
  check_point(l.centroid(7), 5. / 6, 5. / 6, 1);
  CGAL_CHECK_CLOSE(l.area(), 3 + 3 + 8, 1e-14);
}

// Whatever corner comes first, also the one where a fan leaves the polygon.
void polygons_may_begin_at_any_corner()
{
  const Test_mesh prism = l_prism();
  for (std::size_t first = 0; first < 6; ++first)
  {
    Test_mesh mesh;
    mesh.points = prism.points;
    Face face = prism.faces[7];
    std::rotate(face.begin(), face.begin() + std::ptrdiff_t(first), face.end());
    mesh.add_face(face);
    const Indexed_surface surface = to_surface(mesh);
    CGAL_CHECK_CLOSE(surface.area(0), 3, 1e-14);
    check_point(surface.centroid(0), 5. / 6, 5. / 6, 1);
  }
}

// Folded, twisted and flat polygons: the centroid stays near the corners, as distances build on it.
void centroids_of_degenerate_polygons_are_inside()
{
  for (const double gap : {0., 1e-200, 1e-170, 1e-160, 1e-100, 1e-17, 1e-9, 1e-3})
    for (const std::array<Point, 4>& corners :
         {std::array<Point, 4>{{{0, 0, 0}, {1, 0, 0}, {1, gap, 0}, {0, gap, 0}}},
          std::array<Point, 4>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 + gap, 1, 0}}},
          std::array<Point, 4>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, gap}}},
          std::array<Point, 4>{{{0, 0, 0}, {0, 0, 0}, {gap, 0, 0}, {0, 1, 0}}}})
    {
      Test_mesh mesh;
      mesh.points.assign(corners.begin(), corners.end());
      mesh.add_face({0, 1, 2, 3});
      const Indexed_surface surface = to_surface(mesh);
      CGAL_CHECK(surface.area(0) >= 0);
      for (int i = 0; i < 3; ++i)
        CGAL_CHECK(std::abs(surface.centroid(0)[i]) <= 2);
    }
}

void arcs_join_the_faces_that_share_an_edge()
{
  for (const Test_mesh& mesh : {icosphere(2), football(), l_prism(), sheet(5, 4), torus(),
                                moebius_strip(), box(2, 2, 2), height_field(6, 5, 1)})
  {
    const Indexed_surface surface = to_surface(mesh);
    const auto& graph = surface.dual_graph();
    std::map<Edge, int> expected, found;
    std::map<Edge, std::vector<std::size_t>> sharing;
    for (const auto& item : faces_of_edges(mesh))
      for (std::size_t f : item.second)
        sharing[std::minmax(item.first.first, item.first.second)].push_back(f);
    for (const auto& item : sharing)
      if (item.second.size() == 2)
      {
        ++expected[{item.second[0], item.second[1]}];
        ++expected[{item.second[1], item.second[0]}];
      }
    for (const auto arc : boost::make_iterator_range(edges(graph)))
    {
      const Index f = source(arc, graph), g = target(arc, graph);
      ++found[{f, g}];
      CGAL_CHECK_CLOSE(graph[arc].length,
                  std::sqrt(CGAL::squared_distance(surface.centroid(f), surface.centroid(g))), 1e-15);
    }
    CGAL_CHECK_EQUAL(num_vertices(graph), mesh.faces.size());
    CGAL_CHECK(found == expected);
    CGAL_CHECK_CLOSE(surface.area(), area(mesh), 1e-12 * area(mesh));
  }
}

void corners_follow_the_mesh()
{
  const Test_mesh mesh = l_prism();
  const Indexed_surface surface = to_surface(mesh);
  CGAL_CHECK_EQUAL(surface.number_of_faces(), 8);
  CGAL_CHECK_EQUAL(surface.number_of_vertices(), 12);
  CGAL_CHECK_EQUAL(surface.number_of_corners(), 6 * 4 + 2 * 6);
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    Index corner = surface.first_corner(f);
    for (std::size_t v : mesh.faces[f])
    {
      CGAL_CHECK_EQUAL(surface.vertex(corner), v);
      corner = surface.next_corner(f, corner);
    }
    CGAL_CHECK_EQUAL(corner, surface.first_corner(f)); // round the face
  }
  const Indexed_surface sheet_surface = to_surface(sheet(1, 1, 3, 2));
  CGAL_CHECK_EQUAL(sheet_surface.neighbor(0), Indexed_surface::no_face());
  CGAL_CHECK_CLOSE(sheet_surface.edge_length(0, 0), 3, 1e-15);
  CGAL_CHECK_CLOSE(sheet_surface.edge_length(0, 3), 2, 1e-15);
}

// The same surface, but for the unit, as the one made from the arrays directly.
void check_read(const Test_mesh& mesh)
{
  const Surface_of_mesh read = surface_of(mesh);
  const Indexed_surface expected = to_surface(mesh);
  CGAL_CHECK_EQUAL(read.surface.number_of_faces(), expected.number_of_faces());
  CGAL_CHECK_EQUAL(read.surface.number_of_corners(), expected.number_of_corners());
  for (Index f = 0; f < expected.number_of_faces(); ++f)
    CGAL_CHECK_CLOSE(read.surface.area(f) * read.unit * read.unit, expected.area(f), 1e-12);
  for (Index v = 0; v < read.surface.number_of_vertices(); ++v)
    for (int i = 0; i < 3; ++i)
      CGAL_CHECK(std::abs(read.surface.point(v)[i]) <= 1);
  std::map<Edge, double> lengths;
  const auto& graph = expected.dual_graph();
  for (const auto arc : boost::make_iterator_range(edges(graph)))
    lengths[{source(arc, graph), target(arc, graph)}] = graph[arc].length;
  const auto& read_graph = read.surface.dual_graph();
  CGAL_CHECK_EQUAL(num_edges(read_graph), num_edges(graph));
  for (const auto arc : boost::make_iterator_range(edges(read_graph)))
    CGAL_CHECK_CLOSE(read_graph[arc].length * read.unit,
                lengths.at({source(arc, read_graph), target(arc, read_graph)}), 1e-12);
}

void meshes_are_read()
{
  for (const Test_mesh& mesh : {icosphere(2), football(), l_prism(), sheet(5, 4), torus(),
                                single_triangle(), translated(bumpy_sphere(2, 1), {10, -3, 7}),
                                merged({icosphere(1), translated(sheet(2, 2), {3, 0, 0})})})
    check_read(mesh);
}

void an_empty_mesh_is_an_empty_surface()
{
  const Surface_of_mesh empty = surface_of(Mesh());
  CGAL_CHECK_EQUAL(empty.surface.number_of_faces(), 0);
  CGAL_CHECK_EQUAL(empty.surface.area(), 0);
  CGAL_CHECK_EQUAL(Indexed_surface().number_of_faces(), 0);
}

void removed_elements_are_left_out()
{
  const Test_mesh soup = sheet(6, 5);
  Mesh mesh = to_graph<Mesh>(soup);
  for (int i : {0, 7, 8, 13, 29})
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(unsigned(i)), mesh), mesh);
  CGAL_CHECK(mesh.has_garbage());
  const Surface_of_mesh with_garbage = surface_of(mesh);
  mesh.collect_garbage();
  const Surface_of_mesh without = surface_of(mesh);
  CGAL_CHECK_EQUAL(with_garbage.surface.number_of_faces(), 25);
  CGAL_CHECK_EQUAL(without.surface.number_of_faces(), 25);
  CGAL_CHECK_CLOSE(with_garbage.surface.area() * with_garbage.unit * with_garbage.unit, 25, 1e-12);
  CGAL_CHECK_EQUAL(num_edges(with_garbage.surface.dual_graph()), num_edges(without.surface.dual_graph()));
}

void coordinates_must_be_finite()
{
  for (const double bad : {std::nan(""), infinity, -infinity})
    for (std::size_t i = 0; i < 3; ++i)
    {
      Test_mesh mesh = icosphere(1);
      mesh.points[7][i] = bad;
      CGAL_CHECK_THROWS_WITH(surface_of(mesh), std::invalid_argument, "vertex 7");
      CGAL_CHECK_THROWS_WITH(surface_of(mesh), std::invalid_argument, "not finite");
    }
}

// No digit differs after scaling by a power of two, up to the ends of the range of double.
void scaling_by_powers_of_two_is_exact()
{
  const Test_mesh mesh = translated(bumpy_sphere(2, 1), {1, 2, 3});
  const Surface_of_mesh expected = surface_of(mesh);
  for (const int exponent : {-1000, -300, -1, 1, 10, 1000, 1020})
  {
    const Surface_of_mesh read = surface_of(scaled(mesh, std::ldexp(1., exponent)));
    CGAL_CHECK_EQUAL(read.unit, std::ldexp(expected.unit, exponent));
    for (Index f = 0; f < expected.surface.number_of_faces(); ++f)
    {
      CGAL_CHECK_EQUAL(read.surface.area(f), expected.surface.area(f));
      CGAL_CHECK(read.surface.centroid(f) == expected.surface.centroid(f));
    }
  }
}

void tiny_and_huge_coordinates_neither_under_nor_overflow()
{
  const Test_mesh mesh = icosphere(2);
  const double relative_area = surface_of(mesh).surface.area();
  for (const double factor : {1e-300, 1e-160, 1e160, 1e300, 1e307, 1.7e308})
  {
    const Surface_of_mesh read = surface_of(scaled(mesh, factor));
    CGAL_CHECK(std::isfinite(read.unit));
    CGAL_CHECK(read.surface.area() > relative_area / 5 && read.surface.area() < relative_area * 16);
    const auto& graph = read.surface.dual_graph();
    for (const auto arc : boost::make_iterator_range(edges(graph)))
      CGAL_CHECK(graph[arc].length > 1e-3 && graph[arc].length < 1);
  }
}

// A vertex without faces is no part of the surface, wherever it lies.
void isolated_vertices_do_not_matter()
{
  Test_mesh mesh = icosphere(2);
  const Surface_of_mesh expected = surface_of(mesh);
  for (const double far : {0., 1e3, 1e200, infinity})
  {
    mesh.points.resize(icosphere(2).points.size());
    mesh.add_point({far, 0, 0});
    const Surface_of_mesh read = surface_of(mesh);
    CGAL_CHECK_EQUAL(read.unit, expected.unit);
    CGAL_CHECK_EQUAL(read.surface.area(), expected.surface.area());
  }
}

void arrays_must_fit_together()
{
  using Indices = std::vector<Indexed_surface::Index>;
  const std::vector<Indexed_surface::Point_3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Indices none(3, Indexed_surface::no_face());
  const auto make = [&](const Indices& begin, const Indices& vertices, const Indices& neighbors)
  { return Indexed_surface(points, begin, vertices, neighbors); };
  CGAL_CHECK_EQUAL(make({0, 3}, {0, 1, 2}, none).area(), 0.5);
  CGAL_CHECK_EQUAL(make({0}, {}, {}).area(), 0);
  CGAL_CHECK_THROWS_WITH(make({}, {}, {}), std::invalid_argument, "corner_begin: it does not begin with 0");
  CGAL_CHECK_THROWS_WITH(make({1, 3}, {0, 1, 2}, none), std::invalid_argument, "corner_begin: it does not begin with 0");
  CGAL_CHECK_THROWS_WITH(make({0, 2}, {0, 1, 2}, none), std::invalid_argument, "end with the number of corners");
  CGAL_CHECK_THROWS_WITH(make({0, 0, 3}, {0, 1, 2}, none), std::invalid_argument, "corner_begin: a face has no corner");
  CGAL_CHECK_THROWS_WITH(make({0, 3}, {0, 1, 2}, {}), std::invalid_argument, "corner_neighbors: its size");
  CGAL_CHECK_THROWS_WITH(make({0, 3}, {0, 1, 3}, none), std::invalid_argument, "corner_vertices: there is no vertex 3");
  CGAL_CHECK_THROWS_WITH(make({0, 3}, {0, 1, 2}, {1, 1, 1}), std::invalid_argument, "corner_neighbors: there is no face 1");
}

int main()
{
  arrays_must_fit_together();
  areas_and_centroids_of_triangles_and_polygons();
  polygons_may_begin_at_any_corner();
  centroids_of_degenerate_polygons_are_inside();
  arcs_join_the_faces_that_share_an_edge();
  corners_follow_the_mesh();
  meshes_are_read();
  an_empty_mesh_is_an_empty_surface();
  removed_elements_are_left_out();
  coordinates_must_be_finite();
  scaling_by_powers_of_two_is_exact();
  tiny_and_huge_coordinates_neither_under_nor_overflow();
  isolated_vertices_do_not_matter();
  return check::result();
}
