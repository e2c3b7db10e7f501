#!/bin/bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_tools.sh SEGMENT_BY_PROTRUSIONS EVALUATE_SEGMENTATION MAKE_EXAMPLE_MESH DATA_FOLDER WORK_FOLDER JSON_SCHEMA
#
# The command line tools as a user meets them: exit codes, messages, files; on good input, on each of the
# awkward files as its entry in the table of DATA_FOLDER/README.md demands, and where nothing can be written.

set -uo pipefail
segment=$1 evaluate=$2 make_mesh=$3 data=$4 work=$5 schema=$6
rm -rf "$work"
mkdir -p "$work"
cd "$work"
failures=0
export LC_ALL=C

fail()
{
  echo "FAILED: $*" >&2
  echo "  exit code $code, output: $(head -c 300 stdout), errors: $(head -c 300 stderr)" >&2
  failures=$((failures + 1))
}

# run COMMAND...: sets `code`, fills the files stdout and stderr; a hang ends.
run()
{
  command="$*"
  timeout 60 "$@" >stdout 2>stderr
  code=$?
}

# expect CODE COMMAND...: runs it; a failure must be told in one line that begins with the tool's name.
expect()
{
  local wanted=$1
  shift
  run "$@"
  [ "$code" = "$wanted" ] || fail "$command: exit code instead of $wanted"
  if [ "$wanted" != 0 ]; then expect_one_line "$(basename "$1"):"; fi
}

expect_one_line()
{
  [ "$(wc -l <stderr)" = 1 ] || fail "$command: not one line of error"
  grep -qF -- "$1" stderr || fail "$command: the error does not name '$1'"
}

expect_text() # FILE TEXT
{
  grep -qaF -- "$2" "$1" || fail "$command: no '$2' in $1"
}

# Whether the help has that text. Not by a pipe: grep ends at the first match, and the tool would fail to write the rest.
help_says() # TEXT
{
  grep -qF -- "$1" <<<"$("$segment" --help)"
}

# The first number with that key.
json_value() # FILE KEY
{
  grep -m 1 -F "\"$2\": " "$1" | tr -cd '0-9'
}

# Nothing but these files may be in the folder.
expect_files() # FOLDER NAME...
{
  local folder=$1
  shift
  local found wanted
  found=$(cd "$folder" && find . -mindepth 1 | sort | tr '\n' ' ')
  wanted=$(for name in "$@"; do echo "./$name"; done | sort | tr '\n' ' ')
  [ "$found" = "$wanted" ] || fail "$command: files '$found' instead of '$wanted'"
}

# Then the next check begins anew.
expect_empty_folder()
{
  expect_files "$1"
  rm -rf "${1:?}"/*
}

test_usage()
{
  local mesh=$data/tetrahedron.off
  for tool in "$segment" "$evaluate" "$make_mesh"; do
    expect 0 "$tool" --help
    expect_text stdout "Usage"
    expect 2 "$tool"
    expect 2 "$tool" "$mesh" --no-such-option
  done
  expect 2 "$evaluate" "$mesh"
  local arguments
  for arguments in "-k 0" "-k -3" "-k 2.5" "-k many" "--threads 0" "--threads -1" "--threads 1.5" \
                   "--method other" "--distance other" "--seed -1" \
                   "--distance landmark --landmarks 0" "--distance landmark --landmarks 0%" \
                   "--distance landmark --landmarks 101%" "--distance landmark --landmarks 5%%" \
                   "--distance landmark --landmarks -5" "--landmarks 5%" \
                   "--distance diffusion --eigenpairs 0" "--distance diffusion --eigenpairs -1" \
                   "--distance diffusion --eigenpairs 2.5" "--distance diffusion --time -1" \
                   "--distance diffusion --time nan" "--distance diffusion --time inf" \
                   "--distance diffusion --time soon" "--distance diffusion --landmarks 5%" \
                   "--eigenpairs 5" "--time 1" "--distance heat --time 1" "--distance exact --eigenpairs 5" \
                   "-o out.xyz" "-o out" "-o %d.seg" \
                   "-o %d/%d.ply" "-o out.seg --close" "--close" "-o %d.off --close=round" "--borders out.off" "--borders out" "-k 3 --tips out.json" "-o out.seg -o out.seg" "-o out.seg --json out.seg" "--json out.html --report out.html" "-o $mesh" "-o"; do
    # shellcheck disable=SC2086
    expect 2 "$segment" "$mesh" $arguments
  done
  expect_files . stdout stderr
}

# An OFF file of triangles: is each edge that of one face in each direction?
is_closed_manifold()
{
  awk 'NR == 2 { faces = $2 }
       NF == 4 && $1 == 3 && NR > 2 { for (i = 0; i < 3; ++i) ++times[$(2 + i) " " $(2 + (i + 1) % 3)]; ++found }
       END { for (edge in times)
             {
               split(edge, v, " ")
               if (times[edge] != 1 || times[v[2] " " v[1]] != 1)
                 exit 1
             }
             exit found != faces || length(times) != 3 * faces }' "$1"
}

test_example_meshes()
{
  mkdir examples
  local shape vertices faces handles
  for shape in octopus teddy hand horse chair; do
    for i in 1 2; do
      expect 0 "$make_mesh" $shape "examples/$shape$i.off" --faces 2000
    done
    cmp -s examples/${shape}1.off examples/${shape}2.off || fail "$command: two runs differ"
    is_closed_manifold examples/${shape}1.off || fail "$command: not closed or not manifold"
    read -r vertices faces _ < <(sed -n 2p examples/${shape}1.off)
    [ "$faces" -ge 2000 ] && [ "$faces" -le 2500 ] || fail "$command: $faces faces"
    handles=0
    [ $shape != chair ] || handles=1 # below the back
    [ $((vertices - faces / 2)) = $((2 - 2 * handles)) ] || fail "$command: another number of handles"
  done
  expect 2 "$make_mesh" snail examples/snail.off
  expect 1 "$make_mesh" teddy examples/missing/teddy.off --faces 1000
  expect_one_line "examples/missing/teddy.off: cannot be written"
  expect 1 "$make_mesh" teddy examples/teddy.xyz --faces 1000
  expect_one_line "examples/teddy.xyz: cannot be written: only .off, .ply, .obj and .stl are known"
  local extension
  for extension in off ply obj stl; do
    expect 0 "$make_mesh" teddy examples/small.$extension --faces 1000
    expect 0 "$segment" examples/small.$extension -k 2 -o examples/small.seg
    ln -s /dev/full examples/full.$extension
    expect 1 "$make_mesh" teddy examples/full.$extension --faces 1000
    expect_one_line "examples/full.$extension: cannot be written"
  done
  rm -r examples
}

test_outputs()
{
  mkdir outputs
  local in=outputs/teddy.off
  expect 0 "$make_mesh" teddy $in --faces 3000
  expect 0 "$segment" $in -k 4 --method paper -o outputs/a.ply -o outputs/a.off -o outputs/a.seg -o outputs/parts/%d.ply \
           -o outputs/parts/part%d.off -o outputs/a.glb -o outputs/a.vtp -o outputs/a.obj --json outputs/a.json
  expect_text stdout "4 segments"
  expect_files outputs teddy.off a.ply a.off a.seg a.glb a.vtp a.obj a.json parts parts/{0,1,2,3}.ply parts/part{0,1,2,3}.off
  local faces
  faces=$(sed -n 2p $in | cut -d' ' -f2)
  [ "$(wc -l <outputs/a.seg)" = "$faces" ] || fail "a.seg has not one line per face"
  [ "$(sort -u outputs/a.seg | tr '\n' ' ')" = "0 1 2 3 " ] || fail "a.seg has other ids than 0 to 3"
  expect_text outputs/a.ply "format binary"
  expect_text outputs/a.ply "element face $faces"
  [ "$(grep -ac "property uchar red" outputs/a.ply)" = 2 ] || fail "a.ply has not colours of vertices and of faces"
  expect_text outputs/a.ply "property uint segment"
  expect_text outputs/a.vtp "NumberOfPolys=\"$faces\""
  [ "$(sed -n '/Name="segment"/,/DataArray>/p' outputs/a.vtp | grep -v DataArray)" = "$(cat outputs/a.seg)" ] ||
    fail "a.vtp has other segments than a.seg"
  [ "$(awk '/^g segment_/ { id = substr($2, 9) } /^f / { print id }' outputs/a.obj)" = "$(cat outputs/a.seg)" ] ||
    fail "a.obj has other segments than a.seg"
  [ "$(head -c 4 outputs/a.glb)" = glTF ] || fail "a.glb is no binary glTF"
  [ "$(od -An -t u4 -j 8 -N 4 outputs/a.glb | tr -d ' ')" = "$(stat -c %s outputs/a.glb)" ] ||
    fail "a.glb has another length than its header says"
  for id in 0 1 2 3; do
    expect_text outputs/a.glb "segment $id"
  done
  local key
  for key in "\"faces\": $faces," '"segments_requested": 4,' '"segments": 4,' '"dijkstra_runs": ' \
             '"seconds": ' '"writing_seconds": ' '"threads": 1,' '"peak_memory": ' '"input": ' '"method": "paper"' '"distance": "geodesic"' '"seed": 0' \
             '"protrusions": [' '"stages": [' '"note": null' '"border_slot": ' '"distance_histogram": [' \
             '"sectional_diameter_histogram": [' '"hierarchy": [' '"children": ['; do
    expect_text outputs/a.json "$key"
  done

  # What was written can be read, and says the same.
  for mesh in outputs/a.ply outputs/a.off outputs/a.obj; do
    expect 0 "$evaluate" $mesh outputs/a.seg outputs/a.seg
  done
  for part in outputs/parts/*; do
    expect 0 "$segment" "$part" -k 1 --quiet
    [ -s stdout ] || [ -s stderr ] && fail "$command: is not quiet"
  done
}

# volume_of OFF_FILE...: six times the volume of all together; fails unless each edge of a file is there once in either
# direction.
volume_of()
{
  awk '
    FNR == 1 { for (edge in count) open += !(reverse[edge] in count); delete count; delete reverse; line = 0; next }
    /^ *(#|$)/ { next }
    ++line == 1 { n = $1; next }
    line <= n + 1 { for (c = 1; c <= 3; ++c) p[line - 2, c] = $c; next }
    {
      for (i = 2; i <= $1 + 1; ++i)
      {
        next_corner = i > $1 ? $2 : $(i + 1)
        if (count[$i " " next_corner]++) ++open
        reverse[$i " " next_corner] = next_corner " " $i
      }
      for (i = 3; i <= $1; ++i)
      {
        a = $2; b = $i; c = $(i + 1)
        sum += p[a, 1] * (p[b, 2] * p[c, 3] - p[b, 3] * p[c, 2])
        sum += p[a, 2] * (p[b, 3] * p[c, 1] - p[b, 1] * p[c, 3])
        sum += p[a, 3] * (p[b, 1] * p[c, 2] - p[b, 2] * p[c, 1])
      }
    }
    END { for (edge in count) open += !(reverse[edge] in count); printf "%.9g\n", sum; exit open > 0 }' "$@"
}

test_closed_parts()
{
  local whole sum method
  whole=$(volume_of outputs/teddy.off) || fail "outputs/teddy.off is not closed"
  for method in minimum-cut paper; do
    expect 0 "$segment" outputs/teddy.off -k 6 --method $method --close -o closed_$method/%d.off
    sum=$(volume_of closed_$method/[0-5].off) || fail "$command: a part is not closed"
    awk -v a="$whole" -v b="$sum" 'BEGIN { exit !(a > 0 && (a - b) ^ 2 < (1e-6 * a) ^ 2) }' ||
      fail "$command: volumes add up to $sum instead of $whole"
    expect 0 "$segment" outputs/teddy.off -k 6 --method $method -o open_$method/%d.off
    volume_of open_$method/0.off >/dev/null && fail "$command: a part is closed without --close"
    expect 0 "$segment" outputs/teddy.off -k 6 --method $method --close=faired -o faired_$method/%d.off
    volume_of faired_$method/[0-5].off >/dev/null || fail "$command: a part is not closed"
    cmp -s closed_$method/1.off faired_$method/1.off && fail "$command: the caps are flat"
    rm -r faired_$method
    [ -s stderr ] && fail "$command: a note on a closed mesh"
    rm -r closed_$method open_$method
  done
  expect 0 "$segment" $data/open_sheet.off --close -o closed_sheet/%d.off
  expect_text stderr "meshes of segments stay open"
  rm -r closed_sheet
}

# Where three.js was not found at build time, that is said, and nothing is written.
test_report()
{
  local in=outputs/teddy.off name="outputs/</script>"
  run "$segment" $in -k 4 --report outputs/a.html
  if [ "$code" = 2 ]; then
    expect_one_line "three.js was not found"
    [ ! -e outputs/a.html ] || fail "$command: wrote a report"
    return
  fi
  report_option=(--report awkward/a.html)
  expect 0 "$segment" $in -k 4 --report outputs/a.html
  expect_text stdout "wrote outputs/a.html"
  expect_text outputs/a.html "three.js authors"
  expect_text outputs/a.html '"border_length":'
  expect_text outputs/a.html "</html>"
  expect 1 "$segment" $in --report outputs/missing/a.html
  expect_one_line "outputs/missing/a.html: cannot be written"
  mkdir -p "$name" # a name that ends the script in which it stands
  cp $in "$name/a.off"
  expect 0 "$segment" "$name/a.off" --report outputs/a.html
  [ "$(grep -c "</script>/a.off" outputs/a.html)" = 0 ] || fail "$command: the name of the input ends the page's script"
  rm -r outputs/a.html "outputs/<"
}

test_determinism()
{
  local in=outputs/teddy.off options
  for options in "" "--method paper" "--distance landmark" "--distance landmark --landmarks 20 --seed 7" "--distance diffusion" "--distance heat"; do
    for i in 1 2; do
      # shellcheck disable=SC2086
      expect 0 "$segment" $in -k 6 $options -o outputs/same$i.seg -o outputs/same$i.ply -o outputs/same$i.glb
    done
    for extension in seg ply glb; do
      cmp -s outputs/same1.$extension outputs/same2.$extension || fail "$command: two runs differ"
    done
  done
  if help_says "oneTBB was not found"; then
    expect 2 "$segment" $in --threads 2
    expect_text stderr "oneTBB was not found"
  else
    for options in "" "--method paper" "--method paper --distance landmark"; do
      for i in 1 2; do
        # shellcheck disable=SC2086
        expect 0 "$segment" $in -k 6 $options --threads $i -o outputs/same$i.seg --json outputs/threads$i.json
        expect_text outputs/threads$i.json "\"threads\": $i,"
      done
      cmp -s outputs/same1.seg outputs/same2.seg || fail "$command: other segments with two threads"
    done
  fi
  expect 0 "$segment" $in --json -
  expect_text stdout '"segments_requested": null'
  [ "$(head -c 1 stdout)" = "{" ] || fail "$command: there is more than JSON on the standard output"
}

# The name of the distance and of its own options, those of others are null.
test_distances()
{
  local in=outputs/small.off distance key
  expect 0 "$make_mesh" octopus $in --faces 1000
  for distance in geodesic landmark diffusion heat exact; do
    expect 0 "$segment" $in -k 3 --distance $distance --json -
    expect_text stdout "\"distance\": \"$distance\""
    expect_text stdout '"segments": 3,'
    [ $distance = landmark ] || expect_text stdout '"landmarks": null'
    [ $distance = diffusion ] || expect_text stdout '"eigenpairs": null'
    [ $distance = diffusion ] || expect_text stdout '"diffusion_time": null'
  done
  expect 0 "$segment" $in -k 3 --json - # the default method measures on a graph of its own
  for key in '"method": "minimum-cut"' '"distance": null' '"border_slot": null' '"value": ' '"preparation"'; do
    expect_text stdout "$key"
  done
  expect 0 "$segment" $in -k 3 --distance diffusion --eigenpairs 5 --time 0 --json -
  expect_text stdout '"eigenpairs": 5,'
  expect_text stdout '"diffusion_time": 0.0,'
  expect 0 "$segment" "$data/tetrahedron.off" --distance diffusion --eigenpairs 300
  expect 2 "$segment" "$data/tetrahedron.off" --distance diffusion --eigenpairs 1000000
  expect 2 "$segment" $in --distance heat --time 1
  expect_one_line "--time has no meaning with heat, only with diffusion"
}

test_number_of_segments()
{
  expect 0 "$segment" "$data/two_components.off" -k 1 --json -
  expect_text stdout '"segments": 2'
  expect_text stdout '"note": "found 2 segments instead of 1'
  expect_text stderr "found 2 segments instead of 1"
  expect 0 "$segment" "$data/tetrahedron.off" -k 4 --json -
  expect_text stdout '"segments_requested": 4'
  if ! grep -qF '"segments": 4' stdout; then
    expect_text stderr "of 4 segments"
  fi
  expect 0 "$segment" "$data/tetrahedron.off" --json -
  expect_text stdout '"note": "found no protrusion'
  expect_text stderr "found no protrusion"
  expect 1 "$segment" "$data/tetrahedron.off" -k 5 -o outputs/five.seg
  expect_one_line "tetrahedron.off: has 4 faces"
  [ ! -e outputs/five.seg ] || fail "$command: wrote an output"
}

# Squares of areas are no numbers there.
test_huge_and_tiny_coordinates()
{
  local unit
  for unit in e100 e-100; do
    printf 'OFF\n3 1 0\n0 0 0\n3%s 0 0\n0 4%s 0\n3 0 1 2\n' $unit $unit >outputs/triangle.off
    expect 0 "$segment" outputs/triangle.off --json - -o outputs/triangle.seg
    case $unit in
      e100) expect_text stdout '"area": 6e+200' ;;
      *) expect_text stdout '"area": 6e-200' ;;
    esac
  done
}

# The table of the awkward files: | `name` | what it is | accept, repair, reject |
test_awkward_meshes()
{
  mkdir awkward records
  local name duty distance
  while IFS=$'\t' read -r name duty; do
    if [ "$duty" != reject ]; then
      run "$segment" "$data/$name"
      local usual_code=$code
      for distance in landmark diffusion heat exact; do
        expect $usual_code "$segment" "$data/$name" --method paper --distance $distance
      done
    fi
    run "$segment" "$data/$name" -o awkward/a.seg -o awkward/a.ply -o awkward/a.glb -o awkward/a.vtp \
        -o awkward/parts/%d.ply --json awkward/a.json "${report_option[@]}"
    case "$duty:$code" in
      accept:0 | repair:0)
        [ -s awkward/a.seg ] && [ -s awkward/a.json ] || fail "$name: accepted without output"
        [ "$(wc -l <awkward/a.seg)" = "$(json_value awkward/a.json faces)" ] || fail "$name: not a label for each face"
        [ $duty = accept ] || grep -qE "degenerate|duplicate|more than two faces|no two sides|turned over" stderr ||
          fail "$name: repaired without a word"
        mv awkward/a.json "records/$name.json"
        rm -r awkward/* ;;
      reject:1)
        expect_one_line "$data/$name: " ;;
      *)
        fail "$name: must $duty" ;;
    esac
    expect_empty_folder awkward
  done < <(sed -nE 's/^\| `([^`]*)`.*\| (accept|repair|reject) \|$/\1\t\2/p' "$data/README.md" |
           grep -v '\.seg')
  expect 1 "$segment" "$data/no_such_file.off"
  expect_one_line "no_such_file.off: "
  expect 2 "$segment" "$data"
  expect_one_line "--output-folder"
}

test_awkward_segmentations()
{
  local name duty
  while IFS=$'\t' read -r name duty; do
    run "$evaluate" "$data/tetrahedron.off" "$data/$name" "$data/good.seg" --json awkward/a.json
    if [ "$duty" = accept ]; then
      [ "$code" = 0 ] || fail "$name: must accept"
      rm -f awkward/a.json
    else
      [ "$code" = 1 ] || fail "$name: must reject"
      expect_one_line "$data/$name: "
    fi
    expect_empty_folder awkward
  done < <(sed -nE 's/^\| `([^`]*\.seg)`.*\| (accept|reject) \|$/\1\t\2/p' "$data/README.md")
}

test_unwritable_outputs()
{
  mkdir -p out/folder.ply
  local in=$data/tetrahedron.off name
  for name in out/missing/a.ply out/folder.ply; do
    expect 1 "$segment" "$in" -o out/a.seg -o $name --json out/a.json
    expect_one_line "$name: cannot be written"
    expect_files out folder.ply
  done
  echo private >out/a.seg
  chmod 640 out/a.seg
  expect 0 "$segment" "$in" -o out/a.seg
  [ "$(stat -c %a out/a.seg)" = 640 ] || fail "$command: a file that was replaced has other permissions"
  ln -s a.seg out/link.seg
  ln -s b.seg out/to_nothing.seg
  expect 0 "$segment" "$in" -o out/link.seg -o out/to_nothing.seg
  expect_files out folder.ply a.seg b.seg link.seg to_nothing.seg
  [ -h out/link.seg ] && [ -h out/to_nothing.seg ] || fail "$command: a link was replaced"
  cmp -s out/a.seg out/b.seg || fail "$command: what a link leads to was not written"
  ln -s circle.seg out/circle.seg
  expect 1 "$segment" "$in" -o out/circle.seg
  expect_one_line "out/circle.seg: cannot be written"
  rm out/b.seg out/link.seg out/to_nothing.seg out/circle.seg
  echo old >out/a.seg
  expect 1 "$segment" "$in" -o out/a.seg --json /dev/full
  expect_one_line "/dev/full: cannot be written: No space left on device"
  expect 1 "$segment" "$data/nan.off" -o out/a.seg -o out/new/%d.ply
  expect 1 "$segment" "$in" -o out/a.seg -o out/a.seg/parts/%d.ply
  expect_files out folder.ply a.seg
  [ "$(cat out/a.seg)" = old ] || fail "$command: a file was changed by a call that failed"

  # A limit on file sizes stands for a full disc: the second file fits, the first one does not.
  (
    trap '' XFSZ
    ulimit -f 16
    timeout 60 "$segment" outputs/teddy.off -k 2 -o out/new/%d.ply -o out/a.seg -o out/big.ply
  ) >stdout 2>stderr
  code=$?
  [ "$code" = 1 ] || fail "full disc: exit code"
  expect_one_line "cannot be written"
  expect_files out folder.ply a.seg
  [ "$(cat out/a.seg)" = old ] || fail "full disc: a file was changed by a call that failed"

  run "$segment" "$in" --json - -o out/b.seg
  "$segment" "$in" >/dev/full 2>stderr && fail "standard output: a full one is no failure"
}

# No output takes the place of a file that is read, or of another output, by whatever name; nothing is done then.
test_names_given_twice()
{
  mkdir -p names/parts
  cp "$data/tetrahedron.off" names/0.off
  echo '{"tips": [0]}' >names/tips.json
  ln -s 0.off names/link.off
  ln -s ../0.off names/parts/7.ply
  local arguments
  for arguments in "-o %d.off" "-o ./%d.off" "-o $PWD/names/%d.off" "-o link.off" "-o parts/%d.ply" \
                   "--tips tips.json --json tips.json" "--tips tips.json --json ./tips.json" \
                   "-o %d.ply --json 12.ply" "-o d%d.ply -o d0.ply" "-o d%03d.ply -o d1000.ply" "-o d%3d.ply -o ../names/d123.ply" \
                   "-o d%d.ply -o d%02d.ply" "-o d%d.ply -o d1%d.ply" "-o 1%d.ply -o %d2.ply" \
                   "-o new.ply -o ./new.ply" "-o new/a.ply -o new/../new/a.ply"; do
    # shellcheck disable=SC2086
    (cd names && timeout 60 "$segment" 0.off $arguments) >stdout 2>stderr
    code=$? command="$arguments"
    [ "$code" = 2 ] || fail "$command: exit code instead of 2"
    expect_one_line "' is named twice"
  done
  expect_files names 0.off tips.json link.off parts parts/7.ply
  cmp -s "$data/tetrahedron.off" names/0.off || fail "an input was written to"
  # What only looks alike is another file.
  expect 0 "$segment" names/0.off -k 2 -o names/d%d.off -o names/d%d.ply -o names/d00.off -o names/%02d.off -o names/parts/0.off
  rm -r names
}

test_words()
{
  local in=outputs/teddy.off words
  for words in 0 -3 abc 2.5 99999999999999999999999; do
    expect 2 "$segment" $in -k "$words"
    expect_one_line "'$words' is "
    [ "$(wc -c <stderr)" -lt 120 ] || fail "$command: too many words"
  done
  # A leading zero changes nothing: 010 is ten, and 09 a number.
  expect 0 "$segment" $in -k 010 --seed 08 --threads 01 --distance diffusion --eigenpairs 012 --json outputs/zeros.json
  expect_text outputs/zeros.json '"segments": 10,'
  expect_text outputs/zeros.json '"seed": 8'
  expect_text outputs/zeros.json '"eigenpairs": 12,'
  expect 0 "$make_mesh" octopus outputs/zeros.off --faces 01010
  expect 2 "$make_mesh" octopus outputs/zeros.off --faces 999
  expect_one_line "'999' is no number of faces, an integer from 1000 to 1000000"
  expect 2 "$segment" $in --seed 4294967296
  expect_one_line "'4294967296' is no seed, an integer from 0 to 4294967295"
  expect 2 "$segment" $in -k 0x10
  expect 0 "$segment" --version
  grep -qE "^segment_by_protrusions [0-9]+\.[0-9]+\.[0-9]+$" stdout || fail "$command: no version"
  : >outputs/empty.xyz
  expect 1 "$segment" outputs/empty.xyz
  expect_one_line "outputs/empty.xyz: is in no known format"
  expect 0 "$segment" $in -k 4 -o outputs/numbered/%03d.off
  expect_text stdout "wrote outputs/numbered/%03d.off (4 files)"
  expect_files outputs/numbered 000.off 001.off 002.off 003.off
  expect 0 "$segment" $in -k 4 --distance diffusion --eigenpairs 101
  expect_text stderr "101 eigenpairs on "
  expect 1 "$segment" "$data/word_in_face.obj"
  expect_one_line "word_in_face.obj: line 6: 'x' is no corner of a face"
  expect 1 "$segment" "$data/incomplete_vertex.off"
  expect_one_line "incomplete_vertex.off: line 4: "
  expect 1 "$segment" "$data/word_for_number.stl"
  expect_one_line "word_for_number.stl: line 5: '1,0' is no coordinate"
  expect 1 "$segment" "$data/solid_truncated_binary.stl"
  expect_one_line "solid_truncated_binary.stl: announces 4 facets, and ends after 1"
  expect 2 "$segment" $in --threads 5000000
  expect_one_line "'5000000' is no number of threads, an integer from 1 to 1024"
  local keyword
  for keyword in COFF NOFF STOFF NCOFF CSTOFF NSTOFF STNOFF NCSTOFF CNSTOFF STNCOFF; do
    sed "1s/.*/$keyword/" "$data/tetrahedron.off" >outputs/keyword.off
    expect 0 "$segment" outputs/keyword.off
  done
  for keyword in CCOFF NCNOFF STCSTOFF SOFF XOFF; do
    sed "1s/.*/$keyword/" "$data/tetrahedron.off" >outputs/keyword.off
    expect 1 "$segment" outputs/keyword.off
    expect_one_line "'$keyword'"
  done
  expect 1 "$segment" "$data/vertex_twice.ts"
  expect_one_line "vertex_twice.ts: line 5: there is a vertex 2 already"
  expect 1 "$segment" "$data/missing_vertex.ts"
  expect_one_line "missing_vertex.ts: line 6: names vertex 4, "
  expect 0 "$segment" "$data/two_surfaces.ts"
  expect_text stdout "2 faces, 2 segments"
  expect 0 "$segment" "$data/atoms.ts"
  expect_text stdout "4 faces, 1 segments"
  expect 1 "$segment" "$data/utf_16.off"
  expect_one_line "UTF-16"
  expect 1 "$segment" "$data/range_grid.ply"
  expect_one_line "range grid"
  expect 0 "$segment" "$data/facet_of_two_points.stl" --json -
  expect_text stderr "1 degenerate face has the label of a neighbour"
  expect_text stdout '"degenerate_faces": 1,'
  expect 0 "$segment" "$data/facet_of_two_points.stl" -k 2 -o outputs/labels.seg
  expect 0 "$evaluate" "$data/facet_of_two_points.stl" outputs/labels.seg outputs/labels.seg
  expect 0 "$segment" "$data/double_sided.off" --json -
  expect_text stderr "6 duplicate faces have that of the first"
  expect 0 "$segment" "$data/wall_between_solids.off" --json -
  expect_text stdout '"components": 1,'
}

# A file that needs no repair is built as it is, without a search for repairs: the same comes of it as of one with a
# face named twice, or with a point that no face uses.
test_sound_files()
{
  local in=outputs/compact.off vertices faces
  grep . outputs/teddy.off >$in # without empty lines
  read -r vertices faces _ < <(sed -n 2p $in)
  expect 0 "$segment" $in -k 4 -o outputs/sound.seg
  { sed "2s/.*/$vertices $((faces + 1)) 0/" $in; tail -n 1 $in; } >outputs/twice.off
  expect 0 "$segment" outputs/twice.off -k 4 -o outputs/twice.seg
  expect_text stderr "1 duplicate face has that of the first"
  head -n "$faces" outputs/twice.seg | cmp -s - outputs/sound.seg || fail "$command: other labels than of the sound file"
  { head -n -"$faces" $in | sed "2s/.*/$((vertices + 1)) $faces 0/"; echo "7 7 7"; tail -n "$faces" $in; } >outputs/unused.off
  expect 0 "$segment" outputs/unused.off -k 4 -o outputs/unused.seg
  cmp -s outputs/unused.seg outputs/sound.seg || fail "$command: other labels than without the unused point"
}

# Names that are mistyped, or taken for something else.
test_mistaken_names()
{
  local in=$data/tetrahedron.off name arguments
  for name in missing missing/ missing.xyz missing/a.off; do
    expect 1 "$segment" $name
    expect_one_line "$name: cannot be opened: No such file or directory"
  done
  expect 1 "$segment" "$in" --tips outputs
  expect_one_line "outputs: is a folder"
  run "$segment" "$in" missing --output-folder mistaken
  [ "$code" = 1 ] || fail "$command: a failure is not told by the exit code"
  expect_text stderr "missing: cannot be opened: No such file or directory"
  expect_files mistaken tetrahedron.seg tetrahedron.json
  run "$segment" missing --output-folder mistaken/new
  [ "$code" = 1 ] || fail "$command: a failure is not told by the exit code"
  [ ! -e mistaken/new ] || fail "$command: made a folder for nothing"
  cp "$in" mistaken/-dash.off
  code=0 command="a name with a dash"
  (cd mistaken && "$segment" -dash.off) >stdout 2>stderr && fail "is no option"
  expect_one_line "; the file -dash.off is named by ./-dash.off"
  (cd mistaken && "$segment" ./-dash.off && "$segment" -- -dash.off) >stdout 2>stderr || fail "is refused"
  rm -r mistaken
  for arguments in "$in --close faired -o %d.off" "--close faired $in -o %d.off" "--close faired -o %d.off"; do
    # shellcheck disable=SC2086
    expect 2 "$segment" $arguments
    expect_one_line "'faired' is no mesh; caps are chosen by --close=faired"
  done
  expect 2 "$segment" "$in" --close %d.off
  expect_one_line "'%d.off' is no mesh; an output is named by -o"
}

# Where the name has no extension, the format is found by how the file begins.
test_nameless_files()
{
  local name
  for name in tetrahedron.off tetrahedron.obj tetrahedron.ply tetrahedron.stl tetrahedron_binary.stl tetrahedron.ts \
              tetrahedron.off.gz no_keyword.off; do
    cp "$data/$name" outputs/nameless
    expect 0 "$segment" outputs/nameless -k 2
    expect 0 "$segment" <(cat "$data/$name") -k 2
    command="$name as /dev/stdin"
    "$segment" /dev/stdin -k 2 <"$data/$name" >stdout 2>stderr || fail "is refused"
  done
}

# The same through pipes as by files; the format is found by how the file begins.
test_pipes()
{
  local name
  expect 0 "$segment" outputs/teddy.off -k 4 -o outputs/piped.seg
  expect 0 "$segment" outputs/teddy.off -k 4 -o -
  cmp -s stdout outputs/piped.seg || fail "$command: the standard output is not the file"
  for name in tetrahedron.off tetrahedron.obj tetrahedron.ply tetrahedron.stl tetrahedron_binary.stl tetrahedron.ts \
              smallest_byte_first_binary.off no_keyword.off tetrahedron.off.gz counts_behind_keyword.off; do
    command="$name through a pipe"
    "$segment" - -k 2 -o - <"$data/$name" >stdout 2>stderr || fail "is refused"
    [ "$(wc -l <stdout)" = 4 ] || fail "has not four labels"
  done
  for name in teddy.obj teddy.ply teddy.stl; do
    expect 0 "$make_mesh" teddy outputs/piped_$name --faces 1000
    command="$name through a pipe"
    "$segment" - -k 2 -o - <outputs/piped_$name >stdout 2>stderr || fail "is refused"
    [ "$(wc -l <stdout)" -ge 1000 ] || fail "has not a label for each face"
  done
  mkfifo outputs/pipe.off
  cat "$data/tetrahedron.off" >outputs/pipe.off &
  expect 0 "$segment" outputs/pipe.off -k 2
  wait
  rm outputs/pipe.off
  command="nothing through a pipe"
  "$segment" - </dev/null >stdout 2>stderr && fail "is accepted"
  expect_one_line "-: is empty"
}

# An object within a component within a component, moved and scaled: with lib3mf, or not without a word.
test_3MF()
{
  run "$segment" "$data/three_tetrahedra.3mf" -o outputs/a.off
  if ! help_says "3mf"; then
    [ "$code" = 1 ] || fail "$command: is accepted"
    expect_one_line "lib3mf"
    return
  fi
  [ "$code" = 0 ] || fail "$command: is refused"
  [ "$(sed -n 2p outputs/a.off)" = "12 12 0" ] || fail "$command: not three tetrahedra"
  for point in "0 0 8" "2 10 0" "12 10 0" "10 12 0"; do
    grep -qx "$point" outputs/a.off || fail "$command: no vertex at $point"
  done
}

# Vertices and lines are no faces, strips are some: with VTK, or not without a word. What the tool writes is read as it was.
test_VTP()
{
  run "$segment" "$data/strips.vtp" -o outputs/a.off
  if ! help_says "ts, vtp"; then
    [ "$code" = 1 ] || fail "$command: is accepted"
    expect_one_line "VTK"
    return
  fi
  [ "$code" = 0 ] || fail "$command: is refused"
  [ "$(sed -n 2p outputs/a.off | cut -d' ' -f2)" = 4 ] || fail "$command: not four faces"
  ! grep -q "turned over" stderr || fail "$command: every other triangle of a strip is turned over"
  expect 0 "$segment" outputs/teddy.off -k 4 -o outputs/a.vtp -o outputs/a.seg
  expect 0 "$segment" outputs/a.vtp -k 4 -o outputs/b.seg
  cmp -s outputs/a.seg outputs/b.seg || fail "$command: other segments than those of the mesh that was written"
  command="strips.vtp through a pipe"
  "$segment" - -k 2 -o - <"$data/strips.vtp" >stdout 2>stderr || fail "is refused"
  [ "$(wc -l <stdout)" = 4 ] || fail "has not four labels"
}

test_collection()
{
  mkdir -p meshes/inner
  cp outputs/teddy.off meshes/a.off
  gzip -c "$data/tetrahedron.stl" >meshes/inner/b.stl.gz
  cp "$data/truncated.off.gz" meshes/broken.off.gz
  cp "$data/tetrahedron.obj" "$data/tetrahedron.ply" meshes
  local call=("$segment" meshes "$data/quads.off" --output-folder collection --jobs 2 --format seg --format ply -k 2)
  run "${call[@]}"
  [ "$code" = 1 ] || fail "$command: a failure is not told by the exit code"
  expect_text stdout "meshes/a.off: "
  expect_text stderr "meshes/broken.off.gz: is gzip, but broken"
  expect_text stderr "6 meshes: 5 segmented, 0 already there, 1 failed"
  expect_files collection a.{seg,ply,json} inner inner/b.{seg,ply,json} broken.json quads.{seg,ply,json} \
               tetrahedron.obj.{seg,ply,json} tetrahedron.ply.{seg,ply,json}
  expect_text collection/broken.json '"error": '
  cp collection/*.json collection/inner/*.json records

  cp "$data/tetrahedron.off" meshes/broken.off && rm meshes/broken.off.gz collection/a.ply
  touch -d "1 hour" meshes/tetrahedron.obj
  expect 0 "${call[@]}"
  expect_text stdout "6 meshes: 3 segmented, 3 already there, 0 failed"
  touch meshes/tetrahedron.obj
  expect 0 "${call[@]}" --seed 1
  expect_text stdout "6 meshes: 6 segmented, 0 already there, 0 failed"
  expect 0 "${call[@]}" --seed 1
  expect_text stdout "6 meshes: 0 segmented, 6 already there, 0 failed"
  expect 0 "${call[@]}" --seed 1 --again --quiet
  [ -s stdout ] && fail "$command: is not quiet"

  expect 1 "$segment" meshes/a.off meshes/a.off --output-folder twice
  expect_one_line "has the same name as another mesh"
  # Outputs are no inputs, and take the place of none.
  expect 1 "$segment" meshes --output-folder meshes --format off
  expect_one_line "would be a mesh among those to be segmented"
  for i in 1 2; do
    expect 0 "$segment" meshes --output-folder meshes/inner/out --format ply
    expect_text stdout "5 meshes: "
  done
  rm -r meshes/inner/out
  mkdir nothing
  expect 1 "$segment" nothing --output-folder twice
  expect_one_line "nothing: has no mesh in it"
  local options
  for options in "-o a.seg" "--json a.json" "--format xyz" "--jobs 0" "--jobs 0x2"; do
    # shellcheck disable=SC2086
    expect 2 "$segment" meshes --output-folder twice $options
  done
  for options in "--jobs 2" "--format ply" "--again"; do
    # shellcheck disable=SC2086
    expect 2 "$segment" meshes/a.off $options
  done
  expect 2 "$segment" meshes/a.off meshes/broken.off
}

# What an earlier run left beside the files of this one is told of, and not taken for a part of it.
test_files_of_earlier_runs()
{
  expect 0 "$segment" outputs/teddy.off -k 4 -o earlier/%d.obj
  [ -s stderr ] && fail "$command: a note without reason"
  expect 0 "$segment" outputs/teddy.off -k 3 -o earlier/%d.obj
  expect_one_line "earlier/3.obj is not of this run"
  expect 0 "$segment" outputs/teddy.off -k 2 -o earlier/%d.obj
  expect_one_line "earlier/2.obj to earlier/3.obj, 2 files, are not of this run"
  expect_files earlier 0.obj 1.obj 2.obj 3.obj

  mkdir earlier/in
  cp outputs/teddy.off earlier/in/a.off
  local call=("$segment" earlier/in --output-folder earlier/out)
  expect 0 "${call[@]}" -k 3 --format ply --format seg
  expect_text earlier/out/a.json '"ply"'
  expect 0 "${call[@]}" -k 3 --format seg
  expect_text stdout "1 already there"
  [ -s stderr ] && fail "$command: a note on a file of the same segments"
  for i in 1 2; do # done, and done already
    expect 0 "${call[@]}" -k 2
    expect_one_line "earlier/in/a.off: earlier/out/a.ply is of another run than earlier/out/a.json"
  done
  expect_text stdout "1 already there"
  expect 0 "${call[@]}" -k 2 --quiet
  [ -s stderr ] && fail "$command: is not quiet"
  expect 0 "${call[@]}" -k 2 --format ply # which is there, of other segments
  expect_text stdout "0 already there"
  echo broken >earlier/in/a.off
  touch -d "1 hour" earlier/in/a.off
  run "${call[@]}" -k 2
  [ "$code" = 1 ] || fail "$command: a failure is not told by the exit code"
  expect_text stderr "; earlier/out/a.seg, earlier/out/a.ply are of another run than earlier/out/a.json"
  expect_files earlier/out a.seg a.ply a.json
  cp earlier/out/a.json records/of_earlier_run.json
  # A mesh that lies beside its outputs is none of them.
  cp outputs/teddy.off earlier/in/a.off
  expect 0 "$segment" earlier/in/a.off --output-folder earlier/in
  [ -s stderr ] && fail "$command: the mesh is taken for an output"
  rm -r earlier
}

# What is there of another mesh is neither taken for that of this one nor lost. Names are names, also with a "%d".
test_meshes_of_the_same_name()
{
  mkdir -p same/a same/b same/d
  cp outputs/teddy.off same/a/x.off
  cp "$data/tetrahedron.off" same/b/x.off
  expect 0 "$segment" same/a/x.off -k 2 --output-folder same/out
  cp same/out/x.seg same/x.seg
  local again
  for again in "" --again; do
    # shellcheck disable=SC2086
    run "$segment" same/b/x.off -k 2 --output-folder same/out $again
    [ "$code" = 1 ] || fail "$command: takes the place of another mesh"
    expect_text stderr "same/b/x.off: same/out/x.json tells of same/a/x.off"
  done
  cmp -s same/out/x.seg same/x.seg || fail "$command: the segments of another mesh are lost"
  expect 0 "$segment" same/a/x.off -k 2 --output-folder same/out
  expect_text stdout "1 already there"
  (cd same && "$segment" a/x.off -k 2 --output-folder out >/dev/null) || fail "the same mesh from another folder"

  cp outputs/teddy.off same/d/m0.off
  cp "$data/tetrahedron.off" "same/d/m%d.off"
  expect 0 "$segment" same/d -k 2 --format ply --format seg --output-folder same/outd
  expect_files same/outd m0.ply m0.seg m0.json m%d.ply m%d.seg m%d.json
  [ "$(wc -l <same/outd/m%d.seg)" = 4 ] || fail "$command: not the labels of its faces"
  expect 0 "$segment" same/d -k 2 --format ply --format seg --output-folder same/outd
  expect_text stdout "2 already there"

  mkdir same/d/shut
  chmod 0 same/d/shut
  if ! [ -r same/d/shut ]; then # root may read all
    expect 1 "$segment" same/d --output-folder same/outd
    expect_one_line "same/d/shut: cannot be read"
  fi
  rm -r same
}

# Names as long as a folder can hold them, and the standard output by its name.
test_long_and_special_names()
{
  local long
  long=$(printf 'a%.0s' {1..250})
  expect 0 "$segment" "$data/tetrahedron.off" -k 2 -o "$long.seg"
  [ "$(wc -l <"$long.seg")" = 4 ] || fail "$command: no labels"
  rm "$long.seg"
  command="the record to a redirected standard output"
  (echo before && "$segment" "$data/tetrahedron.off" -k 2 --quiet --json /dev/stdout && echo after) >stdout
  [ "$(head -1 stdout)" = before ] && [ "$(tail -1 stdout)" = after ] || fail "what was written before or after is lost"
  expect_text stdout '"faces": 4'
}

# Who ends the program while it writes gets no file that is half written, and none under another name.
test_ended_while_writing()
{
  mkdir ended_writing
  local i process
  for i in 1 2 3; do
    command="ended while writing"
    "$segment" outputs/large.off -k 2 -o ended_writing/a.vtp -o ended_writing/a.obj -o ended_writing/a.ply \
      -o ended_writing/b.vtp -o ended_writing/b.obj >/dev/null 2>&1 &
    process=$!
    until [ -n "$(find ended_writing -name 'a.obj.*.part')" ] || ! kill -0 $process 2>/dev/null; do :; done
    kill -TERM $process 2>/dev/null
    wait $process 2>/dev/null
    code=$?
    # all if the signal came late
    if [ "$code" = 143 ] && [ -z "$(ls -A ended_writing)" ]; then continue; fi
    expect_files ended_writing a.vtp a.obj a.ply b.vtp b.obj
    rm -f ended_writing/*
  done
  rm -r ended_writing
}

# A mesh whose process the system ends, here for want of time, has failed, and no other.
test_ended_process()
{
  expect 0 "$make_mesh" octopus outputs/large.off --faces 20000
  command="a collection with little time for each mesh"
  (ulimit -c 0 -t 1 && timeout 60 "$segment" outputs/large.off "$data/tetrahedron.off" --distance exact --output-folder ended) >stdout 2>stderr
  code=$?
  [ "$code" = 1 ] || fail "$command: a failure is not told by the exit code"
  expect_text stderr "outputs/large.off: its process was ended by signal "
  expect_text stderr "2 meshes: 1 segmented, 0 already there, 1 failed"
  expect_files ended large.json tetrahedron.seg tetrahedron.json
  expect_text ended/large.json '"error": "outputs/large.off: its process was ended by signal '
}

# The processes that segment end with the one that began them, also if that is killed.
test_ended_parent()
{
  expect 0 "$make_mesh" octopus outputs/larger.off --faces 100000
  command="a collection that is killed"
  "$segment" outputs/larger.off outputs/large.off --distance exact --output-folder killed --jobs 2 >stdout 2>stderr &
  local parent=$! children="" child
  local list=/proc/$parent/task/$parent/children
  [ -r $list ] || { kill -KILL $parent; return 0; } # no such list on this system
  for _ in $(seq 100); do
    children=$(cat $list)
    [ "$(wc -w <<<"$children")" = 2 ] && break
    sleep .1
  done
  [ "$(wc -w <<<"$children")" = 2 ] || fail "$command: not two processes"
  kill -KILL $parent
  wait $parent
  for child in $children; do
    for _ in $(seq 100); do
      is_running "$child" || break
      sleep .1
    done
    is_running "$child" && fail "$command: its processes go on"
  done
}

is_running() { [ -r "/proc/$1/status" ] && ! grep -q '^State:.*Z' "/proc/$1/status"; }

# New meshes with smooth borders: closed, with the old face of each new one, and labels of the old faces in SEG.
test_smooth_borders()
{
  mkdir smooth
  expect 0 "$segment" outputs/teddy.off -k 5 -o smooth/ragged.seg -o smooth/ragged.ply --borders smooth/ragged.vtp
  expect 0 "$segment" outputs/teddy.off -k 5 --smooth-borders -o smooth/teddy.seg -o smooth/teddy.off \
    -o smooth/teddy.ply -o smooth/teddy.vtp -o smooth/teddy.glb -o smooth/part%d.off --close --borders smooth/borders.vtp \
    --json records/smooth.json --quiet
  local whole sum
  whole=$(volume_of outputs/teddy.off)
  sum=$(volume_of smooth/teddy.off) || fail "$command: the mesh is not closed"
  awk -v a="$whole" -v b="$sum" 'BEGIN { exit !(a > 0 && (a - b) ^ 2 < (1e-6 * a) ^ 2) }' || fail "$command: the volume changed"
  sum=$(volume_of smooth/part[0-4].off) || fail "$command: a part is not closed"
  awk -v a="$whole" -v b="$sum" 'BEGIN { exit !(a > 0 && (a - b) ^ 2 < (1e-6 * a) ^ 2) }' || fail "$command: the volumes do not add up"
  [ "$(wc -l <smooth/teddy.seg)" = "$(wc -l <smooth/ragged.seg)" ] || fail "$command: SEG is not of the old faces"
  [ "$(sort -u smooth/teddy.seg | wc -l)" = 5 ] || fail "$command: not five segments"
  [ "$(paste smooth/teddy.seg smooth/ragged.seg | awk '$1 != $2' | wc -l)" -lt $(($(wc -l <smooth/teddy.seg) / 20)) ] ||
    fail "$command: one label in twenty changed"
  expect_text smooth/teddy.ply "property uint old_face"
  grep -qaF "old_face" smooth/ragged.ply && fail "old faces without new ones"
  expect_text smooth/teddy.vtp 'Name="old_face"'
  local name
  for name in segment_1 segment_2 length value probability; do
    expect_text smooth/borders.vtp "Name=\"$name\""
  done
  [ "$(length_of_lines smooth/borders.vtp)" -lt "$(length_of_lines smooth/ragged.vtp)" ] || fail "borders did not get shorter"
}

# In thousandths, of all lines.
length_of_lines() # FILE
{
  awk '/Name="length"/ { inside = 1; next } /<\/DataArray>/ { inside = 0 } inside { sum += $1 } END { printf "%d", 1000 * sum }' "$1"
}

# The protrusions of some faces only, as the report saves them.
test_tips()
{
  mkdir tips
  expect 0 "$segment" outputs/teddy.off -k 5 --json tips/all.json -o tips/all.seg
  local tip
  tip=$(json_value tips/all.json tip)
  echo "{\"tips\": [$tip], \"names\": []}" >tips/one.json
  expect 0 "$segment" outputs/teddy.off --tips tips/one.json -o tips/one.seg --json records/tips.json
  [ "$(sort -u tips/one.seg | wc -l)" = 2 ] || fail "$command: one tip does not make two segments"
  [ "$(sed -n "$((tip + 1))p" tips/one.seg)" = 1 ] || fail "$command: the tip is not in the protrusion"
  echo '{"tips": [99999999]}' >tips/bad.json
  expect 1 "$segment" outputs/teddy.off --tips tips/bad.json -o tips/bad.seg
  expect_one_line "has no face 99999999"
  local content
  for content in '' '[1]' '{"tips": 1}' '{"tips": []}' '{"tips": [-1]}' '{"tips": [1.5]}' '{"tips": ["a"]}'; do
    echo "$content" >tips/bad.json
    expect 1 "$segment" outputs/teddy.off --tips tips/bad.json -o tips/bad.seg
    expect_one_line "tips/bad.json"
  done
  expect 1 "$segment" outputs/teddy.off --tips tips/none.json -o tips/bad.seg
  [ -e tips/bad.seg ] && fail "$command: wrote something"
}

# All records so far are as the schema says, and their sums are right.
test_json_schema()
{
  if ! /usr/bin/python3 -c "import jsonschema" 2>/dev/null; then
    echo "skipped: the JSON schema (Debian: python3-jsonschema)"
    return
  fi
  expect 0 "$segment" outputs/teddy.off -k 4 --method paper --distance diffusion --json records/paper.json
  expect 0 "$segment" outputs/teddy.off -k 4 --json records/minimum_cut.json
  expect_text records/minimum_cut.json '"distance_histogram": null'
  run /usr/bin/python3 - "$schema" records/*.json <<'END'
import json, math, sys
import jsonschema

def problems_with_borders(record):
    parents = {protrusion["segment"]: protrusion["parent"] for protrusion in record["protrusions"]}
    def is_in(segment, protrusion):
        while segment != protrusion and segment in parents:
            segment = parents[segment]
        return segment == protrusion
    for border in record["borders"]:
        points = border["points"] + border["points"][:1] * border["is_closed"]
        if not math.isclose(border["length"] or 0, sum(map(math.dist, points, points[1:])), rel_tol=1e-9):
            yield f"the border of {border['segments']} is not as long as its line"
    if record["smooth_borders"]:
        return # the lengths of protrusions are those along edges
    if record["method"] == "paper":
        return # where a protrusion touches one that was cut off before, that border is not counted again
    for protrusion in record["protrusions"]:
        lengths = [border["length"] for border in record["borders"]
                   if len({is_in(segment, protrusion["segment"]) for segment in border["segments"]}) == 2]
        # which the default method adds up in single precision
        if not math.isclose(sum(lengths), protrusion["border_length"], rel_tol=1e-6):
            yield f"the borders of segment {protrusion['segment']} have another length than all of it"

def problems_with_confidence(record):
    for measure in record["measures"]:
        values = [protrusion["value"] for protrusion in record["protrusions"]
                  if measure["segment"] in (protrusion["segment"], protrusion["parent"])]
        if measure["confidence"] != min(values, default=None):
            yield f"the confidence of segment {measure['segment']} is not the least value of its borders"
    for protrusion in record["protrusions"]:
        if (protrusion["probability"] is None) != (record["method"] == "paper"):
            yield "only minimum-cut estimates probabilities"

validator = jsonschema.Draft7Validator(json.load(open(sys.argv[1])))
problems = 0
for name in sys.argv[2:]:
    record = json.load(open(name))
    found = [error.message[:200] for error in validator.iter_errors(record)]
    if "error" not in record:
        if abs(sum(stage["seconds"] for stage in record["stages"]) - record["seconds"]) > 1e-6:
            found.append("the stages take another time than all")
        if record["peak_memory"] is not None and record["peak_memory"] < 8 * record["faces"]:
            found.append("less memory than for the labels")
        if sum(measure["faces"] for measure in record["measures"]) != record["faces"]:
            found.append("the segments have another number of faces than all")
        found += problems_with_borders(record)
        found += problems_with_confidence(record)
    problems += len(found)
    for problem in found:
        print(f"{name}: {problem}", file=sys.stderr)
print(len(sys.argv) - 2, "records")
sys.exit(problems > 0)
END
  [ "$code" = 0 ] || fail "the records are not as the schema says"
}

code=0 command="" report_option=()
touch stdout stderr
test_usage
test_example_meshes
test_outputs
test_closed_parts
test_report
test_determinism
test_distances
test_number_of_segments
test_huge_and_tiny_coordinates
test_awkward_meshes
test_awkward_segmentations
test_unwritable_outputs
test_names_given_twice
test_words
test_sound_files
test_mistaken_names
test_nameless_files
test_pipes
test_3MF
test_VTP
test_collection
test_files_of_earlier_runs
test_ended_process
test_ended_parent
test_ended_while_writing
test_meshes_of_the_same_name
test_long_and_special_names
test_smooth_borders
test_tips
test_json_schema
echo "$failures failures"
[ "$failures" = 0 ]
