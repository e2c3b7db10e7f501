// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A distance of one's own: ways across bent edges are longer, so that its level sets, and with them
// the borders, gather where the surface is bent. The paper's method gets it in place of its own.

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>
#include <CGAL/segmentation_metrics.h>

#include "read_or_make_mesh.h"

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CGAL::Protrusion_segmentation::Indexed_surface;

// A model of ProtrusionDistance.
struct Bent_distance
{
  // A model of ProtrusionDistancesOnSurface.
  class On_surface
  {
  public:
    explicit On_surface(const Indexed_surface& surface) : m_graph(surface.dual_graph())
    {
      for (const auto arc : CGAL::make_range(edges(m_graph)))
      {
        const auto a = surface.area_vector(source(arc, m_graph));
        const auto b = surface.area_vector(target(arc, m_graph));
        const double areas = std::sqrt(a.squared_length() * b.squared_length());
        const double bend = areas > 0 ? 1 - a * b / areas : 0; // 0 flat, 1 a right angle, 2 folded
        m_lengths.push_back(m_graph[arc].length * (1 + 20 * bend));
      }
    }

    void operator()(Indexed_surface::Index source, std::vector<double>& distances)
    {
      distances.resize(num_vertices(m_graph));
      boost::dijkstra_shortest_paths(
        m_graph, source,
        boost::distance_map(boost::make_iterator_property_map(distances.begin(),
                                                              get(boost::vertex_index, m_graph)))
          .weight_map(boost::make_iterator_property_map(m_lengths.begin(),
                                                        get(boost::edge_index, m_graph))));
    }

    // Optional, but without it distances are computed from every face. An end of the longest way found
    // in two steps is at the tip of a protrusion, too.
    Indexed_surface::Index face_of_largest_sum()
    {
      std::vector<double> distances;
      Indexed_surface::Index farthest = 0;
      for (int i = 0; i < 2; ++i)
      {
        (*this)(farthest, distances);
        farthest = static_cast<Indexed_surface::Index>(
          std::max_element(distances.begin(), distances.end()) - distances.begin());
      }
      return farthest;
    }

  private:
    Indexed_surface::Dual_graph m_graph;
    std::vector<double> m_lengths; // of the arcs
  };

  // An Execution has the random seed and knows whether to stop; this distance is not random and soon ready.
  On_surface on(const Indexed_surface& surface, CGAL::Protrusion_segmentation::Execution& /* execution */) const
  {
    return On_surface(surface);
  }
};

// protrusion_distance_example [MESH]
int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!read_or_make_mesh(argc, argv, mesh))
    return EXIT_FAILURE;

  using CGAL::Protrusion_segmentation::Histogram_method;
  auto usual = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:usual").first;
  auto own = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:own").first;
  CGAL::segmentation_via_protrusion_tips(mesh, usual, 7, Histogram_method());
  const std::size_t number_of_segments =
    CGAL::segmentation_via_protrusion_tips(mesh, own, 7, Histogram_method(Bent_distance()));

  // Segments may be numbered differently, so it is pairs of faces that are compared.
  std::cout << number_of_segments << " segments; the distances disagree for a share of "
            << CGAL::Protrusion_segmentation::segmentation_rand_index_error(mesh, usual, own)
            << "\nof all pairs of faces whether they belong together" << std::endl;
  return EXIT_SUCCESS;
}
