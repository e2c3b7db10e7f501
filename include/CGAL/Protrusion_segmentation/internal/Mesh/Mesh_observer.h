// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_MESH_OBSERVER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_MESH_OBSERVER_H

#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Observer.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Whether a visitor has functions of its own for tips or protrusions. A function that it inherits from
// `Segmentation_visitor` has the type of a member of that.
template <typename Visitor, typename FaceGraph, typename = void>
struct Looks_at_protrusions : std::true_type
{};
template <typename Visitor, typename FaceGraph>
struct Looks_at_protrusions<Visitor,
                            FaceGraph,
                            std::void_t<decltype(&Visitor::on_tip), decltype(&Visitor::on_protrusion)>>
  : std::bool_constant<
      !std::is_same_v<decltype(&Visitor::on_tip), decltype(&Segmentation_visitor<FaceGraph>::on_tip)> ||
      !std::is_same_v<decltype(&Visitor::on_protrusion),
                      decltype(&Segmentation_visitor<FaceGraph>::on_protrusion)>>
{};

// Tells a visitor, in faces and units of the mesh, what an observer is told.
template <typename FaceGraph, typename Visitor>
class Mesh_observer : public Observer
{
public:
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;

  Mesh_observer(const FaceGraph& mesh, Visitor& visitor) : m_mesh(mesh), m_visitor(visitor) {}

  // to be called before any face is reported; the surface must outlive the object
  void set_surface(const Canonical_surface& surface) { m_surface = &surface; }

  void small_components_left_out(std::size_t number) { m_visitor.on_small_components(number); }

  bool go_further() override { return m_visitor.go_further(); }
  void progress(double share) override { m_visitor.on_progress(share); }
  void distances_computed(std::size_t number_of_runs) override { m_visitor.on_distances(number_of_runs); }
  void tip_selected(Index face) override { m_visitor.on_tip(descriptor(face)); }
  void tip_eliminated(Index face) override { m_visitor.on_eliminated_tip(descriptor(face)); }

  void stage_begins(Stage stage) override
  {
    switch (stage)
    {
    case Stage::READING:
      return m_visitor.on_reading_begin();
    case Stage::PREPARATION:
      return m_visitor.on_preparation_begin();
    case Stage::TIPS:
      return m_visitor.on_tips_begin();
    case Stage::BORDERS:
      return m_visitor.on_borders_begin();
    case Stage::LABELS:
      return m_visitor.on_labels_begin();
    }
  }
  void stage_ends(Stage stage) override
  {
    switch (stage)
    {
    case Stage::READING:
      return m_visitor.on_reading_end();
    case Stage::PREPARATION:
      return m_visitor.on_preparation_end();
    case Stage::TIPS:
      return m_visitor.on_tips_end();
    case Stage::BORDERS:
      return m_visitor.on_borders_end();
    case Stage::LABELS:
      return m_visitor.on_labels_end();
    }
  }

  bool looks_at_protrusions() const override { return Looks_at_protrusions<Visitor, FaceGraph>::value; }

  void protrusion_found(const Protrusion<Index>& found) override
  {
    if (!looks_at_protrusions())
      return;
    const double unit = m_surface->unit();
    Protrusion<face_descriptor> protrusion;
    protrusion.segment = found.segment;
    protrusion.parent = found.parent;
    protrusion.tip = descriptor(found.tip);
    protrusion.border_distance = found.border_distance * unit;
    protrusion.value = found.value;
    protrusion.probability = found.probability;
    protrusion.area = found.area * unit * unit;
    protrusion.border_length = found.border_length * unit;
    protrusion.border_slot = found.border_slot;
    protrusion.distance_histogram = found.distance_histogram;
    for (double diameter : found.sectional_diameter_histogram)
      protrusion.sectional_diameter_histogram.push_back(diameter * unit);
    m_visitor.on_protrusion(protrusion);
  }

private:
  face_descriptor descriptor(Index face)
  {
    CGAL_assertion(m_surface != nullptr);
    if (m_faces.empty())
      m_faces.assign(faces(m_mesh).begin(), faces(m_mesh).end());
    return m_faces[m_surface->positions()[face]];
  }

  const FaceGraph& m_mesh;
  Visitor& m_visitor;
  const Canonical_surface* m_surface = nullptr;
  std::vector<face_descriptor> m_faces; // in the order of the mesh, when the first is asked for
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_MESH_OBSERVER_H
