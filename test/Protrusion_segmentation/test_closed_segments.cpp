// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments with flat caps: every edge of a part has two faces that look the same way, and volumes add up.

#include "closed_parts.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Protrusion_segmentation/closed_segments.h>
#include <CGAL/protrusion_segmentation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

std::vector<Part> closed_parts(const Mesh& mesh, const Labels& labels, const Labels& parents)
{
  std::vector<Part> parts;
  CGAL::Protrusion_segmentation::closed_segments(mesh, map_of(labels, mesh), record_of(parents),
                                                 std::back_inserter(parts));
  return parts;
}

void check_parts(const Mesh& mesh, const Labels& labels, const Labels& parents, const std::string& name)
{
  const std::vector<Part> parts = closed_parts(mesh, labels, parents);
  CGAL_CHECK_EQUAL(parts.size(), parents.size());
  double sum = 0;
  std::size_t number_of_faces = 0;
  for (std::size_t s = 0; s < parts.size(); ++s)
  {
    check::report(number_of_open_edges(parts[s]) == 0, __FILE__, __LINE__,
                  name + ": part " + std::to_string(s) + " is not closed");
    sum += volume(parts[s]);
    number_of_faces += parts[s].polygons.size();
  }
  const double expected = volume(whole(mesh));
  check::report(std::abs(sum - expected) <= 1e-9 * std::abs(expected), __FILE__, __LINE__,
                name + ": volumes add up to " + std::to_string(sum) + ", not to " +
                  std::to_string(expected));
  CGAL_CHECK(parts.size() < 2 || number_of_faces > mesh.number_of_faces());
}

void test_segmentations(const Mesh& mesh, std::size_t number, const std::string& name)
{
  const auto hierarchy = CGAL::protrusion_hierarchy(mesh, number);
  Labels labels(mesh.number_of_faces()), parents;
  hierarchy.segment_ids(mesh, hierarchy.maximum_number_of_segments(),
                        boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh)));
  for (std::size_t s = 0; s < hierarchy.maximum_number_of_segments(); ++s)
    parents.push_back(hierarchy.parent(s));
  check_parts(mesh, labels, parents, name);
}

// Three segments and more at one vertex, loops that touch themselves, segments in several pieces.
void test_random_labels(const Mesh& mesh, std::size_t number, unsigned int seed, const std::string& name)
{
  const Random_segments segments(mesh, number, seed);
  check_parts(mesh, segments.labels, segments.parents, name + " at random");
}

// Two cubes next to each other become two cubes.
void test_box_in_halves()
{
  const auto mesh = to_graph<Mesh>(box(2, 1, 1));
  double smallest = mesh.point(*vertices(mesh).begin())[0], largest = smallest;
  for (const auto v : vertices(mesh))
  {
    smallest = (std::min)(smallest, mesh.point(v)[0]);
    largest = (std::max)(largest, mesh.point(v)[0]);
  }
  const auto parts = closed_parts(mesh, labels_of_halves(mesh, 0, (smallest + largest) / 2), {0, 0});
  for (const Part& part : parts)
  {
    CGAL_CHECK_EQUAL(part.points.size(), 8);
    CGAL_CHECK_EQUAL(part.polygons.size(), mesh.number_of_faces() / 2 + 2); // two triangles close a square
    CGAL_CHECK_CLOSE(volume(part), volume(whole(mesh)) / 2, 1e-12);
    CGAL_CHECK_EQUAL(number_of_open_edges(part), 0);
  }
}

// What is open stays so; the border between the parts is closed.
void test_open_mesh()
{
  const auto mesh = to_graph<Mesh>(open_cylinder());
  std::size_t number_of_border_edges = 0;
  for (const auto e : edges(mesh))
    number_of_border_edges += mesh.is_border(e) ? 1 : 0;
  std::size_t number_of_faces = 0, open_edges = 0;
  for (const auto& part : closed_parts(mesh, labels_of_halves(mesh, 2, 2), {0, 0}))
  {
    number_of_faces += part.polygons.size();
    open_edges += number_of_open_edges(part);
  }
  CGAL_CHECK(number_of_faces > mesh.number_of_faces());
  CGAL_CHECK_EQUAL(open_edges, number_of_border_edges);

  // A border from one end to the other cannot be closed.
  number_of_faces = 0;
  for (const auto& part : closed_parts(mesh, labels_of_halves(mesh, 0, 0), {0, 0}))
    number_of_faces += part.polygons.size();
  CGAL_CHECK_EQUAL(number_of_faces, mesh.number_of_faces());
}

// The faces of the segment come first, in their order.
void test_faces_of_segment()
{
  const auto mesh = to_graph<Mesh>(icosphere(2));
  const Labels halves = labels_of_halves(mesh, 2, 0);
  const std::vector<Part> parts = closed_parts(mesh, halves, {0, 0});
  std::vector<std::size_t> next = {0, 0};
  for (const auto f : faces(mesh))
  {
    const Part& part = parts[halves[f]];
    const std::vector<std::size_t>& polygon = part.polygons[next[halves[f]]++];
    std::size_t corner = 0;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      CGAL_CHECK(part.points[polygon[corner++]] == mesh.point(v));
  }
}

void test_polyhedron()
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  const Test_mesh soup = icosphere(2);
  const auto mesh = to_graph<Mesh>(soup);
  const auto polyhedron = to_graph<Polyhedron>(soup);
  const Labels halves = labels_of_halves(mesh, 2, 0);
  std::map<Polyhedron::Facet_const_handle, std::size_t> segments;
  auto half = halves.begin();
  for (const auto f : faces(polyhedron))
    segments[f] = *half++;
  std::vector<Part> parts;
  CGAL::Protrusion_segmentation::Segmentation_record<Polyhedron> record;
  CGAL::Protrusion_segmentation::Protrusion<boost::graph_traits<Polyhedron>::face_descriptor> protrusion;
  protrusion.segment = 1;
  record.on_protrusion(protrusion);
  CGAL::Protrusion_segmentation::closed_segments(polyhedron, boost::make_assoc_property_map(segments),
                                                 record, std::back_inserter(parts));
  const std::vector<Part> expected = closed_parts(mesh, halves, {0, 0});
  CGAL_CHECK_EQUAL(parts.size(), 2);
  for (std::size_t s = 0; s < 2; ++s)
  {
    CGAL_CHECK_EQUAL(number_of_open_edges(parts[s]), 0);
    CGAL_CHECK_CLOSE(volume(parts[s]), volume(expected[s]), 1e-12);
  }
}

void test_coordinate_that_is_not_finite()
{
  auto mesh = to_graph<Mesh>(icosphere(1));
  mesh.point(Mesh::Vertex_index(3)) = Mesh::Point(std::numeric_limits<double>::infinity(), 0, 0);
  CGAL_CHECK_THROWS_WITH(closed_parts(mesh, Labels(mesh.number_of_faces(), 0), {0}), std::invalid_argument,
                    "pmesh: vertex 3 has a coordinate that is not finite");
}

} // namespace

int main()
{
  const std::map<std::string, Test_mesh> meshes = {
    {"star", star(5)}, {"creature", creature()}, {"torus", torus()}, {"dumbbell", dumbbell()}};
  for (const auto& [name, soup] : meshes)
  {
    const auto mesh = to_graph<Mesh>(soup);
    for (const std::size_t number : {1, 2, 4, 8})
      test_segmentations(mesh, number, name);
    for (unsigned int seed = 0; seed < 3; ++seed)
      test_random_labels(mesh, 2 + seed, seed, name);
  }
  test_box_in_halves();
  test_open_mesh();
  test_faces_of_segment();
  test_polyhedron();
  test_coordinate_that_is_not_finite();
  return check::result();
}
