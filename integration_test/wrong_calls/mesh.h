// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_WRONG_CALLS_MESH_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_WRONG_CALLS_MESH_H

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Segment_map = Mesh::Property_map<Mesh::Face_index, std::size_t>;

using namespace CGAL::Protrusion_segmentation;

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_WRONG_CALLS_MESH_H
