#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope selftest: its counts, how hard its cases are, and that it notices wrong signs: those of a process that flushes small numbers to zero."""
import os
import platform
import re
import shutil
import signal
import subprocess
import unittest

import predicate_oracle
from support import BIN, Folder, main, run

EXPLICIT = list(predicate_oracle.NUM_OPERANDS)
NAMES = EXPLICIT + list(predicate_oracle.IMPLICIT)
ROW = re.compile(r"(?m)^(\w+) +(\d+) cases, (\d+) exact zeros, (\d+) disagreements; "
                 r"decided by filter (\d+), lattice (\d+), interval (\d+), exact (\d+)$")
WRONG = re.compile(r"(?m)^(\w+): expected (-?[01]), found (-?[01]):((?: -?0x\S+)+)$")
COMPILER = next((name for name in ("g++", "c++", "clang++") if shutil.which(name)), None)


def rows(text):
    """{name: [cases, zeros, disagreements, the four tiers]}"""
    return {row[0]: [int(number) for number in row[1:]] for row in ROW.findall(text)}


class SelfTest(Folder):
    def test_a_right_build_agrees_on_hard_cases_of_every_tier(self):
        share = 1000
        total = share * len(NAMES)
        done = run("selftest", "--verbose", "--cases", total)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertEqual(lines[0], "floating point is as the filters need it")
        self.assertEqual(lines[-1], f"{total} cases, 0 disagreements; seed 1")
        counts = rows(done.stdout)
        self.assertEqual((list(counts), len(lines)), (NAMES, len(NAMES) + 2))
        for name, (cases, zeros, disagreements, *tiers) in counts.items():
            self.assertEqual((cases, disagreements), (share, 0), name)
            self.assertGreaterEqual(zeros, 0.3 * cases, name)
            self.assertGreaterEqual(cases - zeros, 0.3 * cases, name)
            if name in EXPLICIT and name != "order_on_circle":  # that one asks others
                self.assertEqual(sum(tiers), share, name)
                self.assertGreaterEqual(min(tiers), 3, name)
            else:
                self.assertGreaterEqual(min(tiers[2:]), 5, name)

    def test_the_cases_depend_on_the_seed_and_on_nothing_else(self):
        first, second, other = (run("selftest", "--verbose", "--cases", 400, "--seed", seed).stdout for seed in (7, 7, 18446744073709551615))
        self.assertEqual(first, second)
        self.assertNotEqual(rows(first), rows(other))
        self.assertTrue(other.endswith("400 cases, 0 disagreements; seed 18446744073709551615\n"), other)

    def test_the_cases_are_dealt_out_to_all(self):
        for cases, shares in [(1, [1] + [0] * (len(NAMES) - 1)), (len(NAMES) + 3, [2] * 3 + [1] * (len(NAMES) - 3))]:
            self.assertEqual([row[0] for row in rows(run("selftest", "--verbose", "--cases", cases).stdout).values()], shares)

    def test_without_verbose_a_right_build_prints_one_line(self):
        done = run("selftest", "--cases", 300)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "300 cases, 0 disagreements; seed 1\n", ""))

    def test_output_that_cannot_be_written_is_exit_4(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([BIN / "veritope", "selftest", "--cases", "4"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual((done.returncode, done.stderr), (4, "veritope: standard output: cannot be written: No space left on device\n"))


# Switches FTZ and DAZ on when the program first uses GMP: after its first decision, for which it asked about them.
LATE = """#include <dlfcn.h>
#include <xmmintrin.h>
extern "C" void __gmpz_init(void* z) {
  _mm_setcsr(_mm_getcsr() | 0x8040);
  static const auto init = reinterpret_cast<void (*)(void*)>(dlsym(RTLD_NEXT, "__gmpz_init"));
  init(z);
}
"""


@unittest.skipIf(os.environ.get("VERITOPE_SANITIZE"), "sanitizers want to be loaded first")
class HostileProcess(Folder):
    def hostile(self, *arguments, source=""):
        """veritope with a library in it that was built with -ffast-math: it switches FTZ and DAZ on."""
        library, code = self.folder / "fast.so", self.folder / "fast.cc"
        code.write_text(source)
        flags = ["-ffast-math"] if source == "" else []
        subprocess.run([COMPILER, "-shared", "-fPIC", *flags, code, "-o", library], check=True)
        return run(*arguments, env={**os.environ, "LD_PRELOAD": str(library)})

    def test_where_small_numbers_are_flushed_integers_decide_and_are_right(self):
        self.assertIsNotNone(COMPILER)
        done = self.hostile("selftest", "--verbose", "--cases", 25000, "--seed", 3)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"^floating point is not as the filters need it: flush-to-zero .*denormals-are-zero .*; integers decide\n")
        self.assertEqual(WRONG.findall(done.stdout), [])
        self.assertEqual(len(re.findall(r"decided by filter 0, ", done.stdout)), len(rows(done.stdout)))
        self.assertRegex(done.stdout, r"\n25000 cases, 0 disagreements; seed 3\n$")

    @unittest.skipUnless(platform.machine() == "x86_64", "sets the control word of SSE")
    def test_wrong_signs_are_found_and_shown(self):
        """They take a control word that changes after the first decision, unknown to the thread."""
        done = self.hostile("selftest", "--verbose", "--cases", 50000, "--seed", 3, source=LATE)
        if os.environ.get("VERITOPE_AUDIT") == "ON":  # the predicates notice it themselves
            self.assertEqual(done.returncode, -signal.SIGABRT)
            self.assertRegex(done.stderr, r"^audit: two tiers of a cascade contradict each other, please report: filter says -?[01], \w+ says -?[01]\n")
            return
        self.assertEqual(done.returncode, 5)
        self.assertTrue(done.stdout.startswith("floating point is as the filters need it\n"))
        shown = WRONG.findall(done.stdout)
        self.assertGreater(len(shown), 0)
        self.assertEqual(len(shown), sum(row[2] for row in rows(done.stdout).values()))
        self.assertRegex(done.stdout, rf"\n50000 cases, {len(shown)} disagreements; seed 3\n$")
        for name, expected, found, operands in shown:
            self.assertNotEqual(expected, found)
            values = [float.fromhex(operand) for operand in operands.split()]
            self.assertEqual(predicate_oracle.sign(name, values), int(expected), (name, operands))
            self.assertEqual(run("predicate", name, "--expect", "-", input=f"{operands} {expected}\n").returncode, 0)

    def test_the_other_commands_refuse_such_a_process(self):
        done = self.hostile("predicate", "orient2d", "/dev/null")
        self.assertEqual((done.returncode, done.stdout), (5, ""))
        self.assertIn("flush-to-zero", done.stderr)


if __name__ == "__main__":
    main()
