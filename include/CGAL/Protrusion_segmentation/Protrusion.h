// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_H
#define CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_H

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

One protrusion, as a visitor is told of it. Lengths are in the unit of the mesh, areas in its square.
Both methods give all that is neither optional nor empty by default.

\tparam FaceDescriptor `boost::graph_traits<FaceGraph>::%face_descriptor`
*/
template <typename FaceDescriptor>
struct Protrusion
{
  std::size_t segment = 0;    ///< the id of the protrusion's segment
  std::size_t parent = 0;     ///< the id of the segment that it sticks out of
  FaceDescriptor tip{};       ///< the face at its tip
  double border_distance = 0; ///< the distance of the border from the tip
  double border_length = 0;   ///< the length of the border between the protrusion and the rest
  double area = 0; ///< the area beyond the border: of the segment and of all that sticks out of it

  /// how good the border is. For `Minimum_cut_method`, a number from -1/2 to 1/2 without a unit:
  /// \f$(2q-1)\sqrt{AB}\f$ with the evidence for the cut \f$q\f$ from 0 to 1 and the areas \f$A\f$ and \f$B\f$
  /// of the two sides of the segment that it divides, as shares of the area of the component. For
  /// `Histogram_method`, the prominence of the inflection, a number above 0 (Section III.D.3 of the paper).
  double value = 0;

  /// the probability, from 0 to 1, that people put two points on different sides of the border into different
  /// segments; `Minimum_cut_method` only
  std::optional<double> probability;

  /// the slot of the histograms in which the border lies (Section III.D.3); `Histogram_method` only
  std::optional<std::size_t> border_slot;
  /// the number of faces in each slot (Section III.D.1); `Histogram_method` only
  std::vector<std::size_t> distance_histogram;
  /// the diameter of the section in each slot, a length (Section III.D.2); `Histogram_method` only
  std::vector<double> sectional_diameter_histogram;
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_H
