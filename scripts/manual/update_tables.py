#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the figures of the user manual and of the README up to date, none of which is typed.

Tables: the rows and columns that are asked for of a table in the benchmarks' output are copied between the lines

    <!-- begin FILE: SECTION
    columns: COLUMN; COLUMN = what the manual calls it
    rows: ROW; ROW = what the manual calls it
    -->
    <!-- end -->

FILE is relative to benchmark/Protrusion_segmentation, SECTION is how the heading begins above the table, a row goes by
its first cell, and COLUMN#2 is the second column of that name. The first column is always there. Without a line "rows"
there are all rows.

Single figures: a number after <!-- FILE: SECTION; ROW; COLUMN --> is that of the table.

Constants: in table rows that begin with "| `FILE.h`, `NAME` |" the second column is the value that
NAME is set to in that header.

Output of the examples: with --programs FOLDER, a folder in which the examples were built, and --data FOLDER, CGAL's
data folder with meshes/elephant.off, what an example prints without arguments replaces what is between the lines

    <!-- begin output of EXAMPLE -->
    <!-- end -->

Results in the README: table rows whose first cell ends with "<!-- METHOD -->" get that method's means
from the benchmark's output.

With --check nothing is written, and the exit code is 1 if one of the two is out of date.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = ROOT / "doc/Protrusion_segmentation/Protrusion_segmentation.txt"
README = ROOT / "README.md"
BENCHMARKS = ROOT / "benchmark/Protrusion_segmentation"
HEADERS = ROOT / "include/CGAL/Protrusion_segmentation"

OUTPUT = re.compile(r"(<!-- begin output of (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)
LONGEST_OUTPUT = 16  # lines
BLOCK = re.compile(r"(<!-- begin ([^: \n]+): ([^\n]+)\n(.*?)-->\n).*?(<!-- end -->)", re.DOTALL)
FIGURE = re.compile(r"(<!-- ([^:;\n]+): ([^;\n]+); ([^;\n]+); ([^;>\n]+) -->)[-\d.]*\d")
RESULT = re.compile(r"^(\| [^|]*<!-- ([^ ]+) --> )\|.*$", re.MULTILINE)
README_COLUMNS = ("RI", "HD", "CD")
ROW = re.compile(r"^\| `([\w/]+\.h)`, `(\w+)` \| ([^|]+) \|", re.MULTILINE)


errors = []


class Table:
    """The first table below the heading in the benchmarks' output that begins so."""

    def __init__(self, file, heading):
        self.name = f"{file}, {heading}"
        text = (BENCHMARKS / file).read_text(encoding="utf-8")
        section = re.search(r"^## " + re.escape(heading) + r"[^\n]*\n(.*?)(?=^## |\Z)", text, re.DOTALL | re.MULTILINE)
        lines = re.search(r"(?:^\|[^\n]*\n)+", section.group(1) if section else "", re.MULTILINE)
        if not lines:
            sys.exit(f"{self.name}: there is no table")
        cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines.group().splitlines()]
        self.names = cells[0]
        self.rows = {row[0]: row for row in cells[2:]}

    def column(self, name):
        """The index of a column; NAME#2 is the second of that name."""
        name, _, count = name.partition("#")
        found = [i for i, other in enumerate(self.names) if other == name]
        return self.found(found[int(count or 1) - 1:][:1] or None, "column", name)[0]

    def row(self, name):
        return self.found(self.rows.get(name), "row", name)

    def found(self, result, what, name):
        if result is None:
            sys.exit(f"{self.name}: the table has no {what} {name}")
        return result


def choice(options, what):
    """What is asked for, as pairs of the table's name and the manual's."""
    line = re.search(rf"^ *{what}: (.*?)(?=^ *\w+: |\Z)", options, re.DOTALL | re.MULTILINE)
    pairs = [re.split(r" = ", " ".join(item.split())) for item in line.group(1).split(";")] if line else []
    return [(pair[0], pair[-1]) for pair in pairs]


def short_table(file, heading, options):
    table = Table(file, heading)
    columns = [(0, table.names[0])] + [(table.column(name), label) for name, label in choice(options, "columns")]
    rows = choice(options, "rows") or [(name, name) for name in table.rows]
    lines = [[label for _, label in columns], [":--"] + ["--:"] * (len(columns) - 1)]
    for name, label in rows:
        row = table.row(name)
        lines.append([label] + [row[i] for i, _ in columns[1:]])
    return "\n" + "".join("| " + " | ".join(line) + " |\n" for line in lines) + "\n"


def figure(file, heading, row, column):
    table = Table(file, heading)
    return table.row(row)[table.column(column)]


def constant(header, name, old_value):
    """The value; where it is not found, an error is printed and the old one stays."""
    text = "".join(file.read_text(encoding="utf-8") for file in HEADERS.rglob(header))
    found = re.search(rf"\b{name}(?:\(\)(?: const)?)? *(?:=|\{{ *return) *\{{?(-?[\d.][^;}}]*)\}}?;", text)
    if not found:
        errors.append(f"{MANUAL.name}: {header} has no constant {name}")
    return found.group(1) if found else old_value


def program(folder, name):
    """The built program of that name in the folder or the folders in it."""
    for file in sorted(folder.rglob(name)):
        if file.is_file():
            return file
    sys.exit(f"{folder} has no program {name}")


def output(programs, data, example):
    """What the example prints without arguments."""
    result = subprocess.run([program(programs, example)], check=True, capture_output=True, text=True,
                            env={**os.environ, "CGAL_DATA_DIR": str(data)})
    if result.stderr:
        sys.exit(f"{example}: {result.stderr}")
    lines = result.stdout.splitlines()
    if len(lines) > LONGEST_OUTPUT:
        lines[LONGEST_OUTPUT:] = ["..."]
    return "\n\\verbatim\n" + "\n".join(lines) + "\n\\endverbatim\n\n"


def updated_readme(text):
    means = Table("Quality/results.md", "Means")
    def result(match):
        row = means.row(match[2])
        values = [f"{float(row[means.column(column)]):.3f}".lstrip("0") for column in README_COLUMNS]
        return match[1] + "| " + " | ".join(values) + " |"
    return with_figures(RESULT.sub(result, text))


def with_figures(text):
    return FIGURE.sub(lambda m: m[1] + figure(*m.groups()[1:]), text)


def updated(text, programs, data):
    if programs:
        text = OUTPUT.sub(lambda m: m[1] + output(programs, data, m[2]) + m[3], text)
    text = BLOCK.sub(lambda m: m[1] + short_table(m[2], m[3], m[4]) + m[5], text)
    return ROW.sub(lambda m: f"| `{m[1]}`, `{m[2]}` | {constant(m[1], m[2], m[3])} |", with_figures(text))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail if out of date")
    parser.add_argument("--programs", type=pathlib.Path, help="folder with the built examples")
    parser.add_argument("--data", type=pathlib.Path, help="CGAL's data folder")
    arguments = parser.parse_args()
    if arguments.programs and not arguments.data:
        parser.error("--programs needs --data")
    programs = arguments.programs and arguments.programs.resolve()
    for file, update in ((MANUAL, lambda text: updated(text, programs, arguments.data)), (README, updated_readme)):
        old = file.read_text(encoding="utf-8")
        new = update(old)
        if arguments.check and new != old:
            errors.append(f"{file.relative_to(ROOT)} is out of date: run scripts/manual/update_tables.py")
        elif new != old:
            file.write_text(new, encoding="utf-8")
    sys.exit("\n".join(errors) or 0)


if __name__ == "__main__":
    main()
