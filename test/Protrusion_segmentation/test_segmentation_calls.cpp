// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All ways to call the functions, with numbers of any integer type: they compile, and agree.

#include "segmentations.h"
#include "star_mesh.h"

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
namespace parameters = CGAL::parameters;

using Face_descriptor = Mesh::Face_index;

// `segment`: segment map -> number of segments.
template <typename Segment>
void check_labels(const Labels& expected, Segment segment)
{
  CGAL_CHECK(checked(star_mesh(), segment).labels == expected);
}

template <typename Method>
Labels labels_by(const Method& method)
{
  return checked(star_mesh(), [&](auto ids)
                 { return CGAL::segmentation_via_protrusion_tips(star_mesh(), ids, 5, method); })
    .labels;
}

// The number, whatever its type, with a method and without, with named parameters and without.
template <typename Number>
void numbers_of_segments(Number k)
{
  const Mesh& mesh = star_mesh();
  const auto np = parameters::random_seed(0);
  const Minimum_cut_method minimum_cut;
  const Histogram_method histogram;
  static const Labels by_default = labels_by(minimum_cut), by_histogram = labels_by(histogram);
  CGAL_CHECK(by_default != by_histogram);
  const auto via = [&](const Labels& expected, const auto&... others)
  {
    check_labels(expected, [&](auto ids)
                 { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, others...); });
    const Segment_hierarchy hierarchy = CGAL::protrusion_hierarchy(mesh, k, others...);
    check_labels(expected,
                 [&](auto ids)
                 {
                   hierarchy.segment_ids(mesh, 5, ids);
                   return hierarchy.maximum_number_of_segments();
                 });
  };
  via(by_default);
  via(by_default, np);
  via(by_default, minimum_cut);
  via(by_default, minimum_cut, np);
  via(by_histogram, histogram);
  via(by_histogram, histogram, np);
}

template <typename Number>
void numbers_of_tips(Number n)
{
  const auto np = parameters::random_seed(0);
  const auto tips = [&](const auto&... others)
  {
    std::vector<Face_descriptor> result;
    CGAL::protrusion_tips(star_mesh(), n, std::back_inserter(result), others...);
    return result;
  };
  const std::vector<Face_descriptor> expected = tips();
  CGAL_CHECK_EQUAL(expected.size(), n);
  CGAL_CHECK(tips(np) == expected);
  CGAL_CHECK(tips(Geodesic_distance()) == expected);
  CGAL_CHECK(tips(Geodesic_distance(), np) == expected);
}

void numbers_may_have_any_integer_type()
{
  numbers_of_segments(5);
  numbers_of_segments(5u);
  numbers_of_segments(5l);
  numbers_of_segments(static_cast<short>(5));
  numbers_of_segments(static_cast<unsigned char>(5));
  numbers_of_segments(std::size_t(5));
  numbers_of_tips(4);
  numbers_of_tips(4u);
  numbers_of_tips(4l);
  numbers_of_tips(static_cast<short>(4));
  numbers_of_tips(std::size_t(4));
}

template <typename... Others>
std::size_t evident(const Others&... others)
{
  return checked(star_mesh(), [&](auto ids)
                 { return CGAL::segmentation_via_protrusion_tips(star_mesh(), ids, others...); })
    .number;
}

void without_a_number()
{
  const auto np = parameters::random_seed(0);
  CGAL_CHECK_EQUAL(evident(), 5);
  CGAL_CHECK_EQUAL(evident(np), 5);
  CGAL_CHECK_EQUAL(evident(Minimum_cut_method()), 5);
  CGAL_CHECK_EQUAL(evident(Minimum_cut_method(), np), 5);
  const std::size_t by_histogram = evident(Histogram_method());
  CGAL_CHECK(by_histogram >= 5);
  CGAL_CHECK_EQUAL(evident(Histogram_method(), np), by_histogram);
}

template <typename... Others>
Labels from_tips(const std::vector<Face_descriptor>& tips, const Others&... others)
{
  return checked(star_mesh(), [&](auto ids)
                 { return CGAL::segmentation_from_protrusion_tips(star_mesh(), tips, ids, others...); })
    .labels;
}

void from_given_tips()
{
  const auto np = parameters::random_seed(0);
  std::vector<Face_descriptor> tips;
  CGAL::protrusion_tips(star_mesh(), 4, std::back_inserter(tips));
  const Labels expected = from_tips(tips);
  CGAL_CHECK(from_tips(tips, np) == expected);
  CGAL_CHECK(from_tips(tips, Minimum_cut_method()) == expected);
  CGAL_CHECK(from_tips(tips, Minimum_cut_method(), np) == expected);
  CGAL_CHECK(from_tips(tips, Histogram_method(), np) == from_tips(tips, Histogram_method()));
}

// All templates that take one, with the tag in front.
template <typename Tag>
void with_tag()
{
  const Mesh& mesh = star_mesh();
  const auto np = parameters::random_seed(0);
  const Minimum_cut_method method;
  const Labels expected = labels_by(method);
  check_labels(expected,
               [&](auto ids) { return CGAL::segmentation_via_protrusion_tips<Tag>(mesh, ids); });
  check_labels(expected,
               [&](auto ids) { return CGAL::segmentation_via_protrusion_tips<Tag>(mesh, ids, 5); });
  check_labels(expected,
               [&](auto ids) { return CGAL::segmentation_via_protrusion_tips<Tag>(mesh, ids, method); });
  check_labels(expected, [&](auto ids)
               { return CGAL::segmentation_via_protrusion_tips<Tag>(mesh, ids, 5, method, np); });
  CGAL_CHECK_EQUAL(CGAL::protrusion_hierarchy<Tag>(mesh, 5).maximum_number_of_segments(), 5);
  CGAL_CHECK_EQUAL(CGAL::protrusion_hierarchy<Tag>(mesh, 5, method, np).maximum_number_of_segments(), 5);
  std::vector<Face_descriptor> tips;
  CGAL::protrusion_tips<Tag>(mesh, 4, std::back_inserter(tips));
  CGAL::protrusion_tips<Tag>(mesh, 4, std::back_inserter(tips), Landmark_geodesic_distance(), np);
  CGAL_CHECK_EQUAL(tips.size(), 8);
  tips.resize(4);
  for (int i = 0; i < 2; ++i)
    check_labels(from_tips(tips),
                 [&](auto ids)
                 {
                   return i == 0
                            ? CGAL::segmentation_from_protrusion_tips<Tag>(mesh, tips, ids)
                            : CGAL::segmentation_from_protrusion_tips<Tag>(mesh, tips, ids, method, np);
                 });
}

template <typename Number>
void check_refused_number(Number k, const std::string& number)
{
  const std::string message = "number_of_segments is " + number + ", but it must be from 1 to " +
                              std::to_string(star_mesh().number_of_faces()) + ", the number of faces of pmesh";
  const Mesh& mesh = star_mesh();
  Segment_ids<Mesh> ids(mesh);
  CGAL_CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), k), std::invalid_argument,
                    message);
  CGAL_CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), k, Histogram_method()),
                    std::invalid_argument, message);
  CGAL_CHECK_THROWS_WITH(CGAL::protrusion_hierarchy(mesh, k), std::invalid_argument, "maximum_" + message);
  CGAL_CHECK_THROWS_WITH(CGAL::protrusion_hierarchy(mesh, k, Histogram_method()), std::invalid_argument,
                    "maximum_" + message);
  CGAL_CHECK(is_untouched({0, ids.labels()}));
}

// None of them becomes a huge number.
void numbers_below_one_are_refused()
{
  check_refused_number(-1, "-1");
  check_refused_number(-1l, "-1");
  check_refused_number(static_cast<short>(-7), "-7");
  check_refused_number((std::numeric_limits<long long>::min)(),
                       "-9223372036854775808");
  check_refused_number(0, "0");
  check_refused_number(0u, "0");
  check_refused_number(std::size_t(0), "0");
  check_refused_number((std::numeric_limits<std::size_t>::max)(), "18446744073709551615");
  std::vector<Face_descriptor> tips;
  CGAL_CHECK_THROWS_WITH(CGAL::protrusion_tips(star_mesh(), -3, std::back_inserter(tips)),
                    std::invalid_argument, "number_of_tips is -3, but it must be from 0 to ");
  CGAL_CHECK_THROWS_WITH(
    CGAL::protrusion_tips(star_mesh(), -3l, std::back_inserter(tips), Geodesic_distance()),
    std::invalid_argument, "number_of_tips is -3, but it must be from 0 to ");
  CGAL::protrusion_tips(star_mesh(), 0, std::back_inserter(tips));
  CGAL_CHECK(tips.empty());
}

template <typename Id, typename Segment>
void check_narrow_ids(Segment segment, const std::string& message)
{
  Mesh mesh = star_mesh();
  const auto ids = mesh.add_property_map<Face_descriptor, Id>("f:id", Id(1)).first;
  CGAL_CHECK_THROWS_WITH(segment(mesh, ids), std::invalid_argument, message);
  for (const Face_descriptor f : mesh.faces())
    CGAL_CHECK_EQUAL(ids[f], Id(1));
}

// Two segments would become one.
void ids_must_fit_into_the_map()
{
  const auto many = [](const Mesh& mesh, auto ids)
  { CGAL::segmentation_via_protrusion_tips(mesh, ids, 300, Histogram_method()); };
  const auto few = [](const Mesh& mesh, auto ids) { CGAL::segmentation_via_protrusion_tips(mesh, ids, 5); };
  const auto of_hierarchy = [](const Mesh& mesh, auto ids)
  { CGAL::protrusion_hierarchy(mesh, 5).segment_ids(mesh, 5, ids); };
  check_narrow_ids<unsigned char>(many, "holds numbers up to 255, but there is a segment ");
  check_narrow_ids<bool>(few, "holds numbers up to 1, but there is a segment ");
  check_narrow_ids<bool>(of_hierarchy, "holds numbers up to 1, but there is a segment ");
  Mesh mesh = star_mesh();
  const auto ids = mesh.add_property_map<Face_descriptor, unsigned char>("f:id").first;
  CGAL_CHECK_EQUAL(CGAL::segmentation_via_protrusion_tips(mesh, ids, 5), 5);
  CGAL_CHECK_EQUAL(*std::max_element(ids.begin(), ids.end()), 4);
}

int main()
{
  numbers_may_have_any_integer_type();
  without_a_number();
  from_given_tips();
  with_tag<CGAL::Sequential_tag>();
#ifdef CGAL_LINKED_WITH_TBB
  with_tag<CGAL::Parallel_tag>();
#endif
  numbers_below_one_are_refused();
  ids_must_fit_into_the_map();
  return check::result();
}
