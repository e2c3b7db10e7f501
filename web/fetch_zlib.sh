#!/bin/sh
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Unpacks the source of zlib, which Emscripten has not, into FOLDER/zlib, and prints that name:
#
#   fetch_zlib.sh FOLDER
#
# It is Debian's source package, from the archive that this machine's own apt sources name. Nothing is installed, and neither
# the sources nor the package lists of the machine change. What FOLDER already holds is not fetched again.

set -eu

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
  command -v apt-get > /dev/null || fail "needs apt-get"
  release=$(. /etc/os-release && echo "$VERSION_CODENAME")
  # An entry of the sources may name the release by its suite or by its code name.
  uri=$(apt-get indextargets --format '$(COMPONENT) $(REPO_URI) $(RELEASE) $(CODENAME)' \
        | awk -v release="$release" '$1 == "main" && ($3 == release || $4 == release) { print $2; exit }')
  [ -n "$uri" ] || fail "the apt sources of this machine name no Debian archive"

  apt_folder=$folder/apt
  mkdir -p "$apt_folder/lists/partial" "$apt_folder/unpacked"
  keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  signed=
  [ ! -f "$keyring" ] || signed="[signed-by=$keyring]"
  echo "deb-src $signed $uri $release main" > "$apt_folder/sources.list"

  in_sources()
  {
    apt-get -q -o Dir::Etc::sourcelist="$apt_folder/sources.list" -o Dir::Etc::sourceparts=- \
            -o Dir::State::Lists="$apt_folder/lists" -o APT::Sandbox::User=root "$@" >&2
  }
  in_sources update || fail "cannot read the list of sources from $uri"
  (cd "$apt_folder" && in_sources source --download-only zlib) || fail "cannot download the source of zlib"
  tar -xf "$apt_folder"/zlib_*.orig.tar.* -C "$apt_folder/unpacked" --strip-components=1
  rm -rf "$folder/zlib"
  mv "$apt_folder/unpacked" "$folder/zlib" # at once: an interrupted run leaves no half of it
  rm -rf "$apt_folder"
fi
echo "$folder/zlib"
