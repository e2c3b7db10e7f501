// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the hierarchy and the visitor tell of areas: what lies beyond the border of a minimum cut, seen from the body,
// has at most half of the area of its component.

#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// Of every segment of a hierarchy.
std::vector<double> areas_of_segments(const Test_mesh& soup,
                                      const Mesh& mesh,
                                      const Segment_hierarchy& hierarchy)
{
  const std::size_t n = hierarchy.maximum_number_of_segments();
  Segment_ids<Mesh> ids(mesh);
  hierarchy.segment_ids(mesh, n, ids.map());
  const Labels labels = ids.labels();
  std::vector<double> areas(n, 0);
  for (std::size_t f = 0; f < labels.size(); ++f)
    areas[labels[f]] += face_area(soup, soup.faces[f]);
  return areas;
}

// From a segment to the body of its component.
std::vector<std::size_t> ancestors(const Segment_hierarchy& hierarchy, std::size_t segment)
{
  std::vector<std::size_t> result(1, segment);
  while (hierarchy.parent(result.back()) != result.back() &&
         result.size() <= hierarchy.maximum_number_of_segments())
    result.push_back(hierarchy.parent(result.back()));
  CGAL_CHECK(result.back() < hierarchy.minimum_number_of_segments());
  return result;
}

// Of every segment with all that sticks out of it, directly or not.
std::vector<double> areas_beyond_borders(const Segment_hierarchy& hierarchy,
                                         const std::vector<double>& areas)
{
  std::vector<double> result(areas.size(), 0);
  for (std::size_t s = 0; s < areas.size(); ++s)
    for (const std::size_t ancestor : ancestors(hierarchy, s))
      result[ancestor] += areas[s];
  return result;
}

template <typename Method>
std::size_t check_areas(const Test_mesh& soup, const Method& method, bool is_smaller_side)
{
  constexpr std::size_t largest_number = 12;
  const double tolerance = 1e-9 * area(soup);
  const Mesh mesh = to_graph<Mesh>(soup);
  Segmentation_record<Mesh> recorder;
  const Segment_hierarchy hierarchy = CGAL::protrusion_hierarchy(
    mesh, (std::min)(largest_number, soup.faces.size()), method,
    CGAL::parameters::visitor(std::ref(recorder)));
  CGAL_CHECK_EQUAL(recorder.protrusions().size(),
              hierarchy.maximum_number_of_segments() - hierarchy.minimum_number_of_segments());
  const std::vector<double> beyond = areas_beyond_borders(hierarchy,
                                                          areas_of_segments(soup, mesh, hierarchy));
  for (std::size_t i = 0; i < recorder.protrusions().size(); ++i)
  {
    const auto& protrusion = recorder.protrusions()[i];
    CGAL_CHECK_EQUAL(protrusion.segment, hierarchy.minimum_number_of_segments() + i);
    CGAL_CHECK_EQUAL(protrusion.parent, hierarchy.parent(protrusion.segment));
    CGAL_CHECK_CLOSE(beyond[protrusion.segment], protrusion.area, tolerance);
    const std::size_t body = ancestors(hierarchy, protrusion.segment).back();
    if (is_smaller_side)
      CGAL_CHECK(2 * beyond[protrusion.segment] <= beyond[body] + tolerance);
  }
  return recorder.protrusions().size();
}

// The segmentation for the largest number is the direct one; for smaller ones, segments that are no more belong to
// the nearest ancestor that is left.
template <typename Method>
void check_hierarchy(const Test_mesh& soup, const Method& method)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  const std::size_t number = (std::min)(std::size_t(6), soup.faces.size());
  const Segment_hierarchy hierarchy = CGAL::protrusion_hierarchy(mesh, number, method);
  const Segmentation direct = checked(
    mesh, [&](auto map) { return CGAL::segmentation_via_protrusion_tips(mesh, map, number, method); });
  CGAL_CHECK_EQUAL(hierarchy.maximum_number_of_segments(), direct.number);
  for (std::size_t k = hierarchy.minimum_number_of_segments(); k <= direct.number; ++k)
  {
    const Segmentation found = checked(mesh,
                                       [&](auto map)
                                       {
                                         hierarchy.segment_ids(mesh, k, map);
                                         return k;
                                       });
    std::vector<std::size_t> expected;
    for (std::size_t s = 0; s < direct.number; ++s)
    {
      const std::vector<std::size_t> line = ancestors(hierarchy, s);
      expected.push_back(*std::find_if(line.begin(), line.end(), [k](std::size_t a) { return a < k; }));
    }
    for (std::size_t f = 0; f < direct.labels.size(); ++f)
      CGAL_CHECK_EQUAL(found.labels[f], expected[direct.labels[f]]);
  }
}

int main()
{
  std::vector<Test_mesh> meshes = {star(5),
                                   creature(),
                                   body_with_hands(),
                                   dumbbell(),
                                   dumbbell(1, 1, 0.1),
                                   capsule_with_ball(),
                                   box(6, 6, 6),
                                   torus(),
                                   icosphere(3),
                                   sheet(20, 30),
                                   open_cylinder(),
                                   merged({star(3), translated(icosphere(2), {9, 0, 0})})};
  for (unsigned int seed = 0; seed < 60; ++seed)
    meshes.push_back(seed % 2 == 0 ? random_surface(seed) : bumpy_sphere(3, seed));
  std::size_t number = 0;
  for (const Test_mesh& mesh : meshes)
  {
    number += check_areas(mesh, Minimum_cut_method(), true);
    check_areas(mesh, Histogram_method(), false);
    check_hierarchy(mesh, Minimum_cut_method());
    check_hierarchy(mesh, Histogram_method());
  }
  for (const Test_mesh& mesh : {star(5), creature(), dumbbell(), bumpy_sphere(3, 1)})
    number += check_areas(mesh, Minimum_cut_method(Geodesic_distance()), true);
  std::cout << number << " protrusions of the minimum cut method\n";
  CGAL_CHECK(number > 300);
  return check::result();
}
