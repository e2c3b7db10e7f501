// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether to go on is asked before every distance computation, whatever the method and the distance; progress
// moves all the time; and where the answer is no, nothing is written.

#include "optional_distances.h"
#include "recorder.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
namespace parameters = CGAL::parameters;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Index = Indexed_surface::Index;

constexpr std::size_t number_of_segments = 5;
constexpr std::size_t least_number_of_shares = 10; // that a bar of progress shows

// Shared by a distance and a visitor.
struct Counters
{
  std::vector<std::function<std::size_t()>> runs_on_surfaces;
  std::size_t runs_in_preparation = 0; // of these
  std::size_t questions = 0;

  std::size_t runs() const
  {
    std::size_t sum = 0;
    for (const auto& runs_on_surface : runs_on_surfaces)
      sum += runs_on_surface();
    return sum;
  }
};

// Another distance whose computations can be counted while it is at work.
template <typename Distance>
class Counted_distance
{
public:
  Counted_distance(const Distance& distance, Counters& counters)
    : m_distance(distance),
      m_counters(&counters)
  {}

  class On_surface
  {
  public:
    On_surface(const Distance& distance,
               const Indexed_surface& surface,
               Execution& execution,
               Counters& counters)
    {
      const std::size_t questions = counters.questions;
      m_distances = std::make_shared<Distances>(distance.on(surface, execution));
      const std::size_t runs = m_distances->number_of_runs();
      CGAL_CHECK(counters.questions - questions >= runs);
      counters.runs_in_preparation += runs;
      counters.runs_on_surfaces.push_back([distances = m_distances]()
                                          { return distances->number_of_runs(); });
    }
    void operator()(Index source, std::vector<double>& distances) { (*m_distances)(source, distances); }
    Index face_of_largest_sum() { return m_distances->face_of_largest_sum(); }
    std::size_t number_of_runs() const { return m_distances->number_of_runs(); }

  private:
    using Distances = decltype(std::declval<const Distance&>().on(std::declval<const Indexed_surface&>(),
                                                                  std::declval<Execution&>()));
    std::shared_ptr<Distances> m_distances;
  };

  On_surface on(const Indexed_surface& surface, Execution& execution) const
  {
    return On_surface(m_distance, surface, execution, *m_counters);
  }

private:
  Distance m_distance;
  Counters* m_counters;
};

class Counting_visitor : public Recorder<Mesh>
{
public:
  explicit Counting_visitor(Counters& counters) : m_counters(counters) {}

  bool go_further()
  {
    const std::size_t runs = m_counters.runs() - m_counters.runs_in_preparation;
    m_largest = (std::max)(m_largest, runs - m_runs_before);
    m_runs_before = runs;
    ++m_counters.questions;
    return Recorder<Mesh>::go_further();
  }
  std::size_t largest_number_of_runs_between_questions() const { return m_largest; }

private:
  Counters& m_counters;
  std::size_t m_runs_before = 0;
  std::size_t m_largest = 0;
};

std::size_t number_of_different(const std::vector<double>& shares)
{
  return std::set<double>(shares.begin(), shares.end()).size();
}

template <typename Method, typename Visitor>
std::size_t segment(const Mesh& mesh, const Method& method, Visitor& recorder)
{
  return checked(mesh,
                 [&](auto ids)
                 {
                   return CGAL::segmentation_via_protrusion_tips(mesh, ids, number_of_segments, method,
                                                                 parameters::visitor(std::ref(recorder)));
                 })
    .number;
}

template <typename Method, typename Distance>
void check_questions(const std::string& name, const Mesh& mesh, const Distance& distance)
{
  Counters counters;
  Counting_visitor visitor(counters);
  CGAL_CHECK_EQUAL(segment(mesh, Method(Counted_distance<Distance>(distance, counters)), visitor),
              number_of_segments);
  check_stages_and_progress(visitor);
  std::cout << name << ", " << mesh.number_of_faces() << " faces: " << counters.questions
            << " questions, " << counters.runs() << " distance computations, "
            << number_of_different(visitor.shares) << " values of progress\n";
  CGAL_CHECK(counters.runs() > 10);
  CGAL_CHECK_EQUAL(counters.runs(), visitor.number_of_runs());
  CGAL_CHECK_EQUAL(visitor.largest_number_of_runs_between_questions(), 1);
  CGAL_CHECK(number_of_different(visitor.shares) > least_number_of_shares);
}

// Some questions, the first and the last among them: nothing is written, whatever is under way.
template <typename Method>
void check_stops(const Mesh& mesh, const Method& method)
{
  Recorder<Mesh> all;
  CGAL_CHECK_EQUAL(segment(mesh, method, all), number_of_segments);
  constexpr std::size_t number_of_stops = 12;
  for (std::size_t i = 0; i <= number_of_stops; ++i)
  {
    Recorder<Mesh> recorder;
    recorder.stop_at = 1 + i * (all.questions - 1) / number_of_stops;
    CGAL_CHECK_THROWS_AS(segment(mesh, method, recorder), Segmentation_stopped);
    CGAL_CHECK_EQUAL(recorder.questions, recorder.stop_at);
    CGAL_CHECK(recorder.open.empty());
  }
}

template <typename Distance>
void check_distance(const std::string& name, const Mesh& mesh, const Distance& distance)
{
  check_questions<Histogram_method>(name, mesh, distance);
  check_questions<Minimum_cut_method>(name + ", minimum cut", mesh, distance);
  check_stops(mesh, Histogram_method(distance));
  check_stops(mesh, Minimum_cut_method(distance));
}

// The default method's own measure: shortest paths on the coarse graph.
class Visitor_of_tips : public Recorder<Mesh>
{
public:
  bool go_further()
  {
    questions_while_tips_are_selected += !open.empty() && open.back() == "tips";
    return Recorder<Mesh>::go_further();
  }
  std::size_t questions_while_tips_are_selected = 0;
};

void check_default_method(const Mesh& mesh)
{
  Visitor_of_tips visitor;
  CGAL_CHECK_EQUAL(segment(mesh, Minimum_cut_method(), visitor), number_of_segments);
  check_stages_and_progress(visitor);
  std::cout << "default method, " << mesh.number_of_faces() << " faces: " << visitor.questions
            << " questions, " << visitor.questions_while_tips_are_selected << " of them for "
            << visitor.number_of_runs() << " shortest path computations, " << number_of_different(visitor.shares)
            << " values of progress\n";
  CGAL_CHECK(visitor.questions_while_tips_are_selected >= visitor.number_of_runs());
  CGAL_CHECK(number_of_different(visitor.shares) > least_number_of_shares);
  check_stops(mesh, Minimum_cut_method());
}

// From given tips the stages are the same.
template <typename Method>
void check_given_tips(const Mesh& mesh, const Method& method)
{
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, 4, std::back_inserter(tips));
  Recorder<Mesh> recorder;
  const auto np = parameters::visitor(std::ref(recorder));
  checked(mesh,
          [&](auto ids) { return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, method, np); });
  check_stages_and_progress(recorder);
  CGAL_CHECK(recorder.questions > tips.size());
}

// With a number of segments, each of them moves progress on.
void check_progress_to_a_large_number(const Mesh& mesh)
{
  Recorder<Mesh> recorder;
  checked(mesh, [&](auto ids)
          { return CGAL::segmentation_via_protrusion_tips(mesh, ids, 10, parameters::visitor(std::ref(recorder))); });
  std::set<double> late;
  for (double share : recorder.shares)
    if (0.6 < share && share < 0.95)
      late.insert(share);
  CGAL_CHECK(late.size() > 5);
}

// A visitor is told of tips that nothing is cut off at, too.
void check_tips_alone(const Mesh& mesh)
{
  Recorder<Mesh> recorder;
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, 4, std::back_inserter(tips), parameters::visitor(std::ref(recorder)));
  CGAL_CHECK_EQUAL(tips.size(), 4);
  CGAL_CHECK(recorder.tips() == tips);
  CGAL_CHECK_EQUAL(recorder.stages["tips"], 1);
}

struct Throwing_observer : internal::Observer
{
  bool go_further() override { throw std::domain_error("asked"); }
  void progress(double) override { throw std::domain_error("told"); }
};

// What a visitor throws stops other threads, too.
template <typename Call>
void check_that_other_threads_stop(Call call)
{
  Throwing_observer observer;
  Execution execution(observer, 0, true);
  const auto stops = [&]()
  {
    bool is_stopped = false;
    std::thread([&]()
                {
                  try
                  {
                    execution.check();
                  }
                  catch (const Segmentation_stopped&)
                  {
                    is_stopped = true;
                  }
                })
      .join();
    return is_stopped;
  };
  CGAL_CHECK(!stops());
  CGAL_CHECK_THROWS_AS(call(execution), std::domain_error);
  CGAL_CHECK(stops());
}

int main()
{
  check_that_other_threads_stop([](Execution& execution) { execution.check(); });
  check_that_other_threads_stop([](Execution& execution) { execution.progress(0.5); });
  const Mesh mesh = to_graph<Mesh>(star(4));
  check_progress_to_a_large_number(mesh);
  check_tips_alone(mesh);
  CGAL_CHECK(mesh.number_of_faces() > 3000);
  check_default_method(mesh);
  check_given_tips(mesh, Histogram_method());
  check_given_tips(mesh, Minimum_cut_method());
  check_given_tips(mesh, Minimum_cut_method(Geodesic_distance()));
  // on fewer faces there are too few runs to stop one
  check_distance("geodesic", to_graph<Mesh>(star(4, 2, 0.25, 0.04, 0.1)), Geodesic_distance());
  check_distance("landmarks", mesh, Landmark_geodesic_distance(0.02));
  with_diffusion_distance([&](const auto& distance) { check_distance("diffusion", mesh, distance); });
  with_heat_distance([&](const auto& distance) { check_distance("heat", mesh, distance); });
  // some seconds for a larger one
  check_distance("exact", to_graph<Mesh>(star(4, 2, 0.25, 0.04, 0.5)), Exact_geodesic_distance());
  return check::result();
}
