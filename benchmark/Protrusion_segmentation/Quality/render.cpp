// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "render.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <Eigen/Eigenvalues>

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

constexpr int picture_size = 220; // pixels
constexpr int margin = 6;

using Color = std::array<double, 3>;

// Hues that follow the golden ratio stay apart however many there are.
Color color_of(std::size_t label)
{
  const double golden_ratio = 0.618033988749895;
  const double hue = 6 * std::fmod(0.08 + golden_ratio * double(label), 1.);
  const double saturation = label % 3 == 1 ? 0.45 : 0.75;
  Color color;
  for(int c = 0; c < 3; ++c)
  {
    const double distance = std::abs(std::fmod(hue + 2 * (3 - c), 6.) - 3);
    color[std::size_t(c)] = 1 - saturation * (1 - std::clamp(distance - 1, 0., 1.));
  }
  return color;
}

// Rows are the directions to the right, up, and towards the viewer.
Eigen::Matrix3d view(const Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Point center = PMP::centroid(mesh);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for(const Face f : mesh.faces())
    for(const Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      const Vector d = mesh.point(v) - center;
      const Eigen::Vector3d x(d.x(), d.y(), d.z());
      covariance += PMP::face_area(f, mesh) * x * x.transpose();
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse().transpose();
  if(axes.determinant() < 0)
    axes.row(2) = -axes.row(2);
  const double turn = 0.45, tilt = 0.35; // radians: shows three sides
  return Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX())
       * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()) * axes;
}

class Picture
{
public:
  Picture()
    : m_depths(picture_size * picture_size, -std::numeric_limits<double>::infinity())
    , m_pixels(3 * picture_size * picture_size, 255)
  { }

  // Corners in pixels; `z` grows towards the viewer.
  void draw(const std::array<Eigen::Vector3d, 3>& corners, const Color& color)
  {
    const auto [min_x, max_x] = pixel_range(corners, 0);
    const auto [min_y, max_y] = pixel_range(corners, 1);
    for(int y = min_y; y <= max_y; ++y)
      for(int x = min_x; x <= max_x; ++x)
        draw_pixel(corners, color, x, y);
  }

  std::vector<std::uint8_t> png() const
  {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = picture_size;
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::uint8_t> file(size);
    if(!png_image_write_to_memory(&image, file.data(), &size, 0, m_pixels.data(), 0, nullptr))
      throw std::runtime_error(std::string("a picture cannot be written: ") + image.message);
    file.resize(size);
    return file;
  }

private:
  static std::pair<int, int> pixel_range(const std::array<Eigen::Vector3d, 3>& corners, int axis)
  {
    const auto [least, most] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    return {(std::max)(0, int(std::floor(least))),
            (std::min)(picture_size - 1, int(std::ceil(most)))};
  }

  static double twice_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double x, double y)
  {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  }

  void draw_pixel(const std::array<Eigen::Vector3d, 3>& c, const Color& color, int x, int y)
  {
    const double area = twice_area(c[0], c[1], c[2].x(), c[2].y());
    const double u = twice_area(c[1], c[2], x, y) / area;
    const double v = twice_area(c[2], c[0], x, y) / area;
    if(!(u >= 0 && v >= 0 && u + v <= 1)) // nor where the area is 0
      return;
    const double depth = u * c[0].z() + v * c[1].z() + (1 - u - v) * c[2].z();
    const std::size_t pixel = std::size_t(y * picture_size + x);
    if(depth <= m_depths[pixel])
      return;
    m_depths[pixel] = depth;
    for(std::size_t i = 0; i < 3; ++i)
      m_pixels[3 * pixel + i] = std::uint8_t(std::lround(255 * color[i]));
  }

  std::vector<double> m_depths;
  std::vector<std::uint8_t> m_pixels;
};

// Positions in pixels.
std::vector<Eigen::Vector3d> projected_vertices(const Mesh& mesh, const Eigen::Matrix3d& axes)
{
  std::vector<Eigen::Vector3d> result;
  for(const Vertex v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    result.push_back(axes * Eigen::Vector3d(p.x(), p.y(), p.z()));
  }
  Eigen::Vector3d least = result.front(), most = result.front();
  for(const Eigen::Vector3d& p : result)
  {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  const double scale = (picture_size - 2 * margin)
                     / (std::max)(most.x() - least.x(), most.y() - least.y());
  const Eigen::Vector3d middle = (least + most) / 2;
  for(Eigen::Vector3d& p : result)
  {
    p = scale * (p - middle);
    p = Eigen::Vector3d(picture_size / 2. + p.x(), picture_size / 2. - p.y(), p.z());
  }
  return result;
}

double brightness(const Mesh& mesh, Face f, const Eigen::Matrix3d& axes)
{
  const Vector n = CGAL::Polygon_mesh_processing::compute_face_normal(f, mesh);
  const Eigen::Vector3d light = Eigen::Vector3d(-0.35, 0.45, 0.82);
  return 0.45 + 0.55 * (std::max)(0., (axes * Eigen::Vector3d(n.x(), n.y(), n.z())).dot(light));
}

} // namespace

std::vector<std::uint8_t> render(const Mesh& mesh, const Labels& colors)
{
  const Eigen::Matrix3d axes = view(mesh);
  const std::vector<Eigen::Vector3d> positions = projected_vertices(mesh, axes);
  Picture picture;
  for(const Face f : mesh.faces())
  {
    std::array<Eigen::Vector3d, 3> corners;
    std::size_t i = 0;
    for(const Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      corners[i++ % 3] = positions[v];
    Color color = color_of(colors[f]);
    for(double& c : color)
      c *= (std::min)(1., brightness(mesh, f, axes));
    picture.draw(corners, color);
  }
  return picture.png();
}
