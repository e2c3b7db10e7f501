// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_OF_CUT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_OF_CUT_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Bisection.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The strip beside a cut on one of its sides.
struct Cut_strip
{
  double widening, shoulder; // see `Cut_clues` in Cut_weights.h
};

// Measures the strips beside cuts. Where the surface widens, a strip is larger than its length and width say: the sudden
// widening that the paper looks for in its histograms.
class Strip_measurer
{
public:
  using Index = Dual_graph::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  // The arguments must outlive the object.
  Strip_measurer(const Volume_graph& graph, Graph_distances& distances)
    : m_graph(graph), m_distances(distances)
  {
    for (double area : graph.area)
      m_largest_size = (std::max)(m_largest_size, std::sqrt(area));
  }

  // The cut that a strip lies beside.
  struct Cut_measures
  {
    double length;
    Vector_3 opening;      // its area vector, out of the inner side
    double share_of_sheet; // 1 if it crosses a sheet, 0 if it goes around a body, or half a one
  };

  // `along_cut`: the nodes along the cut on one side
  Cut_strip operator()(const Bisection& bisection, const Nodes& along_cut, bool inner, const Cut_measures& cut)
  {
    constexpr double strip_width = 0.4; // relative to the square root of the smaller area
    constexpr double least_widening = 1e-6;
    const double width = strip_width * std::sqrt(bisection.inner_area());
    const Graph_partition& partition = bisection.partition();
    const Nodes_by_distance near_nodes = m_distances(
      along_cut, [&](Index, Index to) { return partition.is_on_side(to, inner); }, m_graph.lengths(),
      width + m_largest_size / 2);
    double area = 0;
    Vector_3 area_vector(0, 0, 0);
    for (std::size_t i = 0; i < near_nodes.nodes.size(); ++i)
    {
      const Index node = near_nodes.nodes[i];
      const double share = share_of_strip(width - near_nodes.distances[i], m_graph.area[node]);
      area += share * m_graph.area[node];
      area_vector += share * m_graph.area_vector[node];
    }
    const double widening = (std::max)(least_widening, area / (cut.length * width));
    return {std::log(widening),
            cut.share_of_sheet * flat_shoulder(widening, width, cut.length) +
              (1 - cut.share_of_sheet) * shoulder(area_vector, area, inner, cut.opening)};
  }

private:
  // The share of a node in a strip that reaches `depth` beyond its centre. A strip is few nodes wide: taken as a whole or
  // not at all, nodes would make its area a matter of chance.
  static double share_of_strip(double depth, double area)
  {
    return (std::min)(1., (std::max)(0., depth / std::sqrt(area) + 0.5));
  }

  // The opening grows by the faces of the strip as seen along the axis of the cut, away from the other side. What
  // sticks out across the axis, as a leg out of a trunk, shows as much forwards as backwards and does not count.
  static double shoulder(const Vector_3& area_vector, double area, bool inner, const Vector_3& opening)
  {
    const double size = std::sqrt(opening.squared_length()) * area;
    return size == 0 ? 0 : (inner ? -1 : 1) * (opening * area_vector) / size;
  }

  // The far edge of a flat strip of that area is as wide as if its sides were straight. Both halves of the round body count.
  static double flat_shoulder(double widening, double width, double length)
  {
    const double far_width = (std::max)(0., 2 * widening - 1);
    const double growth = length * (CGAL::square(far_width) - 1) / CGAL_PI;
    return (std::min)(1., (std::max)(-1., growth / (2 * width * widening)));
  }

  const Volume_graph& m_graph;
  Graph_distances& m_distances;
  double m_largest_size = 0; // of a node: the square root of its area
};

// Computes the clues of the cut of a bisection.
class Clues_of_cut
{
public:
  using Index = Dual_graph::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  Clues_of_cut(const Volume_graph& graph, const Bisection& bisection)
    : m_graph(graph),
      m_bisection(bisection),
      m_smaller_area(bisection.inner_area())
  {
    measure_cut();
    measure_smaller_side();
  }

  // Whether the smaller side is a band between the cut and earlier ones that is narrower than a seam is wide: then both lie in
  // the same seam.
  bool is_band_in_seam() const
  {
    return 2 * m_earlier_length > m_length && 2 * m_smaller_area < width_of_seam * (m_length + m_earlier_length);
  }

  Cut_clues operator()(Strip_measurer& measure_strip)
  {
    const auto [along_inside, along_outside] = m_bisection.partition().nodes_along_cut(m_bisection.inner());
    const Strip_measurer::Cut_measures cut{m_length, m_opening, share_of_sheet()};
    const Cut_strip inside = measure_strip(m_bisection, along_inside, true, cut);
    const Cut_strip outside = measure_strip(m_bisection, along_outside, false, cut);
    // Earlier cuts leave no holes in a sheet: what is narrow between one and the border of the surface goes on behind it.
    constexpr double of_earlier = 3; // the same from 2.5 to 4 for plates with pegs, decisions.md
    Cut_clues clues;
    clues.relative_length = std::log(length_around(m_length + of_earlier * m_openness * m_earlier_length) / std::sqrt(m_smaller_area));
    clues.segment_size = std::log(m_bisection.segment().area);
    clues.widening = (std::max)(inside.widening, outside.widening);
    std::tie(clues.smaller_shoulder, clues.larger_shoulder) = std::minmax({inside.shoulder, outside.shoulder});
    clues.concave_share = weight_of_seam(clues.larger_shoulder) * m_concave_length / m_length;
    clues.roundness = std::log(4 * CGAL_PI * opening() / CGAL::square(length_around(m_length)) + 0.05);
    clues.neighbors = std::log(1 + m_earlier_length / m_length);
    clues.mean_cost = std::log(m_cost / m_length + 0.02);
    const double thickness = 4 * volume() / (m_smaller_area * std::sqrt(opening() + 0.02 * m_smaller_area));
    clues.thickness = std::log((std::max)(0.001, std::abs(thickness)));
    clues.pocket = (std::max)(0., -thickness);
    clues.several_loops = has_several_loops(along_inside, along_outside) ? 1 : 0;
    clues.flatness = (1 - share_of_outline()) * std::sqrt(m_area_vector.squared_length()) / m_smaller_area;
    return clues;
  }

private:
  // Valleys of a rough surface say little, unless something stands out of them as out of a wall.
  double weight_of_seam(double shoulder) const
  {
    constexpr double least_shoulder = 0.7; // with .5 rough balls are cut, with 1 an urchin loses every other spine
    const double share = (std::max)(0., (shoulder - least_shoulder) / (1 - least_shoulder));
    return share + (1 - share) * m_graph.weight_of_valleys;
  }

  // What is divided by a cut that ends at the border of the surface is measured as one half of a round body, of which a cut has a
  // circular opening and cuts off a cylinder. In units of the root of the area of both halves, it is longer by the root of
  // two.
  double length_around(double length) const { return length * (1 + (std::sqrt(2.) - 1) * m_openness); }
  double round_opening() const { return m_openness * CGAL::square(m_length) / (2 * CGAL_PI); }
  // the area of the opening that the cut leaves
  double opening() const { return (std::max)(round_opening(), std::sqrt(m_opening.squared_length())); }
  double share_of_sheet() const
  {
    constexpr double cone_of_half_circle = 1 - 4 / (CGAL_PI * CGAL_PI); // from its centre of gravity, relative to half a disk
    const double cone = std::sqrt(m_opening.squared_length()), round = cone_of_half_circle * round_opening();
    return cone < round ? 1 - cone / round : 0;
  }

  // Of the openness of the cut, what its seam owes to the outline of the surface and not to a fold: a hill that ends at the border of
  // terrain is no limb of a sheet.
  double share_of_outline() const
  {
    return m_openness * (1 - (std::min)(1., m_folded_length / m_length)); // lengths of cuts are straightened, folds are not
  }

  void measure_cut()
  {
    constexpr double least_length = 1e-9;
    Vector_3 moment(0, 0, 0), ends(0, 0, 0);
    m_bisection.partition().for_each_arc_of_cut(m_bisection.inner(), [&](Index arc, Index, Index)
                                                {
                                                  m_concave_length += m_graph.concave_length[arc];
                                                  m_folded_length += m_graph.folded_length[arc];
                                                  m_length += m_graph.border_length[arc];
                                                  m_cost += m_graph.capacity[arc];
                                                  m_opening += m_graph.border_area[arc];
                                                  ends += m_graph.border_vector[arc];
                                                  moment += m_graph.border_moment[arc];
                                                });
    m_length = (std::max)(m_length, least_length);
    m_cost = (std::max)(m_cost, least_length);
    m_centre = moment / m_length;
    m_opening -= cross_product(m_centre, ends) / 2; // a cone over the cut, also if this ends at the border of the surface
    m_along_surface_border = ends;
  }

  void measure_smaller_side()
  {
    const Graph_partition& partition = m_bisection.partition();
    for (Index i : m_bisection.inner())
    {
      m_area_vector += m_graph.area_vector[i];
      m_flux += m_graph.flux[i];
      for (Index arc : m_graph.arcs(i))
        if (!partition.is_selected(m_graph.target[arc]))
        {
          m_earlier_length += m_graph.border_length[arc];
          m_along_surface_border += m_graph.border_vector[arc];
        }
    }
    constexpr double openness_of_half_circle = 2 / CGAL_PI;
    m_openness =
      (std::min)(1., std::sqrt(m_along_surface_border.squared_length()) / (openness_of_half_circle * m_length));
  }

  // of the smaller side, closed by a cone over the cut; negative if it goes into the body
  double volume() const
  {
    const double volume = m_graph.outward * (m_flux - m_area_vector * m_centre) / 3;
    const double of_half_cylinder = m_openness * m_smaller_area * length_around(m_length) / (4 * CGAL_PI);
    return std::abs(volume) < of_half_cylinder ? of_half_cylinder : volume;
  }

  bool has_several_loops(const Nodes& along_inside, const Nodes& along_outside) const
  {
    Nodes along_cut = along_inside;
    along_cut.insert(along_cut.end(), along_outside.begin(), along_outside.end());
    return !m_bisection.partition().are_connected_nearby(along_cut);
  }

  const Volume_graph& m_graph;
  const Bisection& m_bisection;
  double m_smaller_area;
  double m_concave_length = 0, m_folded_length = 0, m_length = 0, m_cost = 0; // of the cut
  Vector_3 m_opening{0, 0, 0}, m_centre{0, 0, 0};        // of the cut
  // along the border of the surface around the smaller side, from its end to its beginning: all borders of a side are closed
  Vector_3 m_along_surface_border{0, 0, 0};
  double m_openness = 0; // of the cut: 0 of a loop, 1 if it ends at distant places of the border of the surface
  double m_earlier_length = 0, m_flux = 0;               // of the smaller side
  Vector_3 m_area_vector{0, 0, 0};                       // of the smaller side
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_OF_CUT_H
