// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ablation_methods.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/protrusion_segmentation.h>

#include <algorithm>
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

Point centre(Face f, const Mesh& mesh)
{
  Vector sum(0, 0, 0);
  for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
    sum += mesh.point(v) - CGAL::ORIGIN;
  return CGAL::ORIGIN + sum / mesh.degree(f);
}

// The label of the face of `from` that is nearest to each face of `to`.
Labels transferred(const Labels& labels, const Mesh& from, const Mesh& to)
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  const Tree tree(faces(from).begin(), faces(from).end(), from);
  Labels result;
  for (const Face f : to.faces())
    result.push_back(labels[tree.closest_point_and_primitive(centre(f, to)).second]);
  return result;
}

Segmentation_method on_remeshed(const std::string& name, double density, double anisotropy)
{
  return {name,
          [density, anisotropy](const Mesh& mesh, std::size_t k, unsigned int seed)
          {
            const Mesh other = remeshed(mesh, density, anisotropy);
            Labels labels(other.number_of_faces());
            CGAL::segmentation_via_protrusion_tips(other, CGAL::make_property_map(labels), k,
                                                   CGAL::parameters::random_seed(seed));
            return transferred(labels, other, mesh);
          },
          false};
}

} // namespace

std::vector<Segmentation_method> remeshed_methods()
{
  return {on_remeshed("Remeshed-half", 0.5, 1), on_remeshed("Remeshed-double", 2, 1),
          on_remeshed("Remeshed-anisotropic", 1, 3)};
}
