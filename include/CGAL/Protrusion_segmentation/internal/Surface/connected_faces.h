// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_FACES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

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

// The connected component of every face, numbered in the order of their first faces, where neighbours are connected for
// which `are_joined(f, g)` holds. `Surface` is `Indexed_surface` or its arrays.
//
// The representative of a set is its lowest face, so that numbers need no further pass. With a million faces a walk over the
// surface takes twice as long, and `Disjoint_sets`, which keep ranks, 1.5 times as long.
template <typename Surface, typename AreJoined>
std::vector<Indexed_surface::Index> components_of_faces(const Surface& surface, AreJoined are_joined)
{
  using Index = Indexed_surface::Index;
  std::vector<Index> component(surface.number_of_faces()); // at first a lower face of it, or the face itself
  std::iota(component.begin(), component.end(), Index(0));
  const auto lowest = [&component](Index face)
  {
    while (component[face] != face)
      face = component[face] = component[component[face]];
    return face;
  };
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
    {
      const Index g = surface.neighbor(c);
      if (g == Indexed_surface::no_face() || g > f || !are_joined(f, g)) // f is a neighbour of g, too
        continue;
      const auto [low, high] = std::minmax({lowest(f), lowest(g)});
      component[high] = low;
    }
  Index number = 0;
  for (Index f = 0; f < component.size(); ++f)
    component[f] = component[f] == f ? number++ : component[component[f]];
  return component;
}

template <typename Surface>
std::vector<Indexed_surface::Index> components_of_faces(const Surface& surface)
{
  return components_of_faces(surface, [](Indexed_surface::Index, Indexed_surface::Index) { return true; });
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
  result.component = components_of_faces(surface, [&labels](Index f, Index g) { return labels[f] == labels[g]; });
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    const Index component = result.component[f];
    if (component == result.label.size())
    {
      result.label.push_back(labels[f]);
      result.area.push_back(0);
    }
    result.area[component] += surface.area(f);
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

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_FACES_H
