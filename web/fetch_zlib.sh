#!/bin/sh
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Unpacks the source of zlib, which Emscripten has not, into FOLDER/zlib, and prints that name:
#
#   fetch_zlib.sh FOLDER
#
# It is Debian's source package, from the archive of scripts/debian_archive.sh. What FOLDER already holds is not fetched again.

set -eu
. "$(dirname "$0")/../scripts/debian_archive.sh"

fail()
{
  echo "fetch_zlib.sh: $1" >&2
  exit 1
}

[ $# -eq 1 ] || { echo "usage: fetch_zlib.sh FOLDER" >&2; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)

if [ ! -f "$folder/zlib/zlib.h" ]
then
  use_archive deb-src "$(release_of_machine)" "$folder/apt"
  in_archive source --download-only zlib || fail "cannot download the source of zlib"
  mkdir -p "$apt_folder/unpacked"
  tar -xf "$apt_folder"/zlib_*.orig.tar.* -C "$apt_folder/unpacked" --strip-components=1
  rm -rf "$folder/zlib"
  mv "$apt_folder/unpacked" "$folder/zlib" # at once: an interrupted run leaves no half of it
  rm -rf "$apt_folder"
fi
echo "$folder/zlib"
