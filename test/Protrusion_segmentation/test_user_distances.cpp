// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of a user's: one that wraps another one is as good as that; one that answers nonsense is refused.

#include "optional_distances.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Index = Indexed_surface::Index;

const Mesh& small_mesh()
{
  static const Mesh mesh = to_graph<Mesh>(star(3, 1, 0.3, 0.04, 0.4));
  return mesh;
}

// Has the functions of the other one and calls them, but for the bound, which only saves time.
template <typename Distance>
class Wrapper
{
public:
  explicit Wrapper(const Distance& distance) : m_distance(distance) {}

  class On_surface
  {
  public:
    On_surface(const Distance& distance, const Indexed_surface& surface, Execution& execution)
      : m_distances(distance.on(surface, execution))
    {}
    void operator()(Index source, std::vector<double>& distances) { m_distances(source, distances); }
    Index face_of_largest_sum() { return m_distances.face_of_largest_sum(); }
    std::size_t number_of_runs() const { return m_distances.number_of_runs(); }

  private:
    decltype(std::declval<const Distance&>().on(std::declval<const Indexed_surface&>(),
                                                std::declval<Execution&>())) m_distances;
  };

  On_surface on(const Indexed_surface& surface, Execution& execution) const
  {
    return On_surface(m_distance, surface, execution);
  }

private:
  Distance m_distance;
};

// The labels and how many distance computations they took.
template <typename Method>
std::pair<Segmentation, std::size_t> result_of(const Method& method)
{
  Segmentation_record<Mesh> record;
  const auto np = CGAL::parameters::visitor(std::ref(record));
  const Segmentation found = checked(
    small_mesh(),
    [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(small_mesh(), ids, 4, method, np); });
  return {found, record.number_of_runs()};
}

template <typename Method, typename Distance>
void check_wrapped(const Distance& distance)
{
  const auto [expected, expected_runs] = result_of(Method(distance));
  const auto [found, runs] = result_of(Method(Wrapper<Distance>(distance)));
  CGAL_CHECK_EQUAL(found.number, 4);
  CGAL_CHECK(found.labels == expected.labels);
  CGAL_CHECK_EQUAL(runs, expected_runs);
  CGAL_CHECK(runs > 0);
}

template <typename Distance>
void a_wrapped_distance_is_as_good(const Distance& distance)
{
  check_wrapped<Histogram_method>(distance);
  check_wrapped<Minimum_cut_method>(distance);
  std::vector<Mesh::Face_index> tips, wrapped_tips;
  CGAL::protrusion_tips(small_mesh(), 5, std::back_inserter(tips), distance);
  CGAL::protrusion_tips(small_mesh(), 5, std::back_inserter(wrapped_tips), Wrapper<Distance>(distance));
  CGAL_CHECK(tips == wrapped_tips);
}

// The distance of the faces' numbers, but for one answer.
struct Faulty_distance
{
  double answer = 0;                 // for the last face
  std::size_t superfluous_faces = 0; // or missing ones, by overflow
  Index extreme_face = 0;            // beyond the surface's faces, if not 0
  double to_itself = 0;              // the answer for the source

  struct On_surface
  {
    const Indexed_surface& surface;
    const Faulty_distance& distance;

    void operator()(Index source, std::vector<double>& distances)
    {
      distances.resize(surface.number_of_faces());
      for (Index f = 0; f < surface.number_of_faces(); ++f)
        distances[f] = std::abs(double(f) - double(source));
      distances[source] = distance.to_itself;
      distances.back() += distance.answer;
      distances.resize(distances.size() + distance.superfluous_faces);
    }
    Index face_of_largest_sum() { return distance.extreme_face; }
  };

  On_surface on(const Indexed_surface& surface, Execution&) const { return {surface, *this}; }
};

template <typename Call>
void check_refused_call(Call call, const std::string& message)
{
  Segment_ids<Mesh> ids(small_mesh());
  CGAL_CHECK_THROWS_WITH(call(ids.map()), std::invalid_argument, message);
  CGAL_CHECK(is_untouched({0, ids.labels()}));
}

template <typename Method>
void check_method_refuses(const Faulty_distance& distance, const std::string& message)
{
  const Mesh& mesh = small_mesh();
  const Method method(distance);
  std::map<Mesh::Edge_index, bool> is_border;
  const auto np = CGAL::parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_border));
  check_refused_call(
    [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, 4, method, np); }, message);
  check_refused_call(
    [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, method, np); }, message);
  // from given tips, the paper's method does not ask for the face of eq. (1)
  if (distance.extreme_face == 0 || std::is_same<Method, Minimum_cut_method>::value)
    check_refused_call(
      [&](auto ids)
      {
        return CGAL::segmentation_from_protrusion_tips(
          mesh, std::vector<Mesh::Face_index>{Mesh::Face_index(3)}, ids, method, np);
      },
      message);
  check_refused_call([&](auto) { return CGAL::protrusion_hierarchy(mesh, 4, method); }, message);
  CGAL_CHECK(is_border.empty());
}

void check_refused(const Faulty_distance& distance, const std::string& message)
{
  check_method_refuses<Histogram_method>(distance, message);
  check_method_refuses<Minimum_cut_method>(distance, message);
  std::vector<Mesh::Face_index> tips;
  CGAL_CHECK_THROWS_WITH(CGAL::protrusion_tips(small_mesh(), 4, std::back_inserter(tips), distance),
                    std::invalid_argument, message);
  CGAL_CHECK(tips.empty());
}

void nonsense_is_refused()
{
  const std::string n = std::to_string(small_mesh().number_of_faces());
  const std::string last = " to face " + std::to_string(small_mesh().number_of_faces() - 1) + " is ";
  check_refused({std::nan(""), 0, 0}, last + "nan");
  check_refused({HUGE_VAL, 0, 0}, last + "inf");
  check_refused({-HUGE_VAL, 0, 0}, last + "-inf");
  check_refused({-1e6, 0, 0}, last + "-");
  check_refused({0, 1, 0}, " of a surface with " + n + " faces is given for");
  check_refused({0, std::size_t(0) - 1, 0}, " of a surface with " + n + " faces is given for");
  check_refused({0, 0, static_cast<Index>(small_mesh().number_of_faces())},
                "face_of_largest_sum() of the distance is " + n);
  check_refused({0, 0, 0, 1}, " to itself is 1");
}

int main()
{
  a_wrapped_distance_is_as_good(Geodesic_distance());
  a_wrapped_distance_is_as_good(Landmark_geodesic_distance());
  with_diffusion_distance([](const auto& distance) { a_wrapped_distance_is_as_good(distance); });
  with_heat_distance([](const auto& distance) { a_wrapped_distance_is_as_good(distance); });
  a_wrapped_distance_is_as_good(Exact_geodesic_distance());
  nonsense_is_refused();
  return check::result();
}
