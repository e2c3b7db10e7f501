// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections by planes have the components that CGAL::Polygon_mesh_slicer finds; diameters are those
// of all pairs of points.

// g++ 12 finds Boost's copies of edge properties without members uninitialized at -O3, and takes the operators below for
// mismatched where it inlines one of them.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Histogram_method/plane_section.h>

#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <new>

std::size_t allocated_bytes = 0;

void* operator new(std::size_t size)
{
  allocated_bytes += size;
  if (void* const memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation::internal;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vector_3 = Indexed_surface::Vector_3;
using Points = std::vector<Point>; // sorted, each point once

constexpr double tolerance = 1e-12;

double brute_force_diameter(const Points& points)
{
  double largest = 0;
  for (const Point& p : points)
    for (const Point& q : points)
      largest = (std::max)(largest, length(p - q));
  return largest;
}

Points unique_points(Points points)
{
  std::sort(points.begin(), points.end());
  Points result;
  for (const Point& p : points)
    if (std::none_of(result.begin(), result.end(),
                     [&](const Point& q) { return length(p - q) < tolerance; }))
      result.push_back(p);
  return result;
}

// Of every component of a section its different points; points alone are left out, as the two ways
// treat planes that touch the surface in a vertex differently.
std::vector<Points> sorted_components(std::vector<Points> components)
{
  std::vector<Points> result;
  for (Points& points : components)
  {
    points = unique_points(std::move(points));
    if (points.size() > 1)
      result.push_back(std::move(points));
  }
  // by the diameter, rounded where symmetric components tie, then by position
  const auto key = [](const Points& points)
  { return std::make_pair(std::lround(1e6 * brute_force_diameter(points)), points.front()); };
  std::sort(result.begin(), result.end(),
            [&](const Points& a, const Points& b) { return key(a) < key(b); });
  return result;
}

std::vector<Points> components_by_slicer(const Mesh& mesh, const Section_plane& plane)
{
  CGAL::Polygon_mesh_slicer<Mesh, Kernel> slicer(mesh);
  std::vector<std::vector<Kernel::Point_3>> polylines;
  const Vector_3& n = plane.normal;
  slicer(Kernel::Plane_3({plane.origin.x(), plane.origin.y(), plane.origin.z()},
                         Kernel::Vector_3(n.x(), n.y(), n.z())),
         std::back_inserter(polylines));
  std::vector<Points> components;
  for (const auto& polyline : polylines)
  {
    components.emplace_back();
    for (const Kernel::Point_3& p : polyline)
      components.back().push_back({p.x(), p.y(), p.z()});
  }
  return sorted_components(components);
}

std::vector<Points> components_by_walk(const Indexed_surface& surface,
                                       Plane_section& section,
                                       const Section_plane& plane)
{
  std::vector<Points> components;
  section.start();
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    std::vector<Indexed_surface::Point_3> points;
    section.component(f, plane, points);
    if (points.empty())
      continue;
    components.emplace_back();
    for (const Indexed_surface::Point_3& p : points)
      components.back().push_back({p.x(), p.y(), p.z()});
    CGAL_CHECK_CLOSE(planar_diameter(points, plane.normal), brute_force_diameter(components.back()),
                tolerance);
  }
  return sorted_components(components);
}

class Sliced_mesh
{
public:
  explicit Sliced_mesh(const Test_mesh& mesh)
    : m_mesh(to_graph<Mesh>(mesh)),
      m_surface(to_surface(mesh)),
      m_section(m_surface)
  {}

  // Returns the number of components.
  std::size_t check(const Section_plane& plane)
  {
    const std::vector<Points> expected = components_by_slicer(m_mesh, plane);
    const std::vector<Points> found = components_by_walk(m_surface, m_section, plane);
    CGAL_CHECK_EQUAL(found.size(), expected.size());
    for (std::size_t i = 0; i < (std::min)(found.size(), expected.size()); ++i)
    {
      CGAL_CHECK_EQUAL(found[i].size(), expected[i].size());
      CGAL_CHECK_CLOSE(brute_force_diameter(found[i]), brute_force_diameter(expected[i]), tolerance);
      for (std::size_t j = 0; j < (std::min)(found[i].size(), expected[i].size()); ++j)
        CGAL_CHECK(std::any_of(expected[i].begin(), expected[i].end(),
                          [&](const Point& p) { return length(p - found[i][j]) < tolerance; }));
    }
    return found.size();
  }

private:
  Mesh m_mesh;
  Indexed_surface m_surface;
  Plane_section m_section;
};

Section_plane random_plane(Random& random, double size)
{
  const auto number = [&](double range) { return random.real(-range, range); };
  const double x = number(size), y = number(size), z = number(size);
  const double u = number(1), v = number(1), w = number(1);
  return {{x, y, z}, {u, v, w}};
}

void random_planes_give_the_same_components()
{
  for (const Test_mesh& mesh :
       {icosphere(3), bumpy_sphere(3, 2), triangulated(torus()), triangulated(open_cylinder()),
        triangulated(closed_cylinder()), height_field(9, 8, 1), random_surface(5),
        merged({icosphere(2), translated(icosphere(1), {0.5, 2, 0})})})
  {
    Sliced_mesh sliced(mesh);
    Random random(1);
    for (int i = 0; i < 60; ++i)
      sliced.check(random_plane(random, 1.5));
  }
}

void a_torus_has_sections_in_two_components()
{
  Sliced_mesh sliced(triangulated(torus(2, 0.5)));
  CGAL_CHECK_EQUAL(sliced.check({{0, 0, 0.01}, {0, 0, 1}}), 2); // rings
  CGAL_CHECK_EQUAL(sliced.check({{0, 0.01, 0}, {0, 1, 0}}), 2); // circles
  CGAL_CHECK_EQUAL(sliced.check({{2, 0.01, 0}, {1, 0, 0}}), 1);
}

// Some of their vertices are on the planes to the last bit.
void planes_through_vertices_and_edges_give_the_same_points()
{
  Sliced_mesh ball(icosphere(2)); // some edges lie in the coordinate planes
  for (const Vector_3& normal : {Vector_3(1, 0, 0), Vector_3(0, -1, 0), Vector_3(0, 0, 1)})
    CGAL_CHECK_EQUAL(ball.check({{0, 0, 0}, normal}), 1);
  Sliced_mesh cylinder(triangulated(open_cylinder(1, 4, 0.25)));
  for (const double z : {0.5, 1., 2.75}) // rings of edges
    CGAL_CHECK_EQUAL(cylinder.check({{0, 0, z}, {0, 0, 1}}), 1);
  Sliced_mesh body(triangulated(box(3, 2, 4)));
  for (const double t : {0.5, 1.})
    for (const Vector_3& normal : {Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1)})
      CGAL_CHECK_EQUAL(body.check({{t, t, t}, normal}), 1);
  Sliced_mesh sheet_mesh(triangulated(sheet(5, 5)));
  CGAL_CHECK_EQUAL(sheet_mesh.check({{2, 0, 0}, {1, 0, 0}}), 1);
  CGAL_CHECK_EQUAL(sheet_mesh.check({{2.5, 2.5, 0}, {1, 1, 0}}), 1);
}

void a_plane_beside_the_surface_crosses_nothing()
{
  const Indexed_surface surface = to_surface(icosphere(2));
  Plane_section section(surface);
  std::vector<Indexed_surface::Point_3> points;
  for (const Section_plane& plane :
       {Section_plane{{0, 0, 2}, {0, 0, 1}}, Section_plane{{0, 0, 0}, {0, 0, 0}}})
  {
    section.start();
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      section.component(f, plane, points);
    CGAL_CHECK(points.empty());
  }
}

void a_component_is_given_once_a_section()
{
  const Indexed_surface surface = to_surface(icosphere(2));
  Plane_section section(surface);
  const Section_plane plane = {{0, 0, 0.1}, {0.1, 0.2, 1}};
  std::vector<Indexed_surface::Point_3> once, again;
  const auto section_of_all_faces = [&](std::vector<Indexed_surface::Point_3>& points)
  {
    section.start();
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      section.component(f, plane, points);
  };
  section_of_all_faces(once);
  section_of_all_faces(again);
  CGAL_CHECK(once == again);
  CGAL_CHECK(!once.empty());
}

// A regular polygon in a tilted plane and random clouds, also on a line or in one point.
void diameters_of_points_in_a_plane()
{
  Random random(3);
  for (int i = 0; i < 300; ++i)
  {
    const double a = random.real(-1, 1), b = random.real(-1, 1);
    const Vector_3 u(1, 0, a), v(0, 1, b), normal = CGAL::cross_product(u, v);
    const double flatness = std::array<double, 4>{1, 1e-3, 1e-12, 0}[std::size_t(i % 4)];
    const std::size_t n = 1 + random.index(40);
    std::vector<Indexed_surface::Point_3> points;
    Points copies;
    for (std::size_t j = 0; j < n; ++j)
    {
      const double turn = 2 * pi * double(j) / double(n);
      const double x = i % 2 == 0 ? std::cos(turn) : random.real(-1, 1);
      const double y = i % 2 == 0 ? std::sin(turn) : random.real(-1, 1);
      points.push_back(Indexed_surface::Point_3(3, -2, 1) + x * u + (flatness * y) * v);
      copies.push_back({points.back().x(), points.back().y(), points.back().z()});
    }
    CGAL_CHECK_CLOSE(planar_diameter(points, normal), brute_force_diameter(copies), tolerance);
    CGAL_CHECK_CLOSE(planar_diameter(points, 1e-300 * normal), brute_force_diameter(copies), tolerance);
  }
  CGAL_CHECK_EQUAL(planar_diameter({}, {0, 0, 1}), 0);
  CGAL_CHECK_EQUAL(planar_diameter({{1, 2, 3}}, {0, 0, 1}), 0);
  CGAL_CHECK_EQUAL(planar_diameter({{1, 2, 3}, {2, 2, 3}}, {0, 0, 0}), 0); // no plane
  CGAL_CHECK_CLOSE(planar_diameter({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {0, 0, -5}), std::sqrt(5.),
              1e-15);
}

// Differences of points whose determinants are all rounded to positive numbers, as those of a very thin hull may be.
namespace rounded_up {

struct Vector
{};
struct Point
{
  double x;
};
Vector operator-(const Point&, const Point&)
{
  return {};
}
double determinant(const Vector&, const Vector&)
{
  return 1;
}
double squared_distance(const Point& p, const Point& q)
{
  return (p.x - q.x) * (p.x - q.x);
}

} // namespace rounded_up

void calipers_come_to_an_end_whatever_is_rounded()
{
  const std::vector<rounded_up::Point> hull = {{0}, {1}, {3}};
  CGAL_CHECK(largest_squared_distance_of_antipodal_pairs(hull) <= 9);
}

void diameters_of_hulls()
{
  using Point_2 = Kernel::Point_2;
  const auto diameter = [](const std::vector<Point_2>& hull)
  { return std::sqrt(largest_squared_distance_of_antipodal_pairs(hull)); };
  CGAL_CHECK_EQUAL(diameter({}), 0);
  CGAL_CHECK_EQUAL(diameter({{1, 2}}), 0);
  CGAL_CHECK_EQUAL(diameter({{0, 0}, {3, 4}}), 5);
  CGAL_CHECK_EQUAL(diameter({{0, 0}, {4, 0}, {0, 3}}), 5);
  CGAL_CHECK_EQUAL(diameter({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), 5);
}

// Several threads have a copy each.
void a_copy_takes_few_bits_for_each_face()
{
  const Indexed_surface surface = to_surface(icosphere(5));
  const Plane_section section(surface);
  const std::size_t before = allocated_bytes;
  const Plane_section copy(section);
  CGAL_CHECK(8 * (allocated_bytes - before) < 3 * surface.number_of_faces());
}

int main()
{
  random_planes_give_the_same_components();
  a_torus_has_sections_in_two_components();
  planes_through_vertices_and_edges_give_the_same_points();
  a_plane_beside_the_surface_crosses_nothing();
  a_component_is_given_once_a_section();
  diameters_of_points_in_a_plane();
  diameters_of_hulls();
  calipers_come_to_an_end_whatever_is_rounded();
  a_copy_takes_few_bits_for_each_face();
  return check::result();
}
