# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program in the page, under node: the same labels as the tool's, the same errors, time, memory and size."""

import subprocess

import pytest

from compare_labels import compare, page_results

MOST_BYTES = 6000000
MOST_TIMES_AS_LONG = 3
MEGABYTES_OF_A_PAGE = 4096


def test_file_is_small(page_file):
    assert page_file.stat().st_size <= MOST_BYTES


@pytest.mark.parametrize("options", [[], ["-k", "5"], ["--method", "paper"], ["--method", "paper", "--distance", "landmark"],
                                     ["--distance", "heat"], ["--method", "paper", "--distance", "diffusion"],
                                     ["--smooth-borders"]])
def test_labels_of_examples(page_file, tool, example_meshes, options):
    lines = []
    same, _ = compare(page_file, tool, options, example_meshes, lines.append)
    assert same == len(example_meshes), lines


def test_examples_are_made_by_the_page(page_file, tool, tmp_path):
    """From a file that the page wrote, the tool finds the same."""
    [result] = page_results(page_file, tmp_path, [], ["example:octopus:24000"])
    labels = tmp_path / "tool.seg"
    subprocess.run([tool, tmp_path / "octopus.off", "-o", labels, "--quiet"], check=True)
    assert result["segments"] == 9 and labels.read_text() == (tmp_path / "octopus.off.seg").read_text()


def test_formats(page_file, tool, example_meshes, tmp_path):
    files = [tmp_path / f"chair.{extension}" for extension in ("obj", "ply", "stl", "glb", "gltf")]
    subprocess.run([tool, example_meshes[0], "-k", "1", "--quiet"] + [w for file in files for w in ("-o", file)], check=True)
    compressed = tmp_path / "zipped.off.gz"
    with open(compressed, "wb") as out:
        subprocess.run(["gzip", "-c", example_meshes[0]], stdout=out, check=True)
    lines = []
    same, _ = compare(page_file, tool, [], files + [compressed], lines.append)
    assert same == len(files) + 1, lines


def test_errors_are_those_of_the_tool(page_file, tool, data, tmp_path):
    files = [data / name for name in ("truncated_binary.ply", "empty.obj", "not_a_mesh.off", "huge_counts.ply", "draco.gltf",
                                      "index_out_of_range.obj", "truncated.off.gz")]
    for file, result in zip(files, page_results(page_file, tmp_path, [], files)):
        done = subprocess.run([tool, file, "--quiet"], capture_output=True, text=True, check=False)
        assert done.returncode == 1 and result["error"].startswith(f"{file.name}: ")
        assert done.stderr.replace(f"{file.parent}/", "").endswith(f"{result['error']}\n"), done.stderr


def test_time(page_file, tool, make_mesh, tmp_path):
    mesh = make_mesh("octopus", tmp_path / "octopus.off", 20000)
    for options in ([], ["--method", "paper"]):
        ratio = min(compare(page_file, tool, options, [mesh])[1][0] for _ in range(3))
        print(f"{' '.join(options)}: {ratio:.2f} times as long as the tool")
        assert ratio <= MOST_TIMES_AS_LONG


def test_a_million_faces(page_file, make_mesh, tmp_path):
    mesh = make_mesh("octopus", tmp_path / "octopus.off", 1000000)
    [result] = page_results(page_file, tmp_path, [], [mesh])
    assert "error" not in result, result
    print(f"{result['faces']} faces: {result['seconds']:.1f} s, {result['megabytes']:.0f} MB")
    assert result["segments"] == 9 and result["megabytes"] <= MEGABYTES_OF_A_PAGE
