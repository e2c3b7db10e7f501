// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// By tinygltf, which knows the file but not what makes sense in it: indices and sizes are checked here. Pictures are kept as they are.

#include "reading/formats.h"

#include "reading/Format_error.h"
#include "reading/Gltf_accessors.h"
#include "reading/Gltf_attributes.h"
#include "reading/gltf_materials.h"

#include <CGAL/Aff_transformation_3.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace tool {
namespace {

using Transformation = CGAL::Aff_transformation_3<CGAL::Simple_cartesian<double>>;

tinygltf::Model parse(const std::string& bytes, const std::string& folder)
{
  if (bytes.size() > (std::numeric_limits<unsigned int>::max)())
    throw Format_error("has more than 4 GB, which glTF cannot have");
  const auto size = static_cast<unsigned int>(bytes.size());
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(keep_picture, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const bool is_binary = bytes.compare(0, 4, "glTF") == 0;
  const bool is_good = is_binary ? loader.LoadBinaryFromMemory(
                                     &model, &error, &warning,
                                     reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
                                 : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(),
                                                              size, folder);
  if (!is_good)
    throw Format_error("is no glTF that tinygltf can read: " + error.substr(0, error.find('\n')));
  return model;
}

// Those that say how the geometry is coded. Others say how it looks, and do not matter.
void check_extensions(const tinygltf::Model& model)
{
  for (const std::string& extension : model.extensionsRequired)
    if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression" ||
        extension == "EXT_mesh_gpu_instancing")
      throw Format_error("needs the extension " + extension + ", which is not read");
}

Transformation matrix_of(const std::vector<double>& m) // by columns
{
  return Transformation(m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]);
}

Transformation rotation_of(const std::vector<double>& q)
{
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  return Transformation(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
                        2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                        2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y));
}

Transformation transform_of(const tinygltf::Node& node)
{
  constexpr std::size_t numbers_of_matrix = 16, numbers_of_rotation = 4, numbers_of_vector = 3;
  if (node.matrix.size() == numbers_of_matrix)
    return matrix_of(node.matrix);
  Transformation result(CGAL::IDENTITY);
  if (node.translation.size() == numbers_of_vector)
    result = Transformation(CGAL::TRANSLATION,
                            Point(node.translation[0], node.translation[1], node.translation[2]) -
                              CGAL::ORIGIN);
  if (node.rotation.size() == numbers_of_rotation)
    result = result * rotation_of(node.rotation);
  if (node.scale.size() == numbers_of_vector)
    result = result * Transformation(node.scale[0], 0, 0, 0, node.scale[1], 0, 0, 0, node.scale[2]);
  return result;
}

// The triangles of all meshes of a scene, moved as its nodes say.
class Scene_triangles
{
public:
  explicit Scene_triangles(const tinygltf::Model& model) : m_model(model), m_accessors(model) {}

  Polygon_soup collect(const std::string& bytes)
  {
    for (const int root : roots())
      add_node(root, Transformation(CGAL::IDENTITY), 0);
    m_soup.attributes = m_attributes.take(m_soup.polygons);
    add_materials(m_model, bytes, std::move(m_materials), m_soup.attributes);
    return std::move(m_soup);
  }

private:
  // Of the scene that is shown, or, without any, all nodes that are no children.
  std::vector<int> roots() const
  {
    if (!m_model.scenes.empty())
      return Gltf_accessors::element(m_model.scenes, (std::max)(m_model.defaultScene, 0), "scene").nodes;
    std::set<int> nodes;
    for (std::size_t i = 0; i < m_model.nodes.size(); ++i)
      nodes.insert(int(i));
    for (const tinygltf::Node& node : m_model.nodes)
      for (const int child : node.children)
        nodes.erase(child);
    return std::vector<int>(nodes.begin(), nodes.end());
  }

  void add_node(int index, const Transformation& outer, std::size_t depth)
  {
    const tinygltf::Node& node = Gltf_accessors::element(m_model.nodes, index, "node");
    if (depth > m_model.nodes.size() || ++m_number_of_nodes > m_model.nodes.size())
      throw Format_error("has a node that is in more than one node, or in itself");
    const Transformation transform = outer * transform_of(node);
    if (node.mesh >= 0)
      for (const tinygltf::Primitive& primitive :
           Gltf_accessors::element(m_model.meshes, node.mesh, "mesh").primitives)
        add_primitive(primitive, node.skin >= 0 ? Transformation(CGAL::IDENTITY)
                                                : transform); // a skin has joints instead
    for (const int child : node.children)
      add_node(child, transform, depth + 1);
  }

  void add_primitive(const tinygltf::Primitive& primitive, const Transformation& transform)
  {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    const auto position = primitive.attributes.find("POSITION");
    if (mode < TINYGLTF_MODE_TRIANGLES || position == primitive.attributes.end())
      return; // points and lines
    const std::size_t first = m_soup.points.size();
    const std::vector<double> coordinates = m_accessors.numbers(position->second, 3);
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
      m_soup.points.push_back(
        transform.transform(Point(coordinates[i], coordinates[i + 1], coordinates[i + 2])));
    m_attributes.add(primitive, coordinates.size() / 3, transform);
    add_triangles(corners_of(primitive, coordinates.size() / 3, first), mode, transform.is_odd());
    const auto number_of_materials = static_cast<int>(m_model.materials.size());
    const bool has_material = primitive.material >= 0 && primitive.material < number_of_materials;
    m_materials.resize(m_soup.polygons.size(), has_material ? std::size_t(primitive.material) : no_index);
  }

  // As indices of points, the first of which is that of the first vertex.
  Polygon corners_of(const tinygltf::Primitive& primitive,
                     std::size_t number_of_vertices,
                     std::size_t first) const
  {
    Polygon corners;
    if (primitive.indices < 0)
      for (std::size_t i = 0; i < number_of_vertices; ++i)
        corners.push_back(first + i);
    else
      for (const double index : m_accessors.numbers(primitive.indices, 1))
      {
        if (!(index >= 0 && index < double(number_of_vertices)))
          throw Format_error("a triangle names vertex " + std::to_string(static_cast<long long>(index)) +
                             " of " + std::to_string(number_of_vertices));
        corners.push_back(first + static_cast<std::size_t>(index));
      }
    return corners;
  }

  void add_triangles(const Polygon& corners, int mode, bool is_mirrored)
  {
    const auto add = [&](const Polygon& t) {
      m_soup.polygons.add(is_mirrored ? Polygon{t[0], t[2], t[1]} : t);
    };
    if (mode == TINYGLTF_MODE_TRIANGLES)
      for (std::size_t i = 2; i < corners.size(); i += 3)
        add({corners[i - 2], corners[i - 1], corners[i]});
    else
      for (std::size_t i = 3; i <= corners.size(); ++i)
        add(mode == TINYGLTF_MODE_TRIANGLE_STRIP ? triangle_of_strip(corners, i)
                                                 : Polygon{corners[0], corners[i - 2], corners[i - 1]});
  }

  const tinygltf::Model& m_model;
  Gltf_accessors m_accessors;
  Gltf_attributes m_attributes{m_accessors};
  Polygon_soup m_soup;
  std::vector<std::size_t> m_materials; // of the triangles
  std::size_t m_number_of_nodes = 0;
};

} // namespace

Polygon_soup read_glTF(const std::string& bytes, const std::string& folder)
{
  const tinygltf::Model model = parse(bytes, folder);
  check_extensions(model);
  return Scene_triangles(model).collect(bytes);
}

} // namespace tool
