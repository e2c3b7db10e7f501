// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The landmark-based geodesic distance (Section III.B.3) is what its documentation defines.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Landmark_geodesic_distance.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Matrix = std::vector<std::vector<double>>;

// Of the nearest landmarks of a face the first.
Matrix landmark_distances(const Matrix& geodesic, const std::vector<Index>& landmarks)
{
  Matrix result;
  for (std::size_t i = 0; i < geodesic.size(); ++i)
  {
    Index nearest = landmarks.front();
    for (const Index l : landmarks)
      if (geodesic[l][i] < geodesic[nearest][i])
        nearest = l;
    result.push_back(geodesic[nearest]);
    for (double& d : result.back())
      d += geodesic[nearest][i];
    result.back()[i] = 0;
  }
  return result;
}

double sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.);
}

void check_definition(const Indexed_surface& surface, std::size_t number_of_landmarks, unsigned int seed)
{
  const std::vector<Index> landmarks = internal::select_landmarks(surface.number_of_faces(),
                                                                  number_of_landmarks, seed);
  const Matrix expected = landmark_distances(all_pairs_distances(surface), landmarks);
  Execution execution(seed);
  auto distances =
    Landmark_geodesic_distance::with_number_of_landmarks(number_of_landmarks).on(surface, execution);
  CGAL_CHECK_EQUAL(distances.number_of_runs(), landmarks.size());

  double largest = 0;
  std::vector<double> row;
  for (Index i = 0; i < surface.number_of_faces(); ++i)
  {
    distances(i, row);
    double error = 0;
    for (Index j = 0; j < surface.number_of_faces(); ++j)
      error = (std::max)(error, std::abs(row[j] - expected[i][j]));
    CGAL_CHECK(error < 1e-12);
    largest = (std::max)(largest, sum(expected[i]));
  }
  CGAL_CHECK_CLOSE(sum(expected[distances.face_of_largest_sum()]), largest, 1e-11 * largest);
}

void distances_and_sums_follow_the_definition()
{
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    const Indexed_surface surface = to_surface(random_surface(seed));
    for (std::size_t number : {1, 3, 10, 1000})
      check_definition(surface, number, seed);
  }
  check_definition(to_surface(single_triangle()), 1, 0);
  check_definition(to_surface(tetrahedron()), 2, 0);
  check_definition(to_surface(thin_strip(1)), 1, 5);
}

// With every face a landmark the distances are the geodesic ones.
void all_faces_as_landmarks_give_the_geodesic_distance()
{
  const Indexed_surface surface = to_surface(random_surface(8));
  const Matrix geodesic = all_pairs_distances(surface);
  Execution execution(3);
  auto distances = Landmark_geodesic_distance(1).on(surface, execution);
  std::vector<double> row;
  distances(7, row);
  for (Index j = 0; j < surface.number_of_faces(); ++j)
    CGAL_CHECK_CLOSE(row[j], geodesic[7][j], 1e-12);
}

void landmarks_are_different_faces_and_follow_the_seed()
{
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    const std::vector<Index> landmarks = internal::select_landmarks(1000, 50, seed);
    CGAL_CHECK_EQUAL(landmarks.size(), 50);
    CGAL_CHECK(std::is_sorted(landmarks.begin(), landmarks.end()));
    CGAL_CHECK(std::adjacent_find(landmarks.begin(), landmarks.end()) == landmarks.end());
    CGAL_CHECK(landmarks.back() < 1000);
    CGAL_CHECK(landmarks == internal::select_landmarks(1000, 50, seed));
    CGAL_CHECK(landmarks != internal::select_landmarks(1000, 50, seed + 1));
  }
  CGAL_CHECK_EQUAL(internal::select_landmarks(7, 100, 0).size(), 7);
}

// The standard fixes the numbers of std::mt19937: the same landmarks on every machine.
void landmarks_are_the_same_everywhere()
{
  CGAL_CHECK(internal::select_landmarks(1000, 5, 0) == (std::vector<Index>{548, 593, 604, 715, 844}));
}

// Every face is drawn about as often as every other.
void landmarks_are_spread_evenly()
{
  std::vector<int> drawn(20, 0);
  for (unsigned int seed = 0; seed < 2000; ++seed)
    for (const Index f : internal::select_landmarks(20, 5, seed))
      ++drawn[f];
  for (const int n : drawn)
    CGAL_CHECK_CLOSE(n, 500, 100); // 5 standard deviations
}

void options_choose_the_number_of_landmarks()
{
  const Indexed_surface surface = to_surface(icosphere(2)); // 320 faces
  CGAL_CHECK_EQUAL(Landmark_geodesic_distance().on(surface, quiet_execution()).number_of_runs(), 16);
  CGAL_CHECK_EQUAL(Landmark_geodesic_distance(0.1).on(surface, quiet_execution()).number_of_runs(), 32);
  CGAL_CHECK_EQUAL(Landmark_geodesic_distance(1).on(surface, quiet_execution()).number_of_runs(), 320);
  CGAL_CHECK_EQUAL(Landmark_geodesic_distance(1e-9).on(surface, quiet_execution()).number_of_runs(), 1);
  const auto with_number = Landmark_geodesic_distance::with_number_of_landmarks;
  CGAL_CHECK_EQUAL(with_number(1).on(surface, quiet_execution()).number_of_runs(), 1);
  CGAL_CHECK_EQUAL(with_number(1000).on(surface, quiet_execution()).number_of_runs(), 320);
}

void impossible_options_are_refused()
{
  for (double fraction : {0., -0.1, 1.5, infinity, std::nan("")})
    CGAL_CHECK_THROWS_WITH(Landmark_geodesic_distance(fraction), std::invalid_argument, "fraction");
  CGAL_CHECK_THROWS_WITH(Landmark_geodesic_distance::with_number_of_landmarks(0), std::invalid_argument,
                    "number of landmarks");
}

int main()
{
  distances_and_sums_follow_the_definition();
  all_faces_as_landmarks_give_the_geodesic_distance();
  landmarks_are_different_faces_and_follow_the_seed();
  landmarks_are_the_same_everywhere();
  landmarks_are_spread_evenly();
  options_choose_the_number_of_landmarks();
  impossible_options_are_refused();
  return check::result();
}
