# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Help, versions, and command lines that make no sense."""

import re

import pytest

from tool import names_in

OPTIONS = {
    "segment_by_protrusions":
        "--help --version --segments --of --method --distance --landmarks --eigenpairs --time --seed "
        "--threads --smooth-borders --tips --labels --names --output --close --borders --json --report --quiet "
        "--output-folder --format --jobs --again",
    "evaluate_segmentation": "--help --json",
    "make_example_mesh": "--help --faces",
}

MEANINGLESS = """
    -k 0 | -k -3 | -k 2.5 | -k many | -k 0x10
    --threads 0 | --threads -1 | --threads 1.5
    --method other | --distance other | --seed -1
    --distance landmark --landmarks 0 | --distance landmark --landmarks 0%
    --distance landmark --landmarks 101% | --distance landmark --landmarks 5%%
    --distance landmark --landmarks -5 | --landmarks 5%
    --distance diffusion --eigenpairs 0 | --distance diffusion --eigenpairs -1
    --distance diffusion --eigenpairs 2.5 | --distance diffusion --time -1
    --distance diffusion --time nan | --distance diffusion --time inf
    --distance diffusion --time soon | --distance diffusion --landmarks 5%
    --eigenpairs 5 | --time 1 | --distance heat --time 1 | --distance exact --eigenpairs 5
    -o out.xyz | -o out | -o %d.seg | -o %d/%d.ply | -o out.seg --close | --close
    -o %d.off --close=round | --borders out.off | --borders out
    -k 3 --tips out.json | -o out.seg -o out.seg | -o out.seg --json out.seg
    --json out.html --report out.html | -o
    --jobs 2 | --format ply | --again
    --of 3 | -k 3 --of 2 | -k 3 --of 0 | --tips a.json --of 3
    --labels a.seg -k 3 | --labels a.seg --tips a.json | --labels a.seg --seed 1 | --labels a.seg --method paper
    -o %s.obj -o a.obj | -o %s.obj -o %d.obj | -o a%s.obj -o ab%s.obj | -o %s%d.obj | -o %s.seg
"""


def calls(table):
    return [call.strip() for line in table.strip().splitlines() for call in line.split("|")]


@pytest.fixture(params=["segment", "evaluate", "make_mesh"])
def tool(request):
    return request.getfixturevalue(request.param)


def test_help_lists_every_option(tool):
    text = tool("--help").out
    assert "usage" in text.lower()
    missing = [option for option in OPTIONS[tool.program.name].split()
               if not re.search(rf"(^|[\s,]){option}\b", text)]
    assert not missing


def test_help_fits_100_columns(tool):
    assert max(map(len, tool("--help").out.splitlines())) <= 100


def test_version(segment):
    assert re.fullmatch(r"segment_by_protrusions \d+\.\d+\.\d+\n", segment("--version").out)


def test_no_arguments_and_unknown_options(tool, tetrahedron, tmp_path):
    tool.refuses(code=2)
    tool.refuses(tetrahedron, "--no-such-option", code=2)
    assert names_in(tmp_path) == []


def test_one_file_is_not_enough_to_evaluate(evaluate, tetrahedron):
    evaluate.refuses(tetrahedron, code=2)


@pytest.mark.parametrize("options", calls(MEANINGLESS))
def test_meaningless_options(segment, tetrahedron, tmp_path, options):
    segment.refuses(tetrahedron, *options.split(), code=2)
    assert names_in(tmp_path) == []


def test_output_in_the_place_of_the_input(segment, teddy):
    before = teddy.read_bytes()
    segment.refuses(teddy, "-o", teddy, code=2)
    assert teddy.read_bytes() == before


def test_folder_without_an_output_folder(segment, data):
    segment.refuses(data, code=2, message="--output-folder")


def test_several_meshes_without_an_output_folder(segment, tetrahedron, data):
    segment.refuses(tetrahedron, data / "quads.off", code=2)


@pytest.mark.parametrize("options, message", [
    ("-k 0", "'0' is "),
    ("-k -3", "'-3' is "),
    ("-k abc", "'abc' is "),
    ("-k 2.5", "'2.5' is "),
    ("-k 99999999999999999999999", "'99999999999999999999999' is "),
])
def test_message_on_a_number_of_segments_is_short(segment, teddy, options, message):
    assert len(segment.refuses(teddy, *options.split(), code=2, message=message).err) < 120


@pytest.mark.parametrize("options, message", [
    ("--seed 4294967296", "'4294967296' is no seed, an integer from 0 to 4294967295"),
    ("--threads 5000000", "'5000000' is no number of threads, an integer from 1 to 1024"),
    ("--distance heat --time 1", "--time has no meaning with heat, only with diffusion"),
    ("--join-pieces=0", "'0' is no distance above 0"),
    ("-o a.ply --one-object", "--one-object has no meaning without an output in glTF"),
    ("--rig a.glb --one-object", "--one-object has no meaning without an output in glTF"),
    ("-o a.seg --up z", "--up has no meaning without an output in glTF or USD"),
    ("-o a.ply --array-name Label", "--array-name has no meaning without an output in VTP"),
    ("-o a.stl --colors input", "--colors has no meaning without an output in PLY, OBJ or glTF"),
    ("-o a.seg --triangulate", "--triangulate has no meaning without an output of a mesh"),
    ("--json a.json --triangulate", "--triangulate has no meaning without an output of a mesh"),
    ("--close %d.off", "'%d.off' is no mesh; an output is named by -o"),
    ("--close faired -o %d.off", "'faired' is no mesh; caps are chosen by --close=faired"),
])
def test_message_on_an_option(segment, teddy, options, message):
    segment.refuses(teddy, *options.split(), code=2, message=message)


@pytest.mark.parametrize("before", [[], ["teddy.off"]])
def test_message_on_caps_in_the_place_of_the_mesh(segment, before):
    segment.refuses("--close", "faired", *before, "-o", "%d.off", code=2,
                    message="'faired' is no mesh; caps are chosen by --close=faired")


def test_leading_zeros(segment, make_mesh, teddy, tmp_path):
    """010 is ten, and 09 a number."""
    record = segment.record(teddy, *("-k 010 --seed 08 --threads 01 --distance diffusion "
                                     "--eigenpairs 012").split())
    assert record["segments"] == 10
    assert record["seed"] == 8
    assert record["eigenpairs"] == 12
    make_mesh("chair", "zeros.off", "--faces", "01010")


def test_message_on_a_number_of_faces(make_mesh):
    make_mesh.refuses("octopus", "a.off", "--faces", "999", code=2,
                      message="'999' is no number of faces, an integer from 1000 to 1000000")
