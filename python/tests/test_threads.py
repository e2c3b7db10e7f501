# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C, and other threads meanwhile."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import protrusion_segmentation as ps
from meshes import ball_with_arms

signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell that starts a job in the background has Ctrl-C ignored
POINTS, TRIANGLES = ball_with_arms(7)  # 327,680 faces
CALLS = {
    "segment": lambda: ps.segment(POINTS, TRIANGLES, 7),
    "diffusion": lambda: ps.segment(POINTS, TRIANGLES, 7, "paper", "diffusion"),
    "hierarchy": lambda: ps.hierarchy(POINTS, TRIANGLES, 7),
    "tips": lambda: ps.tips(POINTS, TRIANGLES, 50, "exact"),
    "evaluate": lambda: ps.evaluate(POINTS, TRIANGLES, TRIANGLES[:, 0] % 9, TRIANGLES[:, 0] % 10),
}
LONGEST_WAIT = 0.25  # that Ctrl-C may take, in seconds


def interrupted_after(delay, call):
    """The time from the signal to the exception, or None if the call was faster than the signal."""
    sent = []

    def send():
        time.sleep(delay)
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=send)
    thread.start()
    is_done = False
    try:
        call()
        is_done = True
        thread.join()
        time.sleep(1)  # here the signal comes
    except KeyboardInterrupt:
        caught = time.monotonic()
    thread.join()
    return None if is_done else caught - sent[0]


@pytest.mark.parametrize("name", CALLS)
def test_keyboard_interrupt_comes_at_once(name):
    waits = [interrupted_after(delay, CALLS[name]) for delay in (0.1, 0.3)]
    measured = [wait for wait in waits if wait is not None]
    assert measured, "no call took long enough to be interrupted"
    assert min(measured) < LONGEST_WAIT  # one may be late on a machine with other work
    assert (ps.segment(*ball_with_arms(3), 7) < 7).all()  # all works as before


@pytest.mark.parametrize("option", ["progress", "distance"])
def test_keyboard_interrupt_among_functions_of_python(option):
    """Then it is looked for when the watcher is asked, which is less often on a busy machine."""
    options = {"progress": lambda share: None, "distance": lambda graph: lambda face: graph.areas * (graph.areas[face] > 0)}
    wait = interrupted_after(0.3, lambda: ps.segment(POINTS, TRIANGLES, 7, **{option: options[option]}))
    assert wait is not None and wait < 20 * LONGEST_WAIT


def test_other_threads_run_meanwhile():
    longest_pause = 0.0
    is_done = False

    def count():
        nonlocal longest_pause
        last = time.monotonic()
        while not is_done:
            time.sleep(0.001)
            now = time.monotonic()
            longest_pause, last = max(longest_pause, now - last), now

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    ps.segment(POINTS, TRIANGLES, 7)
    duration = time.monotonic() - start
    is_done = True
    thread.join()
    assert longest_pause < duration / 3


def test_threads_get_the_same_labels():
    points, triangles = ball_with_arms(4)
    results = []
    threads = [threading.Thread(target=lambda: results.append(ps.segment(points, triangles, 7))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 4
    assert all((labels == results[0]).all() for labels in results)


def outcome(program):
    """The exit code of a program of its own, and what it writes to its standard output and error."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    done = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, timeout=300)
    return done.returncode, done.stdout, done.stderr


def test_the_process_ends_well_after_an_interrupt():
    program = (
        "import os, signal, threading\n"
        "import protrusion_segmentation as ps\n"
        "from meshes import ball_with_arms\n"
        "points, triangles = ball_with_arms(7)\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "threading.Timer(.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        "try:\n"
        "    ps.segment(points, triangles, 7, 'paper', 'diffusion')\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted')\n"
    )
    assert outcome(program) == (0, "interrupted\n", "")


def test_the_process_ends_well_while_another_thread_computes():
    program = (
        "import threading, time\n"
        "import protrusion_segmentation as ps\n"
        "from meshes import ball_with_arms\n"
        "points, triangles = ball_with_arms(7)\n"
        "threading.Thread(target=ps.segment, args=(points, triangles, 7, 'paper', 'diffusion'), daemon=True).start()\n"
        "time.sleep(.2)\n"
    )
    assert outcome(program) == (0, "", "")
