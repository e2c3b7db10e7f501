// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// By VTK. CGAL's reader is for files only, leaves triangle strips out, takes corners that do not exist, and lets VTK tell
// its errors on the standard error.

#include "reading/formats.h"

#include "reading/Format_error.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cstddef>
#include <limits>
#include <string>

namespace tool
{
namespace
{

// Takes what all objects of VTK tell, those within its readers too, in place of the standard error: of each thread the
// first error.
class Error_log : public vtkOutputWindow
{
public:
  static Error_log* New()
  {
    auto* log = new Error_log;
    log->InitializeObjectBase();
    return log;
  }

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* message) override
  {
    if (error().empty())
      error() = message;
  }

  static std::string& error()
  {
    static thread_local std::string message;
    return message;
  }
};

void log_errors()
{
  [[maybe_unused]] static const bool is_done = []
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(vtkNew<Error_log>());
    return true;
  }();
  Error_log::error().clear();
}

// Without the place in VTK's source, which ends with an address.
std::string first_line(const std::string& error)
{
  const std::size_t place = error.find("): ");
  const std::string text = place == std::string::npos ? error : error.substr(place + 3);
  return text.substr(0, text.find('\n'));
}

// As VTK's, but for numbers of values that overflow as numbers of bytes: VTK takes memory for what is left of them, and
// writes behind it.
class Reader : public vtkXMLPolyDataReader
{
public:
  static Reader* New()
  {
    auto* reader = new Reader;
    reader->InitializeObjectBase();
    return reader;
  }

protected:
  int ReadArrayValues(vtkXMLDataElement* element, vtkIdType first, vtkAbstractArray* array,
                      vtkIdType first_of_array, vtkIdType number, FieldType type) override
  {
    constexpr vtkIdType maximum = (std::numeric_limits<vtkIdType>::max)() / sizeof(double);
    if (number >= 0 && number <= maximum)
      return vtkXMLPolyDataReader::ReadArrayValues(element, first, array, first_of_array, number, type);
    vtkErrorMacro("announces " << number << " values");
    return 0;
  }
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
  log_errors();
  const vtkNew<Reader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  if (!Error_log::error().empty())
    throw Format_error("is not a well-formed VTP file: " + first_line(Error_log::error()));
  return soup_of(*reader->GetOutput());
}

} // namespace tool
