// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>

namespace mesh_types {

using Double_kernel = CGAL::Simple_cartesian<double>;

// The ids of Polyhedron_items_with_id_3 may hold anything: they are not used.
void ids_of_a_polyhedron_may_be_unset()
{
  using Polyhedron = CGAL::Polyhedron_3<Double_kernel, CGAL::Polyhedron_items_with_id_3>;
  Polyhedron mesh = to_graph<Polyhedron>(body());
  gives_the_same_labels(mesh);
  for (auto f : faces(mesh))
    f->id() = 7;
  for (auto v : vertices(mesh))
    v->id() = 7;
  gives_the_same_labels(mesh);
}

void test_polyhedra()
{
  gives_the_same_labels<CGAL::Polyhedron_3<Double_kernel>>();
  gives_the_same_labels<CGAL::Polyhedron_3<CGAL::Exact_predicates_exact_constructions_kernel>>();
  ids_of_a_polyhedron_may_be_unset();
}

} // namespace mesh_types
