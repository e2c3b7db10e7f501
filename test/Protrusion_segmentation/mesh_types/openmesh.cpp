// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

namespace mesh_types {

void test_openmesh()
{
  gives_the_same_labels<OpenMesh::PolyMesh_ArrayKernelT<>>();
  gives_the_same_labels<OpenMesh::TriMesh_ArrayKernelT<>>();
}

} // namespace mesh_types
