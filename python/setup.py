# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles the module by the CMakeLists.txt of the whole project, without anything else of it."""

import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = Path(__file__).resolve().parent.parent


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
        }
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        subprocess.run(["cmake", "-S", PROJECT, "-B", build, *definitions], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "protrusion_segmentation_python"], check=True)
        subprocess.run(["cmake", "--install", build, "--component", "python"], check=True)


def version() -> str:
    text = (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"^project\(\S+ VERSION (\S+)", text, re.MULTILINE)
    assert found, "CMakeLists.txt names no version"
    return found[1]


setup(
    version=version(),
    ext_modules=[Extension("protrusion_segmentation._core", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
)
