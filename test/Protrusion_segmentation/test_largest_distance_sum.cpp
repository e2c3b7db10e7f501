// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pruned search for the face of eq. (1) finds the face that all pairs find, ties included, for
// a handful of distance computations.
//
// With PRINCETON_FOLDER, the folder with off/<model>.off, on ten models of that benchmark as well.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <filesystem>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

std::size_t runs_of_search(const Indexed_surface& surface)
{
  auto distances = Geodesic_distance().on(surface, quiet_execution());
  distances.face_of_largest_sum();
  return distances.number_of_runs();
}

void check_same_face(const Indexed_surface& surface)
{
  internal::Shortest_distances distances(surface);
  const Index expected = internal::largest_distance_sum_of_all_pairs(surface, distances,
                                                                     quiet_execution());
  CGAL_CHECK_EQUAL(distances.number_of_runs(), surface.number_of_faces());
  CGAL_CHECK_EQUAL(Geodesic_distance().on(surface, quiet_execution()).face_of_largest_sum(), expected);
}

void check_same_face(const Test_mesh& mesh)
{
  check_same_face(to_surface(mesh));
}

void all_pairs_take_the_lowest_of_the_largest_sums()
{
  const Indexed_surface surface = to_surface(random_surface(3));
  const auto d = all_pairs_distances(surface);
  std::vector<double> sums;
  for (const std::vector<double>& row : d)
    sums.push_back(internal::distance_sum(row));
  auto distances = Geodesic_distance().on(surface, quiet_execution());
  const auto largest = std::max_element(sums.begin(), sums.end());
  CGAL_CHECK_EQUAL(internal::largest_distance_sum_of_all_pairs(surface, distances, quiet_execution()),
              largest - sums.begin());

  // Exact sums: both ends of a strip of unit squares tie.
  const Indexed_surface strip = to_surface(sheet(16, 1));
  auto on_strip = Geodesic_distance().on(strip, quiet_execution());
  CGAL_CHECK_EQUAL(internal::largest_distance_sum_of_all_pairs(strip, on_strip, quiet_execution()), 0);
}

void same_face_as_all_pairs_on_random_surfaces()
{
  for (std::uint_fast32_t seed = 0; seed < 600; ++seed)
    check_same_face(random_surface(seed));
}

// Many faces share the largest sum, exactly or up to rounding.
void same_face_as_all_pairs_where_sums_tie()
{
  std::uint_fast32_t seed = 0;
  for (const Test_mesh& mesh : {tetrahedron(),
                                icosahedron(),
                                dodecahedron(),
                                football(),
                                icosphere(1),
                                icosphere(2),
                                box(),
                                box(4, 4, 4),
                                box(1, 1, 9),
                                sheet(9, 9),
                                sheet(16, 1),
                                sheet(17, 1),
                                torus(2, 0.5, 24, 8),
                                moebius_strip(),
                                pierced_plate(2, 2),
                                regular_prism(12),
                                thin_strip(32),
                                single_triangle(),
                                uv_sphere(),
                                closed_cylinder(1, 2, 0.3),
                                dumbbell(1, 1, 0.3, 3, 0.3),
                                height_field(9, 5, 1)})
  {
    check_same_face(mesh);
    for (int i = 0; i < 3; ++i)
      check_same_face(with_face_order(mesh, random_permutation(mesh.faces.size(), ++seed)));
  }
}

void same_face_as_all_pairs_on_larger_surfaces()
{
  for (const Test_mesh& mesh : {bumpy_sphere(4, 1), icosphere(4), star(5)})
    check_same_face(mesh);
}

// Also where visits are limited: then it is the best of those that were visited.
void the_number_of_threads_does_not_matter()
{
#ifdef CGAL_LINKED_WITH_TBB
  Execution parallel(0, true);
  for (const Test_mesh& mesh : {bumpy_sphere(2, 1), bumpy_sphere(5, 2), star(5), creature()})
    for (const std::size_t most : {1, 2, 5, 8, 1000})
    {
      const Indexed_surface surface = to_surface(mesh);
      const Geodesic_distance distance = Geodesic_distance().maximum_number_of_visits(most);
      auto expected = distance.on(surface, quiet_execution());
      auto found = distance.on(surface, parallel);
      CGAL_CHECK_EQUAL(found.face_of_largest_sum(), expected.face_of_largest_sum());
      CGAL_CHECK_EQUAL(found.number_of_runs(), expected.number_of_runs());
      CGAL_CHECK(found.number_of_runs() <= most);
    }
#endif
}

// On a line many paths are equally long but for rounding. What a face hands on may not get shorter when its own path does,
// so that it is scanned after the faces beyond it.
void same_face_as_all_pairs_where_paths_tie()
{
  for (std::uint_fast32_t seed = 0; seed < 60; ++seed)
    check_same_face(scaled(bumpy_sphere(2, seed), 1 / (3. + static_cast<double>(seed)), 0, 0));
}

// Where all distances are 0 there is nothing to search for.
void faces_in_one_point_need_one_run()
{
  const Test_mesh point = scaled(icosphere(3), 0);
  check_same_face(point);
  CGAL_CHECK_EQUAL(runs_of_search(to_surface(point)), 1);
}

// On a sphere with bumps all sums are alike.
void the_number_of_visits_can_be_limited()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(3, 1));
  Geodesic_distance distance;
  CGAL_CHECK_EQUAL(distance.maximum_number_of_visits(2).maximum_number_of_visits().value(), 2);
  auto distances = distance.on(surface, quiet_execution());
  CGAL_CHECK(distances.face_of_largest_sum() < surface.number_of_faces());
  CGAL_CHECK_EQUAL(distances.number_of_runs(), 2);
  CGAL_CHECK_THROWS_WITH(distance.maximum_number_of_visits(0), std::invalid_argument,
                    "maximum_number_of_visits is 0");
  CGAL_CHECK_EQUAL(distance.maximum_number_of_visits().value(), 2);
}

// As many visits as scan twenty million faces; on a sphere, where all sums are alike, three times as many would prove that the
// face is the best one.
void large_round_bodies_take_no_undue_time()
{
  CGAL_CHECK(!Geodesic_distance().maximum_number_of_visits());
  const Indexed_surface sphere = to_surface(icosphere(6));
  auto distances = Geodesic_distance().on(sphere, quiet_execution());
  distances.face_of_largest_sum();
  CGAL_CHECK_EQUAL(distances.number_of_runs(), 20000000 / sphere.number_of_faces());
}

// A guard that needs no timing. The limits are the counts measured when this was written and a tenth
// more for other roundings; round bodies, where many faces nearly tie, need the most.
void few_runs_on_large_meshes()
{
  const auto check_runs = [](const Test_mesh& mesh, std::size_t most)
  {
    const Indexed_surface surface = to_surface(mesh);
    const std::size_t runs = runs_of_search(surface);
    std::cout << surface.number_of_faces() << " faces: " << runs << " runs\n";
    CGAL_CHECK(runs <= most);
  };
  check_runs(bumpy_sphere(5, 1), 54);
  check_runs(bumpy_sphere(6, 1), 112);
  check_runs(star(5), 10);
  check_runs(creature(), 9);
  check_runs(height_field(100, 100, 1), 19);
  check_runs(capsule_with_ball(), 151);
}

// Who asks for the face asks for its distances next.
void the_distances_from_the_face_take_no_further_run()
{
  const Indexed_surface surface = to_surface(star(4));
  auto distances = Geodesic_distance().on(surface, quiet_execution());
  const Index face = distances.face_of_largest_sum();
  const std::size_t runs = distances.number_of_runs();
  std::vector<double> first, second, expected;
  distances(face, first);
  CGAL_CHECK_EQUAL(distances.number_of_runs(), runs);
  distances(face, second, 1e9);
  CGAL_CHECK_EQUAL(distances.number_of_runs(), runs + 1);
  internal::Shortest_distances shortest_distances(surface);
  shortest_distances(face, expected);
  CGAL_CHECK(first == expected);
  CGAL_CHECK(second == expected);
}

// However many faces were visited and however large they are, no bound is below its sum; that of a visited face is nearly
// its sum.
void joint_bounds_are_bounds(double size)
{
  for (std::uint_fast32_t seed = 0; seed < 20; ++seed)
  {
    const Indexed_surface surface = to_surface(scaled(random_surface(seed), size));
    internal::Shortest_distances distances(surface);
    internal::Joint_sum_bounds bounds(surface.number_of_faces());
    std::vector<double> from_face, sums;
    for (Index f = 0; f < surface.number_of_faces(); ++f)
    {
      distances(f, from_face);
      sums.push_back(internal::distance_sum(from_face));
    }
    for (Index source = 0; source < surface.number_of_faces(); source += 7)
    {
      distances(source, from_face);
      bounds.add(from_face);
      for (Index f = 0; f < surface.number_of_faces(); ++f)
        CGAL_CHECK(bounds(f) >= sums[f] * (1 - 1e-12));
      if (bounds.number_of_sources() == 1)
        CGAL_CHECK(bounds(source) <= sums[source] * (1 + 1e-6));
    }
    CGAL_CHECK(bounds.number_of_sources() > 0);
    CGAL_CHECK(bounds.middle() < surface.number_of_faces());
  }
}

// The smallest files: all pairs take a second for a model of 5,000 faces and four times that for twice as many.
void same_face_as_all_pairs_on_models(const std::filesystem::path& folder)
{
  std::vector<std::pair<std::uintmax_t, std::filesystem::path>> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "off"))
    files.emplace_back(entry.file_size(), entry.path());
  std::sort(files.begin(), files.end());
  CGAL_CHECK(files.size() >= 10);
  files.resize(std::min<std::size_t>(files.size(), 10));
  for (const auto& [size, file] : files)
  {
    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
    CGAL_CHECK(CGAL::IO::read_polygon_mesh(file.string(), mesh));
    const internal::Canonical_surface canonical(internal::read_arrays(mesh, CGAL::parameters::default_values()));
    const Indexed_surface& surface = canonical.surface();
    std::cout << file.filename().string() << ", ";
    std::cout << surface.number_of_faces() << " faces: " << runs_of_search(surface) << " runs\n";
    check_same_face(surface);
  }
}

int main()
{
  all_pairs_take_the_lowest_of_the_largest_sums();
  same_face_as_all_pairs_on_random_surfaces();
  same_face_as_all_pairs_where_sums_tie();
  same_face_as_all_pairs_on_larger_surfaces();
  the_number_of_threads_does_not_matter();
  same_face_as_all_pairs_where_paths_tie();
  faces_in_one_point_need_one_run();
  the_number_of_visits_can_be_limited();
  large_round_bodies_take_no_undue_time();
  few_runs_on_large_meshes();
  the_distances_from_the_face_take_no_further_run();
  for (const double size : {1., 1e-60, 1e60})
    joint_bounds_are_bounds(size);
  if (const char* folder = std::getenv("PRINCETON_FOLDER"))
    same_face_as_all_pairs_on_models(folder);
  return check::result();
}
