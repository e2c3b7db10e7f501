// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Zip_archive.h"

#include "writing/binary_numbers.h"

#include <zlib.h>

#include <limits>
#include <stdexcept>

namespace tool {
namespace {

constexpr std::uint32_t local_header = 0x04034b50, central_header = 0x02014b50,
                        end_of_directory = 0x06054b50;
constexpr std::size_t size_of_local_header = 30, size_of_central_header = 46;
constexpr std::uint16_t version_with_deflate = 20, method_deflate = 8, names_in_UTF_8 = 1 << 11;
constexpr std::uint16_t midnight = 0, first_of_January_1980 = (1 << 5) + 1;

std::uint32_t checked(std::size_t size)
{
  if (size > (std::numeric_limits<std::uint32_t>::max)())
    throw std::length_error("has more than 4 GB, which a ZIP archive cannot hold");
  return static_cast<std::uint32_t>(size);
}

// Without the header and the checksum that zlib adds around it.
std::string deflated(const std::string& content)
{
  constexpr int highest_memory_level = 9;
  z_stream stream = {};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, highest_memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string result(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(
    const_cast<char*>(content.data())); // which zlib does not change
  stream.avail_in = checked(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = checked(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

} // namespace

void Zip_archive::write_description(const Entry& entry)
{
  for (const std::uint16_t number :
       {version_with_deflate, names_in_UTF_8, method_deflate, midnight, first_of_January_1980})
    write_bits(m_out, number);
  for (const std::uint32_t number : {entry.checksum, entry.compressed_size, entry.size})
    write_bits(m_out, number);
  write_bits(m_out, static_cast<std::uint16_t>(entry.name.size()));
  write_bits(m_out, std::uint16_t(0)); // bytes of extra fields
}

void Zip_archive::add(const std::string& name, const std::string& content)
{
  const std::string compressed = deflated(content);
  const auto checksum = static_cast<std::uint32_t>(
    crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()));
  m_entries.push_back(
    {name, checksum, checked(compressed.size()), checked(content.size()), checked(m_size)});
  write_bits(m_out, local_header);
  write_description(m_entries.back());
  m_out << name << compressed;
  m_size += size_of_local_header + name.size() + compressed.size();
}

void Zip_archive::finish()
{
  const std::uint32_t begin = checked(m_size);
  for (const Entry& entry : m_entries)
  {
    write_bits(m_out, central_header);
    write_bits(m_out, version_with_deflate); // of the program that made it
    write_description(entry);
    for (int i = 0; i < 3; ++i)
      write_bits(m_out, std::uint16_t(0)); // no comment, first disk, no attributes
    write_bits(m_out, std::uint32_t(0));   // nor others
    write_bits(m_out, entry.offset);
    m_out << entry.name;
    m_size += size_of_central_header + entry.name.size();
  }
  const auto count = static_cast<std::uint16_t>(m_entries.size());
  write_bits(m_out, end_of_directory);
  write_bits(m_out, std::uint32_t(0)); // the number of this disk, and that of the first
  write_bits(m_out, count);            // on this disk
  write_bits(m_out, count);            // in all
  write_bits(m_out, checked(m_size - begin));
  write_bits(m_out, begin);
  write_bits(m_out, std::uint16_t(0)); // no comment
}

} // namespace tool
