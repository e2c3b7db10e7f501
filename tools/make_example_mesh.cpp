// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a mesh to try a segmentation on:
//
//   make_example_mesh octopus|teddy|hand|horse|chair FILE [--faces N]
//
// Each shape is the zero set of a function (see example_shapes.h), meshed by Mesh_3. The same
// arguments and version of CGAL give the same mesh.

#include "example_shapes.h"

#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>
#include <CGAL/make_mesh_3.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

using example_shapes::Kernel;
using example_shapes::Shape;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// The surface of `shape` in triangles with circumradii of at most about `size`.
Mesh mesh_surface(const Shape& shape, double size)
{
  namespace params = CGAL::parameters;
  using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
  using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
  using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
  using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

  const Kernel::Sphere_3 bounds(CGAL::ORIGIN, CGAL::square(example_shapes::bounding_radius));
  const Domain domain = Domain::create_implicit_mesh_domain(shape, bounds,
                                                            params::relative_error_bound = 1e-6);
  const Criteria criteria(params::facet_angle = 25, params::facet_size = size,
                          params::facet_distance = size);
  const Complex complex = CGAL::make_mesh_3<Complex>(
    domain, criteria, params::no_perturb(), params::no_exude(), params::manifold());
  Mesh mesh;
  CGAL::facets_in_complex_3_to_triangle_mesh(complex, mesh);
  // Not every version of CGAL turns the faces outward.
  if(!CGAL::Polygon_mesh_processing::is_outward_oriented(mesh))
    CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  return mesh;
}

// At least `faces` faces, and up to a quarter more. A coarse mesh tells which size that needs, as
// the number of faces is nearly proportional to 1 / size^2.
Mesh mesh_with_faces(const Shape& shape, std::size_t faces)
{
  double size = 25 / std::sqrt(double(faces));
  Mesh mesh = mesh_surface(shape, size);
  while(mesh.number_of_faces() < faces || mesh.number_of_faces() > 1.25 * double(faces))
  {
    size *= std::sqrt(double(mesh.number_of_faces()) / (1.12 * double(faces)));
    mesh = mesh_surface(shape, size);
  }
  return mesh;
}

int main(int argc, char* argv[])
{
  const std::map<std::string, Shape (*)()> shapes = {
    {"octopus", example_shapes::octopus}, {"teddy", example_shapes::teddy},
    {"hand", example_shapes::hand}, {"horse", example_shapes::horse},
    {"chair", example_shapes::chair}};

  std::string name, file;
  std::size_t faces = 24000;
  CLI::App arguments("Makes a mesh to try a segmentation on.");
  arguments.add_option("SHAPE", name, "The shape")->required()->check(CLI::IsMember(shapes));
  arguments.add_option("FILE", file, "The mesh file (.off, .ply, .obj, .stl)")->required();
  arguments.add_option("--faces", faces, "The least number of faces")
    ->check(CLI::Range(1000, 1000000))->capture_default_str();
  try
  {
    arguments.parse(argc, argv);
  }
  catch(const CLI::ParseError& error)
  {
    return arguments.exit(error) == 0 ? 0 : 2;
  }

  try
  {
    const Mesh mesh = mesh_with_faces(shapes.at(name)(), faces);
    if(!CGAL::IO::write_polygon_mesh(file, mesh, CGAL::parameters::stream_precision(9)))
      throw std::runtime_error("cannot write " + file);
    std::cout << file << ": " << name << ", " << mesh.number_of_faces() << " faces" << std::endl;
    return 0;
  }
  catch(const std::exception& error)
  {
    std::cerr << "make_example_mesh: " << error.what() << std::endl;
    return 1;
  }
}
