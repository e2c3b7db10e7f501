// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connectors on caps of any shape, also on those that flat caps alone hardly close.

#include "connected_parts.h"

#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

// Any segments at all: several pieces, loops that touch themselves, caps that cancel each other.
void test_random_labels(const Mesh& mesh, std::size_t number, unsigned int seed, const std::string& name)
{
  const Random_segments segments(mesh, number, seed);
  check_connected(mesh, segments.labels, segments.parents, {}, name + " at random");
}

// Patches that grow from random faces, and random options.
void test_random_patches(const Mesh& mesh, unsigned int seed, const std::string& name)
{
  std::mt19937 random(seed);
  const std::size_t number = 2 + random() % 6;
  Labels labels(mesh.number_of_faces(), number), parents = {0};
  std::vector<Mesh::Face_index> queue;
  for (std::size_t s = 0; s < number; ++s)
  {
    queue.push_back(Mesh::Face_index(Mesh::size_type(random() % mesh.number_of_faces())));
    labels[queue.back()] = s;
    if (s > 0)
      parents.push_back(random() % s);
  }
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (const auto f : faces_around_face(mesh.halfedge(queue[i]), mesh))
      if (f != Mesh::null_face() && labels[f] == number)
      {
        labels[f] = labels[queue[i]];
        queue.push_back(f);
      }
  for (std::size_t& label : labels)
    label %= number;
  std::uniform_real_distribution<double> share(0, 1);
  Connector_options options;
  options.number_of_sides = 3 + random() % 20;
  options.radius = 0.1 + 0.8 * share(random);
  options.depth = 0.1 + 2 * share(random);
  options.chamfer = 0.5 * share(random);
  options.smallest_radius = 0;
  check_connected(mesh, labels, parents, options, name + " in patches " + std::to_string(seed));
}

} // namespace

int main()
{
  const std::map<std::string, Test_mesh> meshes = {
    {"star", star(5)}, {"creature", creature()}, {"torus", torus()}};
  for (const auto& [name, soup] : meshes)
  {
    const auto mesh = to_graph<Mesh>(soup);
    test_random_labels(mesh, 3, 1, name);
    for (unsigned int seed = 0; seed < 10; ++seed)
      test_random_patches(mesh, seed, name);
  }
  return check::result();
}
