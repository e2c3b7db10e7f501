// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "other_triangles.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

void stretch(Mesh& mesh, double factor)
{
  for (const Vertex v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    mesh.point(v) = Point(factor * p.x(), p.y(), p.z());
  }
}

// About `density` times as many faces, which are `anisotropy` times longer along the x axis than across it.
Point centre(Face f, const Mesh& mesh)
{
  Vector sum(0, 0, 0);
  for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
    sum += mesh.point(v) - CGAL::ORIGIN;
  return CGAL::ORIGIN + sum / mesh.degree(f);
}

// The label of the face of `from` that is nearest to each face of `to`.
} // namespace

Mesh remeshed(Mesh mesh, double density, double anisotropy)
{
  stretch(mesh, 1 / anisotropy);
  const double face_area = PMP::area(mesh) / (density * double(mesh.number_of_faces()));
  const double edge_length = std::sqrt(4 / std::sqrt(3.) * face_area); // of an equilateral triangle
  PMP::isotropic_remeshing(faces(mesh), edge_length, mesh,
                           CGAL::parameters::number_of_iterations(3));
  mesh.collect_garbage();
  stretch(mesh, anisotropy);
  return mesh;
}

std::vector<Face> nearest_faces(const Mesh& mesh, const Mesh& other)
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  const Tree tree(faces(other).begin(), faces(other).end(), other);
  std::vector<Face> result;
  for (const Face f : mesh.faces())
    result.push_back(tree.closest_point_and_primitive(centre(f, mesh)).second);
  return result;
}
