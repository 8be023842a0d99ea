#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What a document or a comment names exists.

Checked in every *.md but those that tell history (changes/, docs/design/), and in the comments of C++, Python, CMake, shell and
table files:
 - a path that starts with a top folder and ends in a file type: robust/base/sign.h. With a * it must match a file; a path with
   <, > or { in it is a pattern for the reader and is left alone;
 - a symbol written veritope::name: the name occurs in code;
 - a source cited as [Key]: docs/references.bib has it;
and in documents only:
 - a file name alone between backquotes, such as `sign.h`: some file has that name;
 - the target of a link [text](target) that is no address, and the heading after its #.
A file counts as there if it, or the .in file that it is made from, is in the tree.
"""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "infra"))
from comments import split  # noqa: E402
from tree import ROOT, files  # noqa: E402

TOP = """robust splines interval predicates topology solids verify io render cli python interop tools tests fuzz bench docs examples
cmake changes LICENSES""".split()
TYPES = "h|cc|inc|py|md|txt|cmake|json|bib|stl|off|obj|ply"
PATH = re.compile(rf"(?<![\w./<>{{*-])((?:{'|'.join(TOP)})/[\w./*-]*?[\w*]\.(?:{TYPES}))(?![\w<{{*/])")
SYMBOL = re.compile(r"\bveritope::(\w+)")
CITED = re.compile(r"\[([A-Z][A-Za-z+]*\d\d[a-z]?)\](?!\()")
BARE = re.compile(r"`([\w-]+\.(?:h|cc|inc|py|md|cmake))`")
LINK = re.compile(r"\[[^\]\n]*\]\(([^)\s]+)\)")
HISTORY = ("changes/", "docs/design/")


class Names:
    """What there is to name: paths, file names, words of code, headings."""

    def __init__(self, root):
        self.root = root
        self.all = [str(path) for path in files(root)]
        self.paths = set(self.all)
        self.names = {pathlib.PurePath(path).name for path in self.all}
        self.texts = {path: self.read(path) for path in self.all}
        self.keys = set(re.findall(r"(?m)^@\w+\{(\w+),", self.texts.get("docs/references.bib") or ""))
        self.words = set()
        for path, text in self.texts.items():
            if text is not None and not path.endswith((".md", ".stl", ".off", ".obj", ".ply", ".bib", ".json")):
                self.words.update(re.findall(r"\w+", split(pathlib.PurePath(path), text)[0]))

    def read(self, path):
        try:
            return (self.root / path).read_text(encoding="utf-8")
        except (UnicodeDecodeError, OSError):
            return None

    def has_path(self, path):
        if "*" in path:
            pattern = re.compile(re.escape(path).replace(r"\*", ".*"))
            return any(pattern.fullmatch(other) for other in self.all)
        return path in self.paths or path + ".in" in self.paths

    def has_name(self, name):
        return name in self.names or name + ".in" in self.names


def anchors(text):
    """The ids of a document's headings: those given as {#ID}, and the usual ones made of the words."""
    found = set(re.findall(r"\{#([\w.-]+)\}", text))
    for heading in re.findall(r"(?m)^#+ +(.*?)\s*(?:\{#.*\})?$", text):
        found.add(re.sub(r"[^\w -]", "", heading.lower()).strip().replace(" ", "-"))
    return found


def faults_of_text(names, text):
    """(offset, fault) for paths, symbols and sources."""
    for match in PATH.finditer(text):
        if not names.has_path(match[1]):
            yield match.start(), f"{match[1]} does not exist"
    for match in SYMBOL.finditer(text):
        if match[1] not in names.words:
            yield match.start(), f"veritope::{match[1]} does not occur in code"
    for match in CITED.finditer(text):
        if match[1] not in names.keys:
            yield match.start(), f"docs/references.bib has no [{match[1]}]"


def faults_of_document(names, path, text):
    for match in BARE.finditer(text):
        if not names.has_name(match[1]):
            yield match.start(), f"no file is called {match[1]}"
    for match in LINK.finditer(text):
        target, _, heading = match[1].partition("#")
        if re.match(r"[a-z]+:", target):
            continue
        file = (names.root / path).parent / target if target else names.root / path
        if not file.exists():
            yield match.start(), f"the link's target {target} does not exist"
        elif heading and heading not in anchors(file.read_text()):
            yield match.start(), f"{file.name} has no heading {heading}"


def find_faults(root):
    """One line a fault: "file:line: what"."""
    names, faults = Names(root), []
    for path, text in names.texts.items():
        if text is None or path.startswith(HISTORY):
            continue
        if path.endswith(".md"):
            found = [*faults_of_text(names, text), *faults_of_document(names, path, text)]
            faults += [f"{path}:{text.count(chr(10), 0, at) + 1}: {fault}" for at, fault in sorted(found)]
            continue
        for line, comment in split(pathlib.PurePath(path), text)[1]:
            faults += [f"{path}:{line + comment.count(chr(10), 0, at)}: {fault}" for at, fault in faults_of_text(names, comment)]
    return faults


class NamesInTheTree(unittest.TestCase):
    def test_what_a_document_or_a_comment_names_exists(self):
        faults = find_faults(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))


class PlantedFaults(unittest.TestCase):
    def faults(self, name, text):
        sound = {"robust/sign.h": "enum class Sign {};  // robust/sign.h\n", "docs/a.md": "# One thing {#ONE-1}\n",
                 "docs/references.bib": "@book{She97,\n}\n"}
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for path, content in {**sound, name: text}.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(content)
            return find_faults(root)

    def test_existing_names_pass(self):
        text = "`robust/sign.h` robust/*.h `sign.h` veritope::Sign [She97] [a](a.md#ONE-1) [b](a.md#one-thing) tests/<layer>/x_test.cc\n"
        self.assertEqual(self.faults("docs/b.md", text), [])
        self.assertEqual(self.faults("robust/b.cc", '// robust/sign.h\nauto s = "robust/none.h";\n'), [])

    def test_a_lost_file_is_found_in_every_kind_of_comment(self):
        for name, text in {"robust/b.cc": "int a;\n/* see\n robust/none.h */\n", "tools/b.py": '"""See robust/none.h."""\n',
                           "cmake/b.cmake": "set(a)  # robust/none.h\n", "docs/b.md": "See robust/none.h.\n"}.items():
            faults = self.faults(name, text)
            self.assertEqual(len(faults), 1, (name, faults))
            self.assertIn("robust/none.h does not exist", faults[0])

    def test_a_lost_name_symbol_source_link_or_heading_is_found(self):
        for text in ("`none.h`", "`veritope::None`", "[a](none.md)", "[a](a.md#TWO)", "[She98]", "`robust/*.cc`"):
            self.assertEqual(len(self.faults("docs/b.md", text)), 1, text)


if __name__ == "__main__":
    unittest.main()
