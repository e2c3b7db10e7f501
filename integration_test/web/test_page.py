# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page in a headless browser, read from the file system: by clicks, as a newcomer uses it."""

import base64
import json
import shutil
import subprocess
import time
import zipfile

import pytest

pytest.importorskip("selenium")
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.support.ui import Select, WebDriverWait  # noqa: E402

from test_report import Page, expect_no_errors  # noqa: E402

LONGEST_SEGMENTATION = 120  # seconds


class Segmenting_page(Page):
    def wait(self, condition, seconds=LONGEST_SEGMENTATION):
        return WebDriverWait(self.browser, seconds, 0.05).until(lambda browser: condition())

    def is_busy(self):
        return self.run("return document.body.classList.contains('busy')")

    def wait_until_done(self):
        self.wait(lambda: not self.is_busy())

    def open(self, *files):
        self.browser.find_element(By.ID, "files").send_keys("\n".join(map(str, files)))
        self.wait_until_done()

    def open_example(self, name):
        self.wait(lambda: self.run("return document.body.classList.contains('ready')"))
        next(b for b in self.browser.find_elements(By.CSS_SELECTOR, "#examples button") if b.text == name).click()
        self.wait_until_done()

    def option(self, name):
        return self.browser.find_element(By.CSS_SELECTOR, f"#options [name={name}]")

    def segment_again(self):
        self.browser.find_element(By.CSS_SELECTOR, "#options [type=submit]").click()
        self.wait_until_done()

    def number(self):
        return self.run("return report.model.number")

    def labels(self):
        return self.run("return report.model.segText()")

    def start_message(self):
        return self.text("start_message")


@pytest.fixture
def page(browser, page_file, tmp_path):
    page = Segmenting_page(browser, shutil.copy(page_file, tmp_path / "segment.html"))
    page.wait(lambda: page.run("return document.body.classList.contains('ready')"))
    yield page
    expect_no_errors(browser)


@pytest.fixture
def octopus(make_mesh, tmp_path):
    return make_mesh("octopus", tmp_path / "octopus.off", 4000)


def labels_of_tool(tool, mesh, *options):
    labels = mesh.with_suffix(".tool.seg")
    subprocess.run([tool, mesh, *options, "-o", labels, "--quiet"], check=True)
    return labels.read_text()


def test_an_example_needs_one_click(page):
    assert page.browser.find_element(By.ID, "drop").is_displayed()
    page.open_example("octopus")
    assert page.number() == 9 and page.pixels() > 10000
    assert not page.browser.find_element(By.ID, "drop").is_displayed()
    assert page.text("title") == "octopus.off"


def test_dropped_file(page, octopus, tool):
    content = octopus.read_text()
    page.browser.execute_script("""
        const transfer = new DataTransfer();
        transfer.items.add(new File([arguments[0]], "octopus.off"));
        for (const type of ["dragenter", "dragover", "drop"])
          document.getElementById("drop").dispatchEvent(new DragEvent(type, {dataTransfer: transfer, bubbles: true, cancelable: true}));
        """, content)
    page.wait_until_done()
    assert page.labels() == labels_of_tool(tool, octopus)
    assert not page.run("return document.body.classList.contains('dragging')")


def test_options_segment_again_and_undo(page, octopus, tool):
    page.open(octopus)
    page.option("segments").send_keys("4")
    page.segment_again()
    assert page.number() == 4 and page.labels() == labels_of_tool(tool, octopus, "-k", "4")
    Select(page.option("method")).select_by_value("paper")
    page.segment_again()
    assert page.labels() == labels_of_tool(tool, octopus, "-k", "4", "--method", "paper")
    assert "paper" in page.text("summary")
    page.click_button("undo")
    assert page.labels() == labels_of_tool(tool, octopus, "-k", "4")
    assert page.option("method").get_attribute("value") == "minimum-cut", "the options are not those of what is shown"
    seg = page.save("save_seg", "octopus.seg")
    assert seg.read_text() == page.labels(), "what is saved is not what is shown"


def test_loose_pieces(page, make_mesh, tmp_path, tool):
    mesh = tmp_path / "pieces.obj"
    subprocess.run([tool, make_mesh("teddy", tmp_path / "teddy.off", 3000), "-o", tmp_path / "%d.stl", "--close", "--quiet"],
                   check=True)
    parts = sorted(tmp_path.glob("[0-9].stl"))
    (tmp_path / "all.stl").write_bytes(joined_stl(parts))
    mesh = tmp_path / "all.stl"
    page.open(mesh)
    page.option("joined").click()
    page.segment_again()
    of_page, of_tool = page.labels().split(), labels_of_tool(tool, mesh, "--join-pieces").split()
    assert page.number() == len(set(of_tool))
    assert sum(a == b for a, b in zip(of_page, of_tool)) > 0.95 * len(of_tool)  # the surface is not the same to the last digit
    for identifier, name in (("save_ply", "all.ply"), ("save_parts", "all.parts.zip")):
        assert page.save(identifier, name).stat().st_size > 0


def joined_stl(files):
    """One binary STL file of several."""
    triangles = b"".join(file.read_bytes()[84:] for file in files)
    return bytes(80) + (len(triangles) // 50).to_bytes(4, "little") + triangles


def test_tips_segment_anew(page, octopus):
    """Of the body alone, the arms whose tips are picked are found anew, with a name that stays."""
    page.open(octopus)
    tips = page.run("return report.model.data.protrusions.map(p => p.tip)")
    page.set_level(2)
    page.run("report.editor.rename(report.model.shownSegments()[1], 'first')")
    page.browser.find_element(By.ID, "picking").click()
    seen = [(tip, page.run(f"return report.view.positionOf({tip})")) for tip in tips]
    before = page.number()
    for tip, (x, y) in seen:
        if page.run(f"return report.view.faceAt({round(x)}, {round(y)})") >= 0:
            page.click_at(round(x), round(y))
    picked = page.run("return report.editor.tips.length")
    assert picked > 0
    page.click_button("from_tips")
    page.wait_until_done()
    assert page.number() > before and page.run("return report.model.data.tips_requested") is not None
    assert "first" in page.text("tree")
    page.click_button("undo")
    assert page.number() == before and page.run("return report.editor.tips.length") == picked


def test_saved_files(page, octopus, tool, tmp_path):
    """A merged and a renamed segment are so in all files."""
    page.open(octopus)
    last = page.run("return report.model.data.protrusions.at(-1).segment")
    page.run(f"report.editor.merge({last}); report.editor.rename(1, 'arm')")
    assert page.number() == 8
    labels = page.save("save_seg", "octopus.seg").read_text()
    assert labels == page.labels() and len(set(labels.split())) == 8
    ply = page.save("save_ply", "octopus.ply")
    assert labels_of_tool(tool, ply, "--labels", str(ply)) == labels
    with zipfile.ZipFile(page.save("save_parts", "octopus.parts.zip")) as archive:
        names = archive.namelist()
        assert len(names) == 8 and "arm.stl" in names
        archive.extractall(tmp_path / "parts")
    with zipfile.ZipFile(page.save("save_obj", "octopus.obj.zip")) as archive:
        assert sorted(archive.namelist()) == ["octopus.mtl", "octopus.obj"]
    assert page.save("save_glb", "octopus.glb").read_bytes()[:4] == b"glTF"
    assert zipfile.is_zipfile(page.save("save_3mf", "octopus.3mf"))
    record = json.loads(page.save("save_json", "octopus.json").read_text())
    assert record["segments"] == 8 and record["measures"][1]["name"] == "arm"
    assert json.loads(page.save("save_tips", "octopus.tips.json").read_text())["names"][0]["name"] == "arm"


def test_bad_files(page, data, octopus):
    for name, message in (("truncated_binary.ply", "truncated_binary.ply: "), ("empty.obj", "empty.obj: is empty")):
        page.open(data / name)
        assert message in page.start_message()
        assert not page.run("return document.body.classList.contains('shown')")
    page.open(octopus)
    assert page.number() == 9
    page.open(data / "empty.obj")
    assert "empty.obj: is empty" in page.text("message") and page.text("title") == "octopus.off"
    page.option("segments").send_keys("100000")
    page.segment_again()
    assert "too few for 100000" in page.text("message")


def test_stop(page, make_mesh, tmp_path):
    large = make_mesh("octopus", tmp_path / "large.off", 200000)
    page.browser.find_element(By.ID, "files").send_keys(str(large))
    page.wait(lambda: float(page.run("return document.getElementById('progress').value")) > 0)
    begin = time.monotonic()
    page.click_button("stop")
    page.wait_until_done()
    assert time.monotonic() - begin < 2 and "Stopped" in page.start_message()
    page.open_example("chair")
    assert page.number() > 1, "the page does not work after it was stopped"


def test_gltf_with_its_buffer(page, octopus, tool, tmp_path):
    subprocess.run([tool, octopus, "-o", tmp_path / "whole.gltf", "--quiet"], check=True)
    document = json.loads((tmp_path / "whole.gltf").read_text())
    uri = document["buffers"][0]["uri"]
    (tmp_path / "mesh.bin").write_bytes(base64.b64decode(uri.split(",", 1)[1]))
    document["buffers"][0]["uri"] = "mesh.bin"
    (tmp_path / "mesh.gltf").write_text(json.dumps(document))
    page.open(tmp_path / "mesh.bin", tmp_path / "mesh.gltf")
    assert page.number() == 9
