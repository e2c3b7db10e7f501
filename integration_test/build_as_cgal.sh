#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# build_as_cgal.sh FOLDER BUILD_FOLDER CGAL_DIR [PROGRAM...]
#
# Configures one of the folders that CGAL takes alone, as CGAL does, with nothing but the CGAL whose CGALConfig.cmake is
# in CGAL_DIR; builds the programs, or all, and runs those of them that are tests by ctest. CMAKE_OPTIONS in the
# environment holds further options for CMake.

set -euo pipefail
[ $# -ge 3 ] || { echo "usage: build_as_cgal.sh FOLDER BUILD_FOLDER CGAL_DIR [PROGRAM...]" >&2; exit 2; }
folder=$1 build=$2 cgal_dir=$3
shift 3
jobs=${JOBS:-$(nproc)}

# With -O1: CGAL's default takes twice as long to compile.
# shellcheck disable=SC2086 # the options are words
cmake -S "$folder" -B "$build" -G Ninja -DCGAL_DIR="$cgal_dir" -DBUILD_TESTING=ON -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" ${CMAKE_OPTIONS:-}
if [ $# = 0 ]; then
  cmake --build "$build" -j "$jobs"
  ctest --test-dir "$build" --output-on-failure
else
  cmake --build "$build" -j "$jobs" --target "$@"
  # The names are execution___of__... in CGAL 5 and "execution   of  ..." in CGAL 6.
  ctest --test-dir "$build" --output-on-failure --no-tests=error \
        --tests-regex "^execution[_ ]+of[_ ]+($(IFS='|'; echo "$*"))\$"
fi
