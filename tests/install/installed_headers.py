# SPDX-License-Identifier: LGPL-3.0-or-later
"""What the tests of the installation know of headers: the rows of cmake/public_headers.txt, and which text an installed
header has. The rewriting itself is CMake's (cmake/VeritopeHeaders.cmake); this is another way to the same bytes."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "cmake" / "public_headers.txt"
MOST_PUBLIC = 40
VERSION_ROW = "cmake/version.h.in"
VERSION_LINE = b"#include <veritope/version.h>\n"
QUOTED = re.compile(rb'([ \t]*#[ \t]*include[ \t]*)"([^"]+)"(.*)', re.S)


def rows(text):
    """[(source, installed name, sentence)] of a table."""
    found = []
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            header, sentence = (part.strip() for part in line.split("|", 1))
            source, _, name = header.partition(" -> ")
            found.append((source, name or source, sentence))
    return found


def public_headers():
    return rows(TABLE.read_text())


def installed_name(source, table):
    """The path below include/veritope."""
    return {row[0]: row[1] for row in table}.get(source, "internal/" + source)


def installed_text(text, table):
    """The bytes of a header of the tree as users get them."""
    out = []
    for line in text.split(b"\n"):
        match = QUOTED.fullmatch(line)
        out.append(match[1] + b"<veritope/" + installed_name(match[2].decode(), table).encode() + b">" + match[3] if match else line)
    before, once, after = b"\n".join(out).partition(b"#pragma once\n")
    return before + once + VERSION_LINE + after
