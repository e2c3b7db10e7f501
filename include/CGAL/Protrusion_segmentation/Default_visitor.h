// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_DEFAULT_VISITOR_H
#define CGAL_PROTRUSION_SEGMENTATION_DEFAULT_VISITOR_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

/// \ingroup PkgProtrusionSegmentationRef
/// the stages that a visitor is told of
enum class Stage
{
  READING,      ///< the mesh is read and its face dual graph built
  TIPS,         ///< protrusion tips are selected; their distances are computed
  BORDERS,      ///< histograms or cuts are computed and borders detected
  LABELS        ///< faces get their segments
};

/*!
\ingroup PkgProtrusionSegmentationRef

One protrusion, as a visitor gets it. Faces are numbered in the order of `faces(tmesh)`, lengths and areas
are in the unit of the mesh.
*/
struct Protrusion
{
  std::size_t segment;        ///< the id of the protrusion's segment
  std::size_t parent;         ///< the id of the segment that it was cut from
  std::size_t tip;            ///< the face at its tip
  double border_distance;     ///< the distance of the border from the tip; 0 where the border is no level set
  double score;               ///< the prominence or the score of the border, as its method defines it
  double area;                ///< the area of the protrusion when it was cut off
  double border_length;       ///< the length of the border when it was cut

  /// the slot of the border, see Section III.D.3; `no_slot()` for methods without histograms
  std::size_t border_slot = no_slot();
  /// the number of faces in each slot, see Section III.D.1; empty for methods without histograms
  std::vector<std::size_t> distance_histogram;
  /// the diameter of the section in each slot, see Section III.D.2; empty for methods without histograms
  std::vector<double> sectional_diameter_histogram;

  static constexpr std::size_t no_slot() { return static_cast<std::size_t>(-1); }
};

/*!
\ingroup PkgProtrusionSegmentationRef

The default visitor: does nothing and never stops a segmentation. A visitor may derive from it and define
some of its functions anew.

\cgalModels{ProtrusionSegmentationVisitor}
*/
class Default_visitor
{
public:
  void stage_starts(Stage) {}
  void stage_ends(Stage) {}
  /// the share of the requested segments that were found so far, in [0, 1]
  void progress(double) {}
  /// is asked between two steps of the segmentation. \return `true`; `false` would stop it
  bool go_further() { return true; }
  void tip_found(std::size_t /* face */) {}
  void tip_eliminated(std::size_t /* face */) {}
  void protrusion_found(const Protrusion&) {}
  /// distances from `number_of_runs` more faces were computed
  void distances_computed(std::size_t /* number_of_runs */) {}
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_DEFAULT_VISITOR_H
