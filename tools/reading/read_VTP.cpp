// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// By VTK. CGAL's reader is for files only, leaves triangle strips out, takes corners that do not exist, and lets VTK tell
// its errors on the standard error.

#include "reading/formats.h"

#include "reading/Format_error.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkInputStream.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tool
{
namespace
{

// Takes what all objects of VTK tell, those within its readers too, in place of the standard error: of each thread the
// first error.
class Error_log : public vtkOutputWindow
{
public:
  static Error_log* New();

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
vtkStandardNewMacro(Error_log)

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

constexpr std::size_t size_of_largest_word = sizeof(double);

// Would so many words overflow as a number of bytes?
constexpr bool is_too_many(std::uint64_t words)
{
  return words > std::uint64_t((std::numeric_limits<vtkIdType>::max)()) / size_of_largest_word;
}

// As VTK's, and looks at what a compressed array says of its blocks, which VTK believes.
class Parser : public vtkXMLDataParser
{
public:
  static Parser* New();

  bool can_read(vtkXMLDataElement* array, bool is_empty)
  {
    const char* format = array->GetAttribute("format");
    vtkTypeInt64 offset = 0;
    const bool is_appended = array->GetScalarAttribute("offset", offset) != 0;
    if (Compressor == nullptr || (!is_appended && (format == nullptr || std::string(format) != "binary")))
      return true;
    DataStream = is_appended ? AppendedDataStream : InlineDataStream;
    if (is_appended)
      SeekG(AppendedDataPosition + offset);
    else
      SeekInlineDataPosition(array);
    DataStream->SetStream(Stream);
    constexpr int bits_of_large_files = 64;
    return HeaderType == bits_of_large_files ? has_sound_blocks<std::uint64_t>(is_empty)
                                             : has_sound_blocks<std::uint32_t>(is_empty);
  }

private:
  template <typename Word>
  bool has_sound_blocks(bool is_empty)
  {
    std::array<Word, 3> header = {};
    DataStream->StartReading();
    const std::size_t size = DataStream->Read(header.data(), sizeof(header));
    DataStream->EndReading();
    PerformByteSwap(header.data(), header.size(), sizeof(Word));
    const auto [blocks, size_of_block, size_of_last_block] = header; // 0: the last one is as large as the others
    if (size < sizeof(header) || size_of_block == 0 || size_of_last_block > size_of_block)
      return false;
    return blocks == 0 ? is_empty && size_of_last_block == 0 : !is_too_many(blocks);
  }
};
vtkStandardNewMacro(Parser)

// As VTK's, but for arrays that it would take too little memory for, or look for in blocks that are not there.
class Reader : public vtkXMLPolyDataReader
{
public:
  static Reader* New();

protected:
  void CreateXMLParser() override
  {
    if (XMLParser != nullptr)
      DestroyXMLParser();
    XMLParser = Parser::New();
  }

  int ReadArrayValues(vtkXMLDataElement* element, vtkIdType first, vtkAbstractArray* array,
                      vtkIdType first_of_array, vtkIdType number, FieldType type) override
  {
    if (number < 0 || is_too_many(std::uint64_t(number)))
      vtkErrorMacro("announces " << number << " values");
    else if (!static_cast<Parser*>(XMLParser)->can_read(element, number == 0))
      vtkErrorMacro("has a compressed array whose blocks do not fit together");
    else if (vtkXMLPolyDataReader::ReadArrayValues(element, first, array, first_of_array, number, type) != 0)
      return 1;
    else if (Error_log::error().empty())
      vtkErrorMacro("has a data array that is too short");
    // VTK tells the name of the cell data, which has none: the error that is logged is enough, no value is used
    return type == CELL_DATA ? 1 : 0;
  }
};
vtkStandardNewMacro(Reader)

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
  Cells(data.GetPolys()).for_each([&](const Polygon& corners) { soup.polygons.add(corners); });
  Cells(data.GetStrips())
    .for_each(
      [&](const Polygon& corners)
      {
        for (std::size_t n = 3; n <= corners.size(); ++n)
          soup.polygons.add(triangle_of_strip(corners, n));
      });
  return soup;
}

vtkSmartPointer<Reader> read(const std::string& bytes)
{
  log_errors();
  auto reader = vtkSmartPointer<Reader>::New();
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  if (!Error_log::error().empty())
    throw Format_error("is not a well-formed VTP file: " + first_line(Error_log::error()));
  return reader;
}

} // namespace

Polygon_soup read_VTP(const std::string& bytes)
{
  return soup_of(*read(bytes)->GetOutput());
}

std::vector<double> read_VTP_labels(const std::string& bytes)
{
  const vtkSmartPointer<Reader> reader = read(bytes);
  vtkPolyData& data = *reader->GetOutput();
  vtkCellData& arrays = *data.GetCellData();
  std::vector<double> labels;
  for (int i = 0; i < arrays.GetNumberOfArrays() && labels.empty(); ++i)
    if (vtkDataArray* array = arrays.GetArray(i); array != nullptr && array->GetName() != nullptr && is_label(array->GetName()))
      for (vtkIdType cell = data.GetNumberOfVerts() + data.GetNumberOfLines(); cell < array->GetNumberOfTuples(); ++cell)
        labels.push_back(array->GetComponent(cell, 0));
  return labels;
}

} // namespace tool
