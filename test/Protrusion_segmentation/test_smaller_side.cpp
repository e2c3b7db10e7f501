// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the hierarchy and the visitor tell of areas: the smaller side of a minimum cut is the protrusion.

#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

struct Recorder : Segmentation_visitor<Mesh>
{
  void on_protrusion(const Protrusion<face_descriptor>& protrusion) override
  {
    protrusions.push_back(protrusion);
  }
  std::vector<Protrusion<face_descriptor>> protrusions;
};

// Of each of the first k segments of the hierarchy.
std::vector<double> areas_of_segments(const Test_mesh& soup,
                                      const Mesh& mesh,
                                      const Segment_hierarchy& hierarchy,
                                      std::size_t k)
{
  Segment_ids<Mesh> ids(mesh);
  hierarchy.segment_ids(mesh, k, ids.map());
  const Labels labels = ids.labels();
  std::vector<double> areas(k, 0);
  for (std::size_t f = 0; f < labels.size(); ++f)
    areas[labels[f]] += face_area(soup, soup.faces[f]);
  return areas;
}

// Areas as they were when each protrusion was cut off, by the labels.
template <typename Method>
std::size_t check_areas(const Test_mesh& soup, const Method& method, bool is_smaller_side)
{
  constexpr std::size_t largest_number = 12;
  const double tolerance = 1e-9 * area(soup);
  const Mesh mesh = to_graph<Mesh>(soup);
  Recorder recorder;
  const Segment_hierarchy hierarchy = CGAL::protrusion_hierarchy(
    mesh, (std::min)(largest_number, soup.faces.size()), method,
    CGAL::parameters::visitor(std::ref(recorder)));
  CHECK_EQUAL(recorder.protrusions.size(),
              hierarchy.maximum_number_of_segments() - hierarchy.minimum_number_of_segments());
  for (std::size_t i = 0; i < recorder.protrusions.size(); ++i)
  {
    const auto& protrusion = recorder.protrusions[i];
    CHECK_EQUAL(protrusion.segment, hierarchy.minimum_number_of_segments() + i);
    CHECK_EQUAL(protrusion.parent, hierarchy.parent(protrusion.segment));
    const std::vector<double> areas = areas_of_segments(soup, mesh, hierarchy, protrusion.segment + 1);
    CHECK_CLOSE(areas.back(), protrusion.area, tolerance);
    if (is_smaller_side)
      CHECK(areas.back() <= areas[protrusion.parent] + tolerance);
  }
  return recorder.protrusions.size();
}

// The cut method's hierarchy holds the segmentation for every number; the other one's that for the last.
void check_hierarchy(const Test_mesh& soup)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  const Histogram_method histogram;
  const Segment_hierarchy hierarchy = CGAL::protrusion_hierarchy(mesh, 6, histogram);
  Segment_ids<Mesh> ids(mesh);
  hierarchy.segment_ids(mesh, hierarchy.maximum_number_of_segments(), ids.map());
  const Segmentation direct = checked(
    mesh, [&](auto map) { return CGAL::segmentation_via_protrusion_tips(mesh, map, 6, histogram); });
  CHECK_EQUAL(hierarchy.maximum_number_of_segments(), direct.number);
  CHECK(ids.labels() == direct.labels);
  for (std::size_t k = hierarchy.minimum_number_of_segments(); k < direct.number; ++k)
  {
    const Segmentation coarser = checked(mesh,
                                         [&](auto map)
                                         {
                                           hierarchy.segment_ids(mesh, k, map);
                                           return k;
                                         });
    for (std::size_t f = 0; f < direct.labels.size(); ++f)
      CHECK(coarser.labels[f] == direct.labels[f] || direct.labels[f] >= k);
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
    check_hierarchy(mesh);
  }
  for (const Test_mesh& mesh : {star(5), creature(), dumbbell(), bumpy_sphere(3, 1)})
    number += check_areas(mesh, Minimum_cut_method(Geodesic_distance()), true);
  std::cout << number << " protrusions of the minimum cut method\n";
  CHECK(number > 300);
  return check::result();
}
