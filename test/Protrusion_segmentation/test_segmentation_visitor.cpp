// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a visitor is told, and how it stops the method.

#include "recorder.h"
#include "segmentations.h"
#include "star_mesh.h"

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
namespace parameters = CGAL::parameters;

using Mesh_recorder = Recorder<Mesh>;

void a_visitor_is_told_what_is_found()
{
  const double factor = 3; // lengths and areas are in the unit of the mesh
  const Test_mesh soup = scaled(star_soup(), factor);
  Mesh_recorder recorder;
  const Segmentation found = paper_segmentation(to_graph<Mesh>(soup), 5,
                                                parameters::visitor(std::ref(recorder)));

  check_stages_and_progress(recorder);
  CGAL_CHECK(recorder.number_of_runs() > 4 && recorder.number_of_runs() < 200);

  CGAL_CHECK_EQUAL(recorder.protrusions().size(), 4);
  for (const auto& protrusion : recorder.protrusions())
  {
    CGAL_CHECK(protrusion.parent < protrusion.segment && protrusion.segment < found.number);
    CGAL_CHECK_EQUAL(found.labels[protrusion.tip], protrusion.segment);
    CGAL_CHECK_EQUAL(std::count(recorder.tips().begin(), recorder.tips().end(), protrusion.tip), 1);
    CGAL_CHECK(protrusion.border_distance > factor && protrusion.border_distance < 2.5 * factor);
    // around the arm, in zigzag
    const double girth = 2 * pi * 0.15 * factor;
    CGAL_CHECK(protrusion.border_length > girth && protrusion.border_length < 2 * girth);
    double area = 0;
    for (std::size_t f = 0; f < found.labels.size(); ++f)
      area += found.labels[f] == protrusion.segment ? face_area(soup, soup.faces[f]) : 0;
    CGAL_CHECK_CLOSE(protrusion.area, area, 1e-9 * area);
    CGAL_CHECK(protrusion.value >= 0.3);
    const std::size_t slot_of_border = protrusion.border_slot.value();
    CGAL_CHECK(slot_of_border < 100);
    CGAL_CHECK_EQUAL(protrusion.distance_histogram.size(), 100);
    CGAL_CHECK(std::accumulate(protrusion.distance_histogram.begin(), protrusion.distance_histogram.end(),
                          std::size_t(0)) > soup.faces.size() / 2);
    // measured to the end, also where no border can lie
    CGAL_CHECK_EQUAL(protrusion.sectional_diameter_histogram.size(), 100);
    for (std::size_t slot = 20; slot < 100; ++slot)
      CGAL_CHECK(protrusion.sectional_diameter_histogram[slot] > 0.1 * factor);
    // half way down the arm the diameter is that of the arm
    CGAL_CHECK_CLOSE(protrusion.sectional_diameter_histogram.at(slot_of_border / 2), 0.3 * factor,
                0.05 * factor);
  }
}

void visitors_are_copied_unless_passed_by_reference()
{
  Mesh_recorder recorder;
  paper_segmentation(star_mesh(), 2, parameters::visitor(recorder));
  CGAL_CHECK(recorder.stages.empty());
  paper_segmentation(star_mesh(), 2, parameters::visitor(std::ref(recorder)));
  CGAL_CHECK(!recorder.stages.empty());
}

// Every question, or a hundred of them if there are more.
template <typename Method>
void a_visitor_stops_the_method_at_every_question(const Method& method)
{
  Mesh_recorder all;
  Segment_ids<Mesh> all_ids(star_mesh());
  CGAL::segmentation_via_protrusion_tips(star_mesh(), all_ids.map(), 5, method,
                                         parameters::visitor(std::ref(all)));
  check_stages_and_progress(all);
  CGAL_CHECK(all.questions > 5);
  const std::size_t step = 1 + all.questions / 100;
  for (std::size_t question = 1; question <= all.questions; question += step)
  {
    Mesh_recorder recorder;
    recorder.stop_at = question;
    std::map<Mesh::Edge_index, bool> is_border;
    const auto np = parameters::visitor(std::ref(recorder))
                      .edge_is_constrained_map(boost::make_assoc_property_map(is_border));
    Segment_ids<Mesh> ids(star_mesh());
    CGAL_CHECK_THROWS_AS(CGAL::segmentation_via_protrusion_tips(star_mesh(), ids.map(), 5, method, np),
                    Segmentation_stopped);
    CGAL_CHECK(is_untouched({0, ids.labels()}));
    CGAL_CHECK(is_border.empty());
    CGAL_CHECK_EQUAL(recorder.questions, question);
    CGAL_CHECK(recorder.open.empty());
  }
}

void a_visitor_stops_the_other_functions()
{
  Mesh_recorder recorder;
  recorder.stop_at = 3;
  CGAL_CHECK_THROWS_AS(CGAL::protrusion_hierarchy(star_mesh(), 5, parameters::visitor(std::ref(recorder))),
                  Segmentation_stopped);
  recorder.questions = 0;
  std::vector<Mesh::Face_index> tips;
  CGAL_CHECK_THROWS_AS(CGAL::protrusion_tips(star_mesh(), 4, std::back_inserter(tips),
                                        parameters::visitor(std::ref(recorder))),
                  Segmentation_stopped);
  CGAL_CHECK(tips.empty());
  CGAL::protrusion_tips(star_mesh(), 4, std::back_inserter(tips));
  recorder.questions = 0;
  Segment_ids<Mesh> ids(star_mesh());
  CGAL_CHECK_THROWS_AS(CGAL::segmentation_from_protrusion_tips(star_mesh(), tips, ids.map(),
                                                          parameters::visitor(std::ref(recorder))),
                  Segmentation_stopped);
  CGAL_CHECK(is_untouched({0, ids.labels()}));
}

template <typename Method>
void a_record_holds_the_last_call(const Method& method)
{
  Segmentation_record<Mesh> record, first;
  Segment_ids<Mesh> ids(star_mesh());
  for (const int k : {5, 3})
    CGAL::segmentation_via_protrusion_tips(star_mesh(), ids.map(), k, method, parameters::visitor(std::ref(record)));
  CGAL::segmentation_via_protrusion_tips(star_mesh(), ids.map(), 3, method, parameters::visitor(std::ref(first)));
  CGAL_CHECK_EQUAL(record.protrusions().size(), 2);
  CGAL_CHECK(record.tips() == first.tips());
  CGAL_CHECK_EQUAL(record.number_of_runs(), first.number_of_runs());
  for (const std::size_t segment : {1, 2})
    CGAL_CHECK(record.value(0, segment) == record.protrusions()[segment - 1].value);
}

// Only those with functions of their own for tips or protrusions pay for descriptions.
struct Progress_visitor : Segmentation_visitor<Mesh>
{
  void on_progress(double) {}
};
struct Tip_visitor : Progress_visitor
{
  void on_tip(face_descriptor) {}
};
struct Visitor_of_any : Segmentation_visitor<Mesh>
{
  template <typename Found>
  void on_protrusion(const Found&)
  {}
};

void protrusions_are_described_only_if_somebody_looks()
{
  CGAL_CHECK(!(internal::Looks_at_protrusions<Segmentation_visitor<Mesh>, Mesh>::value));
  CGAL_CHECK(!(internal::Looks_at_protrusions<Progress_visitor, Mesh>::value));
  CGAL_CHECK((internal::Looks_at_protrusions<Tip_visitor, Mesh>::value));
  CGAL_CHECK((internal::Looks_at_protrusions<Visitor_of_any, Mesh>::value));
  CGAL_CHECK((internal::Looks_at_protrusions<Segmentation_record<Mesh>, Mesh>::value));
}

// Throws in the function of the given number, and then at the end of every stage that is left for it.
class Failing_visitor : public Segmentation_visitor<Mesh>
{
public:
  enum Function
  {
    BEGIN,
    END,
    PROGRESS,
    GO_FURTHER,
    TIP,
    PROTRUSION,
    DISTANCES,
    NUMBER_OF_FUNCTIONS
  };

  explicit Failing_visitor(int failing) : m_failing(failing) {}

  void on_reading_begin() { fail(BEGIN); }
  void on_reading_end() { end(); }
  void on_preparation_end() { end(); }
  void on_tips_end() { end(); }
  void on_borders_end() { end(); }
  void on_labels_end() { end(); }
  void on_progress(double) { fail(PROGRESS); }
  bool go_further()
  {
    fail(GO_FURTHER);
    return true;
  }
  void on_tip(face_descriptor) { fail(TIP); }
  void on_protrusion(const Protrusion<face_descriptor>&) { fail(PROTRUSION); }
  void on_distances(std::size_t) { fail(DISTANCES); }

private:
  void fail(int function)
  {
    if (function == m_failing)
      throw std::runtime_error("the visitor's own");
  }
  void end()
  {
    fail(END);
    if (std::uncaught_exceptions() > 0)
      throw std::runtime_error("a second one");
  }

  int m_failing;
};

template <typename Method>
void exceptions_of_a_visitor_get_through(const Method& method)
{
  for (int function = 0; function < Failing_visitor::NUMBER_OF_FUNCTIONS; ++function)
  {
    Segment_ids<Mesh> ids(star_mesh());
    std::map<Mesh::Edge_index, bool> is_border;
    const auto np = parameters::visitor(Failing_visitor(function))
                      .edge_is_constrained_map(boost::make_assoc_property_map(is_border));
    CGAL_CHECK_THROWS_WITH(CGAL::segmentation_via_protrusion_tips(star_mesh(), ids.map(), 5, method, np),
                      std::runtime_error, "the visitor's own");
    CGAL_CHECK(is_untouched({0, ids.labels()}));
    CGAL_CHECK(is_border.empty());
  }
}

int main()
{
  a_visitor_is_told_what_is_found();
  visitors_are_copied_unless_passed_by_reference();
  a_visitor_stops_the_method_at_every_question(Histogram_method());
  a_visitor_stops_the_method_at_every_question(Minimum_cut_method());
  a_visitor_stops_the_method_at_every_question(Minimum_cut_method(Geodesic_distance()));
  a_visitor_stops_the_other_functions();
  a_record_holds_the_last_call(Histogram_method());
  a_record_holds_the_last_call(Minimum_cut_method());
  protrusions_are_described_only_if_somebody_looks();
  exceptions_of_a_visitor_get_through(Histogram_method());
  exceptions_of_a_visitor_get_through(Minimum_cut_method());
  exceptions_of_a_visitor_get_through(Minimum_cut_method(Geodesic_distance()));
  return check::result();
}
