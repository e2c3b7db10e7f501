// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PLATE_RIMS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PLATE_RIMS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Surface_average.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Finds the rims of thin plates: faces that look sideways where nearly all of the surface around them looks to the one side or the
// other. Of a plate only the outline shows what sticks out, as of a sheet.
class Plate_rims
{
public:
  using Index = Indexed_surface::Index;

  // The surface must outlive the object.
  explicit Plate_rims(const Indexed_surface& surface) : m_surface(surface) {}

  // For each face whether it lies on a rim; nothing if none does.
  std::vector<bool> operator()(const Surface_average& average) const
  {
    Normal_moments moments(m_surface.number_of_faces());
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      moments.set(f, unit_normal(m_surface, f));
    average(moments.means, outline_radius);
    average(moments.squares, outline_radius);
    average(moments.products, outline_radius);
    const auto faces_on_edges = [&](double share)
    {
      std::vector<bool> result(m_surface.number_of_faces());
      for (Index f = 0; f < m_surface.number_of_faces(); ++f)
        result[f] = is_on_edge(moments, f, unit_normal(m_surface, f), share);
      return result;
    };
    return strips_of_plates(faces_on_edges(share_beside_plate), faces_on_edges(share_of_plate));
  }

private:
  // From .68 to .72 there is little difference. With .66 more thin gears are cut into arcs, with .78 fewer plates with arms are
  // right.
  static constexpr double share_of_plate = 0.72;

  // On an edge of a block it is one half. With .5 a rim may go on beside its plate.
  static constexpr double share_beside_plate = 0.55;

  // The mean unit normals, and the mean products of their coordinates, which are the same for opposite normals.
  struct Normal_moments
  {
    Padded_vectors means, squares, products; // the latter xx, yy, zz and xy, yz, zx

    explicit Normal_moments(std::size_t number_of_faces)
      : means(number_of_faces), squares(number_of_faces), products(number_of_faces)
    {}

    void set(std::size_t i, const Padded_vector& n)
    {
      means[i] = n;
      squares[i] = n * n;
      products[i] = n * next(n);
    }
    static Padded_vector next(const Padded_vector& n) { return {{n[1], n[2], n[0], 0}}; }
    // the mean squared cosine of the angle to a unit normal
    double along(std::size_t i, const Padded_vector& n) const
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
    // Whether more than this share of the normals, at least one half, is along one direction. At most one eigenvalue of the products
    // is larger than the share; one is if and only if this determinant is positive.
    bool are_along_one(std::size_t i, double share) const
    {
      const double least = share * trace(i);
      const double xx = squares[i][0] - least, yy = squares[i][1] - least, zz = squares[i][2] - least;
      const double xy = products[i][0], yz = products[i][1], zx = products[i][2];
      return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx) > 0;
    }
  };

  // Whether a face looks sideways where more than this share of the normals is along one direction. In terrain nearly all are, too,
  // but they are not opposite to each other: their mean is long.
  static bool is_on_edge(const Normal_moments& moments, Index i, const Padded_vector& n, double share)
  {
    constexpr double largest_share_sideways = 0.4, largest_squared_mean = 0.25;
    return moments.along(i, n) < largest_share_sideways * moments.trace(i) && moments.are_along_one(i, share) &&
           moments.squared_mean(i) < largest_squared_mean;
  }

  // Of connected faces on edges all are on a rim if three tenths of their area are on edges of plates, else none. So rims go around
  // corners, where more faces look sideways, and have no gaps: the roof has a valley where an outline ends.
  std::vector<bool> strips_of_plates(std::vector<bool> is_on_edge, const std::vector<bool>& is_of_plate) const
  {
    constexpr double least_share_of_plates = 0.3;
    if (std::find(is_of_plate.begin(), is_of_plate.end(), true) == is_of_plate.end())
      return {};
    const std::vector<Index> strip =
      components_of_faces(m_surface, [&](Index f, Index g) { return is_on_edge[f] && is_on_edge[g]; });
    std::vector<double> area(is_on_edge.size(), 0), area_of_plates(area); // of a strip
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
    {
      area[strip[f]] += m_surface.area(f);
      area_of_plates[strip[f]] += is_of_plate[f] ? m_surface.area(f) : 0;
    }
    bool has_rims = false;
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
    {
      is_on_edge[f] = is_on_edge[f] && area_of_plates[strip[f]] > least_share_of_plates * area[strip[f]];
      has_rims = has_rims || is_on_edge[f];
    }
    return has_rims ? is_on_edge : std::vector<bool>();
  }

  const Indexed_surface& m_surface;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PLATE_RIMS_H
