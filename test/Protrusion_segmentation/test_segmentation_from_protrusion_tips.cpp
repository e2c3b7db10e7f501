// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tips alone, and segmentations from given tips.

#include "segmentations.h"
#include "star_mesh.h"

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
namespace parameters = CGAL::parameters;

using Face_descriptor = Mesh::Face_index;

std::vector<Face_descriptor> tips_of(const Mesh& mesh, std::size_t number)
{
  std::vector<Face_descriptor> tips;
  CGAL::protrusion_tips(mesh, number, std::back_inserter(tips), Geodesic_distance());
  return tips;
}

template <typename Tips>
Segmentation segmentation_from_tips(const Mesh& mesh, const Tips& tips)
{
  return checked(mesh,
                 [&](auto ids)
                 {
                   return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, Histogram_method());
                 });
}

void tips_alone_and_from_tips_make_the_whole()
{
  const std::vector<Face_descriptor> tips = tips_of(star_mesh(), 4);
  CHECK_EQUAL(tips.size(), 4);
  std::set<std::size_t> arms;
  for (const Face_descriptor tip : tips)
    arms.insert(star_soup().parts[tip]);
  CHECK(arms == (std::set<std::size_t>{1, 2, 3, 4}));
  CHECK(segmentation_from_tips(star_mesh(), tips).labels == paper_segmentation(star_mesh(), 5).labels);
}

void edited_tips_make_the_segments_of_those_left()
{
  std::vector<Face_descriptor> tips = tips_of(star_mesh(), 4);
  const std::size_t left_out = star_soup().parts[tips[1]];
  tips.erase(tips.begin() + 1);
  const Segmentation found = segmentation_from_tips(star_mesh(), tips);
  CHECK_EQUAL(found.number, 4);
  for (std::size_t f = 0; f < found.labels.size(); ++f)
    if (star_soup().parts[f] == left_out)
      CHECK_EQUAL(found.labels[f], 0);
  CHECK_EQUAL(segmentation_from_tips(star_mesh(), std::vector<Face_descriptor>()).number, 1);
  CHECK_EQUAL(segmentation_from_tips(star_mesh(), std::array<Face_descriptor, 1>{tips[0]}).number, 2);
}

void a_tip_given_twice_counts_once()
{
  std::vector<Face_descriptor> tips = tips_of(star_mesh(), 4);
  const Labels expected = segmentation_from_tips(star_mesh(), tips).labels;
  tips.push_back(tips[0]);
  tips.insert(tips.begin() + 2, tips[1]);
  CHECK(segmentation_from_tips(star_mesh(), tips).labels == expected);
}

void impossible_tips_are_refused()
{
  Segment_ids<Mesh> ids(star_mesh());
  const std::vector<Face_descriptor> beyond(1, Face_descriptor(unsigned(num_faces(star_mesh()))));
  CHECK_THROWS_WITH(CGAL::segmentation_from_protrusion_tips(star_mesh(), beyond, ids.map(), Histogram_method()),
                    std::invalid_argument, "tips");
  CHECK_THROWS_WITH(CGAL::segmentation_from_protrusion_tips(
                      star_mesh(), std::vector<Face_descriptor>(1, Mesh::null_face()), ids.map(), Histogram_method()),
                    std::invalid_argument, "tips");
  CHECK(is_untouched({0, ids.labels()}));
  CHECK_THROWS_WITH(tips_of(to_graph<Mesh>(tetrahedron()), 5), std::invalid_argument,
                    "number_of_tips is 5");
  CHECK_EQUAL(tips_of(to_graph<Mesh>(tetrahedron()), 4).size(), 4);
  CHECK_EQUAL(tips_of(star_mesh(), 0).size(), 0);
  CHECK_EQUAL(tips_of(Mesh(), 0).size(), 0);
}

// Tips go to the component with the largest area per tip, the new one counted.
void components_share_the_tips()
{
  const Test_mesh small = icosphere(1), large = scaled(icosphere(2), 2);
  const Mesh mesh = to_graph<Mesh>(merged({small, translated(large, {5, 0, 0})}));
  const auto tips_on_small = [&](std::size_t number)
  {
    const std::vector<Face_descriptor> tips = tips_of(mesh, number);
    CHECK_EQUAL(tips.size(), number);
    return std::count_if(tips.begin(), tips.end(),
                         [&](Face_descriptor f) { return std::size_t(f) < small.faces.size(); });
  };
  CHECK_EQUAL(tips_on_small(1), 0);
  CHECK_EQUAL(tips_on_small(4), 0); // area 4 to 1
  CHECK_EQUAL(tips_on_small(5), 1);
  CHECK_EQUAL(tips_on_small(10), 2);
}

int main()
{
  tips_alone_and_from_tips_make_the_whole();
  edited_tips_make_the_segments_of_those_left();
  a_tip_given_twice_counts_once();
  impossible_tips_are_refused();
  components_share_the_tips();
  return check::result();
}
