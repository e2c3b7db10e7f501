// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PLATE_RIMS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PLATE_RIMS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/coarsen_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Finds the rims of thin plates: faces that look sideways where nearly all of the surface around them looks to the one side or the
// other. Of a plate only the outline shows what sticks out, as of a sheet.
class Plate_rims
{
public:
  using Index = Indexed_surface::Index;

  // The arguments must outlive the object.
  Plate_rims(const Indexed_surface& surface, Execution& execution) : m_surface(surface), m_execution(execution) {}

  // For each face whether it lies on a rim; nothing if none does. `graph` is the dual graph of the surface, `centre` its centres
  std::vector<bool> operator()(const Dual_graph& graph, const Centres& centre) const
  {
    constexpr double largest_group = 1. / 6; // of the radius
    const double number = 1 / CGAL::square(largest_group * radius);
    if (graph.number_of_nodes() < 2 * number)
      return rims(graph, graph, centre, nullptr);
    const Contracted<Dual_graph> groups = coarsen(graph, centre, graph.border_length, static_cast<Index>(number), m_execution);
    return rims(graph, groups.graph, groups.centre, &groups.node);
  }

private:
  // Over which normals are compared, in units of the square root of the area: with .2 fewer thin plates are right, with .1 none.
  static constexpr double radius = 0.15;

  // The mean unit normals, and the mean products of their coordinates, which are the same for opposite normals.
  struct Normal_moments
  {
    Triples means, squares, products; // the latter xx, yy, zz and xy, yz, zx

    explicit Normal_moments(std::size_t size) : means(size, {0, 0, 0}), squares(means), products(means) {}

    void add(std::size_t i, const Triple& n, double weight)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        means[i][k] += static_cast<float>(weight * n[k]);
        squares[i][k] += static_cast<float>(weight * n[k] * n[k]);
        products[i][k] += static_cast<float>(weight * n[k] * n[(k + 1) % 3]);
      }
    }
    // the mean squared cosine of the angle to a unit normal
    double along(std::size_t i, const Triple& n) const
    {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += n[k] * (squares[i][k] * n[k] + 2 * products[i][k] * n[(k + 1) % 3]);
      return sum;
    }
    double squared_mean(std::size_t i) const
    {
      return CGAL::square(means[i][0]) + CGAL::square(means[i][1]) + CGAL::square(means[i][2]);
    }
    double trace(std::size_t i) const { return squares[i][0] + squares[i][1] + squares[i][2]; }
    double squared_norm(std::size_t i) const
    {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += CGAL::square(squares[i][k]) + 2 * CGAL::square(products[i][k]);
      return sum;
    }
  };

  // `faces`: their graph; `group`: of each face its node in the other graph, if that is one of groups
  std::vector<bool>
  rims(const Dual_graph& faces, const Dual_graph& graph, const Centres& centre, const std::vector<Index>* group) const
  {
    const auto node = [&](Index f) { return group ? (*group)[f] : f; };
    Normal_moments moments(graph.number_of_nodes());
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      if (const double area = graph.area[node(f)]; area > 0)
        moments.add(node(f), normal(f), faces.area[f] / area);
    Multilevel_diffusion average(radius, m_execution);
    average(graph, centre, moments.means);
    average(graph, centre, moments.squares);
    average(graph, centre, moments.products);
    std::vector<bool> result(m_surface.number_of_faces());
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      result[f] = is_rim(moments, node(f), normal(f));
    if (std::find(result.begin(), result.end(), true) == result.end())
      result.clear();
    return result;
  }

  // On an edge of a block half of the normals are along each of two directions, and the squared norm is half of the squared trace. In
  // terrain nearly all normals are along the same direction, too, but not opposite to each other: their mean is long.
  static bool is_rim(const Normal_moments& moments, Index i, const Triple& n)
  {
    constexpr double largest_share_sideways = 0.4, least_squared_norm = 0.55, largest_squared_mean = 0.25;
    const double trace = moments.trace(i);
    return moments.along(i, n) < largest_share_sideways * trace &&
           moments.squared_norm(i) > least_squared_norm * CGAL::square(trace) && moments.squared_mean(i) < largest_squared_mean;
  }

  Triple normal(Index f) const
  {
    const double area = m_surface.area(f);
    return area > 0 ? triple(m_surface.area_vector(f) / area) : Triple{0, 0, 0};
  }

  const Indexed_surface& m_surface;
  Execution& m_execution;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PLATE_RIMS_H
