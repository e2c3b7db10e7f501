#!/usr/bin/python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `segment_by_protrusions --report` in a headless browser, read from the file system.

    test_report.py SEGMENT_BY_PROTRUSIONS MAKE_EXAMPLE_MESH WORK_FOLDER [--faces N] [--method NAME]

Clicks, turns, moves the slider, merges, renames, picks tips, saves, and leaves pictures in WORK_FOLDER. Exit code 77, skipped, where the
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
MOST_BYTES_OF_FACE = 30  # of a large mesh
LONGEST_PAUSE = 0.5  # seconds for a click or a step of the slider

try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
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
        self.downloads = file.resolve().parent / "saved"
        browser.execute_cdp_cmd("Browser.setDownloadBehavior",
                                {"behavior": "allow", "downloadPath": str(self.downloads)})
        browser.get(file.resolve().as_uri())

    def run(self, script):
        return self.browser.execute_script(script)

    def text(self, part):
        return self.browser.find_element(By.ID, part).text

    def click_at(self, x, y):
        actions = ActionChains(self.browser)
        actions.w3c_actions.pointer_action.move_to_location(x, y).click()
        actions.perform()

    def button_of(self, segment):
        shown = self.run("return report.model.shownSegments()")
        names = [self.run(f"return report.editor.nameOf({s})") for s in shown]
        buttons = self.browser.find_elements(By.CSS_SELECTOR, "#tree button")
        return next(b for b in buttons if b.text.split(" (")[0] == names[shown.index(segment)])

    def click_button(self, part):
        self.browser.find_element(By.ID, part).click()

    def save(self, part, name):
        """The file that a button saves."""
        file = self.downloads / name
        file.unlink(missing_ok=True)
        self.click_button(part)
        for _ in range(100):
            if file.exists():
                return file
            time.sleep(0.1)
        raise AssertionError(f"{name} was not saved")

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


def expect_no_errors(browser):
    errors = [entry["message"] for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
    expect(not errors, f"errors in the page: {errors}")


def check_click(page, record):
    """A click on the tip of a protrusion that can be seen shows the protrusion."""
    expect("No segment is selected" in page.text("details"), "a segment is selected at the beginning")
    seen = 0
    for protrusion in record["protrusions"]:
        x, y = map(round, page.run(f"return report.view.positionOf({protrusion['tip']})"))
        if page.run(f"return report.model.segmentOfFace(report.view.faceAt({x}, {y}))") != protrusion["segment"]:
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
        shown = page.run("return new Set(report.model.ancestors).size")
        expect(shown == level, f"{shown} segments at level {level}")
        expect(len(page.browser.find_elements(By.CSS_SELECTOR, "#tree button")) == level, "wrong tree")
    page.set_level(most)


def check_nested(page, record, work, tool, mesh):
    """The page names the call that gives what the slider shows."""
    level = record["segments"] - 4
    page.set_level(level)
    options = ["-k", str(level), "--of", str(record["segments"])]
    expect(" ".join(options) in page.text("nested"), "the page does not say what it shows")
    page.browser.save_screenshot(str(work / "nested.png"))
    labels = work / "nested.seg"
    subprocess.run([tool, mesh, *options, "--method", record["method"], "-o", labels, "--quiet"], check=True)
    expect(page.run("return report.model.segText()") == labels.read_text(), "the call gives other segments")
    page.set_level(record["segments"])
    expect(page.text("nested") == "", "the finest segments are called nested")


def check_merging(page, record):
    """A selected protrusion is given to its parent, and comes back."""
    least = min(record["protrusions"], key=lambda protrusion: protrusion["value"])
    segment, parent = least["segment"], least["parent"]
    before = page.run("return report.model.segText()")
    page.button_of(segment).click()
    page.click_button("merge")
    expect(page.run("return report.model.number") == record["segments"] - 1, "no segment was merged")
    expect(page.run(f"return report.model.segmentOfFace({least['tip']})") ==
           page.run(f"return report.model.ancestors[{parent}]"), "the faces are not those of the parent")
    expect(f"Segment {parent}" in page.text("details"), "the parent is not selected")
    expect(page.run("return report.model.segText()") != before, "the labels are the same")
    page.click_button("undo")
    expect(page.run("return report.model.segText()") == before, "undoing does not bring the labels back")
    for _ in range(page.run("return report.editor.history.length")):
        page.click_button("undo")
    expect(not page.browser.find_element(By.ID, "undo").is_enabled(), "there is more to undo than was done")


def rename(page, segment, name):
    page.button_of(segment).click()
    field = page.browser.find_element(By.ID, "name")
    field.send_keys(Keys.CONTROL, "a")
    field.send_keys(name + "\n")


def check_renaming(page):
    rename(page, 1, "left <arm>")
    expect("left <arm>" in page.text("tree"), "the tree does not show the name")
    expect("Segment left <arm>" in page.text("details"), "the name is not that of the segment")


def check_colors(page, record):
    """Body and protrusions get the colour of their confidence; the one to check first is red."""
    before = page.run("return Array.from(report.view.geometry.attributes.color.array)")
    page.run("const c = document.getElementById('colors'); c.value = 'confidence'; c.dispatchEvent(new Event('change'));")
    expect(page.run("return Array.from(report.view.geometry.attributes.color.array)") != before, "the colours stay")
    confidence = {m["segment"]: m["confidence"] for m in record["measures"]}
    for segment, value in confidence.items():
        expect(abs(page.run(f"return report.model.confidence({segment})") - value) < 1e-12, "another confidence")
    colors = [page.run(f"return colorOf(report.model, {s})") for s in sorted(confidence, key=confidence.get)]
    expect(colors[0][0] - colors[0][2] >= colors[-1][0] - colors[-1][2], "the least sure is not the reddest")
    if all(p["probability"] is not None for p in record["protrusions"]):  # all arms are clear
        expect(all(color[2] > color[0] for color in colors), "a sure segment is red")
    expect("check first" in page.text("tools"), "the scale is not shown")


def check_further_tip(page):
    """Where there is no smaller segment, the page says so, keeps the tip and saves it, too."""
    face = page.run("return report.model.segments.indexOf(0)")
    page.run(f"report.editor.pick({face})")
    page.click_button("from_tips")
    expect(f"ends at face {face}." in page.text("message"), "the page does not say that there is no segment")
    expect(page.run("return JSON.parse(report.editor.tipsText()).tips")[-1] == face, "the further tip is not saved")
    page.browser.save_screenshot(str(page.downloads.parent / "no_segment.png"))
    page.run(f"report.editor.pick({face})")
    expect(page.text("message") == "", "the message stays")


def check_clicks_without_effect(page):
    """They are answered with a word."""
    x, y = page.run("""
        const canvas = report.view.canvas.getBoundingClientRect();
        for (let x = canvas.left + 5; x < canvas.right; x += 10)
          for (let y = canvas.top + 5; y < canvas.bottom; y += 10)
            if (report.view.faceAt(x, y) < 0)
              return [x, y];""")
    page.click_at(round(x), round(y))
    expect("no face" in page.text("message"), "a click beside the mesh is not answered")
    page.browser.find_element(By.ID, "canvas").send_keys(Keys.DELETE)
    expect("No segment" in page.text("message"), "merging nothing is not answered")
    page.button_of(0).click()
    page.browser.find_element(By.ID, "canvas").send_keys(Keys.DELETE)
    expect("no parent" in page.text("message"), "merging a body is not answered")
    page.run("report.select(-1)")


def check_first_view(page):
    """All vertices are on the canvas."""
    outside = page.run("""
        const view = report.view; view.scene.updateMatrixWorld();
        let largest = 0;
        for (let v = 0; v < report.model.positions.length; v += 3)
        {
          const point = view.turned.localToWorld(new THREE.Vector3().fromArray(report.model.positions, v)).project(view.camera);
          largest = Math.max(largest, Math.abs(point.x), Math.abs(point.y));
        }
        return largest;""")
    expect(0.85 < outside < 1, f"the mesh fills {outside} of the canvas")


def check_tips(page, record, work, tool, mesh):
    """Of a page that shows the body alone, two tips are picked by clicks: their protrusions are shown. The tool makes of the saved
    file what it makes of these faces."""
    expect(all(page.run(f"return report.model.segmentOfFace(report.model.tip({p['segment']}))") == p["segment"]
               for p in record["protrusions"]), "the tip of a segment is not on it")
    page.set_level(record["segments"] - len(record["protrusions"]))
    page.browser.find_element(By.ID, "picking").click()
    picked = []
    for protrusion in record["protrusions"]:
        x, y = map(round, page.run(f"return report.view.positionOf({protrusion['tip']})"))
        if len(picked) < 2 and page.run(f"return report.model.segments[report.view.faceAt({x}, {y})]") == protrusion["segment"]:
            page.click_at(x, y)
            picked.append(protrusion["segment"])
    expect(len(picked) == 2, "there are no two tips to click at")
    tips = page.run("return report.editor.tips")
    expect([page.run(f"return report.model.segments[{tip}]") for tip in tips] == picked, "other tips were picked")
    page.browser.save_screenshot(str(work / "picked.png"))
    page.click_button("from_tips")
    expect(page.run("return report.model.shownSegments()") == [0] + sorted(picked), "other segments than those of the tips")
    expect(page.run("return report.editor.tips") == [], "tips of shown segments are still picked")
    check_further_tip(page)
    rename(page, picked[0], "an <arm>")
    tips = [page.run(f"return report.model.tip({segment})") for segment in picked]
    saved = page.save("save_tips", "octopus.tips.json")
    content = json.loads(saved.read_text(encoding="utf-8"))
    expect(sorted(content["tips"]) == sorted(tips), "other tips were saved")
    labels = work / "from_tips.seg"
    subprocess.run([tool, mesh, "--tips", saved, "-o", labels, "--quiet"], check=True)
    of_tool = labels.read_text(encoding="utf-8").split()
    expect(len(set(of_tool)) == 3 and len({of_tool[tip] for tip in tips}) == 2, "the tool makes other segments of the tips")
    of_page = page.save("save_seg", "octopus.seg").read_text(encoding="utf-8").split()
    expect(len(of_page) == record["faces"] and set(of_page) == {"0", "1", "2"}, "the saved segments are not 0, 1 and 2")
    for tip, segment in zip(tips, picked):
        expect(of_page[tip] == str(1 + sorted(picked).index(segment)), "a tip is not in its segment")


def check_labels(browser, work, tool, mesh):
    """What was saved is a segmentation with names, whose page says so."""
    saved = work / "saved"
    subprocess.run([tool, mesh, "--labels", saved / "octopus.seg", "--names", saved / "octopus.tips.json", "--quiet",
                    "-o", work / "parts/%s.obj", "--close", "--report", work / "labels.html"], check=True)
    expect(len(list((work / "parts").iterdir())) == 3 and (work / "parts/an__arm_.obj").exists(), "no part has the name")
    page = Page(browser, work / "labels.html")
    expect("an <arm>" in page.text("tree"), "the page does not show the name")
    expect("octopus.seg" in page.text("summary"), "the page does not say whose segments these are")
    expect(not page.browser.find_element(By.ID, "colors").is_displayed(), "there is confidence without values")
    page.button_of(page.run("return report.model.data.protrusions[0].segment")).click()
    expect("area beyond the border" in page.text("details"), "no details")
    page.browser.save_screenshot(str(work / "labels.png"))
    page.set_level(2)
    expect(page.run("return report.model.number") == 2, "the slider does not join segments")
    expect_no_errors(browser)


def parts_of_obj(file):
    """The triangles of each object, as points."""
    points, parts = [], {}
    for words in map(str.split, file.read_text(encoding="utf-8").splitlines()):
        if words[0] == "o":
            part = parts.setdefault(words[1], [])
        elif words[0] == "v":
            points.append(tuple(map(float, words[1:])))
        else:
            part.append([int(word) - 1 for word in words[1:]])
    return points, parts


def volume_of_closed(points, faces):
    edges = {edge for face in faces for edge in zip(face, face[1:] + face[:1])}
    expect(len(edges) == 3 * len(faces) and all((b, a) in edges for a, b in edges), "a part is not closed")
    return sum(ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
               for (ax, ay, az), (bx, by, bz), (cx, cy, cz) in ([points[i] for i in face] for face in faces)) / 6


def check_meshes(page, record, work, tool, mesh):
    """Meshes that the page saves: the tool reads them, and finds the segments in the coloured one."""
    ply = page.save("save_ply", "octopus.ply")
    labels = work / "of_ply.seg"
    subprocess.run([tool, ply, "--labels", ply, "-o", labels, "-o", work / "of_ply.off", "--quiet"], check=True)
    expect(page.run("return report.model.segText()") == labels.read_text(), "the coloured mesh has other segments")
    points, parts = parts_of_obj(page.save("save_obj", "octopus.parts.obj"))
    expect(len(parts) == page.run("return report.model.number"), "there is not an object for each segment")
    volumes = [volume_of_closed(points, faces) for faces in parts.values()]
    whole = volume_of_closed(*points_and_faces(mesh))
    expect(min(volumes) > 0 and abs(sum(volumes) - whole) < 0.001 * whole, f"the volumes {volumes} are not {whole} together")
    corners = {tuple(point) for point in points_and_faces(mesh)[0]}
    near = min(max(abs(a - b) for a, b in zip(points[0], corner)) for corner in corners)
    expect(near < 1e-3, "the coordinates are not those of the file")
    page.button_of(0).click()
    stl = page.save("save_stl", "octopus.segment_0.stl")
    subprocess.run([tool, stl, "-k", "1", "--quiet"], check=True)
    page.run("report.select(-1)")


def points_and_faces(off):
    lines = [line.split() for line in off.read_text().splitlines() if line.strip()]
    number = int(lines[1][0])
    return [tuple(map(float, line[:3])) for line in lines[2:2 + number]], [list(map(int, line[1:])) for line in lines[2 + number:]]


def check_turning(page):
    before = page.run("return report.view.turned.quaternion.toArray()")
    canvas = page.browser.find_element(By.ID, "canvas")
    ActionChains(page.browser).drag_and_drop_by_offset(canvas, 150, 40).perform()
    expect(page.run("return report.view.turned.quaternion.toArray()") != before, "dragging does not turn")


def check_speed(page, record):
    times = {"click": page.seconds("report.click(400, 400)"),
             "slider": page.seconds(f"report.setLevel({record['segments'] - 1})"),
             "frame": min(page.seconds(FRAME) for _ in range(3))}
    print(f"{record['faces']} faces:", ", ".join(f"{name} {1000 * t:.0f} ms" for name, t in times.items()))
    for name in ("click", "slider"):  # the time of a frame is that of a processor instead of a graphics card
        expect(times[name] < LONGEST_PAUSE, f"{name} takes {times[name]} s")


def check(page, record, work, tool, mesh):
    expect(page.text("title") == pathlib.Path(record["input"]).name, "the title is not the name of the input")
    expect("three.js" in page.run("return document.getElementById('licence').textContent"), "no licence")
    expect(page.pixels() > 10000, "nothing is drawn")
    page.browser.save_screenshot(str(work / "begin.png"))
    check_first_view(page)
    check_clicks_without_effect(page)
    check_click(page, record)
    page.browser.save_screenshot(str(work / "clicked.png"))
    check_slider(page, record)
    check_nested(page, record, work, tool, mesh)
    check_meshes(page, record, work, tool, mesh)
    check_merging(page, record)
    check_renaming(page)
    check_colors(page, record)
    page.browser.save_screenshot(str(work / "confidence.png"))
    check_tips(page, record, work, tool, mesh)
    check_turning(page)
    check_speed(page, record)
    page.browser.save_screenshot(str(work / "end.png"))
    expect_no_errors(page.browser)


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
    if int(arguments.faces) >= 100000:
        bytes_of_face = html.stat().st_size / json.loads(found.read_text(encoding="utf-8"))["faces"]
        print(f"{bytes_of_face:.1f} bytes a face")
        expect(bytes_of_face <= MOST_BYTES_OF_FACE, "the page is too large")
    begin = time.monotonic()
    browser = start_browser()
    try:
        page = Page(browser, html)
        print(f"loaded after {time.monotonic() - begin:.1f} s, the start of the browser included")
        check(page, json.loads(found.read_text(encoding="utf-8")), arguments.work, arguments.segment_by_protrusions, mesh)
        check_labels(browser, arguments.work, arguments.segment_by_protrusions, mesh)
    finally:
        browser.quit()


if __name__ == "__main__":
    main()
