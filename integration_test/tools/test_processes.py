# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The processes that segment the meshes of a collection, where they end before their time."""

import pathlib
import resource
import shutil
import subprocess
import time

import pytest

from records import read_record
from tool import names_in


def limit_time():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (1, 1))


def test_ended_process(segment, example_meshes, tetrahedron, tmp_path):
    """A mesh whose process the system ends, here for want of time, has failed, and no other."""
    large = example_meshes / "large.off"
    result = segment.run(large, tetrahedron, *"--distance exact --output-folder out".split(),
                         preexec_fn=limit_time)
    assert result.code == 1
    message = f"{large}: its process was ended by signal "
    assert message in result.err
    assert "2 meshes: 1 segmented, 0 already there, 1 failed" in result.err
    assert names_in(tmp_path / "out") == ["large.json", "tetrahedron.json", "tetrahedron.seg"]
    assert read_record(tmp_path / "out/large.json")["error"].startswith(message)


def is_running(process):
    try:
        status = pathlib.Path(f"/proc/{process}/status").read_text()
    except FileNotFoundError:
        return False
    return "\nState:\tZ" not in status


def wait_until(condition):
    for _ in range(1000):
        if condition():
            return True
        time.sleep(.01)
    return False


def test_ended_parent(segment, example_meshes, tmp_path):
    """The processes end with the one that began them, also if that is killed."""
    shutil.copy(example_meshes / "large.off", tmp_path / "other.off")
    command = segment.command(example_meshes / "large.off", "other.off",
                              *"--distance exact --output-folder out --jobs 2".split())
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as parent:
        list_of_children = pathlib.Path(f"/proc/{parent.pid}/task/{parent.pid}/children")
        if not list_of_children.exists():
            parent.kill()
            pytest.skip("no list of children on this system")
        assert wait_until(lambda: len(list_of_children.read_text().split()) == 2)
        children = list_of_children.read_text().split()
        parent.kill()
    assert wait_until(lambda: not any(map(is_running, children)))
