// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_SEG_H
#define CGAL_IO_SEG_H

#include <CGAL/Protrusion_segmentation/internal/IO/segment_file.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/segment_id_maps.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgProtrusionSegmentationIO

reads the segment ids of the faces of `pmesh` from a stream, up to its end.

\tparam FaceGraph a model of `FaceListGraph`
\tparam SegmentIdMap a model of `WritablePropertyMap` with
                     `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
                     value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param is the input stream
\param pmesh the mesh
\param segment_ids is filled with the segment ids, from 0 to the largest number of its value type
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the cause of a failure is printed to `std::cerr`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `true` if there is exactly one id for each face and each fits the value type. Otherwise `segment_ids`
        is left as it was: too few or too many ids, a negative one, one too large, or anything that is not an
        id. That throws nothing, unless the stream was told to.

Complexity: linear in the length of the input.
*/
template <typename FaceGraph, typename SegmentIdMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_SEG(std::istream& is,
              const FaceGraph& pmesh,
              SegmentIdMap segment_ids,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace internal = Protrusion_segmentation::internal;

  if constexpr (internal::Check_writable_segment_ids<FaceGraph, SegmentIdMap>::value)
  {
    const std::string problem = internal::read_segments(is, pmesh, segment_ids);
    internal::report_problem(
      "cannot read the segmentation", problem,
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::verbose), false));
    return problem.empty();
  }
  else
    return false;
}

/*!
\ingroup PkgProtrusionSegmentationIO

reads the segment ids of the faces of `pmesh` from a file.

\param fname the name of the file
\param pmesh, segment_ids, np as for the function for streams

\return as for the function for streams; `false` also if the file cannot be opened
*/
template <typename FaceGraph, typename SegmentIdMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_SEG(const std::string& fname,
              const FaceGraph& pmesh,
              SegmentIdMap segment_ids,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace internal = Protrusion_segmentation::internal;

  if constexpr (internal::Check_writable_segment_ids<FaceGraph, SegmentIdMap>::value)
  {
    const std::string problem = internal::read_segments(fname, pmesh, segment_ids);
    internal::report_problem(
      "cannot read " + fname, problem,
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::verbose), false));
    return problem.empty();
  }
  else
    return false;
}

/*!
\ingroup PkgProtrusionSegmentationIO

writes the segment ids of the faces of `pmesh` to a stream.

\tparam FaceGraph a model of `FaceListGraph`
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
                     `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
                     value type

\param os the output stream
\param pmesh the mesh
\param segment_ids the segment ids, none negative

\return `true` if everything was written; `false` if the stream failed, or, then with nothing written, if an id
        is negative. That throws nothing, unless the stream was told to.

Complexity: linear in the number of faces.
*/
template <typename FaceGraph, typename SegmentIdMap>
bool write_SEG(std::ostream& os, const FaceGraph& pmesh, const SegmentIdMap& segment_ids)
{
  if constexpr (Protrusion_segmentation::internal::Check_readable_segment_ids<FaceGraph,
                                                                              SegmentIdMap>::value)
  {
    for (const auto f : faces(pmesh))
      if (get(segment_ids, f) < 0)
        return false;
    for (const auto f : faces(pmesh))
      os << std::to_string(get(segment_ids, f)) << '\n';
    return os.good();
  }
  else
    return false;
}

/*!
\ingroup PkgProtrusionSegmentationIO

writes the segment ids of the faces of `pmesh` to a file.

\param fname the name of the file
\param pmesh, segment_ids as for the function for streams

\return as for the function for streams; `false` also if the file cannot be opened
*/
template <typename FaceGraph, typename SegmentIdMap>
bool write_SEG(const std::string& fname, const FaceGraph& pmesh, const SegmentIdMap& segment_ids)
{
  std::ostringstream content; // a file that is there is only replaced by a whole one
  if (!write_SEG(content, pmesh, segment_ids))
    return false;
  std::ofstream os(fname, std::ios::binary); // lines end alike everywhere
  os << content.str();
  os.close();
  return !os.fail();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_SEG_H
