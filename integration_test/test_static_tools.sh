#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_static_tools.sh BUILD_FOLDER
#
# Builds the tools with static libraries, and runs them in a root folder that holds nothing else: no library, no locale, no
# environment. As root, for chroot.

set -euo pipefail
[ $# = 1 ] || { echo "usage: test_static_tools.sh BUILD_FOLDER" >&2; exit 2; }
cd "$(dirname "$0")/.."
cmake --preset static-tools -B "$1"
cmake --build "$1"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for tool in make_example_mesh segment_by_protrusions evaluate_segmentation; do
  if readelf -d "$1/tools/$tool" | grep NEEDED; then
    echo "test_static_tools.sh: $tool needs a library" >&2
    exit 1
  fi
  strip -o "$folder/$tool" "$1/tools/$tool"
done
in_folder() { env -i "$(command -v chroot)" "$folder" "$@"; }
in_folder /make_example_mesh octopus octopus.off
in_folder /segment_by_protrusions octopus.off -k 9 -o octopus.ply -o octopus.glb -o octopus.seg --report octopus.html
in_folder /evaluate_segmentation octopus.off octopus.seg octopus.seg
ls -l "$folder"
