// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "methods.h"

#include "ablation_methods.h"
#include "peers.h"
#include "protrusion_methods.h"
#include "sdf_methods.h"

namespace {

void append(std::vector<Segmentation_method>& all, const std::vector<Segmentation_method>& some)
{
  all.insert(all.end(), some.begin(), some.end());
}

} // namespace

std::vector<Segmentation_method> all_methods()
{
  std::vector<Segmentation_method> all = protrusion_methods();
  append(all, ablation_methods());
  append(all, remeshed_methods());
  append(all, sdf_methods());
  append(all, clustering_methods());
  return all;
}
