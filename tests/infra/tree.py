# SPDX-License-Identifier: LGPL-3.0-or-later
"""What the tests of this folder share: the files of the tree, and the table of layers."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
CPP = {".h", ".cc", ".inc"}
# New files of a tree that tests/dummy_kind_test.py makes: their names and includes are right there, not here.
OTHER_TREE = pathlib.PurePath("tests/support/dummy_kind/files")


def files(root=ROOT, suffixes=None):
    """Our files, sorted, relative to root: no build folder, no hidden one, no Python cache, nothing of OTHER_TREE."""
    found, folders = [], [root]
    while folders:
        for path in folders.pop().iterdir():
            name = path.name
            if name.startswith(".") and name not in (".ci", ".clang-format", ".editorconfig"):
                continue
            if path.is_dir():
                top_build = path.parent == root and re.fullmatch(r"build(-.*)?", name)
                if not top_build and path.relative_to(root) != OTHER_TREE and name != "__pycache__" and not path.is_symlink():
                    folders.append(path)
            elif suffixes is None or path.suffix in suffixes:
                found.append(path.relative_to(root))
    return sorted(found)


class Layers:
    """docs/layers.txt; its head says what the columns mean."""

    INHERITED = {"posix", "intrinsics", "gmp"}

    def __init__(self, text):
        self.arrows, self.outside = {}, {}
        for line in text.splitlines():
            if line.strip() and not line.startswith("#"):
                folder, arrows, outside = (field.split() for field in line.split("|"))
                self.arrows[folder[0]] = set(arrows)
                self.outside[folder[0]] = set(outside)

    def layer_of(self, path):
        """The row that a path (a folder or a file, with slashes) belongs to, or None."""
        rows = [row for row in self.arrows if path == row or path.startswith(row + "/")]
        return max(rows, key=len, default=None)

    def may_include(self, row):
        """All rows that it may include from, itself among them."""
        reached, todo = set(), [row]
        while todo:
            row = todo.pop()
            if row == "*":
                todo += self.arrows
            elif row not in reached:
                reached.add(row)
                todo += self.arrows.get(row, ())
        return reached

    def outside_of(self, row):
        """The outside headers that it may include."""
        below = set().union(*(self.outside.get(other, set()) for other in self.may_include(row)))
        return self.outside.get(row, set()) | (below & self.INHERITED)
