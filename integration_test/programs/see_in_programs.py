#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens what segment_by_protrusions writes in other programs, and tells what they see there.

    see_in_programs.py SEGMENT_BY_PROTRUSIONS MAKE_EXAMPLE_MESH FOLDER

Programs that are not installed are skipped: Blender, PrusaSlicer, MeshLab, VTK for Python, f3d. (Debian: blender prusa-slicer
meshlab python3-vtk9 f3d xvfb). Pictures of f3d stay in the folder, to be looked at.
"""

import collections
import json
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

NUMBER = 9  # the octopus' body and arms
LONGEST_TIME = 300
MEASURES_IN_MESHLAB = '<!DOCTYPE FilterScript><FilterScript><filter name="Per Face Quality Stat"/></FilterScript>'


def run(*command, with_screen=False):
    """The output of a command, whatever its exit code is: some of these programs fail when they end."""
    if with_screen:
        command = ("xvfb-run", "-a", *command)
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          stdin=subprocess.DEVNULL, timeout=LONGEST_TIME, check=False)
    return done.stdout.decode(errors="replace")


def tell(program, file, text):
    print(f"{program:12} {file:22} {text}", flush=True)


def bounds(folder):
    points = [list(map(float, line.split())) for line in (folder / "octopus.off").read_text().splitlines()[2:]
              if len(line.split()) == 3]
    return [(min(axis), max(axis)) for axis in zip(*points)]


def check_place(seen, expected):
    """Everything together is where the mesh is."""
    for axis, (low, high) in enumerate(expected):
        assert abs(min(one["low"][axis] for one in seen) - low) < 1e-4, (seen, expected)
        assert abs(max(one["high"][axis] for one in seen) - high) < 1e-4, (seen, expected)


def check_rig(line):
    """Each bone moves its segment and all that hangs on it. An end, which is at a tip, moves nothing."""
    (armature,) = [one for one in line["objects"] if "parents" in one]
    parents, moved = armature["parents"], line["moved"]
    tell("Blender", "rig.glb", f"an armature of {len(parents)} bones; segments that each moves: "
         f"{ {bone: len(groups) for bone, groups in moved.items()} }")

    def hangs_on(bone, other):
        return bone is not None and (bone == other or hangs_on(parents[bone], other))

    for bone, groups in moved.items():
        assert groups == sorted(other for other in parents if hangs_on(other, bone) and not other.endswith(" end"))


def blender(folder):
    if not shutil.which("blender"):
        return False
    names = ["a.obj", "a.ply", "a.stl", "a.glb", "one.glb", "one.gltf", "rig.glb"]
    output = run("blender", "--background", "--factory-startup", "--python",
                 pathlib.Path(__file__).with_name("see_in_blender.py"), "--", *(folder / name for name in names))
    lines = [json.loads(line[5:]) for line in output.splitlines() if line.startswith("SEEN ")]
    assert len(lines) == len(names), output
    for name, line in zip(names, lines):
        seen = line["objects"]
        if name == "rig.glb":
            check_rig(line)
            continue
        slots = {slot for one in seen for slot in one["slots"]}
        colors = [attribute for one in seen for attribute in one["color_attributes"]]
        tell("Blender", name, f"{len(seen)} objects, {len(slots)} material slots {sorted(slots)[:2]}, "
             f"{len(colors)} colour attributes")
        check_place(seen, bounds(folder))
        assert len(seen) == (NUMBER if name == "a.glb" else 1)
        assert name in ("a.ply", "a.stl") or len(slots) == NUMBER
        assert all(one["slots_used"] == max(len(one["slots"]), 1) for one in seen)
        assert name != "a.ply" or len(colors) == 1
    return True


def prusa_slicer(folder):
    if not shutil.which("prusa-slicer"):
        return False
    low = bounds(folder)[0][0]
    for name, objects in (("a.3mf", 1), ("parts.3mf", NUMBER), ("a.stl", 1), ("a.obj", 1)):
        output = run("prusa-slicer", "--info", folder / name)
        volumes = [float(volume) for volume in re.findall(r"volume = (\S+)", output)]
        places = [float(place) for place in re.findall(r"min_x = (\S+)", output)]
        tell("PrusaSlicer", name, f"{len(volumes)} objects, {output.count('manifold = yes')} of them manifold, "
             f"volume {sum(volumes):.4f}")
        assert len(volumes) == output.count("manifold = yes") == objects, output
        assert abs(min(places) - low) < 1e-4
    output = run("prusa-slicer", "--info", *(folder / f"connected/{i}.stl" for i in range(NUMBER)))
    volumes = [float(volume) for volume in re.findall(r"volume = (\S+)", output)]
    tell("PrusaSlicer", "connected/%d.stl", f"{len(volumes)} parts with pegs and sockets, {output.count('manifold = yes')} of "
         f"them manifold, volume {sum(volumes):.4f}")
    assert len(volumes) == output.count("manifold = yes") == NUMBER, output
    run("prusa-slicer", "--export-3mf", "--output", folder / "again.3mf", folder / "a.3mf")
    with zipfile.ZipFile(folder / "again.3mf") as archive:
        model = archive.read("3D/3dmodel.model").decode()
    painted = collections.Counter(re.findall(r'mmu_segmentation="(\w+)"', model))
    tell("PrusaSlicer", "a.3mf", f"triangles painted: {dict(painted)}")
    assert len(painted) == NUMBER
    settings = "--scale 8 --center 100,100 --single-extruder-multi-material --layer-height 0.3".split()
    for option, value in (("nozzle-diameter", "0.4"), ("filament-diameter", "1.75"), ("temperature", "200")):
        settings += [f"--{option}", ",".join(5 * [value])]
    run("prusa-slicer", *settings, "--export-gcode", "--output", folder / "a.gcode", folder / "a.3mf")
    tools = collections.Counter(re.findall(r"^T(\d)", (folder / "a.gcode").read_text(), re.MULTILINE))
    tell("PrusaSlicer", "a.3mf", f"sliced for five filaments, changes to each: {dict(tools)}")
    assert len(tools) == 5
    return True


def meshlab(folder):
    """Its server in Debian reads no OBJ at all, and no 3MF."""
    if not shutil.which("meshlabserver"):
        return False
    (folder / "measures.mlx").write_text(MEASURES_IN_MESHLAB)
    output = run("meshlabserver", "-i", folder / "a.ply", "-s", folder / "measures.mlx", "-o", folder / "meshlab.ply",
                 "-m", "fq", "fc", with_screen=True)
    largest = re.findall(r"Min \S+ Max (\S+)", output)[-1]
    header = (folder / "meshlab.ply").read_bytes().split(b"end_header")[0]
    tell("MeshLab", "a.ply", f"face quality up to {largest}; face colours: {b'property uchar red' in header}")
    assert float(largest) == NUMBER - 1 and b"property uchar red" in header
    return True


def vtk(folder):
    try:
        import vtk as library
    except ImportError:
        return False
    for name, reader in (("a.vtp", library.vtkXMLPolyDataReader()), ("a.ply", library.vtkPLYReader()),
                         ("a.obj", library.vtkOBJReader()), ("a.stl", library.vtkSTLReader())):
        reader.SetFileName(str(folder / name))
        reader.Update()
        cells = reader.GetOutput().GetCellData()
        arrays = {cells.GetArrayName(i): cells.GetArray(i).GetRange() for i in range(cells.GetNumberOfArrays())
                  if cells.GetArray(i)}
        tell("VTK", name, f"{reader.GetOutput().GetNumberOfCells()} cells, cell data {arrays}")
        assert name != "a.vtp" or arrays["segment"] == (0, NUMBER - 1)
        assert name != "a.obj" or arrays["GroupIds"] == (0, NUMBER - 1)
    return True


def f3d(folder):
    if not shutil.which("f3d"):
        return False
    for name, options in (("a.glb", []), ("one.glb", ["--up=+Y"]), ("a.obj", ["--up=+Z"]),
                          ("a.ply", ["--up=+Z", "--scalars", "--comp=-2"]),
                          ("a.vtp", ["--up=+Z", "--scalars=color", "--cells", "--comp=-2"])):
        picture = folder / (name + ".png")
        output = run("f3d", folder / name, "--output", picture, *options, with_screen=True)
        assert picture.exists(), output
        tell("f3d", name, f"picture {picture.name}")
    return True


def write_files(segment, make_mesh, folder):
    folder.mkdir(parents=True, exist_ok=True)
    run(make_mesh, "octopus", folder / "octopus.off")
    outputs = [word for extension in "seg obj ply stl 3mf glb gltf vtp".split()
               for word in ("-o", folder / f"a.{extension}")]
    # Blender turns what is up in glTF to its z-axis, so that --up z brings the mesh to its place.
    print(run(segment, folder / "octopus.off", "-k", NUMBER, "--up", "z", *outputs))
    print(run(segment, folder / "octopus.off", "--labels", folder / "a.seg", "--up", "z", "--one-object",
              "-o", folder / "one.glb", "-o", folder / "one.gltf", "--rig", folder / "rig.glb"))
    print(run(segment, folder / "octopus.off", "--labels", folder / "a.seg", "--close", "-o", folder / "parts.3mf"))
    print(run(segment, folder / "octopus.off", "--labels", folder / "a.seg", "--close", "--connectors",
              "-o", folder / "connected/%d.stl", "-o", folder / "connected.3mf"))


def main():
    segment, make_mesh, folder = map(pathlib.Path, sys.argv[1:])
    write_files(segment, make_mesh, folder)
    are_there = [see(folder) for see in (blender, prusa_slicer, meshlab, vtk, f3d)]
    return 0 if any(are_there) else 77


if __name__ == "__main__":
    sys.exit(main())
