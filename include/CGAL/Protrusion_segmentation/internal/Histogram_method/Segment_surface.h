// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_SEGMENT_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_SEGMENT_SURFACE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/Tip_record.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A segment as a surface of its own with the distances on it.
struct Segment_surface
{
  Indexed_surface::Index id;
  std::vector<Indexed_surface::Index> faces; // of the whole surface, ascending
  Indexed_surface own_surface;               // empty if it is all of `whole`, which would be there twice
  const Indexed_surface& surface;
  std::unique_ptr<Distances_on_surface> distances; // refer to the surface
  std::vector<std::vector<double>> from_tips; // of the first records, for a surface that is not large

  Segment_surface(Indexed_surface::Index id_,
                  std::vector<Indexed_surface::Index> faces_,
                  Indexed_surface own_surface_,
                  const Indexed_surface& whole,
                  const Any_distance& distance,
                  Execution& execution)
    : id(id_),
      faces(std::move(faces_)),
      own_surface(std::move(own_surface_)),
      surface(faces.size() == whole.number_of_faces() ? whole : own_surface),
      distances(distance.on(surface, execution))
  {}
  Segment_surface(const Segment_surface&) = delete;
  Segment_surface& operator=(const Segment_surface&) = delete;

  Indexed_surface::Index number_of_face(Indexed_surface::Index face_of_whole_surface) const
  {
    return static_cast<Indexed_surface::Index>(
      std::lower_bound(faces.begin(), faces.end(), face_of_whole_surface) - faces.begin());
  }

  // The distances from the next tip will be wanted a second time. Returns whether there is room for them.
  bool keep(const std::vector<double>& from_tip)
  {
    if ((from_tips.size() + 1) * from_tip.size() > most_kept_distances)
      return false;
    from_tips.push_back(from_tip);
    return true;
  }

  // The distances from a tip by its number, at least up to a bound.
  const std::vector<double>& from(std::size_t number, Indexed_surface::Index tip, double bound)
  {
    if (number < from_tips.size())
      return from_tips[number];
    (*distances)(tip, m_from_tip, bound);
    return m_from_tip;
  }

  // Sees to it that the diameters of the first slots of a tip are known.
  void measure_first_slots(std::size_t number_of_tip,
                           std::size_t number,
                           Execution& execution,
                           Tip_record& record)
  {
    constexpr double no_bound = std::numeric_limits<double>::infinity();
    if (record.number_of_diameters < number)
      measure(from(number_of_tip, record.tip, no_bound), number, execution, record);
  }
  // The same by the distances from the tip.
  void measure(const std::vector<double>& from_tip,
               std::size_t number,
               Execution& execution,
               Tip_record& record)
  {
    if (!m_section)
      m_section.emplace(surface);
    measure_diameters(surface, from_tip, number, *m_section, execution, record);
  }

private:
  static constexpr std::size_t most_kept_distances = std::size_t(1) << 20; // 8 MB

  std::vector<double> m_from_tip;
  std::optional<Plane_section> m_section; // from the first time on that it is wanted
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_SEGMENT_SURFACE_H
