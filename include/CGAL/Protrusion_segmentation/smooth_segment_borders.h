// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SMOOTH_SEGMENT_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_SMOOTH_SEGMENT_BORDERS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Border_smoother.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/named_parameters.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/write_cut_surface.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

moves the borders between segments to smooth lines on the surface and cuts faces along them. The result is a new mesh,
with the segment and the old face of every new face.

At every vertex, each segment has a share: at first that of the angles of its faces. The shares are averaged with those of
the neighbors several times. The border lies where two of them are equal. It crosses edges at new vertices; where
three segments meet in a face, there is a new vertex in it. The old vertices stay in place, and the new ones lie on
old edges and faces, so that the surface is the same. It is closed if it was. Pieces of triangles are triangles. A face
that no border crosses is not changed.

No border between two segments gets longer, except for rounding, and no two segments get a border that had none. A border that
would not get shorter stays along its edges; borders of other segments may end at it. If this would lengthen those, or
let two segments touch, borders stay along their edges around the vertices where they meet; if that does not suffice,
neighboring borders stay, too, and in the end all. With many iterations, the border between two segments with other neighbors
may vanish.

Segments keep their ids and their number, and each keeps its number of connected parts. A segment that would be
lost or torn, such as one that is a single triangle wide, keeps its faces, and the borders of the others end at it.

\tparam FaceGraph a model of `FaceListGraph` with a point for each vertex
\tparam SegmentMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type
                   and an integral value type
\tparam OutputMesh a model of `MutableFaceGraph` with a point for each vertex, which has a constructor from three `double`
\tparam OutputSegmentMap a model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%face_descriptor` as
                         key type and the value type of `SegmentMap`. It has to take faces that are added to
                         the mesh after it was made, as those of `Surface_mesh` do.
\tparam OldFaceMap the same, with `boost::graph_traits<FaceGraph>::%face_descriptor` as value type
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 the same

\param pmesh the mesh. Faces may be any polygons; there may be boundaries and several components. No two edges may have the
       same two ends.
\param segment_ids the segment of every face
\param output the mesh to which the pieces of the faces are added; it may not be `pmesh`
\param output_segment_ids the segment of every new face
\param old_faces for every new face the face of `pmesh` that it is, or is a piece of
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" for `pmesh`
\param output_np an optional sequence of \ref bgl_namedparameters "Named Parameters" for `output`: `vertex_point_map`

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `pmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and a point type with
                   `x()`, `y()` and `z()` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, pmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{how often shares are averaged, at least 0. With more iterations, borders get straighter and move
                          farther, up to about as many edges as the square root of the number. With 0, all borders
                          stay in place.}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{`3`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of segments that keep their faces: those that would have been lost or torn, or all if there is no iteration

\throw std::invalid_argument if a coordinate is not finite, if two edges have the same two ends, or if the number of
       iterations is negative; nothing is added to `output` then

Complexity: O(n log n) for n edges, linear in the number of iterations, and the square of the number of faces around a
vertex. Each time that further borders have to stay, this is repeated, usually a few times.
*/
template <typename FaceGraph,
          typename SegmentMap,
          typename OutputMesh,
          typename OutputSegmentMap,
          typename OldFaceMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
std::size_t smooth_segment_borders(const FaceGraph& pmesh,
                                   SegmentMap segment_ids,
                                   OutputMesh& output,
                                   OutputSegmentMap output_segment_ids,
                                   OldFaceMap old_faces,
                                   const CGAL_NP_CLASS_1& np = parameters::default_values(),
                                   const CGAL_NP_CLASS_2& output_np = parameters::default_values())
{
  using Index = Indexed_surface::Index;
  using Id = typename boost::property_traits<SegmentMap>::value_type;
  constexpr unsigned int default_number_of_iterations = 3; // more hardly shorten borders, but move them

  const std::size_t rounds = internal::checked_count(
    "number_of_iterations",
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_iterations),
                                 default_number_of_iterations));
  // Numbered by size, not by the first face: of equal shares, that with the lower number counts.
  std::vector<Id> ids;
  for (const auto f : faces(pmesh))
    ids.push_back(get(segment_ids, f));
  const std::vector<Id> segment_of_face = ids;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<Index> segments;
  for (const Id& id : segment_of_face)
    segments.push_back(static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin()));
  const auto surface = internal::read_surface(pmesh, np).surface.to_surface();
  internal::check_edges_are_single(surface);
  const internal::Smooth_borders result = internal::Border_smoother(surface, segments, ids.size(), rounds).smooth();
  internal::write_cut_surface(pmesh, result.surface, ids, output, output_segment_ids, old_faces, np,
                              output_np);
  return result.number_of_fixed_segments;
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SMOOTH_SEGMENT_BORDERS_H
