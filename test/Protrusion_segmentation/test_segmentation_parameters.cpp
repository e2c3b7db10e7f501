// SPDX-License-Identifier: GPL-3.0-or-later
//
// Named parameters, visitors, options, tips, several components, and what is refused.

#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
namespace parameters = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face_descriptor = Mesh::Face_index;

const Test_mesh& star_soup()
{
  static const Test_mesh soup = star(4, 1, 0.15, 0.04, 0.2);
  return soup;
}

const Mesh& star_mesh()
{
  static const Mesh mesh = to_graph<Mesh>(star_soup());
  return mesh;
}

// Automatic number of segments.
template <typename FaceGraph>
Segmentation evident_protrusions(const FaceGraph& mesh, const Histogram_border& border = {})
{
  return checked(mesh, [&](auto ids)
  {
    return CGAL::segmentation_via_protrusion_tips(mesh, ids, Geodesic_distance(), border);
  });
}

Segmentation landmark_segmentation(const Mesh& mesh, std::size_t k, unsigned int seed,
                                   const Landmark_geodesic_distance& distance
                                     = Landmark_geodesic_distance())
{
  return checked(mesh, [&](auto ids)
  {
    return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, distance, Histogram_border(),
                                                  parameters::random_seed(seed));
  });
}

// All arms are evident, and what it finds in them when it goes on ends somewhere.
void the_method_stops_by_itself()
{
  const Segmentation found = evident_protrusions(star_mesh());
  CHECK(found.number >= 5 && found.number < star_soup().faces.size());
  CHECK(share_in_true_parts(star_soup(), found.labels) > 0.9);
  CHECK_EQUAL(evident_protrusions(to_graph<Mesh>(open_cylinder(1, 1))).number, 1);
  CHECK_EQUAL(evident_protrusions(to_graph<Mesh>(regular_prism(40))).number, 1);
}

void the_same_seed_gives_the_same_landmarks()
{
  const Segmentation first = landmark_segmentation(star_mesh(), 5, 7);
  CHECK_EQUAL(first.number, 5);
  CHECK(share_in_true_parts(star_soup(), first.labels) > 0.95);
  CHECK(landmark_segmentation(star_mesh(), 5, 7).labels == first.labels);
  for(const double fraction : {0.01, 0.1})
    CHECK_EQUAL(landmark_segmentation(star_mesh(), 5, 1, Landmark_geodesic_distance(fraction)).number,
                5);
  // with few landmarks another seed gives another segmentation, sooner or later
  const auto two = Landmark_geodesic_distance::with_number_of_landmarks(2);
  bool differs = false;
  for(unsigned int seed = 1; seed < 20; ++seed)
    differs = differs || landmark_segmentation(star_mesh(), 5, seed, two).labels
                           != landmark_segmentation(star_mesh(), 5, 0, two).labels;
  CHECK(differs);
}

void points_are_read_from_the_map()
{
  const Test_mesh& soup = star_soup();
  const Mesh flat = to_graph<Mesh>(scaled(soup, 1, 1, 0));
  std::vector<Kernel::Point_3> points;
  for(const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  const auto map = boost::make_function_property_map<Mesh::Vertex_index>(
    [&](Mesh::Vertex_index v) { return points[v]; });
  CHECK(paper_segmentation(flat, 5, parameters::vertex_point_map(map)).labels
        == paper_segmentation(star_mesh(), 5).labels);
}

void borders_are_the_edges_between_segments()
{
  const Mesh& mesh = star_mesh();
  std::map<Mesh::Edge_index, bool> is_border;
  const auto map = boost::make_assoc_property_map(is_border);
  const Segmentation found = paper_segmentation(mesh, 5, parameters::edge_is_constrained_map(map));
  CHECK_EQUAL(is_border.size(), num_edges(mesh));
  std::size_t number = 0;
  for(const auto& item : is_border)
  {
    const auto h = halfedge(item.first, mesh);
    CHECK_EQUAL(item.second, found.labels[face(h, mesh)] != found.labels[face(opposite(h, mesh), mesh)]);
    number += item.second;
  }
  CHECK(number > 4 * 10);
}

// The sheet's own border is none between segments.
void edges_with_one_face_are_no_borders()
{
  const Mesh mesh = to_graph<Mesh>(sheet(4, 4));
  std::map<Mesh::Edge_index, bool> is_border;
  paper_segmentation(mesh, 1, parameters::edge_is_constrained_map(
                                boost::make_assoc_property_map(is_border)));
  CHECK_EQUAL(is_border.size(), num_edges(mesh));
  for(const auto& item : is_border)
    CHECK(!item.second);
}

struct Recorder : Default_visitor
{
  void stage_starts(Stage stage)
  {
    open.push_back(stage);
    ++stages[stage];
  }
  void stage_ends(Stage stage)
  {
    CHECK(!open.empty() && open.back() == stage);
    open.pop_back();
  }
  void progress(double share)
  {
    CHECK(share >= 0 && share <= 1);
    shares.push_back(share);
  }
  bool go_further() { return ++questions != stop_at; }
  void tip_found(std::size_t face) { tips.insert(face); }
  void protrusion_found(const Protrusion& protrusion) { protrusions.push_back(protrusion); }
  void distances_computed(std::size_t number_of_runs) { runs += number_of_runs; }

  std::vector<Stage> open;
  std::map<Stage, int> stages;
  std::vector<double> shares;
  std::size_t questions = 0, stop_at = 0, runs = 0;
  std::set<std::size_t> tips;
  std::vector<Protrusion> protrusions;
};

void a_visitor_is_told_what_is_found()
{
  const double factor = 3; // lengths and areas are in the unit of the mesh
  const Test_mesh soup = scaled(star_soup(), factor);
  Recorder recorder;
  const Segmentation found =
    paper_segmentation(to_graph<Mesh>(soup), 5, parameters::visitor(std::ref(recorder)));

  CHECK(recorder.open.empty());
  for(const Stage stage : {Stage::READING, Stage::TIPS, Stage::BORDERS, Stage::LABELS})
    CHECK(recorder.stages[stage] > 0);
  CHECK(std::is_sorted(recorder.shares.begin(), recorder.shares.end()));
  CHECK_EQUAL(recorder.shares.back(), 1);
  CHECK(recorder.runs > 4 && recorder.runs < 200);

  CHECK_EQUAL(recorder.protrusions.size(), 4);
  for(const Protrusion& protrusion : recorder.protrusions)
  {
    CHECK(protrusion.parent < protrusion.segment && protrusion.segment < found.number);
    CHECK_EQUAL(found.labels[protrusion.tip], protrusion.segment);
    CHECK_EQUAL(recorder.tips.count(protrusion.tip), 1);
    CHECK(protrusion.border_distance > factor && protrusion.border_distance < 2.5 * factor);
    // around the arm, in zigzag
    const double girth = 2 * pi * 0.15 * factor;
    CHECK(protrusion.border_length > girth && protrusion.border_length < 2 * girth);
    double area = 0;
    for(std::size_t f = 0; f < found.labels.size(); ++f)
      area += found.labels[f] == protrusion.segment ? face_area(soup, soup.faces[f]) : 0;
    CHECK_CLOSE(protrusion.area, area, 1e-9 * area);
    CHECK(protrusion.score >= 0.3);
    CHECK(protrusion.border_slot < 100);
    CHECK_EQUAL(protrusion.distance_histogram.size(), 100);
    CHECK(std::accumulate(protrusion.distance_histogram.begin(), protrusion.distance_histogram.end(),
                          std::size_t(0)) > soup.faces.size() / 2);
    // half way down the arm the diameter is that of the arm
    CHECK_CLOSE(protrusion.sectional_diameter_histogram.at(protrusion.border_slot / 2), 0.3 * factor,
                0.05 * factor);
  }
}

void visitors_are_copied_unless_passed_by_reference()
{
  Recorder recorder;
  paper_segmentation(star_mesh(), 2, parameters::visitor(recorder));
  CHECK(recorder.stages.empty());
  paper_segmentation(star_mesh(), 2, parameters::visitor(std::ref(recorder)));
  CHECK(!recorder.stages.empty());
}

void a_visitor_stops_the_method_at_every_question()
{
  Recorder all;
  paper_segmentation(star_mesh(), 5, parameters::visitor(std::ref(all)));
  CHECK(all.questions > 5);
  for(std::size_t question = 1; question <= all.questions; ++question)
  {
    Recorder recorder;
    recorder.stop_at = question;
    std::map<Mesh::Edge_index, bool> is_border;
    const Segmentation found = paper_segmentation(
      star_mesh(), 5, parameters::visitor(std::ref(recorder))
                        .edge_is_constrained_map(boost::make_assoc_property_map(is_border)));
    CHECK_EQUAL(found.number, 0); // and `checked()` sees that nothing was written
    CHECK(is_border.empty());
    CHECK_EQUAL(recorder.questions, question);
    CHECK(recorder.open.empty());
  }
}

struct Failing_visitor : Default_visitor
{
  void tip_found(std::size_t) { throw std::runtime_error("no more tips"); }
};

void exceptions_of_a_visitor_get_through()
{
  Segment_ids<Mesh> ids(star_mesh());
  CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(
                      star_mesh(), ids.map(), 5, Geodesic_distance(), Histogram_border(),
                      parameters::visitor(Failing_visitor())),
                    std::runtime_error, "no more tips");
  CHECK(is_untouched({0, ids.labels()}));
}

std::vector<Face_descriptor> tips_of(const Mesh& mesh, std::size_t number)
{
  std::vector<Face_descriptor> tips;
  CGAL::protrusion_tips(mesh, number, std::back_inserter(tips), Geodesic_distance());
  return tips;
}

template <typename Tips>
Segmentation segmentation_from_tips(const Mesh& mesh, const Tips& tips)
{
  return checked(mesh, [&](auto ids)
  {
    return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, Geodesic_distance(),
                                                   Histogram_border());
  });
}

void tips_alone_and_from_tips_make_the_whole()
{
  const std::vector<Face_descriptor> tips = tips_of(star_mesh(), 4);
  CHECK_EQUAL(tips.size(), 4);
  std::set<std::size_t> arms;
  for(const Face_descriptor tip : tips)
    arms.insert(star_soup().parts[tip]);
  CHECK(arms == (std::set<std::size_t>{1, 2, 3, 4}));
  CHECK(segmentation_from_tips(star_mesh(), tips).labels
        == paper_segmentation(star_mesh(), 5).labels);
}

void edited_tips_make_the_segments_of_those_left()
{
  std::vector<Face_descriptor> tips = tips_of(star_mesh(), 4);
  const std::size_t left_out = star_soup().parts[tips[1]];
  tips.erase(tips.begin() + 1);
  const Segmentation found = segmentation_from_tips(star_mesh(), tips);
  CHECK_EQUAL(found.number, 4);
  for(std::size_t f = 0; f < found.labels.size(); ++f)
    if(star_soup().parts[f] == left_out)
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
  CHECK_THROWS_WITH(CGAL::segmentation_from_protrusion_tips(star_mesh(), beyond, ids.map(),
                                                            Geodesic_distance(), Histogram_border()),
                    std::invalid_argument, "tips");
  CHECK_THROWS_WITH(CGAL::segmentation_from_protrusion_tips(
                      star_mesh(), std::vector<Face_descriptor>(1, Mesh::null_face()), ids.map(),
                      Geodesic_distance(), Histogram_border()),
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
    return std::count_if(tips.begin(), tips.end(), [&](Face_descriptor f) { return std::size_t(f) < small.faces.size(); });
  };
  CHECK_EQUAL(tips_on_small(1), 0);
  CHECK_EQUAL(tips_on_small(4), 0); // area 4 to 1
  CHECK_EQUAL(tips_on_small(5), 1);
  CHECK_EQUAL(tips_on_small(10), 2);
}

void every_component_is_a_segment_at_least()
{
  const Test_mesh one = star_soup();
  const Test_mesh soup =
    merged({icosphere(2), translated(one, {8, 0, 0}), translated(sheet(3, 3), {0, 8, 0})});
  const Mesh mesh = to_graph<Mesh>(soup);
  for(const std::size_t k : {1, 2, 3})
  {
    const Segmentation found = paper_segmentation(mesh, k);
    CHECK_EQUAL(found.number, 3);
    CHECK_EQUAL(found.labels.front(), 0); // components have the first ids, in the order of the faces
    CHECK_EQUAL(found.labels.back(), 2);
  }
  const Segmentation found = paper_segmentation(mesh, 7);
  CHECK_EQUAL(found.number, 7);
  CHECK(share_in_true_parts(soup, found.labels) > 0.98);
}

void impossible_numbers_of_segments_are_refused()
{
  const Mesh mesh = to_graph<Mesh>(icosphere(1));
  Segment_ids<Mesh> ids(mesh);
  const auto segment = [&](std::size_t k)
  {
    return CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), k, Geodesic_distance(),
                                                  Histogram_border());
  };
  CHECK_THROWS_WITH(segment(0), std::invalid_argument, "number_of_segments is 0");
  CHECK_THROWS_WITH(segment(81), std::invalid_argument, "only 80 faces");
  CHECK(is_untouched({0, ids.labels()}));
  CHECK_EQUAL(segment(1), 1);
  const std::size_t most = segment(80); // all that can be found
  CHECK(most >= 1 && most <= 80);
}

void impossible_options_are_refused()
{
  for(const double value : {0., -1., std::nan(""), HUGE_VAL})
    CHECK_THROWS_WITH(Histogram_border().minimum_prominence(value), std::invalid_argument,
                      "minimum_prominence");
  CHECK_EQUAL(Histogram_border().minimum_prominence(0.5).minimum_prominence(), 0.5);
  CHECK(!Histogram_border().uses_candidate_intervals(false).uses_candidate_intervals());
}

void options_decide_what_is_evident()
{
  const Mesh mesh = to_graph<Mesh>(capsule_with_ball(0.15));
  CHECK_EQUAL(evident_protrusions(mesh, Histogram_border().minimum_prominence(5)).number, 1);
  CHECK(evident_protrusions(mesh).number > 1);
  CHECK(evident_protrusions(mesh, Histogram_border().uses_candidate_intervals(false)).number > 1);
  // however small or large it is, a number of segments that was asked for is tried for
  for(const double prominence : {1e-3, 0.01, 5.})
    CHECK_EQUAL(checked(mesh, [&](auto ids)
    {
      return CGAL::segmentation_via_protrusion_tips(
        mesh, ids, 2, Geodesic_distance(), Histogram_border().minimum_prominence(prominence));
    }).number, 2);
}

int main()
{
  the_method_stops_by_itself();
  the_same_seed_gives_the_same_landmarks();
  points_are_read_from_the_map();
  borders_are_the_edges_between_segments();
  edges_with_one_face_are_no_borders();
  a_visitor_is_told_what_is_found();
  visitors_are_copied_unless_passed_by_reference();
  a_visitor_stops_the_method_at_every_question();
  exceptions_of_a_visitor_get_through();
  tips_alone_and_from_tips_make_the_whole();
  edited_tips_make_the_segments_of_those_left();
  a_tip_given_twice_counts_once();
  impossible_tips_are_refused();
  components_share_the_tips();
  every_component_is_a_segment_at_least();
  impossible_numbers_of_segments_are_refused();
  impossible_options_are_refused();
  options_decide_what_is_evident();
  return check::result();
}
