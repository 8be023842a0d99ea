#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of collar certificates of version 2: collars around a thin plate whose boxes hold two sheets, and around bodies of
version 1 in the form of version 2."""
import copy
import unittest
from fractions import Fraction as Q

import collar_forge as forge
import collar_test as one
import star_box_2_forge as forge2
import star_box_2_models as models2


class Collar2(forge.Collar):
    """Shores end at boxes with one sheet."""

    def ends_at(self, box):
        return box.centres[0] if len(box.centres) == 1 else ()


class Collar2Test(one.CollarTest):
    def says(self, expected, collar, plan=None, claim=None, skip=()):
        plan = plan or forge.in_version_2(collar.plan, collar.star)
        if claim:
            plan.values["claim"] = claim
        code, line = one.vc._check(collar.model, plan.certificate(collar.model), frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT collar-2", "ACCEPT"), expected, line)
        return line


class CollarsOfVersion2(Collar2Test):
    def cube(self):
        collar = one.in_cells(one.brick(4, 24), one.solids.cube_shell(0, 28, 8, 20))
        collar.star = forge2.to_version_2(one.brick(4, 24).plan)
        return collar

    def test_a_cube_in_the_form_of_version_2(self):
        collar = self.cube()
        self.says("ACCEPT", collar)
        self.says("B1", collar, claim="collar-1")         # the magic is that of version 2
        plan = copy.deepcopy(collar.plan)
        plan.values["claim"] = "collar-2"
        self.says("B1", collar, plan)                     # and that of version 1

    def test_the_conditions_of_collars_hold_in_version_2_too(self):
        honest = self.cube()

        def lie(**fields):
            collar = copy.copy(honest)
            collar.plan = self.changed(honest, **fields)
            return collar
        steps = honest.plan.collapses
        self.says("K3", lie(collapses=steps[::-1]))
        self.says("K2", lie(sides=[1, 1]))
        self.says("B1", lie(shores=honest.plan.shores[1:]))
        self.says("I4", lie(shores=[honest.plan.shores[0], ([], 0)]))
        more = copy.copy(honest)
        more.plan = copy.deepcopy(honest.plan)
        more.plan.values["cells"] += 1
        self.says("K0", more)
        other = one.in_cells(one.brick(4, 30), one.solids.cube_shell(0, 28, 8, 20), shores=False)
        other.star = forge2.to_version_2(one.brick(4, 30).plan)
        self.says("I1", other)                            # around another cube



class ThinPlate(Collar2Test):
    """A plate of thickness 1/8; the box of its walls has two sheets."""
    @classmethod
    def setUpClass(cls):
        prover = models2.proved_plate(Q(1, 8))
        cls.plate = Collar2(prover, (-1,) * 3, 2)
        cls.plate.build(cls.plate.cells_at(7))
        cls.plate.star = prover.plan
        cls.walls = next(i for i, box in enumerate(prover.plan.boxes) if len(box.centres) == 2)

    def test_its_collar(self):
        self.assertEqual(len(self.plate.plan.shores), 2)
        self.says("ACCEPT", self.plate)

    def with_outer_shore(self, end):
        """From the least vertex of the outer side around the plate to a point above it."""
        around = [tuple(int(x * 2 ** -self.plate.star.unit) for x in p) for p in ((Q(-1, 2), Q(-1, 2), Q(-1, 2)), (Q(-1, 2), Q(-1, 2), Q(1, 4)))]
        shores = list(self.plate.plan.shores)
        outer = next(i for i, (_, end) in enumerate(shores) if end in range(6))
        shores[outer] = (around, end)
        collar = copy.copy(self.plate)
        collar.plan = self.changed(self.plate, shores=shores)
        return collar

    def test_a_shore_ends_at_a_box_with_one_sheet(self):
        """Both ends are points above the plate, where w is 0, and the ways to them are free."""
        one_sheet = next(i for i, box in enumerate(self.plate.star.boxes) if len(box.centres) == 1)
        self.says("ACCEPT", self.with_outer_shore((one_sheet, 1)))
        self.says("I4", self.with_outer_shore((self.walls, 1)))

    def test_c_minus_of_a_sheet_may_lie_outside(self):
        """c- of the upper sheet lies below the plate: w is 0 there, and not 1."""
        self.says("I4", self.with_outer_shore((self.walls, 0)))


if __name__ == "__main__":
    unittest.main()
