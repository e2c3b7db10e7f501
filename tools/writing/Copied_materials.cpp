// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Copied_materials.h"

#include "writing/materials_of_MTL.h"

#include <algorithm>

namespace tool {
namespace {

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// By how the file begins, if nothing else tells; empty if it is none that programs show.
std::string mime_type_of(const Picture& picture)
{
  if (picture.bytes.compare(0, 4, "\x89PNG") == 0)
    return "image/png";
  if (picture.bytes.compare(0, 2, "\xff\xd8") == 0)
    return "image/jpeg";
  if (picture.bytes.compare(0, 4, "RIFF") == 0)
    return "image/webp";
  return picture.mime_type;
}

std::optional<std::size_t> number_in(const Gltf_document::Json& object, const char* key)
{
  if (!object.is_object() || !object.contains(key) || !object[key].is_number_unsigned())
    return std::nullopt;
  return object[key].get<std::size_t>();
}

} // namespace

Copied_materials::Copied_materials(const Surface_attributes& attributes, Gltf_document& document)
  : m_input(attributes.gltf_materials ? attributes.gltf_materials : materials_of_MTL(attributes)),
    m_json(m_input ? Json::parse(m_input->json, nullptr, false) : Json()),
    m_document(document)
{}

std::optional<Gltf_document::Json> Copied_materials::element(const char* list, std::size_t number) const
{
  if (!m_json.is_object() || !m_json.contains(list) || !m_json[list].is_array() ||
      number >= m_json[list].size() || !m_json[list][number].is_object())
    return std::nullopt;
  return m_json[list][number];
}

std::optional<std::size_t> Copied_materials::material(std::size_t number)
{
  const auto [known, is_new] = m_materials.emplace(number, std::nullopt);
  if (!is_new)
    return known->second;
  if (const std::optional<Json> found = element("materials", number))
    known->second = m_document.append("materials", copied(*found));
  return known->second;
}

// With the numbers of the document. A texture that is not found, or lies on a second set of coordinates, is left out.
Gltf_document::Json Copied_materials::copied(const Json& element)
{
  Json result = Json::object();
  for (const auto& [key, value] : element.items())
  {
    if (!value.is_object())
      result[key] = value;
    else if (ends_with(key, "Texture"))
    {
      const std::optional<std::size_t> old = number_in(value, "index");
      const bool is_on_first = number_in(value, "texCoord").value_or(0) == 0;
      if (const auto copy = old && is_on_first ? texture(*old) : std::nullopt)
      {
        result[key] = copied(value);
        result[key]["index"] = *copy;
      }
    }
    else
      result[key] = copied(value);
    if (key == "extensions")
      note_extensions(value);
  }
  return result;
}

void Copied_materials::note_extensions(const Json& extensions)
{
  if (!extensions.is_object())
    return;
  const Json required = m_json.value("extensionsRequired", Json::array());
  for (const auto& [name, value] : extensions.items())
    m_document.use_extension(name, std::find(required.begin(), required.end(), name) != required.end());
}

std::optional<std::size_t> Copied_materials::texture(std::size_t number)
{
  const auto [known, is_new] = m_textures.emplace(number, std::nullopt);
  std::optional<Json> found = is_new ? element("textures", number) : std::nullopt;
  if (!found)
    return known->second;
  bool has_image = false;
  const auto replace_source = [&](Json& object)
  {
    if (const auto source = number_in(object, "source"))
    {
      const auto copy = image(*source);
      has_image = has_image || copy;
      if (copy)
        object["source"] = *copy;
      else
        object.erase("source");
    }
  };
  replace_source(*found);
  if (found->contains("extensions") && (*found)["extensions"].is_object())
  {
    for (auto& extension : (*found)["extensions"])
      replace_source(extension);
    note_extensions((*found)["extensions"]);
  }
  const auto old_sampler = number_in(*found, "sampler");
  found->erase("sampler");
  if (const auto copy = old_sampler ? sampler(*old_sampler) : std::nullopt)
    (*found)["sampler"] = *copy;
  if (has_image)
    known->second = m_document.append("textures", *found);
  return known->second;
}

std::optional<std::size_t> Copied_materials::sampler(std::size_t number)
{
  const auto [known, is_new] = m_samplers.emplace(number, std::nullopt);
  const std::optional<Json> found = is_new ? element("samplers", number) : std::nullopt;
  if (found)
    known->second = m_document.append("samplers", *found);
  return known->second;
}

// In the file itself or, if it was not found, where the input says that it is.
std::optional<std::size_t> Copied_materials::image(std::size_t number)
{
  const auto [known, is_new] = m_images.emplace(number, std::nullopt);
  if (!is_new || number >= m_input->pictures.size())
    return known->second;
  const Picture& picture = m_input->pictures[number];
  if (const std::string type = mime_type_of(picture); !picture.bytes.empty() && !type.empty())
    known->second = m_document.add_picture(picture.bytes, type);
  else if (!picture.uri.empty())
    known->second = m_document.append("images", {{"uri", picture.uri}});
  return known->second;
}

} // namespace tool
