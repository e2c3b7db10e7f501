// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BORDER_VALUES_H
#define CGAL_PROTRUSION_SEGMENTATION_BORDER_VALUES_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

How sure the borders of a segmentation are: which to check by hand first.

Every protrusion has a border to its parent, with a value. Two segments are kept apart by all borders on the way from
one to the other over parents. As sure as the least of them is the border between the two, whether they touch or not.

Values depend on the method. For `Minimum_cut_method` they lie between -1/2 and 1/2: \f$(2q-1)\sqrt{AB}\f$ with what
speaks for the cut, \f$q\f$ from 0 to 1, and the areas \f$A\f$ and \f$B\f$ of both sides of the segment that it divided, as shares
of the component's. So they say how much a cut brought: of equal arms the one that was cut off last, from what the others had
left, has the least value. For `Histogram_method` they are prominences, above 0.

Probabilities, which `Minimum_cut_method` has, are what they say: of the borders with a probability of .7, people make seven
in ten, on the meshes that were measured.
*/
class Border_values
{
public:
  /// no borders
  Border_values() = default;

  /// the borders of a segmentation, in linear time.
  /// \tparam ProtrusionRange a range of `Protrusion` with any face descriptor
  /// \param protrusions all that a visitor was told of by `Segmentation_visitor::on_protrusion()`
  template <typename ProtrusionRange>
  explicit Border_values(const ProtrusionRange& protrusions)
  {
    for (const auto& protrusion : protrusions)
    {
      Border& border = border_of(protrusion.segment);
      border.parent = protrusion.parent;
      border.value = protrusion.value;
      border.probability = protrusion.probability;
    }
    for (const auto& protrusion : protrusions)
      for (std::size_t s : {protrusion.segment, protrusion.parent})
        take_least(border_of(s).least, protrusion);
  }

  /// \return the value of the border between two segments; infinity if they are in different components, or the same
  /// \param s a segment id
  /// \param t a segment id
  double value(std::size_t s, std::size_t t) const { return between(s, t).value; }

  /// \return the least probability on the way from one segment to another, from 0 to 1; none if they are in different
  ///         components or the same, or if the method does not estimate it
  /// \param s a segment id
  /// \param t a segment id
  std::optional<double> probability(std::size_t s, std::size_t t) const { return between(s, t).probability; }

  /// \return the least value of a border of a segment: how sure it is that its faces belong to no other one; infinity if
  ///         it has no border
  /// \param segment a segment id
  double least_value(std::size_t segment) const { return of(segment).least.value; }

  /// \return the least probability of a border of a segment, from 0 to 1; none if it has no border, or if the method does
  ///         not estimate it
  /// \param segment a segment id
  std::optional<double> least_probability(std::size_t segment) const { return of(segment).least.probability; }

private:
  struct Sureness
  {
    double value = (std::numeric_limits<double>::infinity)();
    std::optional<double> probability;
  };
  struct Border
  {
    std::size_t parent = no_parent();
    double value = 0;
    std::optional<double> probability;
    Sureness least; // of all borders of the segment
  };

  static constexpr std::size_t no_parent() { return (std::numeric_limits<std::size_t>::max)(); }

  Border& border_of(std::size_t segment)
  {
    if (segment >= m_borders.size())
      m_borders.resize(segment + 1);
    return m_borders[segment];
  }
  Border of(std::size_t segment) const { return segment < m_borders.size() ? m_borders[segment] : Border(); }

  template <typename Valued>
  static void take_least(Sureness& least, const Valued& border)
  {
    least.value = (std::min)(least.value, border.value);
    if (border.probability && (!least.probability || *border.probability < *least.probability))
      least.probability = border.probability;
  }

  // A segment and all that it sticks out of, the body last.
  std::vector<std::size_t> way_to_body(std::size_t segment) const
  {
    std::vector<std::size_t> way(1, segment);
    while (of(way.back()).parent != no_parent())
      way.push_back(of(way.back()).parent);
    return way;
  }

  Sureness between(std::size_t s, std::size_t t) const
  {
    std::vector<std::size_t> from_s = way_to_body(s), from_t = way_to_body(t);
    if (from_s.back() != from_t.back())
      return {};
    while (!from_s.empty() && !from_t.empty() && from_s.back() == from_t.back())
    {
      from_s.pop_back();
      from_t.pop_back();
    }
    Sureness least;
    for (const auto* way : {&from_s, &from_t})
      for (std::size_t segment : *way)
        take_least(least, m_borders[segment]);
    return least;
  }

  std::vector<Border> m_borders; // of every segment, that to its parent
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_BORDER_VALUES_H
