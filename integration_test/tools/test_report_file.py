# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The file that --report writes; ../test_report.py looks at it in a browser."""

import pytest


def test_report(segment, teddy, tmp_path, libraries):
    page = tmp_path / "a.html"
    if "three.js" not in libraries:
        segment.refuses(teddy, "--report", page, code=2, message="three.js was not found")
        assert not page.exists()
        return
    assert "wrote a.html" in segment(teddy, "-k", 4, "--report", "a.html").out
    content = page.read_text()
    for text in ("three.js authors", '"border_length":', "</html>"):
        assert text in content
    segment.refuses(teddy, "--report", "missing/a.html",
                    message="missing/a.html: cannot be written")


def test_report_on_a_name_that_ends_its_script(segment, teddy, tmp_path, libraries):
    if "three.js" not in libraries:
        pytest.skip("three.js was not found")
    folder = tmp_path / "</script>"
    folder.mkdir(parents=True)
    teddy.rename(folder / "a.off")
    segment("</script>/a.off", "--report", "a.html")
    assert "</script>/a.off" not in (tmp_path / "a.html").read_text()
