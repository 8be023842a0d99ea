#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against both checkers of the claim dms-invalid-1, with fixed seeds (dms_invalid_liars.py runs more).

VERITOPE names the program that proves dms-solid-1; VERITOPE_CHECK names the C++ checker; if unset it is built from verify/checker in a
temporary folder.
"""
import copy
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import dms_invalid_findings as true                       # noqa: E402
import dms_invalid_liars as liars                         # noqa: E402
import dms_liars                                          # noqa: E402
import mutation_test                                      # noqa: E402
import patch_attacks                                      # noqa: E402

SEEDS = range(3)                                          # for each strategy
MORE = {liars.spoiled: range(20)}                         # each tells one lie


class DmsInvalidMutationTest(mutation_test.WithBothCheckers):
    kind = liars.Run

    def test_no_lie_is_accepted_and_every_condition_is_needed(self):
        for strategy, _ in liars.STRATEGIES:
            for seed in MORE.get(strategy, SEEDS):
                for name, subject, cert in patch_attacks.subjects(liars.told(strategy, random.Random(seed))):
                    self.run_.attack(name, subject, cert, seed)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(liars.missing_conditions(self.run_.alone), [])
        for (name, condition), _ in self.run_.table.items():
            if name.startswith("W"):                      # what is wrong is what is rejected
                self.assertEqual(condition, name.split("_")[0], name)

    def test_true_findings_of_every_kind_are_accepted(self):
        for kind, name in enumerate(liars.NAMES):
            for seed in range(6):
                finding = true.honest(kind, random.Random(seed))
                data = finding.model.data()
                self.run_.accept(name, patch_attacks.Subject(data), finding.certificate(data), seed)
        for seed in range(10):                            # where the side that rule H takes matters
            finding = liars.maps.negative_side(random.Random(seed))
            data = finding.model.data()
            self.run_.accept("jacobian between two sides", patch_attacks.Subject(data), finding.certificate(data), seed)
        self.assertEqual(self.run_.failures, [])

    def test_a_solid_may_have_clouds_without_a_core(self):
        """The one finding beside which dms-solid-1 may hold: that claim does not need condition (b)."""
        finding = true.no_core(random.Random(1))
        data = finding.model.data()
        # `certify` proves no model with a defect. Both maps are the identity, so the proof about the collapsed clouds holds here, too.
        collapsed = copy.deepcopy(finding.model)
        for v in range(len(collapsed.clouds)):
            for i in range(1, collapsed.last + 1):
                collapsed.set_knot(v, i, collapsed.point(v))
        proof = dms_liars.proved(collapsed.data())
        proof.data = data
        for certificate in (finding.certificate(data), proof.certificate()):
            self.run_.accept("no core", patch_attacks.Subject(data), certificate, 1)
        self.assertEqual(self.run_.failures, [])


if __name__ == "__main__":
    unittest.main()
