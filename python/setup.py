# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles the module by the CMakeLists.txt of the whole project, without anything else of it.

The project is the folder above, or in a source distribution the folder `project`, which has what the module needs.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

HERE = Path(__file__).resolve().parent
IN_DISTRIBUTION = HERE / "project"
PROJECT = IN_DISTRIBUTION if IN_DISTRIBUTION.exists() else HERE.parent
NEEDED = [
    "CMakeLists.txt",
    "LICENSE",
    "cmake",
    "include",
    "python/CMakeLists.txt",
    "python/protrusion_segmentation",
    "python/source",
    "tools/reading",
    "tools/repair",
]


class BuildByCMake(build_ext):
    def build_extension(self, ext: Extension) -> None:
        build = Path(self.build_temp).resolve()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_REQUIRE_FIND_PACKAGE_pybind11": "ON",
            "CMAKE_INSTALL_PREFIX": Path(self.get_ext_fullpath(ext.name)).resolve().parent.parent,
            "PROTRUSION_SEGMENTATION_PYTHON_FOLDER": ".",
            "Python_EXECUTABLE": sys.executable,
            "BUILD_TESTING": "OFF",
            "PROTRUSION_SEGMENTATION_BUILD_EXAMPLES": "OFF",
            "PROTRUSION_SEGMENTATION_BUILD_TOOLS": "OFF",
            "PROTRUSION_SEGMENTATION_INSTALL": "OFF",
            "PROTRUSION_SEGMENTATION_LITTLE_MEMORY": "ON",
            **pybind11_of_python(),
        }
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        subprocess.run(["cmake", "-S", PROJECT, "-B", build, *definitions], check=True)
        target = ["--config", "Release", "--target", "protrusion_segmentation_python"]
        subprocess.run(["cmake", "--build", build, *target], check=True)
        subprocess.run(["cmake", "--install", build, "--component", "python"], check=True)


class SourceDistribution(sdist):
    def make_release_tree(self, base_dir: str, files: "list[str]") -> None:
        super().make_release_tree(base_dir, files)
        no_caches = shutil.ignore_patterns("__pycache__", "*.so")
        for name in NEEDED:
            source, target = PROJECT / name, Path(base_dir) / "project" / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if source.is_dir():
                shutil.copytree(source, target, ignore=no_caches)
            else:
                shutil.copyfile(source, target)
        shutil.copyfile(PROJECT / "LICENSE", Path(base_dir) / "LICENSE")


def pybind11_of_python() -> "dict[str, str]":
    """Where pybind11 is if pip has installed it; else CMake looks on the system."""
    try:
        import pybind11
    except ImportError:
        return {}
    return {"pybind11_DIR": pybind11.get_cmake_dir()}


def version() -> str:
    text = (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"^project\(\S+ VERSION (\S+)", text, re.MULTILINE)
    assert found, "CMakeLists.txt names no version"
    return found[1]


setup(
    version=version(),
    ext_modules=[Extension("protrusion_segmentation._core", sources=[])],
    cmdclass={"build_ext": BuildByCMake, "sdist": SourceDistribution},
)
