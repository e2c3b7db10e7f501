#!/usr/bin/env bash
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the result files of the benchmarks again. DATA holds psb (the Princeton benchmark), second_benchmark, and data (CGAL's).
#
#   remake_results.sh BUILD_FOLDER DATA [Quality/results.md ...]      (default: all files but those of mesh files and fuzzing)
set -euo pipefail

build=$(realpath "$1")/benchmark/Protrusion_segmentation
results=$(realpath "$(dirname "${BASH_SOURCE[0]}")")/../benchmark/Protrusion_segmentation
version=$(git -C "$results" rev-parse --short HEAD)
cd "$2"
shift 2

princeton() # TITLE OPTION...
{
  "$build/princeton_benchmark" --title "$1" "${@:2}" --threads 2
}

# The default method, and those whose names match.
methods_like() # PATTERN
{
  echo "Minimum-cut,$("$build/princeton_benchmark" --list-methods | grep -xE "$1" | paste -sd,)"
}

peers="Paper-GD|Randomized-cuts|Core-extraction|Spectral-cuts|Planar-cuts|SDF-3-0.1|SDF-5-0.26|K-Means|Voronoi|One-segment"
distances="Paper-GD,Paper-LGD(5),Paper-DD(5),Paper-DD(10),Paper-DD(k),Paper-heat,Paper-exact"
distances+=",Minimum-cut,Minimum-cut-DD(10),Minimum-cut-heat,Minimum-cut-exact"
princeton_title="Development models of the Princeton Segmentation Benchmark"

content() # FILE
{
  case $1 in
  Quality/results.md)
    princeton "Quality: development models of the Princeton Segmentation Benchmark" --folder psb --by-class \
      --methods "$(methods_like "Minimum-cut-automatic|$peers")" ;;
  Quality/second_results.md)
    princeton "Quality: second benchmark" --folder second_benchmark --classes People=1-200,Rigged=201-300 --by-class \
      --methods "$(methods_like "Minimum-cut-automatic|$peers")" ;;
  Quality/random_results.md)
    [[ -d random_shapes ]] || "$build/make_random_shapes" random_shapes --of-each-kind 40 --seed 1000 > /dev/null
    princeton "Quality: random shapes whose parts are known" --folder random_shapes --by-class \
      --methods Minimum-cut,Minimum-cut-automatic,Paper-GD,Paper-GD-automatic ;;
  Quality/ablation.md)
    princeton "Quality: the default method without one ingredient" --folder psb --models 4-396/8 \
      --methods "$(methods_like "Without-.*")" ;;
  Quality/distances.md)
    princeton "Quality: distances" --folder psb --models 125,398,200,52,342,58,386,360,60,46,260,348 \
      --methods "$distances" ;;
  Quality/remeshing.md)
    princeton "Quality: other meshes of the same shapes" --folder psb --models 4-396/8 \
      --methods Minimum-cut,Remeshed-half,Remeshed-double,Remeshed-anisotropic ;;
  Quality/border_probabilities.md)
    sed '/^## /,$d' "$results/$1"
    "$build/border_probabilities" --title "$princeton_title" --folder psb
    echo
    "$build/border_probabilities" --title "Second benchmark" --folder second_benchmark \
      --classes People=1-200,Rigged=201-300 ;;
  Quality/cut_weights.md)
    "$build/fit_cut_weights" --folder psb --models 4-400/4 ;;
  Performance/results.md)
    "$build/performance_benchmark" --folder psb ;;
  Invariance/results.md)
    "$build/invariance_benchmark" --folder psb/off --every 8 --methods Minimum-cut-automatic,Minimum-cut,Paper-GD ;;
  Robustness/results.md)
    sed '/^## /,$d' "$results/$1"
    "$build/robustness_benchmark" --title "CGAL's demo data" --folder data \
      --methods "Minimum-cut,Minimum-cut-automatic,Paper-GD,Paper-LGD(1),Paper-DD(10),Minimum-cut-heat,SDF-5-0.26"
    echo
    "$build/robustness_benchmark" --title "CGAL's demo data, up to 1,000 faces" --folder data --maximum-faces 1000 \
      --methods Paper-exact,Minimum-cut-exact
    echo
    "$build/robustness_benchmark" --title "$princeton_title" --folder psb/off \
      --methods Minimum-cut,Minimum-cut-automatic,Paper-GD ;;
  *)
    echo "$0: there is no command for $1" >&2
    return 1 ;;
  esac
}

if [[ $# == 0 ]]; then
  set -- Quality/{results,second_results,random_results,ablation,distances,remeshing,border_probabilities,cut_weights}.md \
    {Performance,Invariance,Robustness}/results.md
fi
for file; do
  # The title and, below it, of which version the results are.
  content "$file" | sed -e '/^Of version [0-9a-f]*\.$/,+1d' -e "1s/\$/\n\nOf version $version./" > "$results/$file.new"
  mv "$results/$file.new" "$results/$file"
done
