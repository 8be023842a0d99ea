# SPDX-License-Identifier: LGPL-3.0-or-later
"""What the tests of the command line share. The programs are found through VERITOPE_BIN (a folder), the real models through
VERITOPE_DATA."""
import csv
import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ.get("VERITOPE_BIN") or ROOT / "build" / "bin")
DATA = pathlib.Path(os.environ.get("VERITOPE_DATA") or ROOT / ".." / "shared" / "data")
MODELS = ROOT / "tests" / "models"
CHECKER_PY = ROOT / "verify" / "checker" / "veritope_check.py"
COMMANDS = ["certify", "info", "inspect", "convert", "build", "cage", "micro", "dms", "intersect", "project", "classify", "boolean", "chain", "render", "cover", "explain", "explain-certificate", "predicate", "selftest", "corpus"]
VALID, INVALID, UNREADABLE = MODELS / "m3_nearest_valid.off", MODELS / "m3_missing_face.off", MODELS / "unreadable_empty.off"


def run(*arguments, program=BIN / "veritope", **how):
    """The finished process; stdin is empty unless given. Output as text."""
    how.setdefault("stdin", subprocess.DEVNULL if "input" not in how else None)
    if how["stdin"] is None:
        del how["stdin"]
    how.setdefault("timeout", 120)
    how.setdefault("text", True)
    return subprocess.run([program, *map(str, arguments)], capture_output=True, **how)


def report(*arguments, **how):
    """The JSON document of certify."""
    return json.loads(run("certify", "--json", "-", *arguments, **how).stdout)


def only_file(*arguments, **how):
    """The one element of files."""
    files = report(*arguments, **how)["files"]
    assert len(files) == 1, files
    return files[0]


def expectations():
    """The rows of EXPECT.tsv as dicts."""
    with open(MODELS / "EXPECT.tsv", newline="") as file:
        return list(csv.DictReader(file, delimiter="\t"))


def as_written(value):
    """A number of a report as EXPECT.tsv and MANIFEST.tsv write it."""
    return "-" if value is None else str(value)


def grid(size, low=0.0, high=1.0):
    """A closed box over a square grid, size x size cells on top and bottom: 4 size (size + 2) triangles. (vertices, faces)"""
    n = size + 1
    vertices = [(x, y, z) for z in (low, high) for y in range(n) for x in range(n)]
    faces = []
    for y in range(size):
        for x in range(size):
            a, b, c, d = (y * n + x, y * n + x + 1, (y + 1) * n + x + 1, (y + 1) * n + x)
            faces += [(a, c, b), (a, d, c), (a + n * n, b + n * n, c + n * n), (a + n * n, c + n * n, d + n * n)]
    rim = ([x for x in range(size)] + [y * n + size for y in range(size)] + [size * n + x for x in range(size, 0, -1)] +
           [y * n for y in range(size, 0, -1)])
    for a, b in zip(rim, rim[1:] + rim[:1]):
        faces += [(a, b, b + n * n), (a, b + n * n, a + n * n)]
    return vertices, faces


def write_off(path, vertices, faces):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        file.writelines("%r %r %r\n" % v for v in vertices)
        file.writelines("3 %d %d %d\n" % f for f in faces)
    return path


class Folder(unittest.TestCase):
    """Each test has a folder of its own, which is also TMPDIR, so that what is left behind shows."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="veritope-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.environment = {**os.environ, "TMPDIR": str(self.folder)}

    def volumes(self, name, root):
        """The file NAME.vjson of the volumes of a tree."""
        tree, volumes = self.folder / f"{name}.json", self.folder / f"{name}.vjson"
        tree.write_text(json.dumps({"format": "veritope-tree-1", "root": root}))
        done = run("build", tree, "-o", volumes)
        self.assertEqual(done.returncode, 0, done.stderr)
        return volumes

    def listing(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))

    def copy_programs(self, checker=None):
        """A folder with veritope and, instead of veritope-check, a shell script; None: without a checker. Returns veritope."""
        programs = self.folder / "programs"
        programs.mkdir()
        shutil.copy(BIN / "veritope", programs)
        if checker is not None:
            script = programs / "veritope-check"
            script.write_text("#!/bin/sh\n" + checker + "\n")
            script.chmod(0o755)
        return programs / "veritope"


def main():
    if not (BIN / "veritope").exists():
        sys.exit(f"{BIN} has no program veritope: build it, or set VERITOPE_BIN")
    unittest.main()
