// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connected components of faces, against a walk over the surface.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

// By a walk from every face that was not reached yet.
std::vector<Index> components_by_walks(const Indexed_surface& surface, const std::vector<Index>& labels)
{
  std::vector<Index> result(surface.number_of_faces(), Indexed_surface::no_face());
  Index number = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (result[f] == Indexed_surface::no_face())
    {
      internal::connected_faces(
        surface, f, [&](Index g) { return labels[g] == labels[f] && result[g] == Indexed_surface::no_face(); },
        [&](Index g) { result[g] = number; });
      ++number;
    }
  return result;
}

void check_components(const Test_mesh& mesh, std::uint_fast32_t seed)
{
  const Indexed_surface surface = to_surface(mesh);
  Random random(seed);
  std::vector<Index> labels;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    labels.push_back(static_cast<Index>(random.index(3)));

  const internal::Label_components components = internal::label_components(surface, labels);
  CGAL_CHECK(components.component == components_by_walks(surface, labels));
  std::vector<double> areas(components.label.size(), 0);
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    CGAL_CHECK_EQUAL(components.label[components.component[f]], labels[f]);
    areas[components.component[f]] += surface.area(f);
  }
  for (std::size_t c = 0; c < areas.size(); ++c)
    CGAL_CHECK_CLOSE(components.area[c], areas[c], 1e-12 * surface.area());

  CGAL_CHECK(internal::components_of_faces(surface) ==
        components_by_walks(surface, std::vector<Index>(surface.number_of_faces(), 0)));
}

int main()
{
  for (std::uint_fast32_t seed = 0; seed < 100; ++seed)
  {
    const Test_mesh mesh = random_surface(seed);
    const Test_mesh two = merged({mesh, translated(random_surface(seed + 1000), {100, 0, 0})});
    check_components(mesh, seed);
    check_components(with_face_order(two, random_permutation(two.faces.size(), seed)), seed);
  }
  check_components(single_triangle(), 1);
  CGAL_CHECK(internal::components_of_faces(Indexed_surface()).empty());
  return check::result();
}
