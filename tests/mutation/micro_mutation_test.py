#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Quick: lying provers against the checkers of the claim microstructure-1, with fixed seeds (micro_liars.py runs more).

VERITOPE_CHECK names the C++ checker; it judges, too, if it knows the claim.
"""
import os
import random
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import attacks                                            # noqa: E402
import micro_liars as liars                               # noqa: E402
import patch_attacks                                      # noqa: E402

SEEDS = range(12)                                         # for each strategy: about 300 attacks


def native():
    """The C++ checker, or no name if it does not know the claim."""
    name = os.environ.get("VERITOPE_CHECK")
    known = name and subprocess.run([name, "--claims"], capture_output=True, text=True, check=True).stdout
    return name if known and "microstructure-1 " in known else ""


class MicroMutationTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.run_ = liars.Run(attacks.parse(["--checker", native(), "--save", os.path.join(cls.folder.name, "failures")]))

    @classmethod
    def tearDownClass(cls):
        cls.run_.native.close()
        cls.folder.cleanup()

    def setUp(self):
        self.run_.failures.clear()

    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        for strategy, _ in liars.STRATEGIES:
            for seed in SEEDS:
                for name, subject, cert in patch_attacks.subjects(liars.told_by(strategy, random.Random(seed))):
                    self.run_.attack(name, subject, cert, seed)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(liars.missing_conditions(self.run_.alone), [])

    def test_honest_certificates_are_accepted(self):
        for seed in range(30):
            for name, subject, cert in self.run_.honest_certificates(random.Random(seed)):
                self.run_.accept(name, subject, cert, seed)
        self.assertEqual(self.run_.failures, [])


if __name__ == "__main__":
    unittest.main()
