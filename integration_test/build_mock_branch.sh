#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# build_mock_branch.sh WORK_FOLDER CGAL_DIR [PROGRAM...]
#
# Makes the tree that would be submitted, beside it an installed CGAL in the layout of CGAL's branches, a folder with
# include/ and package_info/ for each package, and builds and runs examples and tests in it. PROGRAM: only these tests.

set -euo pipefail
[ $# -ge 2 ] || { echo "usage: build_mock_branch.sh WORK_FOLDER CGAL_DIR [PROGRAM...]" >&2; exit 2; }
work=$1 cgal_dir=$2
shift 2
root=$(cd "$(dirname "$0")/.." && pwd)
include=$(cd "$cgal_dir/../../../.." && pwd)/include # CGAL_DIR is usr/lib/<architecture>/cmake/CGAL
[ -f "$include/CGAL/config.h" ] || { echo "build_mock_branch.sh: $include has no CGAL" >&2; exit 1; }

rm -rf "$work"
"$root/scripts/cgal/make_package.sh" "$work/branch" "$include"
work=$(cd "$work" && pwd)
branch=$work/branch
"$root/scripts/cgal/check_package.sh" "$branch/Protrusion_segmentation" "$include"

# By these folders CGALConfig.cmake knows a branch.
mkdir -p "$branch/Installation/package_info/Installation" "$branch/Installation/lib/cmake" "$branch/Installation/cmake"
mkdir -p "$branch/All_other_packages/package_info" "$branch/All_other_packages/include"
cp -r "$cgal_dir" "$branch/Installation/lib/cmake/CGAL"
cp -r "$cgal_dir" "$branch/Installation/cmake/modules"
rm -f "$branch"/Installation/lib/cmake/CGAL/CGALConfig-installation-dirs.cmake
ln -s "$include/CGAL" "$branch/All_other_packages/include/CGAL"

for folder in examples test; do
  programs=()
  [ $folder = examples ] || programs=("$@")
  "$root/integration_test/build_as_cgal.sh" "$branch/Protrusion_segmentation/$folder/Protrusion_segmentation" "$work/$folder" \
    "$branch/Installation/lib/cmake/CGAL" ${programs[@]+"${programs[@]}"}
  grep -q "^CGAL_DIR:[A-Z]*=$branch/Installation" "$work/$folder/CMakeCache.txt"
done
