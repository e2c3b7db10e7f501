# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pegs and sockets of closed parts."""

import math

import pytest

from mesh_files import volume_of_closed
from records import read_record

CALL = "-k 9 -o parts/%d.off --close --connectors --json a.json".split()


def area_of_polygon(sides, apothem):
    return sides * apothem ** 2 * math.tan(math.pi / sides)


def test_pegs_of_an_octopus(segment, octopus, tmp_path):
    segment(octopus, *"-k 9 -o flat/%d.off --close".split())
    segment(octopus, *CALL, *"--tolerance 0.004 --peg-sides 5 --peg-chamfer 0 --smallest-peg 0".split())
    record = read_record(tmp_path / "a.json")
    assert record["connectors_requested"]["tolerance"] == 0.004 and record["connectors_requested"]["sides"] == 5
    connectors = record["connectors"]
    assert sorted(connector["segment"] for connector in connectors) == list(range(1, 9))
    gaps = 0
    for connector in connectors:
        if connector["status"] == "placed":
            assert connector["tolerance"] == 0.004
            assert math.isclose(math.dist(connector["base"], connector["end"]), connector["depth"], rel_tol=1e-9)
            apothem, depth = connector["radius"] * math.cos(math.pi / 5), connector["depth"]
            gaps += area_of_polygon(5, apothem + 0.004) * (depth + 0.004) - area_of_polygon(5, apothem) * depth
    assert sum(connector["status"] == "placed" for connector in connectors) >= 5
    flat, with_pegs = ([tmp_path / folder / f"{i}.off" for i in range(9)] for folder in ("flat", "parts"))
    assert math.isclose(volume_of_closed(flat) - volume_of_closed(with_pegs), gaps, rel_tol=1e-6)


def test_caps_without_pegs_are_told(segment, octopus, tmp_path):
    result = segment(octopus, *CALL, *"--smallest-peg 1".split())
    assert "connectors on 0 of 8 caps, none at segments 1, " in result.err and "(the cap is too small)" in result.err
    record = read_record(tmp_path / "a.json")
    assert "cap too small" in {connector["status"] for connector in record["connectors"]} <= {"cap too small", "cap not flat"}
    segment(octopus, *"-k 9 -o flat/%d.off --close".split())
    for i in range(9):
        assert (tmp_path / f"parts/{i}.off").read_bytes() == (tmp_path / f"flat/{i}.off").read_bytes()


def test_record_without_connectors(segment, octopus, tmp_path):
    segment(octopus, *"-k 9 --json a.json".split())
    record = read_record(tmp_path / "a.json")
    assert record["connectors"] is None and record["connectors_requested"] is None


@pytest.mark.parametrize("options, message", [
    ("-o %d.off --connectors", "--connectors has no meaning without --close=flat"),
    ("-o %d.off --close=faired --connectors", "--connectors has no meaning without --close=flat"),
    ("-o %d.off --close --tolerance 1", "--tolerance requires --connectors"),
    ("-o %d.off --close --connectors --tolerance -1", "'-1' is no number of at least 0"),
    ("-o %d.off --close --connectors --tolerance wide", "'wide' is no number of at least 0"),
    ("-o %d.off --close --connectors --peg-radius 1", "'1' is no number above 0 and below 1"),
    ("-o %d.off --close --connectors --peg-depth 0", "'0' is no number above 0"),
    ("-o %d.off --close --connectors --peg-chamfer 0.6", "'0.6' is no number from 0 to 0.5"),
    ("-o %d.off --close --connectors --peg-sides 2", "'2' is no number of sides, an integer from 3 to 1000"),
])
def test_wrong_options(segment, tetrahedron, options, message):
    segment.refuses(tetrahedron, *options.split(), code=2, message=message)
