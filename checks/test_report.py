#!/usr/bin/python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `segment_by_protrusions --report` in a headless browser, read from the file system.

    test_report.py SEGMENT_BY_PROTRUSIONS MAKE_EXAMPLE_MESH WORK_FOLDER [--faces N] [--method NAME]

Clicks, turns, moves the slider, and leaves pictures in WORK_FOLDER. Exit code 77, skipped, where the
tool has no --report or Chromium, its driver or Selenium are not installed.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import time

SKIPPED = 77
LONGEST_PAUSE = 0.5  # seconds for a click or a step of the slider

try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.chrome.service import Service
except ImportError:
    sys.exit(SKIPPED)


def start_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for argument in ("headless=new", "no-sandbox", "window-size=1200,800", "use-angle=swiftshader",
                     "enable-unsafe-swiftshader", "disable-dev-shm-usage", "host-resolver-rules=MAP * 127.0.0.1:9"):
        options.add_argument("--" + argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))


class Page:
    def __init__(self, browser, file):
        self.browser = browser
        browser.get(file.resolve().as_uri())

    def run(self, script):
        return self.browser.execute_script(script)

    def text(self, part):
        return self.browser.find_element(By.ID, part).text

    def click_at(self, x, y):
        actions = ActionChains(self.browser)
        actions.w3c_actions.pointer_action.move_to_location(x, y).click()
        actions.perform()

    def set_level(self, level):
        self.run(f"const s = document.getElementById('level'); s.value = {level};"
                 "s.dispatchEvent(new Event('input'));")

    def seconds(self, script):
        return self.run(f"const begin = performance.now(); {script}; return (performance.now() - begin) / 1000;")

    def pixels(self):
        """How many pixels of the canvas are not background."""
        return self.run("""
            const view = report.view; view.renderer.render(view.scene, view.camera);
            const gl = view.renderer.getContext(), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
            const data = new Uint8Array(4 * w * h);
            gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, data);
            let count = 0;
            for (let i = 0; i < data.length; i += 4)
              count += data[i] < 250 || data[i + 1] < 250 || data[i + 2] < 250;
            return count;""")


# draws, and waits for the pixels
FRAME = """const view = report.view, gl = view.renderer.getContext();
view.turn(0.1, 0); view.renderer.render(view.scene, view.camera);
gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))"""


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def check_click(page, record):
    """A click on the tip of a protrusion that can be seen shows the protrusion."""
    expect("No segment is selected" in page.text("details"), "a segment is selected at the beginning")
    seen = 0
    for protrusion in record["protrusions"]:
        x, y = map(round, page.run(f"return report.view.positionOf({protrusion['tip']})"))
        if page.run(f"return report.view.segmentAt({x}, {y})") != protrusion["segment"]:
            continue  # hidden by another part
        page.click_at(x, y)
        details = page.text("details")
        expect(f"Segment {protrusion['segment']}" in details, f"the click shows '{details}'")
        expect(f"tip at face {protrusion['tip']}" in details, f"no tip in '{details}'")
        has_slot = protrusion["border_slot"] is not None
        expect(len(page.browser.find_elements(By.CSS_SELECTOR, "#details svg")) == 2 * has_slot,
               "the histograms are missing")
        expect((f"slot {protrusion['border_slot']}" in details) == has_slot, "no slot")
        seen += 1
    expect(seen > 0, "no tip can be clicked")


def check_slider(page, record):
    most, least = record["segments"], record["segments"] - len(record["protrusions"])
    for level in range(most, least - 1, -1):
        page.set_level(level)
        shown = page.run("return new Set(report.model.ancestors.map(a => a)).size")
        expect(shown == level, f"{shown} segments at level {level}")
        expect(len(page.browser.find_elements(By.CSS_SELECTOR, "#tree button")) == level, "wrong tree")
    page.set_level(most)


def check_turning(page):
    before = page.run("return report.view.turned.quaternion.toArray()")
    canvas = page.browser.find_element(By.ID, "canvas")
    ActionChains(page.browser).drag_and_drop_by_offset(canvas, 150, 40).perform()
    expect(page.run("return report.view.turned.quaternion.toArray()") != before, "dragging does not turn")


def check_speed(page, record):
    times = {"click": page.seconds("report.select(report.view.segmentAt(400, 400))"),
             "slider": page.seconds(f"report.setLevel({record['segments'] - 1})"),
             "frame": min(page.seconds(FRAME) for _ in range(3))}
    print(f"{record['faces']} faces:", ", ".join(f"{name} {1000 * t:.0f} ms" for name, t in times.items()))
    for name in ("click", "slider"):  # the time of a frame is that of a processor instead of a graphics card
        expect(times[name] < LONGEST_PAUSE, f"{name} takes {times[name]} s")


def check(page, record, work):
    expect(page.text("title") == pathlib.Path(record["input"]).name, "the title is not the name of the input")
    expect("three.js" in page.run("return document.getElementById('licence').textContent"), "no licence")
    expect(page.pixels() > 10000, "nothing is drawn")
    page.browser.save_screenshot(str(work / "begin.png"))
    check_click(page, record)
    page.browser.save_screenshot(str(work / "clicked.png"))
    check_slider(page, record)
    check_turning(page)
    check_speed(page, record)
    page.browser.save_screenshot(str(work / "end.png"))
    errors = [entry["message"] for entry in page.browser.get_log("browser") if entry["level"] == "SEVERE"]
    expect(not errors, f"errors in the page: {errors}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("segment_by_protrusions")
    parser.add_argument("make_example_mesh")
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--faces", default="4000")
    parser.add_argument("--method", default="paper")
    arguments = parser.parse_args()
    if not shutil.which("chromium") or not shutil.which("chromedriver"):
        sys.exit(SKIPPED)
    shutil.rmtree(arguments.work, ignore_errors=True)
    arguments.work.mkdir(parents=True)
    mesh, html, found = (arguments.work / name for name in ("octopus.off", "octopus.html", "octopus.json"))
    subprocess.run([arguments.make_example_mesh, "octopus", mesh, "--faces", arguments.faces], check=True)
    tool = subprocess.run([arguments.segment_by_protrusions, mesh, "-k", "9", "--method", arguments.method,
                           "--report", html, "--json", found], capture_output=True, text=True, check=False)
    if "three.js was not found" in tool.stderr:
        sys.exit(SKIPPED)
    expect(tool.returncode == 0, tool.stderr)
    begin = time.monotonic()
    browser = start_browser()
    try:
        page = Page(browser, html)
        print(f"loaded after {time.monotonic() - begin:.1f} s, the start of the browser included")
        check(page, json.loads(found.read_text(encoding="utf-8")), arguments.work)
    finally:
        browser.quit()


if __name__ == "__main__":
    main()
