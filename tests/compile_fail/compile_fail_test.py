#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Must-not-compile: each .cc file here is compiled twice, without its bad line (or flags) and with it.

usage: compile_fail_test.py COMPILER SOURCE_DIR

  // EXPECT REGEX      what the compiler must say about the bad line
  // BAD-FLAGS FLAGS   the flags are what is bad, not a line under #if defined(VT_BAD)
  // ONLY NAME         skip the file for other compilers

probe_main.cc is run under flags that a compiler does not admit to: the run-time probe must find them.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

COMPILER, SOURCE = (sys.argv[1], pathlib.Path(sys.argv[2])) if len(sys.argv) > 2 else ("g++", pathlib.Path("."))
FOLDER = pathlib.Path(__file__).resolve().parent
VERSION = subprocess.run([COMPILER, "--version"], capture_output=True, text=True).stdout
NAME = "clang++" if "clang" in VERSION else "g++"
BASE = [COMPILER, "-std=c++20", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
        "-Wno-unused-variable", "-Wno-unused-but-set-variable", f"-I{SOURCE}"]


def compile_only(path, flags):
    run = subprocess.run(BASE + flags + ["-fsyntax-only", str(path)], capture_output=True, text=True)
    return run.returncode == 0, run.stderr


class MustNotCompile(unittest.TestCase):
    def test_each_file_compiles_without_its_bad_part_and_not_with_it(self):
        files = [p for p in sorted(FOLDER.glob("*.cc")) if p.name != "probe_main.cc"]
        self.assertGreater(len(files), 15)
        for path in files:
            text = path.read_text()
            tags = dict(re.findall(r"^// (EXPECT|BAD-FLAGS|ONLY) (.*)$", text, re.M))
            self.assertEqual("ONLY" in text, "ONLY" in tags, f"{path.name}: a tag stands at the start of its line")
            if tags.get("ONLY", NAME) != NAME:
                continue
            with self.subTest(path.name):
                good, errors = compile_only(path, [])
                self.assertTrue(good, errors)
                bad, errors = compile_only(path, tags.get("BAD-FLAGS", "-DVT_BAD").split())
                self.assertFalse(bad, "the bad part compiles")
                self.assertRegex(errors, tags["EXPECT"])


class Probe(unittest.TestCase):
    CONTRACTION, EXCESS, REASSOCIATION = 1 << 3, 1 << 4, 1 << 5

    def found(self, flags):
        with tempfile.TemporaryDirectory() as folder:
            program = str(pathlib.Path(folder) / "probe")
            base = [f for f in BASE if f != "-ffp-contract=off"]
            subprocess.run(base + flags + [str(FOLDER / "probe_main.cc"), "-o", program], check=True)
            return int(subprocess.run([program], capture_output=True, text=True, check=True).stdout)

    def test_nothing_is_wrong_under_our_flags(self):
        for level in ("-O0", "-O2", "-O3"):
            self.assertEqual(self.found([level, "-ffp-contract=off"]), 0)

    def test_contraction_is_found(self):
        cpu = pathlib.Path("/proc/cpuinfo")
        if not cpu.exists() or " fma " not in cpu.read_text():
            self.skipTest("no FMA instructions here")
        self.assertEqual(self.found(["-O2", "-mfma", "-ffp-contract=fast"]), self.CONTRACTION)

    def test_reassociation_is_found(self):
        flags = ["-O2", "-ffp-contract=off", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"]
        self.assertTrue(self.found(flags) & self.REASSOCIATION)

    def test_excess_precision_is_found(self):
        if NAME != "g++":
            self.skipTest("clang has no x87 mode for x86-64")
        self.assertTrue(self.found(["-O2", "-ffp-contract=off", "-mfpmath=387"]) & self.EXCESS)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
