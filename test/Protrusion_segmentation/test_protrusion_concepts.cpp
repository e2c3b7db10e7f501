// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Archetypes: classes with nothing but what the concepts ask for.

#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A distance without a way of its own to the face of eq. (1): the number of edges to cross.
class Hop_distances
{
public:
  explicit Hop_distances(const Indexed_surface& surface) : m_surface(&surface) {}
  Hop_distances(Hop_distances&&) = default;
  Hop_distances& operator=(Hop_distances&&) = delete;

  void operator()(Indexed_surface::Index source, std::vector<double>& distances)
  {
    ++m_number_of_runs;
    distances.assign(m_surface->number_of_faces(), infinity());
    distances[source] = 0;
    std::vector<Indexed_surface::Index> queue(1, source);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Indexed_surface::Index c = m_surface->first_corner(queue[i]);
           c < m_surface->first_corner(queue[i] + 1); ++c)
      {
        const Indexed_surface::Index g = m_surface->neighbor(c);
        if (g == Indexed_surface::no_face() || distances[g] < infinity())
          continue;
        distances[g] = distances[queue[i]] + 1;
        queue.push_back(g);
      }
  }

  std::size_t number_of_runs() const { return m_number_of_runs; }

private:
  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }

  const Indexed_surface* m_surface;
  std::size_t m_number_of_runs = 0;
};

class Hop_distance
{
public:
  explicit Hop_distance(int) {}
  Hop_distance(const Hop_distance&) = default; // a method keeps a copy
  Hop_distance& operator=(const Hop_distance&) = delete;

  auto on(const Indexed_surface& surface, Execution& /* execution */) const
  {
    return Hop_distances(surface);
  }
};

// Copied, but not assigned or made from nothing.
class Visitor : public Segmentation_visitor<Mesh>
{
public:
  explicit Visitor(std::size_t& calls) : m_calls(&calls) {}
  Visitor(const Visitor&) = default;
  Visitor& operator=(const Visitor&) = delete;

  void on_reading_begin() { ++*m_calls; }
  void on_progress(double) { ++*m_calls; }
  void on_tip(face_descriptor) { ++*m_calls; }
  void on_protrusion(const Protrusion<face_descriptor>&) { ++*m_calls; }

private:
  std::size_t* m_calls;
};

int main()
{
  const Test_mesh soup = star(3, 2, 0.2, 0.04, 0.25);
  const Mesh mesh = to_graph<Mesh>(soup);
  const Hop_distance distance(0);
  const Histogram_method method(distance);
  std::size_t calls = 0;

  const Segmentation found = checked(mesh,
                                     [&](auto ids)
                                     {
                                       return CGAL::segmentation_via_protrusion_tips(
                                         mesh, ids, 4, method, CGAL::parameters::visitor(Visitor(calls)));
                                     });
  CGAL_CHECK_EQUAL(found.number, 4);
  CGAL_CHECK(calls > 10);

  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, 3, std::back_inserter(tips), distance);
  std::set<std::size_t> arms;
  for (const Mesh::Face_index tip : tips)
    arms.insert(soup.parts[tip]);
  CGAL_CHECK(arms == (std::set<std::size_t>{1, 2, 3}));
  CGAL_CHECK(checked(mesh, [&](auto ids)
                { return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, method); })
          .number > 1);
  return check::result();
}
