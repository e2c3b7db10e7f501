// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program calls in the worker.

mergeInto(LibraryManager.library, {
  page_progress: function(share, stage, protrusions)
  {
    if (Module["onProgress"])
      Module["onProgress"](share, UTF8ToString(stage), protrusions);
  },
  page_warning: function(warning)
  {
    if (Module["onWarning"])
      Module["onWarning"](UTF8ToString(warning));
  }
});
