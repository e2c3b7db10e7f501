// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Graphs whose nodes are sets of faces.

#include "check.h"
#include "checks_of_graphs.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Disk_clusters.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/contract_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/measure_coarse_graph.h>

#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Contracted = internal::Contracted<Seam_graph>;

// To disks of a radius.
Contracted contracted(const Indexed_surface& surface, const Seam_graph& fine, double radius, bool is_parallel = false)
{
  const Centres centre = centres(surface);
  return internal::contract(fine, centre, internal::Disk_clusters(fine, centre, radius)(fine.number_of_nodes(), quiet_execution()),
                            is_parallel);
}

void coarse_nodes_are_connected_and_add_up(const Test_mesh& mesh, double radius)
{
  const Indexed_surface surface = to_surface(mesh);
  const Seam_graph fine = seam_graph(surface);
  const Contracted coarse = contracted(surface, fine, radius);
  const Index n = coarse.graph.number_of_nodes();
  CGAL_CHECK(n <= fine.number_of_nodes());
  check_symmetry(coarse.graph);

  std::vector<double> area(n, 0);
  double border = 0;
  for (Index f = 0; f < fine.number_of_nodes(); ++f)
  {
    area[coarse.node[f]] += fine.area[f];
    for (const Index arc : fine.arcs(f))
      if (coarse.node[fine.target[arc]] != coarse.node[f])
        border += fine.capacity[arc];
  }
  for (Index i = 0; i < n; ++i)
    CGAL_CHECK_CLOSE(area[i], coarse.graph.area[i], 1e-12);
  CGAL_CHECK_CLOSE(sum(coarse.graph.capacity), border, 1e-4 * (1 + border));

  // every node's faces are reached from its first one
  std::vector<bool> has_begun(n, false), is_reached(fine.number_of_nodes(), false);
  std::size_t reached = 0;
  for (Index f = 0; f < fine.number_of_nodes(); ++f)
  {
    if (has_begun[coarse.node[f]])
      continue;
    has_begun[coarse.node[f]] = true;
    std::vector<Index> queue(1, f);
    is_reached[f] = true;
    for (std::size_t i = 0; i < queue.size(); ++i, ++reached)
      for (const Index arc : fine.arcs(queue[i]))
      {
        const Index g = fine.target[arc];
        if (!is_reached[g] && coarse.node[g] == coarse.node[f])
        {
          is_reached[g] = true;
          queue.push_back(g);
        }
      }
  }
  CGAL_CHECK_EQUAL(reached, fine.number_of_nodes());
}

// Threads only save time: all nodes and weights are the same to the last bit.
void the_number_of_threads_does_not_matter()
{
#ifdef CGAL_LINKED_WITH_TBB
  const Indexed_surface surface = to_surface(jittered(icosphere(6), 0.001, 5));
  const Seam_graph fine = seam_graph(surface);
  const Contracted expected = contracted(surface, fine, 0.02), found = contracted(surface, fine, 0.02, true);
  CGAL_CHECK(found.node == expected.node && found.centre == expected.centre);
  CGAL_CHECK(found.graph.first_arc == expected.graph.first_arc && found.graph.target == expected.graph.target);
  CGAL_CHECK(found.graph.length == expected.graph.length && found.graph.area == expected.graph.area);
  CGAL_CHECK(found.graph.curvature == expected.graph.curvature &&
        found.graph.capacity == expected.graph.capacity);

  const internal::Index_groups faces_of_nodes(found.node, found.graph.number_of_nodes());
  Volume_graph volumes, expected_volumes;
  static_cast<Seam_graph&>(volumes) = found.graph;
  static_cast<Seam_graph&>(expected_volumes) = expected.graph;
  internal::measure_volumes(surface, found.node, faces_of_nodes, volumes, true);
  internal::measure_volumes(surface, found.node, faces_of_nodes, expected_volumes, false);
  CGAL_CHECK(volumes.border_vector == expected_volumes.border_vector &&
        volumes.border_area == expected_volumes.border_area);
  CGAL_CHECK(volumes.border_moment == expected_volumes.border_moment &&
        volumes.area_vector == expected_volumes.area_vector);
  CGAL_CHECK(volumes.flux == expected_volumes.flux);
#endif
}

int main()
{
  the_number_of_threads_does_not_matter();
  coarse_nodes_are_connected_and_add_up(star(4), 0.06);
  coarse_nodes_are_connected_and_add_up(sheet(20, 30), 0.1);
  coarse_nodes_are_connected_and_add_up(icosahedron(), 0.02);
  coarse_nodes_are_connected_and_add_up(merged({torus(), icosphere(3)}), 0.1);
  for (unsigned int seed = 0; seed < 20; ++seed)
    coarse_nodes_are_connected_and_add_up(random_surface(seed), 0.3);
  return check::result();
}
