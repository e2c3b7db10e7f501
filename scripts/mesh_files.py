#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints benchmark/Protrusion_segmentation/Robustness/mesh_files.md: how many mesh files in folders segment_by_protrusions
reads and labels, and for how many a second reader finds as many faces. Files for which something is missing are listed on the
standard error. Debian: assimp-utils, meshlab, xvfb.

mesh_files.py TOOL FOLDER...
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
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


def is_confirmed(mesh, faces, triangles):
    """MeshLab makes triangles of all faces, so that their number is right, too."""
    return faces_by_assimp(mesh) == faces or faces_by_meshlab(mesh) in (faces, triangles)


def number_of_triangles(off):
    """Of an OFF file that the tool has written: a fan for each face."""
    lines = [line for line in off.read_text().splitlines() if line]
    vertices = int(lines[1].split()[0])
    return sum(max(0, int(line.split()[0]) - 2) for line in lines[2 + vertices:])


def what_is_missing(tool, mesh, folder):
    """The columns of the table, from the first one on, in which the file does not count."""
    record, labels, off = folder / "record.json", folder / "labels.seg", folder / "mesh.off"
    _, errors, code = output_of(tool, mesh, "--quiet", "--json", record, "-o", labels, "-o", off)
    if code == 1:
        return ["read", "labelled", "confirmed"], errors.strip()
    if code != 0:
        return ["read", "labelled", "confirmed", "refused"], f"{mesh}: exit code {code}"
    faces = json.loads(record.read_text())["faces"]
    missing = [] if len(labels.read_text().split()) == faces else ["labelled"]
    if not is_confirmed(mesh, faces, number_of_triangles(off)):
        missing.append("confirmed")
    return missing + ["refused"], f"{mesh}: not {', '.join(missing)}" if missing else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("tool", type=pathlib.Path)
    parser.add_argument("folders", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()
    print("# Robustness: mesh files\n\n```\nscripts/mesh_files.py segment_by_protrusions",
          *(folder.name for folder in arguments.folders))
    print("```\n\nWhat the command line tool makes of mesh files: how many it reads and labels, and for how many a second "
          "reader (assimp or\nMeshLab) finds as many faces. The refused files are point sets.\n\n"
          "| folder | files | read | every face labelled | confirmed by a second reader | refused |\n"
          "|---|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as temporary:
        for folder in arguments.folders:
            files = [mesh for mesh in sorted(folder.rglob("*")) if mesh.suffix.lower() in EXTENSIONS]
            counts = dict.fromkeys(("read", "labelled", "confirmed", "refused"), len(files))
            for mesh in files:
                missing, message = what_is_missing(arguments.tool, mesh, pathlib.Path(temporary))
                for column in missing:
                    counts[column] -= 1
                if message:
                    print(message, file=sys.stderr)
            print("|", folder.name, "|", len(files), "|", " | ".join(map(str, counts.values())), "|", flush=True)


if __name__ == "__main__":
    main()
