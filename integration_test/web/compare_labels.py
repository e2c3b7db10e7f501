#!/usr/bin/python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which meshes get the same segments from the page as from the tool.

    compare_labels.py PAGE SEGMENT_BY_PROTRUSIONS FOLDER [--every N] [-- OPTION...]

PAGE is the file that web/build.sh makes; its program runs under node. FOLDER holds the meshes, at any depth; with --every N only
every Nth is taken. OPTION... are options of segment_by_protrusions. Prints a line for each mesh whose segments differ, and the
share of the others, and how many times longer the page takes.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

EXTENSIONS = {".off", ".obj", ".ply", ".stl", ".ts", ".gltf", ".glb"}
RUNNER = pathlib.Path(__file__).with_name("run_page_program.js")


def page_results(page, folder, options, meshes):
    """What run_page_program.js tells of each mesh."""
    process = subprocess.run(["node", RUNNER, page, folder, json.dumps(options), *map(str, meshes)],
                             stdout=subprocess.PIPE, text=True, check=True)
    return [json.loads(line) for line in process.stdout.splitlines()]


def tool_result(tool, folder, options, mesh):
    """The labels as text, and the seconds; or the error."""
    labels, record = folder / "tool.seg", folder / "tool.json"
    done = subprocess.run([tool, mesh, *options, "-o", labels, "--json", record, "--quiet"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return None, done.stderr
    return labels.read_text(), json.loads(record.read_text())["seconds"]


def share_of_other_labels(left, right):
    pairs = list(zip(left.split(), right.split()))
    return sum(a != b for a, b in pairs) / len(pairs)


def compare(page, tool, options, meshes, tell=print):
    """The number of meshes with the same labels, and how many times longer the page takes for each."""
    same, ratios = 0, []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for mesh, of_page in zip(meshes, page_results(page, folder, options, meshes)):
            labels, seconds = tool_result(tool, folder, options, mesh)
            if labels is None or "error" in of_page:
                agree = labels is None and of_page.get("error", "").split(": ", 1)[-1] in seconds
                tell(f"{mesh}: {of_page.get('error', 'no error')}; the tool: {seconds}")
                same += agree
                continue
            here = (folder / f"{mesh.name}.seg").read_text()
            same += here == labels
            ratios.append(of_page["seconds"] / seconds)
            if here != labels:
                tell(f"{mesh}: {of_page['segments']} and {len(set(labels.split()))} segments, "
                     f"{100 * share_of_other_labels(here, labels):.1f} % of the faces have other labels")
    return same, ratios


def main():
    words = sys.argv[1:]
    options = words[words.index("--") + 1:] if "--" in words else []
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("segment_by_protrusions")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1)
    arguments = parser.parse_args(words[:words.index("--")] if "--" in words else words)
    meshes = sorted(file for file in arguments.folder.rglob("*") if file.suffix.lower() in EXTENSIONS)[::arguments.every]
    same, ratios = compare(arguments.page, arguments.segment_by_protrusions, options, meshes)
    print(f"{same} of {len(meshes)} meshes have the same labels: {100 * same / max(1, len(meshes)):.1f} %")
    if ratios:
        print(f"the page takes {statistics.median(ratios):.2f} times as long (median; most {max(ratios):.2f})")


if __name__ == "__main__":
    main()
