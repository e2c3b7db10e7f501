// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A baseline of spectral methods, in the way of
//
//   Rong Liu and Hao Zhang: Mesh Segmentation via Spectral Embedding and Contour Analysis. Computer Graphics Forum
//   26(3), 2007
//
// A segment is split along a level set of its Fiedler vector, the one with the least normalized cut; and of all
// segments the one with the least is split first, until there are as many as asked for. The article embeds the mesh by
// two matrices and chooses a cut by the salience of its parts; this is what is left without that.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SPECTRAL_CUTS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SPECTRAL_CUTS_H

#include "Segmentation_method.h"

#include <cstddef>

struct Spectral_cuts_options
{
  // Of the decimated mesh.
  std::size_t faces = 2000;
  // See `all_seams()`.
  double exponent = 10;
  // Segments with fewer faces are not cut.
  std::size_t least_faces = 8;
};

Labels spectral_cuts_segmentation(const Mesh& mesh,
                                  std::size_t number_of_segments,
                                  const Spectral_cuts_options& options = Spectral_cuts_options());

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SPECTRAL_CUTS_H
