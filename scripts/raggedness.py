#!/usr/bin/python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""How ragged borders are, with and without --smooth-borders.

    raggedness.py SEGMENT_BY_PROTRUSIONS MESH...

The raggedness is the length of all closed borders over that of the same lines straightened: each point becomes the mean of
those within 1/32 of the line's length before and behind it. A circle has 1.006.
"""

import json
import math
import pathlib
import subprocess
import sys

STEPS = 256  # points in equal distances that take the place of those of a line
REACH = STEPS // 32


def length(points):
    return sum(math.dist(p, q) for p, q in zip(points, points[1:] + points[:1]))


def resampled(points, whole):
    """STEPS points in equal distances along a closed line."""
    result, walked, target = [], 0.0, 0.0
    for p, q in zip(points, points[1:] + points[:1]):
        step = math.dist(p, q)
        while target < walked + step and len(result) < STEPS:
            share = (target - walked) / step
            result.append([a + share * (b - a) for a, b in zip(p, q)])
            target += whole / STEPS
        walked += step
    return result


def straightened(points):
    result = []
    for i in range(len(points)):
        near = [points[(i + j) % len(points)] for j in range(-REACH, REACH + 1)]
        result.append([sum(coordinates) / len(near) for coordinates in zip(*near)])
    return result


def raggedness(record):
    lines = [border for border in record["borders"] if border["is_closed"] and border["length"] > 0]
    straight = sum(length(straightened(resampled(b["points"], b["length"]))) for b in lines)
    return sum(b["length"] for b in lines) / straight if straight > 0 else math.nan


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    print("| mesh | faces | segments | ragged | smooth |\n|:--|--:|--:|--:|--:|")
    sums = [[], []]
    for mesh in sys.argv[2:]:
        values = []
        for options in ([], ["--smooth-borders"]):
            output = subprocess.run([sys.argv[1], mesh, "--json", "-", *options], check=True, capture_output=True)
            record = json.loads(output.stdout)
            values.append(raggedness(record))
        print(f"| {pathlib.Path(mesh).name} | {record['faces']} | {record['segments']} |", end=" ")
        print(" | ".join(f"{value:.3f}" for value in values), "|", flush=True)
        if not any(map(math.isnan, values)):
            for column, value in zip(sums, values):
                column.append(value)
    print("| mean | | |", " | ".join(f"{sum(column) / len(column):.3f}" for column in sums), "|")


if __name__ == "__main__":
    main()
