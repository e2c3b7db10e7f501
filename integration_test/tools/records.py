# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The records in JSON that segment_by_protrusions writes: read, and checked."""

import json
import math
import pathlib

try:
    import jsonschema
except ImportError:
    jsonschema = None

ROOT = pathlib.Path(__file__).parents[2]
SCHEMA = json.loads((ROOT / "tools/writing/segmentation.schema.json").read_text())


def checked_record(text):
    """What the text says; it must be as the schema says, and its sums must be right."""
    record = json.loads(text)
    problems = list(problems_of(record))
    assert not problems, "\n".join(problems)
    return record


def read_record(path):
    return checked_record(pathlib.Path(path).read_text())


def problems_of(record):
    if jsonschema:
        for error in jsonschema.Draft7Validator(SCHEMA).iter_errors(record):
            yield error.message[:200]
    if "error" in record:
        return
    if abs(sum(stage["seconds"] for stage in record["stages"]) - record["seconds"]) > 1e-6:
        yield "the stages take another time than all"
    if record["peak_memory"] is not None and record["peak_memory"] < 8 * record["faces"]:
        yield "less memory than for the labels"
    if sum(measure["faces"] for measure in record["measures"]) != record["faces"]:
        yield "the segments have another number of faces than all"
    yield from problems_with_borders(record)
    yield from problems_with_confidence(record)


def problems_with_borders(record):
    for border in record["borders"]:
        points = border["points"] + border["points"][:1] * border["is_closed"]
        if not math.isclose(border["length"] or 0, sum(map(math.dist, points, points[1:])),
                            rel_tol=1e-9):
            yield f"the border of {border['segments']} is not as long as its line"
    if record["smooth_borders"]:
        return  # the lengths of protrusions are those along edges
    if record["method"] == "paper":
        return  # a border with a protrusion that was cut off before is not counted again
    for protrusion in record["protrusions"]:
        segments = segments_within(record, protrusion["segment"])
        length = sum(border["length"] for border in record["borders"]
                     if len(segments.intersection(border["segments"])) == 1)
        # The default method adds it up in single precision.
        if not math.isclose(length, protrusion["border_length"], rel_tol=1e-6):
            yield (f"the borders of segment {protrusion['segment']} have another length than "
                   "all of it")


def segments_within(record, segment):
    """The segment, and those that were cut off it."""
    result = [segment]
    for found in result:
        result += [p["segment"] for p in record["protrusions"] if p["parent"] == found]
    return set(result)


def problems_with_confidence(record):
    for measure in record["measures"]:
        values = [protrusion["value"] if record["method"] == "paper" else protrusion["probability"]
                  for protrusion in record["protrusions"]
                  if measure["segment"] in (protrusion["segment"], protrusion["parent"]) and not record["labels"]]
        if measure["confidence"] != min(values, default=None):
            yield (f"the confidence of segment {measure['segment']} is not the least of "
                   "its borders")
    for protrusion in record["protrusions"]:
        if (protrusion["probability"] is None) != (record["method"] != "minimum-cut"):
            yield "only minimum-cut estimates probabilities"
