#!/bin/sh
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# fetch_cgal_6.sh FOLDER [SUITE [PACKAGE...]]
#
# Unpacks the headers of CGAL 6 from another Debian release into a folder, beside the installed
# CGAL, and prints the value for CMake's CGAL_DIR:
#
#   cmake -DCGAL_DIR="$(fetch_cgal_6.sh FOLDER)" ...
#
# SUITE is trixie by default, the release after bookworm, with CGAL 6.0.1. Further packages of CGAL
# from there are unpacked besides.
#
# The archive is that of debian_archive.sh. What FOLDER already holds is not fetched again.

set -eu
. "$(dirname "$0")/debian_archive.sh"

package=libcgal-dev

fail()
{
  echo "fetch_cgal_6.sh: $1" >&2
  exit 1
}

[ $# -ge 1 ] || { echo "usage: fetch_cgal_6.sh FOLDER [SUITE [PACKAGE...]]" >&2; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
suite=${2:-trixie}
[ $# -le 2 ] && shift $# || shift 2

# The folder under lib/ is named after the machine's architecture.
cgal_dir()
{
  for config in "$folder"/usr/lib/*/cmake/CGAL/CGALConfig.cmake
  do
    [ ! -f "$config" ] || dirname "$config"
  done
}

if [ -z "$(cgal_dir)" ]
then
  [ ! -e "$folder/usr" ] || fail "$folder/usr exists and holds no CGAL"
  command -v dpkg > /dev/null || fail "needs dpkg"
  use_archive deb "$suite" "$folder/apt"
  in_archive download "$package" "$@" || fail "cannot download $package of $suite"
  for archive in "$apt_folder"/*.deb
  do
    dpkg -x "$archive" "$apt_folder/unpacked"
  done
  mv "$apt_folder/unpacked/usr" "$folder/usr" # at once: an interrupted run leaves no half of it
  rm -rf "$apt_folder"
fi

[ -n "$(cgal_dir)" ] || fail "$package of $suite holds no CGALConfig.cmake"
cgal_dir
