#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails if a page of the built manual refers to a page, an anchor or a picture that is not there.

    scripts/manual/check_links.py HTML_FOLDER
"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.anchors.update(attributes[name] for name in ("id", "name") if attributes.get(name))
        self.links += [attributes[name] for name in ("href", "src") if attributes.get(name)]


def dead_links(folder):
    pages = {file.name: Page(file) for file in sorted(folder.glob("*.html"))}
    for name, page in pages.items():
        for link in page.links:
            url = urllib.parse.urlparse(link)
            if url.scheme or url.netloc:
                continue
            target = urllib.parse.unquote(url.path) or name
            anchor = urllib.parse.unquote(url.fragment)
            if not (folder / target).exists():
                yield name, link
            elif anchor and target in pages and anchor not in pages[target].anchors:
                yield name, link


def main():
    found = list(dead_links(pathlib.Path(sys.argv[1])))
    for name, link in found:
        print(f"{name}: dead link to {link}", file=sys.stderr)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
