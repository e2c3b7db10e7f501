#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the figures of the user manual and of the README up to date, none of which is typed.

Measurements: a section of the benchmarks' output files is copied between the lines

    <!-- begin Quality/results*.md: SECTION -->
    <!-- end -->

where the pattern is relative to benchmark/Protrusion_segmentation and SECTION is how the heading
begins; without ": SECTION" the whole file is copied. Where there is no such file, the manual says
how to measure.

Constants: in table rows that begin with "| `FILE.h`, `NAME` |" the second column is the value that
NAME is set to in that header.

Output of the examples: with --programs FOLDER, a folder in which examples and tools were built, what an example
prints for a shape of make_example_mesh replaces what is between the lines

    <!-- begin output of EXAMPLE for SHAPE -->
    <!-- end -->

Results in the README: table rows whose first cell ends with "<!-- METHOD -->" get that method's means
from the benchmark's output.

With --check nothing is written, and the exit code is 1 if one of the two is out of date.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = ROOT / "doc/Protrusion_segmentation/Protrusion_segmentation.txt"
README = ROOT / "README.md"
EXAMPLES = ROOT / "examples/Protrusion_segmentation"
BENCHMARKS = ROOT / "benchmark/Protrusion_segmentation"
HEADERS = ROOT / "include/CGAL/Protrusion_segmentation"

OUTPUT = re.compile(r"(<!-- begin output of (\w+) for (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)
LONGEST_OUTPUT = 16  # lines
BLOCK = re.compile(r"(<!-- begin ([^: \n]+?)(?:: ([^\n]+?))? -->\n).*?(<!-- end -->)", re.DOTALL)
RESULT = re.compile(r"^(\| [^|]*<!-- ([^ ]+) --> )\|.*$", re.MULTILINE)
README_COLUMNS = ("RI", "HD", "CD")
ROW = re.compile(r"^\| `([\w/]+\.h)`, `(\w+)` \| ([^|]+) \|", re.MULTILINE)


errors = []


def section(text, heading):
    """The part of a Markdown text below the heading that begins so, without the heading."""
    if heading is None:
        return re.sub(r"^# .*\n+", "", text)
    found = re.search(r"^## " + re.escape(heading) + r"[^\n]*\n(.*?)(?=^## |\Z)", text,
                      re.DOTALL | re.MULTILINE)
    return found.group(1) if found else None


def for_doxygen(text):
    """Markdown headings would become sections of the manual; angle brackets would be tags."""
    text = re.sub(r"^#+ (.*)$", r"<b>\1</b>", text, flags=re.MULTILINE)
    return text.strip("\n")


def measurements(pattern, heading):
    parts = []
    files = sorted(BENCHMARKS.glob(pattern))
    for file in files:
        part = section(file.read_text(encoding="utf-8"), heading)
        if part is not None:
            parts.append(f"From `{file.relative_to(ROOT)}`:\n\n{for_doxygen(part)}\n")
    if parts:
        return "\n" + "\n".join(parts) + "\n"
    folder = (BENCHMARKS / pattern).parent.relative_to(ROOT)
    what = f" the table '{heading}'" if heading else " a table"
    return f"\nThe programs in `{folder}` measure and print{what}; see the file README.md there.\n\n"


def constant(header, name, old_value):
    """The value; where it is not found, an error is printed and the old one stays."""
    text = "".join(file.read_text(encoding="utf-8") for file in HEADERS.rglob(header))
    found = re.search(rf"\b{name}(?:\(\)(?: const)?)? *(?:=|\{{ *return) *(-?[\d.][^;]*);", text)
    if not found:
        errors.append(f"{MANUAL.name}: {header} has no constant {name}")
    return found.group(1) if found else old_value


def program(folder, name):
    """The built program of that name in the folder or the folders in it."""
    for file in sorted(folder.rglob(name)):
        if file.is_file():
            return file
    sys.exit(f"{folder} has no program {name}")


def output(programs, example, shape):
    """What the example prints. Its last argument, if it wants one, is the name of a .seg file."""
    with tempfile.TemporaryDirectory() as folder:
        mesh, segments = f"{folder}/{shape}.off", f"{folder}/{shape}.seg"
        subprocess.run([program(programs, "make_example_mesh"), shape, mesh], check=True,
                       stdout=subprocess.DEVNULL)
        writes = "write_SEG" in (EXAMPLES / f"{example}.cpp").read_text(encoding="utf-8")
        result = subprocess.run([program(programs, example), mesh] + ([segments] if writes else []),
                                check=True, capture_output=True, text=True)
    lines = result.stdout.splitlines()
    if len(lines) > LONGEST_OUTPUT:
        lines[LONGEST_OUTPUT:] = ["..."]
    return "\n\\verbatim\n" + "\n".join(lines) + "\n\\endverbatim\n\n"


def means():
    """For each method its row of the table 'Means', by the names of the columns."""
    rows = {}
    for file in sorted(BENCHMARKS.glob("Quality/results*.md")):
        table = [[cell.strip() for cell in line.strip("|").split("|")]
                 for line in (section(file.read_text(encoding="utf-8"), "Means") or "").splitlines()
                 if line.startswith("| ")]
        rows.update({row[0]: dict(zip(table[0], row)) for row in table[1:]})
    return rows


def updated_readme(text):
    rows = means()
    def result(match):
        if match[2] not in rows:
            errors.append(f"{README.name}: there are no results of {match[2]}")
            return match[0]
        values = [f"{float(rows[match[2]][column]):.3f}".lstrip("0") for column in README_COLUMNS]
        return match[1] + "| " + " | ".join(values) + " |"
    return RESULT.sub(result, text)


def updated(text, programs):
    if programs:
        text = OUTPUT.sub(lambda m: m[1] + output(programs, m[2], m[3]) + m[4], text)
    text = BLOCK.sub(lambda m: m[1] + measurements(m[2], m[3]) + m[4], text)
    return ROW.sub(lambda m: f"| `{m[1]}`, `{m[2]}` | {constant(m[1], m[2], m[3])} |", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail if out of date")
    parser.add_argument("--programs", type=pathlib.Path, help="folder with the built examples and tools")
    arguments = parser.parse_args()
    programs = arguments.programs and arguments.programs.resolve()
    for file, update in ((MANUAL, lambda text: updated(text, programs)), (README, updated_readme)):
        old = file.read_text(encoding="utf-8")
        new = update(old)
        if arguments.check and new != old:
            errors.append(f"{file.relative_to(ROOT)} is out of date: run scripts/manual/update_tables.py")
        elif new != old:
            file.write_text(new, encoding="utf-8")
    sys.exit("\n".join(errors) or 0)


if __name__ == "__main__":
    main()
