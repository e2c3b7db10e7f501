#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints benchmark/Protrusion_segmentation/Performance/files.md: how long segment_by_protrusions takes from a mesh file to a
PLY file with labels and how much memory, for a collection of meshes, and beside other readers.

file_times.py TOOL [--threads 1,2] [--collection FOLDER] [--readers MESH] FILE...

Other readers: assimp (Debian: assimp-utils) and VTK (python3-vtk9).
"""
import argparse
import json
import pathlib
import re
import subprocess
import tempfile
import time

REPETITIONS = 3  # the fastest counts


def table(*head):
    print("\n| " + " | ".join(head) + " |\n|---|" + "--:|" * (len(head) - 1))


def print_row(*cells):
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def record_of(tool, mesh, folder, *options):
    record = folder / "record.json"
    subprocess.run([tool, mesh, "--quiet", "--json", record, *options], check=True)
    return json.loads(record.read_text())


def seconds_of_file(record):
    return sum(stage["seconds"] for stage in record["stages"] if stage["stage"] == "file")


def print_files(tool, meshes, threads, folder):
    print("\n## 1. From file to labels\n\nBy the wall clock. *All* is of a run of its own, without the record of the others. "
          "Goal: ten million faces with two threads in 20 seconds and 3 GB.")
    table("file", "MB", "faces", "threads", "reading [s]", "segmentation [s]", "writing [s]", "all [s]", "most memory [GB]")
    for mesh in meshes:
        for number in threads:
            found = record_of(tool, mesh, folder, "--threads", number, "-o", folder / "out.ply")
            reading = seconds_of_file(found)
            start = time.perf_counter()  # once more, since the record takes time as well
            subprocess.run([tool, mesh, "--quiet", "--threads", number, "-o", folder / "out.ply"], check=True)
            print_row(mesh.name, f"{mesh.stat().st_size / 1e6:.3g}", found["faces"], number, f"{reading:.2f}",
                      f"{found['seconds'] - reading:.2f}", f"{found['writing_seconds']:.2f}",
                      f"{time.perf_counter() - start:.1f}", f"{found['peak_memory'] / 1e9:.2f}")


def print_collection(tool, collection, folder):
    print("\n## 2. A collection\n\nAll meshes of a folder in one call. Times the sum: of what the meshes take by themselves, over "
          "the number of jobs. Goal: 1.1.")
    table("folder", "meshes", "MB", "jobs", "seconds", "times the sum")
    meshes = [mesh for mesh in collection.rglob("*") if mesh.is_file()]
    megabytes = sum(mesh.stat().st_size for mesh in meshes) / 1e6
    alone = 0
    for jobs in (1, 2):
        start = time.perf_counter()
        subprocess.run([tool, collection, "--quiet", "--output-folder", folder / str(jobs), "--jobs", str(jobs)], check=True)
        seconds = time.perf_counter() - start
        alone = alone or seconds
        print_row(collection.name, len(meshes), f"{megabytes:.0f}", jobs, f"{seconds:.1f}", f"{seconds / (alone / jobs):.2f}")


def assimp_seconds(mesh):
    text = subprocess.run(["assimp", "info", mesh], capture_output=True, text=True).stdout
    found = re.search(r"import took approx\. ([\d.]+) seconds", text)
    return float(found[1]) if found else None


def vtk_seconds(mesh):
    import vtk
    readers = {".obj": vtk.vtkOBJReader, ".ply": vtk.vtkPLYReader, ".stl": vtk.vtkSTLReader,
               ".vtp": vtk.vtkXMLPolyDataReader}
    if mesh.suffix not in readers:
        return None
    reader = readers[mesh.suffix]()
    reader.SetFileName(str(mesh))
    start = time.perf_counter()
    reader.Update()
    return time.perf_counter() - start


def text_of_stl(mesh, path):
    import vtk
    reader = vtk.vtkSTLReader()
    reader.SetFileName(str(mesh))
    writer = vtk.vtkSTLWriter()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(str(path))
    writer.SetFileTypeToASCII()
    writer.Write()


def fastest(seconds):
    found = [seconds() for _ in range(REPETITIONS)]
    return "" if None in found else f"{min(found):.2f}"


def print_readers(tool, mesh, folder):
    print("\n## 3. Reading\n\nOne mesh in each format. This package's times include joining the faces to a surface and looking for "
          "what has to be repaired; the others read points and faces only.")
    table("file", "MB", "this package [s]", "assimp [s]", "VTK [s]")
    names = [folder / f"{mesh.stem}.{extension}" for extension in ("off", "obj", "ply", "stl", "vtp")]
    for name in names:
        subprocess.run([tool, mesh, "--quiet", "-o", name], check=True)
    names.append(folder / f"{mesh.stem}_text.stl")
    text_of_stl(folder / f"{mesh.stem}.stl", names[-1])
    for name in names:
        print_row(name.name, f"{name.stat().st_size / 1e6:.1f}", fastest(lambda: seconds_of_file(record_of(tool, name, folder))),
                  fastest(lambda: assimp_seconds(name)), fastest(lambda: vtk_seconds(name)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("tool", type=pathlib.Path)
    parser.add_argument("files", type=pathlib.Path, nargs="+")
    parser.add_argument("--threads", default="1,2", help="numbers of threads (default: %(default)s)")
    parser.add_argument("--collection", type=pathlib.Path, help="a folder of meshes")
    parser.add_argument("--readers", type=pathlib.Path, help="a mesh that is read in each format")
    arguments = parser.parse_args()
    options = "".join(f" --{name} {value.name}" for name, value in
                      (("collection", arguments.collection), ("readers", arguments.readers)) if value)
    names = " ".join(mesh.name for mesh in arguments.files)
    print(f"# Performance: files\n\n```\nscripts/file_times.py segment_by_protrusions --threads {arguments.threads}{options} "
          f"{names}\n```")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        print_files(arguments.tool, arguments.files, arguments.threads.split(","), folder)
        if arguments.collection:
            print_collection(arguments.tool, arguments.collection, folder)
        if arguments.readers:
            print_readers(arguments.tool, arguments.readers, folder)


if __name__ == "__main__":
    main()
