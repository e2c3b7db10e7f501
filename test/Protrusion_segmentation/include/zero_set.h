// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed triangle meshes of the surface where a function is zero. Tests and example meshes are made
// by it.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_ZERO_SET_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_ZERO_SET_H

#include "test_mesh.h"

#include <limits>

namespace test_meshes
{

struct Box
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low = {infinity, infinity, infinity};
  Point high = {-infinity, -infinity, -infinity};

  // Makes room for a ball.
  void add(const Point& center, double radius)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], center[i] - radius);
      high[i] = (std::max)(high[i], center[i] + radius);
    }
  }
};

// The values of a function at the points of a grid, layer by layer: the two layers of a sheet of
// cubes are all that is kept. `Function` has the signature `double(const Point&)`; from one point to
// another it changes by no more than twice their distance, so that one value tells the sign of all
// points near by.
template <typename Function>
class Grid_values
{
public:
  Grid_values(const Function& function, const Box& box, double cell)
    : m_function(function), m_cell(cell)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      // A margin for the fillets, and an odd fraction lest the grid meets symmetric bodies.
      m_origin[i] = box.low[i] - 3.137 * cell;
      m_size[i] = static_cast<std::size_t>((box.high[i] + 3.137 * cell - m_origin[i]) / cell) + 2;
    }
    for (std::vector<double>& layer : m_layers)
      layer.resize(m_size[0] * m_size[1]);
  }

  const std::array<std::size_t, 3>& size() const { return m_size; }

  Point point(std::size_t v) const
  {
    const std::size_t x = v % m_size[0], y = v / m_size[0] % m_size[1];
    const std::size_t z = v / m_size[0] / m_size[1];
    return m_origin + m_cell * Point{double(x), double(y), double(z)};
  }

  // Of a point in the layer computed last or in the one before. Far from the surface only the sign
  // is right.
  double operator[](std::size_t v) const
  {
    const std::size_t layer_size = m_layers[0].size();
    return m_layers[v / layer_size % 2][v % layer_size];
  }

  void compute_layer(std::size_t z)
  {
    for (std::size_t y = 0; y < m_size[1]; y += block)
      for (std::size_t x = 0; x < m_size[0]; x += block)
        compute_block(x, y, z);
  }

private:
  static constexpr std::size_t block = 8;

  void compute_block(std::size_t x_begin, std::size_t y_begin, std::size_t z)
  {
    const double half = block / 2.;
    const double nearby = 2 * std::sqrt(2.) * half * m_cell;
    const double value = m_function(
      m_origin + m_cell * Point{double(x_begin) + half, double(y_begin) + half, double(z)});
    for (std::size_t y = y_begin; y < (std::min)(y_begin + block, m_size[1]); ++y)
      for (std::size_t x = x_begin; x < (std::min)(x_begin + block, m_size[0]); ++x)
      {
        const std::size_t v = y * m_size[0] + x;
        m_layers[z % 2][v] = std::abs(value) > nearby
                               ? value : m_function(point(v + z * m_layers[0].size()));
      }
  }

  const Function& m_function;
  double m_cell;
  Point m_origin;
  std::array<std::size_t, 3> m_size;
  std::array<std::vector<double>, 2> m_layers;
};

// Marching tetrahedra: each cube of a grid is cut into six tetrahedra around its diagonal, each of
// these into inside and outside by one or two triangles. The result is closed and manifold.
template <typename Function>
class Marching_tetrahedra
{
public:
  Marching_tetrahedra(const Function& function, const Box& box, double cell)
    : m_values(function, box, cell)
  {}

  Test_mesh run()
  {
    const std::array<std::size_t, 3> size = m_values.size();
    m_values.compute_layer(0);
    for (std::size_t z = 0; z + 1 < size[2]; ++z)
    {
      m_values.compute_layer(z + 1);
      for (std::size_t y = 0; y + 1 < size[1]; ++y)
        for (std::size_t x = 0; x + 1 < size[0]; ++x)
          cut_cube((z * size[1] + y) * size[0] + x);
    }
    return std::move(m_mesh);
  }

private:
  bool is_inside(std::size_t v) const { return m_values[v] < 0; }

  bool is_cut(std::size_t corner, const std::array<std::size_t, 3>& steps) const
  {
    const bool is_first_inside = is_inside(corner);
    for (std::size_t i = 1; i < 8; ++i)
      if (is_inside(corner + (i & 1) * steps[0] + (i >> 1 & 1) * steps[1] + (i >> 2) * steps[2])
          != is_first_inside)
        return true;
    return false;
  }

  // One path of three steps along the axes from the first to the last corner of the cube for each
  // of the six orders of the axes; even orders make positive tetrahedra.
  void cut_cube(std::size_t corner)
  {
    const std::array<std::size_t, 3>& size = m_values.size();
    const std::array<std::size_t, 3> steps = {1, size[0], size[0] * size[1]};
    if (!is_cut(corner, steps))
      return;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j : {(i + 1) % 3, (i + 2) % 3})
      {
        const std::size_t k = 3 - i - j;
        std::array<std::size_t, 4> tetrahedron = {corner, corner + steps[i],
                                                  corner + steps[i] + steps[j],
                                                  corner + steps[i] + steps[j] + steps[k]};
        if (j != (i + 1) % 3)
          std::swap(tetrahedron[0], tetrahedron[1]);
        cut_tetrahedron(tetrahedron);
      }
  }

  // Moves the inside corners to the front by an even number of swaps, then cuts.
  void cut_tetrahedron(std::array<std::size_t, 4> t)
  {
    std::size_t swaps = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (!is_inside(t[j]) && is_inside(t[j + 1]))
        {
          std::swap(t[j], t[j + 1]);
          ++swaps;
        }
    const std::size_t inside = static_cast<std::size_t>(
      std::count_if(t.begin(), t.end(), [&](std::size_t v) { return is_inside(v); }));
    if (swaps % 2 == 1 && inside > 1)
      std::swap(t[0], t[1]);
    else if (swaps % 2 == 1)
      std::swap(t[2], t[3]);

    if (inside == 1)
      m_mesh.add_face({cut(t[0], t[1]), cut(t[0], t[2]), cut(t[0], t[3])});
    else if (inside == 3)
      m_mesh.add_face({cut(t[3], t[0]), cut(t[3], t[1]), cut(t[3], t[2])});
    else if (inside == 2)
    {
      const Face quad = {cut(t[0], t[2]), cut(t[0], t[3]), cut(t[1], t[3]), cut(t[1], t[2])};
      m_mesh.add_face({quad[0], quad[1], quad[2]});
      m_mesh.add_face({quad[0], quad[2], quad[3]});
    }
  }

  // The vertex on a grid edge. It keeps away from the ends, where the triangles would be slivers.
  std::size_t cut(std::size_t v, std::size_t w)
  {
    const auto found = m_vertices.emplace(std::minmax(v, w), m_mesh.points.size());
    if (found.second)
    {
      const double t = std::clamp(m_values[v] / (m_values[v] - m_values[w]), 0.2, 0.8);
      m_mesh.add_point((1 - t) * m_values.point(v) + t * m_values.point(w));
    }
    return found.first->second;
  }

  Grid_values<Function> m_values;
  std::map<Edge, std::size_t> m_vertices;
  Test_mesh m_mesh;
};

template <typename Function>
Point gradient(const Function& function, const Point& p, double step)
{
  Point result = {0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
  {
    Point before = p, after = p;
    before[i] -= step;
    after[i] += step;
    result[i] = (function(after) - function(before)) / (2 * step);
  }
  return result;
}

// One step of Newton's method from `p` towards the surface.
template <typename Function>
Point projection(const Function& function, const Point& p, double step)
{
  const Point direction = gradient(function, p, step);
  const double squared_length = dot(direction, direction);
  return squared_length == 0 ? p : p - (function(p) / squared_length) * direction;
}

// Moves each vertex to the mean of its neighbours and back to the surface, a few times.
template <typename Function>
void even_out(Test_mesh& mesh, const Function& function, double cell)
{
  std::vector<Edge> edges; // both directions of each
  for (const Face& face : mesh.faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      edges.emplace_back(face[i], face[(i + 1) % face.size()]);
  std::sort(edges.begin(), edges.end());
  for (int round = 0; round < 4; ++round)
  {
    std::vector<Point> sums(mesh.points.size(), Point{0, 0, 0});
    std::vector<double> degrees(mesh.points.size(), 0);
    for (const Edge& edge : edges)
    {
      sums[edge.first] = sums[edge.first] + mesh.points[edge.second];
      ++degrees[edge.first];
    }
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      mesh.points[v] = projection(function, (1 / degrees[v]) * sums[v], 1e-3 * cell);
  }
}

// The surface in `box` where `function` is zero, negative values inside, in triangles with edges of
// about half the length `cell`.
template <typename Function>
Test_mesh zero_set(const Function& function, const Box& box, double cell)
{
  Test_mesh mesh = Marching_tetrahedra<Function>(function, box, cell).run();
  even_out(mesh, function, cell);
  return mesh;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_ZERO_SET_H
