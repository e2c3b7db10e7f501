// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of --report shows the data that are in it.

"use strict";

try
{
  window.report = new Report(new Model(JSON.parse(document.getElementById("data").textContent)));
}
catch (error)
{
  document.getElementById("hint").textContent = `The mesh cannot be shown: ${error.message}`;
}
