# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program of the page in web/, compiled for this machine: its files are those of the tool."""

import json
import os
import subprocess
import zipfile

import pytest


class Page_program:
    """Answers questions of a page in a folder."""

    def __init__(self, folder):
        self.folder = folder
        self.process = subprocess.Popen([os.environ["PROTRUSION_SEGMENTATION_PAGE_PROGRAM"]], cwd=folder, text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def ask(self, question, content=""):
        text = content if isinstance(content, str) else json.dumps(content)
        print(question, text, file=self.process.stdin, flush=True)
        return json.loads(self.process.stdout.readline())

    def write(self, words, joined=(), names=(), archive=""):
        answer = self.ask("write", {"words": words, "joined": joined, "names": names, "archive": archive})
        assert "error" not in answer, answer
        return answer["files"]

    def read(self, name):
        return (self.folder / "out" / name).read_bytes()


@pytest.fixture
def page(tmp_path):
    program = Page_program(tmp_path)
    yield program
    program.process.stdin.close()
    assert program.process.wait(timeout=60) == 0


def test_examples_are_those_of_the_tool(page, make_mesh, tmp_path):
    assert "chair" in page.ask("about")["examples"]
    assert page.ask("example", "chair 1000") == {"file": "chair.off"}
    made = (tmp_path / "chair.off").read_bytes()
    make_mesh("chair", "again.off", "--faces", 1000)
    assert made == (tmp_path / "again.off").read_bytes()


@pytest.mark.parametrize("options", [["-k", "9"], ["--method", "paper"], ["--smooth-borders"]])
def test_files_are_those_of_the_tool(page, segment, octopus, options):
    data = page.ask("segment", ["octopus.off", *options])["data"]
    assert data["faces"] > 0 and data["mesh"]["positions"] and data["segments"] > 1
    names = [f"a.{extension}" for extension in ("3mf", "glb", "ply", "seg")]
    assert page.write(["octopus.off", *options, *(word for name in names for word in ("-o", f"out/{name}"))]) == names
    segment("octopus.off", *options, *(word for name in names for word in ("-o", name)))
    for name in names:
        assert page.read(name) == (octopus.parent / name).read_bytes(), name


def test_joined_segments_are_nested_ones(page, segment, octopus):
    """Without the last three protrusions, what is left is what the tool calls six of nine."""
    data = page.ask("segment", ["octopus.off", "-k", "9"])["data"]
    joined = [protrusion["segment"] for protrusion in data["protrusions"]][-3:]
    page.write(["octopus.off", "-o", "out/a.seg"], joined=joined)
    segment("octopus.off", "-k", 6, "--of", 9, "-o", "tool.seg")
    assert page.read("a.seg") == (octopus.parent / "tool.seg").read_bytes()
    page.write(["octopus.off", "-o", "out/a.seg"])
    segment("octopus.off", "-k", 9, "-o", "tool.seg")
    assert page.read("a.seg") == (octopus.parent / "tool.seg").read_bytes(), "the joined ones stay joined"


def test_any_protrusion_can_be_joined(page, octopus):
    data = page.ask("segment", ["octopus.off", "-k", "9"])["data"]
    whole = [int(line) for line in (page.write(["octopus.off", "-o", "out/a.seg"]), page.read("a.seg"))[1].split()]
    first = data["protrusions"][0]
    page.write(["octopus.off", "-o", "out/a.seg"], joined=[first["segment"]])
    expected = [first["parent"] if s == first["segment"] else s for s in whole]
    numbers = {s: i for i, s in enumerate(sorted(set(expected)))}
    assert [int(line) for line in page.read("a.seg").split()] == [numbers[s] for s in expected]


def test_archive_holds_the_closed_parts(page, segment, octopus):
    page.ask("segment", ["octopus.off", "-k", "3"])
    names = ["body", "", "an arm"]
    assert page.write(["octopus.off", "-o", "out/%s.stl", "--close"], names=names, archive="a.zip") == ["a.zip"]
    segment("octopus.off", "-k", 3, "-o", "parts/%d.stl", "--close")
    with zipfile.ZipFile(octopus.parent / "out" / "a.zip") as archive:
        assert sorted(archive.namelist()) == ["an_arm.stl", "body.stl", "segment_1.stl"]
        for number, name in enumerate(["body.stl", "segment_1.stl", "an_arm.stl"]):
            assert archive.read(name)[80:] == (octopus.parent / "parts" / f"{number}.stl").read_bytes()[80:]


def test_tips_with_names(page, octopus):
    first = page.ask("segment", ["octopus.off", "-k", "9"])["data"]["protrusions"][0]
    (octopus.parent / "tips.json").write_text(json.dumps(
        {"tips": [first["tip"]], "names": [{"face": first["tip"], "name": "arm"}]}))
    data = page.ask("segment", ["octopus.off", "--tips", "tips.json"])["data"]
    assert data["segments"] == 2
    assert [m["name"] for m in data["measures"]] == [None, "arm"]


def test_errors_are_those_of_the_tool(page, segment, octopus):
    (octopus.parent / "bad.off").write_text("no mesh\n")
    for words in (["bad.off"], ["missing.off"], ["octopus.off", "-k", "0"], ["octopus.off", "-k", "100000"],
                  ["octopus.off", "--time", "1"], ["octopus.off", "--help"]):
        error = page.ask("segment", words)["error"]
        if words[-1] != "--help":
            assert error in segment.run(*words, "--quiet").err, words
    assert "segmented" in page.ask("write", {"words": ["octopus.off"], "joined": [], "names": [], "archive": ""})["error"]
