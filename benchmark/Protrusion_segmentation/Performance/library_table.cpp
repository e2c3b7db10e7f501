// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"
#include "tables.h"

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/histograms.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/protrusion_segmentation.h>

#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

namespace PS = CGAL::Protrusion_segmentation;
using Index = PS::Indexed_surface::Index;

// Shortest paths by Boost's algorithm, with what the search for the face of eq. (1) needs of them.
class Boost_shortest_distances
{
public:
  explicit Boost_shortest_distances(const PS::Indexed_surface& surface) : m_arcs(surface), m_graph(surface.dual_graph()) {}

  void operator()(Index source, std::vector<double>& distances)
  {
    ++m_number_of_runs;
    const auto index = get(boost::vertex_index, m_graph);
    distances.resize(num_vertices(m_graph));
    m_tree.parent.resize(num_vertices(m_graph));
    m_tree.order.clear();
    boost::dijkstra_shortest_paths_no_color_map(
      m_graph, source,
      boost::weight_map(get(&PS::Indexed_surface::Arc::length, m_graph))
        .distance_map(boost::make_iterator_property_map(distances.begin(), index))
        .predecessor_map(boost::make_iterator_property_map(m_tree.parent.begin(), index))
        .visitor(boost::make_dijkstra_visitor(Order_of_scans(m_tree.order))));
  }

  const PS::internal::Dual_arcs& arcs() const { return m_arcs; }
  const PS::internal::Shortest_path_tree& tree() const { return m_tree; }
  std::size_t number_of_runs() const { return m_number_of_runs; }

private:
  struct Order_of_scans : boost::base_visitor<Order_of_scans>
  {
    using event_filter = boost::on_examine_vertex;

    explicit Order_of_scans(std::vector<Index>& faces) : order(&faces) {}

    template <typename Graph>
    void operator()(Index face, const Graph&)
    {
      order->push_back(face);
    }

    std::vector<Index>* order;
  };

  PS::internal::Dual_arcs m_arcs;
  PS::Indexed_surface::Dual_graph m_graph;
  PS::internal::Shortest_path_tree m_tree;
  std::size_t m_number_of_runs = 0;
};

// The geodesic distance by these.
class Boost_distance
{
public:
  class On_surface : public Boost_shortest_distances
  {
  public:
    On_surface(const PS::Indexed_surface& surface, PS::Execution& execution)
      : Boost_shortest_distances(surface), m_surface(surface), m_execution(execution)
    {}

    Index face_of_largest_sum()
    {
      Boost_shortest_distances& distances = *this;
      using Search = PS::internal::Largest_distance_sum<Boost_shortest_distances>;
      return Search(m_surface, distances, m_execution)(m_surface.number_of_faces());
    }

  private:
    const PS::Indexed_surface& m_surface;
    PS::Execution& m_execution;
  };

  On_surface on(const PS::Indexed_surface& surface, PS::Execution& execution) const { return {surface, execution}; }
};

template <typename Distance>
double seconds_of_paper(const Model& model, const Distance& distance, Labels& labels, const Options& options)
{
  return seconds_of(options.repetitions,
                    [&]
                    {
                      CGAL::segmentation_via_protrusion_tips(model.mesh, CGAL::make_property_map(labels),
                                                             model.number_of_segments,
                                                             PS::Histogram_method(distance));
                    });
}

using Slicer_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Slicer_mesh = CGAL::Surface_mesh<Slicer_kernel::Point_3>;

Slicer_mesh mesh_of(const PS::Indexed_surface& surface)
{
  Slicer_mesh mesh;
  for (Index v = 0; v < surface.number_of_vertices(); ++v)
    mesh.add_vertex({surface.point(v).x(), surface.point(v).y(), surface.point(v).z()});
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    std::vector<Slicer_mesh::Vertex_index> corners;
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      corners.emplace_back(surface.vertex(c));
    mesh.add_face(corners);
  }
  return mesh;
}

// The planes of all slots of the histograms from the first face.
struct Planes_of_tip
{
  explicit Planes_of_tip(const PS::Indexed_surface& surface) : distances(distances_on(surface)), tip_slots(distances)
  {
    for (std::size_t s = 0; s < PS::internal::number_of_slots; ++s)
      if (!tip_slots.faces(s).empty())
        planes.push_back(PS::internal::plane_of_slot(surface, distances, tip_slots, s));
  }

  static std::vector<double> distances_on(const PS::Indexed_surface& surface)
  {
    PS::internal::Shortest_distances shortest_distances(surface);
    std::vector<double> result;
    shortest_distances(0, result);
    return result;
  }

  std::vector<double> distances;
  PS::internal::Slots tip_slots;
  std::vector<PS::internal::Section_plane> planes;
};

struct Times_of_sections
{
  double ours, slicer, tree;
};

Times_of_sections times_of_sections(const Model& model, const Options& options)
{
  using Primitive = CGAL::AABB_halfedge_graph_segment_primitive<Slicer_mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Slicer_kernel, Primitive>>;
  const PS::internal::Canonical_surface canonical(
    PS::internal::read_arrays(model.mesh, CGAL::parameters::default_values()));
  const PS::Indexed_surface& surface = canonical.surface();
  const Planes_of_tip tip(surface);
  PS::internal::Plane_section section(surface);
  PS::Execution execution;
  Times_of_sections result;
  result.ours = seconds_of(
    options.repetitions,
    [&] { PS::internal::sectional_diameter_histogram(surface, tip.distances, tip.tip_slots, section, execution); });

  const Slicer_mesh mesh = mesh_of(surface);
  Tree tree;
  result.tree = seconds_of(options.repetitions,
                           [&]
                           {
                             tree.rebuild(edges(mesh).first, edges(mesh).second, mesh);
                             tree.build();
                           });
  const CGAL::Polygon_mesh_slicer<Slicer_mesh, Slicer_kernel> slice(mesh, tree);
  result.slicer = seconds_of(options.repetitions,
                             [&]
                             {
                               for (const PS::internal::Section_plane& plane : tip.planes)
                               {
                                 const Slicer_kernel::Point_3 p(plane.origin.x(), plane.origin.y(), plane.origin.z());
                                 const Slicer_kernel::Vector_3 n(plane.normal.x(), plane.normal.y(), plane.normal.z());
                                 std::vector<std::vector<Slicer_kernel::Point_3>> lines;
                                 slice(Slicer_kernel::Plane_3(p, n), std::back_inserter(lines));
                               }
                             });
  return result;
}

} // namespace

void print_library_table(const Options& options, const Benchmark_folder& folder)
{
  std::vector<double> ours, boosts, paths_slower, sections, slicer, slicer_slower, with_tree, with_tree_slower;
  for (const int number_of_model : folder.models(options.models))
  {
    const Model model = folder.read_model(number_of_model);
    Labels labels(model.mesh.number_of_faces()), labels_of_boost(labels);
    ours.push_back(1e3 * seconds_of_paper(model, PS::Geodesic_distance(), labels, options));
    boosts.push_back(1e3 * seconds_of_paper(model, Boost_distance(), labels_of_boost, options));
    if (labels != labels_of_boost)
      std::cerr << "model " << number_of_model << ": other segments by Boost's paths" << std::endl;
    const Times_of_sections times = times_of_sections(model, options);
    sections.push_back(1e3 * times.ours);
    slicer.push_back(1e3 * times.slicer);
    with_tree.push_back(1e3 * (times.slicer + times.tree));
    paths_slower.push_back(boosts.back() / ours.back());
    slicer_slower.push_back(slicer.back() / sections.back());
    with_tree_slower.push_back(with_tree.back() / sections.back());
  }
  std::cout << "## 6. Against Boost's shortest paths and CGAL's slicer\n\nMeans of " << ours.size()
            << " models. Sections: of one tip, with their diameters, which the slicer does not compute.\n\n";
  const Markdown_table table({"what", "ours [ms]", "theirs [ms]", "times slower"});
  const auto print_means = [&](const std::string& what, const std::vector<double>& own, const std::vector<double>& other,
                               const std::vector<double>& ratio)
  { table.row({what, number(mean(own)), number(mean(other)), number(mean(ratio))}); };
  print_means("the paper's method, paths by `boost::dijkstra_shortest_paths_no_color_map()`", ours, boosts, paths_slower);
  print_means("sections by `CGAL::Polygon_mesh_slicer`", sections, slicer, slicer_slower);
  print_means("the same with its tree", sections, with_tree, with_tree_slower);
}
