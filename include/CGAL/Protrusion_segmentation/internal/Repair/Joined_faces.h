// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_JOINED_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_JOINED_FACES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Edge_pairs.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Vertex_fans.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/choose_faces.h>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The chosen faces and how they are joined.
struct Joined_faces
{
  Joined_faces(const Polygon_soup& soup,
               const std::vector<std::size_t>& places,
               const std::vector<std::size_t>& surfaces,
               const std::vector<bool>& is_left_out)
    : choice(choose_faces(soup.polygons, places, surfaces, is_left_out)),
      pairs(soup.points, choice, places),
      is_turned(pairs.turned_faces()),
      fans(pairs, is_turned)
  {}
  Joined_faces(const Joined_faces&) = delete; // its members refer to each other
  Joined_faces& operator=(const Joined_faces&) = delete;

  Face_choice choice;
  Edge_pairs pairs;
  std::vector<bool> is_turned;
  Vertex_fans fans;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_JOINED_FACES_H
