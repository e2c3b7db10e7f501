// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIFFUSION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIFFUSION_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/conductance.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// In single precision, which takes half the memory.
using Average_vector = Simple_cartesian<float>::Vector_3;
using Average_vectors = std::vector<Average_vector>; // of every node

inline Average_vector single_precision(const Indexed_surface::Vector_3& v)
{
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline Indexed_surface::Vector_3 double_precision(const Average_vector& v) { return {v.x(), v.y(), v.z()}; }

// Zero of a face without area.
inline Average_vector unit_normal(const Indexed_surface& surface, Indexed_surface::Index f)
{
  const double area = surface.area(f);
  return area > 0 ? single_precision(surface.area_vector(f) / area) : Average_vector(0, 0, 0);
}

// Diffuses vectors on the nodes of a dual graph: solves (M + time * L) x = M x_0, where M holds the areas and L is the finite-volume
// Laplacian, by conjugate gradients with a diagonal preconditioner. That takes about sqrt(time * number of nodes) iterations, each
// linear. The coordinates are one system: an iteration waits for memory more than it computes.
//
// Sums are added in blocks, so that they are rounded alike with any number of threads.
class Diffusion
{
public:
  using Index = Dual_graph::Index;
  using Values = Average_vectors;

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
    const double right_hand_side = start(x);
    double rho = advance(0, x);
    for (int i = 0; i < maximum_number_of_iterations && rho > tolerance * tolerance * right_hand_side; ++i)
    {
      execution.check();
      const double before = rho, curvature = multiply(m_direction, m_product);
      rho = advance(static_cast<float>(rho / curvature), x);
      const float share = static_cast<float>(rho / before);
      for_each_node([&](Index k) { m_direction[k] = m_residual[k] / m_diagonal[k] + share * m_direction[k]; });
    }
    // Faces differ more in size than single precision can resolve: the values are averaged well enough all the same.
  }

private:
  template <typename Visit>
  void for_each_node(Visit visit) const
  {
    for_each_number(m_graph.number_of_nodes(), m_is_parallel, visit);
  }

  // The sum over the nodes.
  template <typename Term>
  double add_nodes(Term term) const
  {
    return add_numbers(m_graph.number_of_nodes(), m_is_parallel, 0., [&](double& sum, Index i) { sum += term(i); });
  }

  // a face without area still must not make the matrix singular
  double mass(Index i) const { return m_graph.area[i] + 1e-9 / m_graph.number_of_nodes(); }

  // Residuals and first directions; returns the squared norm of the right hand side.
  double start(const Values& x)
  {
    m_residual.resize(x.size());
    m_direction.resize(x.size());
    m_product.resize(x.size());
    multiply(x, m_product);
    return add_nodes(
      [&](Index k)
      {
        const Average_vector b = static_cast<float>(mass(k)) * x[k];
        m_residual[k] = b - m_product[k];
        m_direction[k] = m_residual[k] / m_diagonal[k];
        return double_precision(b).squared_length() / m_diagonal[k];
      });
  }

  // Goes `step` along the direction; returns the squared norm of the new residual.
  double advance(float step, Values& x)
  {
    return add_nodes(
      [&](Index k)
      {
        x[k] += step * m_direction[k];
        m_residual[k] -= step * m_product[k];
        return double_precision(m_residual[k]).squared_length() / m_diagonal[k];
      });
  }

  // Returns the scalar product of the values with the result.
  double multiply(const Values& x, Values& result) const
  {
    return add_nodes(
      [&](Index k)
      {
        Average_vector row = m_diagonal[k] * x[k];
        for (Index arc : m_graph.arcs(k))
          row -= m_weights[arc] * x[m_graph.target[arc]];
        result[k] = row;
        return double_precision(x[k]) * double_precision(row);
      });
  }

  const Dual_graph& m_graph;
  bool m_is_parallel;
  std::vector<float> m_diagonal;
  std::vector<float> m_weights; // of every arc
  Values m_residual, m_direction, m_product;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIFFUSION_H
