#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Quick: lying provers against the checkers of the claims microstructure-1 and micro-inside-1, with fixed seeds (micro_liars.py and
micro_inside_liars.py run more).

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
import micro_inside_liars as inside_liars                 # noqa: E402
import micro_liars as liars                               # noqa: E402
import micro_variants                                     # noqa: E402
import patch_attacks                                      # noqa: E402

SEEDS = range(12)                                         # for each strategy: about 300 attacks


def native():
    """The C++ checker, or no name if it does not know the claim."""
    name = os.environ.get("VERITOPE_CHECK")
    known = name and subprocess.run([name, "--claims"], capture_output=True, text=True, check=True).stdout
    return name if known and "microstructure-1 " in known else ""


class Lying(unittest.TestCase):
    """A run of `liars`, a module, against both checkers."""
    liars = None

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.run_ = cls.liars.Run(attacks.parse(["--checker", native(), "--save", os.path.join(cls.folder.name, "failures")]))

    @classmethod
    def tearDownClass(cls):
        cls.run_.native.close()
        cls.folder.cleanup()


class MicroMutationTest(Lying):
    liars = liars

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

    def test_variants_are_rejected_for_the_same_condition(self):
        """By the C++ checker, or by the Python one."""
        check = self.run_.native.check if self.run_.options.checker else self.run_.py.check
        for n, (strategy, _) in enumerate(liars.STRATEGIES):
            rng = random.Random(n)
            for _, lie in () if strategy in liars.ALONE else strategy(rng):
                said = attacks.condition_of(*check(lie.text(), lie.certificate()))
                for other in micro_variants.variants(lie, rng, 3):
                    self.assertEqual(attacks.condition_of(*check(other.text(), other.certificate())), said, strategy)


class InsideMutationTest(Lying):
    liars = inside_liars

    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        for strategy, _ in inside_liars.STRATEGIES:
            for seed in range(8):
                for name, subject, certificate, model in inside_liars.told_by(strategy, random.Random(seed)):
                    self.run_.attack(name, inside_liars.Case(subject, model), certificate, seed)
        for seed in range(12):
            for name, subject, certificate in self.run_.honest_certificates(random.Random(seed)):
                self.run_.accept(name, subject, certificate, seed)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(inside_liars.missing_conditions(self.run_.alone), [])


class BridgesTest(unittest.TestCase):
    """What the liars say of K is decided by their own computation, which is right where it is known."""

    def test_r1_of_straight_bridges(self):
        for seed in range(20):
            rng = random.Random(seed)
            row = liars.micro_bridge_liars.Row(rng)
            bridge = row.bridge(liars.micro_bridge_liars.some_end(rng, row))
            self.assertTrue(liars.micro_bridge_liars.keeps_r1(bridge), seed)
            turned = bridge.changed(matrix=[[-c for c in line] for line in bridge.matrix])
            self.assertFalse(liars.micro_bridge_liars.keeps_r1(turned), seed)


if __name__ == "__main__":
    unittest.main()
