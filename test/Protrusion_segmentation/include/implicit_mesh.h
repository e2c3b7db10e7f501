// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed triangle meshes around smoothly blended balls and tapered sticks.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_IMPLICIT_MESH_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_IMPLICIT_MESH_H

#include "test_mesh.h"

#include <limits>

namespace test_meshes
{

// A stick from `from` to `to` with round ends and linearly changing radius; a ball if both are one
// point.
struct Stick
{
  Point from, to;
  double radius_from, radius_to;
  std::size_t part;

  // Negative inside; a distance up to the taper.
  double distance(const Point& p) const
  {
    const Point axis = to - from;
    const double squared_length = dot(axis, axis);
    const double t = squared_length == 0
                       ? 0 : std::clamp(dot(p - from, axis) / squared_length, 0., 1.);
    return length(p - (from + t * axis)) - (radius_from + t * (radius_to - radius_from));
  }
};

inline Stick ball(const Point& center, double radius, std::size_t part)
{
  return {center, center, radius, radius, part};
}

class Implicit_body
{
public:
  // `blend`: the size of the fillets where sticks meet.
  Implicit_body(std::vector<Stick> sticks, double blend)
    : m_sticks(std::move(sticks)), m_blend(blend) {}

  // A smooth minimum of the distances; it does not depend on the order of the sticks.
  double value(const Point& p) const
  {
    double nearest = std::numeric_limits<double>::max();
    for(const Stick& stick : m_sticks)
      nearest = std::min(nearest, stick.distance(p));
    double sum = 0;
    for(const Stick& stick : m_sticks)
      sum += std::exp((nearest - stick.distance(p)) / m_blend);
    return nearest - m_blend * std::log(sum);
  }

  // The part of the stick with the nearest surface.
  std::size_t part(const Point& p) const
  {
    return std::min_element(m_sticks.begin(), m_sticks.end(), [&](const Stick& a, const Stick& b)
    {
      return a.distance(p) < b.distance(p);
    })->part;
  }

  // One step of Newton's method towards the surface.
  Point projection(const Point& p, double step) const
  {
    Point gradient = {0, 0, 0};
    for(std::size_t i = 0; i < 3; ++i)
    {
      Point before = p, after = p;
      before[i] -= step;
      after[i] += step;
      gradient[i] = (value(after) - value(before)) / (2 * step);
    }
    const double squared_length = dot(gradient, gradient);
    return squared_length == 0 ? p : p - (value(p) / squared_length) * gradient;
  }

  const std::vector<Stick>& sticks() const { return m_sticks; }

private:
  std::vector<Stick> m_sticks;
  double m_blend;
};

// Marching tetrahedra: each cube of a grid is cut into six tetrahedra around its diagonal, each of
// these into inside and outside by one or two triangles. The result is closed and manifold.
class Marching_tetrahedra
{
public:
  Marching_tetrahedra(const Implicit_body& body, double cell) : m_cell(cell)
  {
    Point low, high;
    low.fill(std::numeric_limits<double>::max());
    high.fill(std::numeric_limits<double>::lowest());
    for(const Stick& stick : body.sticks())
      for(std::size_t i = 0; i < 3; ++i)
      {
        const double radius = std::max(stick.radius_from, stick.radius_to);
        low[i] = std::min({low[i], stick.from[i] - radius, stick.to[i] - radius});
        high[i] = std::max({high[i], stick.from[i] + radius, stick.to[i] + radius});
      }
    for(std::size_t i = 0; i < 3; ++i)
    {
      // A margin for the fillets, and an odd fraction lest the grid meets symmetric bodies.
      m_origin[i] = low[i] - 3.137 * cell;
      m_size[i] = static_cast<std::size_t>((high[i] + 3.137 * cell - m_origin[i]) / cell) + 2;
    }
    for(std::size_t v = 0; v < m_size[0] * m_size[1] * m_size[2]; ++v)
      m_values.push_back(body.value(grid_point(v)));
  }

  Test_mesh run()
  {
    for(std::size_t z = 0; z + 1 < m_size[2]; ++z)
      for(std::size_t y = 0; y + 1 < m_size[1]; ++y)
        for(std::size_t x = 0; x + 1 < m_size[0]; ++x)
          cut_cube((z * m_size[1] + y) * m_size[0] + x);
    return std::move(m_mesh);
  }

private:
  Point grid_point(std::size_t v) const
  {
    const std::size_t x = v % m_size[0], y = v / m_size[0] % m_size[1];
    const std::size_t z = v / m_size[0] / m_size[1];
    return m_origin + m_cell * Point{double(x), double(y), double(z)};
  }

  bool is_inside(std::size_t v) const { return m_values[v] < 0; }

  // One path of three steps along the axes from the first to the last corner of the cube for each
  // of the six orders of the axes; even orders make positive tetrahedra.
  void cut_cube(std::size_t corner)
  {
    const std::array<std::size_t, 3> steps = {1, m_size[0], m_size[0] * m_size[1]};
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j : {(i + 1) % 3, (i + 2) % 3})
      {
        const std::size_t k = 3 - i - j;
        std::array<std::size_t, 4> tetrahedron = {corner, corner + steps[i],
                                                  corner + steps[i] + steps[j],
                                                  corner + steps[i] + steps[j] + steps[k]};
        if(j != (i + 1) % 3)
          std::swap(tetrahedron[0], tetrahedron[1]);
        cut_tetrahedron(tetrahedron);
      }
  }

  // Moves the inside corners to the front by an even number of swaps, then cuts.
  void cut_tetrahedron(std::array<std::size_t, 4> t)
  {
    std::size_t swaps = 0;
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        if(!is_inside(t[j]) && is_inside(t[j + 1]))
        {
          std::swap(t[j], t[j + 1]);
          ++swaps;
        }
    const std::size_t inside = static_cast<std::size_t>(
      std::count_if(t.begin(), t.end(), [&](std::size_t v) { return is_inside(v); }));
    if(swaps % 2 == 1 && inside > 1)
      std::swap(t[0], t[1]);
    else if(swaps % 2 == 1)
      std::swap(t[2], t[3]);

    if(inside == 1)
      m_mesh.add_face({cut(t[0], t[1]), cut(t[0], t[2]), cut(t[0], t[3])});
    else if(inside == 3)
      m_mesh.add_face({cut(t[3], t[0]), cut(t[3], t[1]), cut(t[3], t[2])});
    else if(inside == 2)
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
    if(found.second)
    {
      const double t = std::clamp(m_values[v] / (m_values[v] - m_values[w]), 0.2, 0.8);
      m_mesh.add_point((1 - t) * grid_point(v) + t * grid_point(w));
    }
    return found.first->second;
  }

  double m_cell;
  Point m_origin;
  std::array<std::size_t, 3> m_size;
  std::vector<double> m_values;
  std::map<Edge, std::size_t> m_vertices;
  Test_mesh m_mesh;
};

// Moves each vertex to the mean of its neighbours and back to the surface, a few times.
inline void even_out(Test_mesh& mesh, const Implicit_body& body, double cell)
{
  const auto edges = faces_of_edges(mesh);
  for(int round = 0; round < 4; ++round)
  {
    std::vector<Point> sums(mesh.points.size(), Point{0, 0, 0});
    std::vector<double> degrees(mesh.points.size(), 0);
    for(const auto& item : edges)
    {
      sums[item.first.first] = sums[item.first.first] + mesh.points[item.first.second];
      ++degrees[item.first.first];
    }
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
      mesh.points[v] = body.projection((1 / degrees[v]) * sums[v], 1e-3 * cell);
  }
}

// The surface of `body` in triangles with edges of about half the length `cell`. The true part of
// a face is that of the stick whose surface is nearest to its centroid.
inline Test_mesh implicit_mesh(const Implicit_body& body, double cell)
{
  Test_mesh mesh = Marching_tetrahedra(body, cell).run();
  even_out(mesh, body, cell);
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    mesh.parts[f] = body.part(centroid(mesh, mesh.faces[f]));
  return mesh;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_IMPLICIT_MESH_H
