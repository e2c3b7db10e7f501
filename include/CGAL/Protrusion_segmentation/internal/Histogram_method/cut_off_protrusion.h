// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_CUT_OFF_PROTRUSION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_CUT_OFF_PROTRUSION_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Step 4 of Section III.A: gives `label` to the faces connected to `tip` for which `is_near(face)` holds, out
// of the connected set of faces that have the label of `tip`. Where this leaves that set in several pieces,
// the piece of largest area keeps the old label (the one with the lowest face among equals) and the others,
// islands behind the protrusion, go with it; so both labels are connected. Returns the area of `label`.
template <typename IsNear>
double cut_off_protrusion(const Indexed_surface& surface,
                          std::vector<Indexed_surface::Index>& labels,
                          Indexed_surface::Index tip,
                          IsNear is_near,
                          Indexed_surface::Index label)
{
  using Index = Indexed_surface::Index;
  const Index body = labels[tip];
  const std::vector<Index> protrusion = connected_faces(
    surface, tip, [&](Index f) { return labels[f] == body && is_near(f); },
    [&](Index f) { labels[f] = label; });
  double area = 0;
  for (Index f : protrusion)
    area += surface.area(f);

  const Label_components components = label_components(surface, labels);
  Index rest = Indexed_surface::no_face();
  for (Index c = 0; c < components.label.size(); ++c)
    if (components.label[c] == body &&
        (rest == Indexed_surface::no_face() || components.area[c] > components.area[rest]))
      rest = c;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (labels[f] == body && components.component[f] != rest)
    {
      labels[f] = label;
      area += surface.area(f);
    }
  return area;
}

// Whether a face with a label is not near: the border may lie beyond all that earlier protrusions left.
template <typename IsNear>
bool leaves_a_face(const std::vector<Indexed_surface::Index>& labels,
                   Indexed_surface::Index label,
                   IsNear is_near)
{
  for (Indexed_surface::Index f = 0; f < labels.size(); ++f)
    if (labels[f] == label && !is_near(f))
      return true;
  return false;
}

// Of `faces` those with a label, where `labels` are those of `faces`.
inline std::vector<Indexed_surface::Index> faces_with_label(
  const std::vector<Indexed_surface::Index>& labels,
  Indexed_surface::Index label,
  const std::vector<Indexed_surface::Index>& faces)
{
  std::vector<Indexed_surface::Index> result;
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (labels[f] == label)
      result.push_back(faces[f]);
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_CUT_OFF_PROTRUSION_H
