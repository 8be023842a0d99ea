# SPDX-License-Identifier: Apache-2.0 OR MIT
"""What the tests of the Python checker of star-box certificates of version 2 share: what is accepted, and lies of which each is rejected by
its condition and accepted when only that condition is left out. What a second judge cannot leave out (a part of a condition) is
replaced by unittest.mock; only the first judge is asked then."""
import contextlib
import copy
import unittest
from fractions import Fraction as Q
from unittest import mock

import star_box_2_forge as forge2
import star_box_2_models as models2
import star_box_forge as forge
import star_box_test as star

vc, SCALE, UNIT, units, Box2, Prover2 = star.vc, star.SCALE, models2.UNIT, models2.units, forge2.Box2, forge2.Prover2


def replaced(*changes):
    """changes: (module or class, name, value)."""
    stack = contextlib.ExitStack()
    for change in changes:
        stack.enter_context(mock.patch.object(*change))
    return stack


class Judged(unittest.TestCase):
    def says(self, expected, prover, plan=None, skip=(), claim="star-box-2"):
        plan = plan or prover.plan
        plan.values["claim"] = claim
        code, line = vc._check(prover.model, plan.certificate(prover.model), frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT " + claim, "ACCEPT"), expected, line)
        self.assertEqual(code, 0 if expected == "ACCEPT" else 1, line)
        return line

    def alone(self, condition, prover, plan=None, *changes, skip=None, claim="star-box-2"):
        """The lie is rejected by this condition and accepted without it: without the changed parts if there are changes."""
        self.says(condition, prover, plan, claim=claim)
        with replaced(*changes):
            self.says("ACCEPT", prover, plan, {"replaced"} if changes else skip or {condition}, claim)

    def one_box(self, expected, entities, box, *changes, frames=(), roots=0):
        """What the test of one box says about open surfaces."""
        with replaced(*changes):
            prover = Prover2(entities, frames=frames, checked=False)
            for patch in prover.patches:
                patch.roots = [roots, 0] if isinstance(roots, int) else roots
            prover.forest = forge.star_nodes.Forest(prover.patches, 10 ** 9)
            reason = prover.reason(box)
            self.assertEqual(reason.split(":")[0], expected, reason)


class OnAPlate(Judged):
    """Lies about a turned plate, which has a mesh box, one with one sheet and one with both walls."""

    @classmethod
    def setUpClass(cls):
        cls.plate = models2.proved_plate(Q(1, 64), True)
        number = [len(box.centres) for box in cls.plate.plan.boxes].index
        cls.mesh, cls.one, cls.walls = number(0), number(1), number(2)

    def plan(self, **fields):
        plan = copy.deepcopy(self.plate.plan)
        for key, value in fields.items():
            setattr(plan, key, value)
        return plan

    def changed(self, number, **fields):
        plan = self.plan()
        for key, value in fields.items():
            setattr(plan.boxes[number], key, value)
        return plan
