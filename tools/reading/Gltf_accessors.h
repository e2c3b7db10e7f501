// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_ACCESSORS_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_ACCESSORS_H

#include "reading/Format_error.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace tool {

// The numbers of a glTF file. tinygltf does not check that they are there.
class Gltf_accessors
{
public:
  explicit Gltf_accessors(const tinygltf::Model& model) : m_model(model) {}

  // All numbers of an accessor whose elements have so many, one after the other.
  std::vector<double> numbers(int index, int dimension) const
  {
    const tinygltf::Accessor& accessor = element(m_model.accessors, index, "accessor");
    if (accessor.sparse.isSparse)
      throw Format_error("has a sparse accessor, which is not read");
    if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != dimension)
      throw Format_error("its accessor " + std::to_string(index) + " has not " +
                         std::to_string(dimension) + " numbers for each vertex");
    const int size = tinygltf::GetComponentSizeInBytes(
      static_cast<std::uint32_t>(accessor.componentType));
    if (size <= 0)
      throw Format_error("its accessor " + std::to_string(index) + " has numbers of an unknown type");
    return numbers(accessor, std::size_t(dimension), std::size_t(size));
  }

  // The element of a list of the file; throws if there is none.
  template <typename T>
  static const T& element(const std::vector<T>& list, int index, const std::string& kind)
  {
    if (index < 0 || std::size_t(index) >= list.size())
      throw Format_error("names " + kind + " " + std::to_string(index) + " of " +
                         std::to_string(list.size()));
    return list[std::size_t(index)];
  }

private:
  std::vector<double> numbers(const tinygltf::Accessor& accessor,
                              std::size_t dimension,
                              std::size_t size_of_number) const
  {
    const tinygltf::BufferView& view = element(m_model.bufferViews, accessor.bufferView, "buffer view");
    const std::vector<unsigned char>& bytes = element(m_model.buffers, view.buffer, "buffer").data;
    const std::size_t size = dimension * size_of_number,
                      stride = view.byteStride > 0 ? view.byteStride : size;
    const auto has = [](std::size_t all, std::size_t begin, std::size_t length)
    { return begin <= all && length <= all - begin; };
    // The last element needs no more than its own size.
    if (!has(bytes.size(), view.byteOffset, view.byteLength) ||
        (accessor.count > 0 &&
         (!has(view.byteLength, accessor.byteOffset, size) ||
          (accessor.count - 1) > (view.byteLength - accessor.byteOffset - size) / stride)))
      throw Format_error("an accessor announces more than its buffer holds");
    std::vector<double> result;
    result.reserve(accessor.count * dimension);
    const unsigned char* begin = bytes.data() + view.byteOffset + accessor.byteOffset;
    for (std::size_t i = 0; i < accessor.count; ++i)
      for (std::size_t c = 0; c < dimension; ++c)
        result.push_back(number(begin + i * stride + c * size_of_number, accessor));
    return result;
  }

  static double number(const unsigned char* bytes, const tinygltf::Accessor& accessor)
  {
    switch (accessor.componentType)
    {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return integer<std::int8_t>(bytes, accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return integer<std::uint8_t>(bytes, accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return integer<std::int16_t>(bytes, accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return integer<std::uint16_t>(bytes, accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_INT:
      return integer<std::int32_t>(bytes, accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return integer<std::uint32_t>(bytes, accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return value<float>(bytes);
    default:
      return value<double>(bytes);
    }
  }

  template <typename T>
  static T value(const unsigned char* bytes)
  {
    T result;
    std::memcpy(&result, bytes, sizeof(result));
    return result;
  }

  // Normalized ones are shares of the largest (glTF 2.0, section 3.11).
  template <typename T>
  static double integer(const unsigned char* bytes, bool is_normalized)
  {
    const double number = value<T>(bytes);
    return is_normalized ? (std::max)(number / double((std::numeric_limits<T>::max)()), -1.) : number;
  }

  const tinygltf::Model& m_model;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_ACCESSORS_H
