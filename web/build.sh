#!/bin/sh
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the page that segments:
#
#   web/build.sh [FOLDER]
#
# FOLDER is build/web without one; the page is FOLDER/segment.html. README.md says which packages are needed.

set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "${1:-$root/build/web}"
folder=$(cd "${1:-$root/build/web}" && pwd)

if command -v ccache > /dev/null
then
  export EM_COMPILER_WRAPPER=ccache
fi
export NODE_PATH=/usr/share/nodejs # where Debian's modules are, for a node that is not Debian's
zlib=$("$root/web/fetch_zlib.sh" "$folder")
emcmake cmake -S "$root/web" -B "$folder/program" -G Ninja -DZLIB_SOURCE="$zlib"
cmake --build "$folder/program"
cp "$folder/program/segment.html" "$folder/segment.html"
echo "$folder/segment.html"
