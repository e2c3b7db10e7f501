// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Candidate_pool.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/leave_out_small_components.h>
#include <CGAL/protrusion_segmentation.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace PS = CGAL::Protrusion_segmentation;

namespace {

const PS::Indexed_surface& connected(const PS::Indexed_surface& surface, int number)
{
  if (PS::internal::Nested_segments(surface).number_of_components() > 1)
    throw std::invalid_argument("the mesh of model " + std::to_string(number) + " is not connected");
  return surface;
}

double pairs(double n)
{
  return n * (n - 1) / 2;
}

double sum_of_pairs(const std::vector<double>& numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.,
                         [](double sum, double n) { return sum + pairs(n); });
}

} // namespace

Candidate_pool::Candidate_pool(const Model& model, std::size_t folder)
  : m_class_name(model.class_name),
    m_folder(folder),
    m_number_of_segments(model.number_of_segments),
    m_surface(PS::internal::leave_out_small_components(
      PS::internal::read_arrays(model.mesh, CGAL::parameters::default_values()))),
    m_graphs(connected(m_surface.surface(), model.number), m_options, m_execution),
    m_search(m_surface.surface(), m_graphs, m_no_distance, m_options, m_execution)
{
  count_shares(model.humans);
}

void Candidate_pool::count_shares(const std::vector<Labels>& humans)
{
  const std::vector<Index> node = m_surface.in_order_of_mesh(m_graphs.node_of_face);
  m_shares.resize(m_graphs.coarse.number_of_nodes());
  for (const Labels& human : humans)
  {
    std::map<std::pair<Index, std::size_t>, double> faces;
    for (std::size_t f = 0; f < human.size(); ++f)
      ++faces[{node[f], human[f]}];
    std::vector<double> of_labels(1 + *std::max_element(human.begin(), human.end()), 0);
    for (const auto& [node_and_label, number] : faces)
    {
      m_shares[node_and_label.first].push_back({m_faces_of_human.size(), node_and_label.second, number});
      of_labels[node_and_label.second] += number;
    }
    m_faces_of_human.push_back(std::move(of_labels));
  }
}

// The segments that were searched keep their cuts.
void Candidate_pool::begin_again(const Cut_weights& weights)
{
  m_options.weights = weights;
  auto greedy = std::make_unique<PS::internal::Greedy_search>(m_graphs.coarse, m_search, m_options);
  for (Index id = 0; m_greedy && id < m_greedy->memo().number_of_segments(); ++id)
  {
    const PS::internal::Segment_memo::Entry& entry = m_greedy->memo()[id];
    if (!entry.is_searched)
      continue;
    std::vector<PS::internal::Cut> cuts = entry.cuts;
    for (PS::internal::Cut& cut : cuts)
      PS::internal::value_by_clues(weights, cut);
    PS::internal::sort_best_first(cuts);
    greedy->memo().set_cuts(greedy->memo().find_or_add(entry.segment.nodes), std::move(cuts));
  }
  m_greedy = std::move(greedy);
}

Candidate_pool::Errors Candidate_pool::errors(const Cut_weights& weights)
{
  begin_again(weights);
  const double with_number = rand_index_error(m_number_of_segments);
  const std::size_t found = m_greedy->automatic_number([](std::size_t) { return 0; });
  return {with_number, rand_index_error(found), found == m_number_of_segments};
}

// Pairs that one segmentation has together and the other one apart.
double Candidate_pool::rand_index_error(std::size_t k)
{
  while (!m_greedy->best(k))
    --k;
  const std::size_t number_of_humans = m_faces_of_human.size();
  std::vector<double> apart(number_of_humans); // so far, of the pairs that the human has together
  for (std::size_t h = 0; h < number_of_humans; ++h)
    apart[h] = sum_of_pairs(m_faces_of_human[h]);
  for (const Index segment : m_greedy->best(k)->segments)
  {
    std::vector<std::vector<double>> common; // faces of every human and label in the segment
    for (const std::vector<double>& labels : m_faces_of_human)
      common.emplace_back(labels.size(), 0.);
    for (const Index i : m_greedy->memo()[segment].segment.nodes)
      for (const Share& share : m_shares[i])
        common[share.human][share.label] += share.faces;
    for (std::size_t h = 0; h < number_of_humans; ++h)
      apart[h] += pairs(std::accumulate(common[h].begin(), common[h].end(), 0.)) -
                  2 * sum_of_pairs(common[h]);
  }
  double sum = 0;
  for (std::size_t h = 0; h < number_of_humans; ++h)
    sum += apart[h] / pairs(std::accumulate(m_faces_of_human[h].begin(), m_faces_of_human[h].end(), 0.));
  return sum / double(number_of_humans);
}
