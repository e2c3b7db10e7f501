# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every header in quotation marks is there. Not all programs are compiled by the tests: some need further libraries."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ["benchmark", "examples", "include", "integration_test", "python", "test", "tools", "web"]
# Where headers are looked for beside the folder of the file.
INCLUDE_FOLDERS = [ROOT / folder for folder in ("tools", "python/source", "web", "test/Protrusion_segmentation/include",
                                                "benchmark/Protrusion_segmentation/Quality")]
GENERATED = {"report_page.h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def is_there(file, header):
    return header in GENERATED or any((folder / header).is_file() for folder in [file.parent, *INCLUDE_FOLDERS])


files = [file for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*")) if file.suffix in {".h", ".cpp"}]
missing = [f"{file.relative_to(ROOT)}: there is no {header}"
           for file in files for header in INCLUDE.findall(file.read_text(encoding="utf-8")) if not is_there(file, header)]
if missing or not files:
    sys.exit("\n".join(missing) or "there are no files")
print(f"{len(files)} files include headers that are there")
