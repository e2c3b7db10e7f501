// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading and writing `.seg` files.

#include "check.h"

#include <CGAL/IO/SEG.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = boost::graph_traits<Mesh>::face_descriptor;

template <typename Id>
using Id_map = Mesh::Property_map<Face, Id>;

constexpr int untouched = 77;

Mesh tetrahedron()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                         Kernel::Point_3(0, 0, 1), mesh);
  return mesh;
}

template <typename Id>
Id_map<Id> new_ids(Mesh& mesh)
{
  return mesh.add_property_map<Face, Id>("f:ids", Id(untouched)).first;
}

template <typename Id>
std::vector<Id> values(const Mesh& mesh, Id_map<Id> ids)
{
  std::vector<Id> result;
  for (const Face f : faces(mesh))
    result.push_back(get(ids, f));
  return result;
}

template <typename Id>
void check_accepted(const std::string& text, const std::vector<Id>& expected)
{
  Mesh mesh = tetrahedron();
  const Id_map<Id> ids = new_ids<Id>(mesh);
  std::istringstream in(text);
  CGAL_CHECK(CGAL::IO::read_SEG(in, mesh, ids));
  CGAL_CHECK(values(mesh, ids) == expected);
}

// `cause` is part of the text that tells it.
template <typename Id>
void check_rejected(const std::string& text, const std::string& cause)
{
  Mesh mesh = tetrahedron();
  const Id_map<Id> ids = new_ids<Id>(mesh);
  std::istringstream in(text);
  CGAL_CHECK(!CGAL::IO::read_SEG(in, mesh, ids));
  CGAL_CHECK(values(mesh, ids) == std::vector<Id>(4, Id(untouched)));

  std::istringstream again(text);
  const std::string told = CGAL::Protrusion_segmentation::internal::read_segments(again, mesh, ids);
  CGAL_CHECK(told.find(cause) != std::string::npos);
  CGAL_CHECK_EQUAL(std::string(told.begin(), told.end()).find('\n'), std::string::npos);
}

void test_accepted_texts()
{
  check_accepted<std::size_t>("0\n1\n2\n3\n", {0, 1, 2, 3});
  check_accepted<std::size_t>("0\n1\n2\n3", {0, 1, 2, 3});
  check_accepted<std::size_t>("0\r\n1\r\n2\r\n3\r\n", {0, 1, 2, 3});
  check_accepted<std::size_t>(" 5\n\t7 \n007\n18446744073709551615\n\n \n",
                              {5, 7, 7, 18446744073709551615u});
  check_accepted<int>("0\n2147483647\n2\n3\n", {0, 2147483647, 2, 3});
  check_accepted<std::uint8_t>("0\n255\n2\n3\n", {0, 255, 2, 3});
}

void test_rejected_texts()
{
  check_rejected<std::size_t>("", "only 0 segment ids for 4 faces");
  check_rejected<std::size_t>("0\n1\n2\n", "only 3 segment ids for 4 faces");
  check_rejected<std::size_t>("0\n1\n2\n3\n4\n", "line 5: there are more segment ids");
  check_rejected<std::size_t>("0\n1\nx\n3\n", "line 3: 'x' is not a segment id");
  check_rejected<std::size_t>("0\n1\n2 2\n3\n", "line 3: '2 2' is not a segment id");
  check_rejected<std::size_t>("0\n1\n2.5\n3\n", "'2.5' is not");
  check_rejected<std::size_t>("0\n1\n1e1\n3\n", "'1e1' is not");
  check_rejected<std::size_t>("0\n1\n0x1\n3\n", "'0x1' is not");
  check_rejected<std::size_t>("0\n1\n+1\n3\n", "'+1' is not");
  check_rejected<std::size_t>("0\n1\n-\n3\n", "'-' is not");
  check_rejected<std::size_t>("0\n1\n--1\n3\n", "'--1' is not");
  check_rejected<std::size_t>("0\n1\nnan\n3\n", "'nan' is not");
  check_rejected<std::size_t>("0\n-1\n2\n3\n", "line 2: the segment id '-1' is negative");
  check_rejected<int>("0\n-1\n2\n3\n", "is negative");
  check_rejected<std::size_t>("0\n18446744073709551616\n2\n3\n", "is too large");
  check_rejected<int>("0\n2147483648\n2\n3\n", "line 2: the segment id '2147483648' is too large");
  check_rejected<std::uint8_t>("0\n256\n2\n3\n", "is too large");
  check_rejected<std::size_t>("0\n1\n\n2\n3\n", "line 4: a segment id follows a blank line");
  check_rejected<std::size_t>("\n0\n1\n2\n3\n", "line 2");
  check_rejected<std::size_t>(std::string("0\n1\n2\0\n3\n", 9), "'2?' is not");
  check_rejected<std::size_t>(std::string(1000, '\x7f'), "...' is not");
}

void test_failed_stream()
{
  Mesh mesh = tetrahedron();
  const auto ids = new_ids<std::size_t>(mesh);
  std::istringstream in("0\n1\n2\n3\n");
  in.setstate(std::ios::failbit);
  CGAL_CHECK(!CGAL::IO::read_SEG(in, mesh, ids));
  std::ostringstream out;
  out.setstate(std::ios::failbit);
  CGAL_CHECK(!CGAL::IO::write_SEG(out, mesh, ids));
}

void test_verbose_tells_the_cause()
{
  Mesh mesh = tetrahedron();
  const auto ids = new_ids<std::size_t>(mesh);
  std::ostringstream caught;
  std::streambuf* const original = std::cerr.rdbuf(caught.rdbuf());
  std::istringstream silent("0\n"), verbose("0\n");
  CGAL::IO::read_SEG(silent, mesh, ids);
  CGAL::IO::read_SEG("no such file.seg", mesh, ids);
  const bool was_silent = caught.str().empty();
  CGAL::IO::read_SEG(verbose, mesh, ids, CGAL::parameters::verbose(true));
  CGAL::IO::read_SEG("no such file.seg", mesh, ids, CGAL::parameters::verbose(true));
  std::cerr.rdbuf(original);
  CGAL_CHECK(was_silent);
  CGAL_CHECK(caught.str().find("only 1 segment ids for 4 faces") != std::string::npos);
  CGAL_CHECK(caught.str().find("no such file.seg: it cannot be opened") != std::string::npos);
}

// A folder of its own that disappears with the test.
struct Scratch_folder
{
  Scratch_folder()
    : path(fs::temp_directory_path() /
           ("protrusion_segmentation_test_SEG_" + std::to_string(std::random_device()())))
  {
    fs::create_directories(path);
  }
  ~Scratch_folder() { fs::remove_all(path); }

  std::size_t number_of_files() const
  {
    return std::size_t(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }

  fs::path path;
};

std::string content(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

void test_files()
{
  const Scratch_folder folder;
  const std::string name = (folder.path / "a.seg").string();
  Mesh mesh = tetrahedron();
  const auto ids = new_ids<std::size_t>(mesh);
  std::size_t next = 3;
  for (const Face f : faces(mesh))
    put(ids, f, next *= 10);

  CGAL_CHECK(CGAL::IO::write_SEG(name, mesh, ids));
  CGAL_CHECK_EQUAL(content(name), std::string("30\n300\n3000\n30000\n"));
  CGAL_CHECK_EQUAL(folder.number_of_files(), 1);

  const auto read = mesh.add_property_map<Face, long>("f:read", -1).first;
  CGAL_CHECK(CGAL::IO::read_SEG(name, mesh, read));
  CGAL_CHECK((values<long>(mesh, read) == std::vector<long>{30, 300, 3000, 30000}));
  CGAL_CHECK(!CGAL::IO::read_SEG(folder.path.string(), mesh, read));
}

void test_failed_writing()
{
  const Scratch_folder folder;
  Mesh mesh = tetrahedron();
  const auto ids = new_ids<int>(mesh);
  CGAL_CHECK(!CGAL::IO::write_SEG((folder.path / "none" / "a.seg").string(), mesh, ids));
  CGAL_CHECK(!CGAL::IO::write_SEG(folder.path.string(), mesh, ids));
  CGAL_CHECK(!CGAL::IO::write_SEG("", mesh, ids));
  CGAL_CHECK_EQUAL(folder.number_of_files(), 0);

  put(ids, *std::prev(faces(mesh).end()), -1);
  CGAL_CHECK(!CGAL::IO::write_SEG((folder.path / "a.seg").string(), mesh, ids));
  CGAL_CHECK_EQUAL(folder.number_of_files(), 0);
  std::ostringstream out;
  CGAL_CHECK(!CGAL::IO::write_SEG(out, mesh, ids));
  CGAL_CHECK(out.str().empty());

  const fs::path before = folder.path / "before.seg";
  std::ofstream(before) << "0";
  CGAL_CHECK(!CGAL::IO::write_SEG(before.string(), mesh, ids));
  CGAL_CHECK_EQUAL(fs::file_size(before), 1);
}

// As by all functions of CGAL that write files: the file itself is written, whatever may be made or replaced beside it.
void test_a_file_is_written_in_place()
{
  const Scratch_folder folder;
  const fs::path name = folder.path / "a.seg", other_name = folder.path / "b.seg";
  std::ofstream(name) << "before, and longer than the new content";
  fs::create_hard_link(name, other_name);
  fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
  Mesh mesh = tetrahedron();
  CGAL_CHECK(CGAL::IO::write_SEG(name.string(), mesh, new_ids<int>(mesh)));
  CGAL_CHECK_EQUAL(content(name), std::string("77\n77\n77\n77\n"));
  CGAL_CHECK_EQUAL(content(other_name), content(name));
  fs::permissions(folder.path, fs::perms::owner_all);
}

void test_links_are_followed()
{
  const Scratch_folder folder;
  const fs::path target = folder.path / "target.seg", link = folder.path / "link.seg";
  std::ofstream(target) << "before";
  fs::create_symlink(target, link);
  Mesh mesh = tetrahedron();
  CGAL_CHECK(CGAL::IO::write_SEG(link.string(), mesh, new_ids<int>(mesh)));
  CGAL_CHECK(fs::is_symlink(link));
  CGAL_CHECK_EQUAL(content(target), std::string("77\n77\n77\n77\n"));
}

void test_removed_faces_have_no_line()
{
  Mesh mesh = tetrahedron();
  CGAL::Euler::remove_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  const auto ids = new_ids<std::size_t>(mesh);
  std::istringstream in("4\n5\n6\n");
  CGAL_CHECK(CGAL::IO::read_SEG(in, mesh, ids));
  std::ostringstream out;
  CGAL_CHECK(CGAL::IO::write_SEG(out, mesh, ids));
  CGAL_CHECK_EQUAL(out.str(), std::string("4\n5\n6\n"));
}

void test_mesh_without_faces()
{
  Mesh mesh;
  const auto ids = new_ids<std::size_t>(mesh);
  std::istringstream empty(""), one_id("0\n");
  CGAL_CHECK(CGAL::IO::read_SEG(empty, mesh, ids));
  CGAL_CHECK(!CGAL::IO::read_SEG(one_id, mesh, ids));
}

void test_polyhedron_with_associative_map()
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Polyhedron mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                         Kernel::Point_3(0, 0, 1), mesh);
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, std::size_t> ids;
  std::istringstream in("1\n2\n3\n4\n");
  CGAL_CHECK(CGAL::IO::read_SEG(in, mesh, boost::make_assoc_property_map(ids)));
  std::ostringstream out;
  CGAL_CHECK(CGAL::IO::write_SEG(out, mesh, boost::make_assoc_property_map(ids)));
  CGAL_CHECK_EQUAL(out.str(), std::string("1\n2\n3\n4\n"));
}

int main()
{
  test_accepted_texts();
  test_rejected_texts();
  test_failed_stream();
  test_verbose_tells_the_cause();
  test_files();
  test_failed_writing();
  test_a_file_is_written_in_place();
  test_links_are_followed();
  test_removed_faces_have_no_line();
  test_mesh_without_faces();
  test_polyhedron_with_associative_map();
  return check::result();
}
