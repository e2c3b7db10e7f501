// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clusters that become nodes of the coarse graph.

#include "check.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Disk_clusters.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Clusters;

constexpr Index no_limit = 1000000;

Clusters clusters_of(const Test_mesh& mesh, Index largest_number = no_limit)
{
  const Indexed_surface surface = to_surface(mesh);
  const Seam_graph graph = seam_graph(surface);
  const Centres centre = centres(surface);
  return internal::Disk_clusters(graph, centre, 0.026)(largest_number, quiet_execution());
}

// Of clusters, the number of connected pieces of their nodes.
std::size_t number_of_pieces(const Seam_graph& graph, const Clusters& clusters)
{
  std::vector<bool> is_reached(graph.number_of_nodes(), false);
  std::size_t pieces = 0;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
  {
    if (is_reached[i])
      continue;
    ++pieces;
    std::vector<Index> queue(1, i);
    is_reached[i] = true;
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (const Index arc : graph.arcs(queue[k]))
        if (const Index j = graph.target[arc];
            !is_reached[j] && clusters.of_node[j] == clusters.of_node[i])
        {
          is_reached[j] = true;
          queue.push_back(j);
        }
  }
  return pieces;
}

void clusters_are_connected(const Test_mesh& mesh)
{
  const Seam_graph graph = seam_graph(mesh);
  for (const Index largest_number : {no_limit, Index(50), Index(1)})
  {
    const Clusters clusters = clusters_of(mesh, largest_number);
    CGAL_CHECK(clusters.number >= 1 && clusters.number <= largest_number);
    CGAL_CHECK_EQUAL(clusters.of_node.size(), graph.number_of_nodes());
    std::vector<bool> has_node(clusters.number, false);
    for (const Index cluster : clusters.of_node)
      has_node.at(cluster) = true;
    CGAL_CHECK(std::find(has_node.begin(), has_node.end(), false) == has_node.end());
    CGAL_CHECK_EQUAL(number_of_pieces(graph, clusters), clusters.number);
  }
}

// A shape of area 1 has some 1,400 disks of the radius, however fine its triangles are.
void their_number_does_not_depend_on_the_triangles()
{
  const double coarse = clusters_of(icosphere(5)).number;
  const double fine = clusters_of(icosphere(6)).number;
  CGAL_CHECK(coarse > 1200 && coarse < 1700);
  CGAL_CHECK(fine > 0.9 * coarse && fine < 1.2 * coarse);
}

void a_mirrored_shape_has_mirrored_clusters()
{
  const Test_mesh mesh = bumpy_sphere(5, 3);
  Test_mesh mirror = mesh;
  for (Point& p : mirror.points)
    p[0] = -p[0];
  for (Face& face : mirror.faces)
    std::reverse(face.begin() + 1, face.end());
  CGAL_CHECK(clusters_of(mesh).of_node == clusters_of(mirror).of_node);
}

// The share of the arcs within clusters that lie between clusters of the other graph, or the other way round.
double difference(const Seam_graph& graph, const Clusters& a, const Clusters& b)
{
  std::size_t different = 0;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    for (const Index arc : graph.arcs(i))
    {
      const Index j = graph.target[arc];
      different += (a.of_node[i] == a.of_node[j]) != (b.of_node[i] == b.of_node[j]);
    }
  return static_cast<double>(different) / static_cast<double>(graph.target.size());
}

// What moves a little changes little: clusters by merging would be all others.
void a_moved_vertex_changes_clusters_nearby()
{
  Test_mesh mesh = bumpy_sphere(5, 4);
  const Seam_graph graph = seam_graph(mesh);
  const Clusters clusters = clusters_of(mesh);
  const double edge = length(mesh.points[mesh.faces[0][0]] - mesh.points[mesh.faces[0][1]]);
  const Clusters all_moved = clusters_of(jittered(mesh, 0.01 * edge, 1));
  mesh.points[0] = 1.01 * mesh.points[0];
  const Clusters one_moved = clusters_of(mesh);
  CGAL_CHECK(difference(graph, clusters, one_moved) < 0.01);
  CGAL_CHECK(difference(graph, clusters, all_moved) < 0.1);
}

int main()
{
  clusters_are_connected(star(4));
  clusters_are_connected(sheet(60, 50));
  clusters_are_connected(thin_strip(300));
  clusters_are_connected(single_triangle());
  their_number_does_not_depend_on_the_triangles();
  a_mirrored_shape_has_mirrored_clusters();
  a_moved_vertex_changes_clusters_nearby();
  return check::result();
}
