# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples and the README's program. What needs a library that is not there is skipped."""

import json
import re
import runpy
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import protrusion_segmentation as ps
from meshes import ball_with_arms

FOLDER = Path(__file__).resolve().parent.parent
POINTS, TRIANGLES = ball_with_arms()
LABELS = ps.segment(POINTS, TRIANGLES)


def example(name):
    return runpy.run_path(str(FOLDER / "examples" / name))["label"]


def test_meshio(tmp_path):
    meshio = pytest.importorskip("meshio")
    lines = np.array([[0, 1], [1, 2]])
    mesh = meshio.Mesh(POINTS, [("triangle", TRIANGLES[:99]), ("line", lines), ("triangle", TRIANGLES[99:])])
    example("label_with_meshio.py")(mesh)
    mesh.write(tmp_path / "mesh.vtk")
    first, of_lines, second = meshio.read(tmp_path / "mesh.vtk").cell_data["segment"]
    assert (np.concatenate([first, second]) == LABELS).all()
    assert (np.array(of_lines) == -1).all()


def test_trimesh():
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.Trimesh(POINTS, TRIANGLES, process=False)
    example("label_with_trimesh.py")(mesh)
    assert (mesh.face_attributes["segment"] == LABELS).all()
    assert len(np.unique(mesh.visual.face_colors, axis=0)) == LABELS.max() + 1


def test_trimesh_with_texture():
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.Trimesh(POINTS, TRIANGLES, process=False, visual=trimesh.visual.TextureVisuals(uv=POINTS[:, :2]))
    example("label_with_trimesh.py")(mesh)
    assert len(np.unique(mesh.visual.face_colors, axis=0)) == LABELS.max() + 1


def test_stand_in_for_trimesh(monkeypatch):
    """Runs where trimesh is not there: with objects that have what the example uses, and no more."""
    visual = SimpleNamespace(
        interpolate=lambda values, color_map: [(color_map, value) for value in values],
        ColorVisuals=lambda mesh, face_colors: SimpleNamespace(mesh=mesh, face_colors=face_colors),
    )
    monkeypatch.setitem(sys.modules, "trimesh", SimpleNamespace(Trimesh=SimpleNamespace, visual=visual))
    mesh = SimpleNamespace(vertices=POINTS, faces=TRIANGLES, face_attributes={}, visual=None)
    example("label_with_trimesh.py")(mesh)
    assert (mesh.face_attributes["segment"] == LABELS).all()
    assert mesh.visual.mesh is mesh
    assert mesh.visual.face_colors == [("viridis", label) for label in LABELS]


def test_stand_in_for_pyvista(monkeypatch):
    """The same for pyvista."""
    monkeypatch.setitem(sys.modules, "pyvista", SimpleNamespace(PolyData=SimpleNamespace))
    mesh = SimpleNamespace(points=POINTS.astype(np.float32), irregular_faces=tuple(TRIANGLES), cell_data={})
    example("label_with_pyvista.py")(mesh)
    assert mesh.cell_data["segment"].shape == LABELS.shape
    assert len(np.unique(mesh.cell_data["segment"])) == LABELS.max() + 1


def test_pyvista():
    pyvista = pytest.importorskip("pyvista")
    mesh = pyvista.PolyData.from_irregular_faces(POINTS, TRIANGLES)
    example("label_with_pyvista.py")(mesh)
    assert (mesh.cell_data["segment"] == LABELS).all()


def test_picture(tmp_path):
    pytest.importorskip("matplotlib")
    pytest.importorskip("meshio")
    picture = tmp_path / "mesh.png"
    show = runpy.run_path(str(FOLDER / "examples" / "show_segmentation.py"))["show"]
    found = show(POINTS, TRIANGLES, picture, 7)
    assert found.number_of_segments == 7
    assert picture.read_bytes().startswith(b"\x89PNG") and picture.stat().st_size > 20000


def test_notebook(capsys):
    """Its cells run, and what they print is what the notebook shows."""
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    names = {}
    cells = json.loads((FOLDER / "examples" / "segmentation.ipynb").read_text(encoding="utf-8"))["cells"]
    for cell in cells:
        if cell["cell_type"] == "code":
            exec("".join(cell["source"]), names)
            shown = ["".join(output["text"]) for output in cell["outputs"] if output["output_type"] == "stream"]
            assert capsys.readouterr().out == "".join(shown)
    assert names["found"].number_of_segments == 7


def test_programs_of_the_readme():
    programs = re.findall(r"```python\n(.*?)```", (FOLDER / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    assert programs
    names = {"vertices": POINTS, "faces": TRIANGLES}
    for program in programs:
        exec(program, names)
    assert (names["labels"] == LABELS).all()
