// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ablation_methods.h"
#include "other_triangles.h"

#include <CGAL/protrusion_segmentation.h>

namespace {

Segmentation_method on_remeshed(const std::string& name, double density, double anisotropy)
{
  return {name,
          [density, anisotropy](const Mesh& mesh, std::size_t k, unsigned int seed)
          {
            const Mesh other = remeshed(mesh, density, anisotropy);
            Labels labels(other.number_of_faces());
            CGAL::segmentation_via_protrusion_tips(other, CGAL::make_property_map(labels), k,
                                                   CGAL::parameters::random_seed(seed));
            Labels result;
            for (const Face f : nearest_faces(mesh, other))
              result.push_back(labels[f]);
            return result;
          },
          false};
}

} // namespace

std::vector<Segmentation_method> remeshed_methods()
{
  return {on_remeshed("Remeshed-half", 0.5, 1), on_remeshed("Remeshed-double", 2, 1),
          on_remeshed("Remeshed-anisotropic", 1, 3)};
}
