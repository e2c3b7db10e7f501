// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIFFUSION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIFFUSION_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/conductance.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A vector and a zero: four numbers, which a processor adds at once. Operators act on each number. Eigen has such arrays, but the
// default method needs no Eigen.
template <typename Number>
struct Four_numbers
{
  alignas(16) std::array<Number, 4> of = {0, 0, 0, 0};

  Number& operator[](std::size_t i) { return of[i]; }
  Number operator[](std::size_t i) const { return of[i]; }

  template <typename Other>
  Four_numbers<Other> as() const
  {
    return {{static_cast<Other>(of[0]), static_cast<Other>(of[1]), static_cast<Other>(of[2]), static_cast<Other>(of[3])}};
  }
  Four_numbers& operator+=(const Four_numbers& b) { return *this = *this + b; }
  Four_numbers& operator-=(const Four_numbers& b) { return *this = *this - b; }
  friend Four_numbers operator+(const Four_numbers& a, const Four_numbers& b) { return of_each(a, b, std::plus<>()); }
  friend Four_numbers operator-(const Four_numbers& a, const Four_numbers& b) { return of_each(a, b, std::minus<>()); }
  friend Four_numbers operator*(const Four_numbers& a, const Four_numbers& b) { return of_each(a, b, std::multiplies<>()); }
  friend Four_numbers operator*(Number a, const Four_numbers& b) { return Four_numbers{{a, a, a, a}} * b; }
  friend Four_numbers operator/(const Four_numbers& a, Number b) { return of_each(a, {{b, b, b, b}}, std::divides<>()); }

private:
  template <typename Operation>
  static Four_numbers of_each(const Four_numbers& a, const Four_numbers& b, Operation operation)
  {
    Four_numbers result;
    for (std::size_t i = 0; i < 4; ++i)
      result.of[i] = operation(a.of[i], b.of[i]);
    return result;
  }
};

using Padded_vector = Four_numbers<float>;
using Padded_vectors = std::vector<Padded_vector>; // of every node

inline Padded_vector padded(const Indexed_surface::Vector_3& v)
{
  return {{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0}};
}

inline Indexed_surface::Vector_3 unpadded(const Padded_vector& v) { return {v[0], v[1], v[2]}; }

// Zero of a face without area.
inline Padded_vector unit_normal(const Indexed_surface& surface, Indexed_surface::Index f)
{
  const double area = surface.area(f);
  return area > 0 ? padded(surface.area_vector(f) / area) : Padded_vector();
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
    Sums rho = advance(Padded_vector(), x);
    const auto is_solved = [&](std::size_t i) { return !(rho[i] > tolerance * tolerance * right_hand_side[i]); };
    for (int iteration = 0; iteration < maximum_number_of_iterations; ++iteration)
    {
      execution.check();
      if (is_solved(0) && is_solved(1) && is_solved(2))
        return;
      const Sums curvature = multiply(m_direction, m_product);
      Padded_vector step, share;
      for (std::size_t i = 0; i < 3; ++i)
        step[i] = is_solved(i) ? 0 : static_cast<float>(rho[i] / curvature[i]);
      const Sums before = rho;
      rho = advance(step, x);
      for (std::size_t i = 0; i < 3; ++i)
        share[i] = before[i] > 0 ? static_cast<float>(rho[i] / before[i]) : 0;
      for_each_node([&](Index k) { m_direction[k] = m_residual[k] / m_diagonal[k] + share * m_direction[k]; });
    }
    // Faces differ more in size than single precision can resolve: the values are averaged well enough all the same.
  }

private:
  using Sums = Four_numbers<double>;

  template <typename Visit>
  void for_each_node(Visit visit) const
  {
    for_each_number(m_graph.number_of_nodes(), m_is_parallel, visit);
  }

  // `add(sums, node)` adds the terms of a node.
  template <typename Add>
  Sums add_nodes(Add add) const
  {
    return add_numbers(m_graph.number_of_nodes(), m_is_parallel, Sums(), add);
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
        const Sums b = mass(k) * x[k].as<double>();
        m_residual[k] = (b - m_product[k].as<double>()).as<float>();
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
        sums += m_residual[k].as<double>() * (m_residual[k] / m_diagonal[k]).as<double>();
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
        sums += x[k].as<double>() * row.as<double>();
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
