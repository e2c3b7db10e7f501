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

// Labels of polygons that are loose pieces.
class Labels_of_pieces
{
public:
  Labels_of_pieces(std::vector<std::size_t> labels,
                   const std::vector<std::size_t>& pieces,
                   const std::vector<double>& areas)
    : m_labels(std::move(labels)),
      m_pieces(pieces),
      m_areas(areas)
  {
    for (const std::size_t label : m_labels)
      ++m_counts[label];
  }

  // A piece gets one label if that has most of its area, unless another label would vanish.
  void unite_pieces()
  {
    constexpr double most = 0.8;
    std::map<std::size_t, std::vector<std::size_t>> polygons; // of each piece
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      polygons[m_pieces[i]].push_back(i);
    for (const auto& [piece, of_piece] : polygons)
    {
      std::map<std::size_t, std::pair<double, std::size_t>> labels; // area and number of polygons
      double area = 0;
      for (const std::size_t i : of_piece)
      {
        labels[m_labels[i]].first += m_areas[i];
        ++labels[m_labels[i]].second;
        area += m_areas[i];
      }
      const auto largest = std::max_element(labels.begin(), labels.end(),
                                            [](const auto& a, const auto& b)
                                            { return a.second.first < b.second.first; });
      const bool vanishes = std::any_of(labels.begin(), labels.end(),
                                        [&](const auto& label) {
                                          return label.first != largest->first &&
                                                 label.second.second == m_counts[label.first];
                                        });
      if (!vanishes && largest->second.first >= most * area)
        for (const std::size_t i : of_piece)
          set(i, largest->first);
    }
  }

  // Gives a label that no polygon has to the first one near a face with that label, if it is not the last one with its own.
  void complete(const std::vector<std::size_t>& labels_of_faces,
                const std::vector<std::size_t>& polygon_of_face)
  {
    for (std::size_t face = 0; face < labels_of_faces.size(); ++face)
      if (m_counts[labels_of_faces[face]] == 0 && m_counts[m_labels[polygon_of_face[face]]] > 1)
        set(polygon_of_face[face], labels_of_faces[face]);
  }

  const std::vector<std::size_t>& labels() const { return m_labels; }

private:
  void set(std::size_t polygon, std::size_t label)
  {
    --m_counts[m_labels[polygon]];
    m_labels[polygon] = label;
    ++m_counts[label];
  }

  std::vector<std::size_t> m_labels;
  const std::vector<std::size_t>& m_pieces;
  const std::vector<double>& m_areas;
  std::map<std::size_t, std::size_t> m_counts; // of the polygons with a label
};

// From the labels of the faces of the surface around the pieces.
inline std::vector<std::size_t> labels_of_pieces(const std::vector<std::size_t>& labels_of_faces,
                                                 const std::vector<std::size_t>& face_of_polygon,
                                                 const std::vector<std::size_t>& polygon_of_face,
                                                 const std::vector<std::size_t>& pieces,
                                                 const std::vector<double>& areas)
{
  std::vector<std::size_t> labels;
  for (const std::size_t face : face_of_polygon)
    labels.push_back(labels_of_faces[face]);
  Labels_of_pieces result(std::move(labels), pieces, areas);
  result.unite_pieces();
  result.complete(labels_of_faces, polygon_of_face);
  return result.labels();
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LABELS_OF_PIECES_H
