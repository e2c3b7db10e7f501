// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_ZIP_ARCHIVE_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_ZIP_ARCHIVE_H

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

// A ZIP archive in a stream, its files compressed by zlib. All have one date, so that the same files give the same archive.
// By PKWARE's APPNOTE.TXT, version 6.3.10.
class Zip_archive
{
public:
  explicit Zip_archive(std::ostream& out) : m_out(out) {}

  // Throws std::length_error where a file or the archive has more bytes than 32 bits count.
  void add(const std::string& name, const std::string& content);

  // Writes the table of contents.
  void finish();

private:
  struct Entry
  {
    std::string name;
    std::uint32_t checksum;
    std::uint32_t compressed_size;
    std::uint32_t size;
    std::uint32_t offset;
  };

  // What the header of a file and its entry in the table have in common.
  void write_description(const Entry& entry);

  std::ostream& m_out;
  std::size_t m_size = 0; // of what is written
  std::vector<Entry> m_entries;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_ZIP_ARCHIVE_H
