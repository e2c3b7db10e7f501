// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same labels whatever compiled the method: fingerprints of labels beside those in
// data/golden_labels.txt. After a change that is meant to change segments, `test_determinism --write`, called in
// this folder, writes the file anew.

#include "optional_distances.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Method = std::function<Labels(const Mesh&)>;

constexpr const char* golden_file = "data/golden_labels.txt";

Mesh rounded(const Test_mesh& mesh)
{
  return to_graph<Mesh>(with_rounded_points(mesh));
}

std::map<std::string, Mesh> meshes()
{
  return {{"star", rounded(star(5, 1, 0.2, 0.04, 0.2))},
          {"creature", rounded(creature(0.2))},
          {"hands", rounded(body_with_hands(3, 0.18))},
          {"dumbbell", rounded(dumbbell())},
          {"bumps", rounded(bumpy_sphere(3, 1))},
          {"polygons", rounded(football())},
          {"random", rounded(jittered(random_surface(3), 0.5, 3))}};
}

constexpr std::size_t usual_number_of_segments = 6;

template <typename Segmentation_method>
Method method(const Segmentation_method& segmentation_method, std::size_t k = usual_number_of_segments)
{
  return [segmentation_method, k](const Mesh& mesh)
  {
    return checked(mesh, [&](auto ids)
                   { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, segmentation_method); })
      .labels;
  };
}

std::map<std::string, Method> methods()
{
  std::map<std::string, Method> result = {
    {"minimum-cut", method(Minimum_cut_method())},
    {"paper", method(Histogram_method())},
    {"paper-landmark", method(Histogram_method(Landmark_geodesic_distance()))}};
  with_diffusion_distance([&](const auto& distance)
                          { result.emplace("paper-diffusion", method(Histogram_method(distance))); });
  with_heat_distance([&](const auto& distance)
                     { result.emplace("paper-heat", method(Histogram_method(distance))); });
  return result;
}

// FNV-1a
std::string fingerprint(const Labels& labels)
{
  std::uint64_t hash = 14695981039346656037u;
  for (const std::size_t label : labels)
    hash = (hash ^ label) * 1099511628211u;
  std::ostringstream text;
  text << std::hex << hash;
  return text.str();
}

std::map<std::string, std::string> fingerprints()
{
  std::map<std::string, std::string> result;
  for (const auto& mesh : meshes())
    for (const auto& method : methods())
      result[mesh.first + " " + method.first] = fingerprint(method.second(mesh.second));
  return result;
}

void compare_with_golden_labels()
{
  std::map<std::string, std::string> golden;
  std::ifstream in(golden_file);
  const auto known_methods = methods();
  for (std::string mesh, method, value; in >> mesh >> method >> value;)
    if (known_methods.count(method) > 0)
      golden[mesh + " " + method] = value;
  const auto found = fingerprints();
  CGAL_CHECK_EQUAL(found.size(), golden.size());
  for (const auto& item : found)
    CGAL_CHECK_EQUAL(item.first + " " + item.second, item.first + " " + golden[item.first]);
}

void write_golden_labels()
{
  constexpr std::size_t number_of_methods = 5;
  CGAL_CHECK_EQUAL(methods().size(), number_of_methods); // else a library is missing
  std::ofstream out(golden_file);
  for (const auto& item : fingerprints())
    out << item.first << " " << item.second << "\n";
  CGAL_CHECK(out.good());
}

// Some threads, more threads than processors, and one.
template <typename Segmentation_method>
void check_threads(const Segmentation_method& segmentation_method,
                   const Test_mesh& test_mesh = creature(0.2),
                   std::size_t k = usual_number_of_segments)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Mesh mesh = rounded(test_mesh);
  const Labels expected = method(segmentation_method, k)(mesh);
  for (const std::size_t threads : {1, 2, 8})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Segmentation found = checked(
      mesh,
      [&](auto ids)
      {
        return CGAL::segmentation_via_protrusion_tips<CGAL::Parallel_tag>(mesh, ids, k,
                                                                          segmentation_method);
      });
    CGAL_CHECK(found.labels == expected);
  }
#else
  static_cast<void>(segmentation_method);
  static_cast<void>(test_mesh);
  static_cast<void>(k);
#endif
}

// Of a few faces each, and among them figures with arms to cut off.
constexpr std::size_t number_of_small_components = 240;

Test_mesh small_components()
{
  const std::vector<Test_mesh> shapes = {tetrahedron(), box(), regular_prism(5), icosahedron(),
                                         box(4, 1, 1)};
  const Test_mesh figure = star(4, 1, 0.3, 0.05, 0.3);
  std::vector<Test_mesh> result;
  for (std::size_t i = 0; i < number_of_small_components; ++i)
  {
    const Test_mesh& shape = i % 40 == 0 ? figure : shapes[i % shapes.size()];
    const Point place{10. * static_cast<double>(i % 16), 10. * static_cast<double>(i / 16), 0};
    result.push_back(translated(shape, place));
  }
  return merged(result);
}

void the_number_of_threads_does_not_matter()
{
  check_threads(Histogram_method());
  check_threads(Histogram_method(Landmark_geodesic_distance()));
  check_threads(Minimum_cut_method());
  check_threads(Minimum_cut_method(),
                bumpy_sphere(6, 1)); // so large that all of it is divided among threads
  check_threads(Minimum_cut_method(Landmark_geodesic_distance()));
  for (const std::size_t further_segments : {0, 12})
  {
    const std::size_t k = number_of_small_components + further_segments;
    check_threads(Minimum_cut_method(), small_components(), k);
    check_threads(Histogram_method(), small_components(), k);
  }
}

// No digit of a coordinate changes, hence no label.
void scaling_by_a_power_of_two_does_not_matter()
{
  const Test_mesh soup = creature(0.2);
  for (const auto& method : methods())
  {
    const Labels expected = method.second(to_graph<Mesh>(soup));
    for (const int exponent : {-900, -1, 7, 1000})
      CGAL_CHECK(method.second(to_graph<Mesh>(scaled(soup, std::ldexp(1., exponent)))) == expected);
  }
}

int main(int argc, char** argv)
{
  if (argc == 2 && std::string(argv[1]) == "--write")
    write_golden_labels();
  else
  {
    compare_with_golden_labels();
    the_number_of_threads_does_not_matter();
    scaling_by_a_power_of_two_does_not_matter();
  }
  return check::result();
}
