// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_ALL_PUBLIC_HEADERS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_ALL_PUBLIC_HEADERS_H

#include <CGAL/IO/SEG.h>
#include <CGAL/Protrusion_segmentation/Closed_segment.h>
#include <CGAL/Protrusion_segmentation/Connector.h>
#include <CGAL/Protrusion_segmentation/Connector_options.h>
#include <CGAL/Protrusion_segmentation/Consistency_error.h>
#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Hamming_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Joined_pieces.h>
#include <CGAL/Protrusion_segmentation/Landmark_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Minimum_cut_method.h>
#include <CGAL/Protrusion_segmentation/Polygon_soup_correspondence.h>
#include <CGAL/Protrusion_segmentation/Polygon_soup_repairs.h>
#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/Segment_border.h>
#include <CGAL/Protrusion_segmentation/Segment_hierarchy.h>
#include <CGAL/Protrusion_segmentation/Segmentation_metrics.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Protrusion_segmentation/Segmentation_stopped.h>
#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>
#include <CGAL/Protrusion_segmentation/Skeleton_joint.h>
#include <CGAL/Protrusion_segmentation/closed_segments.h>
#include <CGAL/Protrusion_segmentation/closed_segments_with_connectors.h>
#include <CGAL/Protrusion_segmentation/faired_closed_segments.h>
#include <CGAL/Protrusion_segmentation/join_pieces.h>
#include <CGAL/Protrusion_segmentation/label_confidence.h>
#include <CGAL/Protrusion_segmentation/polygon_soup_to_manifold_mesh.h>
#include <CGAL/Protrusion_segmentation/protrusion_hierarchy.h>
#include <CGAL/Protrusion_segmentation/protrusion_skeleton.h>
#include <CGAL/Protrusion_segmentation/segment_borders.h>
#include <CGAL/Protrusion_segmentation/segmentation_from_protrusion_tips.h>
#include <CGAL/Protrusion_segmentation/segmentation_via_protrusion_tips.h>
#include <CGAL/Protrusion_segmentation/smooth_segment_borders.h>
#include <CGAL/protrusion_segmentation.h>
#include <CGAL/segmentation_metrics.h>

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_ALL_PUBLIC_HEADERS_H
