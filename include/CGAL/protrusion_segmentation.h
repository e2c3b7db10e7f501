// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Landmark_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Minimum_cut_method.h>
#include <CGAL/Protrusion_segmentation/Segment_hierarchy.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Protrusion_segmentation/Segmentation_stopped.h>
#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>
#include <CGAL/Protrusion_segmentation/label_confidence.h>
#include <CGAL/Protrusion_segmentation/protrusion_hierarchy.h>
#include <CGAL/Protrusion_segmentation/segmentation_from_protrusion_tips.h>
#include <CGAL/Protrusion_segmentation/segmentation_via_protrusion_tips.h>

#endif // CGAL_PROTRUSION_SEGMENTATION_H
