// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of segments, our own: hues in steps of the golden angle, so that any number of segments
// in a row get hues far from each other, at three lightnesses in turn.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_PALETTE_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_PALETTE_H

#include <CGAL/IO/Color.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tool
{

// The linear part of a colour in sRGB, encoded in a byte.
inline unsigned char encode_sRGB(double linear)
{
  const double c = std::clamp(linear, 0., 1.);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255 * encoded));
}

// The linear part of a byte of a colour in sRGB.
inline double decode_sRGB(unsigned char byte)
{
  const double c = byte / 255.;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// The colour space OKLCh (B. Ottosson, 2020): equal steps look equally far apart. `hue` is in
// radians.
inline CGAL::IO::Color color_of_OKLCh(double lightness, double chroma, double hue)
{
  const double a = chroma * std::cos(hue);
  const double b = chroma * std::sin(hue);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return CGAL::IO::Color(encode_sRGB(+4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                         encode_sRGB(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                         encode_sRGB(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
}

// Segment 0, the body of the first component, is a light grey.
inline CGAL::IO::Color segment_color(std::size_t segment)
{
  if (segment == 0)
    return color_of_OKLCh(0.85, 0, 0);
  const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
  const std::array<double, 3> lightness = {0.65, 0.8, 0.52};
  return color_of_OKLCh(lightness[segment % 3], 0.15,
                        0.5 + static_cast<double>(segment) * golden_angle);
}

// The colours of all segments that faces have, by their numbers: to compute one takes longer than to write a face.
inline std::vector<CGAL::IO::Color> segment_colors(const std::vector<std::size_t>& segments_of_faces)
{
  const auto last = std::max_element(segments_of_faces.begin(), segments_of_faces.end());
  std::vector<CGAL::IO::Color> result;
  for (std::size_t segment = 0; last != segments_of_faces.end() && segment <= *last; ++segment)
    result.push_back(segment_color(segment));
  return result;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_PALETTE_H
