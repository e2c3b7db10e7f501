// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape_meshes.h"

#include "zero_set.h" // the mesher of the tests

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <map>

using namespace test_meshes;

namespace {

Test_mesh picked_faces(const Test_mesh& mesh, const std::vector<bool>& is_picked)
{
  Test_mesh result;
  std::map<std::size_t, std::size_t> number;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    if (!is_picked[f])
      continue;
    Face face = mesh.faces[f];
    for (std::size_t& v : face)
    {
      const auto [found, is_new] = number.emplace(v, result.points.size());
      if (is_new)
        result.add_point(mesh.points[v]);
      v = found->second;
    }
    result.add_face(face, mesh.parts[f]);
  }
  return result;
}

// Faces are connected over edges.
Test_mesh largest_component(const Test_mesh& mesh)
{
  using Sets = CGAL::Protrusion_segmentation::internal::Disjoint_sets;
  Sets components(mesh.faces.size());
  std::map<Edge, std::size_t> face_of_edge;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Edge edge = std::minmax(mesh.faces[f][i], mesh.faces[f][(i + 1) % 3]);
      components.union_set(Sets::Index(f), Sets::Index(face_of_edge.emplace(edge, f).first->second));
    }
  std::vector<std::size_t> size(mesh.faces.size(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    ++size[components.find_set(Sets::Index(f))];
  const std::size_t largest = std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<bool> is_picked;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    is_picked.push_back(components.find_set(Sets::Index(f)) == largest);
  return picked_faces(mesh, is_picked);
}

} // namespace

Test_mesh mesh_of(const Shape& shape, double cells)
{
  Box wide, box;
  for (const double s : {-3.4, 3.4})
    wide.add({s, s, s}, 0);
  for (double x = wide.low[0]; x < wide.high[0]; x += .12) // where is it?
    for (double y = wide.low[0]; y < wide.high[0]; y += .12)
      for (double z = wide.low[0]; z < wide.high[0]; z += .12)
        if (shape({x, y, z}) < .15)
          box.add({x, y, z}, .12);
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i)
    size = (std::max)(size, box.high[i] - box.low[i]);
  Test_mesh mesh = zero_set(shape, box, size / cells);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    mesh.parts[f] = shape.part_at(centroid(mesh, mesh.faces[f]));
  return largest_component(mesh);
}

Test_mesh kept_faces(const Test_mesh& mesh, const std::function<bool(const Point&)>& keep)
{
  std::vector<bool> is_picked;
  for (const Face& face : mesh.faces)
    is_picked.push_back(keep(centroid(mesh, face)));
  return largest_component(picked_faces(mesh, is_picked));
}
