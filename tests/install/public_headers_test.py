#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The public headers: cmake/public_headers.txt has at most 40 rows, docs/library.md shows them, and what examples, consumers
and documents include is among them; and the rewriting of includes changes nothing else in a header, whatever is in it.

usage: public_headers_test.py CMAKE
       public_headers_test.py --write      puts the table into docs/library.md
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent), str(pathlib.Path(__file__).resolve().parents[1]),
                str(pathlib.Path(__file__).resolve().parents[1] / "infra")]
import installed_headers  # noqa: E402
from installed_headers import MOST_PUBLIC, ROOT, VERSION_LINE, VERSION_ROW, installed_text, public_headers  # noqa: E402
from layering_test import is_installed  # noqa: E402
from tree import Layers  # noqa: E402

PAGE = ROOT / "docs" / "library.md"
BEGIN, END = "| header | what it is for |\n|---|---|\n", "\n\n"
CMAKE = "cmake"


def table_of_page():
    return "".join(f"| `<veritope/{name}>` | {sentence} |\n" for _, name, sentence in public_headers())


def includes(text, pattern):
    return re.findall(r"(?m)^[ \t]*#[ \t]*include[ \t]*" + pattern, text)


class PublicHeaders(unittest.TestCase):
    def test_there_are_at_most_forty_and_each_is_an_installed_header_of_the_tree(self):
        layers = Layers((ROOT / "docs" / "layers.txt").read_text())
        rows = public_headers()
        self.assertLessEqual(len(rows), MOST_PUBLIC)
        self.assertEqual(len({source for source, _, _ in rows}), len(rows))
        self.assertEqual(len({name for _, name, _ in rows}), len(rows))
        for source, name, sentence in rows:
            self.assertTrue((ROOT / source).is_file(), source)
            self.assertTrue(is_installed(source, layers) or source == VERSION_ROW, source)
            self.assertTrue(name.endswith(".h") and not name.startswith("internal/"), name)
            self.assertTrue(sentence and not sentence.endswith("."), source)

    def test_the_page_shows_the_table(self):
        self.assertIn(BEGIN + table_of_page() + END[1:], PAGE.read_text(),
                      "run tests/install/public_headers_test.py --write")

    def test_examples_include_public_headers_only(self):
        """Their shapes of models/ are not installed; everything else could be written by a user. Two programs study chains,
        which are not in the public headers."""
        public = {source for source, _, _ in public_headers()}
        programs = sorted(path for path in (ROOT / "examples").rglob("*.cc") if path.parent.name not in ("esc_figures", "literal_chain"))
        self.assertGreater(len(programs), 3)
        for program in programs:
            names = {name for name in includes(program.read_text(), '"([^"]+)"') if not name.startswith("models/")}
            self.assertLessEqual(names, public, str(program))

    def test_consumers_and_documents_include_public_headers_only(self):
        public = {name for _, name, _ in public_headers()}
        files = [*(ROOT / "tests" / "install" / "consumer").glob("*.cc"), ROOT / "README.md", PAGE,
                 ROOT / "docs" / "how-to" / "use-with-cgal-boost-eigen.md"]
        for file in files:
            names = includes(file.read_text(), "<veritope/([^>]+)>")
            self.assertTrue(names, str(file))
            self.assertLessEqual(set(names), public, str(file))
            self.assertEqual(includes(file.read_text(), '"([^"]+)"'), [], str(file))


class Rewriting(unittest.TestCase):
    """cmake/InstallHeaders.cmake on small trees."""

    # What has a meaning for CMake, in lists or in regular expressions, and what an editor might change.
    HARD = ('// SPDX\n#pragma once\n#include "a/b.h"  // \\1 ${x} @y@ $ENV{HOME}\n#  include\t"a/other.h"\n#include <vector>\n'
            '// #include "a/b.h" and "a/none.h" in a comment stay\n'
            'const char* s = "a;b;;c [[ ]=] [ \\; \\\\ \\n \\" ${s} # ;";  \n'
            '#if defined(X)\n  #include "a/b.h"\n#endif\nint x[3]; int y[[maybe_unused]] = x[x[0]];;\n'
            'auto r = R"cmake(\n#[[ not a comment ]]\n)cmake";\n\f\tUmlaute: \u00e4\u00f6\u00fc \u221e\n\n\n// no line feed at the end; [')
    TREE = {"a/b.h": "#pragma once\nint b;\n", "a/other.h": "#pragma once\n", "a/deep_internal.h": "#pragma once\n", "a/b.cc": "",
            "a/generated/g.h": "// x\n#pragma once\n#include \"a/hard.h\"\n", "a/hard.h": HARD, "z/far.h": "#pragma once\n"}
    TABLE = "# a comment; with [ a bracket\ncmake/version.h.in -> version.h | v\na/b.h -> b.h | first; [ second\na/other.h | x\n"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, tree, table=TABLE):
        root = self.folder / "tree"
        for name, text in tree.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_bytes(text.encode())
        (self.folder / "table.txt").write_text(table)
        (self.folder / "version.h").write_text("#pragma once\n// the version\n")
        values = {"ROOT": root, "TABLE": self.folder / "table.txt", "FOLDERS": "a", "VERSION_FILE": self.folder / "version.h",
                  "STAGE": self.folder / "stage"}
        done = subprocess.run([CMAKE, *(f"-DVERITOPE_{name}={value}" for name, value in values.items()),
                               "-P", ROOT / "cmake" / "InstallHeaders.cmake"], capture_output=True, text=True)
        return done.stderr

    def stage(self):
        place = self.folder / "stage"
        return {str(path.relative_to(place)): path.read_bytes() for path in place.rglob("*") if path.is_file()}

    def test_nothing_but_includes_changes_in_the_hardest_text(self):
        self.assertEqual(self.write(self.TREE), "")
        found = self.stage()
        self.assertEqual(set(found), {"version.h", "b.h", "a/other.h", "internal/a/hard.h", "internal/a/generated/g.h"})
        hard = self.HARD.replace('\n#include "a/b.h"', "\n#include <veritope/b.h>").replace("#pragma once\n", "#pragma once\n" + VERSION_LINE.decode())
        hard = hard.replace('  #include "a/b.h"', "  #include <veritope/b.h>").replace('"a/other.h"', "<veritope/a/other.h>")
        self.assertEqual(found["internal/a/hard.h"].decode(), hard)
        self.assertEqual(found["internal/a/generated/g.h"], b"// x\n#pragma once\n" + VERSION_LINE + b"#include <veritope/internal/a/hard.h>\n")
        table = installed_headers.rows(self.TABLE)
        for source in ("a/hard.h", "a/b.h", "a/generated/g.h"):
            self.assertEqual(found[installed_headers.installed_name(source, table)], installed_text(self.TREE[source].encode(), table))

    def test_a_second_run_writes_only_what_has_changed_and_removes_what_is_gone(self):
        self.write(self.TREE)
        first = (self.folder / "stage" / "b.h").stat().st_mtime_ns
        (self.folder / "stage" / "internal" / "old.h").write_text("")
        self.assertEqual(self.write({"a/other.h": "#pragma once\nint new_one;\n"}), "")
        self.assertEqual((self.folder / "stage" / "b.h").stat().st_mtime_ns, first)
        self.assertIn(b"new_one", self.stage()["a/other.h"])
        self.assertNotIn("internal/old.h", self.stage())

    def test_what_cannot_be_installed_is_refused_with_its_name(self):
        for changes, table, words in (
                ({"a/bad.h": '#pragma once\n#include "z/far.h"\n'}, self.TABLE, 'a/bad.h includes "z/far.h"'),
                ({"a/bad.h": '#pragma once\n#include "a/deep_internal.h"\n'}, self.TABLE, 'a/bad.h includes "a/deep_internal.h"'),
                ({"a/bad.h": '#pragma once\n#include "a/[b].h"\n'}, self.TABLE, "a/bad.h: this include is not understood"),
                ({"a/bad.h": "#pragma once\r\n"}, self.TABLE, "a/bad.h has bytes that CMake does not read"),
                ({"a/bad.h": "int a;\n"}, self.TABLE, "a/bad.h has no line #pragma once"),
                ({}, self.TABLE + "a/none.h | x\n", "a/none.h, which is not a header"),
                ({}, self.TABLE + "a/hard.h -> b.h | x\n", "two headers would be installed as veritope/b.h"),
                ({}, self.TABLE + "a/hard.h > b.h | x\n", "is neither SOURCE nor SOURCE -> NAME")):
            with self.subTest(words):
                self.assertIn(words, " ".join(self.write({**self.TREE, **changes}, table).split()))
                for name in changes:
                    (self.folder / "tree" / name).unlink()


def write_page():
    text = PAGE.read_text()
    begin = text.index(BEGIN) + len(BEGIN)
    PAGE.write_text(text[:begin] + table_of_page() + text[text.index(END, begin - 1) + 1:])


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        write_page()
    else:
        CMAKE = sys.argv.pop(1) if len(sys.argv) > 1 else CMAKE
        unittest.main()
