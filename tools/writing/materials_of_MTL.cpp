// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/materials_of_MTL.h"

#include "writing/Json_object.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

namespace tool {
namespace {

struct Look
{
  std::array<double, 3> color = {0.8, 0.8, 0.8};
  double opacity = 1;
  std::string picture; // its file
};

std::string rest_of(std::istringstream& line)
{
  std::string rest;
  std::getline(line >> std::ws, rest);
  while (!rest.empty() && (rest.back() == '\r' || rest.back() == ' '))
    rest.pop_back();
  return rest;
}

void read_MTL(const std::string& file, std::map<std::string, Look>& looks)
{
  std::ifstream in(file);
  Look* look = nullptr;
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "newmtl")
      look = &looks[rest_of(words)];
    else if (look && keyword == "Kd")
      words >> look->color[0] >> look->color[1] >> look->color[2];
    else if (look && keyword == "d")
      words >> look->opacity;
    else if (look && keyword == "map_Kd")
    {
      std::string name = rest_of(words); // behind options, if there are some
      if (!name.empty() && name[0] == '-')
        name = name.substr(name.rfind(' ') + 1);
      std::replace(name.begin(), name.end(), '\\', '/');
      look->picture = (std::filesystem::path(file).parent_path() / name).string();
    }
  }
}

// Colours of MTL are linear, as those of glTF are.
Json material_of(const std::string& name,
                 const Look& look,
                 std::vector<Picture>& pictures,
                 Json& textures)
{
  Json surface = {{"metallicFactor", 0}, {"roughnessFactor", 0.8}};
  surface["baseColorFactor"] = {look.color[0], look.color[1], look.color[2], look.opacity};
  std::ifstream in(look.picture, std::ios::binary);
  if (!look.picture.empty() && in)
  {
    surface["baseColorTexture"] = {{"index", textures.size()}};
    textures.push_back({{"source", pictures.size()}});
    pictures.push_back({std::string(std::istreambuf_iterator<char>(in), {}), "", ""});
  }
  Json material = {{"name", name}, {"doubleSided", true}, {"pbrMetallicRoughness", surface}};
  if (look.opacity < 1)
    material["alphaMode"] = "BLEND";
  return material;
}

} // namespace

std::shared_ptr<const Gltf_materials> materials_of_MTL(const Surface_attributes& attributes)
{
  if (attributes.material_files.empty())
    return nullptr;
  std::map<std::string, Look> looks;
  for (const std::string& file : attributes.material_files)
    read_MTL(file, looks);
  Json materials = Json::array(), textures = Json::array();
  Gltf_materials result;
  for (const std::string& name : attributes.material_names)
    materials.push_back(material_of(name, looks[name], result.pictures, textures));
  result.json = Json({{"materials", materials}, {"textures", textures}})
                  .dump(-1, ' ', false, Json::error_handler_t::replace);
  return std::make_shared<const Gltf_materials>(result);
}

} // namespace tool
