// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_CONNECTOR_OPTIONS_H
#define CGAL_PROTRUSION_SEGMENTATION_CONNECTOR_OPTIONS_H

#include <cstddef>
#include <optional>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

The shape of the pegs and sockets of `closed_segments_with_connectors()`.

A peg is a regular prism with a chamfer of 45 degrees at its end. Its socket is the peg with each of its planes moved outwards by
the tolerance.
*/
struct Connector_options
{
  /// the number of sides of the prism, from 3 to 1000: few sides keep the parts from turning, many make it round
  std::size_t number_of_sides = 6;

  /// the radius of the peg, as a share of that of the largest circle in the cap, above 0 and below 1. Where there is not enough
  /// room for it, the peg is thinner, down to a half of this.
  double radius = 0.5;

  /// the length of the peg, in the same unit, above 0. Where there is not enough room for it, the peg is shorter, down to
  /// a half of its radius.
  double depth = 0.75;

  /// the width of the chamfer, as a share of the radius of the peg, at least 0 and at most 0.5
  double chamfer = 0.2;

  /// the distance between the sides of peg and socket, in the unit of the coordinates, at least 0; unset: a twentieth of
  /// the radius of each peg
  std::optional<double> tolerance = {};

  /// the least radius of a peg, in the same unit, at least 0; unset: a hundredth of that of a ball around the mesh
  std::optional<double> smallest_radius = {};
};

namespace internal {

constexpr std::size_t least_number_of_sides = 3, most_sides = 1000; // more show in no print

} // namespace internal
} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_CONNECTOR_OPTIONS_H
