#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates of version 2: B1, B2 and C1."""
import copy
import unittest
from fractions import Fraction as Q

import star_box_2_forge as forge2
import star_box_2_models as models2
import star_box_forge as forge
import star_box_models as models
from star_box_2_judged import OnAPlate, Box2, Prover2, UNIT, units, vc

from veritope_checker.patches import star_box_2_read as read2


class Body(OnAPlate):
    def test_b1(self):
        walls = self.plate.plan.boxes[self.walls]
        frame = self.plate.plan.frames[0]
        for plan in (self.plan(tail=b"x"), self.plan(flags=[2] + [0] * 5), self.plan(kinds=[2] + [1] * 5), self.plan(kinds=[0] + [1] * 5),
                     self.plan(kinds=[3] + [1] * 5), self.plan(magic=b"VTSB"), self.changed(self.walls, frame=2),
                     self.changed(self.walls, signs=[[1], [0]]), self.changed(self.walls, signs=[[3], [1]]),
                     self.changed(self.walls, signs=[[], []], separators=[]), self.changed(self.walls, shift=4097),
                     self.changed(self.walls, points_shift=4097), self.changed(self.walls, hi=[walls.lo[0], *walls.hi[1:]]),
                     self.changed(self.walls, separators=[[1, 65, walls.separators[0][2]]]),
                     self.changed(self.walls, separators=[[1, -65, walls.separators[0][2]]]),
                     self.changed(self.walls, separators=[[0, 0, [1]]]), self.changed(self.walls, separators=[[4, 0, [1] * 35]]),
                     self.changed(self.walls, centres=[], signs=[], separators=[]),
                     self.changed(self.one, separators=walls.separators, signs=[[1]]),
                     self.changed(self.walls, centres=walls.centres * 33, signs=[[1]] * 66),
                     self.changed(self.walls, separators=walls.separators * 65, signs=[[1] * 65, [2] * 65])):
            self.says("B1", self.plate, plan)
        self.says("ACCEPT", self.plate, self.changed(self.walls, separators=walls.separators * 64, signs=[[1] * 64, [2] * 64]))
        self.says("ACCEPT", self.plate, self.plan(frames=[frame] * 70000))
        body = self.plate.plan.body()
        for n in range(len(body)):                        # every truncation
            plan = self.plan()
            plan.body = lambda n=n: body[:n]
            self.says("B1", self.plate, plan)

    def test_b1_a_centre_on_the_boundary_of_its_box(self):
        for side in (0, 1):
            plan = self.plan()
            box = plan.boxes[self.walls]
            c = box.centres[1][side]
            at = models2.times(plan.frames[0], c)[2]
            self.assertNotIn(at, (box.lo[2], box.hi[2]))
            (box.lo if at < 0 else box.hi)[2] = at
            self.says("B1", self.plate, plan)
            (box.lo if at < 0 else box.hi)[2] += -1 if at < 0 else 1
            self.says("ACCEPT", self.plate, plan)

    def test_b2_an_entity_of_another_kind(self):
        entities = models.cube() + [{"kind": "curve", "group": None, "attributes": [], "shape": {}}]
        plan = forge2.Plan2(entities)
        plan.roots, plan.trees, plan.boxes = [[0, 0]] * 6, [[0]] * 6, [Box2(1, [0] * 3, [9] * 3)]
        code, line = vc._check(forge.encode_model(entities), plan.certificate(), frozenset())
        self.assertEqual((code, line[:10]), (1, "REJECT B2:"), line)
        plan.kinds[6] = 1
        code, line = vc._check(forge.encode_model(entities), plan.certificate(), frozenset())
        self.assertEqual((code, line[:10]), (1, "REJECT B1:"), line)

    def test_a_singular_frame(self):
        a, b, _ = frame = self.plate.plan.frames[0]
        lo, hi = self.plate.plan.boxes[self.mesh].lo, self.plate.plan.boxes[self.mesh].hi
        for singular in ((a, b, a), (a, b, (0, 0, 0)), (a, b, tuple(x + y for x, y in zip(a, b)))):
            plan = self.plan(frames=[frame, singular])
            box = plan.boxes[self.mesh]
            box.frame, box.lo, box.hi = 2, [*lo[:2], 8 * lo[2]], [*hi[:2], 8 * 9 * UNIT]
            self.alone("B1", self.plate, plan, (read2, "dot", lambda *_: 1))

    def test_an_entry_of_a_frame_of_more_than_31_bits(self):
        for entry, expected in (((1 << 31) - 1, "ACCEPT"), (1 << 31, "B1"), (1 - (1 << 31), "ACCEPT"), (-1 << 31, "B1")):
            plan = self.plan(frames=[*self.plate.plan.frames, ((entry, 0, 0), (0, 1, 0), (0, 0, 1))])
            self.says(expected, self.plate, plan)
            if expected == "B1":
                self.alone("B1", self.plate, plan, (read2, "MAX_ENTRY", 1 << 40))

    # PROVES STAR-4.APART
    def test_two_sheets_with_equal_signs(self):
        """Two open sheets that cross in the box: neither satisfies S1 with the other's centres."""
        crossing = [forge.surface([[(x, y, 0) for y in (-2, 2)] for x in (-2, 2)]), forge.surface([[(0, y, z) for z in (-2, 2)] for y in (-2, 2)])]
        h = Q(1, 2)
        box = Box2(0, units(-1, -1, -1), units(1, 1, 1), [[units(h, h, -h), units(h, h, h)], [units(-h, h, h), units(h, h, h)]],
                   [(1, 0, [1, 0, 0, 0])], [[1], [1]])
        self.one_box("B1", crossing, box)
        self.one_box("", crossing, box, (read2, "combinations", lambda *_: ()))


class Leaves(OnAPlate):
    def test_rows_of_a_frame_exchanged(self):
        a, b, c = self.plate.plan.frames[0]
        plan = self.plan(frames=[(c, b, a)])
        self.assertIn(self.says_any(plan), ("B1", "C1"))
        for box in plan.boxes:
            box.lo, box.hi = box.lo[::-1], box.hi[::-1]
        self.says("ACCEPT", self.plate, plan)

    def says_any(self, plan):
        return vc._check(self.plate.model, plan.certificate(self.plate.model), frozenset())[1].split(":")[0].replace("REJECT ", "")

    def test_rows_of_a_frame_exchanged_in_a_mesh_box(self):
        a, b, c = self.plate.plan.frames[0]
        plan = self.plan(frames=[(a, b, c), (c, b, a)])
        plan.boxes[self.mesh].frame = 2
        self.alone("C1", self.plate, plan)

    def test_a_leaf_that_lies_in_its_box_only_after_rounding(self):
        """The corners of the plate have thirds; the unit is rounded down and up."""
        entities, to, boxes = models2.plate(Q(1, 64), True)
        third = [copy.deepcopy(e) for e in entities]
        for e in third:
            e["shape"]["points"] = [[str(Q(c) / 27) for c in p] for p in e["shape"]["points"]]
        for box in boxes:
            for pair in box.centres:
                pair[:] = [[x // 27 for x in c] for c in pair]
            box.lo, box.hi = [x // 27 for x in box.lo], [-(-x // 27) for x in box.hi]
        walls = boxes[1]
        row = to.frames[0][2]
        walls.separators, walls.signs = [], [[], []]
        walls.separate({(1, 0, 0): row[0], (0, 1, 0): row[1], (0, 0, 1): row[2], (0, 0, 0): -Q(9 * UNIT, 27 * 128)}, 0, 1, 2)
        prover = Prover2(third, boxes, to.frames, roots=2, deepest=0).prove()
        self.says("ACCEPT", prover)
        mesh = next(box for box in prover.plan.boxes if box.kind)
        mesh.lo, mesh.hi = [0, 0, 0], [UNIT // 3, UNIT // 3, UNIT // 3 // 64]       # the plate is 1 / 3 x 1 / 3 x 1 / 192 there
        self.alone("C1", prover)
        mesh.hi = [x + 1 for x in mesh.hi]
        self.says("ACCEPT", prover)

    def test_a_box_that_no_leaf_names(self):
        plan = self.plan()
        plan.boxes.append(copy.deepcopy(plan.boxes[self.walls]))
        self.alone("C1", self.plate, plan)

    def test_a_box_of_one_sheet_or_a_mesh_box_with_leaves_of_two_components(self):
        entities = models2.cuboid((0, 0, 0), (1, 1, 1)) + models2.cuboid((2, 0, 0), (3, 1, 1))
        to = models2.Setting(False)
        boxes = [to.box(0, (x + Q(1, 8), Q(1, 8), Q(3, 4)), (x + Q(7, 8), Q(7, 8), Q(5, 4)),
                        ((x + Q(1, 2), Q(1, 2), Q(7, 8)), (x + Q(1, 2), Q(1, 2), Q(9, 8)))) for x in (0, 2)]
        prover = Prover2(entities, [*boxes, to.box(1, (-1,) * 3, (4,) * 3)], roots=2, deepest=0).prove()
        self.assertEqual(len(prover.plan.boxes), 3)
        self.alone("C1", prover)
        # one star box for both, whose disk is the first cube's face and the second cube's beside it: S2 counts the line only
        wide = to.box(0, (Q(1, 8), Q(1, 8), Q(3, 4)), (Q(23, 8), Q(7, 8), Q(5, 4)), ((Q(1, 2), Q(1, 2), Q(7, 8)), (Q(1, 2), Q(1, 2), Q(9, 8))))
        plan = copy.deepcopy(prover.plan)
        plan.boxes[next(i for i, box in enumerate(plan.boxes) if box.kind == 0)] = wide
        self.says("C1", prover, plan)

if __name__ == "__main__":
    unittest.main()
