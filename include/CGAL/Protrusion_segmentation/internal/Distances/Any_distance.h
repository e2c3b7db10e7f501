// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_ANY_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_ANY_DISTANCE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Any model of ProtrusionDistancesOnSurface: the methods are compiled once and not for every distance.
class Distances_on_surface
{
public:
  using Index = Indexed_surface::Index;
  static constexpr double unbounded() { return (std::numeric_limits<double>::infinity)(); }

  virtual ~Distances_on_surface() = default;
  // The distances from `source`; those above `bound` may be larger than they are.
  virtual void operator()(Index source, std::vector<double>& distances, double bound = unbounded()) = 0;
  // Eq. (1): by the distance's own way if it has one, else from all pairs.
  virtual Index face_of_largest_sum() = 0;
  virtual std::size_t number_of_runs() const = 0;
};

template <typename Distances, typename = void>
struct Has_bounded_distances : std::false_type {};
template <typename Distances>
struct Has_bounded_distances<Distances,
                             std::void_t<decltype(std::declval<Distances&>()(
                               Indexed_surface::Index(), std::declval<std::vector<double>&>(), 0.))>>
  : std::true_type {};

template <typename Distances, typename = void>
struct Has_face_of_largest_sum : std::false_type {};
template <typename Distances>
struct Has_face_of_largest_sum<
  Distances, std::void_t<decltype(std::declval<Distances&>().face_of_largest_sum())>> : std::true_type {};

template <typename Distances, typename = void>
struct Has_number_of_runs : std::false_type {};
template <typename Distances>
struct Has_number_of_runs<
  Distances, std::void_t<decltype(std::declval<const Distances&>().number_of_runs())>> : std::true_type {};

// Whether a type has what ProtrusionDistance requires.
template <typename Distance, typename = void>
struct Is_distance : std::false_type {};
template <typename Distance>
struct Is_distance<Distance,
                   std::void_t<decltype(std::declval<const Distance&>().on(
                     std::declval<const Indexed_surface&>(), std::declval<Execution&>())(
                     Indexed_surface::Index(), std::declval<std::vector<double>&>()))>> : std::true_type {};

// What a distance may answer: anything else would become garbage or a crash far from its cause.
inline void check_distances(const std::vector<double>& distances,
                            Indexed_surface::Index source,
                            Indexed_surface::Index number_of_faces,
                            double bound)
{
  const auto fail = [source](const std::string& what)
  { throw std::invalid_argument("the distance from face " + std::to_string(source) + what); };
  if (distances.size() != number_of_faces)
    fail(" of a surface with " + std::to_string(number_of_faces) + " faces is given for " +
         std::to_string(distances.size()) + " faces");
  const bool may_be_infinite = std::isfinite(bound);
  for (std::size_t f = 0; f < distances.size(); ++f)
    if (!(distances[f] >= 0) || (std::isinf(distances[f]) && !may_be_infinite))
      fail(" to face " + std::to_string(f) + " is " + std::to_string(distances[f]));
  if (distances[source] != 0)
    fail(" to itself is " + std::to_string(distances[source]));
}

template <typename Distance>
class Model_of_distances : public Distances_on_surface
{
public:
  Model_of_distances(const Distance& distance, const Indexed_surface& surface, Execution& execution)
    : m_surface(surface), m_execution(execution), m_distances(distance.on(surface, execution))
  {}

  void operator()(Index source, std::vector<double>& distances, double bound = unbounded()) override
  {
    ++m_number_of_calls;
    m_execution.check();
    if constexpr (Has_bounded_distances<On_surface>::value)
      m_distances(source, distances, bound);
    else
      m_distances(source, distances);
    check_distances(distances, source, m_surface.number_of_faces(), bound);
  }

  Index face_of_largest_sum() override
  {
    if constexpr (Has_face_of_largest_sum<On_surface>::value)
    {
      const Index face = m_distances.face_of_largest_sum();
      if (face >= m_surface.number_of_faces())
        throw std::invalid_argument("face_of_largest_sum() of the distance is " + std::to_string(face) +
                                    " on a surface with " +
                                    std::to_string(m_surface.number_of_faces()) + " faces");
      return face;
    }
    else
      return largest_distance_sum_of_all_pairs(m_surface, *this, m_execution);
  }

  std::size_t number_of_runs() const override
  {
    if constexpr (Has_number_of_runs<On_surface>::value)
      return m_distances.number_of_runs();
    else
      return m_number_of_calls;
  }

private:
  using On_surface =
    decltype(std::declval<const Distance&>().on(std::declval<const Indexed_surface&>(), std::declval<Execution&>()));

  const Indexed_surface& m_surface;
  Execution& m_execution;
  On_surface m_distances;
  std::size_t m_number_of_calls = 0;
};

// Any model of ProtrusionDistance. Copies share it: its options are not changed any more.
class Any_distance
{
public:
  template <typename Distance>
  explicit Any_distance(Distance distance)
  {
    static_assert(Is_distance<Distance>::value, "the distance is no model of ProtrusionDistance: it has no "
                                                "function on(const Indexed_surface&, Execution&) const whose "
                                                "result computes distances");
    if constexpr (Is_distance<Distance>::value) // no further errors after this one
      m_on = [shared = std::make_shared<const Distance>(std::move(distance))](const Indexed_surface& surface,
                                                                              Execution& execution)
      { return std::make_unique<Model_of_distances<Distance>>(*shared, surface, execution); };
  }

  // The surface and the execution must outlive the result.
  std::unique_ptr<Distances_on_surface> on(const Indexed_surface& surface, Execution& execution) const
  {
    return m_on(surface, execution);
  }

private:
  std::function<std::unique_ptr<Distances_on_surface>(const Indexed_surface&, Execution&)> m_on;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_ANY_DISTANCE_H
