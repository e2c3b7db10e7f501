#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# compute_dependencies.sh [CGAL_INCLUDE_FOLDER]
#
# Prints what package_info/Protrusion_segmentation/dependencies should hold: the packages of CGAL whose headers the
# headers of this package include, with Eigen and TBB, and itself. To which package a header belongs is said in its
# first lines. Needs g++, Eigen and TBB. To be called with the CGAL that the package is meant for: releases
# differ.

set -euo pipefail
cgal=${1:-/usr/include}
include=$(cd "$(dirname "$0")/../../include" && pwd)
options=(-std=c++17 -M -x c++ -I "$include" -isystem /usr/include/eigen3 -DCGAL_EIGEN3_ENABLED -DCGAL_LINKED_WITH_TBB)
[ "$cgal" = /usr/include ] || options+=(-isystem "$cgal")

headers=$(cd "$include" && find . -name '*.h' -printf '#include <%P>\n' | sort)
files=$(g++ "${options[@]}" - <<<"$headers" | tr -s ' \\' '\n\n' | grep -F "$cgal/CGAL/" | sort -u)
[ -n "$files" ] || { echo "compute_dependencies.sh: $cgal has no headers of CGAL" >&2; exit 1; }
{
  echo Protrusion_segmentation
  xargs sed -nE 's#.*\$URL: [^ ]*/blob/[^/]*/([^/]*)/.*#\1#p' <<<"$files"
} | LC_ALL=C sort -u
