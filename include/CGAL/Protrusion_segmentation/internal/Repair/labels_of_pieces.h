// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LABELS_OF_PIECES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LABELS_OF_PIECES_H

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// From the labels of the faces of the surface around the pieces. A piece gets one label if that has most of its area, unless
// another label would vanish. A label that no polygon has goes to the first one near a face with that label, if it is not
// the last one with its own.
inline std::vector<std::size_t> labels_of_pieces(const std::vector<std::size_t>& labels_of_faces,
                                                 const std::vector<std::size_t>& face_of_polygon,
                                                 const std::vector<std::size_t>& polygon_of_face,
                                                 const std::vector<std::size_t>& pieces,
                                                 const std::vector<double>& areas)
{
  constexpr double most = 0.8;
  std::vector<std::size_t> labels;
  std::map<std::size_t, std::size_t> counts;                // of the polygons with a label
  std::map<std::size_t, std::vector<std::size_t>> polygons; // of each piece
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    labels.push_back(labels_of_faces[face_of_polygon[i]]);
    ++counts[labels[i]];
    polygons[pieces[i]].push_back(i);
  }
  const auto set = [&](std::size_t polygon, std::size_t label)
  {
    --counts[labels[polygon]];
    labels[polygon] = label;
    ++counts[label];
  };
  for (const auto& [piece, of_piece] : polygons)
  {
    std::map<std::size_t, std::pair<double, std::size_t>> shares; // of labels: area and number of polygons
    double area = 0;
    for (const std::size_t i : of_piece)
    {
      shares[labels[i]].first += areas[i];
      ++shares[labels[i]].second;
      area += areas[i];
    }
    const auto largest = std::max_element(shares.begin(), shares.end(),
                                          [](const auto& a, const auto& b)
                                          { return a.second.first < b.second.first; });
    const bool vanishes = std::any_of(shares.begin(), shares.end(),
                                      [&](const auto& share) {
                                        return share.first != largest->first &&
                                               share.second.second == counts[share.first];
                                      });
    if (!vanishes && largest->second.first >= most * area)
      for (const std::size_t i : of_piece)
        set(i, largest->first);
  }
  for (std::size_t face = 0; face < labels_of_faces.size(); ++face)
    if (counts[labels_of_faces[face]] == 0 && counts[labels[polygon_of_face[face]]] > 1)
      set(polygon_of_face[face], labels_of_faces[face]);
  return labels;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LABELS_OF_PIECES_H
