// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// By lib3mf 1.x. CGAL's reader is for files only, tells its errors on the standard error, and looks into components twice
// or, where they are nested, not at all.

#include "reading/formats.h"

#include "reading/Format_error.h"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <array>
#include <memory>
#include <vector>

namespace tool
{
namespace
{

using Raw_handle = NMR::PLib3MFBase*;

struct Release
{
  void operator()(Raw_handle handle) const { NMR::lib3mf_release(handle); }
};
using Handle = std::unique_ptr<NMR::PLib3MFBase, Release>;

void require(HRESULT result)
{
  if (result != LIB3MF_OK)
    throw Format_error("is no 3MF that lib3mf can read");
}

// What `get(Raw_handle*)` gives away.
template <typename Get>
Handle take(const Get& get)
{
  Raw_handle handle = nullptr;
  require(get(&handle));
  return Handle(handle);
}

using Transform = NMR::MODELTRANSFORM; // three rows of four numbers, the last of which is the translation

Transform identity()
{
  Transform result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      result.m_fFields[row][column] = row == column ? 1.f : 0.f;
  return result;
}

Point transformed(const Transform& transform, const std::array<double, 3>& point)
{
  std::array<double, 3> result;
  for (std::size_t row = 0; row < 3; ++row)
  {
    result[row] = transform.m_fFields[row][3];
    for (std::size_t column = 0; column < 3; ++column)
      result[row] += transform.m_fFields[row][column] * point[column];
  }
  return Point(result[0], result[1], result[2]);
}

// The transform by `inner`, then by `outer`.
Transform product(const Transform& outer, const Transform& inner)
{
  Transform result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
    {
      double sum = column == 3 ? outer.m_fFields[row][3] : 0;
      for (int i = 0; i < 3; ++i)
        sum += double(outer.m_fFields[row][i]) * inner.m_fFields[i][column];
      result.m_fFields[row][column] = static_cast<float>(sum);
    }
  return result;
}

class Collector
{
public:
  // An object is a mesh, or is made of others that are moved.
  void add_object(Raw_handle object, const Transform& transform, int depth = 0)
  {
    constexpr int deepest = 100; // a file may say that an object is made of itself
    if (depth > deepest)
      throw Format_error("has components within components without end");
    BOOL is_mesh = false, is_composed = false;
    require(NMR::lib3mf_object_ismeshobject(object, &is_mesh));
    require(NMR::lib3mf_object_iscomponentsobject(object, &is_composed));
    if (is_mesh)
      add_mesh(object, transform);
    else if (is_composed)
      add_components(object, transform, depth);
  }

  const Polygon_soup& soup() const { return m_soup; }

private:
  void add_mesh(Raw_handle mesh, const Transform& transform)
  {
    DWORD vertices = 0, triangles = 0;
    require(NMR::lib3mf_meshobject_getvertexcount(mesh, &vertices));
    require(NMR::lib3mf_meshobject_gettrianglecount(mesh, &triangles));
    const std::size_t first = m_soup.points.size();
    for (DWORD i = 0; i < vertices; ++i)
    {
      NMR::MODELMESHVERTEX vertex;
      require(NMR::lib3mf_meshobject_getvertex(mesh, i, &vertex));
      m_soup.points.push_back(
        transformed(transform, {vertex.m_fPosition[0], vertex.m_fPosition[1], vertex.m_fPosition[2]}));
    }
    for (DWORD i = 0; i < triangles; ++i)
    {
      NMR::MODELMESHTRIANGLE triangle;
      require(NMR::lib3mf_meshobject_gettriangle(mesh, i, &triangle));
      m_soup.polygons.add(
        {first + triangle.m_nIndices[0], first + triangle.m_nIndices[1], first + triangle.m_nIndices[2]});
    }
  }

  void add_components(Raw_handle object, const Transform& transform, int depth)
  {
    DWORD count = 0;
    require(NMR::lib3mf_componentsobject_getcomponentcount(object, &count));
    for (DWORD i = 0; i < count; ++i)
    {
      const Handle component = take([&](Raw_handle* handle)
                                    { return NMR::lib3mf_componentsobject_getcomponent(object, i, handle); });
      const Handle inner = take([&](Raw_handle* handle)
                                { return NMR::lib3mf_component_getobjectresource(component.get(), handle); });
      BOOL has_transform = false;
      Transform own = identity();
      require(NMR::lib3mf_component_hastransform(component.get(), &has_transform));
      if (has_transform)
        require(NMR::lib3mf_component_gettransform(component.get(), &own));
      add_object(inner.get(), product(transform, own), depth + 1);
    }
  }

  Polygon_soup m_soup;
};

void add_item(Raw_handle item, Collector& collector)
{
  const Handle object = take([&](Raw_handle* handle)
                             { return NMR::lib3mf_builditem_getobjectresource(item, handle); });
  BOOL has_transform = false;
  Transform transform = identity();
  require(NMR::lib3mf_builditem_hasobjecttransform(item, &has_transform));
  if (has_transform)
    require(NMR::lib3mf_builditem_getobjecttransform(item, &transform));
  collector.add_object(object.get(), transform);
}

} // namespace

Polygon_soup read_3MF(const std::string& bytes)
{
  const Handle model = take([](Raw_handle* handle) { return NMR::lib3mf_createmodel(handle); });
  const Handle reader = take([&](Raw_handle* handle)
                             { return NMR::lib3mf_model_queryreader(model.get(), "3mf", handle); });
  std::vector<BYTE> buffer(bytes.begin(), bytes.end());
  require(NMR::lib3mf_reader_readfrombuffer(reader.get(), buffer.data(), buffer.size()));
  const Handle items = take([&](Raw_handle* handle)
                            { return NMR::lib3mf_model_getbuilditems(model.get(), handle); });
  Collector collector;
  BOOL is_there = false;
  for (require(NMR::lib3mf_builditemiterator_movenext(items.get(), &is_there)); is_there;
       require(NMR::lib3mf_builditemiterator_movenext(items.get(), &is_there)))
  {
    const Handle item = take([&](Raw_handle* handle)
                             { return NMR::lib3mf_builditemiterator_getcurrent(items.get(), handle); });
    add_item(item.get(), collector);
  }
  return collector.soup();
}

} // namespace tool
