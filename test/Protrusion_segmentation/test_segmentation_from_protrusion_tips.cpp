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
                 [&](auto ids) {
                   return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, Histogram_method());
                 });
}

void tips_alone_and_from_tips_make_the_whole()
{
  const std::vector<Face_descriptor> tips = tips_of(star_mesh(), 4);
  CGAL_CHECK_EQUAL(tips.size(), 4);
  std::set<std::size_t> arms;
  for (const Face_descriptor tip : tips)
    arms.insert(star_soup().parts[tip]);
  CGAL_CHECK(arms == (std::set<std::size_t>{1, 2, 3, 4}));
  CGAL_CHECK(segmentation_from_tips(star_mesh(), tips).labels == paper_segmentation(star_mesh(), 5).labels);
}

void edited_tips_make_the_segments_of_those_left()
{
  std::vector<Face_descriptor> tips = tips_of(star_mesh(), 4);
  const std::size_t left_out = star_soup().parts[tips[1]];
  tips.erase(tips.begin() + 1);
  const Segmentation found = segmentation_from_tips(star_mesh(), tips);
  CGAL_CHECK_EQUAL(found.number, 4);
  for (std::size_t f = 0; f < found.labels.size(); ++f)
    if (star_soup().parts[f] == left_out)
      CGAL_CHECK_EQUAL(found.labels[f], 0);
  CGAL_CHECK_EQUAL(segmentation_from_tips(star_mesh(), std::vector<Face_descriptor>()).number, 1);
  CGAL_CHECK_EQUAL(segmentation_from_tips(star_mesh(), std::array<Face_descriptor, 1>{tips[0]}).number, 2);
}

void a_tip_given_twice_counts_once()
{
  std::vector<Face_descriptor> tips = tips_of(star_mesh(), 4);
  const Labels expected = segmentation_from_tips(star_mesh(), tips).labels;
  tips.push_back(tips[0]);
  tips.insert(tips.begin() + 2, tips[1]);
  CGAL_CHECK(segmentation_from_tips(star_mesh(), tips).labels == expected);
}

void impossible_tips_are_refused()
{
  Segment_ids<Mesh> ids(star_mesh());
  const std::vector<Face_descriptor> beyond(1, Face_descriptor(unsigned(num_faces(star_mesh()))));
  CGAL_CHECK_THROWS_WITH(
    CGAL::segmentation_from_protrusion_tips(star_mesh(), beyond, ids.map(), Histogram_method()),
    std::invalid_argument, "tips");
  CGAL_CHECK_THROWS_WITH(
    CGAL::segmentation_from_protrusion_tips(
      star_mesh(), std::vector<Face_descriptor>(1, Mesh::null_face()), ids.map(), Histogram_method()),
    std::invalid_argument, "tips");
  CGAL_CHECK(is_untouched({0, ids.labels()}));
  CGAL_CHECK_THROWS_WITH(tips_of(to_graph<Mesh>(tetrahedron()), 5), std::invalid_argument,
                    "number_of_tips is 5");
  CGAL_CHECK_EQUAL(tips_of(to_graph<Mesh>(tetrahedron()), 4).size(), 4);
  CGAL_CHECK_EQUAL(tips_of(star_mesh(), 0).size(), 0);
  CGAL_CHECK_EQUAL(tips_of(Mesh(), 0).size(), 0);
}

// Tips go to the component with the largest area per tip, the new one counted.
void components_share_the_tips()
{
  const Test_mesh small = icosphere(1), large = scaled(icosphere(2), 2);
  const Mesh mesh = to_graph<Mesh>(merged({small, translated(large, {5, 0, 0})}));
  const auto tips_on_small = [&](std::size_t number)
  {
    const std::vector<Face_descriptor> tips = tips_of(mesh, number);
    CGAL_CHECK_EQUAL(tips.size(), number);
    return std::count_if(tips.begin(), tips.end(),
                         [&](Face_descriptor f) { return std::size_t(f) < small.faces.size(); });
  };
  CGAL_CHECK_EQUAL(tips_on_small(1), 0);
  CGAL_CHECK_EQUAL(tips_on_small(4), 0); // area 4 to 1
  CGAL_CHECK_EQUAL(tips_on_small(5), 1);
  CGAL_CHECK_EQUAL(tips_on_small(10), 2);
}

template <typename Method>
Segmentation segmentation_from(const Mesh& mesh,
                               const std::vector<Face_descriptor>& tips,
                               const Method& method)
{
  return checked(mesh, [&](auto ids)
                 { return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, method); });
}

// Of each arm the face farthest from the centre.
std::vector<Face_descriptor> ends_of_arms(const Test_mesh& soup)
{
  std::vector<Face_descriptor> ends(number_of_parts(soup), Mesh::null_face());
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
  {
    Face_descriptor& end = ends[soup.parts[f]];
    if (end == Mesh::null_face() ||
        length(centroid(soup, soup.faces[f])) > length(centroid(soup, soup.faces[end])))
      end = Face_descriptor(static_cast<Mesh::size_type>(f));
  }
  ends.erase(ends.begin()); // the body's
  return ends;
}

// The area that a segment and a true part have in common, as a share of what they cover together.
double overlap(const Test_mesh& soup, const Labels& labels, std::size_t segment, std::size_t part)
{
  double common = 0, covered = 0;
  for (std::size_t f = 0; f < labels.size(); ++f)
  {
    const double area = face_area(soup, soup.faces[f]);
    common += labels[f] == segment && soup.parts[f] == part ? area : 0;
    covered += labels[f] == segment || soup.parts[f] == part ? area : 0;
  }
  return common / covered;
}

template <typename Method>
void one_tip_cuts_off_its_arm(const Test_mesh& soup, const Method& method)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  for (const Face_descriptor tip : ends_of_arms(soup))
  {
    const Segmentation found = segmentation_from(mesh, {tip}, method);
    CGAL_CHECK_EQUAL(found.number, 2);
    CGAL_CHECK_EQUAL(found.labels[tip], 1);
    const double share = overlap(soup, found.labels, 1, soup.parts[tip]);
    std::cout << "arm " << soup.parts[tip] << " of " << number_of_parts(soup) - 1 << ": " << 100 * share
              << " %\n";
    CGAL_CHECK(share >= 0.9);
  }
}

// A tip means a place: again, or beside an earlier one, it means the same.
template <typename Method>
void tips_in_one_place_count_once(const Method& method)
{
  const Test_mesh soup = star(6);
  const Mesh mesh = to_graph<Mesh>(soup);
  const std::vector<Face_descriptor> once = ends_of_arms(soup);
  const Segmentation expected = segmentation_from(mesh, once, method);
  CGAL_CHECK_EQUAL(expected.number, 7);

  std::vector<Face_descriptor> twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  CGAL_CHECK(segmentation_from(mesh, twice, method).labels == expected.labels);
  CGAL_CHECK(segmentation_from(mesh, twice, method).number <= 7);

  std::vector<Face_descriptor> with_neighbors = once;
  for (const Face_descriptor tip : once)
    for (const auto v : vertices_around_face(halfedge(tip, mesh), mesh))
      for (const Face_descriptor f : faces_around_target(halfedge(v, mesh), mesh))
        with_neighbors.push_back(f);
  CGAL_CHECK(with_neighbors.size() > 60);
  CGAL_CHECK(segmentation_from(mesh, with_neighbors, method).labels == expected.labels);

  // where the first tip of each place is another one, there are as many segments
  std::reverse(with_neighbors.begin(), with_neighbors.end());
  CGAL_CHECK(segmentation_from(mesh, with_neighbors, method).number <= 7);
}

void one_tip_cuts_off_its_arm()
{
  const Test_mesh thin_star = star(5, 2, 0.1, 0.04, 0.1), thin_octopus = star(8, 2, 0.1, 0.04, 0.1);
  // not where arms are thick: planes through the body that meet other arms mislead the histogram of diameters
  one_tip_cuts_off_its_arm(thin_star, Histogram_method());
  one_tip_cuts_off_its_arm(thin_octopus, Histogram_method());
  for (const Test_mesh& soup : {thin_star, thin_octopus, star(6), star(8)})
  {
    one_tip_cuts_off_its_arm(soup, Minimum_cut_method());
    one_tip_cuts_off_its_arm(soup, Minimum_cut_method(Geodesic_distance()));
  }
}

int main()
{
  tips_alone_and_from_tips_make_the_whole();
  edited_tips_make_the_segments_of_those_left();
  a_tip_given_twice_counts_once();
  impossible_tips_are_refused();
  components_share_the_tips();
  one_tip_cuts_off_its_arm();
  tips_in_one_place_count_once(Histogram_method());
  tips_in_one_place_count_once(Minimum_cut_method());
  tips_in_one_place_count_once(Minimum_cut_method(Geodesic_distance()));
  return check::result();
}
