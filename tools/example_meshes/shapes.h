// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shapes of make_example_mesh.cpp and of the page in web/.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_SHAPES_H
#define PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_SHAPES_H

#include "example_meshes/Shape.h"

#include <cmath>
#include <map>
#include <string>

namespace example_shapes
{

inline Shape octopus()
{
  Shape shape{{}, {}, 0.07};
  shape.add({{{0, 0, 0.35}, 0.7}, {{-0.1, 0, 1.0}, 0.72}, {{-0.45, 0, 1.9}, 0.95}}); // head
  shape.add_pair({{{0.5, 0.4, 0.95}, 0.22}, {{0.62, 0.46, 1.0}, 0.18}});             // eyes
  for (int i = 0; i < 8; ++i)
  {
    // No two arms alike: each ends in a curl of its own.
    const double turn = CGAL_PI * (i + 0.5) / 4, curl = 0.55 + 0.12 * std::sin(2.4 * i);
    const double reach = 1 + 0.06 * std::cos(1.7 * i);
    auto at = [&](double r, double side, double z)
    {
      const double angle = turn + side * curl;
      return Point(r * reach * std::cos(angle), r * reach * std::sin(angle), z);
    };
    shape.add({{at(0.3, 0, 0.2), 0.36}, {at(1.0, 0, -0.25), 0.31}, {at(1.8, 0.05, -0.6), 0.25},
               {at(2.6, 0.25, -0.5), 0.2}, {at(3.2, 0.55, -0.15), 0.15},
               {at(3.3, 0.9, 0.35), 0.11}, {at(2.9, 1.1, 0.5), 0.07}});
  }
  return shape;
}

inline Shape teddy()
{
  Shape shape{{}, {}, 0.05};
  shape.add({{{0, 0, -0.1}, 0.95}, {{0, 0, 0.3}, 0.97}, {{0, 0, 0.85}, 0.72}});         // trunk
  shape.add({{{0.02, 0, 2.05}, 0.8}, {{0.1, 0, 2.0}, 0.8}});                            // head
  shape.add({{{0.6, 0, 1.85}, 0.36}, {{0.9, 0, 1.8}, 0.27}});                           // snout
  shape.add_pair({{{0, 0.62, 2.65}, 0.28}, {{-0.02, 0.72, 2.8}, 0.27}});                // ears
  shape.add_pair({{{0.05, 0.6, 0.95}, 0.3}, {{0.35, 1.25, 0.65}, 0.32}, {{0.8, 1.6, 0.5}, 0.34}});
  shape.add_pair({{{0.2, 0.5, -0.55}, 0.4}, {{0.9, 0.75, -0.75}, 0.4}, {{1.5, 0.9, -0.75}, 0.4},
                  {{1.65, 0.92, -0.45}, 0.34}});                                        // legs
  return shape;
}

inline Shape hand()
{
  Shape shape{{}, {}, 0.06};
  shape.add({{{0, 0, -1.5}, 0.5}, {{0, 0, -0.7}, 0.44}, {{0, 0, 0.1}, 0.5}}); // wrist
  const double lengths[] = {1.6, 1.85, 1.65, 1.25};
  for (int i = 0; i < 4; ++i) // each finger with its part of the palm
  {
    const double y = 0.84 - 0.56 * i, z = 1.5 - 0.08 * std::abs(i - 1), length = lengths[i];
    shape.add({{{0, 0.35 * y, 0.1}, 0.42}, {{0, 0.8 * y, 0.9}, 0.34}, {{0, y, z}, 0.25},
               {{0.02, 1.2 * y, z + 0.55 * length}, 0.21}, {{0.2, 1.35 * y, z + length}, 0.16}});
  }
  shape.add({{{0.05, 0.2, 0.1}, 0.4}, {{0.15, 0.75, 0.5}, 0.33}, {{0.25, 1.35, 0.95}, 0.25},
             {{0.3, 1.75, 1.5}, 0.18}}); // thumb
  return shape;
}

inline Shape horse()
{
  Shape shape{{}, {}, 0.05};
  shape.add({{{-1.1, 0, 0}, 0.6}, {{0, 0, -0.05}, 0.56}, {{1.0, 0, 0.02}, 0.6}});          // trunk
  shape.add({{{1.1, 0, 0.2}, 0.42}, {{1.7, 0, 0.95}, 0.3}, {{2.05, 0, 1.55}, 0.25}});      // neck
  shape.add({{{2.0, 0, 1.6}, 0.29}, {{2.5, 0, 1.25}, 0.22}, {{2.8, 0, 1.02}, 0.18}});      // head
  shape.add_pair({{{1.95, 0.14, 1.8}, 0.1}, {{1.95, 0.18, 2.1}, 0.05}});                   // ears
  shape.add_pair({{{1.1, 0.3, -0.1}, 0.3}, {{1.15, 0.34, -0.9}, 0.19}, {{1.12, 0.34, -1.5}, 0.14},
                  {{1.12, 0.34, -2.1}, 0.13}, {{1.2, 0.34, -2.25}, 0.16}});                // front
  shape.add_pair({{{-1.2, 0.3, -0.05}, 0.34}, {{-1.2, 0.34, -0.8}, 0.23},
                  {{-1.45, 0.34, -1.45}, 0.14}, {{-1.35, 0.34, -2.1}, 0.13},
                  {{-1.27, 0.34, -2.25}, 0.16}});                                          // hind
  shape.add({{{-1.6, 0, 0.25}, 0.16}, {{-2.0, 0, 0.15}, 0.15}, {{-2.25, 0, -0.4}, 0.16},
             {{-2.3, 0, -1.1}, 0.07}});                                                    // tail
  return shape;
}

inline Shape chair()
{
  Shape shape{{}, {}, 0.03};
  shape.blocks.push_back({{0, 0, 0}, {1.1, 1.1, 0.14}, 0.12});       // seat
  shape.blocks.push_back({{-1.17, 0, 1.85}, {0.1, 0.95, 0.42}, 0.1}); // back
  shape.add_pair({{{-0.95, 0.9, 0}, 0.13}, {{-1.1, 0.9, 1.1}, 0.12}, {{-1.2, 0.9, 2.3}, 0.12}});
  shape.add_pair({{{-0.95, 0.9, 0}, 0.15}, {{-1.05, 0.95, -1.0}, 0.13}, {{-1.2, 1.0, -2.0}, 0.1}});
  shape.add_pair({{{0.9, 0.9, 0}, 0.15}, {{0.95, 0.95, -1.0}, 0.13}, {{1.05, 1.0, -2.05}, 0.1}});
  return shape;
}

// By their names.
inline const std::map<std::string, Shape (*)()>& shapes()
{
  static const std::map<std::string, Shape (*)()> all = {
    {"octopus", octopus}, {"teddy", teddy}, {"hand", hand}, {"horse", horse}, {"chair", chair}};
  return all;
}

} // namespace example_shapes

#endif // PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_SHAPES_H
