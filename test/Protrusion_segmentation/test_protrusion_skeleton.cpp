// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of shapes whose axes are known.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Protrusion_segmentation/protrusion_skeleton.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

using namespace test_meshes;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Joint = CGAL::Protrusion_segmentation::Skeleton_joint<Kernel::Point_3>;

// `parents` of the segments, their own for bodies; the tip of each is its face with the largest z.
template <typename FaceGraph>
std::vector<Joint> skeleton(const FaceGraph& mesh,
                            const std::vector<std::size_t>& labels,
                            const std::vector<std::size_t>& parents,
                            int number_of_inner_joints)
{
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;
  std::map<Face, std::size_t> segments;
  std::map<std::size_t, Face> tips;
  std::map<std::size_t, double> heights;
  auto label = labels.begin();
  for (const Face f : faces(mesh))
  {
    segments[f] = *label++;
    double height = 0;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh))
      height += get(CGAL::vertex_point, mesh, v).z() / double(CGAL::degree(f, mesh));
    if (tips.count(segments[f]) == 0 || height > heights[segments[f]])
    {
      tips[segments[f]] = f;
      heights[segments[f]] = height;
    }
  }
  CGAL::Protrusion_segmentation::Segmentation_record<FaceGraph> record;
  for (std::size_t s = 0; s < parents.size(); ++s)
    if (parents[s] != s)
    {
      CGAL::Protrusion_segmentation::Protrusion<Face> protrusion;
      protrusion.segment = s;
      protrusion.parent = parents[s];
      protrusion.tip = tips[s];
      record.on_protrusion(protrusion);
    }
  std::vector<Joint> joints;
  CGAL::Protrusion_segmentation::protrusion_skeleton(mesh, boost::make_assoc_property_map(segments),
                                                     record, number_of_inner_joints,
                                                     std::back_inserter(joints));
  return joints;
}

void check_on_axis(const Joint& joint, double z, double tolerance)
{
  CGAL_CHECK_CLOSE(joint.point.x(), 0, tolerance);
  CGAL_CHECK_CLOSE(joint.point.y(), 0, tolerance);
  CGAL_CHECK_CLOSE(joint.point.z(), z, tolerance);
}

// A cylinder of three parts, each two high: a body at the bottom, an arm, and a hand at its end.
Test_mesh arm()
{
  return revolution(Profile(0.1)
                      .line(0, 0, 0.5, 0, 0)
                      .line(0.5, 0, 0.5, 2, 0)
                      .line(0.5, 2, 0.5, 4, 1)
                      .line(0.5, 4, 0.5, 6, 2)
                      .line(0.5, 6, 0, 6, 2),
                    32);
}

template <typename FaceGraph>
void test_rig(double tolerance)
{
  const Test_mesh soup = arm();
  const std::vector<Joint> joints = skeleton(to_graph<FaceGraph>(soup), soup.parts, {0, 0, 1}, 0);
  CGAL_CHECK_EQUAL(joints.size(), 5);
  // The bottom, of area pi / 4, is at height 0, and the wall, of area 2 pi, is at height 1 in the mean.
  check_on_axis(joints[0], 2 / 2.25, 2e-2);
  check_on_axis(joints[1], 2, tolerance);
  check_on_axis(joints[3], 4, tolerance);
  const std::vector<std::size_t> parents = {0, 0, 1, 1, 3}, segments = {0, 1, 1, 2, 2};
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    CGAL_CHECK_EQUAL(joints[i].parent, parents[i]);
    CGAL_CHECK_EQUAL(joints[i].segment, segments[i]);
    CGAL_CHECK_EQUAL(joints[i].is_tip, i == 2 || i == 4);
  }
  CGAL_CHECK(joints[2].point.z() > 3.9 && joints[2].point.z() < 4);
  CGAL_CHECK_CLOSE(joints[4].point.z(), 6, 1e-12);
}

void test_inner_joints()
{
  const Test_mesh soup = arm();
  const std::vector<Joint> joints = skeleton(to_graph<Mesh>(soup), soup.parts, {0, 0, 1}, 3);
  CGAL_CHECK_EQUAL(joints.size(), 1 + 5 + 5);
  for (std::size_t i = 2; i < 5; ++i) // at quarters of the arm
  {
    check_on_axis(joints[i], 2 + 0.5 * double(i - 1), 0.06);
    CGAL_CHECK_EQUAL(joints[i].parent, i - 1);
  }
  CGAL_CHECK(joints[5].is_tip);
  CGAL_CHECK_EQUAL(joints[5].parent, 4);
  CGAL_CHECK_EQUAL(joints[6].parent, 4); // the hand hangs on the last inner joint of the arm
  check_on_axis(joints[6], 4, 1e-12);
}

void test_mesh_of_any_size()
{
  const Test_mesh soup = arm();
  for (const double size : {1e-200, 1e200})
  {
    std::vector<Joint> joints = skeleton(to_graph<Mesh>(scaled(soup, size)), soup.parts, {0, 0, 1}, 1);
    for (Joint& joint : joints)
      joint.point = Kernel::Point_3(joint.point.x() / size, joint.point.y() / size,
                                    joint.point.z() / size);
    const std::vector<Joint> expected = skeleton(to_graph<Mesh>(soup), soup.parts, {0, 0, 1}, 1);
    CGAL_CHECK_EQUAL(joints.size(), expected.size());
    for (std::size_t i = 0; i < joints.size(); ++i)
      CGAL_CHECK(CGAL::squared_distance(joints[i].point, expected[i].point) < 1e-20);
  }
}

// Two bodies are two roots; a protrusion that does not touch its parent has its joint in its middle.
void test_components()
{
  const Test_mesh soup = arm();
  const std::vector<Joint> two = skeleton(to_graph<Mesh>(soup), soup.parts, {0, 0, 2}, 0);
  CGAL_CHECK_EQUAL(two.size(), 4);
  CGAL_CHECK_EQUAL(two[3].parent, 3);
  CGAL_CHECK_EQUAL(two[3].segment, 2);
  const std::vector<Joint> apart = skeleton(to_graph<Mesh>(soup), soup.parts, {0, 0, 0}, 2);
  CGAL_CHECK_EQUAL(apart.size(), 1 + 4 + 2); // the hand does not touch the body, and has no inner joints
  CGAL_CHECK_EQUAL(apart[5].parent, 0);
  CGAL_CHECK(apart[5].point.z() > 5 && apart[5].point.z() < 5.5);
}

void test_wrong_arguments()
{
  Mesh mesh = to_graph<Mesh>(arm());
  const Test_mesh soup = arm();
  CGAL_CHECK_THROWS_WITH(skeleton(mesh, soup.parts, {0, 0, 1}, -1), std::invalid_argument,
                    "number_of_inner_joints is -1, but it must be at least 0");
  mesh.point(Mesh::Vertex_index(3)) = Kernel::Point_3(std::numeric_limits<double>::infinity(), 0, 0);
  CGAL_CHECK_THROWS_WITH(skeleton(mesh, soup.parts, {0, 0, 1}, 0), std::invalid_argument,
                    "pmesh: vertex 3 has a coordinate that is not finite");
}

int main()
{
  test_rig<Mesh>(1e-12);
  test_rig<CGAL::Polyhedron_3<Kernel>>(1e-12);
  test_inner_joints();
  test_mesh_of_any_size();
  test_components();
  test_wrong_arguments();
  return check::result();
}
