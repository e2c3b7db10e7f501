# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line tools as a user meets them: exit codes, messages, files.

The environment says which tools are tested:
    PROTRUSION_SEGMENTATION_TOOLS      the folder of the programs
    PROTRUSION_SEGMENTATION_LIBRARIES  the libraries that they were built with, separated by commas,
                                       of tbb, lib3mf, vtk, tinygltf, three.js
"""

import os
import pathlib
import shutil

import pytest

from tool import Tool


@pytest.fixture(scope="session")
def programs():
    return pathlib.Path(os.environ["PROTRUSION_SEGMENTATION_TOOLS"])


@pytest.fixture(scope="session")
def libraries():
    return os.environ["PROTRUSION_SEGMENTATION_LIBRARIES"].split(",")


@pytest.fixture
def segment(programs, tmp_path):
    return Tool(programs / "segment_by_protrusions", tmp_path)


@pytest.fixture
def evaluate(programs, tmp_path):
    return Tool(programs / "evaluate_segmentation", tmp_path)


@pytest.fixture
def make_mesh(programs, tmp_path):
    return Tool(programs / "make_example_mesh", tmp_path)


@pytest.fixture(scope="session")
def data():
    """The folder of awkward files."""
    return pathlib.Path(__file__).parents[1] / "data"


@pytest.fixture(scope="session")
def example_meshes(programs, tmp_path_factory):
    """A folder with meshes that are made once."""
    folder = tmp_path_factory.mktemp("example_meshes")
    make = Tool(programs / "make_example_mesh", folder)
    for shape, name, faces in (("teddy", "teddy", 3000), ("horse", "horse", 1000),
                               ("hand", "large", 20000), ("octopus", "octopus", 4000)):
        make(shape, f"{name}.off", "--faces", faces)
    return folder


@pytest.fixture
def teddy(example_meshes, tmp_path):
    """3,000 faces, in teddy.off, which may be changed."""
    return shutil.copy(example_meshes / "teddy.off", tmp_path) and tmp_path / "teddy.off"


@pytest.fixture
def octopus(example_meshes, tmp_path):
    """A body with eight arms, in octopus.off, which may be changed."""
    return shutil.copy(example_meshes / "octopus.off", tmp_path) and tmp_path / "octopus.off"


@pytest.fixture
def tetrahedron(data):
    return data / "tetrahedron.off"
