// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pegs and sockets on flat caps: parts stay closed, cut themselves nowhere, and differ by the volumes of peg and socket.

#include "connected_parts.h"

#include <CGAL/protrusion_segmentation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

// A box, longer than the cube that it consists of, cut in the middle.
struct Two_cubes
{
  Mesh mesh;
  Labels labels;
};

Two_cubes two_cubes(double size = 1)
{
  Two_cubes result;
  result.mesh = to_graph<Mesh>(box(2, 1, 1));
  for (const auto v : vertices(result.mesh))
    result.mesh.point(v) = CGAL::ORIGIN + size * (result.mesh.point(v) - CGAL::ORIGIN);
  double smallest = result.mesh.point(*vertices(result.mesh).begin())[0], largest = smallest;
  for (const auto v : vertices(result.mesh))
  {
    smallest = (std::min)(smallest, result.mesh.point(v)[0]);
    largest = (std::max)(largest, result.mesh.point(v)[0]);
  }
  result.labels = labels_of_halves(result.mesh, 0, (smallest + largest) / 2);
  return result;
}

void test_volumes_of_two_cubes()
{
  const Two_cubes cubes = two_cubes();
  const double volume_of_cube = volume(whole(cubes.mesh)) / 12, half = std::cbrt(volume_of_cube) / 2;
  for (const std::size_t sides : {3, 4, 6, 32})
    for (const double chamfer : {0., 0.2, 0.5})
      for (const double tolerance : {-1., 0., 0.02 * half})
      {
        Connector_options options;
        options.number_of_sides = sides;
        options.chamfer = chamfer;
        if (tolerance >= 0)
          options.tolerance = tolerance;
        check_connected(cubes.mesh, cubes.labels, {0, 0}, options, "two cubes");
        const Connected found = connected(cubes.mesh, cubes.labels, {0, 0}, options);
        CGAL_CHECK_EQUAL(found.connectors.size(), 1);
        const Connector& connector = found.connectors.front();
        CGAL_CHECK(connector.status == Status::PLACED);
        CGAL_CHECK(connector.is_peg_on_segment);
        CGAL_CHECK_EQUAL(connector.segment, 1);
        CGAL_CHECK_EQUAL(connector.parent, 0);
        CGAL_CHECK_CLOSE(connector.cap_radius, half, 0.01 * half);
        CGAL_CHECK_CLOSE(connector.radius, 0.5 * connector.cap_radius, 1e-12);
        CGAL_CHECK_CLOSE(connector.depth, 0.75 * connector.cap_radius, 1e-12);
        CGAL_CHECK_CLOSE(connector.tolerance, tolerance >= 0 ? tolerance : connector.radius / 20, 1e-12);
        const Volumes volumes = volumes_of(connector, options);
        CGAL_CHECK_CLOSE(volume(found.parts[1]) / 6, volume_of_cube + volumes.peg, 1e-12 * volume_of_cube);
        CGAL_CHECK_CLOSE(volume(found.parts[0]) / 6, volume_of_cube - volumes.socket, 1e-12 * volume_of_cube);
      }
}

// Of each triangle of the socket there is one of the peg as far inside as the tolerance.
void test_socket_is_peg_widened_by_tolerance()
{
  const Two_cubes cubes = two_cubes();
  Connector_options options;
  options.tolerance = 0.01;
  const Connected found = connected(cubes.mesh, cubes.labels, {0, 0}, options);
  using Plane = CGAL::Simple_cartesian<double>::Plane_3;
  const auto planes_of = [&](const Part& part)
  {
    std::vector<Plane> planes;
    for (const auto& polygon : part.polygons)
    {
      const Plane plane(part.points[polygon[0]], part.points[polygon[1]], part.points[polygon[2]]);
      const auto is_beyond_cap = [&](std::size_t v)
      {
        return (part.points[v] - found.connectors[0].base).squared_length() < 0.5 &&
               (part.points[v] - found.connectors[0].base) *
                   (found.connectors[0].end - found.connectors[0].base) >
                 1e-9;
      };
      if (std::any_of(polygon.begin(), polygon.end(), is_beyond_cap))
        planes.push_back(plane);
    }
    return planes;
  };
  std::size_t number_of_planes = 0;
  for (const Plane& wall : planes_of(found.parts[0]))
  {
    const auto normal = wall.orthogonal_vector() / std::sqrt(wall.orthogonal_vector().squared_length());
    if (std::abs(wall.a() * found.connectors[0].base.x() + wall.b() * found.connectors[0].base.y() +
                 wall.c() * found.connectors[0].base.z() + wall.d()) == 0)
      continue;
    double least = 1;
    for (const Plane& side : planes_of(found.parts[1]))
    {
      const auto other = side.orthogonal_vector() / std::sqrt(side.orthogonal_vector().squared_length());
      if (normal * other < -1 + 1e-9) // they face each other
        least = (std::min)(least, std::abs(normal * (wall.point() - side.point())));
    }
    if (least < 0.1)
    {
      ++number_of_planes;
      CGAL_CHECK_CLOSE(least, 0.01, 1e-12);
    }
  }
  CGAL_CHECK(number_of_planes >= 6 * 4 + 4); // two triangles for each side and slope, and the end
}

// Lengths are those of the user, however large the mesh.
void test_size_of_mesh()
{
  for (const double size : {1e-200, 1e-20, 1., 1e20, 1e200})
  {
    const Two_cubes cubes = two_cubes(size);
    Connector_options options;
    options.tolerance = 0.01 * size;
    const Connected found = connected(cubes.mesh, cubes.labels, {0, 0}, options);
    CGAL_CHECK_EQUAL(number_of_placed(found), 1);
    CGAL_CHECK_CLOSE(found.connectors[0].tolerance / size, 0.01, 1e-12);
    CGAL_CHECK_CLOSE(found.connectors[0].radius / size,
                connected(two_cubes().mesh, cubes.labels, {0, 0}).connectors[0].radius, 1e-9);
    for (const Part& part : found.parts)
      CGAL_CHECK_EQUAL(number_of_open_edges(part), 0);
  }
}

// Every arm of a star gets its own, and none cuts another.
void test_arms(const Test_mesh& soup,
               std::size_t number,
               std::size_t least_number_of_pegs,
               const std::string& name)
{
  const auto mesh = to_graph<Mesh>(soup);
  const auto hierarchy = CGAL::protrusion_hierarchy(mesh, number);
  Labels labels(mesh.number_of_faces()), parents;
  const std::size_t found_number = hierarchy.maximum_number_of_segments();
  hierarchy.segment_ids(mesh, found_number,
                        boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh)));
  for (std::size_t s = 0; s < found_number; ++s)
    parents.push_back(hierarchy.parent(s));
  check_connected(mesh, labels, parents, {}, name);
  const Connected found = connected(mesh, labels, parents);
  check::report(number_of_placed(found) >= least_number_of_pegs, __FILE__, __LINE__,
                name + " has " + std::to_string(number_of_placed(found)) + " pegs");
}

void test_statuses()
{
  const Two_cubes cubes = two_cubes();
  const auto status = [&](const Connector_options& options)
  {
    const Connected found = connected(cubes.mesh, cubes.labels, {0, 0}, options);
    const std::vector<Part> flat = without_connectors(cubes.mesh, cubes.labels, {0, 0});
    if (found.connectors.front().status != Status::PLACED)
      for (std::size_t s = 0; s < flat.size(); ++s)
        CGAL_CHECK(found.parts[s].points == flat[s].points && found.parts[s].polygons == flat[s].polygons);
    return found.connectors.front().status;
  };
  Connector_options options;
  options.smallest_radius = 0.26 * 2;
  CGAL_CHECK(status(options) == Status::CAP_TOO_SMALL);
  options = {};
  options.tolerance = 1;
  CGAL_CHECK(status(options) == Status::CAP_TOO_SMALL);
  options = {};
  options.depth = 100; // as deep as there is room
  CGAL_CHECK(status(options) == Status::PLACED);
  CGAL_CHECK(connected(cubes.mesh, cubes.labels, {0, 0}, options).connectors[0].depth < 2);
}

// The axis goes through a vertex of a symmetric mesh, whatever rounding says.
void test_axis_through_vertices()
{
  for (int step = 0; step < 20; ++step)
  {
    auto mesh = to_graph<Mesh>(icosphere(3));
    const double angle = 0.1 * step, x = std::cos(angle), y = std::sin(angle);
    const Labels labels = labels_of_halves(mesh, 2, 0);
    for (const auto v : vertices(mesh))
    {
      const Mesh::Point p = mesh.point(v);
      mesh.point(v) = Mesh::Point(p.x(), x * p.y() - y * p.z(), y * p.y() + x * p.z());
    }
    CGAL_CHECK_EQUAL(number_of_placed(connected(mesh, labels, {0, 0})), 1);
  }
}

// A slice is too thin for a socket; its neighbour is not.
void test_thin_protrusion_and_parent()
{
  for (const double cut : {0.02, 0.98})
  {
    auto mesh = to_graph<Mesh>(box(50, 10, 10));
    double low = 1e9, high = -1e9;
    for (const auto v : vertices(mesh))
    {
      low = (std::min)(low, mesh.point(v)[0]);
      high = (std::max)(high, mesh.point(v)[0]);
    }
    const Labels labels = labels_of_halves(mesh, 0, low + cut * (high - low));
    const Connected found = connected(mesh, labels, {0, 0});
    CGAL_CHECK_EQUAL(found.connectors.size(), 1);
    check_connected(mesh, labels, {0, 0}, {}, "slice");
    if (found.connectors[0].status == Status::PLACED)
      CGAL_CHECK_EQUAL(found.connectors[0].is_peg_on_segment, cut > 0.5);
  }
}

void test_open_mesh()
{
  const auto mesh = to_graph<Mesh>(open_cylinder());
  const Connected found = connected(mesh, labels_of_halves(mesh, 2, 2), {0, 0});
  CGAL_CHECK_EQUAL(found.connectors.size(), 1);
  CGAL_CHECK(found.connectors[0].status == Status::NO_ROOM);
}

void test_wrong_options()
{
  const Two_cubes cubes = two_cubes();
  const auto call = [&](double Connector_options::*option, double value)
  {
    Connector_options options;
    options.*option = value;
    connected(cubes.mesh, cubes.labels, {0, 0}, options);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {0., -1., 1., nan})
    CGAL_CHECK_THROWS_WITH(call(&Connector_options::radius, value), std::invalid_argument,
                      "connectors: radius is out of range");
  for (const double value : {0., -1., nan})
    CGAL_CHECK_THROWS_WITH(call(&Connector_options::depth, value), std::invalid_argument,
                      "connectors: depth is out of range");
  for (const double value : {-0.1, 0.6, nan})
    CGAL_CHECK_THROWS_WITH(call(&Connector_options::chamfer, value), std::invalid_argument,
                      "connectors: chamfer is out of range");
  Connector_options options;
  options.number_of_sides = 2;
  CGAL_CHECK_THROWS_WITH(connected(cubes.mesh, cubes.labels, {0, 0}, options), std::invalid_argument,
                    "connectors: number_of_sides is 2, but it must be from 3 to 1000");
}

} // namespace

int main()
{
  test_volumes_of_two_cubes();
  test_socket_is_peg_widened_by_tolerance();
  test_size_of_mesh();
  test_arms(star(5), 6, 5, "star");
  test_arms(creature(), 6, 4, "creature");
  test_arms(dumbbell(), 3, 1, "dumbbell");
  test_statuses();
  test_axis_through_vertices();
  test_thin_protrusion_and_parent();
  test_open_mesh();
  test_wrong_options();
  return check::result();
}
