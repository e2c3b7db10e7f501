// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VISITOR_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VISITOR_H

#include <CGAL/Protrusion_segmentation/Protrusion.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

The base of visitors, which are told of the progress and of the findings of a segmentation, and may stop it. This class
does nothing and never stops. A visitor derives from it and overrides some of its functions; with `override`, a
misspelt function is an error at compile time.

A visitor is passed as the named parameter `visitor`. It is copied unless it is passed by `std::ref()`. All
calls come from the thread that called the function of the package. A visitor may throw any exception; the call
then ends with it and writes nothing.

Both methods go through the same stages:
- reading: the mesh is read as index arrays;
- preparation: what a method needs to know of a surface is computed: weights and a coarse graph, or what the
  distances on a segment are made from;
- tips: protrusion tips of a segment are selected (Section III.C of the paper);
- borders: histograms or cuts are computed, and borders chosen (Section III.D); for `Histogram_method` the
  histograms of a tip are computed as soon as it is selected, so that this stage lies within the one before;
- labels: the faces of protrusions get their segments.

All but the first come again and again. Every begin has its end, also if an exception passes.

\tparam FaceGraph the type of the mesh
*/
template <typename FaceGraph>
class Segmentation_visitor
{
public:
  /// a face of the mesh
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;

  virtual ~Segmentation_visitor() = default;

  /// \name Stages
  /// @{
  virtual void on_reading_begin() {}     ///< reading begins
  virtual void on_reading_end() {}       ///< reading ends
  virtual void on_preparation_begin() {} ///< preparation begins
  virtual void on_preparation_end() {}   ///< preparation ends
  virtual void on_tips_begin() {}        ///< the selection of tips begins
  virtual void on_tips_end() {}          ///< the selection of tips ends
  virtual void on_borders_begin() {}     ///< the computation of borders begins
  virtual void on_borders_end() {}       ///< the computation of borders ends
  virtual void on_labels_begin() {}      ///< labelling begins
  virtual void on_labels_end() {}        ///< labelling ends
  /// @}

  /// \name Progress
  /// @{

  /// is called again and again. The share never falls, and is 1 at the end.
  /// \param share about how much of the work is done, from 0 to 1; if no number of segments was asked for,
  ///        the end of the work is not known before, and the share only approaches 1
  virtual void on_progress([[maybe_unused]] double share) {}
  /// is called again and again, whatever the method and the distance do.
  /// \return `false` to stop: the function that the visitor was passed to then writes nothing and returns 0
  virtual bool go_further() { return true; }
  /// is called when the work on a segment ends.
  /// \param number_of_runs from how many more faces distances were computed; the default method may need more of them with
  ///        several threads than with one
  virtual void on_distances([[maybe_unused]] std::size_t number_of_runs) {}
  /// @}

  /// \name Findings
  /// @{

  /// is called if there are specks, connected components with less than a thousandth of the area of the largest one and
  /// fewer faces, which get no segments of their own.
  /// \param number_of_specks how many there are
  virtual void on_specks([[maybe_unused]] std::size_t number_of_specks) {}
  /// is called for each protrusion tip that is selected, which need not become a segment.
  /// \param face the face at the tip
  virtual void on_tip([[maybe_unused]] face_descriptor face) {}
  /// is called for each face that is farthest from the tips but does not become one, because it lies on the border of a
  /// segment that was cut off before.
  /// \param face the face
  virtual void on_eliminated_tip([[maybe_unused]] face_descriptor face) {}
  /// is called for each protrusion that is cut off.
  /// \param protrusion all that is known of it
  virtual void on_protrusion([[maybe_unused]] const Protrusion<face_descriptor>& protrusion) {}
  /// @}
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VISITOR_H
