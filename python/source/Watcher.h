// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_WATCHER_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_WATCHER_H

#include "reading/Mesh.h"

#include <CGAL/Protrusion_segmentation/Segmentation_record.h>

#include <functional>
#include <utility>

namespace python {

// Keeps what a call finds, is told of its progress, and stops it.
class Watcher : public CGAL::Protrusion_segmentation::Segmentation_record<tool::Mesh>
{
public:
  explicit Watcher(std::function<bool()> go_further, std::function<void(double)> progress = {})
    : m_go_further(std::move(go_further)),
      m_progress(std::move(progress))
  {}

  bool go_further() { return m_go_further(); }
  void on_progress(double share)
  {
    if (m_progress)
      m_progress(share);
  }

private:
  std::function<bool()> m_go_further;
  std::function<void(double)> m_progress;
};

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_WATCHER_H
