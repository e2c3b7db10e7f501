// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_CONNECTOR_H
#define CGAL_PROTRUSION_SEGMENTATION_CONNECTOR_H

#include <cstddef>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

Whether a cap has a peg and a socket, or why it has none.
*/
enum class Connector_status
{
  PLACED,        ///< it has
  CAP_TOO_SMALL, ///< the peg would be thinner than allowed, or the tolerance leaves no wall around its socket
  CAP_NOT_FLAT, ///< seen from above the border crosses itself, or a cap with a flat middle would cut the surface or another cap
  NO_ROOM ///< the peg or its socket would come too near to the surface or to another cap, or there is no solid
};

/*!
\ingroup PkgProtrusionSegmentationRef

What `closed_segments_with_connectors()` does with one cap.

\tparam Point the type of the points of the mesh
*/
template <typename Point>
struct Connector
{
  std::size_t segment = 0; ///< the protrusion that is cut off
  std::size_t parent = 0;  ///< what it sticks out of
  Connector_status status = Connector_status::
    NO_ROOM; ///< whether there is a peg. Without, only `cap_radius` has a meaning below.
  double cap_radius =
    0; ///< the radius of the largest circle in the cap, seen from above; 0 if it crosses itself
  bool is_peg_on_segment = true; ///< whether the protrusion has the peg and its parent the socket
  Point base = {};               ///< the center of the peg at its cap
  Point end = {};                ///< the center of its other end
  double radius = 0;             ///< the distance of its corners from its axis
  double depth = 0;              ///< the distance of its ends
  double tolerance = 0;          ///< the distance between the sides of peg and socket
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_CONNECTOR_H
