#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_lab_plugin.sh WORK_FOLDER [SUITE]
#
# Builds CGAL Lab of a Debian release, by default trixie, with the plugin in lab/, starts it on a virtual screen with a mesh, and
# sees that the plugin is loaded and its dialog can be opened. Needs Qt 6, xvfb and Mesa. It takes some six minutes of processor
# time.

set -euo pipefail
[ $# -ge 1 ] || { echo "usage: test_lab_plugin.sh WORK_FOLDER [SUITE]" >&2; exit 2; }
root=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$1"
work=$(cd "$1" && pwd)
cgal_dir=$("$root/scripts/fetch_cgal_6.sh" "$work/cgal" "${2:-trixie}" libcgal-demo libcgal-qt6-dev)

rm -rf "$work/demo"
tar -C "$work" -xzf "$work/cgal/usr/share/doc/libcgal-demo/demo.tar.gz" demo/Lab
ln -s "$root/lab/Protrusion_segmentation" "$work/demo/Lab/Plugins/"
# shellcheck disable=SC2086 # the options are words
cmake -S "$work/demo/Lab" -B "$work/build" -G Ninja -DCGAL_DIR="$cgal_dir" -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" ${CMAKE_OPTIONS:-}
cmake --build "$work/build" -j "${JOBS:-$(nproc)}" --target CGALlab off_plugin protrusion_segmentation_plugin

# The Lab runs autostart.js of the folder in which it is started. It opens what all plugins have for the mesh.
cat > "$work/autostart.js" <<JS
main_window.open("$root/integration_test/data/tetrahedron.off");
main_window.test_all_actions();
JS
cd "$work"
LIBGL_ALWAYS_SOFTWARE=1 LAB_DEMO_PLUGINS_PATH=$work/build/Plugins/IO:$work/build/Plugins/Protrusion_segmentation \
  timeout --preserve-status -k 10 60 xvfb-run -a "$work/build/CGALlab" > lab.log 2>&1 || true
grep -q 'Testing.*Protrusion Segmentation' lab.log || { cat lab.log; echo "test_lab_plugin.sh: the plugin is not loaded" >&2; exit 1; }
echo "CGAL Lab has the plugin"
