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
trap 'rm -f "$failures" "$failures".*' EXIT

# Fails for every line of the input.
none()
{
  awk -v wrong="$1" '{ print wrong ": " $0 }' | tee -a "$failures"
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
  grep -vxE "doc/$name/(Doxyfile\.in|PackageDescription\.txt|($name|How_it_works)\.txt|dependencies|examples\.txt)" |
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
LC_ALL=C.UTF-8 grep -naxv '.*' "${texts[@]}" | cut -d: -f1,2 | none "is not UTF-8"
grep -nP '\t' "${texts[@]}" | none "a tab"
grep -nP '[ \t]$' "${texts[@]}" | none "a blank at the end of a line"
grep -nP '\r$' "${texts[@]}" | none "a DOS line end"
perl -0777 -ne 'print "$ARGV\n" if /[^\n]\z/' "${texts[@]}" | none "has no line end at its end"

# On Windows min and max may be macros. Strings and comments are left out; the line ends of comments stay.
perl -0777 -ne '
  s{("(?:[^"\\\n]|\\.)*"|\x27(?:[^\x27\\\n]|\\.)\x27)|//[^\n]*|(/\*.*?\*/)}
   {$1 ? q("") : defined $2 ? $2 =~ s/[^\n]+/ /gr : ""}egs;
  my $line = 0;
  for (split /\n/) { ++$line; print "$ARGV:$line:$_\n" if /\b(?:min|max)\s*\(/ }' "${code[@]}" |
  none "min or max without ( )"
grep -nE '^ *# *define' "${headers[@]}" | grep -vE '# *define +CGAL_' | none "a macro that does not begin with CGAL_"

perl -0777 -ne '
  (my $guard = uc $ARGV) =~ s{^INCLUDE/}{};
  $guard =~ s{[/.]}{_}g;
  print "$ARGV: $guard\n" unless /^#ifndef $guard\n#define $guard\n.*^#endif \/\/ $guard\n\z/ms' "${headers[@]}" |
  none "has not its include guard"
grep -hE '^#ifndef CGAL_.*_H$' "${code[@]}" | sort | uniq -d | none "an include guard of two files"

mapfile -t own < <(printf '%s\n' "${code[@]}" | grep -v '^doc/') # files of the manual have none in CGAL
awk 'FNR == 1 && !/^\/\/ Copyright \(c\) [0-9][0-9][0-9][0-9]/ { print FILENAME }' "${own[@]}" | none "has no copyright line"
grep -L '^// SPDX-License-Identifier: GPL-3.0-or-later' "${own[@]}" | none "has no SPDX line"
if grep -q 'This file is part of CGAL' "${headers[0]}"; then # the form of CGAL
  for line in '// This file is part of CGAL (www.cgal.org).' '// $URL$' '// $Id$' '// Author(s)     : ' \
    "#include <CGAL/license/$name.h>"; do
    grep -LF -- "$line" "${headers[@]}" | none "has no line '$line'"
  done
else
  grep -lE 'part of CGAL|CGAL/license' "${code[@]}" | none "says that it is part of CGAL"
fi

# Each .cpp belongs to a program that is named; each program has a line of its own.
for part in test examples benchmark; do
  list=$part/$name/CMakeLists.txt
  (cd "$part/$name" && find . -name '*.cpp' | sed 's#^\./##' | sort) >"$failures.there"
  grep -oE '"[^"]+\.cpp"' "$list" | tr -d '"' | sort -u >"$failures.named"
  comm -23 "$failures.there" "$failures.named" | none "is not named in $list"
  comm -13 "$failures.there" "$failures.named" | none "does not exist, but is named in $list"
  grep -v / "$failures.there" |
    grep -vxFf <(sed -nE 's/^ *create_single_source_cgal_program\("([^"]*)".*/\1/p' "$list") | none "has no program in $list"
  [ "$(awk '!/^ *(#|$)/ { print; exit }' "$part/$name/CMakeLists.txt")" = 'cmake_minimum_required(VERSION 3.12...3.31)' ] ||
    echo "$part/$name/CMakeLists.txt" | none "does not begin with cmake_minimum_required"
done
grep -n 'include(CTest)' {test,examples,benchmark}/$name/CMakeLists.txt | none "makes targets of dashboards in all of CGAL"
for part in test examples benchmark; do # CGAL passes over a folder without
  [ -n "$(find $part/$name -maxdepth 1 -name '*.cpp')" ] || echo "$part/$name" | none "has no .cpp file itself"
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
