#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds in C++ files what g++ and clang++ accept and MSVC is known to refuse.

    check_portability.py [FOLDER_OR_FILE...]

By default it reads the folders include and tools of this project. It prints each place with the reason, and fails if there is
one. Comments are not code, and neither are the contents of strings. Lines that the preprocessor leaves out on Windows may hold
anything: those under a condition with __has_include, __unix__, __linux__, __GNUC__ or _WIN32.

It is no substitute for MSVC, with which the project was not compiled.
"""

import pathlib
import re
import sys

# A regular expression for a line of code, and why MSVC does not take it. The numbers are those of its messages.
RULES = [
    (r"\b(?:min|max)\s*\(", "min and max are macros of windows.h: write (std::min)(a, b)"),
    (r"(?<![\w.:>\"<])(?:near|far|small|interface|IN|OUT|ERROR|DELETE|hyper)\b(?!\.h)", "a macro of windows.h"),
    (r"\b(?:and|or|not|xor|bitand|bitor|compl|and_eq|or_eq|not_eq|xor_eq)\b", "a word for an operator needs /permissive-"),
    (r"\b__(?:attribute|attribute__|extension__|typeof|typeof__|int128|uint128_t|PRETTY_FUNCTION__|asm__)\b|"
     r"\b__(?:builtin|sync|atomic)_\w+|\btypeof\s*\(|\[\[gnu::", "an extension of GNU"),
    (r"(?<![\w>)\]])\(\{|\?\s*:(?!:)|\bcase\b[^:?]*\.\.\.|&&\w+\s*;\s*goto", "an extension of GNU"),
    (r"\bM_(?:E|PI|SQRT|LN|LOG|1_PI|2_)\w*", "needs _USE_MATH_DEFINES: write CGAL_PI"),
    (r"\b(?:ssize_t|off_t|pid_t|uint|ulong|u_int\w*)\b", "no type of the standard"),
    (r"#\s*include\s*[<\"](?:unistd|strings|dirent|dlfcn|fcntl|pthread|poll|termios|glob|libgen|getopt|err|sys/\w+|"
     r"netinet/\w+|arpa/\w+|bits/\S+|ext/\S+)", "a header of POSIX or GNU"),
    (r"(?<![\w.>])(?:strcasecmp|strncasecmp|strsep|strndup|gmtime_r|localtime_r|strtok_r|rand_r|drand48|getline\s*\(\s*&|"
     r"asprintf|vasprintf|fmemopen|popen|pclose|fileno|isatty|usleep|getpid|setenv|unsetenv|realpath|mkdtemp|mkstemp|"
     r"sigaction|sincos)\s*\(", "a function of POSIX or GNU"),
    (r"[{,(]\s*\.[A-Za-z_]\w*\s*(?:=(?!=)|\{)", "C7555: a designated initializer needs C++20"),
    (r"^\s*(?:const\s+)?(?:unsigned\s+|long\s+|short\s+)*(?:int|char|double|float|bool|std::size_t|long|\w+_t)\s+[a-z_]\w*"
     r"\[\s*[a-z_][\w.]*(?:\(\))?\s*[^\]]*\]\s*;", "C2131: an array of a length that is not constant"),
    (r"\b\w+\s+\w+\[0\]\s*;", "C2466: an array of length 0"),
    (r"#\s*(?:warning|include_next|ident)\b", "C1021: no directive of C++17"),
    (r"\b(?:register)\s+\w", "no word of C++17"),
    (r"\bpath\w*\.c_str\(\)|\.native\(\)", "characters of a path are wchar_t on Windows: write .string()"),
    (r"\b(?:std::)?(?:auto_ptr|random_shuffle|unary_function|binary_function|bind1st|bind2nd|mem_fun|ptr_fun)\b",
     "removed in C++17"),
]
RULES = [(re.compile(expression), reason) for expression, reason in RULES]

# A literal of more bytes is C2026; pieces that stand one after the other may be longer together.
LONGEST_LITERAL = 16380
LONGEST_STRING = 65535

TOKEN = re.compile(
    r'(?P<raw>(?:u8|[uUL])?R"(?P<mark>[^()\s\\]{0,16})\((?P<text>.*?)\)(?P=mark)")|'
    r'(?P<string>(?:u8|[uUL])?"(?:[^"\\\n]|\\.)*")|'
    r"(?P<character>(?<![0-9a-fA-F])'(?:[^'\\\n]|\\[^\n][^'\n]*)')|"
    r"(?P<comment>//[^\n]*|/\*.*?\*/)",
    re.DOTALL)
NOT_ON_WINDOWS = re.compile(r"__has_include|__unix__|__linux__|__GNUC__|_WIN32|_MSC_VER")
EMPTY_STRUCT = re.compile(r"\b(?:struct|union|class)\s*\{[^{}]*\}\s*;")


def without_literals(text, report):
    """The text with comments as blanks and literals as empty ones, its line ends kept."""
    end_of_last = None
    length_of_last = 0

    def replace(found):
        nonlocal end_of_last, length_of_last
        literal = found["raw"] or found["string"]
        line_ends = "\n" * found[0].count("\n")
        if literal is None:
            return "' '" if found["character"] else " " + line_ends
        length = len((found["text"] if found["raw"] else literal[1:-1]).encode())
        line = text.count("\n", 0, found.start()) + 1
        if length > LONGEST_LITERAL:
            report(line, f"C2026: a literal of {length} bytes, more than {LONGEST_LITERAL}")
        follows = end_of_last is not None and not text[end_of_last:found.start()].strip()
        length_of_last = length + (length_of_last if follows else 0)
        if length_of_last > LONGEST_STRING >= length_of_last - length:
            report(line, f"C1091: a string of more than {LONGEST_STRING} bytes")
        if not literal.isascii():
            report(line, "C4819: a string with letters beyond ASCII needs /utf-8")
        end_of_last = found.end()
        return '""' + line_ends

    return TOKEN.sub(replace, text)


def check(text, report):
    """Calls report(line, reason) for every place."""
    code = without_literals(text, report)
    for found in EMPTY_STRUCT.finditer(code):
        report(code.count("\n", 0, found.start()) + 1, "C4201: a struct without a name")
    conditions = []  # whether each #if that is open may be false on Windows
    not_on_windows = []  # macros that are defined under one of these
    for number, line in enumerate(code.split("\n"), 1):
        directive = re.match(r"\s*#\s*(if|ifdef|ifndef|elif|else|endif)\b(.*)", line)
        if directive:
            word = directive[1]
            if word.startswith("if"):
                conditions.append(bool(NOT_ON_WINDOWS.search(line)) or any(name in line for name in not_on_windows))
            elif word == "endif" and conditions:
                conditions.pop()
            continue
        if any(conditions):
            not_on_windows += re.findall(r"^\s*#\s*define\s+(\w+)", line)
            continue
        for expression, reason in RULES:
            if expression.search(line):
                report(number, reason)


def main(arguments):
    root = pathlib.Path(__file__).resolve().parent.parent
    files = []
    for name in arguments or [root / "include", root / "tools"]:
        path = pathlib.Path(name)
        files += [path] if path.is_file() else sorted(f for f in path.rglob("*") if f.suffix in {".h", ".cpp"})
    if not files:
        sys.exit("check_portability.py: there are no files")
    failures = 0
    for file in files:
        def report(line, reason):
            nonlocal failures
            failures += 1
            print(f"{file}:{line}: {reason}")
        check(file.read_text(encoding="utf-8"), report)
    if failures:
        sys.exit(f"check_portability.py: MSVC would not take {failures} places")
    print(f"{len(files)} files hold nothing that MSVC is known to refuse")


if __name__ == "__main__":
    main(sys.argv[1:])
