// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What peers share that split segments in two, one after the other, along edges that are cheap to cut.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_HIERARCHICAL_CUTS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_HIERARCHICAL_CUTS_H

#include "Segmentation_method.h"

#include <cstddef>
#include <functional>
#include <vector>

// Two faces that share an edge.
struct Seam
{
  std::size_t a, b;
  double length;
  double cost; // of cutting along it
};

// All edges of the mesh that two faces share. An edge costs its length, and less if it is concave: times the angle
// between its faces outside, as a share of pi, to the power of `exponent` (Golovinskiy and Funkhouser 2008).
std::vector<Seam> all_seams(const Mesh& mesh, double exponent);

// By index of the face.
std::vector<double> face_areas(const Mesh& mesh);

// The faces of a segment, numbered by themselves.
struct Segment_faces
{
  Segment_faces(const std::vector<Seam>& all_seams,
                const std::vector<double>& all_areas,
                const Labels& labels,
                std::size_t label);

  std::vector<std::size_t> faces; // of the mesh
  std::vector<double> areas;
  double area = 0;
  std::vector<Seam> seams; // inside, between numbers in the segment
};

// What a cut costs for the area on both sides of it: the normalized cut.
double normalized_cost(const Segment_faces& segment, const std::vector<bool>& side);

// How to split a segment, and how good that is.
struct Split
{
  std::vector<std::size_t> faces; // of one side; none if the segment cannot be split
  double value = 0;
};

// Begins with the connected components and splits the segment with the largest value until there are as many as asked
// for, or none can be split.
Labels split_best_first(const Mesh& mesh,
                        std::size_t number_of_segments,
                        const std::function<Split(const Labels&, std::size_t label)>& split_of);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_HIERARCHICAL_CUTS_H
