// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPAIR_JOINED_FACES_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPAIR_JOINED_FACES_H

#include "reading/Polygon_soup.h"
#include "repair/Edge_pairs.h"
#include "repair/Face_choice.h"
#include "repair/Fans.h"

#include <cstddef>
#include <vector>

namespace tool
{

// The chosen faces and how they are joined.
struct Joined_faces
{
  Joined_faces(const Polygon_soup& soup,
               const std::vector<std::size_t>& places,
               const std::vector<bool>& is_left_out)
    : choice(choose_faces(soup, places, is_left_out)),
      pairs(soup.points, choice, places),
      is_turned(pairs.turned_faces()),
      fans(pairs, is_turned)
  {}

  Face_choice choice;
  Edge_pairs pairs;
  std::vector<bool> is_turned;
  Fans fans;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPAIR_JOINED_FACES_H
