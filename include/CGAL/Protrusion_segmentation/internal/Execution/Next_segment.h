// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_NEXT_SEGMENT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_NEXT_SEGMENT_H

#include <CGAL/Protrusion_segmentation/Execution.h>

#include <cstddef>
#include <optional>

namespace CGAL::Protrusion_segmentation::internal {

// One step of a call that looks for segments: while it lives, progress is that from `found` segments to one
// more. With no number asked for, the share grows with every segment and never gets to 1.
class Next_segment : public Execution::Subtask
{
public:
  Next_segment(Execution& execution, std::size_t found, std::optional<std::size_t> requested)
    : Execution::Subtask(execution, share(found, requested), share(found + 1, requested))
  {
    execution.progress(0);
  }

private:
  static double share(std::size_t found, std::optional<std::size_t> requested)
  {
    const double n = static_cast<double>(found);
    return requested ? n / static_cast<double>(*requested) : n / (n + 1);
  }
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_NEXT_SEGMENT_H
