// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several threads may segment one constant mesh at the same time. With the thread sanitizer it is compiled without TBB, which
// that does not know.

#include "optional_distances.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <thread>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <typename Method>
Labels labels(const Mesh& mesh, const Method& method)
{
  Labels result(mesh.number_of_faces(), unwritten);
  CGAL::segmentation_via_protrusion_tips(
    mesh, boost::make_iterator_property_map(result.begin(), get(boost::face_index, mesh)), 4, method);
  return result;
}

int main()
{
  const Mesh mesh = to_graph<Mesh>(star(3, 1, 0.3, 0.04, 0.4));
  const Minimum_cut_method minimum_cut;
  const Histogram_method geodesic;
  const Histogram_method landmark{Landmark_geodesic_distance()};
  std::vector<std::function<Labels()>> methods = {[&]() { return labels(mesh, minimum_cut); },
                                                  [&]() { return labels(mesh, geodesic); },
                                                  [&]() { return labels(mesh, landmark); }};
  with_diffusion_distance(
    [&](const auto& distance)
    {
      methods.push_back([&mesh, method = Minimum_cut_method(distance)]() { return labels(mesh, method); });
      methods.push_back([&mesh, method = Histogram_method(distance)]() { return labels(mesh, method); });
    });

  std::vector<Labels> expected;
  for (const auto& method : methods)
    expected.push_back(method());

  constexpr std::size_t number_of_rounds = 2; // of which each runs all methods at the same time
  std::vector<Labels> found(number_of_rounds * methods.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i)
    threads.emplace_back([&, i]() { found[i] = methods[i % methods.size()](); });
  for (std::thread& thread : threads)
    thread.join();
  for (std::size_t i = 0; i < found.size(); ++i)
    CGAL_CHECK(found[i] == expected[i % methods.size()]);
  return check::result();
}
