#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints benchmark/Protrusion_segmentation/Performance/files.md: how long segment_by_protrusions takes from a mesh file to a
PLY file with labels, and how much memory.

file_times.py TOOL [--threads 1,2] FILE...
"""
import argparse
import json
import pathlib
import subprocess
import tempfile


def row(tool, mesh, threads, folder):
    record = folder / "record.json"
    subprocess.run([tool, mesh, "--quiet", "--threads", threads, "-o", folder / "out.ply", "--json", record],
                   check=True)
    found = json.loads(record.read_text())
    reading = sum(stage["seconds"] for stage in found["stages"] if stage["stage"] == "file")
    cells = [mesh.name, f"{mesh.stat().st_size / 1e6:.3g}", found["faces"], threads, f"{reading:.2f}",
             f"{found['seconds'] - reading:.2f}", f"{found['writing_seconds']:.2f}", f"{found['peak_memory'] / 1e9:.2f}"]
    return "| " + " | ".join(map(str, cells)) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("tool", type=pathlib.Path)
    parser.add_argument("files", type=pathlib.Path, nargs="+")
    parser.add_argument("--threads", default="1,2", help="numbers of threads (default: %(default)s)")
    arguments = parser.parse_args()
    names = " ".join(mesh.name for mesh in arguments.files)
    print(f"# Performance: files\n\n```\nscripts/file_times.py segment_by_protrusions --threads {arguments.threads} {names}\n"
          "```\n\nFrom file to labels with the command line tool, by the wall clock. Goal: ten million faces in 35 seconds and "
          "6 GB.\n\n| file | MB | faces | threads | reading [s] | segmentation [s] | writing [s] | most memory [GB] |\n"
          "|---|--:|--:|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as temporary:
        for mesh in arguments.files:
            for threads in arguments.threads.split(","):
                print(row(arguments.tool, mesh, threads, pathlib.Path(temporary)), flush=True)


if __name__ == "__main__":
    main()
