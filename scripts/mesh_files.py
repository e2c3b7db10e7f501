#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints a table, in Markdown, of what segment_by_protrusions makes of the mesh files in folders, and whether a second
reader finds as many faces. Debian: assimp-utils, meshlab, xvfb.

mesh_files.py TOOL [--before OTHER_TOOL] FOLDER...
"""
import argparse
import json
import pathlib
import re
import subprocess
import tempfile

EXTENSIONS = {".off", ".obj", ".ply", ".stl", ".ts", ".vtp", ".3mf"}
SECONDS = 120


def output_of(*command):
    """Standard output, errors and exit code; nothing after a while."""
    try:
        run = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=SECONDS)
        return run.stdout, run.stderr, run.returncode
    except (subprocess.TimeoutExpired, FileNotFoundError):
        return "", "", None


def number(pattern, text):
    match = re.search(pattern, text)
    return int(match[1]) if match else None


def faces_by_assimp(mesh):
    return number(r"Faces:\s+(\d+)", output_of("assimp", "info", mesh, "--raw")[0])


def faces_by_meshlab(mesh):
    out, errors, _ = output_of("xvfb-run", "-a", "meshlabserver", "-i", mesh)
    return number(r"loaded has \d+ vn (\d+) fn", out + errors)


def second_opinion(mesh, faces, triangles):
    """MeshLab makes triangles of all faces, so that their number is right, too."""
    by_assimp = faces_by_assimp(mesh)
    if by_assimp == faces:
        return "assimp"
    by_meshlab = faces_by_meshlab(mesh)
    if by_meshlab == faces:
        return "MeshLab"
    if by_meshlab == triangles:
        return f"MeshLab: {triangles} triangles"
    return f"no: assimp {by_assimp or '-'}, MeshLab {by_meshlab or '-'}"


def reason(errors, mesh):
    return errors.strip().removeprefix("segment_by_protrusions: ").removeprefix(f"{mesh}: ")


def number_of_triangles(off):
    """Of an OFF file that the tool has written: a fan for each face."""
    lines = [line for line in off.read_text().splitlines() if line]
    vertices = int(lines[1].split()[0])
    return sum(max(0, int(line.split()[0]) - 2) for line in lines[2 + vertices:])


def result_of(tool, mesh, folder):
    record, labels, off = folder / "record.json", folder / "labels.seg", folder / "mesh.off"
    _, errors, code = output_of(tool, mesh, "--quiet", "--json", record, "-o", labels, "-o", off)
    if code != 0:
        return {"reason": "refused: " + reason(errors, mesh) if code == 1 else f"exit code {code}"}
    found = json.loads(record.read_text())
    return {"faces": found["faces"], "segments": found["segments"], "labels": len(labels.read_text().split()),
            "note": re.sub(r"(; )?found no evident.*", "", found["note"] or ""), "triangles": number_of_triangles(off)}


def row(arguments, mesh, name, folder):
    new = result_of(arguments.tool, mesh, folder)
    cells = [f"`{name}`"]
    if "reason" in new:
        by_assimp = faces_by_assimp(mesh)
        cells += ["", "", "", "assimp" if not by_assimp else f"no: assimp {by_assimp}"]
    else:
        opinion = second_opinion(mesh, new["faces"], new["triangles"])
        cells += [str(new["faces"]), str(new["labels"]), str(new["segments"]), opinion]
    if arguments.before:
        old = result_of(arguments.before, mesh, folder)
        is_same = "segments" in old and (old["faces"], old["segments"]) == (new.get("faces"), new.get("segments"))
        cells.append("same" if is_same or old == new else old.get("reason") or f"{old['faces']} / {old['segments']}")
    cells.append(new.get("reason") or new["note"])
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("tool", type=pathlib.Path)
    parser.add_argument("folders", type=pathlib.Path, nargs="+")
    parser.add_argument("--before", type=pathlib.Path)
    arguments = parser.parse_args()
    titles = ["file", "faces", "labelled", "segments", "a second reader", "before: faces / segments", "note"]
    if not arguments.before:
        titles.remove("before: faces / segments")
    with tempfile.TemporaryDirectory() as temporary:
        for folder in arguments.folders:
            print("| " + " | ".join(titles) + " |")
            print("|---|--:|--:|--:|" + "---|" * (len(titles) - 4))
            for mesh in sorted(folder.rglob("*")):
                if mesh.suffix.lower() in EXTENSIONS:
                    print(row(arguments, mesh, mesh.relative_to(folder), pathlib.Path(temporary)), flush=True)
            print()


if __name__ == "__main__":
    main()
