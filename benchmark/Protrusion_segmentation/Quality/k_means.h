// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's baseline, after
//
//   Shymon Shlafman, Ayellet Tal and Sagi Katz: Metamorphosis of Polyhedral Surfaces using
//   Decomposition. Computer Graphics Forum 21(3), 2002
//
// with the distance between faces that the paper gives in its section II.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_K_MEANS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_K_MEANS_H

#include "Segmentation_method.h"

#include <cstddef>

struct K_means_options
{
  // Weight of the distance of centroids against that of the dihedral angle, in (0, 1]; `delta` of
  // the paper, which gives no value.
  double delta = 0.5;
  // Most rounds of choosing representatives and assigning faces anew.
  std::size_t iterations = 20;
  // Faces of a patch from which the one in its middle is estimated.
  std::size_t samples = 10;
};

Labels k_means_segmentation(const Mesh& mesh, std::size_t number_of_segments, unsigned int seed,
                            const K_means_options& options = K_means_options());

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_K_MEANS_H
