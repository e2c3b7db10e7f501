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
# The archive is the one that this machine's own apt sources name. Nothing is installed, and
# neither the sources nor the package lists of the machine change. What FOLDER already holds is
# not fetched again.

set -eu

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
  command -v apt-get > /dev/null && command -v dpkg > /dev/null || fail "needs apt-get and dpkg"

  # An entry of the sources may name the release by its suite or by its code name.
  uri=$(apt-get indextargets --format '$(COMPONENT) $(REPO_URI) $(RELEASE) $(CODENAME)' \
        | awk -v release="$(. /etc/os-release && echo "$VERSION_CODENAME")" \
              '$1 == "main" && ($3 == release || $4 == release) { print $2; exit }')
  [ -n "$uri" ] || fail "the apt sources of this machine name no Debian archive"

  apt_folder=$folder/apt
  mkdir -p "$apt_folder/lists/partial" "$apt_folder/cache/archives/partial"
  keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  signed=
  [ ! -f "$keyring" ] || signed="[signed-by=$keyring]"
  echo "deb $signed $uri $suite main" > "$apt_folder/sources.list"

  in_suite()
  {
    apt-get -q -o Dir::Etc::sourcelist="$apt_folder/sources.list" -o Dir::Etc::sourceparts=- \
            -o Dir::State::Lists="$apt_folder/lists" -o Dir::Cache="$apt_folder/cache" \
            -o APT::Sandbox::User=root "$@" >&2
  }
  in_suite update || fail "cannot read the package lists of $suite from $uri"
  (cd "$apt_folder" && in_suite download "$package" "$@") || fail "cannot download $package of $suite"
  for archive in "$apt_folder"/*.deb
  do
    dpkg -x "$archive" "$apt_folder/unpacked"
  done
  mv "$apt_folder/unpacked/usr" "$folder/usr" # at once: an interrupted run leaves no half of it
  rm -rf "$apt_folder"
fi

[ -n "$(cgal_dir)" ] || fail "$package of $suite holds no CGALConfig.cmake"
cgal_dir
