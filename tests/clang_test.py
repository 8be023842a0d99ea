#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""clang++-14, which builds the fuzz targets, compiles what g++ compiles.

    clang_test.py BUILD_FOLDER

Only parses: the batches of files that the build has made of the libraries, so a layer costs seconds. The suite golden_compilers
compiles a tenth of the objects with clang and runs them; this test reads them all."""
import concurrent.futures
import pathlib
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]
CLANG = "clang++-14"
FLAGS = ["-std=c++20", "-fsyntax-only", "-frounding-math", "-Wno-everything", "-I", str(ROOT), "-isystem", "/usr/include/eigen3"]


def batches(build):
    """The libraries' batches; tests and benchmarks are compiled by g++ alone. Other tests build whole trees in folders of the build
    that the sources do not have."""
    def is_of_library(path):
        folder = path.relative_to(build).parts[0]
        return (ROOT / folder).is_dir() and folder not in ("tests", "bench")

    return sorted(path for path in build.glob("**/Unity/unity_*.cxx") if is_of_library(path))


def errors_of(batch):
    run = subprocess.run([CLANG, *FLAGS, str(batch)], capture_output=True, text=True, timeout=1200)
    return run.stderr if run.returncode else ""


@unittest.skipUnless(shutil.which(CLANG), CLANG + " is not installed")
class Clang(unittest.TestCase):
    build = None

    def test_it_parses_every_library(self):
        found = batches(self.build)
        if not found:
            self.skipTest("the build has no batches of files")
        self.assertGreater(len(found), 15)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for batch, errors in zip(found, pool.map(errors_of, found)):
                self.assertEqual(errors, "", batch.relative_to(self.build))

    def test_an_error_is_seen(self):
        wrong = self.build / "clang_test_wrong.cc"
        wrong.write_text("int main() { return missing; }\n")
        self.addCleanup(wrong.unlink)
        self.assertIn("missing", errors_of(wrong))


if __name__ == "__main__":
    Clang.build = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
