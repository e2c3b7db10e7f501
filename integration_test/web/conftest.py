# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that web/build.sh makes, under node and in a headless browser.

The environment says what is tested:
    PROTRUSION_SEGMENTATION_PAGE   the file
    PROTRUSION_SEGMENTATION_TOOLS  the folder of the tools
"""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))

SHAPES = ["chair", "hand", "horse", "octopus", "teddy"]


@pytest.fixture(scope="session")
def page_file():
    return pathlib.Path(os.environ["PROTRUSION_SEGMENTATION_PAGE"]).resolve()


@pytest.fixture(scope="session")
def tool():
    return pathlib.Path(os.environ["PROTRUSION_SEGMENTATION_TOOLS"]).resolve() / "segment_by_protrusions"


@pytest.fixture(scope="session")
def make_mesh(tool):
    def make(shape, file, faces=24000):
        subprocess.run([tool.with_name("make_example_mesh"), shape, file, "--faces", str(faces)], check=True,
                       stdout=subprocess.DEVNULL)
        return file
    return make


@pytest.fixture(scope="session")
def example_meshes(make_mesh, tmp_path_factory):
    folder = tmp_path_factory.mktemp("example_meshes")
    return [make_mesh(shape, folder / f"{shape}.off") for shape in SHAPES]


@pytest.fixture(scope="session")
def data():
    """The folder of awkward files."""
    return pathlib.Path(__file__).parents[1] / "data"


@pytest.fixture(scope="module")
def browser():
    report = pytest.importorskip("test_report", reason="needs Selenium")
    if not shutil.which("chromium") or not shutil.which("chromedriver"):
        pytest.skip("needs Chromium and its driver")
    browser = report.start_browser()
    yield browser
    browser.quit()
