#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_package.sh FOLDER [CGAL_INCLUDE_FOLDER]
#
# What CGAL's scripts check in every package, for the folders of FOLDER that CGAL takes: those of this repository,
# or of a tree that make_package.sh made (its folder Protrusion_segmentation, whose headers have CGAL's form). Prints all
# that is wrong, and then fails.

set -uo pipefail
[ $# = 1 ] || [ $# = 2 ] || { echo "usage: check_package.sh FOLDER [CGAL_INCLUDE_FOLDER]" >&2; exit 2; }
cgal=${2:-/usr/include}/CGAL
cd "$1" || exit 1
name=Protrusion_segmentation
failures=$(mktemp)
trap 'rm -f "$failures"' EXIT

# Fails for every line of the input.
none()
{
  sed "s/^/$1: /" | tee -a "$failures"
}

parts=(include test examples doc benchmark package_info)
for part in "${parts[@]}"; do
  [ -d "$part" ] || echo "$part" | none "there is no folder"
done
mapfile -t files < <(find "${parts[@]}" -type f | LC_ALL=C sort)
mapfile -t code < <(printf '%s\n' "${files[@]}" | grep -E '\.(h|cpp)$')
mapfile -t headers < <(printf '%s\n' "${files[@]}" | grep -E '^include/.*\.h$')
mapfile -t texts < <(printf '%s\n' "${files[@]}" | grep -vE '\.(png|svg|jpg)$')
[ "${#headers[@]}" -gt 10 ] && [ "${#code[@]}" -gt 50 ] || echo "$PWD" | none "there are hardly any files in"

# Only what CGAL has in these folders, and in each but include/ only the folder of the package.
printf '%s\n' "${files[@]}" |
  grep -vxE "include/CGAL/(IO/SEG|protrusion_segmentation|segmentation_metrics)\.h|include/CGAL/$name/.*\.h" |
  grep -vxE "(test|examples|benchmark)/$name/(CMakeLists\.txt|([[:alnum:]_]+/)*[[:alnum:]_]+\.(cpp|h|md))|test/$name/data/.*" |
  grep -vxE "doc/$name/(Doxyfile\.in|PackageDescription\.txt|$name\.txt|dependencies|examples\.txt)" |
  grep -vxE "doc/$name/(fig/[[:alnum:]_]+\.(png|svg|jpg)|Concepts/[[:alnum:]]+\.h)" |
  grep -vxE "package_info/$name/(copyright|dependencies|description\.txt|license\.txt|long_description\.txt|maintainer)" |
  none "CGAL has no such file"
printf '%s\n' "${files[@]}" | tr '[:upper:]' '[:lower:]' | sort | uniq -d | none "names that differ by case only"
for file in test/$name/CMakeLists.txt examples/$name/CMakeLists.txt benchmark/$name/CMakeLists.txt \
  doc/$name/{Doxyfile.in,PackageDescription.txt,dependencies,examples.txt} \
  package_info/$name/{copyright,dependencies,description.txt,license.txt,long_description.txt,maintainer}; do
  [ -s "$file" ] || echo "$file" | none "is missing or empty"
done

find "${parts[@]}" -type f -perm /111 | none "is executable"
for file in "${texts[@]}"; do
  iconv -f UTF-8 -t UTF-8 "$file" >/dev/null 2>&1 || echo "$file" | none "is not UTF-8"
done
grep -nP '\t' "${texts[@]}" | none "a tab"
grep -nP '[ \t]$' "${texts[@]}" | none "a blank at the end of a line"
grep -nP '\r$' "${texts[@]}" | none "a DOS line end"
for file in "${texts[@]}"; do
  [ -z "$(tail -c 1 "$file")" ] || echo "$file" | none "has no line end at its end"
done

# On Windows min and max may be macros. Comments and strings are left out.
sed -E 's/"([^"\\]|\\.)*"/""/g; s://.*::' "${code[@]}" | sed '/\/\*/,/\*\//d' |
  grep -P '(^|[^\w.>])(std::|\w+::)*(min|max)\s*\(' | grep -vP '\(\s*[\w:<>]*(min|max)\s*\)\s*\(' | none "min or max without ( )"
grep -nE '^ *# *define' "${headers[@]}" | grep -vE '# *define +CGAL_' | none "a macro that does not begin with CGAL_"

for header in "${headers[@]}"; do
  guard=$(sed 's#^include/##; s#[/.]#_#g' <<<"${header^^}" | sed 's#^INCLUDE_##')
  [ "$(grep -cE "^#(ifndef|define) $guard\$" "$header")" = 2 ] || echo "$header: $guard" | none "has not its include guard"
  grep -qE "^#endif // $guard\$" <(tail -n 1 "$header") || echo "$header: $guard" | none "does not end its include guard"
done
grep -hE '^#ifndef CGAL_.*_H$' "${code[@]}" | sort | uniq -d | none "an include guard of two files"

for file in "${code[@]}"; do
  [[ $file == doc/* ]] && continue
  head -n 1 "$file" | grep -qE '^// Copyright \(c\) [0-9]{4}' || echo "$file" | none "has no copyright line"
  head -n 9 "$file" | grep -q '^// SPDX-License-Identifier: GPL-3.0-or-later' || echo "$file" | none "has no SPDX line"
done
if grep -q 'This file is part of CGAL' "${headers[0]}"; then # the form of CGAL
  for header in "${headers[@]}"; do
    for line in '// This file is part of CGAL (www.cgal.org).' '// $URL$' '// $Id$' '// Author(s)     : ' \
      "#include <CGAL/license/$name.h>"; do
      [ "$(grep -cF -- "$line" "$header")" = 1 ] || echo "$header: $line" | none "has not the line"
    done
  done
else
  grep -lE 'part of CGAL|CGAL/license' "${code[@]}" | none "says that it is part of CGAL"
fi

# Each .cpp belongs to a program that is named; each program has a line of its own.
for part in test examples benchmark; do
  find "$part/$name" -name '*.cpp' -printf '%P\n' | while read -r source; do
    grep -qF "\"$source\"" "$part/$name/CMakeLists.txt" || echo "$part/$name/$source" | none "is not named in CMakeLists.txt"
    [[ $source == */* ]] || grep -qE "^ *create_single_source_cgal_program\(\"$source\"" "$part/$name/CMakeLists.txt" ||
      echo "$part/$name/$source" | none "has no program"
  done
  grep -oE '"[^"]+\.cpp"' "$part/$name/CMakeLists.txt" | tr -d '"' | while read -r source; do
    [ -f "$part/$name/$source" ] || echo "$part/$name/$source" | none "does not exist, but is named in CMakeLists.txt"
  done
  [ "$(awk '!/^ *(#|$)/ { print; exit }' "$part/$name/CMakeLists.txt")" = 'cmake_minimum_required(VERSION 3.12...3.31)' ] ||
    echo "$part/$name/CMakeLists.txt" | none "does not begin with cmake_minimum_required"
done
for pair in test:Tests examples:Examples benchmark:Benchmark; do
  grep -qx "project(${name}_${pair#*:})" "${pair%:*}/$name/CMakeLists.txt" ||
    echo "${pair%:*}/$name/CMakeLists.txt" | none "has another project"
done

# The examples of the manual.
sed -n 's#^/// \\example ##p' doc/$name/examples.txt | while read -r example; do
  [ -f "examples/$example" ] || echo "$example" | none "is no example"
done
for example in examples/"$name"/*.cpp; do
  grep -qF "$name/$(basename "$example")" doc/$name/examples.txt || echo "$example" | none "is not in examples.txt"
done
grep -hoE '#include <CGAL/[^>]*>' test/$name/include/all_public_headers.h | sort >"$failures.listed"
printf '%s\n' "${headers[@]}" | grep -v /internal/ | sed -E 's#^include/(.*)#\#include <\1>#' | sort |
  comm -3 "$failures.listed" - | none "all_public_headers.h disagrees about"
rm "$failures.listed"

# Every named parameter that is documented is one of CGAL's.
known=$(find "$cgal" -name parameters_interface.h -exec sed -nE 's/^CGAL_add_.*named_parameter.*, *([a-z_0-9]+)\)$/\1/p' {} +)
[ -n "$known" ] || echo "$cgal" | none "the named parameters of CGAL are not found in"
cat "${headers[@]}" | grep -oP 'cgalParamNBegin\{\s*\K[a-z_0-9]+' | sort -u | grep -vxFf <(echo "$known") |
  none "a named parameter that CGAL does not have"

LC_ALL=C sort -cu package_info/$name/dependencies 2>&1 | none "dependencies"
if [ -s "$failures" ]; then
  echo "check_package.sh: $(wc -l <"$failures") things are wrong" >&2
  exit 1
fi
echo "${#files[@]} files are as CGAL wants them"
