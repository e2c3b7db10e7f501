// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Borders between segments as lines, on meshes where every line is known.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Protrusion_segmentation/segment_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <vector>

using namespace test_meshes;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Border = CGAL::Protrusion_segmentation::Segment_border<Kernel::Point_3>;

template <typename FaceGraph>
std::vector<Border> borders(const Test_mesh& soup, const std::vector<std::size_t>& labels)
{
  const auto mesh = to_graph<FaceGraph>(soup);
  std::map<typename boost::graph_traits<FaceGraph>::face_descriptor, std::size_t> segments;
  auto label = labels.begin();
  for (const auto f : faces(mesh))
    segments[f] = *label++;
  std::vector<Border> result;
  CGAL::Protrusion_segmentation::segment_borders(mesh, boost::make_assoc_property_map(segments),
                                                 std::back_inserter(result));
  return result;
}

// A ring of the cylinder is between the two parts; its ends are at no border.
void a_border_around_a_cylinder_is_closed()
{
  const std::size_t slices = 24;
  const Test_mesh soup = revolution(Profile(0.25).line(1, 0, 1, 2, 0).line(1, 2, 1, 3, 1), slices);
  for (const std::vector<Border>& found : {borders<Mesh>(soup, soup.parts), borders<CGAL::Polyhedron_3<Kernel>>(soup, soup.parts)})
  {
    CGAL_CHECK_EQUAL(found.size(), 1);
    const Border& border = found.front();
    CGAL_CHECK(border.is_closed);
    CGAL_CHECK_EQUAL(border.points.size(), slices);
    CGAL_CHECK_CLOSE(border.length, 2. * slices * std::sin(pi / slices), 1e-12);
    CGAL_CHECK_EQUAL(border.segments[0], 0);
    CGAL_CHECK_EQUAL(border.segments[1], 1);
    double turn = 0; // clockwise seen from above: segment 0, which is below, is on the left
    for (std::size_t i = 0; i < slices; ++i)
    {
      const auto& p = border.points[i];
      const auto& q = border.points[(i + 1) % slices];
      CGAL_CHECK_CLOSE(p.z(), 2, 1e-12);
      turn += p.x() * q.y() - p.y() * q.x();
    }
    CGAL_CHECK(turn < 0);
  }
}

// Columns of a sheet, of three segments: two lines from boundary to boundary.
void lines_end_at_the_boundary()
{
  const Test_mesh soup = sheet(6, 4);
  std::vector<std::size_t> labels;
  for (const Face& face : soup.faces)
    labels.push_back(static_cast<std::size_t>(centroid(soup, face)[0] / 2));
  const std::vector<Border> found = borders<Mesh>(soup, labels);
  CGAL_CHECK_EQUAL(found.size(), 2);
  for (const Border& border : found)
  {
    CGAL_CHECK(!border.is_closed);
    CGAL_CHECK_CLOSE(border.length, 4, 1e-12);
    CGAL_CHECK_EQUAL(border.segments[1], border.segments[0] + 1);
  }
}

// A cube whose sides are segments: twelve lines, each an edge of the cube.
void lines_end_where_three_segments_meet()
{
  const Test_mesh soup = box(3, 3, 3);
  std::vector<std::size_t> labels;
  for (const Face& face : soup.faces)
  {
    const Point normal = area_vector(soup, face);
    std::size_t side = 0;
    for (std::size_t c = 0; c < 3; ++c)
      if (normal[c] != 0)
        side = 2 * c + (normal[c] > 0 ? 1 : 0);
    labels.push_back(side);
  }
  const std::vector<Border> found = borders<Mesh>(soup, labels);
  CGAL_CHECK_EQUAL(found.size(), 12);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    CGAL_CHECK_EQUAL(found[i].points.size(), 4);
    CGAL_CHECK_CLOSE(found[i].length, 3, 1e-12);
    CGAL_CHECK(found[i].segments[0] < found[i].segments[1]);
    CGAL_CHECK(i == 0 || found[i - 1].segments < found[i].segments);
  }
}

void one_segment_has_no_borders()
{
  const Test_mesh soup = sheet(3, 3);
  CGAL_CHECK(borders<Mesh>(soup, std::vector<std::size_t>(soup.faces.size(), 4)).empty());
}

int main()
{
  a_border_around_a_cylinder_is_closed();
  lines_end_at_the_boundary();
  lines_end_where_three_segments_meet();
  one_segment_has_no_borders();
  return check::result();
}
