#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# measure_coverage.sh BUILD_FOLDER
#
# Runs the test programs of a build with the preset `coverage` and prints which share of the lines of the package's
# headers they reach, then the lines that none reaches.

set -euo pipefail
build=$(cd "$1" && pwd)
folder=$build/test/Protrusion_segmentation
cd "$(dirname "$0")/.."
include=$(cd include && pwd)
profiles=$folder/profiles
rm -rf "$profiles"
mkdir "$profiles"
objects=()
for program in "$folder"/test_*; do
  [ -f "$program" ] && [ -x "$program" ] || continue
  echo "running $(basename "$program")" >&2
  (cd test/Protrusion_segmentation && LLVM_PROFILE_FILE=$profiles/$(basename "$program").profraw "$program" >/dev/null)
  objects+=(-object "$program")
done
for name in fuzz_seg_replay fuzz_mesh_replay; do
  if [ -x "$build/integration_test/$name" ]; then
    LLVM_PROFILE_FILE=$profiles/$name.profraw "$build/integration_test/$name" \
        integration_test/data integration_test/fuzz/corpus >/dev/null
    objects+=(-object "$build/integration_test/$name")
  fi
done
llvm-profdata merge -sparse "$profiles"/*.profraw -o "$profiles/all.profdata"
# the first program is no option: llvm-cov would take the folder of the headers for it
llvm-cov export -format=lcov -instr-profile "$profiles/all.profdata" "${objects[@]:1}" "$include" 2>/dev/null |
  awk -F'[:,]' -v prefix="$include/" '
    /^SF:/ { file = substr($0, 4); sub(prefix, "", file) }
    /^DA:/ { key = file ":" $2; if (!(key in count)) { order[++n] = key; count[key] = 0 } count[key] += $3 }
    END {
      for (i = 1; i <= n; ++i) {
        split(order[i], part, ":")
        ++lines[part[1]]
        if (count[order[i]] > 0) ++reached[part[1]]; else missing[part[1]] = missing[part[1]] " " part[2]
      }
      for (file in lines) { all += lines[file]; hit += reached[file] }
      printf "%.1f %% of %d lines\n\n", 100 * hit / all, all
      for (file in missing) printf "%s: %d of %d, without:%s\n", file, reached[file], lines[file], missing[file]
    }'
