#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Quick: lying provers against both checkers of the claim vmodel-invalid-1, with fixed seeds (vmodel_invalid_liars.py runs more).

VERITOPE_CHECK names the C++ checker; if unset it is built from verify/checker in a temporary folder.
"""
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mutation_test                                      # noqa: E402
import patch_attacks                                      # noqa: E402
import vmodel_invalid_liars as liars                      # noqa: E402

SEEDS = range(8)                                          # for each strategy


class VModelInvalidMutationTest(mutation_test.WithBothCheckers):
    kind = liars.Run

    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        for strategy, _ in liars.STRATEGIES:
            for seed in SEEDS:
                found = ((name, model, lie.certificate(model)) for name, lie in strategy(random.Random(seed)) for model in [lie.model()])
                for name, subject, cert in patch_attacks.subjects(found):
                    self.run_.attack(name, subject, cert, seed)
        for what, _, lie in liars.all_lies():             # each once, where it is
            for name, subject, cert in patch_attacks.subjects([(what, lie.model(), lie.certificate())]):
                self.run_.attack(name, subject, cert, 0)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(liars.missing_conditions(self.run_.alone), [])

    def test_honest_certificates_are_accepted(self):
        for seed in range(60):
            for name, subject, cert in self.run_.honest_certificates(random.Random(seed)):
                self.run_.accept(name, subject, cert, seed)
        self.assertEqual(self.run_.failures, [])


if __name__ == "__main__":
    unittest.main()
