#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Quick: lying provers against both checkers of the claims about patches, with fixed seeds (patch_attacks.py runs more).

VERITOPE_CHECK names the C++ checker; if unset it is built from verify/checker in a temporary folder.
"""
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import attacks                                            # noqa: E402
import collar_liars as collar                             # noqa: E402
import fold_liars as fold                                 # noqa: E402
import invalid_liars as invalid                           # noqa: E402
import meeting_liars as meeting                           # noqa: E402
import mutation_test                                      # noqa: E402
import patch_attacks                                      # noqa: E402
import patch_differential                                 # noqa: E402
import patch_liars as star                                # noqa: E402
import sheet_conditions as parts                          # noqa: E402
import sheet_liars as sheets                              # noqa: E402


def bent(make, most=99):
    """The attacks on one false collar."""
    def found(rng):
        made = make(rng)
        for n, (name, plan) in enumerate(collar.bent(made, rng)):
            if n < most:
                yield "%s/%s" % (make.__name__, name), made.model, plan.certificate(made.model)
    return found


def three_sheets(rng):
    for case, plan in star.three_sheets(rng):
        yield "three_sheets", case.bytes, case.certificate(plan)


def double_cover(rng):
    case = star.Case(*star.double_cover(rng))
    yield "double_cover", case.bytes, case.certificate()


# Found by a greedy cover: every condition is needed by some attack of these.
SEEDS = ((star.star_attacks, (0, 1, 2, 6, 15)), (three_sheets, (2,)), (double_cover, (1, 3)), (invalid.invalid_attacks, (0, 1, 3, 13, 19, *range(100, 130))),
         (meeting.meeting_attacks, range(40)), (fold.fold_attacks, range(40)),        # every strategy
         (collar.lies_about_a_collar, (0,)), (bent(collar.touching_cells), (1,)), (bent(collar.out_of_the_wall), (1, 2)),
         (bent(collar.several_shells, 4), (3,)), (bent(collar.pits, 4), (0, 1)), (bent(collar.handle, 1), (0,)))


class PatchMutationTest(mutation_test.WithBothCheckers):
    kind = patch_attacks.Run

    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        for source, seeds in SEEDS:
            for seed in seeds:
                for name, subject, cert in patch_attacks.subjects(source(random.Random(seed))):
                    self.run_.attack(name, subject, cert, seed)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(patch_attacks.missing_conditions(self.run_.alone), [])
        for c in patch_attacks.CONDITIONS:
            if c not in patch_attacks.IMPLIED:
                self.assertGreater(self.run_.alone[c], 0, c)
        self.assertGreaterEqual(sum(self.run_.table.values()), 350)

    def test_every_part_of_a_condition_of_version_2_is_needed(self):
        names = {name[2:] for name in parts.NAMES if name not in parts.UNCOVERED}
        self.assertEqual({name for names in sheets.DIRECTED.values() for name in names}, names)
        for pair, wanted in sheets.DIRECTED.items():
            for name in wanted:
                self.assertTrue(any(self.is_needed(name, pair, seed) for seed in range(30)), (pair, name))
        self.assertEqual(self.run_.failures, [])

    def is_needed(self, name, pair, seed):
        for strategy, subject, cert in patch_attacks.subjects(sheets.directed_attacks(random.Random(seed), pair)):
            found = attacks.Run.both(self.run_, subject, cert, seed, strategy)
            self.assertNotEqual(found, "ACCEPT", (seed, strategy))
            if found == name.split()[0] and parts.accepts_without(self.run_.py._check, subject.bytes, cert, name):
                return True
        return False

    def test_honest_certificates_are_accepted(self):
        for seed in range(24):
            for name, subject, cert in patch_attacks.Run.honest_certificates(random.Random(seed)):
                self.run_.accept(name, subject, cert, seed)
        self.assertEqual(self.run_.failures, [])

    def test_the_checkers_read_damaged_files_alike(self):
        run = patch_differential.Run(self.options)
        for seed in range(150):
            for name, model, cert in patch_differential.cases(random.Random(seed)):
                run.attack(name, model, cert, seed)
        for seed in range(60):
            run.attack(*patch_differential.model_case(random.Random(seed), "formats"), seed)
        run.native.close()
        self.assertEqual(run.failures, [])
        self.assertGreater(run.table["same", "ACCEPT"], 30)
        formats = {name for name, _ in run.table}
        self.assertLessEqual({"vjson", "itd", "g2", "mfem", "vjson-faces", "itd-faces", "g2-faces", "mfem-faces"}, formats)

    def test_the_harness_notices_a_checker_that_accepts_everything(self):
        run = patch_attacks.Run(attacks.parse(["--save", self.options.save]))
        run.py._check = run.py.check = lambda model, cert, skip=None: (0, "ACCEPT star-box-1")
        for name, subject, cert in patch_attacks.subjects(star.star_attacks(random.Random(0))):
            run.attack(name, subject, cert, 0)
        run.native.close()
        self.assertTrue(run.failures and all("FALSE CLAIM ACCEPTED" in f for f in run.failures))


if __name__ == "__main__":
    unittest.main()
