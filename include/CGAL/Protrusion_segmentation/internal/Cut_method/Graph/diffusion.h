// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIFFUSION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIFFUSION_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/coarsen_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/conductance.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A vector and a zero: four numbers, which a processor adds at once.
using Padded_vector = Eigen::Array4f;
using Padded_vectors = std::vector<Padded_vector>; // of every node

inline Padded_vector padded(const Indexed_surface::Vector_3& v)
{
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0};
}

inline Indexed_surface::Vector_3 unpadded(const Padded_vector& v) { return {v[0], v[1], v[2]}; }

// Zero of a face without area.
inline Padded_vector unit_normal(const Indexed_surface& surface, Indexed_surface::Index f)
{
  const double area = surface.area(f);
  return area > 0 ? padded(surface.area_vector(f) / area) : Padded_vector::Zero();
}

// Diffuses vectors on the nodes of a dual graph: solves (M + time * L) x = M x_0 for each coordinate, where M holds the
// areas and L is the finite-volume Laplacian, by conjugate gradients with a diagonal preconditioner. That takes about
// sqrt(time * number of nodes) iterations, each linear.
//
// The three systems are solved side by side, since an iteration waits for memory more than it computes. Sums are added
// in blocks, so that they are rounded alike with any number of threads.
class Diffusion
{
public:
  using Index = Dual_graph::Index;
  using Values = Padded_vectors;

  // `scale`: of the conductances
  Diffusion(const Dual_graph& graph, double time, double scale = 1, bool is_parallel = false)
    : m_graph(graph),
      m_is_parallel(is_parallel),
      m_diagonal(graph.number_of_nodes()),
      m_weights(graph.target.size())
  {
    const float shortest = static_cast<float>(shortest_length(1, graph.number_of_nodes()));
    for_each_node(
      [&](Index i)
      {
        double sum = mass(i);
        for (Index arc : graph.arcs(i))
        {
          m_weights[arc] =
            static_cast<float>(time * scale * conductance(graph.border_length[arc], graph.length[arc], shortest));
          sum += m_weights[arc];
        }
        m_diagonal[i] = static_cast<float>(sum);
      });
  }

  // Replaces `x` by the diffused values, up to a residual of `tolerance` relative to the right hand side.
  void operator()(Values& x, double tolerance, Execution& execution)
  {
    constexpr int maximum_number_of_iterations = 200; // some ten to thirty are usual
    const Sums right_hand_side = start(x);
    Sums rho = advance(Padded_vector::Zero(), x);
    const auto is_solved = [&](Eigen::Index i) { return !(rho[i] > tolerance * tolerance * right_hand_side[i]); };
    for (int iteration = 0; iteration < maximum_number_of_iterations; ++iteration)
    {
      execution.check();
      if (is_solved(0) && is_solved(1) && is_solved(2))
        return;
      const Sums curvature = multiply(m_direction, m_product);
      Padded_vector step = Padded_vector::Zero(), share = step;
      for (Eigen::Index i = 0; i < 3; ++i)
        step[i] = is_solved(i) ? 0 : static_cast<float>(rho[i] / curvature[i]);
      const Sums before = rho;
      rho = advance(step, x);
      for (Eigen::Index i = 0; i < 3; ++i)
        share[i] = before[i] > 0 ? static_cast<float>(rho[i] / before[i]) : 0;
      for_each_node([&](Index k) { m_direction[k] = m_residual[k] / m_diagonal[k] + share * m_direction[k]; });
    }
    // Faces differ more in size than single precision can resolve: the values are averaged well enough all the same.
  }

private:
  using Sums = Eigen::Array4d;

  template <typename Visit>
  void for_each_node(Visit visit) const
  {
    for_each_number(m_graph.number_of_nodes(), m_is_parallel, visit);
  }

  // `add(sums, node)` adds the terms of a node.
  template <typename Add>
  Sums add_nodes(Add add) const
  {
    return add_numbers(m_graph.number_of_nodes(), m_is_parallel, Sums(Sums::Zero()), add);
  }

  // a face without area still must not make the matrix singular
  double mass(Index i) const { return m_graph.area[i] + 1e-9 / m_graph.number_of_nodes(); }

  // Residuals and first directions; returns the norms of the right hand sides.
  Sums start(const Values& x)
  {
    m_residual.resize(x.size());
    m_direction.resize(x.size());
    m_product.resize(x.size());
    multiply(x, m_product);
    return add_nodes(
      [&](Sums& norms, Index k)
      {
        const Sums b = mass(k) * x[k].cast<double>();
        m_residual[k] = (b - m_product[k].cast<double>()).cast<float>();
        m_direction[k] = m_residual[k] / m_diagonal[k];
        norms += b * b / m_diagonal[k];
      });
  }

  // Goes `step` along the direction; returns the norms of the new residuals.
  Sums advance(const Padded_vector& step, Values& x)
  {
    return add_nodes(
      [&](Sums& sums, Index k)
      {
        x[k] += step * m_direction[k];
        m_residual[k] -= step * m_product[k];
        sums += m_residual[k].cast<double>() * (m_residual[k] / m_diagonal[k]).cast<double>();
      });
  }

  // Returns the scalar products of the values with the result.
  Sums multiply(const Values& x, Values& result) const
  {
    return add_nodes(
      [&](Sums& sums, Index k)
      {
        Padded_vector row = m_diagonal[k] * x[k];
        for (Index arc : m_graph.arcs(k))
          row -= m_weights[arc] * x[m_graph.target[arc]];
        result[k] = row;
        sums += x[k].cast<double>() * row.cast<double>();
      });
  }

  const Dual_graph& m_graph;
  bool m_is_parallel;
  std::vector<float> m_diagonal;
  std::vector<float> m_weights; // of every arc
  Values m_residual, m_direction, m_product;
};

// Averages vectors over about a radius on the surface. Where faces are small for the radius that is done on groups of
// about four nodes first, and so on, and the steps between groups are smoothed away: the time for a face does not grow
// with their number.
class Multilevel_diffusion
{
public:
  using Index = Dual_graph::Index;
  using Values = Diffusion::Values;

  Multilevel_diffusion(double radius, Execution& execution) : m_radius(radius), m_execution(execution) {}

  // Diffusion for a time t has the variance 4 t, the mean over a disc half the square of its radius.
  void operator()(const Dual_graph& graph, const Centres& centre, Values& values) const
  {
    diffuse(graph, centre, 1, CGAL::square(m_radius) / 8, values);
  }

private:
  // Groups are no larger than that share of the radius.
  static constexpr double largest_group = 1. / 6;

  // `scale`: of the conductances, see `energy()`
  void diffuse(const Dual_graph& graph, const Centres& centre, double scale, double time, Values& values) const
  {
    const double least_number_of_groups = 1 / CGAL::square(largest_group * m_radius);
    std::optional<double> time_between_groups;
    if (graph.number_of_nodes() >= 2 * least_number_of_groups)
      time_between_groups = diffuse_groups(
        graph, centre, scale, time, static_cast<Index>((std::max)(graph.number_of_nodes() / 4., least_number_of_groups)), values);
    if (!time_between_groups)
      return diffuse_twice(graph, scale, time, values);
    constexpr double tolerance = 1e-2;
    Diffusion(graph, *time_between_groups, scale, m_execution.is_parallel())(values, tolerance, m_execution);
  }

  // Diffuses the means of about `number` groups; returns how long the steps between these are to be smoothed: over about
  // the size of a group. Does nothing if the nodes do not come together, such as those around one that is large.
  std::optional<double> diffuse_groups(const Dual_graph& graph, const Centres& centre, double scale, double time, Index number, Values& values) const
  {
    const Contracted<Dual_graph> groups = coarsen(graph, centre, graph.border_length, number, m_execution);
    if (groups.graph.number_of_nodes() > graph.number_of_nodes() / 2)
      return std::nullopt;
    Values means = means_of_groups(graph, groups, values);
    const double time_between_groups = 1. / groups.graph.number_of_nodes();
    diffuse(groups.graph, groups.centre, scale * energy(graph) / energy(groups.graph), time - time_between_groups, means);
    for_each_number(graph.number_of_nodes(), m_execution.is_parallel(), [&](Index i) { values[i] = means[groups.node[i]]; });
    return time_between_groups;
  }

  void diffuse_twice(const Dual_graph& graph, double scale, double time, Values& values) const
  {
    constexpr int steps = 2; // which is nearer to a disc than one
    constexpr double tolerance = 1e-4; // normals need no more
    Diffusion diffusion(graph, time / steps, scale, m_execution.is_parallel());
    for (int step = 0; step < steps; ++step)
    {
      m_execution.progress(static_cast<double>(step) / steps);
      diffusion(values, tolerance, m_execution);
    }
  }

  static Values means_of_groups(const Dual_graph& graph, const Contracted<Dual_graph>& groups, const Values& values)
  {
    Values means(groups.graph.number_of_nodes(), Padded_vector::Zero());
    for (Index i = 0; i < graph.number_of_nodes(); ++i)
    {
      const Index group = groups.node[i];
      if (const double area = groups.graph.area[group]; area > 0)
        means[group] += static_cast<float>(graph.area[i] / area) * values[i];
    }
    return means;
  }

  // How much the position itself varies, by the Laplacian of the graph: twice the area, if borders are straight. Those
  // of groups are ragged, and what flows through them is scaled down by that.
  static double energy(const Dual_graph& graph)
  {
    return std::inner_product(graph.border_length.begin(), graph.border_length.end(), graph.length.begin(), 0.);
  }

  double m_radius;
  Execution& m_execution;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIFFUSION_H
