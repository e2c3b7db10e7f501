// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VISITOR_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VISITOR_H

#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/Segmentation_stopped.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

A visitor that does nothing and never stops: the default, and a base for visitors that define only some of the
functions. They are not virtual: the functions of the class that is passed as `visitor` are called.
`ProtrusionSegmentationVisitor` says when.

\cgalModels{ProtrusionSegmentationVisitor}

\tparam FaceGraph the type of the mesh
*/
template <typename FaceGraph>
class Segmentation_visitor
{
public:
  /// a face of the mesh
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;

  /// \name Stages
  /// @{
  void on_reading_begin() {}     ///< does nothing
  void on_reading_end() {}       ///< does nothing
  void on_preparation_begin() {} ///< does nothing
  void on_preparation_end() {}   ///< does nothing
  void on_tips_begin() {}        ///< does nothing
  void on_tips_end() {}          ///< does nothing
  void on_borders_begin() {}     ///< does nothing
  void on_borders_end() {}       ///< does nothing
  void on_labels_begin() {}      ///< does nothing
  void on_labels_end() {}        ///< does nothing
  /// @}

  /// \name Progress
  /// @{
  void on_progress(double /* share */) {}                ///< does nothing
  bool go_further() { return true; }                     ///< \return `true`
  void on_distances(std::size_t /* number_of_runs */) {} ///< does nothing
  /// @}

  /// \name Findings
  /// @{
  void on_small_components(std::size_t /* number_of_small_components */) {}                      ///< does nothing
  void on_tip(face_descriptor /* face */) {}                                 ///< does nothing
  void on_eliminated_tip(face_descriptor /* face */) {}                      ///< does nothing
  void on_protrusion(const Protrusion<face_descriptor>& /* protrusion */) {} ///< does nothing
  /// @}
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VISITOR_H
