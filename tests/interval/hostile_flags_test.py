#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""interval.h in a translation unit whose flags break ordinary floating point: the bounds stay the tightest ones.

usage: hostile_flags_test.py BUILD_FOLDER SOURCE_DIR

-U__SSE2__ selects the code for processors without it, which runs on this one as well. The library itself is the one of BUILD_FOLDER. Every compiler of COMPILERS that is here takes part.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, SOURCE = (pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])) if len(sys.argv) > 2 else (None, None)
COMPILERS = ("g++", "clang++-14", "clang++-19")
FLAGS = ["-O0", "-O2 -ffp-contract=fast", "-O3 -ffast-math", "-Ofast -fno-rounding-math", "-O2 -ffinite-math-only -fno-signed-zeros",
         "-O3 -ffast-math -march=x86-64-v3", "-O2 -mfpmath=387",
         "-O0 -U__SSE2__", "-O2 -U__SSE2__"]


class HostileFlags(unittest.TestCase):
    def test_bounds_are_the_tightest_under_every_flag_set(self):
        libraries = [next(BUILD.rglob(f"libveritope_{name}.a")) for name in ("interval", "robust", "base")]
        compilers = [c for c in COMPILERS if shutil.which(c)]
        self.assertTrue(compilers)
        cpu = pathlib.Path("/proc/cpuinfo").read_text()
        with tempfile.TemporaryDirectory() as folder:
            for compiler in compilers:
                for flags in FLAGS:
                    if ("387" in flags and compiler != "g++") or ("-v3" in flags and " avx2 " not in cpu):
                        continue
                    program = str(pathlib.Path(folder) / "hostile")
                    command = [compiler, "-std=c++20", *flags.split(), f"-I{SOURCE}", str(SOURCE / "tests/interval/hostile_main.cc"),
                               *map(str, libraries), "-lmpfr", "-lgmp", "-lpthread", "-o", program]
                    with self.subTest(compiler=compiler, flags=flags):
                        built = subprocess.run(command, capture_output=True, text=True)
                        self.assertEqual(built.returncode, 0, built.stderr)
                        ran = subprocess.run([program], capture_output=True, text=True)
                        checks, violations = map(int, ran.stdout.split())
                        self.assertGreater(checks, 10000)
                        self.assertEqual(violations, 0, ran.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
