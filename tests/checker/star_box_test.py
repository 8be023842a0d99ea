#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of star-box certificates against the Python one, whose tests it runs: on every model and certificate that they
judge (sound models, a lie for each condition, the traps of THEORY, hostile bytes) both must give the same exit code and name the
same condition. VERITOPE_CHECK names the program."""
import os
import random
import unittest
from fractions import Fraction as Q

import judges
import star_box_forge as forge
import star_box_hostile_test as hostile_tests
import star_box_itd_test as itd_tests
import star_box_models as models
import star_box_test as python_tests

SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
both, in_cpp = judges.both, judges.in_cpp
judges.judge(python_tests.vc)
SoundModels, Lies, Traps, Hostile = python_tests.SoundModels, python_tests.Lies, python_tests.Traps, hostile_tests.Hostile
Meaning, Refusals, ItdCertificates = itd_tests.Meaning, itd_tests.Refusals, itd_tests.Certificates


class Mutations(unittest.TestCase):
    """Single changes of sound certificates, with the hash of the body mended."""

    def mutated(self, prover, seed, rounds):
        rng = random.Random(seed)
        body = prover.plan.body()
        for _ in range(rounds):
            changed = bytearray(body)
            at = rng.randrange(len(changed))
            changed[at] = rng.choice([changed[at] ^ 1 << rng.randrange(8), rng.randrange(256)])
            plan = prover.plan
            original, plan.body = plan.body, lambda: bytes(changed)
            try:
                with self.subTest(seed=seed, at=at, value=changed[at]):
                    both(prover.model, plan.certificate())
            finally:
                plan.body = original

    def test_cube(self):
        self.mutated(forge.Prover(models.cube()).prove(), 61, 100 * SCALE)

    def test_tetrahedron(self):
        self.mutated(forge.Prover(models.tetrahedron()).prove(), 62, 40 * SCALE)

    def test_octant_sphere(self):
        self.mutated(forge.Prover(models.octant_sphere()).prove(), 63, 20 * SCALE)


class Cpp(unittest.TestCase):
    """What only this checker limits or does in its own way."""

    def test_coordinates_of_more_than_61_bits_are_refused_by_name(self):
        prover = forge.Prover(models.cube()).prove()
        box = prover.plan.boxes[0]
        for s, lo in ((70, [0, 0, 0]), (0, [1 << 61, 0, 0]), (41, box.lo)):
            plan = prover.plan
            plan.boxes[0] = forge.Box(box.kind, lo, box.size, box.minus, box.plus, s)
            code, condition, text = in_cpp(prover.model, plan.certificate())
            self.assertEqual((code, condition, "far" in text), (1, "B1", True), text)
        plan.boxes[0] = box
        self.assertEqual(in_cpp(prover.model, plan.certificate())[0], 0)

    def test_numbers_of_several_limbs(self):
        """The cube with thirds and long binary fractions, so that nodes have one to five limbs and no common power of two."""
        for bits in (3, 40, 90, 150):
            offset = Q(1, 3) + Q((1 << bits) // 3, 1 << bits)
            prover = forge.Prover(models.cube(middle=(offset, 0, offset))).prove()
            self.assertEqual(both(prover.model, prover.plan.certificate())[0], 0)


if __name__ == "__main__":
    unittest.main()
