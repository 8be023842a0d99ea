#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates of version 2: thin solids, smooth sections and flat patches that are accepted, and lies of
which each is rejected by its condition and accepted when only that condition is left out. What a second judge cannot leave out
(a part of a condition) is replaced by unittest.mock; only the first judge is asked then."""
import contextlib
import copy
import random
import unittest
from fractions import Fraction as Q
from unittest import mock

import star_box_2_forge as forge2
import star_box_2_models as models2
import star_box_forge as forge
import star_box_models as models
import star_box_test as star

from veritope_checker.patches import star_box_2_check as check, star_box_2_flat as flat, star_box_2_read as read2
from veritope_checker.patches import star_box_2_sheets as sheets, star_box_work as work

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


class SoundModels(Judged):
    def test_plates_along_the_axes_and_turned_take_three_boxes_at_every_gap(self):
        for turned in (False, True):
            for gap in (Q(1, 16), Q(1, 1 << 18)):
                prover = models2.proved_plate(gap, turned)
                self.says("ACCEPT", prover)
                walls = next(box for box in prover.plan.boxes if len(box.centres) == 2)
                self.assertEqual((len(prover.plan.boxes), walls.frame), (3, int(turned)))
                self.assertGreater(min(h - l for l, h in zip(walls.lo, walls.hi)), UNIT // 2)

    # PROVES STAR-4
    def test_concentric_spheres_take_the_same_boxes_at_every_gap(self):
        counts = set()
        for gap in (Q(1, 1 << 12), Q(1, 1 << 20)):
            prover = models2.proved_shell(gap)
            self.says("ACCEPT", prover)
            self.assertEqual((prover.plan.values["shells"], prover.plan.values["vertices"]), (2, 12))
            counts.add(len(prover.plan.boxes))
        self.assertEqual(len(counts), 1)

    # PROVES STAR-5
    def test_a_smooth_section_of_four_sides_has_normals_zero_in_its_corners(self):
        prover = Prover2(models2.prism(models2.squircle), search=True).prove()
        self.says("ACCEPT", prover)
        corner = prover.patches[0].corner_of(prover.patches[0].make_g()[3])
        self.assertEqual(corner, [0] * 4)
        self.assertRaisesRegex(ValueError, "no box", forge.Prover(models2.prism(models2.squircle), deepest=3).prove)

    def test_a_smooth_section_of_three_sides_has_triangles_with_normals_zero_in_their_corners(self):
        prover = Prover2(models2.rounded_prism(), search=True).prove()
        self.says("ACCEPT", prover)
        self.assertEqual(prover.patches[0].corner_of(prover.patches[0].make_g()[3]), [0] * 3)
        with replaced((sheets, "sides_at", lambda patch, at: [])):
            self.assertIn("no box", self.why_not(models2.rounded_prism()))

    def why_not(self, entities):
        try:
            Prover2(entities, search=True, deepest=3).prove()
        except ValueError as e:
            return str(e)
        return ""

    def test_blocks_whose_normals_at_a_vertex_lie_in_no_half_space(self):
        prover = models2.star_and_mesh(models2.blocks()).prove()
        self.says("ACCEPT", prover)
        self.assertEqual([box.kind for box in prover.plan.boxes], [1, 0])

    def test_certificates_of_version_1_in_the_form_of_version_2(self):
        for entities in (models.cube(), models.tetrahedron(), models.bicubic_ball(), models.octant_sphere(), models.snake()):
            prover = forge.Prover(entities).prove()
            plan = forge2.to_version_2(prover.plan)
            self.says("ACCEPT", prover, plan)
            self.assertEqual(forge2.read_plan(prover.model, prover.certificate()).body(), plan.body())
            for claim, magic in (("star-box-1", b"VTS2"), ("star-box-2", b"VTSB")):
                lie = copy.copy(plan if magic == b"VTS2" else prover.plan)
                self.says("B1", prover, lie, claim=claim)

    def test_bodies_are_read_as_they_are_written(self):
        for prover in (models2.proved_plate(Q(1, 64), True), models2.proved_shell(Q(1, 1 << 12))):
            read = forge2.read_plan(prover.model, prover.certificate())
            self.assertEqual(read.body(), prover.plan.body())

    def test_turned_claims(self):
        turned = star.AnySign([models.reversed_surface(e) for e in models.cube()]).prove()
        plan = forge2.to_version_2(turned.plan)
        plan.values.update(bodies=0)
        self.says("W2", turned, plan)
        plan.values.update(winding=0)
        self.says("ACCEPT", turned, plan, claim="star-box-turned-2")
        self.says("S1", turned, plan, claim="star-box-2")
        plan.values.update(winding=2)
        self.says("W3", turned, plan, claim="star-box-turned-2")

    def test_a_flag_does_not_matter_to_a_flat_patch(self):
        entities = models2.blocks()
        entities = [models.reversed_surface(e) if i % 2 else e for i, e in enumerate(entities)]
        self.says("ACCEPT", models2.star_and_mesh(entities, flags=[i % 2 for i in range(len(entities))]).prove())


class Lies(Judged):
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

    # ---- B1, B2

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
                     self.changed(self.walls, centres=walls.centres * 33, signs=[[1]] * 66), self.plan(frames=[frame] * 65536),
                     self.changed(self.walls, separators=walls.separators * 65, signs=[[1] * 65, [2] * 65])):
            self.says("B1", self.plate, plan)
        self.says("ACCEPT", self.plate, self.changed(self.walls, separators=walls.separators * 64, signs=[[1] * 64, [2] * 64]))
        self.says("ACCEPT", self.plate, self.plan(frames=[frame] * 65535))
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

    # ---- C1

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

    # ---- C2, C3

    def test_sheets_merged(self):
        for sheet in (0, 1):
            plan = self.plan()
            box = plan.boxes[self.walls]
            box.centres, box.separators, box.signs = [box.centres[sheet]], [], [[]]
            self.alone("C2", self.plate, plan, skip={"C2", "C3"})

    def test_a_sheet_split(self):
        """Each half of the upper wall as a sheet of its own."""
        plan = self.plan()
        box = plan.boxes[self.walls]
        box.centres = [box.centres[0], box.centres[0], box.centres[1]]
        box.signs = [[1], [1], [2]]
        row, middle = plan.frames[0][0], Q(9 * UNIT, 2)
        box.separate({(1, 0, 0): row[0], (0, 1, 0): row[1], (0, 0, 1): row[2], (0, 0, 0): -middle}, 0, 1, 2, 0)
        self.alone("C2", self.plate, plan, skip={"C2", "C3"})

    def test_a_separator_of_the_wrong_sign(self):
        plan = self.changed(self.walls, signs=[[2], [1]])
        self.alone("C2", self.plate, plan, (sheets, "sign_on", lambda *a, f=sheets.sign_on: -f(*a)))

    # PROVES STAR-4.S3
    def test_a_separator_that_is_zero_at_a_point_of_a_sheet(self):
        def zero_counts_as(sign):
            return lambda node, separator, f=sheets.sign_on: f(node, separator._replace(
                terms=[(n + sign * (p == (0, 0, 0)), p) for n, p in separator.terms]))

        to = models2.Setting(True)
        for height, sign in ((0, -1), (Q(1, 64), 1)):     # the lower wall, the upper wall
            plan = self.plan()
            box = plan.boxes[self.walls]
            box.separators, box.signs = [], [[], []]
            box.separate(to.plane(height), 0, 1, 2)
            self.alone("C2", self.plate, plan, (sheets, "sign_on", zero_counts_as(sign)))
        for height in (Q(1, UNIT), Q(1, 64) - Q(1, UNIT)):
            box.separators, box.signs = [], [[], []]
            box.separate(to.plane(height), 0, 1, 2)
            self.says("ACCEPT", self.plate, plan)

    def test_a_separator_in_other_units(self):
        _, t, c = self.plate.plan.boxes[self.walls].separators[0]
        for by in range(1, 65 - t, 8):
            for separator in ([1, t + by, [c[0]] + [x << by for x in c[1:]]], [1, t - by, [c[0] << by, *c[1:]]]):
                if max(map(abs, separator[2])) < 1 << 62:
                    self.says("ACCEPT", self.plate, self.changed(self.walls, separators=[separator]))

    def test_a_separator_that_is_too_long_for_a_patch(self):
        """A plate of which one wall has degree 15 and long numbers: a separator in units that are greater and greater."""
        entities, _, boxes = models2.plate(Q(1, 64))
        top = next(i for i, e in enumerate(entities) if {Q(p[2]) for p in e["shape"]["points"]} == {Q(1, 64)})
        entities[top] = models2.raised(entities[top], 15, Q(1, 1 << 449))
        prover = Prover2(entities, boxes, roots=2, deepest=0).prove()
        patch, walls = prover.patches[top], next(i for i, box in enumerate(prover.plan.boxes) if len(box.centres) == 2)
        (_, t, c), r = prover.plan.boxes[walls].separators[0], prover.plan.boxes[walls].exponent()
        longest = (1 << 20) // patch.num_g - patch.bits - 2 * r
        self.assertTrue(t < longest < 64 and r > 0, (t, longest, r))
        for to, expected in ((longest, "ACCEPT"), (longest + 1, "C2")):
            plan = copy.deepcopy(prover.plan)
            plan.boxes[walls].separators = [[1, to, [c[0]] + [x << to - t for x in c[1:]]]]
            self.says(expected, prover, plan)
        self.alone("C2", prover, plan, (sheets, "MAX_SIZE", 1 << 21))

    def test_units_of_work_for_a_node(self):
        """Each number by hand from the table of star-box.md, section 6, and the end of section 6 of star-box-2.md."""
        box = Box2(0, units(-1, -1, -1), units(1, 1, 1), [[units(0, 0, -Q(1, 2)), units(0, 0, Q(1, 2))]] * 2 + [[units(0, 0, Q(1, 2)), units(0, 0, -Q(1, 2))]],
                   [(3, 64, [1] + [0] * 19), (1, 0, [-1] + [0] * 3)], [[2, 1], [2, 2], [1, 0]])
        square = forge.surface([[(x, y, 0) for y in (0, 1)] for x in (0, 1)])
        for degree, level, bits, s1, first, second in ((1, 0, 21, 1, 1 + (3 * 4 * 9 * 7 ** 2 >> 9), 1),
                                                       (15, 0, 24, 1 + (2025 * 24 >> 12), 1 + (3 * 256 * 961 * 7 ** 2 >> 9), 1 + (256 * 2 ** 2 >> 9)),
                                                       (15, 2, 84, 1 + (2025 * 84 >> 12), 1 + (3 * 256 * 961 * 10 ** 2 >> 9), 1 + (256 * 3 ** 2 >> 9))):
            prover = Prover2([models2.raised(square, degree)], checked=False)
            read, node, spent = prover.probe(box), prover.forest.roots[0], []
            for _ in range(level):
                node = node.children()[0]
            self.assertEqual((work.bits_at(node.patch, level), [s.length for s in read.separators]), (bits, [19 + 19 + 64, 19 + 19]))
            self.assertEqual(sheets.sheet_of(node, read, spent.append), None)
            self.assertEqual(spent, [s1, first, s1, s1])          # S1 fails for the last sheet: its signs are not looked at
            read.sheets[1] = read.sheets[1]._replace(signs=[1, -1])
            del spent[:]
            self.assertEqual(sheets.sheet_of(node, read, spent.append), 1)
            self.assertEqual(spent, [s1, first, s1, second])

    def test_units_of_work_for_hulls_g_and_pairs(self):
        square = forge.surface([[(x, y, 0) for y in (0, 1)] for x in (0, 1)])
        for degree, hull, g, products in ((1, 1, 1, 1 + (4 * 9 * 4 >> 6)), (15, 1 + (256 * 30 * 54 >> 12), 1 + (2025 * 30 * 54 >> 13), 1 + (256 * 961 * 4 >> 6))):
            node = Prover2([models2.raised(square, degree)], checked=False).forest.roots[0].children()[3]
            self.assertEqual((work.of_hull(node), work.of_g(node), work.of_products(node.patch), work.of_pair(node.patch, node.patch)),
                             (hull, g, products, 4))
            node.patch.bits = 200
            self.assertEqual(work.of_pair(node.patch, node.patch), 4 + 9)
            node.patch.roots = [3, 5]
            self.assertEqual(work.bits_at(node.patch, 1), 200 + 2 * degree * 6)

    def test_the_bound_of_the_work(self):
        """Exactly the work that the certificate takes is enough."""
        plan, spent = self.plate.plan, []
        with replaced((check.Checker2, "check_values", lambda checker: spent.append(checker.forest.work) or {})):
            self.says("ACCEPT", self.plate, plan, skip={"replaced"})
        taken = work.allowed(len(self.plate.model) + len(plan.body())) - spent[0]
        self.assertTrue(0 < taken < 20 * len(plan.body()), taken)
        for most, expected in ((taken, "ACCEPT"), (taken - 1, "W1"), (0, "C1")):
            with replaced((work, "allowed", lambda _, most=most: most)):
                self.says(expected, self.plate, plan, skip={"replaced"})

    def test_separators_of_other_pairs(self):
        """Two plates, four walls in one box."""
        prover, to = self.two_plates()
        self.says("ACCEPT", prover)
        box = next(box for box in prover.plan.boxes if len(box.centres) == 4)
        box.separators[0], box.separators[1] = box.separators[1], box.separators[0]
        self.alone("C2", prover, skip={"C2", "C3"})

    def two_plates(self):
        to, g = models2.Setting(True), Q(1, 64)
        entities = models2.cuboid((0, 0, 0), (1, 1, g), to.point) + models2.cuboid((0, 0, 2 * g), (1, 1, 3 * g), to.point)
        lo, hi = (Q(3, 16), Q(3, 16), -Q(1, 4)), (Q(13, 16), Q(13, 16), Q(1, 2))
        below, above = (Q(1, 2), Q(1, 2), -Q(1, 8)), (Q(1, 2), Q(1, 2), Q(1, 4))
        walls = to.box(0, lo, hi, (above, below), (below, above), (above, below), (below, above))
        walls.separate(to.plane(g / 2), 0, 2, 1, 0, 0).separate(to.plane(3 * g / 2), 0, 2, 2, 1, 1).separate(to.plane(5 * g / 2), 0, 0, 0, 2, 1)
        boxes, h = [], Q(3, 8)
        for n, (top, bottom, c) in enumerate(((g * 3 / 2, g / 2, (h, h, g)), (Q(1, 2), g * 5 / 2, (h, h, 3 * g)))):
            one = to.box(0, (Q(3, 16), Q(3, 16), bottom), (Q(9, 16), Q(9, 16), top),
                         ((*c[:2], c[2] - g / 4), (*c[:2], c[2] + g / 4)))
            one.owner = n
            boxes.append(one)
        for n, z in enumerate((0, 2 * g)):
            mesh = to.box(1, (-Q(1, 8), -Q(1, 8), z - g / 4), (Q(9, 8), Q(9, 8), z + g * 5 / 4))
            mesh.owner = n
            boxes.append(mesh)
        prover = Prover2(entities, [*boxes[:2], walls, *boxes[2:]], to.frames, roots=2, deepest=0)
        for patch in prover.patches:
            prover.plan.trees.append([prover.tree(node) for node in forge.star_nodes.root_nodes(patch)])
        ones = [next(i for i, box in enumerate(prover.plan.boxes) if box is one) for one in boxes[:2]]
        # the gap between the plates is open: from c+ along the frame's first axis, then out
        out = units(*to.point((3, h, g + g / 4)))
        prover.plan.walks = [(ones[0], 1, [out], 0), (ones[1], 1, [], 0)]
        prover.plan.values["bodies"] = 2
        return prover, to

    def test_centres_exchanged_between_sheets(self):
        centres = self.plate.plan.boxes[self.walls].centres
        plan = self.changed(self.walls, centres=centres[::-1])
        box = plan.boxes[self.walls]
        box.separators, box.signs = [], [[], []]
        box.separate(models2.Setting(True).plane(Q(1, 128)), 0, 1, 2)
        self.alone("C2", self.plate, plan, skip={"C2", "C3"})
        box.signs = [[2], [1]]                            # the sheets in another order
        self.says("ACCEPT", self.plate, plan)

    # PROVES STAR-4.S1
    def test_a_node_that_satisfies_s1_only_with_another_sheets_centres(self):
        """A Z-fold: its first and third face cross in the box, the middle one satisfies S1 with exchanged centres, which a sheet below
        has by right."""
        profile = [(-2, 0), (Q(1, 2), Q(1, 10)), (-Q(1, 2), Q(1, 5)), (2, -Q(1, 10))]
        fold = [forge.surface([[(x, y, z) for y in (-2, 2)] for x, z in pair]) for pair in zip(profile, profile[1:])]
        lower = forge.surface([[(x, y, -Q(3, 4)) for x in (-2, 2)] for y in (-2, 2)])
        up, down = units(0, 0, -Q(13, 16)), units(0, 0, Q(13, 16))
        box = Box2(0, [int(-UNIT)] * 3, [UNIT] * 3, [[up, down], [down, up]], signs=[[], []])
        box.separate({(0, 0, 1): 1, (0, 0, 0): Q(UNIT, 2)}, 0, 1, 2)
        self.one_box("C2", fold + [lower], box)
        original, pairs = sheets.has_s1, [tuple(map(tuple, pair)) for pair in box.centres]
        self.one_box("", fold + [lower], box, (sheets, "has_s1", lambda node, c: any(original(node, pair) for pair in pairs)))

    # PROVES STAR-4.S2
    def test_a_sheet_that_its_line_does_not_cross(self):
        """Both sheets get nodes of one wall: the box's other wall is a rim's, too far away."""
        box = Box2(0, units(-1, -1, -1), units(1, 1, 1), [[units(0, 0, -Q(1, 2)), units(0, 0, Q(1, 2))], [units(0, 0, Q(1, 2)), units(0, 0, -Q(1, 2))]],
                   signs=[[], []]).separate({(0, 0, 1): 1, (0, 0, 0): UNIT // 4}, 0, 1, 2)
        plane = forge.surface([[(x, y, 0) for y in (-2, 2)] for x in (-2, 2)])
        self.one_box("C3", [plane], box)
        low = forge.surface([[(x, y, -Q(1, 3)) for x in (-2, 2)] for y in (-2, 2)])
        self.one_box("", [plane, low], box)

    # PROVES STAR-3
    def test_a_mirrored_frame_does_not_turn_an_inside_out_solid(self):
        turned = star.AnySign([models.reversed_surface(e) for e in models.cube()]).prove()
        plan = forge2.to_version_2(turned.plan)
        plan.frames = [((1, 0, 0), (0, 1, 0), (0, 0, -1))]
        for box in plan.boxes:
            box.frame, box.lo[2], box.hi[2] = 1, -box.hi[2], -box.lo[2]
        plan.values.update(bodies=0)
        self.says("W2", turned, plan)
        for box in plan.boxes:                            # S1 of the mapped pieces
            box.centres = [pair[::-1] for pair in box.centres]
        plan.walks = [(box, 1 - sign, points, end) for box, sign, points, end in plan.walks]
        plan.values.update(bodies=1)
        signs, crossing = sheets.has_signs, check.Crossing
        mirrored = type("Mirrored", (), {"__init__": lambda s, *a: setattr(s, "by", crossing(*a)), "number": lambda s: -s.by.number()})
        self.alone("C2", turned, plan, (sheets, "has_signs", lambda node, c, sign: signs(node, c, -sign)), (check, "Crossing", mirrored))

    # ---- W1

    def test_a_walk_that_starts_at_a_box_with_two_sheets(self):
        plan = self.plan(walks=[(self.walls, 1, [], 0)])
        self.alone("W1", self.plate, plan, (check.Checker2, "may_walk", lambda *_: True))

    def test_a_walk_that_ends_at_a_box_with_two_sheets(self):
        """A FALSE VALID of the referee: c- of the outer sheet lies in the cavity, beyond the other sheet."""
        prover = models2.nested_cubes()
        for patch in prover.patches:
            prover.plan.trees.append([prover.tree(node) for node in forge.star_nodes.root_nodes(patch)])
        boxes = prover.plan.boxes
        two = next(i for i, box in enumerate(boxes) if len(box.centres) == 2)
        ones = [next(i for i in own if len(boxes[i].centres) == 1) for own in prover.components]
        prover.plan.walks = [(ones[0], 1, [], 4), (ones[1], 0, [], (ones[0], 0)), (ones[2], 0, [], (two, 0))]
        prover.plan.values["bodies"] = 1
        self.alone("W1", prover, None, (check.Checker2, "may_walk", lambda *_: True))

    # ---- hostile bytes

    def test_bytes_of_the_body(self):
        rng, codes, body = random.Random(91), [0] * 5, self.plate.plan.body()
        for trial in range(300 * SCALE):
            lie = forge.bent(rng, body)
            plan = copy.copy(self.plate.plan)
            plan.body = lambda lie=lie: lie
            code, line = vc._check(self.plate.model, plan.certificate(self.plate.model), frozenset())
            self.assertIn(code, (0, 1), (trial, lie.hex(), line))
            codes[code] += 1
        self.assertGreater(codes[1], 200)


class ZeroNormals(Judged):
    """S1 with coefficients that are zero: where they may be, and where not."""

    # PROVES STAR-5.FACES
    def test_an_inner_side_whose_normals_are_zero(self):
        """The line u = 1/2 is mapped to one point: two sheets hang together there."""
        bow = forge.surface([[(-1, 0, 0), (-1, 1, 0)], [(0, 0, 0), (0, -1, 0)], [(1, 0, 0), (1, 1, 0)]])
        box = Box2(0, units(-Q(3, 4), -Q(1, 4), -1), units(Q(3, 4), Q(1, 2), 1),
                   [[units(Q(1, 2), Q(1, 8), -Q(1, 2)), units(Q(1, 2), Q(1, 8), Q(1, 2))]])
        self.one_box("C2", [bow], box, roots=1)
        self.one_box("", [bow], box, (sheets, "is_inner_side", lambda *_: False), roots=1)

    def test_an_inner_corner_whose_normal_is_zero(self):
        # r^2 (x, y) in degree three: x^3, x^2, x, 1 over [-1, 1] in Bernstein form
        cube, square, line, one = (-1, 1, -1, 1), (1, -Q(1, 3), -Q(1, 3), 1), (-1, -Q(1, 3), Q(1, 3), 1), (1, 1, 1, 1)
        rows = [[(cube[i] * one[j] + line[i] * square[j], one[i] * cube[j] + square[i] * line[j], 0) for j in range(4)] for i in range(4)]
        box = Box2(0, units(-1, -1, -1), units(1, 1, 1), [[units(Q(1, 4), Q(1, 8), -Q(1, 2)), units(Q(1, 4), Q(1, 8), Q(1, 2))]])
        self.one_box("C2", [forge.surface(rows)], box)
        self.one_box("", [forge.surface(rows)], box, (sheets, "is_inner_corner", lambda *_: False))

    def root(self, entity, edges=True):
        prover = Prover2([entity], checked=False)
        patch = prover.patches[0]
        if edges:
            patch.sides = [side or (n, True) for n, side in enumerate(patch.sides)]
        return next(forge.star_nodes.root_nodes(patch))

    # PROVES STAR-5.RADIAL
    def test_a_side_on_a_line_through_c(self):
        """g = v^2 for every c of the line that the side v = 0 lies on."""
        root = self.root(forge.surface([[(0, 0, z), (Q(1, 2), 0, z), (1, -1, z)] for z in (0, 1)]))
        plus = units(3, 3, Q(1, 2))
        for height, x, expected in ((-1, 0, False), (Q(1, 2), 0, False), (-1, -Q(1, 8), True)):
            minus = units(x, 0, height)
            with self.subTest(x=x, height=height):
                self.assertEqual(sheets.has_s1(root, (minus, plus)), expected)
                with replaced((sheets, "touches_radial_side", lambda *_: False)):
                    self.assertTrue(sheets.has_s1(root, (minus, plus)))

    def test_a_radial_side_that_only_a_corner_of_the_node_touches(self):
        root = self.root(forge.triangle([(0, 0, 0), (0, 0, 1), (1, -1, 0), (0, 0, 2), (1, -1, 1), (2, -4, 0)], 2))
        for node in [root, *root.children()]:
            lies = any(at[2] == 0 for at in node.at)
            self.assertEqual(sheets.touches_radial_side(node, units(0, 0, -5)), lies, node.at)
            self.assertFalse(sheets.touches_radial_side(node, units(0, Q(1, 1 << 20), -5)))

    def test_two_collapsed_sides_with_a_common_corner(self):
        """S = u v T(u, v): no coefficient of its normal is negative, and many are positive."""
        lune = [[(0, 0, 0)] * 3, [(0, 0, 0), (1, 1, 0), (0, 2, 0)], [(0, 0, 0), (2, 0, 0), (2, 2, 0)]]
        root = self.root(forge.surface(lune), False)
        c = units(0, 0, -9), units(0, 0, 9)
        self.assertFalse(sheets.has_s1(root, c))
        with replaced((sheets, "are_apart", lambda *_: True)):
            self.assertTrue(sheets.has_s1(root, c))

    def test_both_centres_count_and_neither_lies_in_the_plane(self):
        root = self.root(forge.triangle([(0, 0, 0), (1, 0, 0), (0, 1, 0)]))
        for minus, plus in ((-1, 1), (0, 1), (-1, 0), (1, -1), (-2, -1), (1, 2), (0, 0)):
            self.assertEqual(sheets.has_s1(root, (units(0, 0, minus), units(0, 0, plus))), minus < 0 < plus, (minus, plus))

    def test_a_node_that_may_have_zeros_at_a_pole(self):
        """The sides beside a collapsed side are looked at, the collapsed one is not: it would lie on every line through its point."""
        prover = Prover2(models.octant_sphere()[:1], checked=False)
        patch, root = prover.patches[0], prover.forest.roots[0]
        pole = [s for s in range(4) if forge.patches.is_collapsed(patch.side(s))]
        self.assertEqual(len(pole), 1)
        patch.sides = [None if s in pole else (s, True) for s in range(4)]
        self.assertFalse(sheets.touches_radial_side(root, (0, 0, 0)))
        patch.sides[pole[0]] = (9, True)
        self.assertTrue(sheets.touches_radial_side(root, (0, 0, 0)))

    def test_a_triangle_that_is_a_point(self):
        root = self.root(forge.triangle([(1, 0, 0)] * 3), False)
        for c in ((units(0, 0, 0), units(2, 0, 0)), (units(2, 0, 0), units(0, 0, 0))):
            with replaced((sheets, "are_apart", lambda *_: True)):
                self.assertFalse(sheets.has_s1(root, c))

    def test_a_patch_with_a_normal_that_is_zero_everywhere(self):
        root = self.root(forge.surface([[(x, 0, 0) for _ in (0, 1)] for x in (0, 1)]))
        self.assertFalse(sheets.has_s1(root, (units(0, 0, -1), units(0, 0, 1))))


class FlatPatches(Judged):
    def test_a_patch_that_bulges(self):
        for lift, good in (((0, Q(1, 8), -Q(1, 4)), True), ((Q(1, UNIT), 0, 0), False), ((-Q(1, 4), 0, 0), False)):
            entities = models2.blocks(lift=lambda rows, lift=lift: models2.biquadratic(rows, lift))
            prover = models2.star_and_mesh(entities, (-Q(1, 2), -Q(1, 2), 1))
            if good:
                self.says("ACCEPT", prover.prove())
                continue
            with replaced((flat, "lies_in_plane", lambda *_: True)):
                prover.prove()
            self.alone("C4", prover, None, (flat, "lies_in_plane", lambda *_: True))

    # PROVES STAR-6
    def test_a_patch_that_folds(self):
        """Its middle control point lies in its plane, far beyond its sides."""
        def lift(rows):
            (a, _), (c, _) = rows
            return models2.biquadratic(rows, [6 * (y - x) for x, y in zip(a, c)])
        prover = models2.star_and_mesh(models2.blocks(lift=lift), (-Q(1, 2), -Q(1, 2), 1))
        with replaced((flat, "is_unfolded", lambda *_: True)):
            prover.prove()
        self.alone("C4", prover, None, (flat, "is_unfolded", lambda *_: True))

    def test_a_corner_on_a_side(self):
        """A prism over a triangle, with four walls: at one corner of the section the angle is straight."""
        section = [(0, 0), (1, 0), (2, 0), (0, 2)]
        caps = [[[(*section[1], z), (*section[0], z)], [(*section[2], z), (*section[3], z)]] for z in (0, 1)]
        walls = [[[(*p, 0), (*p, 1)], [(*q, 0), (*q, 1)]] for p, q in zip(section, section[1:] + section[:1])]
        entities = [forge.surface(rows) for rows in [caps[1], [list(c) for c in zip(*caps[0])], *walls]]
        wall = Box2(0, units(Q(1, 4), -Q(1, 8), Q(1, 8)), units(Q(3, 4), Q(1, 8), Q(7, 8)), [[units(Q(1, 2), Q(1, 16), Q(1, 2)), units(Q(1, 2), -Q(1, 16), Q(1, 2))]])
        prover = Prover2(entities, [wall, Box2(1, units(-4, -4, -4), units(4, 4, 4))], roots=2, deepest=1)
        with replaced((flat, "is_convex", lambda *_: True)):
            prover.prove()
        self.alone("C4", prover, None, (flat, "is_convex", lambda *_: True))

    def test_a_side_that_is_curved(self):
        """A mesh box inside the cap of a prism."""
        mesh = Box2(1, units(-Q(5, 16), -Q(5, 16), Q(7, 8)), units(Q(5, 16), Q(5, 16), Q(9, 8)))

        class Deep(Prover2):
            def star_box(self, node):
                return None if node.patch.index == 0 and node.level < 3 else super().star_box(node)

        prover = Deep(models2.prism(models2.barrel), [mesh], search=True)
        with replaced((flat, "has_straight_sides", lambda *_: True)):
            prover.prove()
        self.assertTrue(any(box.kind for box in prover.plan.boxes))
        self.alone("C4", prover, None, (flat, "has_straight_sides", lambda *_: True))

    def polygon(self, rows):
        return flat.polygon_of(Prover2([forge.surface(rows)], checked=False).patches[0])

    def test_polygons(self):
        square = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]
        to_units = [tuple(units(*p)) for p in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))]
        self.assertEqual(self.polygon(square), to_units)
        self.assertEqual(self.polygon(models2.biquadratic(square)), to_units)
        self.assertIsNotNone(self.polygon([list(c) for c in zip(*square)]))
        for corner in ((Q(1, 2), Q(1, 2), 0), (Q(1, 4), Q(1, 4), 0), (0, 0, 0), (1, 0, 0), (0, -1, 0), (1, 1, 1)):
            self.assertIsNone(self.polygon([square[0], [(1, 0, 0), corner]]), corner)
        collapsed = [[(0, 0, 0), (0, 0, 0)], square[1]]
        self.assertIsNone(self.polygon(collapsed))
        crossed = [[(0, 0, 0), (1, 1, 0)], [(1, 0, 0), (0, 1, 0)]]
        self.assertIsNone(self.polygon(crossed))
        # a side that goes beyond its end and comes back
        beyond = [[(0, 0, 0), (0, Q(1, 2), 0), (0, 1, 0)], [(3, 0, 0), (3, Q(1, 2), 0), (Q(1, 2), 1, 0)], [(1, 0, 0), (1, Q(1, 2), 0), (1, 1, 0)]]
        self.assertIsNone(self.polygon(beyond))

    def test_triangles(self):
        def polygon(points, degree, **options):
            return flat.polygon_of(Prover2([forge.triangle(points, degree, **options)], checked=False).patches[0])
        self.assertEqual(polygon([(0, 0, 1), (1, 0, 1), (0, 1, 1)], 1), [tuple(units(*p)) for p in ((0, 0, 1), (1, 0, 1), (0, 1, 1))])
        self.assertIsNone(polygon([(0, 0, 1), (1, 1, 1), (2, 2, 1)], 1))
        good = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (2, 0, 0), (1, 1, 0), (0, 2, 0)]
        self.assertEqual(len(polygon(good, 2)), 3)
        self.assertIsNone(polygon([(*p, 1) for p in good], 2, rational=True))
        for i, p in ((1, (1, Q(1, 8), 0)), (4, (1, 1, Q(1, 8))), (1, (3, 0, 0)), (4, (4, -2, 0))):
            self.assertIsNone(polygon(good[:i] + [p] + good[i + 1:], 2), (i, p))

    def test_a_mesh_box_in_a_frame_tests_the_mapped_triangles(self):
        """Two squares that cross at x = 2 to 3; the frame multiplies by 8."""
        def crossing(x):
            return [forge.surface([[(a, -1, z), (a, 1, z)] for a, z in ((x, 0), (x + 1, 0))]),
                    forge.surface([[(a, 0, -1), (a, 0, 1)] for a in (x, x + 1)])]
        frame, box = ((8, 0, 0), (0, 8, 0), (0, 0, 8)), Box2(1, units(16, -8, -8), units(24, 8, 8), frame=1)
        for x, expected in ((2, "C4"), (16, "")):
            self.one_box(expected, crossing(x), box, frames=[frame])
            # a triangle in the plane x + y + z = const that misses the box, although its hull meets it
            corner = forge.triangle([(x + 4, 0, 0), (x, 4, 0), (x, 0, 4)])
            self.one_box("", [corner, crossing(x)[0]], box, frames=[frame])

    def test_the_two_triangles_of_a_patch_and_those_of_its_neighbours(self):
        """Contacts count by X, not by position: blocks that touch along an edge, and at a vertex."""
        for cells in (((0, 0, 0), (1, 1, 0)), ((0, 0, 0), (1, 1, 1))):
            entities = [face for cell in cells for face in models2.cuboid(cell, [c + 1 for c in cell])]
            prover = models2.star_and_mesh(entities, (Q(1, 2), Q(1, 2), 1), checked=False)
            mesh = Box2(1, units(-1, -1, -1), units(3, 3, 3))
            self.assertIn("do not meet properly", prover.reason(mesh))
        cube = Prover2(models2.cuboid((0, 0, 0), (1, 1, 1)))
        self.assertEqual(cube.reason(Box2(1, units(-1, -1, -1), units(3, 3, 3))), "")


class Separators(unittest.TestCase):
    def test_signs_are_those_of_the_definition(self):
        """Coefficients by slow products of Bernstein polynomials."""
        rng, seen = random.Random(92), set()
        for trial in range(120 * SCALE):
            is_tensor, rational = trial % 2 == 0, trial % 3 == 0
            p, q = rng.randint(1, 3), rng.randint(1, 2)

            def point():
                return tuple(Q(rng.randint(-8, 8), 4) for _ in range(3)) + ((Q(rng.randint(1, 5)),) if rational else ())
            if is_tensor:
                entity = forge.surface([[point() for _ in range(q + 1)] for _ in range(p + 1)], rational=rational)
            else:
                entity = forge.triangle([point() for _ in range((p + 1) * (p + 2) // 2)], p, rational)
            node = Prover2([entity], checked=False, unit=-2).forest.roots[0]
            node = rng.choice([node, *node.children()])
            degree = rng.randint(1, 3)
            origin, exponent = [rng.randint(-9, 9) for _ in range(3)], rng.randint(-3, 3)
            terms = [(rng.randint(-3, 3) + (rng.randint(-200, 200) if not any(abc) else 0), abc) for abc in forge2.powers(degree)]
            got = sheets.sign_on(node, read2.Separator(degree, origin, exponent, terms, 0))
            self.assertEqual(got, slow_sign(node, degree, origin, exponent, terms), trial)
            seen.add(got)
        self.assertEqual(seen, {-1, 0, 1})


def slow_sign(node, degree, origin, exponent, terms):
    """Multiplies polynomials in Bernstein form as functions {index: coefficient times binomial factors}."""
    x, y, z, w = [scaled(rows, node.patch.is_tensor) for rows in node.net]

    def times(f, g):
        out = {}
        for i, a in f.items():
            for j, b in g.items():
                key = i[0] + j[0], i[1] + j[1]
                out[key] = out.get(key, 0) + a * b
        return out

    axes = [{i: (a[i] - o * w[i]) / Q(2) ** exponent for i in a} for a, o in zip((x, y, z), origin)]
    total = {}
    for n, abc in terms:
        product = {(0, 0): Q(n)}
        for factor, times_ in zip([*axes, w], [*abc, degree - sum(abc)]):
            for _ in range(times_):
                product = times(product, factor)
        for i, a in product.items():
            total[i] = total.get(i, 0) + a
    return (min(total.values()) > 0) - (max(total.values()) < 0)


def scaled(rows, is_tensor):
    comb, m = forge.math.comb, len(rows) - 1
    if is_tensor:
        return {(i, j): Q(c) * comb(m, i) * comb(len(row) - 1, j) for i, row in enumerate(rows) for j, c in enumerate(row)}
    return {(r, k): Q(c) * comb(m, r) * comb(r, k) for r, row in enumerate(rows) for k, c in enumerate(row)}


if __name__ == "__main__":
    unittest.main()
