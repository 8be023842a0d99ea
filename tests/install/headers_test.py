#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every header of the tree, installed or not, compiles alone: it includes all that it needs. No precompiled header
takes part. (Those of bench/ are left out: they need the libraries that are compared there.)

usage: headers_test.py CXX_COMPILER
"""
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("robust", "splines", "interval", "predicates", "topology", "solids", "models", "io", "verify", "render",
           "named_predicates", "hard_models", "report", "cli", "interop", "fuzz", "tests")
FLAGS = ["-fsyntax-only", "-Wall", "-Wextra", "-Wno-unused-parameter", "-Werror", "-ffp-contract=off", f"-I{ROOT}"]
INTEROP_FLAGS = ["-isystem", "/usr/include/eigen3", "-frounding-math"]  # where Debian puts Eigen; what CGAL asks for
COMPILER = "c++"


DUMMY_KIND = ROOT / "tests" / "support" / "dummy_kind"  # files of another tree: tests/dummy_kind_test.py compiles them


def headers():
    paths = (path for folder in FOLDERS for path in (ROOT / folder).rglob("*.h") if not path.is_relative_to(DUMMY_KIND))
    return sorted(str(path.relative_to(ROOT)) for path in paths)


def flags_of(header):
    more = INTEROP_FLAGS if header.startswith("interop/") else []
    return ["-std=c++11" if header.startswith("verify/checker/") else "-std=c++20", *FLAGS, *more]


class Headers(unittest.TestCase):
    def test_every_header_compiles_alone(self):
        found = headers()
        for example in ("predicates/orient3d.h", "verify/checker/common/sha256.h", "tests/support/shapes.h"):
            self.assertIn(example, found)
        with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:

            def compile_alone(header):
                source = pathlib.Path(folder) / (header.replace("/", "_") + ".cc")
                source.write_text(f'#include "{header}"\n')
                return subprocess.run([COMPILER, *flags_of(header), source], capture_output=True, text=True)

            for header, done in zip(found, pool.map(compile_alone, found)):
                with self.subTest(header=header):
                    self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    COMPILER = sys.argv.pop(1)
    unittest.main()
