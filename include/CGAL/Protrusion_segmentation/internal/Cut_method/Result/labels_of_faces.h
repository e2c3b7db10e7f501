// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_LABELS_OF_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_LABELS_OF_FACES_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Gives each face one of the labels of its pieces, the one with the largest share of its area where segments stay connected so. Every
// label keeps a face.
class Face_labeler
{
public:
  using Index = Dual_graph::Index;

  // `faces`: a connected graph with no fewer faces than there are labels; the pieces are in the order of the faces
  Face_labeler(const Dual_graph& faces,
               const std::vector<Index>& face_of_piece,
               const std::vector<double>& area_of_piece,
               const std::vector<Index>& label_of_piece)
    : m_faces(faces), m_labels(faces.number_of_nodes(), no_label), m_shares(faces.number_of_nodes())
  {
    for (std::size_t p = 0; p < face_of_piece.size(); ++p)
      add(m_shares[face_of_piece[p]], label_of_piece[p], area_of_piece[p]);
  }

  std::vector<Index> operator()(std::size_t number_of_labels)
  {
    CGAL_assertion(number_of_labels <= m_labels.size());
    choose_first_faces(number_of_labels);
    grow();
    return std::move(m_labels);
  }

private:
  struct Share
  {
    Index label;
    double area;
  };
  // how much of a face has a label, its area with that label, minus the face, the label
  using Offer = std::tuple<double, double, double, Index>;

  static void add(std::vector<Share>& shares, Index label, double area)
  {
    const auto found = std::find_if(shares.begin(), shares.end(), [&](const Share& s) { return s.label == label; });
    if (found == shares.end())
      shares.push_back({label, area});
    else
      found->area += area;
  }

  Offer offer(Index face, Index label) const
  {
    double all = 0, own = 0;
    for (const Share& share : m_shares[face])
    {
      all += share.area;
      own += share.label == label ? share.area : 0;
    }
    return {all > 0 ? own / all : 0, own, -static_cast<double>(face), label};
  }

  static Index face_of(const Offer& offer) { return static_cast<Index>(-std::get<2>(offer)); }

  // One for each label, where its share is largest; of two labels with the same face only the first one gets it.
  void choose_first_faces(std::size_t number_of_labels)
  {
    std::vector<Offer> offers;
    for (Index f = 0; f < m_shares.size(); ++f)
      for (const Share& share : m_shares[f])
        offers.push_back(offer(f, share.label));
    std::sort(offers.begin(), offers.end(), std::greater<>());
    std::vector<bool> has_face(number_of_labels, false);
    for (const Offer& offer : offers)
      take_first(face_of(offer), std::get<3>(offer), has_face);
    for (const Offer& offer : offers) // labels all of whose faces are taken get one nearby
      if (!has_face[std::get<3>(offer)])
        take_first(nearest_free_face(face_of(offer)), std::get<3>(offer), has_face);
  }

  void take_first(Index face, Index label, std::vector<bool>& has_face)
  {
    if (has_face[label] || m_labels[face] != no_label)
      return;
    m_labels[face] = label;
    has_face[label] = true;
  }

  // By the number of edges between.
  Index nearest_free_face(Index face) const
  {
    std::vector<bool> is_reached(m_labels.size(), false);
    std::vector<Index> faces(1, face);
    is_reached[face] = true;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (m_labels[faces[i]] == no_label)
        return faces[i];
      for (Index arc : m_faces.arcs(faces[i]))
        if (!is_reached[m_faces.target[arc]])
        {
          is_reached[m_faces.target[arc]] = true;
          faces.push_back(m_faces.target[arc]);
        }
    }
    return face;
  }

  // The segments grow from their first faces, over the faces of which they have the largest share first.
  void grow()
  {
    std::priority_queue<Offer> offers;
    const auto offer_neighbors = [&](Index f)
    {
      for (Index arc : m_faces.arcs(f))
        if (m_labels[m_faces.target[arc]] == no_label)
          offers.push(offer(m_faces.target[arc], m_labels[f]));
    };
    const std::vector<Index> first = m_labels;
    for (Index f = 0; f < first.size(); ++f)
      if (first[f] != no_label)
        offer_neighbors(f);
    while (!offers.empty())
    {
      const Index f = face_of(offers.top()), label = std::get<3>(offers.top());
      offers.pop();
      if (m_labels[f] != no_label)
        continue;
      m_labels[f] = label;
      offer_neighbors(f);
    }
  }

  static constexpr Index no_label = Indexed_surface::no_face();

  const Dual_graph& m_faces;
  std::vector<Index> m_labels;               // of every face
  std::vector<std::vector<Share>> m_shares; // of every face
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_LABELS_OF_FACES_H
