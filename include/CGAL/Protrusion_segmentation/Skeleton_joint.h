// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SKELETON_JOINT_H
#define CGAL_PROTRUSION_SEGMENTATION_SKELETON_JOINT_H

#include <cstddef>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

A joint of a skeleton, see `protrusion_skeleton()`. Bones are the lines between joints and their parents.

\tparam Point the type of the points of the mesh
*/
template <typename Point>
struct Skeleton_joint
{
  Point point; ///< where it is
  std::size_t parent =
    0; ///< the number of the joint that it hangs on, which is lower; its own for a root
  std::size_t segment = 0; ///< the segment that it is in, or whose border to the parent it is in
  bool is_tip = false;     ///< whether it is at the tip of its segment
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SKELETON_JOINT_H
