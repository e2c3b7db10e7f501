// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as 3MF. The first byte chooses method and number of segments. The rest is the file if it begins as an
// archive does; else it is the model in an archive that is in order, where no change of a byte breaks a checksum.

#include "fuzz_target.h"
#include "mesh_file.h"

#include <zlib.h>

#include <cstdint>

namespace {

constexpr const char* archive_signature = "PK";

constexpr const char* content_types =
  R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>)";

constexpr const char* relationships =
  R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="rel0" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>)";

// A ZIP archive of files that are not compressed, by sections 4.3.7, 4.3.12 and 4.3.16 of its specification (APPNOTE.TXT).
class Archive
{
public:
  void add(const std::string& name, const std::string& content)
  {
    const std::string entry = entry_of(name, content);
    m_directory += "PK\x01\x02" + bytes<2>(version) + entry + bytes<2>(0) /* comment */ +
                   bytes<2>(0) /* disk */ + bytes<2>(0) + bytes<4>(0) /* attributes */ +
                   bytes<4>(m_files.size()) + name;
    m_files += "PK\x03\x04" + entry + name + content;
    ++m_number_of_files;
  }

  std::string finished() const
  {
    return m_files + m_directory + "PK\x05\x06" + bytes<4>(0) /* disks */ + bytes<2>(m_number_of_files) +
           bytes<2>(m_number_of_files) + bytes<4>(m_directory.size()) + bytes<4>(m_files.size()) +
           bytes<2>(0);
  }

private:
  static constexpr std::size_t version = 20, first_of_january_1980 = 33;

  // Least byte first.
  template <int n>
  static std::string bytes(std::size_t number)
  {
    std::string result;
    for (int i = 0; i < n; ++i)
      result += static_cast<char>(number >> (8 * i) & 0xff);
    return result;
  }

  // What a file's own header and the directory say of it.
  static std::string entry_of(const std::string& name, const std::string& content)
  {
    const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                                static_cast<uInt>(content.size()));
    return bytes<2>(version) + bytes<2>(0) /* flags */ + bytes<2>(0) /* not compressed */ +
           bytes<2>(0) /* time */ + bytes<2>(first_of_january_1980) + bytes<4>(checksum) +
           bytes<4>(content.size()) + bytes<4>(content.size()) + bytes<2>(name.size()) +
           bytes<2>(0) /* extra */;
  }

  std::string m_files, m_directory;
  std::size_t m_number_of_files = 0;
};

std::string archive_of_model(const std::string& model)
{
  Archive archive;
  archive.add("[Content_Types].xml", content_types);
  archive.add("_rels/.rels", relationships);
  archive.add("3D/3dmodel.model", model);
  return archive.finished();
}

} // namespace

void fuzz(const std::string& bytes)
{
  if (bytes.empty())
    return;
  const std::string file = bytes.substr(1);
  fuzz_mesh_file(".3mf", file.compare(0, 2, archive_signature) == 0 ? file : archive_of_model(file),
                 static_cast<unsigned char>(bytes[0]));
}
