# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in Blender: opens each file and prints what is there, as JSON in one line.

    blender --background --python see_in_blender.py -- FILE...
"""

import json
import sys

import bpy
import mathutils
import numpy

# Blender 3.4's importer of glTF uses names that numpy 1.24 has no more.
for name, of_python in (("bool", bool), ("int", int), ("float", float), ("object", object)):
    if name not in vars(numpy):
        setattr(numpy, name, of_python)


def open_file(path):
    extension = path.rsplit(".", 1)[1]
    importers = {"obj": lambda: bpy.ops.wm.obj_import(filepath=path, forward_axis="Y", up_axis="Z"),
                 "ply": lambda: bpy.ops.import_mesh.ply(filepath=path),
                 "stl": lambda: bpy.ops.import_mesh.stl(filepath=path)}
    gltf = lambda: bpy.ops.import_scene.gltf(filepath=path)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    importers.get(extension, gltf)()


def describe(element):
    if element.type == "ARMATURE":
        return {"name": element.name, "parents": {bone.name: bone.parent.name if bone.parent else None for bone in element.data.bones}}
    mesh = element.data
    corners = [element.matrix_world @ mathutils.Vector(corner) for corner in element.bound_box]
    return {"name": element.name,
            "slots": [slot.name for slot in element.material_slots],
            "slots_used": len({polygon.material_index for polygon in mesh.polygons}),
            "faces": len(mesh.polygons),
            "color_attributes": [attribute.name for attribute in mesh.color_attributes],
            "uv_layers": [layer.name for layer in mesh.uv_layers],
            "vertex_groups": [group.name for group in element.vertex_groups],
            "low": [min(corner[i] for corner in corners) for i in range(3)],
            "high": [max(corner[i] for corner in corners) for i in range(3)]}


def move_each_bone():
    """For each bone that is turned, the vertex groups of the vertices that move with it."""
    armatures = [element for element in bpy.data.objects if element.type == "ARMATURE"]
    meshes = [element for element in bpy.data.objects if element.type == "MESH" and element.find_armature()]
    if not armatures:
        return None
    (armature,), (mesh,) = armatures, meshes
    groups = [mesh.vertex_groups[max(vertex.groups, key=lambda group: group.weight).group].name
              for vertex in mesh.data.vertices]

    def coordinates():
        bpy.context.view_layer.update()
        evaluated = mesh.evaluated_get(bpy.context.evaluated_depsgraph_get())
        return [vertex.co.copy() for vertex in evaluated.data.vertices]

    before, moved = coordinates(), {}
    for bone in armature.pose.bones:
        bone.rotation_mode = "XYZ"
        bone.rotation_euler = (1, 1, 0)
        moved[bone.name] = sorted({group for group, old, new in zip(groups, before, coordinates())
                                   if (old - new).length > 1e-3})
        bone.rotation_euler = (0, 0, 0)
    return moved


for file in sys.argv[sys.argv.index("--") + 1:]:
    open_file(file)
    seen = [describe(element) for element in bpy.data.objects if element.type in ("MESH", "ARMATURE")]
    print("SEEN " + json.dumps({"file": file, "objects": seen, "moved": move_each_bone()}))
