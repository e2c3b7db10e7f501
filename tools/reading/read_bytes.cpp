// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/read_bytes.h"

#include "command_line/Error.h"

#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

namespace tool {
namespace {

constexpr const char* gzip_magic = "\x1f\x8b";          // RFC 1952, section 2.3.1
constexpr const char* byte_order_mark = "\xef\xbb\xbf"; // of UTF-8
constexpr const char* git_lfs_pointer =
  "version https://git-lfs."; // what stands for a large file that was not fetched

std::string read_all(std::istream& in)
{
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  do
  {
    in.read(buffer.data(), buffer.size());
    bytes.append(buffer.data(), std::size_t(in.gcount()));
  } while (in);
  return bytes;
}

std::string read_all(const std::string& file_name)
{
  if (file_name == "-")
    return read_all(std::cin);
  std::error_code ignored;
  if (std::filesystem::is_directory(file_name, ignored))
    throw Error(file_name, "is a folder");
  errno = 0;
  std::ifstream in(file_name, std::ios::binary);
  if (!in)
    throw Error(file_name,
                "cannot be opened" + (errno != 0 ? ": " + std::generic_category().message(errno) : ""));
  std::string bytes = read_all(in);
  if (in.bad())
    throw Error(file_name, "cannot be read");
  return bytes;
}

class Inflater
{
public:
  explicit Inflater(std::string& bytes)
  {
    m_stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
    m_left = bytes.size();
    constexpr int gzip_only = 16; // as zlib.h says of inflateInit2()
    m_is_open = inflateInit2(&m_stream, gzip_only + MAX_WBITS) == Z_OK;
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&m_stream); }

  // Appends all members of the file; returns whether they are complete.
  bool inflate_all(std::string& result)
  {
    std::array<char, 1 << 16> buffer;
    int state = m_is_open ? Z_OK : Z_MEM_ERROR;
    while (state == Z_OK)
    {
      feed();
      m_stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
      m_stream.avail_out = static_cast<uInt>(buffer.size());
      state = inflate(&m_stream, Z_NO_FLUSH);
      result.append(buffer.data(), buffer.size() - m_stream.avail_out);
      if (state == Z_STREAM_END && *m_stream.next_in == 0x1f && m_stream.avail_in + m_left > 0)
        state = inflateReset(&m_stream);
    }
    return state == Z_STREAM_END;
  }

private:
  // zlib counts what is left in 32 bits.
  void feed()
  {
    const std::size_t more = (std::min)(m_left, std::size_t(1) << 30);
    if (m_stream.avail_in > 0)
      return;
    m_stream.avail_in = static_cast<uInt>(more);
    m_left -= more;
  }

  z_stream m_stream = {};
  std::size_t m_left;
  bool m_is_open;
};

} // namespace

std::string read_bytes(const std::string& file_name)
{
  std::string bytes = read_all(file_name);
  if (bytes.empty())
    throw Error(file_name, "is empty");
  if (bytes.compare(0, 2, gzip_magic) == 0)
  {
    std::string inflated;
    if (!Inflater(bytes).inflate_all(inflated))
      throw Error(file_name, "is gzip, but broken or cut off");
    bytes.swap(inflated);
  }
  if (bytes.compare(0, 3, byte_order_mark) == 0)
    bytes.erase(0, 3);
  if (bytes.compare(0, std::strlen(git_lfs_pointer), git_lfs_pointer) == 0)
    throw Error(file_name, "is a pointer of Git LFS and not the file itself, which 'git lfs pull' gets");
  return bytes;
}

} // namespace tool
