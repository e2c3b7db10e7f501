// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// By VTK. CGAL's reader is for files only, leaves triangle strips out, takes corners that do not exist, and lets VTK tell
// its errors on the standard error.

#include "reading/formats.h"

#include "reading/Format_error.h"

#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cstddef>
#include <string>

namespace tool
{
namespace
{

// What has a listener writes nothing itself.
class Error_listener : public vtkCommand
{
public:
  static Error_listener* New() { return new Error_listener; }

  void Execute(vtkObject*, unsigned long, void* message) override
  {
    if (m_error.empty() && message != nullptr)
      m_error = static_cast<const char*>(message);
  }

  bool is_silent() const { return m_error.empty(); }

  // Without the place in VTK's source, which ends with an address.
  std::string error() const
  {
    const std::size_t place = m_error.find("): ");
    const std::string text = place == std::string::npos ? m_error : m_error.substr(place + 3);
    return text.substr(0, text.find('\n'));
  }

private:
  std::string m_error;
};

// The corners of each cell of an array whose indices VTK has not checked.
class Cells
{
public:
  explicit Cells(vtkCellArray* cells)
    : m_corners(cells->GetConnectivityArray()),
      m_ends(cells->GetOffsetsArray()),
      m_number_of_cells(cells->GetNumberOfCells())
  {}

  template <typename Use>
  void for_each(const Use& use) const
  {
    for (vtkIdType i = 0; i < m_number_of_cells; ++i)
    {
      const double begin = m_ends->GetComponent(i, 0), end = m_ends->GetComponent(i + 1, 0);
      if (!(begin >= 0 && begin <= end && end <= static_cast<double>(m_corners->GetNumberOfTuples())))
        throw Format_error("the offset of cell " + std::to_string(i) + " is beyond the corners");
      Polygon corners;
      for (auto c = static_cast<vtkIdType>(begin); c < static_cast<vtkIdType>(end); ++c)
        corners.push_back(corner(c, i));
      use(corners);
    }
  }

private:
  std::size_t corner(vtkIdType c, vtkIdType cell) const
  {
    const double value = m_corners->GetComponent(c, 0);
    if (value < 0)
      throw Format_error("cell " + std::to_string(cell) + " has a negative corner");
    return static_cast<std::size_t>(value);
  }

  vtkDataArray* m_corners;
  vtkDataArray* m_ends;
  vtkIdType m_number_of_cells;
};

// In VTK's order of cells: polygons, then strips. Vertices and lines are no faces.
Polygon_soup soup_of(vtkPolyData& data)
{
  Polygon_soup soup;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
  {
    const double* point = data.GetPoint(i);
    soup.points.emplace_back(point[0], point[1], point[2]);
  }
  Cells(data.GetPolys()).for_each([&](const Polygon& corners) { soup.polygons.push_back(corners); });
  Cells(data.GetStrips())
    .for_each(
      [&](const Polygon& corners)
      {
        for (std::size_t n = 3; n <= corners.size(); ++n)
          soup.polygons.push_back(triangle_of_strip(corners, n));
      });
  return soup;
}

} // namespace

Polygon_soup read_VTP(const std::string& bytes)
{
  const vtkNew<Error_listener> listener;
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->SetReaderErrorObserver(listener);
  reader->SetParserErrorObserver(listener);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  if (!listener->is_silent())
    throw Format_error("is not a well-formed VTP file: " + listener->error());
  return soup_of(*reader->GetOutput());
}

} // namespace tool
