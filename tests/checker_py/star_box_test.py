#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates: models that are solids, a lie for every condition, the traps of THEORY."""
import copy
import hashlib
import json
import os
import random
import unittest
from fractions import Fraction as Q

import star_box_forge as forge
import star_box_models as models

from veritope_checker import program as vc                # star_box_forge says where it is

read, patches = forge.read, forge.patches
star_crossing, star_nodes, star_triangles = forge.star_crossing, forge.star_nodes, forge.star_triangles
SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
UNIT = 1 << 20                                            # of the forge: coordinates are counted in 2^-20


class Careless(forge.Prover):
    """Does not look at the crossing number."""

    def holds(self, box):
        probe = forge.check_box(box)
        self.forest.work = 10 ** 5
        try:
            self.forest.descend(star_nodes.misses_box(probe), "C2", lambda n: n.has_s1(probe.c))
            return True
        except read.Reject:
            return False
        finally:
            self.forest.work = 10 ** 9


class OneStar(forge.Prover):
    """Mesh boxes for all leaves but one of each component."""

    def tree(self, node):
        mine = self.components[node.patch.component]
        if node.level == 0 or not mine and node.level < 6 and node.at[0][0] < patches.FULL:
            box = self.star_box(node) if not mine else None
            if box is None and not mine:
                return [self.tree(kid) for kid in node.children()]
        else:
            box = self.star_box(node) if not mine else None
        if box is None:
            box = forge.Box(1, *self.grown(node, 1.1))
        else:
            mine.append(len(self.plan.boxes))
        self.plan.boxes.append(box)
        return len(self.plan.boxes) - 1


def cut(entities, breaks, *args, kind=forge.Prover, **options):
    """A prover with breaks that are given."""
    class Cut(kind):
        @staticmethod
        def plan_kind(*of_plan):
            plan = kind.plan_kind(*of_plan)
            plan.breaks = breaks
            return plan
    return Cut(entities, *args, **options)


WHOLE, HALVES = [Q(0), Q(1)], [Q(0), Q(1, 2), Q(1)]
ONE_KNOT, NO_KNOT = [0, 0, Q(1, 2), 1, 1], [0, 0, 1, 1]   # in degree 1


def with_waist(heights, **options):
    """A cube (entities, and breaks with which they fit) whose top is cut at y = h(x) and y = -h(x): the sheet between these is the first
    entity, (x, v h(x), 1). heights: the coefficients of h, which is 1 at x = -1 and x = 1."""
    top = [forge.surface([[(x, a + b * h, 1) for a, b in borders] for x, h in zip((-1, 0, 1), heights)], **options)
           for borders in (((0, -1), (0, 1)), ((0, 1), (1, 0)), ((-1, 0), (0, -1)))]
    walls = models.cube()
    del walls[4]
    return top + walls, [[HALVES, HALVES]] + [[HALVES, WHOLE]] * 2 + [[HALVES, HALVES]] * 5


def cusp():
    """The middle sheet is a polynomial, (x, x^2 v, 1); the break is no knot."""
    return with_waist((1, -1, 1))


def bow_tie():
    """The middle sheet has a knot where its line is collapsed: (x, |x| v, 1)."""
    return with_waist((1, 0, 1), degrees=(1, 1), knots=[ONE_KNOT, NO_KNOT])


def half_bow_tie():
    """The middle sheet takes in that at larger y. Its line x = 0 is collapsed for v < 0, and goes from (0, 0, 1) to (0, 1, 1) for v > 0."""
    entities, breaks = bow_tie()
    rows = [[(x, y, 1) for y in ys] for x, ys in ((-1, (-1, 0, 1)), (0, (0, 0, 1)), (1, (-1, 0, 1)))]
    return [forge.surface(rows, (1, 1), [ONE_KNOT] * 2), *entities[2:]], [breaks[0], *breaks[2:]]


def sphere_of_one_surface():
    """The sphere of octants as one surface of 4 x 2 spans, with a seam; its poles are outer sides of four spans each."""
    us, vs = [[p for q in quarters for p in models.arc(q)[q != quarters[0]:]] for quarters in ((0, 1, 2, 3), (3, 4))]
    rows = [[(c * x, c * y, s * w, v * w) for c, s, v in vs] for x, y, w in us]
    knots = [[0, *[t for t in range(spans + 1) for _ in range(2)], spans] for spans in (4, 2)]
    return [forge.surface(rows, (2, 2), knots, True)]


class StarBoxTest(unittest.TestCase):
    def says(self, expected, prover, model=None, plan=None, skip=()):
        model = model or prover.model
        code, line = vc._check(model, (plan or prover.plan).certificate(model), frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT star-box-1", "ACCEPT"), expected, line)
        self.assertEqual(code, {"ACCEPT": 0, "ERROR": 4}.get(expected, 1), line)

    def alone(self, condition, prover, plan=None):
        """The lie is rejected by this condition and accepted without it."""
        self.says(condition, prover, plan=plan)
        self.says("ACCEPT", prover, plan=plan, skip={condition})

    def proved(self, entities, kind=forge.Prover, **options):
        return kind(entities, **options).prove()


class SoundModels(StarBoxTest):
    def accepted(self, entities, **values):
        prover = self.proved(entities)
        self.says("ACCEPT", prover)
        for key, value in values.items():
            self.assertEqual(prover.plan.values[key], value, key)
        return prover

    def test_cube_of_bilinear_patches(self):
        self.accepted(models.cube(), patches=6, edges=12, vertices=8, shells=1, bodies=1, genus=0)

    def test_tetrahedron(self):
        self.accepted(models.tetrahedron(), edges=6, vertices=4)

    def test_bicubic_ball(self):
        self.accepted(models.bicubic_ball(), edges=12, genus=0)

    def test_sphere_of_octants_has_characteristic_two(self):
        self.accepted(models.octant_sphere(), patches=8, edges=12, vertices=6, genus=0)

    def test_poles_with_knots_and_breaks_along_them(self):
        prover = cut(sphere_of_one_surface(), [[[Q(0), Q(1, 2), Q(1), Q(2), Q(3), Q(4)], [Q(0), Q(1), Q(2)]]]).prove()
        self.says("ACCEPT", prover)
        self.assertEqual([prover.plan.values[key] for key in ("patches", "edges", "vertices", "genus")], [10, 15, 7, 0])

    def test_torus(self):
        self.accepted(models.torus(), patches=16, edges=32, vertices=16, genus=1)

    def test_cubic_triangles(self):
        self.accepted(models.cubic_octahedron(), patches=8, edges=12, vertices=6, genus=0)

    def test_a_vertex_without_a_half_space_needs_a_mesh_box(self):
        prover = self.accepted(models.snake(), genus=0, patches=36)
        self.assertTrue(any(box.kind for box in prover.plan.boxes))

    def test_a_cavity(self):
        inner = [models.reversed_surface(e) for e in models.cube(Q(1, 2))]
        prover = self.accepted(models.cube(2) + inner, shells=2, bodies=1, vertices=16)
        flagged = self.proved(models.cube(2) + models.cube(Q(1, 2)), flags=[0] * 6 + [1] * 6)
        self.says("ACCEPT", flagged)
        self.assertEqual(flagged.plan.values["bodies"], 1)
        flagged.plan.values["flipped"] = 5
        self.alone("W3", flagged)
        self.says("ACCEPT", prover)

    def test_cubes_3_2_1_are_two_bodies(self):
        self.accepted(models.cube(3) + [models.reversed_surface(e) for e in models.cube(2)] + models.cube(1), shells=3, bodies=2)

    def test_knots_inside_a_patch_are_extracted(self):
        faces = models.cube(degree=3, shape=lambda p: [c * (Q(5, 4) - sum(x * x for x in p) * Q(3, 16)) for c in p])
        knots = [[0] * 4 + [Q(1, 3)] + [1] * 4, [-1, -1, -1, 0, 1, 1, 1, 2]]    # the second: not clamped
        entity = forge.surface([[(i, j * j, i * j) for j in range(4)] for i in range(5)], (3, 3), knots)
        parsed = read.read_model(forge.encode_model([entity]))[0]
        u, v = [Q(0), Q(1, 5), Q(1, 3), Q(1)], [Q(0), Q(1, 2), Q(1)]
        got = list(patches.patches_of(parsed, [u, v], 0, 0))
        self.assertEqual(len(got), 6)
        for n, (a, b) in enumerate([(a, b) for a in range(3) for b in range(2)]):
            for s, t in ((Q(1, 2), Q(1, 3)), (Q(0), Q(0)), (Q(1), Q(1))):
                x = [bezier(a_, s, t) for a_ in got[n].net]
                want = de_boor(parsed, (u[a] + s * (u[a + 1] - u[a]), v[b] + t * (v[b + 1] - v[b])))
                self.assertEqual([c / x[3] for c in x[:3]], want[:3], (n, s, t))
        halved = self.proved(faces[:1] + faces[1:], roots=1)
        self.says("ACCEPT", halved)

    def test_breaks_that_need_the_long_form(self):
        """The cube with parameter domains whose ends have numerators or denominators of 70 bits and more."""
        far = (1 << 70) + 1
        for lo, hi in ((0, far), (-far, far), (Q(-1, far), Q(far, 3)), (far, far + Q(1, far))):
            faces = [dict(f, shape=dict(f["shape"], knots=[[str(lo)] * 2 + [str(hi)] * 2, ["0", "0", "1", "1"]])) for f in models.cube()]
            self.assertIn(b"\0\0", forge.rational(hi)[:2])
            self.accepted(faces, patches=6)

    def test_walks_in_all_six_directions(self):
        """From c+ of a box at the middle of each face: straight out is free, straight in is not."""
        prover = self.proved(models.cube(), roots=2)
        for end in range(6):
            axis, sign = end // 2, 1 - 2 * (end % 2)
            at = [forge.check_box(box).c[1] for box in prover.plan.boxes]
            number = max(range(len(at)), key=lambda i: sign * at[i][axis] - max(abs(at[i][k]) for k in range(3) if k != axis))
            self.assertTrue(sign * at[number][axis] > UNIT > max(abs(at[number][k]) for k in range(3) if k != axis))
            for to, expected in ((end, "ACCEPT"), (end ^ 1, "W1")):
                plan = copy.deepcopy(prover.plan)
                plan.walks = [(number, 1, [], to)]
                self.says(expected, prover, plan=plan)

    def test_more_breaks_than_knots(self):
        plan_breaks = [[Q(0), Q(1, 3), Q(1)]] * 2

        class Split(forge.Prover):
            def __init__(self, entities):
                original = forge.Plan.__init__

                def patched(plan, *args):
                    original(plan, *args)
                    plan.breaks = [plan_breaks] * len(plan.breaks)
                forge.Plan.__init__ = patched
                try:
                    super().__init__(entities, unit=-40)
                finally:
                    forge.Plan.__init__ = original
        faces = [forge.surface([[at(*[Q(c) for c in (u, v)]) for v in (-1, 1)] for u in (-1, 1)]) for at in models.cube_faces()]
        with self.assertRaisesRegex(ValueError, "P1"):    # a third from the left meets a third from the right
            Split(faces)
        plan_breaks[:] = [[Q(0), Q(1, 2), Q(1)]] * 2
        prover = Split(faces).prove()
        self.assertEqual(prover.plan.values["patches"], 24)
        self.says("ACCEPT", prover)

    def test_the_line_of_the_centres_may_pass_through_edges_and_vertices(self):
        entities = models.cube()
        for direction in ((1, 1, 0), (1, 1, 1)):
            prover = self.proved(entities, roots=3)
            at = [UNIT * d for d in direction]            # a point of an edge, a vertex
            lo, size = [c - UNIT // 4 for c in at], [UNIT // 2] * 3
            minus, plus = [[UNIT // 4 + s * d * UNIT // 8 for d in direction] for s in (-1, 1)]
            box = forge.Box(0, lo, size, minus, plus)
            inside = [i for i, other in enumerate(prover.plan.boxes) if all(c < l and l + s < c + t for c, t, l, s in zip(
                lo, size, [a + b // 5 for a, b in zip(other.lo, other.size)], [b * 3 // 5 for b in other.size]))]
            self.assertTrue(inside)
            for i in inside:
                prover.plan.boxes[i] = box
            self.says("ACCEPT", prover)


def bezier(rows, s, t):
    def curve(c, x):
        while len(c) > 1:
            c = [(1 - x) * a + x * b for a, b in zip(c, c[1:])]
        return c[0]
    return curve([curve(r, t) for r in rows], s)


def de_boor(entity, at):
    """By the definition of the basis functions, not by blossoms."""
    def basis(t, i, p, x, end):
        if p == 0:
            return Q(int(t[i] < x == t[i + 1] if x == t[end] else t[i] <= x < t[i + 1]))
        a = (x - t[i]) / (t[i + p] - t[i]) * basis(t, i, p - 1, x, end) if t[i + p] > t[i] else 0
        b = (t[i + p + 1] - x) / (t[i + p + 1] - t[i + 1]) * basis(t, i + 1, p - 1, x, end) if t[i + p + 1] > t[i + 1] else 0
        return a + b
    weights = [[basis(t, i, p, x, len(t) - p - 1) for i in range(len(t) - p - 1)]
               for t, p, x in zip(entity.knots, entity.degrees, at)]
    return [sum(a * b * entity.rows[i][j][c] for i, a in enumerate(weights[0]) for j, b in enumerate(weights[1])) for c in range(4)]


class Lies(StarBoxTest):
    """For every condition: a lie that this condition alone rejects."""

    @classmethod
    def setUpClass(cls):
        cls.cube = forge.Prover(models.cube()).prove()

    def plan(self):
        return copy.deepcopy(self.cube.plan)

    def test_s1_s3_s4_name_themselves(self):
        cert = self.cube.certificate()
        for old, new, expected in ((b'"genus":0', b'"genus":00', "S1"), (b'"genus":0,', b'', "S1"), (b'"vjson"', b'"json"', "S1"),
                                   (b'"edges":12', b'"edges":12,"faces":1', "S1"), (b'"star-box-1"', b'"star-box-9"', "S1"),
                                   (b'"edges"', b'"as_indexed":true,"edges"', "S1"), (b'"subject_bytes":', b'"subject_bytes":1', "S3"),
                                   (b"VTSB", b"VTSC", "S4")):
            self.assertIn(old, cert)
            self.assertTrue(vc.check(self.cube.model, cert.replace(old, new, 1))[1].startswith("REJECT %s:" % expected), new)
        self.assertTrue(vc.check(self.cube.model + b" ", cert)[1].startswith("REJECT S3:"))

    def test_b1(self):
        def change(**fields):
            plan = self.plan()
            for key, value in fields.items():
                setattr(plan, key, value)
            return plan
        good = self.plan()
        box = good.boxes[0]
        bad_boxes = [forge.Box(2, box.lo, box.size, box.minus, box.plus), forge.Box(0, box.lo, [0, 9, 9], box.minus, box.plus),
                     forge.Box(0, box.lo, box.size, [0, 1, 1], box.plus), forge.Box(0, box.lo, box.size, box.minus, box.size),
                     forge.Box(0, box.lo, box.size, box.minus, box.plus, 4097)]
        for plan in (change(tail=b"x"), change(flags=[2] + [0] * 5), change(entities=self.cube.plan.entities[:5]), change(unit=5000),
                     change(trees=[[len(good.boxes)]] + good.trees[1:]), change(walks=[(99, 1, [], 0)]), change(walks=[(0, 1, [], 7)]),
                     change(roots=[[13, 0]] + good.roots[1:]), change(breaks=[[[0, 1], [0, 2]]] + good.breaks[1:]),
                     change(breaks=[[[0, 1], [0]]] + good.breaks[1:]), change(breaks=[[[0, Q(1, 2), Q(1, 2), 1], [0, 1]]] + good.breaks[1:]),
                     *[change(boxes=[b] + good.boxes[1:]) for b in bad_boxes]):
            self.says("B1", self.cube, plan=plan)
        deep = 0
        for _ in range(25):
            deep = [deep, 0, 0, 0]
        self.says("B1", self.cube, plan=change(trees=[[deep]] + good.trees[1:]))
        body = self.cube.plan.body()
        for n in range(len(body)):                        # every truncation
            plan = self.plan()
            plan.body = lambda n=n: body[:n]
            self.says("B1", self.cube, plan=plan)

    def test_a_model_without_entities_bounds_nothing(self):
        nothing = json.dumps({"format": "veritope-spline-1", "groups": [], "entities": []}).encode()
        body = b"VTSB" + bytes(4) + bytes(1) + bytes(4) + bytes(4)      # no entity, E = 0, no box, no walk
        statement = {"certificate": "veritope-certificate-1", "tool": "test", "claim": "star-box-1",
                     "subject_sha256": hashlib.sha256(nothing).hexdigest(), "subject_bytes": len(nothing),
                     "subject_format": "vjson", "body_sha256": hashlib.sha256(body).hexdigest()}
        statement.update(dict.fromkeys(("patches", "edges", "vertices", "shells", "bodies", "genus", "boxes", "flipped"), 0))
        code, line = vc.check(nothing, json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body)
        self.assertEqual((code, line.split(":")[0]), (1, "REJECT B1"))

    def test_a_knot_must_be_a_break(self):
        rows = [[(i, j, 0) for j in range(2)] for i in range(3)]
        plan = forge.Plan([forge.surface(rows, (1, 1), [[0, 0, 1, 2, 2], [0, 0, 1, 1]])])
        plan.breaks, plan.roots, plan.trees, plan.boxes = [[[Q(0), Q(2)], [Q(0), Q(1)]]], [[0, 0]], [[0]], [forge.Box(1, [0] * 3, [9] * 3)]
        code, line = vc.check(forge.encode_model(plan.entities), plan.certificate())
        self.assertTrue(line.startswith("REJECT B1: breaks"), line)

    def test_b2(self):
        flat = forge.surface([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
        high = forge.surface([[(i, j, 0) for j in range(2)] for i in range(17)])
        curve = {"kind": "curve", "group": None, "attributes": [], "shape": {}}
        long = forge.surface([[(0, 0, Q(1, 3 ** 5200)), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
        for entity in (flat, high, curve, long):
            plan = forge.Plan(models.cube() + [entity])
            plan.roots = [[0, 0]] * (6 if entity is curve else 7)
            plan.boxes, plan.trees = [forge.Box(1, [0] * 3, [9] * 3)], [[0]] * len(plan.roots)
            model = forge.encode_model(plan.entities)
            self.says("B2", None, model, plan)

    def test_p1(self):
        prover = self.proved(models.cube()[:5], checked=False)
        self.alone("P1", prover)
        twice = forge.Prover(models.cube() * 2, checked=False)
        self.assertRaisesRegex(ValueError, "P1", forge.Prover, models.cube() * 2)
        self.assertEqual(twice.plan.values["patches"], 12)

    def test_p1_a_line_inside_of_a_surface_that_is_a_point(self):
        for build in (bow_tie, half_bow_tie):
            with self.subTest(build.__name__):
                entities, breaks = build()
                self.assertRaisesRegex(ValueError, "P1 .*collapsed", cut, entities, breaks)
                self.alone("P1", cut(entities, breaks, checked=False).prove())
                turned = [models.reversed_surface(e) for e in entities]
                prover = cut(turned, [axes[::-1] for axes in breaks], flags=[1] * len(entities), checked=False)
                self.alone("P1", prover.prove())

    def test_p1_a_break_that_is_no_knot_on_a_line_that_is_a_point(self):
        """Without the break P1 holds: it is about the sides of patches."""
        entities, breaks = cusp()
        prover = cut(entities, breaks, checked=False)
        prover.plan.boxes, prover.plan.trees = [forge.Box(1, [0] * 3, [9] * 3)], [[0]] * len(prover.patches)
        self.says("P1", prover)
        self.says("C1", prover, skip={"P1"})              # star_box_2_test.py has a proof of the rest
        quarters = [Q(n, 4) for n in range(5)]
        for axis in (WHOLE, [t for t in quarters if t != Q(1, 2)]):
            cut(entities, [[axis if t is HALVES else t for t in axes] for axes in breaks])       # does not raise
        with self.assertRaisesRegex(ValueError, "P1 .*collapsed"):
            cut(entities, [[quarters if t is HALVES else t for t in axes] for axes in breaks])

    def test_c1(self):
        lies = [lie for i, box in enumerate(self.cube.plan.boxes) for k in range(3) for lie in [self.shrunk(i, k)]
                if vc.check(self.cube.model, lie.certificate())[1].startswith("REJECT C1")]
        accepted = [lie for lie in lies if vc._check(self.cube.model, lie.certificate(), frozenset({"C1"}))[0] == 0]
        self.assertTrue(accepted)
        plan = self.plan()
        plan.boxes.append(plan.boxes[0])                  # named by no leaf
        self.alone("C1", self.cube, plan)

    def shrunk(self, i, k):
        """Box i cut on axis k to just contain its centres."""
        plan = self.plan()
        box = plan.boxes[i]
        cut, end = min(box.minus[k], box.plus[k]) - 2, max(box.minus[k], box.plus[k]) + 2
        box.lo[k], box.size[k] = box.lo[k] + cut, end - cut
        box.minus[k], box.plus[k] = box.minus[k] - cut, box.plus[k] - cut
        return plan

    def test_c1_leaves_of_two_components(self):
        prover = self.proved(models.cube() + models.cube(1, (4, 0, 0)))
        plan = prover.plan
        last = plan.trees[6]
        plan.trees[6] = copy.deepcopy(last)
        tree = plan.trees[6]
        while not isinstance(tree[0], int):
            tree = tree[0]
        dropped = tree[0]
        tree[0] = 0                                       # of the other cube: it is not in this box either
        del dropped
        self.says("C1", prover, plan=plan)

    def test_c2(self):
        plan = self.plan()
        lo, size = [UNIT - UNIT // 4] * 3, [UNIT // 2] * 3
        minus, plus = [UNIT // 8] * 3, [UNIT * 3 // 8, UNIT // 8 + 2, UNIT // 8 + 1]
        plan.boxes[0] = forge.Box(0, lo, size, minus, plus)      # the line crosses x = 1 once; the others do not separate its ends
        self.says("C2", self.cube, plan=plan, skip={"C1"})
        self.says("ACCEPT", self.cube, plan=plan, skip={"C1", "C2"})

    def test_c2_alone(self):
        plan = self.plan()
        i = next(i for i, box in enumerate(plan.boxes) if self.tilt(plan, i))
        self.alone("C2", self.cube, self.tilt(plan, i))

    def tilt(self, plan, i):
        """c+ moved until S1 fails while the line still crosses once; None where that does not happen."""
        for k in range(3):
            for to in (1, plan.boxes[i].size[k] - 1):
                lie = copy.deepcopy(plan)
                lie.boxes[i].plus[k] = to
                cert = lie.certificate()
                if (vc.check(self.cube.model, cert)[1].startswith("REJECT C2: a node") and
                        vc._check(self.cube.model, cert, frozenset({"C2"}))[0] == 0):
                    return lie
        return None

    def test_c2_the_centres_exchanged(self):
        plan = self.plan()
        for box in plan.boxes:
            box.minus, box.plus = box.plus, box.minus
        self.says("C2", self.cube, plan=plan)

    def test_c3_two_cubes_that_cross(self):
        prover = self.proved(models.cube() + models.cube(1, (1, Q(1, 2), Q(1, 4))), kind=Careless)
        self.assertEqual(prover.plan.values["shells"], 2)
        self.alone("C3", prover)

    def test_c4_two_tetrahedra_that_cross(self):
        prover = self.proved(models.tetrahedron() + models.tetrahedron(1, (Q(1, 4), Q(1, 5), Q(1, 6))), kind=OneStar)
        self.alone("C4", prover)

    def test_w1(self):
        plan = self.plan()
        start = next(walk for walk in plan.walks)
        box = forge.check_box(plan.boxes[start[0]])
        through = [-c for c in box.c[1]]
        plan.walks = [(start[0], 1, [through], 0)]
        self.says("W1", self.cube, plan=plan)
        self.says("ACCEPT", self.cube, plan=plan, skip={"W1"})
        plan.walks = []
        self.says("W1", self.cube, plan=plan)
        plan.walks = [start, start]
        self.says("W1", self.cube, plan=plan)
        plan.walks = [(start[0], 1, [], (start[0], 1))]
        self.says("W1", self.cube, plan=plan)

    def test_w3(self):
        for key in ("patches", "edges", "vertices", "shells", "bodies", "genus", "boxes", "flipped"):
            for change in (1, 1 << 60):
                plan = self.plan()
                plan.values = dict({"boxes": len(plan.boxes), "flipped": 0}, **plan.values)
                plan.values[key] += change
                self.alone("W3", self.cube, plan)

    def test_w2_reversed_cube(self):
        prover = self.proved([models.reversed_surface(e) for e in models.cube()], kind=AnySign)
        self.assertEqual(prover.plan.walks[0][1], 0)
        self.alone("W2", prover)

    def test_w2_a_solid_inside_a_solid(self):
        prover = self.proved(models.cube(2) + models.cube(Q(1, 2)), kind=AnySign)
        self.alone("W2", prover)

    def test_w2_a_walk_that_changes_sides(self):
        prover = self.proved(models.cube(2) + [models.reversed_surface(e) for e in models.cube(Q(1, 2))])
        second = prover.plan.walks[1]
        prover.plan.walks[1] = (*second[:3], (second[3][0], 1 - second[3][1]))
        self.says("W1", prover)


class AnySign(forge.Prover):
    """Walks from either centre to anything that can be reached."""

    def first_walk(self, n, done):
        for number in self.components[n]:
            box = self.probe(self.plan.boxes[number])
            for sign in (1, 0):
                for end in range(6):
                    ray = [0, 0, 0]
                    ray[end // 2] = 1 - 2 * (end % 2)
                    if self.is_free(star_nodes.misses_segment(box.c[sign], ray, True)):
                        return number, sign, [], end
                for other in [b for m in done for b in self.components[m][:12]]:
                    for to in (0, 1):
                        at = self.probe(self.plan.boxes[other]).c[to]
                        if self.is_free(star_nodes.misses_segment(box.c[sign], star_triangles.sub(at, box.c[sign]), False)):
                            return number, sign, [], (other, to)
        return None


class Traps(StarBoxTest):
    """The counterexamples of the referees."""

    def judge(self, entities, lo, hi, minus, plus, scale):
        """(S1 holds on all tested nodes, crossing number) for one box around open sheets."""
        prover = forge.Prover(entities, checked=False)
        to = [[int(c * scale * UNIT) for c in p] for p in (lo, hi, minus, plus)]
        box = forge.Box(0, to[0], star_triangles.sub(to[1], to[0]), star_triangles.sub(to[2], to[0]), star_triangles.sub(to[3], to[0]))
        probe = forge.check_box(box)
        nodes = prover.forest.descend(star_nodes.misses_box(probe), "C2", lambda n: n.has_s1(probe.c))
        return star_crossing.Crossing(nodes, probe, lambda units: None).number()

    def test_a_fold_of_three_sheets_passes_everything_but_p1(self):
        def graph(sign):
            def z(x):
                return sign * Q(1, 10) * (x - Q(1, 2)) * (x - Q(7, 10))
            x0, x1 = Q(1, 2), Q(3, 2)
            mid = sign * Q(1, 10) * ((x0 - Q(1, 2)) * (x1 - Q(7, 10)) + (x1 - Q(1, 2)) * (x0 - Q(7, 10))) / 2
            return forge.surface([[(x, y, h) for y in (-2, 2)] for x, h in ((x0, z(x0)), (Q(1), mid), (x1, z(x1)))])
        plane = forge.surface([[(x, y, Q(-3, 10)) for y in (-2, 2)] for x in (-2, 2)])
        sheets = [plane, graph(1), graph(-1)]
        self.assertEqual(self.judge(sheets, (-1,) * 3, (1,) * 3, (0, 0, Q(-9, 10)), (0, 0, Q(9, 10)), 1), 1)
        self.assertRaisesRegex(ValueError, "P1", forge.Prover, sheets)

    def test_two_sheets_of_count_one_a_piece_cross_twice(self):
        def up(x):
            return x / 10
        corners = [(Q(x), Q(y), up(Q(x))) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        fan = [forge.triangle([(0, 0, 0), corners[i - 1], corners[i]]) for i in range(4)]
        other = forge.triangle([(Q(x), Q(y), Q(1, 50) - Q(x, 10)) for x, y in ((-2, -1), (2, -1), (0, 3))])
        args = (-Q(1, 2),) * 3, (Q(1, 2),) * 3, (0, 0, -Q(2, 5)), (0, 0, Q(2, 5)), 1
        self.assertEqual(self.judge(fan, *args), 1)
        self.assertEqual(self.judge([other], *args), 1)
        self.assertEqual(self.judge(fan + [other], *args), 2)

    def z_fold(self):
        p, q, m1, m2, o, a, b = (-2, 0), (2, 0), (0, 1), (0, -1), (0, 0), (0, 4), (0, -4)
        nw, ne, se, sw, w, e = (-4, 4), (4, 4), (4, -4), (-4, -4), (-4, 0), (4, 0)
        top = [(p, m2, a), (m2, q, a), (p, a, nw), (p, nw, w), (q, e, ne), (q, ne, a), (o, q, m1), (o, m1, p), (o, p, b), (o, b, q),
               (p, w, sw), (p, sw, b), (q, b, se), (q, se, e), (p, m1, q), (p, q, m2)]
        ring = [nw, w, sw, b, se, e, ne, a]
        faces = [[(*c, 4) for c in t] for t in top]
        for c, d in zip(ring, ring[1:] + ring[:1]):
            faces += [[(*c, 4), (*c, -4), (*d, -4)], [(*c, 4), (*d, -4), (*d, 4)]]
        faces += [[(*ring[0], -4), (*ring[i + 1], -4), (*ring[i], -4)] for i in range(1, 7)]
        return [forge.triangle(t) for t in faces]

    def test_a_flat_fold(self):
        prover = forge.Prover(self.z_fold())
        self.assertEqual((prover.plan.values["patches"], prover.plan.values["edges"], prover.plan.values["genus"]), (38, 57, 0))
        self.alone("C4", self.proved(self.z_fold(), kind=OneStar))

    def test_two_tetrahedra_joined_at_a_vertex(self):
        below = models.triangles([(0, 0, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)], [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)])
        prover = self.proved(models.tetrahedron() + below, kind=OneStar)
        self.assertEqual((prover.plan.values["vertices"], prover.plan.values["shells"]), (8, 2))
        self.alone("C4", prover)

    def test_a_pillow(self):
        t = models.triangles([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 1)])
        prover = forge.Prover(t)
        prover.plan.boxes = [forge.Box(1, [-9] * 3, [2 * UNIT] * 3)]
        prover.plan.trees = [[0], [0]]
        self.says("C4", prover)
        prover.plan.boxes = [forge.Box(0, [-9 * UNIT] * 3, [20 * UNIT] * 3, [9 * UNIT] * 3, [10 * UNIT] * 3)]
        self.says("C2", prover)

    def test_a_triangle_that_is_a_point_has_no_coefficient_left(self):
        """All sides are collapsed: were all its coefficients left out, S1 would hold and a point would count as a shell."""
        entities = models.cube() + [forge.triangle([(1, 0, 0)] * 3)]
        cube = self.proved(models.cube())
        prover = forge.Prover(entities)
        self.assertEqual((prover.plan.values["shells"], prover.plan.values["genus"]), (2, 0))
        plan = prover.plan
        plan.boxes, plan.trees = cube.plan.boxes[:], cube.plan.trees + [[len(cube.plan.boxes)]]
        around = forge.Box(0, [UNIT // 2, -UNIT // 4, -UNIT // 4], [UNIT, UNIT // 2, UNIT // 2], [9, UNIT // 4, UNIT // 4],
                           [UNIT - 9, UNIT // 4, UNIT // 4])
        plan.boxes.append(around)
        last = len(plan.boxes) - 1
        plan.walks = cube.plan.walks + [(last, 1, [], 0)]
        plan.values["bodies"] = 2
        self.says("C2", prover)

    def test_a_lune_whose_sides_collapse_at_a_common_corner_is_never_certified(self):
        rows = [[(0, 0, 0), (0, 0, 0), (0, 0, 0)], [(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 0, 0), (0, 1, 0), (0, 2, 0)]]
        prover = forge.Prover([forge.surface(rows)], checked=False)
        root = prover.forest.roots[0]
        self.assertIs(root.kept(root.coefficients()), False)
        self.assertFalse(root.has_s1(((0, 0, -9), (0, 0, 9))))


class Pieces(unittest.TestCase):
    """The parts of the checker against slow formulas."""

    def test_g_is_the_determinant(self):
        rng = random.Random(6)
        for is_tensor in (True, False):
            for p, q in ((1, 1), (2, 1), (2, 3), (3, 3)) if is_tensor else ((1, 1), (2, 2), (4, 4)):
                if is_tensor:
                    rows = [[tuple(rng.randint(-9, 9) for _ in range(3)) + (rng.randint(1, 5),) for _ in range(q + 1)] for _ in range(p + 1)]
                    entity = forge.surface(rows, rational=True)
                else:
                    rows = [tuple(rng.randint(-9, 9) for _ in range(3)) + (rng.randint(1, 5),) for _ in range((p + 1) * (p + 2) // 2)]
                    entity = forge.triangle(rows, p, True)
                flag = rng.randint(0, 1)
                parsed = read.read_model(forge.encode_model([entity]))[0]
                patch = next(patches.patches_of(parsed, [[Q(0), Q(1)]] * 2, flag, 0))
                d, x, y, z = patch.make_g()
                c = [rng.randint(-9, 9) for _ in range(3)]
                ratios = set()
                for _ in range(4):
                    s = [Q(rng.randint(1, 9), 20) for _ in range(2)]
                    value = evaluate(d, s, is_tensor) - sum(k * evaluate(a, s, is_tensor) for k, a in zip(c, (x, y, z)))
                    want = slow_g(patch, s, c) * (-1 if flag else 1)
                    ratios.add(value / want if want else None)
                self.assertEqual(len(ratios), 1, (is_tensor, p, q, rows))
                self.assertGreater(ratios.pop(), 0)

    def test_touching_is_meeting_and_zero_is_not_positive(self):
        box = type("Box", (), {"lo": [0, 0, 0], "hi": [6, 6, 6]})
        for k in range(3):
            for at, misses in ((-2, False), (-3, True), (12, False), (13, True)):
                lo, hi = [[(4, 2)] * 3 for _ in range(2)]
                lo[k], hi[k] = ((-9, 2), (at + 2, 2)) if at < 0 else ((at, 2), (at + 5, 2))
                self.assertEqual(star_nodes.misses_box(box)(lo, hi), misses, (k, at))
        entity = read.read_model(forge.encode_model([forge.triangle([(0, 0, 0), (1, 0, 0), (0, 1, 0)])]))[0]
        node = next(star_nodes.root_nodes(next(patches.patches_of(entity, None, 0, 0))))
        node.patch.sides = [(0, True), (1, True), (2, True)]
        for minus, plus, good in ((-1, 1, True), (0, 1, False), (-1, 0, False), (1, -1, False)):
            self.assertEqual(node.has_s1(((0, 0, minus), (0, 0, plus))), good, (minus, plus))

    def test_the_rule_of_the_crossing_number(self):
        """Whole turns of polygons around the centre, from every corner, both ways, vertices on the ray among them."""
        crossing = star_crossing.Crossing([], type("Box", (), {"c": [[0] * 3, [0, 0, 1]]}), lambda units: None)
        square = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)]
        for shift, want in (((0, 0), 1), ((3, 0), 0), ((-3, 0), 0), ((0, 3), 0)):
            points = [(x + shift[0], y + shift[1]) for x, y in square]
            for way in (1, -1):
                turn = points[::way]
                total = sum(crossing.of_curve([a[0], b[0]], [a[1], b[1]]) for a, b in zip(turn, turn[1:] + turn[:1]))
                self.assertEqual(total, way * want, (shift, way))
        self.assertEqual(crossing.of_curve([1, -9, 9, -1], [-1, 1, 1, -1]), -1)    # up where x < 0, down where x > 0
        self.assertRaises(read.Reject, crossing.of_curve, [-1, 2], [-1, 2])         # through the centre, at 1/3

    def test_triangles_and_boxes(self):
        rng = random.Random(7)
        for _ in range(400 * SCALE):
            t = [tuple(rng.randint(-4, 4) for _ in range(3)) for _ in range(3)]
            entity = read.read_model(forge.encode_model([forge.triangle(t)]))[0]
            patch = next(patches.patches_of(entity, None, 0, 0))
            lo = [rng.randint(-4, 2) for _ in range(3)]
            hi = [a + rng.randint(1, 3) for a in lo]
            box = type("Box", (), {"lo": lo, "hi": hi})
            polygon = [tuple(map(Q, p)) for p in t]
            for k in range(3):                            # cut by the six planes
                for sign, at in ((1, lo[k]), (-1, hi[k])):
                    heights, result = [sign * (p[k] - at) for p in polygon], []
                    for i, (p, h) in enumerate(zip(polygon, heights)):
                        o, g = polygon[i - 1], heights[i - 1]
                        if min(g, h) < 0 < max(g, h):
                            result.append(tuple((a * h - b * g) / (h - g) for a, b in zip(o, p)))
                        if h >= 0:
                            result.append(p)
                    polygon = result
            self.assertEqual(star_triangles.triangle_misses_box(star_triangles.corners_of(patch), box), not polygon, (t, lo, hi))

    def test_segments_and_boxes(self):
        rng = random.Random(8)
        for _ in range(1000 * SCALE):
            p, d = [[rng.randint(-4, 4) for _ in range(3)] for _ in range(2)]
            lo = [rng.randint(-4, 3) for _ in range(3)]
            hi = [a + rng.randint(0, 3) for a in lo]
            pairs = [(a, 1) for a in lo], [(a, 1) for a in hi]
            for is_ray in (False, True):
                times = sorted({Q(0), *([] if is_ray else [Q(1)]),
                                *[Q(a - c, s) for corner in (lo, hi) for a, c, s in zip(corner, p, d) if s]})
                meets = any(0 <= t and (is_ray or t <= 1) and all(a <= c + t * s <= b for a, b, c, s in zip(lo, hi, p, d)) for t in times)
                self.assertEqual(star_nodes.misses_segment(p, d, is_ray)(*pairs), not meets, (p, d, lo, hi, is_ray))

    def test_numbers(self):
        for text, value in (("3", 3), ("-1/3", Q(-1, 3)), ("0.25", Q(1, 4)), ("1e-3", Q(1, 1000)), ("0x1.8p-3", Q(3, 16)), ("+.5", Q(1, 2)),
                            ("5.", 5), ("0X.8", Q(1, 2)), ("6/4", Q(3, 2)), ("1e-" + "0" * 5000 + "2", Q(1, 100)), ("1" * 5096, None), ("-0xap1", -20)):
            self.assertEqual(read.number(text), int(text[:4000]) * 10 ** 1096 + int(text[4000:]) if value is None else value, text[:20])
        for text in ("", "+", ".", "1/0", "1/-2", "e5", "0x", "0x.", "1e", "1e4097", "1" * 5097, "0." + "1" * 1001, " 1", "1 ", "1_0", "nan", "inf",
                     "1e99999999999", "0x1p5000", "\u0661", 3, None, True, "1/2/3", "0x1e3.p", "1.5/2"):
            self.assertRaises(read.Refused, read.number, text)


def evaluate(rows, s, is_tensor):
    if is_tensor:
        return bezier(rows, *s)
    a, b, c = 1 - s[0] - s[1], s[0], s[1]
    while len(rows) > 1:
        rows = [[a * rows[r][k] + b * rows[r + 1][k] + c * rows[r + 1][k + 1] for k in range(r + 1)] for r in range(len(rows) - 1)]
    return rows[0][0]


def slow_g(patch, s, c):
    """w^3 n.(S - c) with n from difference quotients' limits: derivatives of the homogeneous map by interpolation."""
    def at(s):
        return [evaluate(a, s, patch.is_tensor) for a in patch.net]

    def derivative(k):
        n = patch.degrees[0] + patch.degrees[-1] + 1      # exact: a polynomial of this degree at n + 1 points
        xs = [Q(i, 64) for i in range(n + 1)]
        values = [at([v + (x if i == k else 0) for i, v in enumerate(s)]) for x in xs]
        out = []
        for component in zip(*values):
            total = Q(0)
            for i, y in enumerate(component):             # derivative at 0 of Lagrange's polynomials
                others = [x for j, x in enumerate(xs) if j != i]
                scale = Q(1)
                for x in others:
                    scale *= xs[i] - x
                slope = Q(0)
                for j in range(len(others)):
                    product = Q(1)
                    for m, x in enumerate(others):
                        product *= 1 if m == j else -x
                    slope += product
                total += y * slope / scale
            out.append(total)
        return out

    f, fu, fv = at(s), derivative(0), derivative(1)
    w = f[3]
    point = [a / w for a in f[:3]]
    su, sv = [[(d[i] * w - f[i] * d[3]) / w ** 2 for i in range(3)] for d in (fu, fv)]
    return w ** 3 * star_triangles.dot(star_triangles.cross(su, sv), star_triangles.sub(point, c))


if __name__ == "__main__":
    unittest.main()
