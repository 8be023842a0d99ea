#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of the claim star-box-turned-2: the tests of star-box-turned-1 with bodies of version 2, and a thin plate inside out,
about which each lie is rejected by the condition that it breaks."""
import copy
import unittest
from fractions import Fraction as Q

import star_box_2_forge as forge2
import star_box_2_models as models2
import star_box_test as star
import star_box_turned_test as turned
from star_box_2_judged import Judged, Prover2, replaced

from veritope_checker.patches import star_box_2_check as check, star_box_2_sheets as sheets

CLAIM = "star-box-turned-2"


class Turned(turned.Turned):
    def says(self, expected, prover, plan=None, skip=(), claim="star-box-turned-1"):
        plan = forge2.to_version_2(plan or prover.plan)
        Judged.says(self, expected, prover, plan, skip, claim.replace("-1", "-2"))


class AnySign(star.AnySign, Prover2):
    pass


class ThinPlate(Judged):
    """Its surface is that of a plate 1 x 1 x 1/64, turned in space, with its normals inwards."""

    @classmethod
    def setUpClass(cls):
        entities, to, boxes = models2.plate(Q(1, 64), True, True)
        cls.plate = AnySign(entities, boxes, to.frames, roots=2, deepest=0).prove()
        cls.plate.plan.values.update(winding=0, bodies=0)
        number = [len(box.centres) for box in cls.plate.plan.boxes].index
        cls.one, cls.walls = number(1), number(2)

    def lie(self, condition, change, *changes):
        plan = copy.deepcopy(self.plate.plan)
        change(plan)
        self.alone(condition, self.plate, plan, *changes, claim=CLAIM)

    def test_it_is_accepted(self):
        self.says("ACCEPT", self.plate, claim=CLAIM)

    def test_it_is_no_solid(self):
        plan = copy.deepcopy(self.plate.plan)
        self.says("S1", self.plate, plan)                 # a key more than that claim has
        del plan.values["winding"]
        self.says("W2", self.plate, plan)

    def test_w3(self):
        for key, lies in (("winding", (1, 2, (1 << 64) - 1)), ("bodies", (1,)), ("genus", (1,)), ("shells", (2,))):
            for value in lies:
                self.lie("W3", lambda plan, key=key, value=value: plan.values.update({key: value}))

    def test_w1_a_walk_that_starts_at_a_box_with_two_sheets(self):
        def change(plan):
            (_, sign, points, end), = plan.walks
            plan.walks = [(self.walls, sign, points, end)]
        self.lie("W1", change)

    def test_c2_centres_exchanged(self):
        """c- and c+ of the wall z = 0: no node has S1 with them."""
        self.lie_about_s1(lambda box: box.centres[0].reverse())

    def test_c2_the_sheets_exchanged(self):
        """The centres of each wall with the signs of the other: their separator is wrong on every node."""
        plan = copy.deepcopy(self.plate.plan)
        box = plan.boxes[self.walls]
        box.signs = box.signs[::-1]
        self.says("C2", self.plate, plan, claim=CLAIM)

    def lie_about_s1(self, change):
        plan = copy.deepcopy(self.plate.plan)
        box = plan.boxes[self.walls]
        box.centres = [list(pair) for pair in box.centres]
        change(box)
        self.says("C2", self.plate, plan, claim=CLAIM)
        # Without S1 the crossing number names it.
        with replaced((sheets, "has_s1", lambda *_: True)):
            self.says("C3", self.plate, plan, claim=CLAIM, skip={"replaced"})
            with replaced((check.Crossing, "number", lambda _: 1)):
                self.says("ACCEPT", self.plate, plan, claim=CLAIM, skip={"replaced"})

    def test_c1_a_box_that_a_leaf_leaves(self):
        def change(plan):
            plan.boxes[self.walls].hi[0] -= 9 * models2.UNIT // 4
        self.lie("C1", change)


if __name__ == "__main__":
    unittest.main()
