// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed triangle meshes around smoothly blended balls and tapered sticks.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_IMPLICIT_MESH_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_IMPLICIT_MESH_H

#include "zero_set.h"

#include <CGAL/Protrusion_segmentation/internal/inline.h>

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
    double nearest = (std::numeric_limits<double>::max)();
    for (const Stick& stick : m_sticks)
      nearest = (std::min)(nearest, stick.distance(p));
    double sum = 0;
    for (const Stick& stick : m_sticks)
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

  Box box() const
  {
    Box result;
    for (const Stick& stick : m_sticks)
    {
      const double radius = (std::max)(stick.radius_from, stick.radius_to);
      result.add(stick.from, radius);
      result.add(stick.to, radius);
    }
    return result;
  }

private:
  std::vector<Stick> m_sticks;
  double m_blend;
};

// The surface of `body` in triangles with edges of about half the length `cell`. The true part of
// a face is that of the stick whose surface is nearest to its centroid.
Test_mesh implicit_mesh(const Implicit_body& body, double cell);

#ifndef CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES

CGAL_PROTRUSION_SEGMENTATION_INLINE Test_mesh implicit_mesh(const Implicit_body& body, double cell)
{
  const auto value = [&](const Point& p) { return body.value(p); };
  Test_mesh mesh = zero_set(value, body.box(), cell);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    mesh.parts[f] = body.part(centroid(mesh, mesh.faces[f]));
  return mesh;
}

#endif // CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_IMPLICIT_MESH_H
