#!/usr/bin/python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the table of benchmark/Protrusion_segmentation/Quality/segment_trees.md: what sticks out of what.

    segment_trees.py SEGMENT_BY_PROTRUSIONS FOLDER...

A segment touches another one if their border is at least a tenth of its longest border. An arm sticks out of an equal if both
touch the body and neither has more than twice the area of the other.
"""

import collections
import json
import pathlib
import subprocess
import sys

HEAD = """| meshes | number | protrusions | of the body | of another one, touching the body | of an equal | meshes with one |
|:--|--:|--:|--:|--:|--:|--:|"""


def borders_of(record):
    """The lengths of the borders of each segment with its neighbours."""
    result = collections.defaultdict(lambda: collections.defaultdict(float))
    for border in record["borders"]:
        for segment, other in (border["segments"], reversed(border["segments"])):
            result[segment][other] += border["length"]
    return result


def body_of(segment, parents):
    while segment in parents:
        segment = parents[segment]
    return segment


def counts(record):
    """Protrusions of the body; of another one though they touch the body; of an equal."""
    parents = {p["segment"]: p["parent"] for p in record["protrusions"]}
    area = [measure["area"] for measure in record["measures"]]
    borders = borders_of(record)

    def touches_body(segment):
        lengths = borders[segment]
        return lengths[body_of(segment, parents)] > 0.1 * max(lengths.values())

    of_body = touching = equal = 0
    for segment, parent in parents.items():
        if parent not in parents:
            of_body += 1
        elif touches_body(segment):
            touching += 1
            equal += touches_body(parent) and 0.5 <= area[segment] / area[parent] <= 2
    return [len(parents), of_body, touching, equal, equal > 0]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    print(HEAD)
    for folder in map(pathlib.Path, sys.argv[2:]):
        sums, number = [0] * 5, 0
        for mesh in sorted(folder.iterdir()):
            run = subprocess.run([sys.argv[1], mesh, "--quiet", "--json", "-"], capture_output=True, check=False)
            if run.returncode == 0:
                sums = [a + b for a, b in zip(sums, counts(json.loads(run.stdout)))]
                number += 1
        print("|", folder.name, "|", number, "|", " | ".join(map(str, sums)), "|", flush=True)


if __name__ == "__main__":
    main()
