// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the page calls: segment_by_protrusions and make_example_mesh without a command line. Files are those of the working
// folder. All functions return JSON, which is valid until the next call: {"error": "a message of the tool"}, or what is said
// below.

#ifndef PROTRUSION_SEGMENTATION_WEB_PROGRAM_H
#define PROTRUSION_SEGMENTATION_WEB_PROGRAM_H

extern "C" {
// Is called by the others: the share that is done, from 0 to 1, the stage, and the number of protrusions so far.
void page_progress(double share, const char* stage, int number_of_protrusions);
void page_warning(const char* warning);

// {"version": "1.0", "methods": [{"name": "paper", "description": "..."}, ...], "distances": [...], "formats": "off, obj, ...",
// "examples": ["octopus", ...]}
const char* page_about();

// `shape` is one of the examples; its mesh of so many faces becomes a file: {"file": "octopus.off"}
const char* page_make_example(const char* shape, int number_of_faces);

// `words` is an array of strings in JSON, the command line of segment_by_protrusions: {"data": what the page of --report shows}
const char* page_segment(const char* words);

// Writes what page_segment() found last. `request` is an object in JSON:
//   "words": the same command line, with outputs; all of them are in the folder `out`
//   "joined": protrusions that are given to what they stick out of
//   "names": the names of the segments that are left, empty for those without
//   "archive": the name of a ZIP archive in the folder that takes the place of all files; empty for none
// Returns {"files": [the names of the files in the folder]}.
const char* page_write(const char* request);
}

#endif // PROTRUSION_SEGMENTATION_WEB_PROGRAM_H
