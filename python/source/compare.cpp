// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare.h"

#include <CGAL/segmentation_metrics.h>

#include <boost/property_map/property_map.hpp>

namespace python {
namespace {

namespace PS = CGAL::Protrusion_segmentation;

template <typename Map>
PS::Segmentation_metrics compare(const tool::Mesh& mesh,
                                 const Map& labels,
                                 const Map& reference,
                                 const std::string& metrics)
{
  if (metrics == "all")
    return PS::segmentation_metrics(mesh, labels, reference);
  PS::Segmentation_metrics result;
  if (metrics == "rand_index_error")
    result.rand_index_error = PS::segmentation_rand_index_error(mesh, labels, reference);
  else if (metrics == "hamming_distance")
    result.hamming_distance = PS::segmentation_hamming_distance(mesh, labels, reference);
  else if (metrics == "cut_discrepancy")
    result.cut_discrepancy = PS::segmentation_cut_discrepancy(mesh, labels, reference);
  else if (metrics == "mean_best_intersection_over_union")
    result.mean_best_intersection_over_union = PS::mean_best_intersection_over_union(mesh, labels,
                                                                                     reference);
  else
    result.consistency_error = PS::segmentation_consistency_error(mesh, labels, reference);
  return result;
}

} // namespace

std::vector<PS::Segmentation_metrics> compare(const Arrays& arrays,
                                              const std::vector<std::int64_t>& labels,
                                              const std::vector<std::vector<std::int64_t>>& references,
                                              const std::string& metrics)
{
  const tool::Input_mesh input = mesh_of_arrays(arrays);
  const auto face_index = get(boost::face_index, input.mesh);
  const std::vector<std::int64_t> ids = labels_of_mesh(labels, input, "labels");
  std::vector<PS::Segmentation_metrics> result;
  for (const std::vector<std::int64_t>& reference : references)
  {
    const std::vector<std::int64_t> others = labels_of_mesh(reference, input, "reference");
    result.push_back(compare(input.mesh, boost::make_iterator_property_map(ids.begin(), face_index),
                             boost::make_iterator_property_map(others.begin(), face_index), metrics));
  }
  return result;
}

} // namespace python
