// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_FACES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The faces connected to `seed` over faces for which `is_inside(face)` holds, `seed` first. `is_inside` is
// asked about a face until it says yes and has to say no once the face was told to `enter(face)`. `Surface` is
// `Indexed_surface` or its arrays.
template <typename Surface, typename IsInside, typename Enter>
std::vector<Indexed_surface::Index> connected_faces(const Surface& surface,
                                                    Indexed_surface::Index seed,
                                                    IsInside is_inside,
                                                    Enter enter)
{
  using Index = Indexed_surface::Index;
  std::vector<Index> faces(1, seed);
  enter(seed);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Index f = faces[i];
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
    {
      const Index g = surface.neighbor(c);
      if (g != Indexed_surface::no_face() && is_inside(g))
      {
        enter(g);
        faces.push_back(g);
      }
    }
  }
  return faces;
}

// The connected components of the faces with equal labels.
struct Label_components
{
  std::vector<Indexed_surface::Index> component; // of every face
  std::vector<Indexed_surface::Index> label;     // of every component
  std::vector<double> area;                   // of every component
};

inline Label_components label_components(const Indexed_surface& surface,
                                         const std::vector<Indexed_surface::Index>& labels)
{
  using Index = Indexed_surface::Index;
  Label_components result;
  result.component.assign(surface.number_of_faces(), Indexed_surface::no_face());
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    if (result.component[f] != Indexed_surface::no_face())
      continue;
    const Index id = static_cast<Index>(result.label.size());
    const std::vector<Index> faces = connected_faces(
      surface, f, [&](Index g)
      { return labels[g] == labels[f] && result.component[g] == Indexed_surface::no_face(); },
      [&](Index g) { result.component[g] = id; });
    double area = 0;
    for (Index g : faces)
      area += surface.area(g);
    result.label.push_back(labels[f]);
    result.area.push_back(area);
  }
  return result;
}

// The length of the edges between faces with `label` and others.
inline double border_length(const Indexed_surface& surface,
                            const std::vector<Indexed_surface::Index>& labels,
                            Indexed_surface::Index label)
{
  using Index = Indexed_surface::Index;
  double length = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (labels[f] == label)
      for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
        if (surface.neighbor(c) != Indexed_surface::no_face() && labels[surface.neighbor(c)] != label)
          length += surface.edge_length(f, c);
  return length;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_FACES_H
