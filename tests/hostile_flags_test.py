#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""A program of ours in translation units whose flags break ordinary floating point, linked with the library as it was built: what the headers compute inline must stay right.

usage: hostile_flags_test.py [--without-sse2] BUILD_FOLDER SOURCE_DIR SOURCE...

The program prints its number of checks and of violations. --without-sse2 adds -U__SSE2__, which selects the code for processors without it and runs on this one as well. Every compiler of COMPILERS that is here takes part.
"""
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

COMPILERS = ("g++", "clang++-14", "clang++-19")
FLAGS = ["-O0", "-O2 -ffp-contract=fast", "-O3 -ffast-math", "-Ofast -fno-rounding-math", "-O2 -ffinite-math-only -fno-signed-zeros",
         "-O3 -ffast-math -march=x86-64-v3", "-O2 -march=x86-64-v3", "-O2 -mfpmath=387"]
WITHOUT_SSE2 = ["-O0 -U__SSE2__", "-O2 -U__SSE2__"]
arguments = sys.argv[1:]
flag_sets = FLAGS + (WITHOUT_SSE2 if "--without-sse2" in arguments else [])
BUILD, SOURCE, *MAIN = (pathlib.Path(a) for a in arguments if a != "--without-sse2")
# What depends on others first; the compiler's own archives below build/golden are not these.
LIBRARIES = [str(BUILD / folder / f"libveritope_{name}.a")
             for folder, name in (("predicates", "predicates"), ("interval", "interval"), ("robust", "robust"), ("robust", "base"))]


def can_run(compiler, flags):
    if "387" in flags and compiler != "g++":
        return False
    return "-v3" not in flags or " avx2 " in pathlib.Path("/proc/cpuinfo").read_text()


def build_and_run(compiler, flags):
    """(what the compiler said, what the program printed)"""
    with tempfile.TemporaryDirectory() as folder:
        program = str(pathlib.Path(folder) / "hostile")
        built = subprocess.run([compiler, "-std=c++20", *flags.split(), f"-I{SOURCE}", *(str(SOURCE / m) for m in MAIN), *LIBRARIES,
                                "-lmpfr", "-lgmp", "-lpthread", "-o", program], capture_output=True, text=True)
        if built.returncode != 0:
            return built.stderr, ""
        ran = subprocess.run([program], capture_output=True, text=True)
        return "", ran.stdout + ran.stderr


class HostileFlags(unittest.TestCase):
    def test_nothing_is_wrong_under_any_flag_set(self):
        builds = [(c, f) for c in COMPILERS if shutil.which(c) for f in flag_sets if can_run(c, f)]
        self.assertTrue(builds)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for (compiler, flags), (errors, printed) in zip(builds, pool.map(lambda b: build_and_run(*b), builds)):
                with self.subTest(compiler=compiler, flags=flags):
                    self.assertEqual(errors, "")
                    self.assertRegex(printed, r"^\d+ \d+\n")
                    checks, violations = map(int, printed.split()[:2])
                    self.assertGreater(checks, 10000)
                    self.assertEqual(violations, 0, printed)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
