// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces of revolution around the z-axis, in quads (and triangles at the poles): sections,
// diameters and areas are known.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_REVOLUTION_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_REVOLUTION_H

#include "test_mesh.h"

namespace test_meshes {

// A polyline of circles from the lowest to the highest one, piece by piece. A circle of radius 0
// is a pole and closes the surface.
class Profile
{
public:
  struct Circle
  {
    double radius, z;
    std::size_t part; // of the faces between this circle and the one before
  };

  // `spacing`: the wanted distance of two circles along the profile.
  explicit Profile(double spacing) : m_spacing(spacing) {}

  // A straight piece; radius or height may change. What starts where the last piece ended does
  // not repeat that circle.
  Profile& line(double radius_from, double z_from, double radius_to, double z_to, std::size_t part)
  {
    const std::size_t n = steps(std::hypot(radius_to - radius_from, z_to - z_from));
    for (std::size_t i = m_circles.empty() ? 0 : 1; i <= n; ++i)
    {
      const double t = double(i) / double(n);
      m_circles.push_back(
        {radius_from + t * (radius_to - radius_from), z_from + t * (z_to - z_from), part});
    }
    return *this;
  }

  // A piece of a sphere with its centre on the axis, between two latitudes in radians.
  Profile& arc(double radius, double center_z, double from, double to, std::size_t part)
  {
    const std::size_t n = steps(radius * (to - from));
    for (std::size_t i = m_circles.empty() ? 0 : 1; i <= n; ++i)
    {
      const double latitude = from + double(i) / double(n) * (to - from);
      const bool at_pole = std::abs(latitude) > pi / 2 - 1e-9;
      m_circles.push_back(
        {at_pole ? 0 : radius * std::cos(latitude), center_z + radius * std::sin(latitude), part});
    }
    return *this;
  }

  const std::vector<Circle>& circles() const { return m_circles; }

private:
  std::size_t steps(double length) const
  {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(length / m_spacing)));
  }

  double m_spacing;
  std::vector<Circle> m_circles;
};

// The surface that `profile` draws around the z-axis, with `slices` faces around. Open at an end
// that is not a pole. Faces: from the lowest to the highest ring.
inline Test_mesh revolution(const Profile& profile, std::size_t slices)
{
  Test_mesh result;
  std::vector<Face> rings;
  for (const Profile::Circle& circle : profile.circles())
  {
    Face ring;
    for (std::size_t i = 0; i < slices; ++i)
    {
      const double turn = 2 * pi * double(i) / double(slices);
      if (circle.radius > 0 || i == 0)
        result.add_point({circle.radius * std::cos(turn), circle.radius * std::sin(turn), circle.z});
      ring.push_back(result.points.size() - 1);
    }
    rings.push_back(std::move(ring));
  }

  for (std::size_t r = 1; r < rings.size(); ++r)
    for (std::size_t i = 0; i < slices; ++i)
    {
      const std::size_t j = (i + 1) % slices;
      Face face = {rings[r - 1][i], rings[r - 1][j], rings[r][j], rings[r][i]};
      face.erase(std::unique(face.begin(), face.end()), face.end());
      if (face.front() == face.back())
        face.pop_back();
      result.add_face(std::move(face), profile.circles()[r].part);
    }
  return result;
}

// The number of slices for which faces around a circle are about as wide as they are high.
inline std::size_t slices_for(double radius, double spacing)
{
  return std::max<std::size_t>(3, static_cast<std::size_t>(std::lround(2 * pi * radius / spacing)));
}

inline Test_mesh uv_sphere(double radius = 1, double spacing = 0.2)
{
  return revolution(Profile(spacing).arc(radius, 0, -pi / 2, pi / 2, 0), slices_for(radius, spacing));
}

// A cylinder wall from z = 0 to z = height, open at both ends. One part.
inline Test_mesh open_cylinder(double radius = 1, double height = 4, double spacing = 0.2)
{
  return revolution(Profile(spacing).line(radius, 0, radius, height, 0), slices_for(radius, spacing));
}

// Parts: 0 the wall, 1 the lower and 2 the upper disk.
inline Test_mesh closed_cylinder(double radius = 1, double height = 4, double spacing = 0.2)
{
  return revolution(Profile(spacing)
                      .line(0, 0, radius, 0, 1)
                      .line(radius, 0, radius, height, 0)
                      .line(radius, height, 0, height, 2),
                    slices_for(radius, spacing));
}

// A cylinder of the given length with half balls at both ends, centred in the origin. One part.
inline Test_mesh capsule(double radius = 0.5, double length = 4, double spacing = 0.15)
{
  return revolution(Profile(spacing)
                      .arc(radius, -length / 2, -pi / 2, 0, 0)
                      .line(radius, -length / 2, radius, length / 2, 0)
                      .arc(radius, length / 2, 0, pi / 2, 0),
                    slices_for(radius, spacing));
}

// A stick with a round lower end at z = -stick_radius, and on it, from z = stick_length on, a
// ball: the protrusion's border is known. `ball_radius` is above `stick_radius`.
// Parts: 0 the ball, 1 the stick.
inline Test_mesh capsule_with_ball(double stick_radius = 0.3,
                                   double stick_length = 3,
                                   double ball_radius = 1,
                                   double spacing = 0.1)
{
  const double latitude = -std::acos(stick_radius / ball_radius);
  const double center_z = stick_length - ball_radius * std::sin(latitude);
  return revolution(Profile(spacing)
                      .arc(stick_radius, 0, -pi / 2, 0, 1)
                      .line(stick_radius, 0, stick_radius, stick_length, 1)
                      .arc(ball_radius, center_z, latitude, pi / 2, 0),
                    slices_for(ball_radius, spacing));
}

// Two balls and a bar between z = 0 and z = bar_length. Parts: 0 the bar, 1 the lower ball, 2 the
// upper one, which may have another radius; both radii are above `bar_radius`.
inline Test_mesh dumbbell(double lower_radius = 1,
                          double upper_radius = 1,
                          double bar_radius = 0.3,
                          double bar_length = 3,
                          double spacing = 0.1)
{
  const double lower = std::acos(bar_radius / lower_radius);
  const double upper = -std::acos(bar_radius / upper_radius);
  return revolution(Profile(spacing)
                      .arc(lower_radius, -lower_radius * std::sin(lower), -pi / 2, lower, 1)
                      .line(bar_radius, 0, bar_radius, bar_length, 0)
                      .arc(upper_radius, bar_length - upper_radius * std::sin(upper), upper, pi / 2, 2),
                    slices_for((std::max)(lower_radius, upper_radius), spacing));
}

// A torus around the z-axis in `around` * `across` quads. One part.
inline Test_mesh torus(double major_radius = 2,
                       double minor_radius = 0.5,
                       std::size_t around = 48,
                       std::size_t across = 16)
{
  Test_mesh result;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j)
    {
      const double u = 2 * pi * double(i) / double(around);
      const double v = 2 * pi * double(j) / double(across);
      const double r = major_radius + minor_radius * std::cos(v);
      result.add_point({r * std::cos(u), r * std::sin(u), minor_radius * std::sin(v)});
    }
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j)
    {
      const std::size_t row = i * across, next_row = (i + 1) % around * across;
      const std::size_t next = (j + 1) % across;
      result.add_face({row + j, next_row + j, next_row + next, row + next});
    }
  return result;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_REVOLUTION_H
