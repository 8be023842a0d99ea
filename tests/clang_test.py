#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""clang++-14, which builds the fuzz targets, compiles what g++ compiles.

    clang_test.py BUILD_FOLDER

Only parses what the build compiles of the libraries and programs, with the build's warnings as errors. The suite
golden_compilers compiles a tenth of the objects with clang and runs them; this test reads them all."""
import concurrent.futures
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]
CLANG = "clang++-14"
FLAGS = ["-std=c++20", "-fsyntax-only", "-frounding-math", "-Wall", "-Wextra", "-Wpedantic", "-Wno-unused-parameter",
         "-Werror", "-I", str(ROOT), "-isystem", "/usr/include/eigen3"]


def units(build):
    """What the build compiles for the libraries and programs, with the options that name instructions or macros: batches of files, and
    files that are compiled alone. Tests and benchmarks are compiled by g++ alone."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"])
        folder = path.relative_to(build if path.is_relative_to(build) else ROOT).parts[0]
        if (ROOT / folder).is_dir() and folder not in ("tests", "bench", "examples", "fuzz"):
            found[path] = [word for word in shlex.split(entry["command"]) if word.startswith(("-m", "-D", "-I"))]
    return found


def errors_of(unit, options=()):
    run = subprocess.run([CLANG, *FLAGS, *options, str(unit)], capture_output=True, text=True, timeout=1200)
    return run.stderr if run.returncode else ""


@unittest.skipUnless(shutil.which(CLANG), CLANG + " is not installed")
class Clang(unittest.TestCase):
    build = None

    def test_it_parses_every_library(self):
        found = units(self.build)
        self.assertGreater(len(found), 100)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for unit, errors in zip(found, pool.map(errors_of, found, found.values())):
                self.assertEqual(errors, "", unit)

    def test_an_error_is_seen(self):
        wrong = self.build / "clang_test_wrong.cc"
        wrong.write_text("int main() { return missing; }\n")
        self.addCleanup(wrong.unlink)
        self.assertIn("missing", errors_of(wrong))
        wrong.write_text("class Wrong { int unused; };\n")
        self.assertIn("unused", errors_of(wrong))


if __name__ == "__main__":
    Clang.build = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
