# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_portability.py finds each of these lines, and none of those that look alike."""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "scripts"))
import check_portability  # noqa: E402

REFUSED = [
    "int m = std::max(a, b);",
    "int m = std::numeric_limits<int>::max();",
    "for (const Point& near : points) {}",
    "if (a and not b) {}",
    "__attribute__((unused)) int i;",
    "if (__builtin_expect(a, 1)) {}",
    "__int128 big;",
    "typeof(a) b = a;",
    "int m = ({ f(); });",
    "int m = a ?: b;",
    "case 1 ... 3: f();",
    "double angle = 2 * M_PI;",
    "ssize_t size = 0;",
    "#include <unistd.h>",
    "#include <bits/stdc++.h>",
    "if (isatty(0)) {}",
    "Point p = {.x = 1, .y = 2};",
    "f(Options{.size{3}});",
    "double weights[number_of_faces];",
    "char values[text.size() + 1];",
    "#warning old",
    "union { struct { int a; }; int b; };",
    "std::fopen(path.c_str(), mode);",
    'const char* s = "' + 16381 * "x" + '";',
    'const char* s = R"(' + 16381 * "x" + ')";',
    "const char* s = " + 5 * ('"' + 16000 * "x" + '"\n') + ";",
    'const char* s = "é";',
    "#ifdef NDEBUG\nssize_t size;\n#endif",
    "#ifdef __unix__\n#endif\nssize_t size;",
]

TAKEN = [
    "int m = (std::max)(a, b); // std::max(a, b)",
    "/* x */ int m = (std::numeric_limits<int>::max)(); /* or\nmax(1, 2) */",
    "bool is_near = a.near(b);",
    "#include <CGAL/Kernel/interface.h>",
    'const char* s = "a and not b, std::max(a, b)";',
    "points.push_back({1, 2});",
    "template <typename... Ts> void f(Ts&&... ts);",
    "const int b = is_a ? 1 : ::two();",
    "double weights[3];",
    "Point p = {x, .5, p.y};",
    'const char* s = "' + 16000 * "x" + '";',
    "const char* s = R\"(it's)\"; ssize_of(s);",
    "const char quote = '\"'; const char* s = \"//\"; int i = 1'000'000;",
    "#if __has_include(<unistd.h>)\n#define HAS_UNISTD\n#include <unistd.h>\n#endif\n#ifdef HAS_UNISTD\nssize_t size;\n#endif",
    "#ifndef _WIN32\nif (isatty(0)) {}\n#endif",
    "struct Empty {};",
    "// é",
]


def reasons(text):
    found = []
    check_portability.check(text, lambda line, reason: found.append(f"{line}: {reason}"))
    return found


wrong = [f"not found: {text[:80]!r}" for text in REFUSED if not reasons(text)]
wrong += [f"{text[:80]!r}: {reasons(text)}" for text in TAKEN if reasons(text)]
check_portability.main([])
if wrong:
    sys.exit("\n".join(wrong))
print(f"{len(REFUSED)} lines are found, {len(TAKEN)} are not")
