// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_H
#define CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_H

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

One protrusion, as a visitor is told of it. Lengths and areas are in the unit of the mesh.

\tparam FaceDescriptor `boost::graph_traits<FaceGraph>::%face_descriptor`
*/
template <typename FaceDescriptor>
struct Protrusion
{
  std::size_t segment;    ///< the id of the protrusion's segment
  std::size_t parent;     ///< the id of the segment that it sticks out of
  FaceDescriptor tip;     ///< the face at its tip
  double border_distance; ///< the distance of the border from the tip
  double value;           ///< how good the border is: its prominence or its value, as its method defines it
  /// the probability, from 0 to 1, that people put two points on different sides of the border into different segments;
  /// none for methods that do not estimate it
  std::optional<double> probability;
  double area;            ///< the area beyond the border: of the segment and of all that sticks out of it
  double border_length;   ///< the length of the border between that and the rest

  /// the slot of the border, see Section III.D.3; `no_slot()` for methods without histograms
  std::size_t border_slot = no_slot();
  /// the number of faces in each slot, see Section III.D.1; empty for methods without histograms
  std::vector<std::size_t> distance_histogram;
  /// the diameter of the section in each slot, see Section III.D.2; empty for methods without histograms
  std::vector<double> sectional_diameter_histogram;

  /// \return what stands for the slot where there is none
  static constexpr std::size_t no_slot() { return static_cast<std::size_t>(-1); }
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_H
