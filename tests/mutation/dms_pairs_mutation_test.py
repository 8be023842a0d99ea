#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Quick: lying provers against both checkers of the claim dms-solid-2, with fixed seeds (dms_pairs_liars.py runs more).

VERITOPE names the program that proves what is bent; VERITOPE_CHECK names the C++ checker; if unset it is built from verify/checker in a
temporary folder.
"""
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import dms_pairs_liars as liars                           # noqa: E402
import mutation_test                                      # noqa: E402
import patch_attacks                                      # noqa: E402

SEEDS = range(8)                                          # for each strategy


class DmsPairsMutationTest(mutation_test.WithBothCheckers):
    kind = liars.Run

    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        told = 0
        for strategy, _ in liars.STRATEGIES:
            for seed in SEEDS:
                for name, subject, cert in patch_attacks.subjects(liars.told(strategy, random.Random(seed))):
                    self.run_.attack(name, subject, cert, seed)
                    told += 1
        self.assertEqual(self.run_.failures, [])
        self.assertGreater(told, 60)
        self.assertEqual(liars.missing_conditions(self.run_.alone), [])

    def test_honest_certificates_are_accepted(self):
        for seed in range(8):
            for name, subject, cert in self.run_.honest_certificates(random.Random(seed)):
                self.run_.accept(name, subject, cert, seed)
        self.assertEqual(self.run_.failures, [])


if __name__ == "__main__":
    unittest.main()
