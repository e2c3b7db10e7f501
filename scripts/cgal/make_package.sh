#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make_package.sh FOLDER [CGAL_INCLUDE_FOLDER]
#
# Makes the tree that would be submitted to CGAL, in the layout of its branches:
#
#   FOLDER/Protrusion_segmentation/                                    the package, with headers in CGAL's form
#   FOLDER/Installation/include/CGAL/license/Protrusion_segmentation.h as CGAL generates it for a package under the GPL
#
# FOLDER must not exist or be empty. The header of the license is made from another package's in CGAL_INCLUDE_FOLDER
# (default: /usr/include), and is the same from CGAL 5.5 and from CGAL 6. What is left to do by
# hand is in scripts/cgal/for_maintainers.md.

set -euo pipefail
name=Protrusion_segmentation
title="Protrusion-Based Surface Mesh Segmentation"
authors="The Protrusion_segmentation authors"

fail()
{
  echo "make_package.sh: $1" >&2
  exit 1
}

[ $# = 1 ] || [ $# = 2 ] || { echo "usage: make_package.sh FOLDER [CGAL_INCLUDE_FOLDER]" >&2; exit 2; }
template=${2:-/usr/include}/CGAL/license/Surface_mesh_segmentation.h
[ -f "$template" ] || fail "there is no $template to make the header of the license from"
[ ! -e "$1" ] || [ -z "$(ls -A "$1")" ] || fail "$1 is not empty"
mkdir -p "$1"
folder=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."

mkdir "$folder/$name"
cp -r include "$folder/$name/"
for part in test examples doc benchmark package_info; do
  mkdir "$folder/$name/$part"
  cp -r "$part/$name" "$folder/$name/$part/"
done

# A header begins with its copyright and SPDX lines, and maybe with a comment after these; its include guard comes before
# all else.
cgal_header()
{
  awk -v name="$name" -v authors="$authors" '
    NR == 1 {
      copyright = $0
      sub(/ All rights reserved\.$/, "", copyright)
      print copyright "\n// All rights reserved.\n//\n// This file is part of CGAL (www.cgal.org).\n//"
      print "// $" "URL$\n// $" "Id$"
      next
    }
    NR == 2 { next }
    /^\/\/ SPDX/ { print $0 "\n//\n// Author(s)     : " authors; next }
    { print }
    /^#define CGAL_.*_H$/ && !done { print "\n#include <CGAL/license/" name ".h>"; done = 1 }
    END { if (!done) exit 1 }' "$1"
}

find "$folder/$name/include" -name '*.h' | while read -r header; do
  cgal_header "$header" > "$header.new" || fail "$header has no include guard"
  mv "$header.new" "$header"
done

license=$folder/Installation/include/CGAL/license/$name.h
mkdir -p "$(dirname "$license")"
other=Surface_mesh_segmentation
other_title=$(sed -nE 's/.*this release of the (.*) package\.".*/\1/p' "$template")
[ -n "$other_title" ] || fail "$template has another form than it used to have"
sed -e '/\$URL/s/.*/\/\/ $URL$/' -e '/\$Id/s/.*/\/\/ $Id$/' -e "s/$other/$name/g" -e "s/${other^^}/${name^^}/g" \
    -e "s/$other_title/$title/g" \
    -e 's#CGAL/licence/README#CGAL/license/README#' "$template" > "$license"

find "$folder" -type d -exec chmod 755 {} +
find "$folder" -type f -exec chmod 644 {} +
