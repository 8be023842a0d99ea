#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope corpus: 100,000 hard cases, the same bytes on every machine, with signs that integers of Python confirm; and what
veritope predicate does with it. CORPUS_CASES: how many cases to judge here (default 8000; 0: all)."""
import collections
import hashlib
import os
import unittest

import predicate_oracle
from support import BIN, ROOT, Folder, main, run

CASES = int(os.environ.get("CORPUS_CASES", "8000"))
SHA256 = ROOT / "tests" / "cli" / "corpus.sha256"
NAMES = [*predicate_oracle.NUM_OPERANDS, *predicate_oracle.IMPLICIT]


def split(line):
    name, *operands, sign = line.split()
    return name, [float.fromhex(x) for x in operands], int(sign)


class Corpus(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.text = run("corpus", *(["--cases", CASES] if CASES else []), timeout=500).stdout
        cls.lines = [line for line in cls.text.splitlines() if not line.startswith("#")]

    def test_signs_are_those_of_integers(self):
        counts = collections.defaultdict(collections.Counter)
        for line in self.lines:
            name, operands, sign = split(line)
            self.assertEqual(predicate_oracle.sign(name, operands), sign, line)
            counts[name][sign] += 1
        self.assertEqual(sorted(counts), sorted(NAMES))
        for name, count in counts.items():
            self.assertGreaterEqual(count[0], 0.3 * count.total(), name)
            self.assertGreaterEqual(min(count[-1], count[1]), 0.1 * count.total(), name)

    def test_predicate_agrees_with_it_line_by_line(self):
        done = run("predicate", "any", "--expect", "--tiers", "-", input=self.text, timeout=300)
        self.assertEqual((done.returncode, done.stdout), (0, f"{len(self.lines)} cases, 0 disagreements\n"))

    def test_predicate_notices_every_wrong_sign(self):
        turned = []
        for line in self.lines[:200]:
            name_and_operands, sign = line.rsplit(" ", 1)
            turned.append(f"{name_and_operands} {(int(sign) + 2) % 3 - 1}")
        done = run("predicate", "any", "--expect", "-", input="\n".join(turned))
        self.assertEqual(done.returncode, 1)
        self.assertTrue(done.stdout.endswith(f"{len(turned)} cases, {len(turned)} disagreements\n"))

    def test_a_line_with_the_name_alone_given_answers_alike(self):
        for name in NAMES:
            mine = [line for line in self.lines if line.split()[0] == name][:20]
            done = run("predicate", name, "-", input="".join(line.split(" ", 1)[1].rsplit(" ", 1)[0] + "\n" for line in mine))
            self.assertEqual(done.stdout.split(), [line.rsplit(" ", 1)[1] for line in mine], name)

    def test_it_is_the_seed_and_the_number_of_cases(self):
        self.assertEqual(run("corpus", "--cases", 50).stdout.splitlines()[2:], self.lines[:50])
        self.assertNotEqual(run("corpus", "--cases", 50, "--seed", 2).stdout.splitlines()[2:], self.lines[:50])

    @unittest.skipIf(CASES, "all cases are printed in the full tests")
    def test_all_bytes_are_as_published(self):
        self.assertEqual(len(self.lines), 100000)
        self.assertEqual(hashlib.sha256(self.text.encode()).hexdigest(), SHA256.read_text().split()[0])


class Refusals(Folder):
    def refusal(self, name, line):
        done = run("predicate", name, "-", input="# first\n" + line + "\n")
        self.assertEqual((done.returncode, done.stdout), (4, ""))
        return done.stderr

    def test_a_line_without_a_known_name_is_refused(self):
        for name in ("orient4d", "any", "0", "ORIENT2D"):
            self.assertEqual(self.refusal("any", f"{name} 0 0 1 0 0 1"), "veritope: standard input:2: column 1: the name of a "
                             f"predicate expected, but there is '{name}'\n")

    def test_columns_count_the_name(self):
        self.assertIn(":2: column 3: a number expected, but there is 'x'", self.refusal("any", "orient2d 0 x 1 0 0 1"))
        self.assertIn(":2: 6 numbers expected, but there are 5 columns", self.refusal("any", "orient2d 0 0 1 0 0"))

    def test_points_that_do_not_exist_are_refused(self):
        nothing = "an implicit point does not exist: there is no such intersection, or a denominator is 0"
        for name, line in [("orient2d_ssi", "0 0 1 0 0 0 1 1 2 0 3 1"), ("orient2d_segment", "0 0 1 0 1 0 " * 3),
                           ("orient3d_lpi", "0 0 0 1 0 0 0 1 0 " + "0 0 0 1 0 0 0 0 1 1 0 1 0 1 1"),
                           ("orient3d_tpi", "0 0 0 1 0 0 0 1 0 " + "0 0 0 1 0 0 0 1 0 " * 3)]:
            self.assertIn(f":2: {nothing}\n", self.refusal(name, line))


if __name__ == "__main__":
    main()
