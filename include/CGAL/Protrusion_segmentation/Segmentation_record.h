// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_RECORD_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_RECORD_H

#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

A visitor that keeps what a segmentation found: the tips, and of each protrusion its segment, parent, tip, border,
value, probability and area. It is passed by `std::ref()` and holds what the last call found.

Every protrusion has a border to its parent. Segments and parents are trees, one in each connected component. The value of
the border between two segments is the least value on the path that joins them in the tree, whether they touch or
not; so is its probability.

Values depend on the method, see `Protrusion::value`. For `Minimum_cut_method` they tell how much a cut brought: of
equal arms, the one that was cut off last has the least value. Probabilities are calibrated: on the meshes on which they were
measured, people put about 70 % of the pairs of points on two sides of borders with a probability of .7 into different
segments.

It has all functions of `ProtrusionSegmentationVisitor`. A class that derives from it and defines one of them calls the
function of this class first.

\cgalModels{ProtrusionSegmentationVisitor}

\tparam FaceGraph the type of the mesh
*/
template <typename FaceGraph>
class Segmentation_record : public Segmentation_visitor<FaceGraph>
{
public:
  /// a face of the mesh
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;

  /// \name Findings
  /// @{

  /// \return all protrusions, in the order in which they were found
  const std::vector<Protrusion<face_descriptor>>& protrusions() const { return m_protrusions; }
  /// \return the faces at all tips that were selected, in the order of selection
  const std::vector<face_descriptor>& tips() const { return m_tips; }
  /// \return the number of faces that were farthest from the tips but on the border of an earlier segment
  std::size_t number_of_eliminated_tips() const { return m_number_of_eliminated_tips; }
  /// \return the number of small components, which get no segments of their own
  std::size_t number_of_small_components() const { return m_number_of_small_components; }
  /// \return from how many faces distances were computed
  std::size_t number_of_runs() const { return m_number_of_runs; }
  /// @}

  /// \name Borders
  /// @{

  /// \return the value of the border between two segments; none if they are the same or in different components.
  ///         Linear in the lengths of their paths to the body.
  /// \param s a segment id
  /// \param t a segment id
  std::optional<double> value(std::size_t s, std::size_t t) const { return between(s, t).value; }
  /// \return the probability of the border between two segments, from 0 to 1; none if they are the same or in
  ///         different components, or if the method does not estimate it
  /// \param s a segment id
  /// \param t a segment id
  std::optional<double> probability(std::size_t s, std::size_t t) const
  {
    return between(s, t).probability;
  }

  /// \return the least value of a border of a segment; none if it has no border
  /// \param segment a segment id
  std::optional<double> least_value(std::size_t segment) const { return node(segment).least.value; }
  /// \return the least probability of a border of a segment, from 0 to 1; none if it has no border or if the method
  ///         does not estimate it
  /// \param segment a segment id
  std::optional<double> least_probability(std::size_t segment) const
  {
    return node(segment).least.probability;
  }
  /// @}

#ifndef DOXYGEN_RUNNING
  // forgets the call before
  void on_reading_begin() { *this = Segmentation_record(); }
  void on_tip(face_descriptor face) { m_tips.push_back(face); }
  void on_eliminated_tip(face_descriptor /* face */) { ++m_number_of_eliminated_tips; }
  void on_small_components(std::size_t number_of_small_components) { m_number_of_small_components = number_of_small_components; }
  void on_distances(std::size_t number_of_runs) { m_number_of_runs += number_of_runs; }
  void on_protrusion(const Protrusion<face_descriptor>& protrusion)
  {
    m_protrusions.push_back(protrusion);
    const Sureness border{protrusion.value, protrusion.probability};
    m_nodes.resize((std::max)({m_nodes.size(), protrusion.segment + 1, protrusion.parent + 1}));
    m_nodes[protrusion.segment].parent = protrusion.parent;
    m_nodes[protrusion.segment].border = border;
    m_nodes[protrusion.segment].least.take_least(border);
    m_nodes[protrusion.parent].least.take_least(border);
  }
#endif

private:
  struct Sureness
  {
    std::optional<double> value, probability;

    void take_least(const Sureness& other)
    {
      for (const auto part : {&Sureness::value, &Sureness::probability})
        if (other.*part && (!(this->*part) || *(other.*part) < *(this->*part)))
          this->*part = other.*part;
    }
  };
  struct Node
  {
    std::optional<std::size_t> parent;
    Sureness border; // to the parent
    Sureness least;  // of all borders of the segment
  };

  Node node(std::size_t segment) const { return segment < m_nodes.size() ? m_nodes[segment] : Node(); }

  // A segment and all that it sticks out of, the body last.
  std::vector<std::size_t> path_to_body(std::size_t segment) const
  {
    std::vector<std::size_t> path(1, segment);
    while (const auto parent = node(path.back()).parent)
      path.push_back(*parent);
    return path;
  }

  Sureness between(std::size_t s, std::size_t t) const
  {
    std::vector<std::size_t> from_s = path_to_body(s), from_t = path_to_body(t);
    if (from_s.back() != from_t.back())
      return {};
    while (!from_s.empty() && !from_t.empty() && from_s.back() == from_t.back())
    {
      from_s.pop_back();
      from_t.pop_back();
    }
    Sureness least;
    for (const auto* path : {&from_s, &from_t})
      for (const std::size_t segment : *path)
        least.take_least(m_nodes[segment].border);
    return least;
  }

  std::vector<Protrusion<face_descriptor>> m_protrusions;
  std::vector<face_descriptor> m_tips;
  std::size_t m_number_of_eliminated_tips = 0;
  std::size_t m_number_of_small_components = 0;
  std::size_t m_number_of_runs = 0;
  std::vector<Node> m_nodes; // of the trees, by segment
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_RECORD_H
