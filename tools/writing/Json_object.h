// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_OBJECT_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_OBJECT_H

#include <nlohmann/json.hpp>

#include <optional>
#include <utility>

namespace tool
{

using Json = nlohmann::ordered_json;

// Added one by one: the compiler takes many times as long for nested lists in braces.
class Json_object
{
public:
  template <typename T>
  Json_object& add(const char* key, const T& value)
  {
    add_json(key, Json(value));
    return *this;
  }

  template <typename T>
  Json_object& add_if(bool is_known, const char* key, const T& value)
  {
    add_json(key, is_known ? Json(value) : Json(nullptr));
    return *this;
  }

  template <typename T>
  Json_object& add_optional(const char* key, const std::optional<T>& value)
  {
    return value ? add(key, *value) : add(key, nullptr);
  }

  Json_object& add_all(const Json& object)
  {
    m_json.update(object);
    return *this;
  }

  Json take() { return std::move(m_json); }

private:
  void add_json(const char* key, Json value) { m_json.emplace(key, std::move(value)); }

  Json m_json = Json::object();
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_OBJECT_H
