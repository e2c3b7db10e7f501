// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a visitor is told, and how it stops the method.

#include "segmentations.h"
#include "star_mesh.h"

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
namespace parameters = CGAL::parameters;

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
  const Segmentation found = paper_segmentation(to_graph<Mesh>(soup), 5,
                                                parameters::visitor(std::ref(recorder)));

  CHECK(recorder.open.empty());
  for (const Stage stage : {Stage::READING, Stage::TIPS, Stage::BORDERS, Stage::LABELS})
    CHECK(recorder.stages[stage] > 0);
  CHECK(std::is_sorted(recorder.shares.begin(), recorder.shares.end()));
  CHECK_EQUAL(recorder.shares.back(), 1);
  CHECK(recorder.runs > 4 && recorder.runs < 200);

  CHECK_EQUAL(recorder.protrusions.size(), 4);
  for (const Protrusion& protrusion : recorder.protrusions)
  {
    CHECK(protrusion.parent < protrusion.segment && protrusion.segment < found.number);
    CHECK_EQUAL(found.labels[protrusion.tip], protrusion.segment);
    CHECK_EQUAL(recorder.tips.count(protrusion.tip), 1);
    CHECK(protrusion.border_distance > factor && protrusion.border_distance < 2.5 * factor);
    // around the arm, in zigzag
    const double girth = 2 * pi * 0.15 * factor;
    CHECK(protrusion.border_length > girth && protrusion.border_length < 2 * girth);
    double area = 0;
    for (std::size_t f = 0; f < found.labels.size(); ++f)
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
  for (std::size_t question = 1; question <= all.questions; ++question)
  {
    Recorder recorder;
    recorder.stop_at = question;
    std::map<Mesh::Edge_index, bool> is_border;
    const Segmentation found = paper_segmentation(
      star_mesh(), 5,
      parameters::visitor(std::ref(recorder))
        .edge_is_constrained_map(boost::make_assoc_property_map(is_border)));
    CHECK_EQUAL(found.number, 0); // and `checked()` sees that nothing was written
    CHECK(is_border.empty());
    CHECK_EQUAL(recorder.questions, question);
    CHECK(recorder.open.empty());
  }
}

// Throws in the function of the given number, and then at the end of every stage that is left for it.
struct Failing_visitor
{
  enum Function
  {
    STARTS,
    ENDS,
    PROGRESS,
    GO_FURTHER,
    TIP,
    PROTRUSION,
    DISTANCES,
    NUMBER_OF_FUNCTIONS
  };

  void fail(int function)
  {
    if (function == failing)
      throw std::runtime_error("the visitor's own");
  }

  void stage_starts(Stage) { fail(STARTS); }
  void stage_ends(Stage)
  {
    fail(ENDS);
    if (std::uncaught_exceptions() > 0)
      throw std::runtime_error("a second one");
  }
  void progress(double) { fail(PROGRESS); }
  bool go_further()
  {
    fail(GO_FURTHER);
    return true;
  }
  void tip_found(std::size_t) { fail(TIP); }
  void tip_eliminated(std::size_t) {}
  void protrusion_found(const Protrusion&) { fail(PROTRUSION); }
  void distances_computed(std::size_t) { fail(DISTANCES); }

  int failing;
};

template <typename Border>
void exceptions_of_a_visitor_get_through(const Border& border)
{
  for (int function = 0; function < Failing_visitor::NUMBER_OF_FUNCTIONS; ++function)
  {
    Segment_ids<Mesh> ids(star_mesh());
    std::map<Mesh::Edge_index, bool> is_border;
    CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(
                        star_mesh(), ids.map(), 5, Geodesic_distance(), border,
                        parameters::visitor(Failing_visitor{function})
                          .edge_is_constrained_map(boost::make_assoc_property_map(is_border))),
                      std::runtime_error, "the visitor's own");
    CHECK(is_untouched({0, ids.labels()}));
    CHECK(is_border.empty());
  }
}

int main()
{
  a_visitor_is_told_what_is_found();
  visitors_are_copied_unless_passed_by_reference();
  a_visitor_stops_the_method_at_every_question();
  exceptions_of_a_visitor_get_through(Histogram_method());
  exceptions_of_a_visitor_get_through(Minimum_cut_method());
  return check::result();
}
