// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parts.h"

#include <CGAL/Protrusion_segmentation/closed_segments.h>
#include <CGAL/Protrusion_segmentation/closed_segments_with_connectors.h>
#include <CGAL/Protrusion_segmentation/protrusion_skeleton.h>

#include <iterator>
#include <stdexcept>
#include <string>

namespace python {
namespace {

std::size_t checked(std::int64_t number, std::size_t bound, const std::string& what)
{
  if (number < 0 || static_cast<std::size_t>(number) >= bound)
    throw std::invalid_argument("found: there is no " + what + " " + std::to_string(number));
  return static_cast<std::size_t>(number);
}

} // namespace

Segmented_mesh segmented_mesh(const Arrays& arrays, const Tree_of_arrays& tree)
{
  Segmented_mesh result;
  result.input = mesh_of_arrays(arrays);
  const std::size_t number_of_segments = tree.parents.size();
  for (const std::int64_t label : labels_of_mesh(tree.labels, result.input, "found.labels"))
    result.segment_of_face.push_back(checked(label, number_of_segments, "segment"));
  for (std::size_t s = 0; s < number_of_segments; ++s)
  {
    CGAL::Protrusion_segmentation::Protrusion<tool::Face> protrusion;
    protrusion.segment = s;
    protrusion.probability = 0; // no matter here; g++ warns where there is none
    protrusion.parent = checked(tree.parents[s], number_of_segments, "segment");
    if (protrusion.parent == s)
      continue;
    const std::size_t tip = checked(tree.tips[s], result.input.label_giver.size(), "face");
    protrusion.tip = tool::Face(static_cast<tool::Face::size_type>(result.input.label_giver[tip]));
    result.record.on_protrusion(protrusion);
  }
  return result;
}

std::vector<Part> close_segments(const Arrays& arrays, const Tree_of_arrays& tree)
{
  const Segmented_mesh mesh = segmented_mesh(arrays, tree);
  std::vector<Part> parts;
  CGAL::Protrusion_segmentation::closed_segments(mesh.input.mesh, mesh.segments(), mesh.record,
                                                 std::back_inserter(parts));
  return parts;
}

Connected_parts close_segments_with_connectors(
  const Arrays& arrays,
  const Tree_of_arrays& tree,
  const CGAL::Protrusion_segmentation::Connector_options& options)
{
  const Segmented_mesh mesh = segmented_mesh(arrays, tree);
  Connected_parts found;
  CGAL::Protrusion_segmentation::closed_segments_with_connectors(
    mesh.input.mesh, mesh.segments(), mesh.record, options, std::back_inserter(found.parts),
    std::back_inserter(found.connectors));
  return found;
}

std::vector<Joint> find_skeleton(const Arrays& arrays,
                                 const Tree_of_arrays& tree,
                                 int number_of_inner_joints)
{
  const Segmented_mesh mesh = segmented_mesh(arrays, tree);
  std::vector<Joint> joints;
  CGAL::Protrusion_segmentation::protrusion_skeleton(mesh.input.mesh, mesh.segments(), mesh.record,
                                                     number_of_inner_joints, std::back_inserter(joints));
  return joints;
}

} // namespace python
