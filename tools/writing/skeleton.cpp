// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/skeleton.h"

#include "writing/shortest_digits.h"
#include "writing/vtp.h"

#include <CGAL/Protrusion_segmentation/protrusion_skeleton.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>

namespace tool {

std::vector<Joint> find_skeleton(const Findings& findings, int number_of_inner_joints)
{
  const Mesh& mesh = findings.mesh.mesh;
  std::vector<Joint> joints;
  CGAL::Protrusion_segmentation::protrusion_skeleton<Mesh>(
    mesh,
    boost::make_iterator_property_map(findings.segmentation.segment_ids.begin(),
                                      get(boost::face_index, mesh)),
    findings.segmentation.record, number_of_inner_joints, std::back_inserter(joints));
  return joints;
}

void write_skeleton(std::ostream& out, const std::vector<Joint>& joints)
{
  std::vector<std::size_t> bones; // by their lower ends
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].parent != i)
      bones.push_back(i);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << joints.size() << "\" NumberOfLines=\"" << bones.size()
      << "\">\n<PointData>\n";
  write_data_array(out, "type=\"UInt8\" Name=\"is_tip\"",
                   [&]()
                   {
                     for (const Joint& joint : joints)
                       out << joint.is_tip << "\n";
                   });
  out << "</PointData>\n<CellData Scalars=\"segment\">\n";
  write_data_array(out, "type=\"UInt32\" Name=\"segment\"",
                   [&]()
                   {
                     for (const std::size_t bone : bones)
                       out << joints[bone].segment << "\n";
                   });
  out << "</CellData>\n<Points>\n";
  write_data_array(out, "type=\"Float64\" NumberOfComponents=\"3\"",
                   [&]()
                   {
                     for (const Joint& joint : joints)
                     {
                       write_shortest(out, joint.point);
                       out << "\n";
                     }
                   });
  out << "</Points>\n<Lines>\n";
  write_data_array(out, "type=\"Int64\" Name=\"connectivity\"",
                   [&]()
                   {
                     for (const std::size_t bone : bones)
                       out << joints[bone].parent << " " << bone << "\n";
                   });
  write_data_array(out, "type=\"Int64\" Name=\"offsets\"",
                   [&]()
                   {
                     for (std::size_t i = 1; i <= bones.size(); ++i)
                       out << 2 * i << "\n";
                   });
  out << "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace tool
