// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dual graph of a surface and the weights of its seams, which minimum cuts are made of.

#include "check.h"
#include "checks_of_graphs.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Seam_finder.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/make_dual_graph.h>

#include <cmath>
#include <cstdint>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

// Necks of a dumbbell: concave where a ball meets the bar, nowhere else.
void seams_lie_where_parts_meet()
{
  const Test_mesh mesh = star(5);
  const Indexed_surface surface = to_surface(mesh);
  const Indexed_surface reversed = to_surface(with_reversed_orientation(mesh));
  const Seam_graph graph = seam_graph(surface);
  check_symmetry(graph);
  double between = 0, inside = 0;
  std::size_t count_between = 0, count_inside = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (const Index arc : graph.arcs(f))
    {
      const bool same = mesh.parts[f] == mesh.parts[graph.target[arc]];
      (same ? inside : between) += graph.capacity[arc] / graph.border_length[arc];
      ++(same ? count_inside : count_between);
    }
  CGAL_CHECK(count_between > 0);
  CGAL_CHECK(between / double(count_between) < 0.7 * inside / double(count_inside));
  // what is inside is found out from the volume: an inward orientation gives the same weights
  CGAL_CHECK_CLOSE(sum(seam_graph(reversed).capacity), sum(graph.capacity), 1e-3);
}

void weights_do_not_depend_on_scale()
{
  const Seam_graph small = seam_graph(scaled(star(3), 0.5));
  const Seam_graph large = seam_graph(scaled(star(3), 64));
  CGAL_CHECK(small.capacity == large.capacity);
  CGAL_CHECK(small.curvature == large.curvature);
}

// Threads only save time: all weights are the same to the last bit, of a surface so large that it is divided among them.
void the_number_of_threads_does_not_matter()
{
#ifdef CGAL_LINKED_WITH_TBB
  const Indexed_surface surface = to_surface(jittered(icosphere(6), 0.001, 5));
  Execution parallel(0, true);
  const Seam_graph expected = seam_graph(surface), found = seam_graph(surface, parallel);
  CGAL_CHECK(found.first_arc == expected.first_arc && found.target == expected.target);
  CGAL_CHECK(found.length == expected.length && found.border_length == expected.border_length);
  CGAL_CHECK(found.curvature == expected.curvature && found.capacity == expected.capacity);
  CGAL_CHECK(found.area == expected.area);
  for (std::uint32_t arc = 0; arc < expected.target.size(); ++arc)
    CGAL_CHECK_EQUAL(found.length_in_seam(arc), expected.length_in_seam(arc));
  CGAL_CHECK(internal::centres_of_faces(surface, true) == internal::centres_of_faces(surface, false));
#endif
}

int main()
{
  seams_lie_where_parts_meet();
  weights_do_not_depend_on_scale();
  the_number_of_threads_does_not_matter();
  return check::result();
}
