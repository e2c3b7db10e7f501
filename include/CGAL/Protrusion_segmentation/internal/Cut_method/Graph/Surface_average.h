// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_SURFACE_AVERAGE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_SURFACE_AVERAGE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Disk_clusters.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/contract_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Averages vectors of the faces over about a radius on the surface, by diffusion. Where faces are small, the means of disks are
// diffused in their place, and each face gets a mean of the disks around it.
class Surface_average
{
public:
  using Index = Dual_graph::Index;
  using Values = Diffusion::Values;

  // `radius_of_disks`: a seventh of the radius to average over, or less, in units of the square root of the area. The arguments must
  // outlive the object.
  Surface_average(const Dual_graph& faces, const Centres& centre, double radius_of_disks, Execution& execution)
    : m_faces(faces), m_centre(centre), m_radius_of_disks(radius_of_disks), m_execution(execution), m_disks(disks_of(faces, centre))
  {}
  // With larger disks, made of those of the other.
  Surface_average(const Surface_average& finer, double radius_of_disks)
    : m_faces(finer.m_faces), m_centre(finer.m_centre), m_radius_of_disks(radius_of_disks), m_execution(finer.m_execution)
  {
    if (!finer.m_disks)
      m_disks = disks_of(m_faces, m_centre);
    else if (m_disks = disks_of(finer.m_disks->graph, finer.m_disks->centre); m_disks)
    {
      std::vector<Index> node(finer.m_disks->node.size());
      for_each_number(node.size(), m_execution.is_parallel(), [&](Index f) { node[f] = m_disks->node[finer.m_disks->node[f]]; });
      m_disks->node = std::move(node);
    }
    else
      m_disks = finer.m_disks;
  }

  void operator()(Values& values, double radius) const
  {
    if (!m_disks)
      return diffuse(m_faces, 1, radius, values);
    Values means = means_of_disks(values);
    diffuse(m_disks->graph, energy(m_faces) / energy(m_disks->graph), radius, means);
    for_each_number(values.size(), m_execution.is_parallel(), [&](Index f) { values[f] = mean_around(f, means); });
  }

private:
  // None if faces, or disks, are not much smaller.
  std::optional<Contracted<Dual_graph>> disks_of(const Dual_graph& graph, const Centres& centre) const
  {
    const Index n = graph.number_of_nodes();
    if (n < 2 / CGAL::square(m_radius_of_disks))
      return std::nullopt;
    Clusters disks = Disk_clusters(graph, centre, m_radius_of_disks)(n, m_execution);
    if (disks.number > n / 2) // around few large faces
      return std::nullopt;
    return contract(graph, centre, std::move(disks), m_execution.is_parallel());
  }

  // Diffusion for a time t has the variance 4 t, the mean over a disc half the square of its radius.
  // `scale`: of the conductances, see `energy()`
  void diffuse(const Dual_graph& graph, double scale, double radius, Values& values) const
  {
    constexpr int steps = 2; // which is nearer to a disc than one
    constexpr double tolerance = 1e-4; // normals need no more
    Diffusion diffusion(graph, CGAL::square(radius) / 8 / steps, scale, m_execution.is_parallel());
    for (int step = 0; step < steps; ++step)
    {
      m_execution.progress(static_cast<double>(step) / steps);
      diffusion(values, tolerance, m_execution);
    }
  }

  Values means_of_disks(const Values& values) const
  {
    Values means(m_disks->graph.number_of_nodes());
    for (Index f = 0; f < m_faces.number_of_nodes(); ++f)
    {
      const Index disk = m_disks->node[f];
      if (const double area = m_disks->graph.area[disk]; area > 0)
        means[disk] += static_cast<float>(m_faces.area[f] / area) * values[f];
    }
    return means;
  }

  // Of the disk of a face and its neighbours, nearer ones with more weight.
  Padded_vector mean_around(Index face, const Values& means) const
  {
    constexpr double reach = 1.75; // in radii of disks; with 2.5 borders are less exact
    const Contracted<Dual_graph>& disks = *m_disks;
    const Indexed_surface::Point_3 place = point(m_centre[face]);
    Padded_vector sum;
    float weights = 0;
    const auto add = [&](Index disk, double least_weight)
    {
      const double distance = (point(disks.centre[disk]) - place).squared_length() / CGAL::square(reach * m_radius_of_disks);
      const float weight = static_cast<float>(CGAL::square((std::max)(0., 1 - distance)) + least_weight);
      sum += weight * means[disk];
      weights += weight;
    };
    constexpr double of_own_disk = 1e-6; // so that there is some weight even if its faces are larger
    add(disks.node[face], of_own_disk);
    for (Index arc : disks.graph.arcs(disks.node[face]))
      add(disks.graph.target[arc], 0);
    return sum / weights;
  }

  // How much the position itself varies, by the Laplacian of the graph: twice the area, if borders are straight. Those
  // of disks are ragged, and what flows through them is scaled down by that.
  static double energy(const Dual_graph& graph)
  {
    return std::inner_product(graph.border_length.begin(), graph.border_length.end(), graph.length.begin(), 0.);
  }

  const Dual_graph& m_faces;
  const Centres& m_centre;
  double m_radius_of_disks;
  Execution& m_execution;
  std::optional<Contracted<Dual_graph>> m_disks; // of the faces, if these are many
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_SURFACE_AVERAGE_H
