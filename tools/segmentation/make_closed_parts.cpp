// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/make_closed_parts.h"

#include "writing/carried_attributes.h"
#include "writing/closed_parts.h"
#include "writing/hulls.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace tool {
namespace {

using Status = CGAL::Protrusion_segmentation::Connector_status;

std::vector<Polygon_soup> find_parts(Findings& findings, Caps caps)
{
  const Mesh& mesh = findings.mesh_of_borders();
  const std::vector<std::size_t>& segments = findings.segments_at_borders();
  const Segmentation& segmentation = findings.segmentation;
  if (caps == Caps::HULL)
    return convex_hulls(mesh, segments, segmentation.number_of_segments);
  if (!findings.options.connectors)
    return closed_parts(mesh, segments, segmentation.record, caps == Caps::FAIRED);
  findings.connectors.emplace();
  return connected_parts(mesh, segments, segmentation.record, *findings.options.connectors,
                         *findings.connectors);
}

// Of the faces of each segment, in their order: the face of the file that it is, or is a piece of.
std::vector<std::vector<std::size_t>> old_faces_of_parts(const Findings& findings)
{
  std::vector<std::vector<std::size_t>> result(findings.segmentation.number_of_segments);
  const std::vector<std::size_t>& segments = findings.segments_at_borders();
  for (std::size_t face = 0; face < segments.size(); ++face)
    result[segments[face]].push_back(
      findings.mesh.face_in_file[findings.smoothed ? findings.smoothed->old_faces[face] : face]);
  return result;
}

// Are the faces of the segments the first ones of the parts, and is the surface that of the file?
bool can_have_attributes(const Findings& findings, Caps caps)
{
  const Mesh& mesh = findings.mesh_of_borders();
  const auto is_triangle = [&](const Face face) { return mesh.degree(face) == 3; };
  return caps != Caps::HULL && !findings.mesh.has_joined_pieces() &&
         (caps != Caps::FAIRED || std::all_of(faces(mesh).begin(), faces(mesh).end(), is_triangle));
}

std::string list_of(const std::vector<std::size_t>& segments)
{
  std::string result = segments.size() == 1 ? "segment " : "segments ";
  for (std::size_t i = 0; i < segments.size(); ++i)
    result += (i == 0 ? "" : ", ") + std::to_string(segments[i]);
  return result;
}

// Empty, or which borders have no connector, and why.
std::string note_on_connectors(const std::vector<Connector>& connectors)
{
  std::map<Status, std::vector<std::size_t>> segments;
  for (const Connector& connector : connectors)
    segments[connector.status].push_back(connector.segment);
  if (segments[Status::PLACED].size() == connectors.size())
    return "";
  const std::map<Status, std::string> reasons = {
    {Status::CAP_TOO_SMALL, "the cap is too small"},
    {Status::CAP_NOT_FLAT, "the border is too far from flat"},
    {Status::NO_ROOM, "there is no room for a socket"}};
  std::string note = "connectors on " + std::to_string(segments[Status::PLACED].size()) + " of " +
                     std::to_string(connectors.size()) + " caps";
  for (const auto& [status, reason] : reasons)
    if (!segments[status].empty())
      note += ", none at " + list_of(segments[status]) + " (" + reason + ")";
  return note;
}

} // namespace

std::vector<Segmented_soup> make_closed_parts(Findings& findings, const Polygon_soup& file, Caps caps)
{
  const bool have_attributes = can_have_attributes(findings, caps);
  const std::vector<std::vector<std::size_t>> old_faces = old_faces_of_parts(findings);
  std::vector<Segmented_soup> parts;
  for (Polygon_soup& part : find_parts(findings, caps))
  {
    const std::size_t segment = parts.size(), number_of_faces = part.polygons.size();
    if (have_attributes && segment < old_faces.size())
      part.attributes = attributes_of_pieces(file, part, old_faces[segment]);
    parts.push_back(
      {std::move(part), std::vector<std::size_t>(number_of_faces, segment), {}, findings.names});
  }
  if (findings.connectors)
    findings.add_note(note_on_connectors(*findings.connectors));
  return parts;
}

} // namespace tool
