#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates of version 2: separators, C2, C3 and W1."""
import copy
import random
import unittest
from fractions import Fraction as Q

import star_box_2_forge as forge2
import star_box_2_models as models2
import star_box_forge as forge
import star_box_models as models
import star_box_test as star
from star_box_2_judged import OnAPlate, Box2, Prover2, SCALE, UNIT, units

from veritope_checker.patches import star_box_2_check as check, star_box_2_read as read2, star_box_2_sheets as sheets


class Sheets(OnAPlate):
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


class Walks(OnAPlate):
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
