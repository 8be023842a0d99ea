#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Quick: lying provers against both checkers with fixed seeds (attacks.py and differential.py run more).

VERITOPE_CHECK names the C++ checker; if unset it is built from verify/checker in a temporary folder.
"""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import attacks                                            # noqa: E402
import differential                                       # noqa: E402
import expression_liars                                   # noqa: E402
import points_liars                                       # noqa: E402
import reversed_liars                                     # noqa: E402
import time_limit                                         # noqa: E402

# Found by a greedy cover: with these every condition is needed by at least two attacks.
SEEDS = (87, 94, 106, 115, 123, 134, 150, 183, 197, 215, 225, 247, 250, 252, 261, 320, 345, 352, 390, 431, 433)
POINTS_SEEDS = (0, 1, 2, 3, 8, 9, 10, 23, 158)
REVERSED_SEEDS = (22, 61, 130, 175, 197, 264, 397)          # found in the same way, for each condition once


def build_checker(folder):
    sources = sorted(str(p) for p in attacks.CHECKER_PY.parent.rglob("*.cc"))
    program = os.path.join(folder, "veritope-check")
    subprocess.run([os.environ.get("CXX", "g++"), "-std=c++11", "-O1", "-o", program] + sources, check=True)
    return program


class WithBothCheckers(unittest.TestCase):
    kind = attacks.Run                                    # of run_

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        checker = os.environ.get("VERITOPE_CHECK") or build_checker(cls.folder.name)
        cls.options = attacks.parse(["--checker", checker, "--save", os.path.join(cls.folder.name, "failures")])
        cls.run_ = cls.kind(cls.options)

    @classmethod
    def tearDownClass(cls):
        cls.run_.native.close()
        cls.folder.cleanup()

    def setUp(self):
        self.run_.failures.clear()


class ReversedMutationTest(WithBothCheckers):
    kind = reversed_liars.Run

    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        for seed in REVERSED_SEEDS:
            for name, case, cert in reversed_liars.reversed_attacks(random.Random(seed)):
                self.run_.attack(name, case, cert, seed)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(reversed_liars.missing_conditions(self.run_.alone), [])

    def test_honest_certificates_are_accepted(self):
        for seed in range(25):
            for name, case, cert in reversed_liars.honest(random.Random(seed)):
                self.run_.accept(name, case, cert, seed)
        self.assertEqual(self.run_.failures, [])


class PointsMutationTest(WithBothCheckers):
    kind = points_liars.Run

    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        sources = [(points_liars.too_much_work, 1), *((points_liars.points_attacks, seed) for seed in POINTS_SEEDS)]
        for source, seed in sources:
            for name, case, cert in source(random.Random(seed)):
                self.run_.attack(name, case, cert, seed)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(points_liars.missing_conditions(self.run_.alone), [])

    def test_honest_certificates_are_accepted(self):
        for seed in range(25):
            for name, case, cert in points_liars.honest(random.Random(seed)):
                self.run_.accept(name, case, cert, seed)
        self.assertEqual(self.run_.failures, [])


class ExpressionMutationTest(WithBothCheckers):
    kind = expression_liars.Run

    # PROVES POINT-6, POINT-7.P
    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        liars = expression_liars
        sources = ((liars.false_lines, (*range(8), 22)), (liars.other_files, range(6)), (liars.changed_files, range(3)), (liars.narrow_boxes, range(12)),
                   (liars.split_variables, range(3)), (liars.open_meshes, range(8)), (liars.curved_walls, range(12)), (liars.bad_fans, range(4)),
                   (liars.wrong_numbers, range(2)), (liars.shells, range(1)), (liars.too_much_work, range(1)))
        for source, seeds in sources:
            for seed in seeds:
                for name, case, cert in source(random.Random(seed)):
                    self.run_.attack(name, case, cert, seed)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(liars.missing_conditions(self.run_.alone), [])
        self.assertGreaterEqual(len({n for n, _ in self.run_.table}), 15)

    def test_honest_certificates_are_accepted(self):
        for seed in range(25):
            for name, case, cert in expression_liars.honest(random.Random(seed)):
                self.run_.accept(name, case, cert, seed)
        self.assertEqual(self.run_.failures, [])


class MutationTest(WithBothCheckers):
    # PROVES MESH-9
    def test_no_false_claim_is_accepted_and_every_condition_is_needed(self):
        for seed in SEEDS:
            for name, case, cert in attacks.attacks(random.Random(seed)):
                self.run_.attack(name, case, cert, seed)
        self.assertEqual(self.run_.failures, [])
        self.assertEqual(attacks.missing_conditions(self.run_.alone), [])
        for c in attacks.CONDITIONS:
            if c not in attacks.IMPLIED:
                self.assertGreater(self.run_.alone[c], 0, c)
        self.assertGreaterEqual(len({n for n, _ in self.run_.table}), 30)
        weak = sum(n for (_, c), n in self.run_.table.items() if c in attacks.UNCOUNTED)
        self.assertEqual(weak, 0)

    def test_honest_certificates_are_accepted(self):
        for seed in range(25):
            for name, case, cert in attacks.honest_certificates(random.Random(seed)):
                self.run_.accept(name, case, cert, seed)
        self.assertEqual(self.run_.failures, [])

    def test_the_checkers_read_damaged_files_alike(self):
        for seed in range(500):
            name, data, cert = differential.damaged_model(random.Random(seed))
            differential.compare(self.run_, data, cert, seed, name)
        for seed in range(12):
            for name, data, cert, broken in differential.damaged_certificate(random.Random(seed)):
                if differential.compare(self.run_, data, cert, seed, name) == "ACCEPT" and broken is not None:
                    self.assertFalse(differential.is_false(cert, broken))
        self.assertEqual(self.run_.failures, [])

    def test_the_harness_notices_a_checker_that_accepts_everything(self):
        run = attacks.Run(attacks.parse(["--save", self.options.save]))

        def accept(model, cert, skip=None):
            return 0, "ACCEPT mesh-valid-1"
        with unittest.mock.patch.object(run.py, "_check", accept), unittest.mock.patch.object(run.py, "check", accept):
            for name, case, cert in attacks.attacks(random.Random(SEEDS[0])):
                run.attack(name, case, cert, SEEDS[0])
        run.native.close()
        self.assertTrue(run.failures and all("FALSE CLAIM ACCEPTED" in f for f in run.failures))

    def test_the_harness_notices_a_checker_that_does_not_end(self):
        def busy(*_):
            while True:
                pass
        self.run_.py, py = unittest.mock.Mock(check=busy), self.run_.py
        try:
            with unittest.mock.patch.object(time_limit, "SECONDS", .05):
                code, message = self.run_.in_python(b"", b"")
        finally:
            self.run_.py = py
        self.assertEqual((code, message), (time_limit.TOO_SLOW, "takes more than 0.05 s of processor time"))

    def test_a_process_that_does_not_end_is_ended(self):
        process = subprocess.Popen([sys.executable, "-c", "while True: pass"])
        time_limit.limit_process(process.pid, 1)
        self.assertEqual(process.wait(600), -signal.SIGXCPU)


if __name__ == "__main__":
    unittest.main()
