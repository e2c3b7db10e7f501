#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_cgal_package.sh WORK_FOLDER CGAL_INCLUDE_FOLDER
#
# The folders that CGAL takes are as CGAL wants them, here and in the tree that would be submitted; and the script that says
# so finds what is wrong: it is shown one mistake after the other.

set -uo pipefail
work=$1 cgal=$2
root=$(cd "$(dirname "$0")/.." && pwd)
check=$root/scripts/cgal/check_package.sh
failures=0

fail()
{
  echo "test_cgal_package.sh: $1" >&2
  failures=$((failures + 1))
}

"$check" "$root" "$cgal" || fail "this repository is not as CGAL wants it"
rm -rf "$work"
"$root/scripts/cgal/make_package.sh" "$work/tree" "$cgal" || fail "the tree is not made"
package=$work/tree/Protrusion_segmentation
"$check" "$package" "$cgal" || fail "the tree is not as CGAL wants it"
"$root/scripts/cgal/make_package.sh" "$work/tree" "$cgal" 2>/dev/null && fail "a tree is written over"
license=$work/tree/Installation/include/CGAL/license/Protrusion_segmentation.h
grep -q CGAL_PROTRUSION_SEGMENTATION_COMMERCIAL_LICENSE "$license" || fail "there is no header of the license"
grep -q "see include/CGAL/license/README.md" "$license" || fail "the header of the license names another README.md than CGAL 6 has"
grep -qi "surface_mesh_segmentation" "$license" && fail "the header of the license names another package"
[ "$(ls "$work/tree")" = "$(printf 'Installation\nProtrusion_segmentation')" ] || fail "there is more in the tree"

# shows MESSAGE COMMAND: after COMMAND in the package, MESSAGE is what is wrong, and nothing else is.
shows()
{
  local message=$1 output
  shift
  rm -rf "$work/wrong"
  cp -r "$package" "$work/wrong"
  (cd "$work/wrong" && "$@") || fail "'$*' does not work"
  output=$("$check" "$work/wrong" "$cgal" 2>/dev/null) && fail "'$*' is not found"
  grep -q "^$message: " <<<"$output" || fail "'$*' is not called '$message', but: $output"
  [ "$(wc -l <<<"$output")" = 1 ] || fail "'$*' is more than one mistake: $output"
}

append() { printf "$2" >> "$1"; }
shell() { bash -c "$1"; }

header=include/CGAL/segmentation_metrics.h
test=test/Protrusion_segmentation/test_SEG.cpp
shows "CGAL has no such file" touch test/Protrusion_segmentation/run.sh
shows "CGAL has no such file" cp doc/Protrusion_segmentation/dependencies doc/CMakeLists.txt
shows "is missing or empty" truncate -s 0 package_info/Protrusion_segmentation/description.txt
shows "is executable" chmod +x $header
shows "is not UTF-8" append $test '// \344\n'
shows "a tab" append $test '\t// x\n'
shows "a blank at the end of a line" append $test '// x \n'
shows "has no line end at its end" append $test '// x'
shows "min or max without ( )" append $test 'int m = std::max(1, 2);\n'
shows "min or max without ( )" append $test '/* x */\nint m = std::numeric_limits<int>::max(); // a "string"\n'
shows "min or max without ( )" append $test 'const char* s = "// x"; int m = generator.max();\n'
shows "a macro that does not begin with CGAL_" sed -i '$i#define MINE' $header
shows "has not its include guard" sed -i '0,/^#ifndef CGAL_/s//#ifndef CGAL_X/' $header
shows "has no copyright line" sed -i '1s/.*/\/\//' $test
shows "has no SPDX line" sed -i '/SPDX/d' $test
shows "has no line .// This file is part of CGAL.*" sed -i '/This file is part of CGAL/d' $header
shows "has no line .#include <CGAL/license.*" sed -i '/CGAL\/license/d' $header
shows "is not named in test.*" sed -i 's/"two_translation_units.second_unit.cpp"//' test/Protrusion_segmentation/CMakeLists.txt
shows "does not exist, but is named in test.*" \
  append test/Protrusion_segmentation/CMakeLists.txt 'create_single_source_cgal_program("test_x.cpp")\n'
shows "does not begin with cmake_minimum_required" sed -i '/^cmake_minimum_required/d' examples/Protrusion_segmentation/CMakeLists.txt
shows "has another project" sed -i 's/_Benchmark)/)/' benchmark/Protrusion_segmentation/CMakeLists.txt
shows "makes targets of dashboards in all of CGAL" \
  append examples/Protrusion_segmentation/CMakeLists.txt 'include(CTest)\n'
shows "has no .cpp file itself" shell 'cd benchmark/Protrusion_segmentation && mv kernel_benchmark.cpp Quality/ &&
  sed -i "s/\"kernel_benchmark/\"Quality\/kernel_benchmark/" CMakeLists.txt'
shows "is not in examples.txt" sed -i 1d doc/Protrusion_segmentation/examples.txt
shows "all_public_headers.h disagrees about" \
  sed -i '/IO.SEG/d' test/Protrusion_segmentation/include/all_public_headers.h
shows "a named parameter that CGAL does not have" sed -i '0,/cgalParamNBegin{[a-z_]*}/s//cgalParamNBegin{vertex_point_mop}/' \
  include/CGAL/Protrusion_segmentation/segmentation_via_protrusion_tips.h
shows "dependencies" append package_info/Protrusion_segmentation/dependencies 'AABB_tree\n'
[ $failures = 0 ]
