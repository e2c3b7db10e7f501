// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segmentations as lists of labels, in the order of the faces, that were checked for what every
// segmentation guarantees.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_SEGMENTATIONS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_SEGMENTATIONS_H

#include "check.h"
#include "test_mesh.h"
#include "validation.h"

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

namespace test_meshes {

using Labels = std::vector<std::size_t>;

struct Segmentation
{
  std::size_t number = 0;
  Labels labels;
};

// What a label is before a function writes it.
constexpr std::size_t unwritten = 1234567;

inline bool is_untouched(const Segmentation& segmentation)
{
  return std::all_of(segmentation.labels.begin(), segmentation.labels.end(),
                     [](std::size_t label) { return label == unwritten; });
}

// Segment ids of all faces of a mesh, `unwritten` at first.
template <typename FaceGraph>
class Segment_ids
{
public:
  using Face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;

  explicit Segment_ids(const FaceGraph& mesh) : m_mesh(mesh)
  {
    for (const auto f : faces(mesh))
      m_ids[f] = unwritten;
  }

  auto map() { return boost::make_assoc_property_map(m_ids); }

  Labels labels() const
  {
    Labels result;
    for (const auto f : faces(m_mesh))
      result.push_back(m_ids.at(f));
    return result;
  }

private:
  const FaceGraph& m_mesh;
  std::map<Face_descriptor, std::size_t> m_ids;
};

// `segment`: segment map -> number of segments. Checks that the result is valid, and that it is
// untouched where the function returns 0.
template <typename FaceGraph, typename Segment>
Segmentation checked(const FaceGraph& mesh, Segment segment)
{
  Segment_ids<FaceGraph> ids(mesh);
  Segmentation result;
  result.number = segment(ids.map());
  result.labels = ids.labels();
  if (result.number == 0)
    CGAL_CHECK(is_untouched(result));
  else
    CGAL_CHECK_EQUAL(validation::problem_with_segmentation(mesh, ids.map(), result.number).value_or("no problem"),
                "no problem");
  return result;
}

// The default method, with the number of segments that it finds.
inline Segmentation automatic_segmentation(const Test_mesh& soup)
{
  const auto mesh = to_graph<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>(soup);
  return checked(mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids); });
}

// The same with a number of segments.
inline Segmentation given_segmentation(const Test_mesh& soup, std::size_t k)
{
  const auto mesh = to_graph<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>(soup);
  return checked(mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k); });
}

// The paper's method.
template <typename FaceGraph, typename NamedParameters>
Segmentation paper_segmentation(const FaceGraph& mesh, std::size_t k, const NamedParameters& np)
{
  using namespace CGAL::Protrusion_segmentation;
  return checked(mesh,
                 [&](auto ids) {
                   return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, Histogram_method(), np);
                 });
}

template <typename FaceGraph>
Segmentation paper_segmentation(const FaceGraph& mesh, std::size_t k)
{
  return paper_segmentation(mesh, k, CGAL::parameters::default_values());
}

// The labels renumbered in the order of their first faces: equal for equal partitions.
inline Labels as_partition(const Labels& labels)
{
  std::map<std::size_t, std::size_t> numbers;
  Labels result;
  for (const std::size_t label : labels)
    result.push_back(numbers.emplace(label, numbers.size()).first->second);
  return result;
}

// The share of the area in faces that have the true part that is most common in their segment.
inline double share_in_true_parts(const Test_mesh& mesh, const Labels& labels)
{
  std::map<std::size_t, std::map<std::size_t, double>> areas;
  for (std::size_t f = 0; f < labels.size(); ++f)
    areas[labels[f]][mesh.parts[f]] += face_area(mesh, mesh.faces[f]);
  double sum = 0;
  for (const auto& segment : areas)
    sum += std::max_element(segment.second.begin(), segment.second.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
             ->second;
  return sum / area(mesh);
}

// As many segments as there are true parts, and at least `least_share` of the area in the right one.
inline void check_parts(const Test_mesh& mesh, const Segmentation& found, double least_share)
{
  CGAL_CHECK_EQUAL(found.number, number_of_parts(mesh));
  const double share = share_in_true_parts(mesh, found.labels);
  std::cout << mesh.faces.size() << " faces, " << found.number << " segments: " << 100 * share
            << " % of the area in the true part\n";
  CGAL_CHECK(share >= least_share);
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_SEGMENTATIONS_H
