#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pages of concepts, which Doxygen takes for classes, say that they are concepts.

    scripts/manual/finish_concepts.py FOLDER

FOLDER is the HTML output of Doxygen. There is no header to include for a concept. In CGAL's tree, CGAL's own
scripts do this.
"""

import pathlib
import re
import sys

CONCEPTS = pathlib.Path(__file__).resolve().parents[2] / "doc/Protrusion_segmentation/Concepts"
INCLUDE = re.compile(r"<p><code>#include [^\n]*</code></p>\n")

for concept in CONCEPTS.glob("*.h"):
    page = pathlib.Path(sys.argv[1]) / f"class{concept.stem}.html"
    text = INCLUDE.sub("", page.read_text(encoding="utf-8"))
    page.write_text(text.replace("Class Reference", "Concept Reference"), encoding="utf-8")
