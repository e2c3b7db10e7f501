// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Watches a segmentation: its progress, the histograms of each protrusion and the slot of its
// border. Stops it after five seconds.

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include "read_or_make_mesh.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Face = Mesh::Face_index;
using CGAL::Protrusion_segmentation::Protrusion;

class Watcher : public CGAL::Protrusion_segmentation::Segmentation_visitor<Mesh>
{
public:
  void on_progress(double share)
  {
    if (share < m_next_share)
      return;
    std::cout << "progress " << share << "\n";
    m_next_share = share + 0.1;
  }

  // a bar for every fourth slot: the number of faces at that distance from the tip
  void on_protrusion(const Protrusion<Face>& protrusion)
  {
    std::cout << "segment " << protrusion.segment << " with its tip at face " << protrusion.tip.idx() << "\n";
    const std::vector<std::size_t>& histogram = protrusion.distance_histogram;
    for (std::size_t slot = 0; slot < histogram.size(); slot += 4)
    {
      const std::size_t largest = *std::max_element(histogram.begin(), histogram.end());
      const std::size_t length = 60 * histogram[slot] / largest;
      const double diameter = protrusion.sectional_diameter_histogram[slot];
      std::cout << (slot / 4 == protrusion.border_slot.value() / 4 ? "border " : "       ")
                << std::string(length, '#') << "  diameter " << diameter << "\n";
    }
  }

  bool go_further() { return std::chrono::steady_clock::now() < m_end; }

private:
  double m_next_share = 0;
  std::chrono::steady_clock::time_point m_end =
    std::chrono::steady_clock::now() + std::chrono::seconds(5);
};

// protrusion_visitor_example [MESH]
int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!read_or_make_mesh(argc, argv, mesh))
    return EXIT_FAILURE;

  auto segments = mesh.add_property_map<Face, std::size_t>("f:segment").first;
  Watcher watcher;
  const CGAL::Protrusion_segmentation::Histogram_method method; // the one that has histograms
  try
  {
    const std::size_t number_of_segments = CGAL::segmentation_via_protrusion_tips(
      mesh, segments, 7, method, CGAL::parameters::visitor(std::ref(watcher)));
    std::cout << number_of_segments << " segments" << std::endl;
  }
  catch (const CGAL::Protrusion_segmentation::Segmentation_stopped&)
  {
    std::cout << "stopped, nothing is segmented" << std::endl;
  }
  return EXIT_SUCCESS;
}
