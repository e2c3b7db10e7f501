// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_SKELETON_H
#define CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_SKELETON_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Protrusion_segmentation/Skeleton_joint.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/named_parameters.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Skeleton.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

makes a curve skeleton of what a segmentation found: joints at the centers of borders, between them and at the tips, joined
along the tree of segments.

Each body has a joint at the centroid of its faces. Each protrusion has one at the center of its border to its parent, one at its
tip, and inner ones between them: the centroids of bands around it, at equal steps of the distance from the border on the
surface. Bands without faces have none. A joint at a border hangs on the joint of the parent that is nearest by that
distance, tips aside. So without inner joints there is one joint for each segment, besides the tips: a rig, whose joint
moves the segment with all that sticks out of it.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph` with a point for each vertex
\tparam SegmentMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type
                   and an integral value type
\tparam OutputIterator a model of `OutputIterator` that accepts a `Protrusion_segmentation::Skeleton_joint` of the
                       type of the points, which has a constructor from three `double`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh. Faces may be any polygons; there may be boundaries and several components.
\param segment_ids the segment of every face, from 0
\param record what a segmentation of the mesh found, with these segments
\param number_of_inner_joints how many there are between the border and the tip of a protrusion, at least 0
\param joints where the joints are written, parents first
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` as for
          `segmentation_via_protrusion_tips()`

\return `joints`, advanced

\throw std::invalid_argument if a coordinate is not finite or the number is negative

Complexity: O(n log n) for n faces.
*/
template <typename FaceGraph,
          typename SegmentMap,
          typename OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator protrusion_skeleton(const FaceGraph& pmesh,
                                   SegmentMap segment_ids,
                                   const Segmentation_record<FaceGraph>& record,
                                   int number_of_inner_joints,
                                   OutputIterator joints,
                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Points = typename GetVertexPointMap<FaceGraph, CGAL_NP_CLASS>::const_type;
  using Point = typename boost::property_traits<Points>::value_type;

  const std::size_t number = internal::checked_count("number_of_inner_joints", number_of_inner_joints);
  internal::Surface_arrays surface = internal::read_arrays(pmesh, np);
  const int exponent = internal::scale_to_unit(surface.points);
  std::vector<std::size_t> segments;
  auto number_of_face = get(CGAL::dynamic_face_property_t<Indexed_surface::Index>(), pmesh);
  for (const auto f : faces(pmesh))
  {
    put(number_of_face, f, static_cast<Indexed_surface::Index>(segments.size()));
    segments.push_back(static_cast<std::size_t>(get(segment_ids, f)));
  }
  std::vector<internal::Limb> limbs;
  for (const auto& protrusion : record.protrusions())
    limbs.push_back({protrusion.segment, protrusion.parent, get(number_of_face, protrusion.tip)});
  const internal::Skeleton skeleton(surface, segments, limbs, number);
  for (const auto& joint : skeleton.joints())
  {
    const auto p = internal::scaled_by_power_of_two(joint.point, exponent);
    *joints++ = Skeleton_joint<Point>{Point(p.x(), p.y(), p.z()), joint.parent, joint.segment,
                                      joint.is_tip};
  }
  return joints;
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_SKELETON_H
