// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segmentations given as lists of labels, for the tests of the metrics.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_LABELED_MESHES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_LABELED_MESHES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/segmentation_metrics.h>

#include <map>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = boost::graph_traits<Mesh>::face_descriptor;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;
using Metrics = CGAL::Protrusion_segmentation::Segmentation_metrics;
using Labels = std::vector<int>; // in the order of the faces

constexpr double exact = 1e-12;

// Segment ids for a mesh type of any kind.
template <typename FaceGraph>
class Face_labels
{
public:
  using key_type = typename boost::graph_traits<FaceGraph>::face_descriptor;

  Face_labels(const FaceGraph& mesh, const Labels& labels)
  {
    std::size_t i = 0;
    for (const key_type f : faces(mesh))
      m_labels[f] = labels.at(i++);
  }

  auto map() const { return boost::make_assoc_property_map(m_labels); }

private:
  std::map<key_type, int> m_labels;
};

template <typename FaceGraph>
Metrics metrics_of(const FaceGraph& mesh, const Labels& segments, const Labels& reference)
{
  return CGAL::Protrusion_segmentation::segmentation_metrics(
    mesh, Face_labels<FaceGraph>(mesh, segments).map(), Face_labels<FaceGraph>(mesh, reference).map());
}

// Squares of side 1 in a row from x = 0 on, numbered from left to right.
inline Mesh strip_of_squares(std::size_t n)
{
  Mesh mesh;
  std::vector<Vertex> lower, upper;
  for (std::size_t i = 0; i <= n; ++i)
  {
    lower.push_back(mesh.add_vertex(Point(double(i), 0, 0)));
    upper.push_back(mesh.add_vertex(Point(double(i), 1, 0)));
  }
  for (std::size_t i = 0; i < n; ++i)
    mesh.add_face(lower[i], lower[i + 1], upper[i + 1], upper[i]);
  return mesh;
}

inline Mesh icosahedron()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(1, 2, 3), 2.5);
  return mesh;
}

// Labels 0..number-1, each face on its own: segments that are not connected.
inline Labels random_labels(std::size_t number_of_faces, int number, unsigned int seed)
{
  std::mt19937 random(seed);
  Labels labels;
  for (std::size_t i = 0; i < number_of_faces; ++i)
    labels.push_back(int(random() % unsigned(number)));
  return labels;
}

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_LABELED_MESHES_H
