#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of patch-invalid certificates: models that are invalid, a lie for every condition, attacks on sound models,
hostile bytes. A lie is rejected by its condition and, where the test says `alone`, accepted without it."""
import copy
import json
import os
import random
import sys
import time
import unittest
from fractions import Fraction as Q

import star_box_forge as star_forge                       # noqa: F401  (finds the checker)
import patch_invalid_forge as forge
import patch_invalid_models as broken
import star_box_models as models

from veritope_checker import program as vc

check = forge.check
SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
WHOLE = (0, 0, 1)


class PatchInvalidTest(unittest.TestCase):
    def says(self, expected, finding, skip=(), model=None):
        model = model or star_forge.encode_model(finding.entities)
        code, line = vc._check(model, finding.certificate(model), frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT " + finding.claim, "ACCEPT"), expected, line)
        self.assertEqual(code, {"ACCEPT": 0, "ERROR": 4}.get(expected, 1), line)

    def alone(self, condition, finding):
        self.says(condition, finding)
        self.says("ACCEPT", finding, {condition})

    def changed(self, finding, **fields):
        finding = copy.deepcopy(finding)
        for key, value in fields.items():
            setattr(finding, key, value)
        return finding

    def judged(self, finding, note):
        start = time.process_time()
        model = star_forge.encode_model(finding.entities)
        code, line = vc._check(model, finding.certificate(model), frozenset())
        self.assertIn(code, (0, 1), (note, line))
        self.assertLess(time.process_time() - start, 20, note)
        return code, line

    def mutated(self, finding, seed, rounds, true=False):
        """true: the model is invalid, so that an ACCEPT is no lie."""
        rng, body, accepted = random.Random(seed), finding.body(), 0
        for trial in range(rounds):
            lie = bytearray(body)
            for _ in range(rng.randint(1, 3)):
                at, kind = rng.randrange(len(lie)), rng.randrange(5)
                if kind < 3:
                    lie[at] = rng.choice((lie[at] ^ 1 << rng.randrange(8), 0, 1, 127, 128, 255, rng.randrange(256)))
                elif kind == 3:
                    del lie[at:at + rng.randint(1, 9)]
                else:
                    lie[at:at] = bytes(rng.randrange(256) for _ in range(rng.randint(1, 9)))
            changed = copy.copy(finding)
            changed.body = lambda lie=lie: bytes(lie)
            code, line = self.judged(changed, ("seed", seed, trial, bytes(lie).hex()))
            accepted += code == 0
            if not true:
                self.assertEqual(code, 1, (seed, trial, bytes(lie).hex(), line))
        return accepted


def crossing_cubes():
    return models.cube() + models.cube(1, (1, Q(1, 2), Q(1, 4)))


def crossing_of_cubes(**options):
    return forge.crossing(crossing_cubes(), 0, 9, (0.25, 0.5, 0.625, 0.5), **options)


def crossing_of_triangles(**options):
    return forge.crossing(broken.pierced(), 0, 1, (0.375, 0.444, 0.667, 0.5), **options)


class Crossings(PatchInvalidTest):
    # PROVES INVALID-1
    def test_two_cubes(self):
        for fixed in (1, 2):                              # z; with both left free the matrix is singular
            self.says("ACCEPT", crossing_of_cubes(fixed=fixed))

    def test_two_triangles(self):
        for fixed in (0, 1, 2, 3):
            self.says("ACCEPT", crossing_of_triangles(fixed=fixed, bits=7))

    def test_a_rational_torus_and_a_sheet(self):
        entities = models.torus() + [broken.sheet((Q(5, 2), -1, -1), (0, 3, 0), (0, 0, 3))]
        for bits in (5, 9, 14):
            self.says("ACCEPT", forge.crossing(entities, 0, 16, (0.3, 0.5, 0.7, 0.6), 1, bits))

    def test_a_sheet_and_a_triangle_of_degree_3(self):
        entities = models.cubic_octahedron() + [broken.sheet((Q(1, 4), -2, -2), (Q(1, 9), 4, 0), (0, 0, 4))]
        for patch in range(4, 8):                         # x < 0 and x > 0
            centre = star_forge.read.read_model(star_forge.encode_model([entities[patch]]))[0].rows[0][0]
            start = (0.7, 0.5, 0.5, 0.5) if centre[0] > 0 else None
            if start:
                self.says("ACCEPT", forge.crossing(entities, patch, 8, start, 1, 8))

    def test_a_patch_that_crosses_itself(self):
        for fixed in (1, 3):
            self.says("ACCEPT", forge.crossing([broken.open_loop()], 0, 0, (0.084, 0.5, 0.916, 0.5), fixed, 7))

    def test_patches_between_breaks(self):
        entities = [broken.sheet((0, 0, 0), (3, 0, 0), (0, 2, 0), (3, 2)), broken.sheet((Q(3, 2), Q(1, 2), -1), (Q(1, 9), 1, 0), (0, 0, 4), (2, 2))]
        self.says("ACCEPT", forge.crossing(entities, 2, 6, (0.5, 0.7, 0.3, 0.5), 1))      # (3/2 + .., 3/4, 0) and v in [0, 1] of z

    def test_flags_do_not_matter(self):
        finding = crossing_of_cubes(fixed=1, flags=[1] * 5 + [0] * 7)
        self.says("ACCEPT", finding)
        finding.values["flipped"] = 4
        self.alone("B3", finding)

    def test_b_may_lie_on_a_border(self):
        """An edge of a triangle that passes through the other's inside: its parameter is the fixed one."""
        finding = forge.crossing(broken.pierced(), 0, 1, (0.5, 0.42, 1.0, 0.667), 2, 8)
        self.assertEqual(finding.pair[1][1], (1, 1))
        self.says("ACCEPT", finding)


class Sides(PatchInvalidTest):
    # PROVES INVALID-2
    def test_an_open_cube(self):
        entities = models.cube()[1:]
        borders = [(n, s) for n in range(5) for s in range(4) if forge.passing(entities, n, s)[1:] == (1, 0)]
        self.assertEqual(len(borders), 4)
        for n, s in borders:
            self.says("ACCEPT", forge.side(entities, n, s))

    def test_a_face_that_is_turned(self):
        entities = [models.reversed_surface(models.cube()[0])] + models.cube()[1:]
        finding = forge.side(entities, 0, 2)
        self.assertEqual(finding.values, {"same": 2, "opposite": 0})
        self.says("ACCEPT", finding)
        flagged = forge.side(models.cube(), 0, 2, [1] + [0] * 5)               # the model is sound: it is the flag that is wrong
        self.assertEqual(flagged.values, {"same": 2, "opposite": 0, "flipped": 1})
        self.alone("D2", flagged)
        flags = [1, 1, 0, 0, 1]
        finding = next(f for n in range(5) for s in range(4) for f in [forge.side(models.cube()[1:], n, s, flags)] if not f.arcs[1:])
        self.says("ACCEPT", finding)                      # an open border is one whatever the flags say
        mended = forge.side(entities, 0, 2, [1] + [0] * 5)
        self.assertEqual((mended.values["same"], mended.values["opposite"]), (1, 1))
        self.says("D2", mended)

    def test_three_and_four_sheets_at_an_edge(self):
        for entities, want in ((models.cube() + models.cube(1, (2, 2, 0)), (2, 2)), (models.cube() + [broken.sheet((1, 1, -1), (0, 0, 2), (3, 3, 0))], None)):
            n, s = next((n, s) for n in range(6) for s in range(4) if sum(forge.passing(entities, n, s)[1:]) > 2)
            finding = forge.side(entities, n, s)
            if want:
                self.assertEqual(tuple(finding.values.values()), want)
            self.says("ACCEPT", finding)

    def test_a_cylinder_without_its_ends(self):
        entities = broken.cylinder_wall()
        finding = forge.side(entities, 0, 1 if forge.passing(entities, 0, 1)[1:] == (1, 0) else 2)
        self.assertEqual(finding.values, {"same": 1, "opposite": 0})
        self.says("ACCEPT", finding)
        for n in range(4):
            for s in range(4):
                for t0 in (Q(3, 8), Q(5, 1 << 40), 1 - Q(3, 1 << 40)):
                    finding = forge.side(entities, n, s, t0=t0, part=(40, 1, (1 << 40) - 1))
                    self.says("ACCEPT" if finding.values["opposite"] == 0 else "D2", finding)

    def test_a_torus_without_a_patch(self):
        entities = models.torus()[1:]
        finding = next(f for n in range(15) for s in range(4) for f in [forge.side(entities, n, s)] if f.values["opposite"] == 0)
        self.says("ACCEPT", finding)

    def test_triangles(self):
        for entities in (models.tetrahedron()[1:], models.cubic_octahedron()[1:]):
            finding = next(f for n in range(len(entities)) for s in range(3) for f in [forge.side(entities, n, s)] if not f.values["opposite"])
            self.says("ACCEPT", finding)
            self.assertEqual(finding.values["same"], 1)

    def test_a_part_of_a_side(self):
        """A long side against a short one: closed over its first half, open over the other."""
        long = broken.sheet((0, 0, 0), (2, 0, 0), (0, 1, 0))                   # side 0: v = 0, from x = 0 to 2
        short = broken.sheet((1, 0, 0), (-1, 0, 0), (0, 0, 1))                 # side 0: from x = 1 to 0
        entities = [long, short]
        open_part = forge.sides(entities, [(0, 0, (1, 1, 2))], 1, 0, t0=Q(3, 4))
        self.says("ACCEPT", open_part)
        covered = forge.sides(entities, [(0, 0, (1, 0, 1)), (1, 0, WHOLE)], 1, 1, t0=Q(1, 4))
        self.alone("D2", covered)
        self.alone("D4", forge.sides(entities, [(0, 0, (1, 0, 1))], 1, 0, t0=Q(1, 4)))
        twice = entities + [broken.sheet((1, 0, 0), (-1, 0, 0), (0, 1, 1))]
        self.says("ACCEPT", forge.sides(twice, [(0, 0, (1, 0, 1)), (1, 0, WHOLE), (2, 0, (0, 0, 1))], 1, 2, t0=Q(1, 4)))
        parts = [(0, 0, (2, 1, 2)), (1, 0, (1, 0, 1)), (2, 0, (1, 0, 1))]
        self.says("ACCEPT", forge.sides(twice, parts, 1, 2, t0=Q(3, 8)))

    def test_borders_of_entities_with_inner_knots(self):
        entities = [broken.sheet((0, 0, 0), (3, 0, 0), (0, 2, 0), (3, 2))]
        patches = forge.Parsed(entities).patches
        self.assertEqual(sorted(patches.outer()), [(0, 0), (0, 3), (1, 2), (1, 3), (2, 0), (3, 2), (4, 0), (4, 1), (5, 1), (5, 2)])
        for n, s in patches.outer():
            self.says("ACCEPT", forge.side(entities, n, s))

    def test_a_sphere_without_an_octant(self):
        entities = models.octant_sphere()[1:]
        findings = [forge.side(entities, n, s) for n in range(7) for s in range(4) if not forge.check.is_collapsed(forge.Parsed(entities).patches[n].side(s))]
        found = [f for f in findings if f.values["opposite"] == 0]
        self.assertEqual(len(found), 3)
        for finding in found:
            self.says("ACCEPT", finding)


class Lies(PatchInvalidTest):
    """For every condition a lie that this condition rejects; alone unless the test says why that is impossible."""

    def test_s1(self):
        finding = crossing_of_cubes(fixed=1)
        cert, model = finding.certificate(), star_forge.encode_model(finding.entities)
        for old, new, expected in ((b'"crossing"', b'"cross"', "S1"), (b'"same":0', b'"same":"0"', "S1"), (b'"same":0,', b"", "S1"),
                                   (b'"same":0', b'"same":0,"genus":0', "S1"), (b'"patch-invalid-1"', b'"patch-invalid-2"', "S1"),
                                   (b'"vjson"', b'"json"', "S1"), (b'"subject_bytes":', b'"subject_bytes":1', "S3"), (b"VTPI", b"VTPJ", "S4")):
            self.assertIn(old, cert)
            self.assertTrue(vc.check(model, cert.replace(old, new, 1))[1].startswith("REJECT %s:" % expected), new)

    def test_b1(self):
        good, open_cube = crossing_of_cubes(fixed=1), forge.side(models.cube()[1:], 0, 0)
        a, b = good.pair
        bad = [self.changed(good, tail=b"\0"), self.changed(good, kind=2), self.changed(good, flags=[2] + [0] * 11),
               self.changed(good, entities=good.entities[:11]), self.changed(good, breaks=[[[0, 1], [0, 2]]] + good.breaks[1:]),
               self.changed(good, pair=[(12, *a[1:]), b]), self.changed(good, pair=[(0, (63, 1, 2), a[2]), b]),
               self.changed(good, pair=[(0, (5, 2, 1), a[2]), b]), self.changed(good, pair=[(0, (5, 2, 33), a[2]), b]),
               self.changed(open_cube, arcs=[]), self.changed(open_cube, arcs=[(5, 0, WHOLE)]), self.changed(open_cube, arcs=[(0, 4, WHOLE)]),
               self.changed(open_cube, axis=3), self.changed(open_cube, t0=(63, 1)), self.changed(open_cube, tail=b"x")]
        triangles = forge.side(models.tetrahedron()[1:], 0, 0)
        bad.append(self.changed(triangles, arcs=[(0, 3, WHOLE)]))
        for finding in bad:
            self.says("B1", finding, model=star_forge.encode_model(good.entities if finding.kind == 0 else finding.entities))
        for finding in (good, open_cube, triangles):
            body = finding.body()
            for n in range(len(body)):
                lie = copy.deepcopy(finding)
                lie.body = lambda n=n, body=body: body[:n]
                self.says("B1", lie)

    def test_b2(self):
        flat = star_forge.surface([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
        high = star_forge.surface([[(i, j, 0) for j in range(2)] for i in range(17)])
        curve = {"kind": "curve", "group": None, "attributes": [], "shape": {}}
        long = star_forge.surface([[(0, 0, Q(1, 3 ** 5200)), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
        for entity in (flat, high, curve, long):
            finding = forge.sides([entity] if entity is not curve else [models.cube()[0], entity], [(0, 0, WHOLE)], 1, 0)
            self.says("B2", finding)

    def test_b2_a_surface_that_is_torn_at_a_knot(self):
        """Two unit squares with a gap between them, as one entity: an inner knot of multiplicity 2, degree 1."""
        rows = [[(x, y, 0) for y in (0, 1)] for x in (0, 1, 2, 3)]
        torn = star_forge.surface(rows, (1, 1), [[0, 0, 1, 1, 2, 2], [0, 0, 1, 1]])
        self.alone("B2", forge.side([torn], 0, 0))
        kept = star_forge.surface([rows[0], rows[1], rows[3]], (1, 1), [[0, 0, 1, 2, 2], [0, 0, 1, 1]])
        self.says("ACCEPT", forge.side([kept], 0, 0))

    def test_b3(self):
        for finding in (crossing_of_cubes(fixed=1), forge.side(models.cube()[1:], *self.border(models.cube()[1:]))):
            for key, value in (("patches", 7), ("flipped", 1), ("finding", "side" if finding.kind == 0 else "crossing"), ("patches", (1 << 64) - 1)):
                self.alone("B3", self.changed(finding, values=dict(finding.values, **{key: value})))
        for key in ("same", "opposite"):
            self.alone("B3", self.changed(crossing_of_cubes(fixed=1), values={key: 1}))

    def border(self, entities):
        return next((n, s) for n in range(len(entities)) for s in range(4) if forge.passing(entities, n, s)[1:] == (1, 0))

    # PROVES INVALID-1.X1
    def test_x1_two_points_that_are_fixed(self):
        """Opposite faces of a sound cube: a line along y on x = 1 and one along z on x = -1 cross when seen along x."""
        finding = forge.Finding(models.cube())
        half = (2, 2, 2)
        finding.pair = [(0, WHOLE, half), (1, half, WHOLE)]        # A: y rises with u; B: z rises with v
        finding.y = [[0, 1, 0], [0, 0, -1], [1, 0, 0]]
        self.says("X1", finding)                          # A is not in the open domain either
        finding.pair[0] = (0, (2, 1, 3), half)
        self.alone("X1", finding)

    def test_x1_nothing_fixed(self):
        finding = crossing_of_cubes(fixed=1)
        (a, *at), b = finding.pair
        finding.pair[0] = (a, at[0], (at[1][0] - Q(1, 1 << 20), at[1][1] + Q(1, 1 << 20)))
        self.says("X1", finding)

    def test_x1_on_the_border(self):
        """The edge of one through the other's inside, with the one that has the edge as A."""
        finding = forge.crossing(broken.pierced(), 1, 0, (1.0, 0.667, 0.5, 0.42), 0, 8)
        self.alone("X1", finding)

    # PROVES INVALID-1.X1
    def test_x1_the_corner_of_a_triangle(self):
        """B is the line from the corner (1, 1, -1) along (2, 1, 3); rows 1 and 2 do not see it, row 3 is -z."""
        finding = crossing_of_triangles()
        wide, half = (Q(1, 16), Q(15, 16)), (Q(1, 2), Q(1, 2))
        finding.pair, finding.y = [(0, wide, wide), (1, (Q(0), Q(1)), half)], [[1, 1, -1], [-4, 5, 1], [0, 0, -1]]
        self.alone("X1", finding)
        self.says("ACCEPT", self.changed(finding, pair=[finding.pair[0], (1, wide, half)]))

    def test_x1_one_patch_with_itself(self):
        """Where boxes of one patch have common parameters, A = B on a face of the box, and X3 fails, too: never alone."""
        finding = forge.crossing([broken.open_loop()], 0, 0, (0.084, 0.5, 0.916, 0.5), 1, 7)
        for pair in ([finding.pair[0]] * 2, [finding.pair[0], (0, (Q(0), Q(1)), finding.pair[1][2])]):
            lie = self.changed(finding, pair=pair)
            self.says("X1", lie)
            self.says("X3", lie, {"X1"})
        touching = self.changed(finding, pair=[(0, (Q(1, 64), Q(1, 2)), (Q(1, 2), Q(1, 2))), (0, (Q(1, 2), Q(63, 64)), (Q(1, 4), Q(3, 4)))])
        self.says("X1", touching)
        self.says("X3", touching, {"X1"})

    # PROVES INVALID-1.X2
    def test_x2_is_implied(self):
        """A row that depends on others cannot have its own signs at the corners of the box: X3 implies X2, no lie is left to X2 alone."""
        finding = crossing_of_cubes(fixed=1)
        for row in ([0, 0, 0], finding.y[0], [a + b for a, b in zip(*finding.y[:2])], [a - b for a, b in zip(*finding.y[:2])]):
            lie = self.changed(finding, y=finding.y[:2] + [row])
            self.says("X2", lie)
            self.says("X3", lie, {"X2"})

    # PROVES INVALID-1.X3
    def test_x3(self):
        finding = crossing_of_cubes(fixed=1)
        a, b = finding.pair
        for lie in (self.changed(finding, y=[[-c for c in row] for row in finding.y]), self.changed(finding, y=finding.y[::-1]),
                    self.changed(finding, pair=[a, (b[0] - 1, *b[1:])]), self.changed(finding, pair=[a, (b[0], a[1], b[2])]),
                    self.changed(finding, pair=[b, a])):
            self.alone("X3", lie)

    def test_x3_a_root_on_a_face_of_the_box(self):
        """A = B exactly where a parameter of B is at its lower end: the signs are not strict."""
        finding = crossing_of_cubes(fixed=1)
        a, b = finding.pair
        middle = [Q(5, 8), Q(1, 2)]
        flush = [(middle[0], b[1][1]), b[2]]
        self.alone("X3", self.changed(finding, pair=[(0, (Q(7, 32), Q(9, 32)), (Q(1, 2), Q(1, 2))), (9, *flush)]))

    # PROVES INVALID-2.D1
    def test_d1_an_inner_break_line(self):
        """A sound box has a knot in the middle of its first face: nothing else passes there, so D2 to D4 hold."""
        faces = models.cube()
        p = [tuple(Q(c) for c in q) for q in faces[0]["shape"]["points"]]
        middle = [tuple((a + b) / 2 for a, b in zip(p[j], p[2 + j])) for j in (0, 1)]
        entities = [star_forge.surface([p[:2], middle, p[2:]], (1, 1), [[0, 0, 1, 2, 2], [0, 0, 1, 1]])] + faces[1:]
        inner = next((n, s) for n in (0, 1) for s in range(4) if (n, s) not in set(forge.Parsed(entities).patches.outer()))
        for axis in range(3):
            lie = forge.sides(entities, [(*inner, WHOLE)], 1, 0, axis)
            self.says("D1", lie)
            if vc._check(star_forge.encode_model(entities), lie.certificate(), frozenset({"D1"}))[0] == 0:
                break
        self.alone("D1", lie)

    # PROVES INVALID-2.D1
    def test_d1_a_side_counted_twice(self):
        """A sound cube: one arc in each direction, and the first once more."""
        finding = forge.side(models.cube(), 0, 0, part=WHOLE)
        self.assertEqual(finding.values, {"same": 1, "opposite": 1})
        self.says("D2", finding)
        self.alone("D1", self.changed(finding, arcs=finding.arcs + finding.arcs[:1], values={"same": 2, "opposite": 1}))
        self.alone("D1", self.changed(finding, arcs=finding.arcs + [(0, 0, (4, 0, 16))] * 2, values={"same": 3, "opposite": 1}))

    def test_d1_what_other_conditions_reject_too(self):
        """A collapsed side and an interval that is a point have no slope (D3); a point off the first arc is passed by its own side (D4)."""
        entities = models.octant_sphere()
        patches = forge.Parsed(entities).patches
        pole = next((n, s) for n, s in patches.outer() if check.is_collapsed(patches[n].side(s)))
        self.says("D1", forge.sides(entities, [(*pole, WHOLE)], 1, 0))
        self.says("D3", forge.sides(entities, [(*pole, WHOLE)], 1, 0), {"D1"})
        cube = models.cube()[1:]
        n, s = self.border(cube)
        finding = forge.side(cube, n, s)
        self.says("D1", self.changed(finding, arcs=[(n, s, (1, 1, 1))]))
        self.says("D3", self.changed(finding, arcs=[(n, s, (1, 1, 1))]), {"D1"})
        for at, t0 in (((1, 0, 1), (1, 1)), ((1, 0, 1), (2, 3)), (WHOLE, (0, 1)), (WHOLE, (0, 0))):
            lie = self.changed(finding, arcs=[(n, s, at)], t0=t0)
            self.says("D1", lie)
            if at != WHOLE:
                self.says("D4", lie, {"D1"})
        self.says("D1", self.changed(finding, t0=(0, 1 << 62)))

    # PROVES INVALID-2.D2
    def test_d2(self):
        cube = forge.side(models.cube(), 0, 0, part=WHOLE)
        self.alone("D2", cube)                            # an edge of a closed surface
        partner = cube.arcs[1]
        self.alone("D2", self.changed(cube, arcs=[cube.arcs[0], (*partner[:2], (2, 0, 3))], values={"same": 1, "opposite": 0}))
        finding = forge.side(models.cube()[1:], *self.border(models.cube()[1:]))
        for same, opposite in ((0, 1), (2, 0), (1, 1), (0, 0)):
            self.alone("D2", self.changed(finding, values={"same": same, "opposite": opposite}))

    # PROVES INVALID-2.D3
    def test_d3(self):
        entities = models.cube()[1:]
        finding = forge.side(entities, *self.border(entities))
        for axis in {0, 1, 2} - {finding.axis}:
            self.alone("D3", self.changed(finding, axis=axis))
        # a border that turns back: the same points twice, in the two directions, in a patch that is folded along it
        rows = [[(0, 0, 0), (0, 0, 1)], [(2, 0, 0), (2, 1, 1)], [(0, 0, 0), (0, 0, 2)]]
        fold = star_forge.surface(rows)
        side = next(s for s in range(4) if check.curve_key(forge.Parsed([fold]).patches[0].side(s)) ==
                    check.curve_key(forge.Parsed([fold]).patches[0].side(s)[::-1]))
        self.alone("D3", forge.sides([fold], [(0, side, WHOLE)], 1, 0, 0, Q(1, 4)))
        self.says("D2", forge.sides([fold], [(0, side, (3, 0, 3)), (0, side, (3, 5, 8))], 1, 1, 0, Q(1, 4)))
        self.says("D4", forge.sides([fold], [(0, side, (3, 0, 3))], 1, 0, 0, Q(1, 4)))

    def test_d3_is_about_the_quotient(self):
        """X rises, X / w turns back; X turns back, X / w rises."""
        for curve, expected in ((((0, 0, 0, 1), (1, 0, 0, 1), (2, 0, 0, 8)), "D3"), (((0, 0, 0, 1), (2, 0, 0, 1), (1, 0, 0, Q(1, 4))), "ACCEPT")):
            entity = star_forge.surface([[p, (*p[:2], p[3], p[3])] for p in curve], rational=True)
            side = next(s for s in range(4) if sum(p[2] for p in forge.Parsed([entity]).patches[0].side(s)) == 0)
            finding = forge.sides([entity], [(0, side, WHOLE)], 1, 0, 0, Q(1, 4))
            self.says(expected, finding)
            self.says("ACCEPT", finding, {"D3"})

    # PROVES INVALID-2.D4
    def test_d4(self):
        """An edge of a sound model, told as a border."""
        for entities in (models.cube(), models.torus(), models.tetrahedron(), models.octant_sphere(), models.cubic_octahedron()):
            finding = forge.side(entities, 0, 2)
            finding.arcs, finding.values = finding.arcs[:1], {"same": 1, "opposite": 0}
            self.alone("D4", finding)

    def test_d4_every_outer_side_of_every_patch(self):
        """A box whose faces have inner knots: 72 outer sides, each told as a border, without its mate, of whatever patch of its face."""
        faces = []
        for at in models.cube_faces():
            rows = [[at(Q(2 * i, 3) - 1, Q(2 * j, 3) - 1) for j in range(4)] for i in range(4)]
            faces.append(star_forge.surface(rows, (1, 1), [[0, 0, 1, 2, 3, 3]] * 2))
        outer = list(forge.Parsed(faces).patches.outer())
        self.assertEqual(len(outer), 72)
        for n, s in outer:
            finding = forge.side(faces, n, s, part=WHOLE)
            self.assertEqual(finding.values, {"same": 1, "opposite": 1})
            self.alone("D4", self.changed(finding, arcs=finding.arcs[:1], values={"same": 1, "opposite": 0}))

    def test_d4_another_parametrization(self):
        """A cylinder's circle whose lid has it with another speed: closed as a set of points, so it is no open border."""
        wall = broken.cylinder_wall()
        n, s = 0, next(s for s in range(4) if forge.passing(wall, 0, s)[1:] == (1, 0))
        curve = forge.Parsed(wall).patches[0].side(s)
        fast = [tuple(c * f for c in p) for p, f in zip(curve[::-1], (1, 2, 4))]
        lid = star_forge.surface([[p, (0, 0, p[2] * p[3], p[3])] for p in fast], rational=True)
        finding = forge.side(wall + [lid], n, s)
        self.assertEqual(finding.values, {"same": 1, "opposite": 0})
        self.alone("D4", finding)


class SoundModels(PatchInvalidTest):
    """No witness that could be thought of makes a sound model invalid."""

    SOUND = (models.cube, models.torus, models.octant_sphere, models.tetrahedron, models.cubic_octahedron)

    def test_crossings_at_edges_vertices_and_poles(self):
        rng = random.Random(51)
        for build in self.SOUND:
            entities = build()
            for trial in range(60 * SCALE):
                a, b = rng.choice([(rng.randrange(len(entities)), rng.randrange(len(entities)))] * 3 + [(0, 0), (0, 1)])
                finding = forge.Finding(entities)
                places = [rng.choice((Q(0), Q(1), Q(1, 2), Q(1, 1 << 20), 1 - Q(1, 1 << 20))) for _ in range(4)]
                fixed, h = rng.randrange(4), Q(1, 1 << rng.choice((1, 5, 21, 40)))
                at = [(p, p) if i == fixed else (max(p - h, 0), min(p + h, 1)) for i, p in enumerate(places)]
                finding.pair = [(a, *at[:2]), (b, *at[2:])]
                finding.y = [[rng.randint(-9, 9) for _ in range(3)] for _ in range(3)]
                try:
                    finding.y = self.newton_rows(entities, a, b, [float(p) for p in places], fixed)
                except (ZeroDivisionError, OverflowError):
                    pass
                code, line = vc._check(star_forge.encode_model(entities), finding.certificate(), frozenset())
                self.assertEqual((code, line[:8]), (1, "REJECT X"), (build.__name__, trial, finding.pair, finding.y, line))

    def newton_rows(self, entities, a, b, start, fixed):
        parsed = forge.Parsed(entities)
        _, pu, pv = parsed.at(a, *start[:2])
        _, qu, qv = parsed.at(b, *start[2:])
        columns = [pu, pv, [-c for c in qu], [-c for c in qv]]
        y = forge.inverse(list(zip(*[c for i, c in enumerate(columns) if i != fixed])))
        return [[max(min(round(c * 1024), 1 << 60), -1 << 60) for c in row] for row in y]

    def test_every_side_with_every_subset_of_its_arcs(self):
        for build in self.SOUND:
            entities = build()
            for n, s in forge.Parsed(entities).patches.outer():
                arcs, same, opposite = forge.passing(entities, n, s)
                if arcs and arcs[0][:2] == (n, s):
                    self.assertEqual((same, opposite), (1, 1), (build.__name__, n, s))
                    finding = forge.side(entities, n, s, t0=Q(3, 8))
                    self.says("D2", finding)
                    for part in ((3, 2, 4), forge.MOST, (3, 2, 5)):
                        self.says("D4", self.changed(finding, arcs=[(n, s, part)], values={"same": 1, "opposite": 0}))
                self.says("D1", self.changed(finding, arcs=finding.arcs + [(n, s, (3, 3, 4))], values={"same": 2, "opposite": 1}))


    def test_seams(self):
        """A surface that closes on itself: its two ends are different parameters of one point of X."""
        torus = broken.polygon_torus()
        prover = star_forge.Prover(torus)                 # P1 holds
        self.assertEqual((prover.plan.values["patches"], prover.plan.values["genus"]), (16, 1))
        for n, s in prover_sides(torus):
            finding = forge.side(torus, n, s)
            self.assertEqual(finding.values, {"same": 1, "opposite": 1})
            self.says("D2", finding)
            self.says("D4", self.changed(finding, arcs=finding.arcs[:1], values={"same": 1, "opposite": 0}))
        inner = next((n, s) for n in range(16) for s in range(4) if (n, s) not in prover_sides(torus))
        self.says("D1", forge.sides(torus, [(*inner, WHOLE)], 1, 0))
        for entities, a, b in ((torus, 0, 12), (broken.drop(), 0, 0)):
            for h in (Q(1, 2), Q(1, 8), Q(1, 1 << 30)):
                finding = forge.Finding(entities)
                middle = Q(1, 2)
                for u, v, fixed in (((Q(0), h), (1 - h, Q(1)), 1), ((Q(0), Q(0)), (1 - h, Q(1)), 0), ((h, 2 * h), (1 - h, Q(1)), 3)):
                    if max(u) > 1:
                        continue
                    of_v = [(middle, middle) if fixed == axis else (middle - h, middle + h) for axis in (1, 3)]
                    finding.pair = [(a, u, of_v[0]), (b, v, of_v[1])]
                    for y in ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 0, 1], [1, 1, 0], [-1, 1, 0]], [[1, 2, 3], [3, -1, 4], [-2, 5, 1]]):
                        for sign in (1, -1):
                            finding.y = [[sign * c for c in row] for row in y]
                            code, line = vc._check(star_forge.encode_model(entities), finding.certificate(), frozenset())
                            self.assertEqual((code, line[:8]), (1, "REJECT X"), (finding.pair, finding.y, line))


def prover_sides(entities):
    return list(forge.Parsed(entities).patches.outer())


class Hostile(PatchInvalidTest):
    """Bytes by someone who wants a crash, a hang or a wrong ACCEPT."""

    def test_bytes_of_bodies_about_invalid_models(self):
        for seed, finding in enumerate((crossing_of_cubes(fixed=1), crossing_of_triangles(bits=7),
                                        forge.crossing([broken.open_loop()], 0, 0, (0.084, 0.5, 0.916, 0.5), 1, 7),
                                        forge.side(models.tetrahedron()[1:], 0, 0), forge.side(broken.cylinder_wall(), 0, 1))):
            self.mutated(finding, 100 + seed, 300 * SCALE, True)

    def test_bytes_of_bodies_about_sound_models(self):
        cube = forge.Finding(models.cube())
        cube.pair, cube.y = crossing_of_cubes(fixed=1).pair, crossing_of_cubes(fixed=1).y
        cube.pair = [cube.pair[0], (3, *cube.pair[1][1:])]
        for seed, finding in enumerate((cube, forge.side(models.cube(), 0, 0), forge.side(models.octant_sphere(), 0, 0),
                                        forge.side(models.tetrahedron(), 0, 0))):
            self.mutated(finding, 200 + seed, 300 * SCALE)

    def test_breaks_that_would_make_many_patches(self):
        """3,000 x 3,000 patches are spoken of, but the finding is about the border, or about two of them."""
        many = [Q(i, 3000) for i in range(3001)]
        crossing = crossing_of_cubes(fixed=1)
        crossing.breaks = [[many, many]] + crossing.breaks[1:]
        crossing.pair = [(0, (Q(1, 4), Q(3, 4)), (Q(1, 2), Q(1, 2))), (9000000 + 8, *crossing.pair[1][1:])]
        self.assertEqual(self.judged(crossing, "crossing")[1].split(":")[0], "REJECT X3")
        side = forge.side(models.cube(), 0, 0)
        side.breaks = [[many[::10], many[::10]]] + side.breaks[1:]
        self.assertEqual(self.judged(side, "side")[0], 1)

    def test_long_numbers(self):
        finding = crossing_of_cubes(fixed=1)
        for name, value in (("y", [[(1 << 62) + 1, 1, 2], [0, 1 - (1 << 63), 5], [3, 4, (1 << 63) - 1]]),
                            ("breaks", [[[Q(0)] + [Q(i, 1 << 2000) for i in range(1, 9)] + [Q(1)]] * 2] + finding.breaks[1:])):
            self.assertEqual(self.judged(self.changed(finding, **{name: value}), name)[0], 1)
        high = [star_forge.surface([[(Q(i, 3 ** 100), Q(j, 7 ** 50), (i * j) ** 15) for j in range(16)] for i in range(16)])]
        side = forge.sides(high, [(0, 0, (62, 1, 1 << 62))], 1, 0, 0, Q(1, 2))
        self.judged(side, "degree 15")
        cross = forge.Finding(high)
        cross.pair = [(0, (62, 1, 3), (62, 5, 5)), (0, (62, 1 << 61, (1 << 61) + 1), (62, 1, 9))]
        cross.y = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        self.assertEqual(self.judged(cross, "degree 15")[1].split(":")[0], "REJECT X3")

    def test_json_of_the_model(self):
        finding, rng = crossing_of_triangles(bits=7), random.Random(5)
        model = star_forge.encode_model(finding.entities)
        for trial in range(300 * SCALE):
            lie = bytearray(model)
            for _ in range(rng.randint(1, 4)):
                at = rng.randrange(len(lie))
                lie[at:at + rng.randint(0, 3)] = bytes(rng.choice(b'0123456789"[]{},:/-e.x\xff\x00 ') for _ in range(rng.randint(0, 3)))
            code, line = vc._check(bytes(lie), finding.certificate(bytes(lie)), frozenset())
            self.assertIn(code, (0, 1, 4), (trial, bytes(lie), line))
        self.assertTrue(json.loads(model))


if __name__ == "__main__":
    unittest.main()
