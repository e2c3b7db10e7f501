#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_headers.sh public|all [OPTION...]
#
# Every header compiles alone, and twice in a row, without a warning: without Eigen, Spectra and TBB, as CGAL checks it, or
# with what OPTIONs for the compiler, CXX, by default g++, name. Together they compile where the words of Qt are macros.

set -euo pipefail
which=${1:?usage: check_headers.sh public|all [OPTION...]}
shift
cd "$(dirname "$0")/../../include"
headers=$(find CGAL -name '*.h' | LC_ALL=C sort)
[ "$which" = all ] || headers=$(grep -v /internal/ <<<"$headers")

# The header comes as lines of a file, not as the file itself: of that `#pragma once` and others would complain.
xargs -P "${JOBS:-$(nproc)}" -I '{}' bash -c '
  header=$1
  shift
  printf "#include <%s>\n" "$header" "$header" | "$@" -std=c++17 -fsyntax-only -Wall -Wextra -Werror -I . -x c++ - ||
    { echo "check_headers.sh: $header does not compile alone" >&2; exit 1; }' _ '{}' "${CXX:-g++}" "$@" <<<"$headers"
# Qt defines these unless QT_NO_KEYWORDS is set.
sed 's/.*/#include <&>/' <<<"$headers" |
  "${CXX:-g++}" "$@" -std=c++17 -fsyntax-only -Wall -Wextra -Werror -I . -x c++ - \
    -Dslots= -Demit= -Dsignals=public '-Dforeach(variable,range)=for (variable : range)' ||
  { echo "check_headers.sh: the headers do not compile where slots, emit, signals and foreach are macros" >&2; exit 1; }
echo "$(wc -l <<<"$headers") headers compile alone, and together with the macros of Qt${*:+; with $*}"
