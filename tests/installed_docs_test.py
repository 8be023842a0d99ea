#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""An installed page names installed files only.

cmake/installed_docs.txt lists the documents that are installed. In each of their pages
 - the target of every link is installed;
 - a path of the tree (robust/base/sign.h) is an installed document or example, an installed header, or a file of the
   checker in Python, which is installed elsewhere; or the words "of the source tree" follow it.
The rows of the list exist.
"""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "infra"))
from doc_links_test import LINK, PATH  # noqa: E402
from layering_test import is_installed  # noqa: E402
from tree import ROOT, Layers, files  # noqa: E402

LIST = "cmake/installed_docs.txt"
CHECKER = re.compile(r"verify/checker/veritope_check(er/.*)?\.py")


def rows(root):
    lines = (root / LIST).read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


def installed(root):
    """Documents and examples that are installed."""
    folders = tuple(row + "/" for row in rows(root))
    names = [str(path) for path in files(root)]
    examples = [name for name in names if re.fullmatch(r"examples/([^/]+\.(?!txt|cc|h)\w+|esc_figures/[^/]+\.(obj|off))", name)]
    return {name for name in names if name in rows(root) or name.startswith(folders)} | set(examples)


def faults(root):
    layers = Layers((root / "docs/layers.txt").read_text())
    there = installed(root)
    everything = {str(path) for path in files(root)}
    for row in rows(root):
        if row not in everything and not any(name.startswith(row + "/") for name in everything):
            yield f"{LIST}: {row} does not exist"
    for page in sorted(name for name in there if name.endswith(".md")):
        text = (root / page).read_text()

        def place(match):
            return f"{page}:{text.count(chr(10), 0, match.start()) + 1}"
        for match in LINK.finditer(text):
            target = match[1].partition("#")[0]
            if not target or re.match(r"[a-z]+:", target):
                continue
            file = (root / page).parent / target
            name = str(file.resolve().relative_to(root.resolve()))
            if name not in there and not (file.is_dir() and any(other.startswith(name + "/") for other in there)):
                yield f"{place(match)}: {name} is not installed"
        for match in PATH.finditer(re.sub(r"\]\([^)\s]*\)", lambda link: " " * len(link[0]), text)):
            name = match[1]
            if re.match(r"`?\s+of\s+the\s+source\s+tree", text[match.end():]):
                continue
            pattern = re.compile(re.escape(name).replace(r"\*", ".*"))
            named = {other for other in everything if pattern.fullmatch(other)}
            if not named & there and not CHECKER.fullmatch(name) and not any(is_installed(one, layers) for one in named):
                yield f"{place(match)}: {name} is not installed"


class InstalledPages(unittest.TestCase):
    def test_they_name_installed_files_only(self):
        found = list(faults(ROOT))
        self.assertFalse(found, "\n" + "\n".join(found))


class PlantedFaults(unittest.TestCase):
    SOUND = {LIST: "# what\ndocs/a.md\ndocs/cli\n", "docs/a.md": "[b](cli/b.md) docs/cli/b.md robust/sign.h [c](cli)\n", "docs/cli/b.md": "b\n",
             "docs/layers.txt": "robust | | gmp\n", "robust/sign.h": "\n", "robust/sign.cc": "\n", "docs/c.md": "tests/x.py\n",
             "tests/x.py": "\n"}

    def found(self, changes):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**self.SOUND, **changes}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return list(faults(root))

    def test_a_sound_tree_has_none(self):
        self.assertEqual(self.found({}), [])

    def test_a_link_or_a_path_to_what_is_not_installed_is_found(self):
        for text in ("\n[x](c.md)", "\n[x](../tests/x.py)", "\n`tests/x.py` does", "\nsee robust/sign.cc", "\n[x](c.md) of the source tree"):
            (fault,) = self.found({"docs/a.md": text})
            self.assertIn("docs/a.md:2: ", fault)
            self.assertIn("is not installed", fault)

    def test_a_path_of_the_source_tree_may_be_named_as_such(self):
        self.assertEqual(self.found({"docs/a.md": "\n`tests/x.py` of the\nsource tree"}), [])

    def test_a_row_without_a_file_is_found(self):
        (fault,) = self.found({LIST: "docs/a.md\ndocs/cli\ndocs/none.md\n"})
        self.assertIn("docs/none.md does not exist", fault)


if __name__ == "__main__":
    unittest.main()
