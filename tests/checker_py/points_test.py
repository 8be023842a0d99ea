#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Tests of docs/certificates/points.md: true answers are accepted in every spelling and with every hint, and each condition rejects lies
that break nothing else. What is true says the oracle of points_forge.py."""
import itertools
import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

import mesh_test                                          # says where the others are
import mesh_models as models
from mesh_models import CUBE, OCTAHEDRON, ONION, REGULAR, SHELL, TET, TWIST

attacks, forge, vc = mesh_test.attacks, mesh_test.forge, mesh_test.vc
import points_forge                                       # noqa: E402
import solids                                             # noqa: E402
from points_forge import Line, Plan                       # noqa: E402
from veritope_checker.points import answers as points_answers, box_tree, points_check    # noqa: E402

HALF, THIRD = Fraction(1, 2), Fraction(1, 3)
DOUBLE = TET[0], TET[1] * 2
# Two tetrahedra with a common edge, and triangles without area on it, beside it, and of one point.
FLAT = (TET[0] + [(1, 1, 1), (2, 0, 0), (0.5, 0.5, 0)], TET[1] + [(1, 2, 4), (1, 3, 2), (1, 4, 3), (2, 3, 4)] +
        [(0, 0, 5), (0, 5, 0), (5, 5, 5), (1, 2, 6), (6, 2, 1)])


class PointsTest(unittest.TestCase):
    def setUp(self):
        self.rng = random.Random(11)

    def use(self, mesh, **how):
        """mesh: (points, polygons)"""
        self.model = forge.Model(*models.triangles(mesh), **how)
        self.bytes, self.mesh = self.model.encode(), forge.mesh_of(self.model)
        return self

    def plan(self, *points, decimals="nearest", winding=True):
        """The true plan of these points."""
        return points_forge.true_plan(self.mesh, points, self.rng, decimals, winding)

    def ask(self, plan, answers=None, skip=None):
        files = self.bytes, plan.certificate(self.bytes, self.model)
        answers = plan.answers() if answers is None else answers
        return vc.check(*files, answers) if skip is None else vc._check(*files, frozenset(skip), answers)

    def says(self, expected, plan, answers=None):
        code, message = self.ask(plan, answers)
        self.assertEqual(attacks.condition_of(code, message), expected, (message, plan.answers()[:400]))
        return message

    def alone(self, condition, plan, answers=None):
        """The condition, and no other one, rejects the certificate."""
        self.says(condition, plan, answers)
        self.assertEqual(self.ask(plan, answers, (condition,))[0], 0)

    def text_says(self, expected, answers, **statement):
        """These bytes as the answers file of an otherwise true plan without lines."""
        self.says(expected, Plan(self.mesh, ()).copy(claimed_answers=answers, values=statement), answers)


# ---------------------------------------------------------------- the oracle

def angle(a, b, c):
    """The solid angle of a triangle seen from the origin, divided by 4 pi."""
    x, y, z = (math.hypot(*p) for p in (a, b, c))
    volume = forge.dot(a, forge.cross(b, c))
    return math.atan2(volume, x * y * z + forge.dot(a, b) * z + forge.dot(b, c) * x + forge.dot(c, a) * y) / (2 * math.pi)


class Oracle(PointsTest):
    def test_it_agrees_with_the_sum_of_solid_angles(self):
        found = set()
        for seed in range(60):
            rng = random.Random(seed)
            self.use(points_forge.chain(rng) if seed % 2 else solids.box(rng))
            sizes = [max(c) for c in zip(*self.mesh.floats)]
            for _ in range(30):
                point = [rng.uniform(-.1, 1.1) * size for size in sizes]
                corners = [[[float(c) for c in p] for p in t] for t in points_forge.around(self.mesh, point)]
                if any(forge.dot(n, n) and abs(forge.dot(t[0], n)) < 1e-3 * math.hypot(*n) * max(math.hypot(*p) for p in t)
                       for t in corners for n in [forge.cross(forge.sub(t[1], t[0]), forge.sub(t[2], t[0]))]):
                    continue                              # too near a plane for numbers with 53 bits
                total = sum(angle(*t) for t in corners if any(forge.cross(forge.sub(t[1], t[0]), forge.sub(t[2], t[0]))))
                self.assertAlmostEqual(total, points_forge.winding(self.mesh, point), 6)
                found.add(round(total))
        self.assertLessEqual({-1, 0, 1, 2}, found)

    def test_points_of_a_hull_are_its_weighted_sums(self):
        rng = random.Random(3)
        for _ in range(300):
            a, b, c = ([rng.randint(-2, 2) for _ in range(3)] for _ in range(3))
            w = [rng.randint(0, 3) for _ in range(3)]
            if any(w):
                at = [w[0] * x + w[1] * y + w[2] * z for x, y, z in zip(a, b, c)]
                self.assertTrue(points_forge.has_origin(*([sum(w) * x - y for x, y in zip(p, at)] for p in (a, b, c))))
            n = [4 * x + y + z for x, y, z in zip(a, b, c)]
            k = max(range(3), key=lambda i: max(abs(p[i]) for p in (a, b, c)))
            if n[k]:
                far = [x + 9 * n[k] * (i == k) for i, x in enumerate(a)]     # beyond the box of the three
                self.assertFalse(points_forge.has_origin(*(forge.sub(p, far) for p in (a, b, c))))


# ---------------------------------------------------------------- true answers

class Accepted(PointsTest):
    def every_hint(self, plan):
        """Every direction of every point, and every triangle on which it lies."""
        for number, line in enumerate(plan.lines):
            hints = range(6) if line.is_off() else points_forge.triangles_at(self.mesh, line.point(plan.decimals)) if line.word == "on" else ()
            for code in hints:
                self.says("ACCEPT", plan.with_line(number, code=code))

    def test_solids_and_other_closed_chains(self):
        meshes = [row[0] for row in models.SOLIDS.values()]
        meshes += [TWIST, models.turned(SHELL), DOUBLE, FLAT, models.CROSSED, *(models.BROKEN[rule] for rule in (6, 8, 9))]
        words = set()
        for mesh in meshes:
            self.use(mesh)
            plan = self.plan(*points_forge.interesting(self.mesh, self.rng, 25))
            words |= {line.word + line.f for line in plan.lines}
            self.assertEqual(self.ask(plan), (0, "ACCEPT points-1"))
            self.every_hint(self.plan(*points_forge.interesting(self.mesh, self.rng, 4)))
        self.assertLessEqual({"on-", "--1", "-0", "-1"}, words)

    def test_random_chains_and_points(self):
        for seed in range(150):
            rng = random.Random(seed)
            mesh = points_forge.chain(rng) if seed % 3 else solids.solid(rng)
            if len(mesh[1]) < 120:
                self.use((solids.affine(mesh[0], rng), mesh[1]), fmt=rng.choice(forge.FORMATS), as_indexed=seed % 4 == 0, variant=seed % 3)
                points = points_forge.interesting(self.mesh, rng, 10)
                self.says("ACCEPT", self.plan(*points, decimals=("nearest", "exact")[seed % 2], winding=seed % 5 > 1))

    def test_rays_through_vertices_along_edges_and_in_faces(self):
        """The lines along the axes through these points meet vertices, whole edges and whole faces; some of the points are in the planes of
        faces and on the lines of edges."""
        grid = [Fraction(k, 2) for k in range(-2, 5)]
        for mesh in (CUBE, OCTAHEDRON, TET, FLAT, DOUBLE):
            self.use(mesh)
            plan = self.plan(*itertools.product(grid, repeat=3))
            for directions in (*([k] * 6 for k in range(6)), range(6)):
                turned = plan.copy()
                for number, line in enumerate(plan.lines):
                    if line.is_off():
                        turned.lines[number] = line.changed(code=directions[number % 6])
                self.says("ACCEPT", turned)

    def test_what_the_words_say_of_a_cube(self):
        self.use(CUBE)
        for point, word in (((HALF, HALF, HALF), "in"), ((THIRD, THIRD, 1), "on"), ((0, 0, THIRD), "on"), ((1, 1, 1), "on"), ((2, 0, 0), "out"),
                            ((THIRD, THIRD, Fraction(2 ** 80 + 1, 2 ** 80)), "out"), ((THIRD, THIRD, Fraction(2 ** 80 - 1, 2 ** 80)), "in")):
            self.assertEqual(self.plan(point, winding=False).lines[0].word, word)
            self.says("ACCEPT", self.plan(point, winding=False))

    def test_winding_numbers(self):
        for mesh, point, f in ((DOUBLE, (.125, .125, .125), 2), (models.turned(DOUBLE), (.125, .125, .125), -2), (ONION, (.5, .5, .5), 1), (SHELL, (.5, .5, .5), 0),
                               (models.join(*[models.turned(CUBE)] * 12), (.5, .5, .5), -12)):
            plan = self.use(mesh).plan(point)
            self.assertEqual(plan.lines[0].f, str(f))
            self.every_hint(plan)

    def test_a_triangle_without_area_holds_the_points_of_its_segment(self):
        self.use(FLAT)
        for point, on in (((2, 0, 0), {8, 9, 10}), ((1.5, 0, 0), {8, 9}), ((.5, .5, 0), {0, 3, 4, 5, 11, 12}), ((2.5, 0, 0), set())):
            self.assertLessEqual({f for f in on if f >= 8}, set(points_forge.triangles_at(self.mesh, point)))
            self.every_hint(self.plan(point))
            for f in set(range(len(self.mesh.tris))) - set(points_forge.triangles_at(self.mesh, point)):
                self.says("P2", Plan(self.mesh, [Line([repr(float(c)) for c in point], "on", "-", "-", f)]))
        self.alone("P3", Plan(self.mesh, [points_forge.off_line(("1.5", "0", "0"), 0, "-", 4, True)], with_winding=True))

    def test_no_line_and_undecided_lines(self):
        self.use(TET)
        self.says("ACCEPT", self.plan())
        line = Line(("1/3", "-0", ".5e1"), "undecided", "-", "-", None)
        self.says("ACCEPT", Plan(self.mesh, [line] * 3))
        self.says("ACCEPT", Plan(self.mesh, [line, *self.plan((0, 0, 0)).lines, line], with_winding=True))

    def test_every_format(self):
        for writer, (fmt, write) in models.WRITERS.items():
            with self.subTest(writer):
                self.model = models.File(write(CUBE), fmt)
                self.bytes, self.mesh = self.model.encode(), forge.mesh_of(self.model)
                self.says("ACCEPT", self.plan((.5, .25, .125), (0, 0, 0), (2, 2, 2)))


# ---------------------------------------------------------------- lies

class Conditions(PointsTest):
    def test_p1_alone(self):
        for mesh in (models.OPEN, models.BROKEN[2], models.BROKEN[4], models.BROKEN[5], (TET[0], TET[1] + [TET[1][0]])):
            self.use(mesh)
            self.alone("P1", Plan(self.mesh, ()))
            self.alone("P1", Plan(self.mesh, [points_forge.off_line(("9", "9", "9"), 0, "-", 0, True)], with_winding=True))
        apart = TET[0] + [TET[0][0]], TET[1][:3] + [(1, 2, 3)]
        apart[1][0] = (4, 2, 1)
        self.says("ACCEPT", self.use(apart).plan((9, 9, 9)))
        self.alone("P1", self.use(apart, as_indexed=True).plan((9, 9, 9)))

    def test_p1_counts_each_direction_of_an_edge(self):
        for extra, closed in (([(0, 0, 1)], True), ([(1, 0, 1)], True), ([(2, 2, 2)], True), ([(0, 1, 2), (2, 1, 0)], True), ([(0, 1, 2), (0, 1, 2)], False),
                              ([(0, 1, 2), (0, 2, 1), (0, 1, 2)], False), ([(0, 1, 2), (1, 2, 0), (2, 1, 0), (1, 0, 2)], True)):
            self.use((TET[0], TET[1] + extra))
            self.assertEqual(points_forge.is_closed(self.mesh), closed)
            self.says("ACCEPT" if closed else "P1", Plan(self.mesh, ()))

    def test_p1_names_an_edge_that_does_not_occur_as_often_as_its_reverse(self):
        rng = random.Random(4)
        for _ in range(60):
            points, tris = points_forge.chain(rng)
            tris = tris[:-1] + rng.choice(([], [tris[-1][::-1]], [tris[-1]] * 2))
            self.use((points, tris), as_indexed=True)
            if not points_forge.is_closed(self.mesh):
                message = self.says("P1", Plan(self.mesh, ()))
                a, b, c, d = map(int, re.search(r"\((\d+), (\d+)\) and \((\d+), (\d+)\)", message).groups())
                edges = [(t[i], t[(i + 1) % 3]) for t in self.mesh.tris for i in range(3)]
                self.assertEqual((a, b), (d, c))
                self.assertNotEqual(edges.count((a, b)), edges.count((b, a)), message)

    def test_lines_after_an_undecided_one_are_tested(self):
        self.use(CUBE)
        undecided = Line(("5", "5", "5"), "undecided", "-", "-", None)
        for condition, lie in (("P2", Line(("2", "0", "0"), "on", "-", "-", 0)), ("P3", points_forge.off_line(("0", "0", "0"), 0, "-", 0, True)),
                               ("P4", points_forge.off_line(("1/2", "1/3", "1/3"), 0, "-", 0, True))):
            for before, after in ((1, 0), (2, 1), (1, 2)):
                self.says(condition, Plan(self.mesh, [undecided] * before + [lie] + [undecided] * after, with_winding=True))

    def test_p2_alone(self):
        self.use(CUBE)
        for point in ((HALF, THIRD, 0), (0, 0, 0), (HALF, HALF, 1), (1, THIRD, 1)):
            plan = self.plan(point)
            on = points_forge.triangles_at(self.mesh, point)
            for f in set(range(12)) - set(on):
                self.alone("P2", plan.with_line(0, code=f))
        for point in ((HALF, HALF, HALF), (2, 0, 0), (HALF, HALF, Fraction(-1, 2 ** 90))):
            for f in range(12):
                self.alone("P2", self.plan(point).with_line(0, word="on", f="-", code=f))

    def test_p3_alone(self):
        """Points on vertices, edges and faces, answered with the number that the checker's ray finds if it may."""
        for mesh in (CUBE, TET, OCTAHEDRON, DOUBLE):
            self.use(mesh)
            points = [*self.mesh.floats, *([sum(p[k] for p in t) / len(t) for k in range(3)] for t in
                                           (edge for f in self.mesh.tris for c in [[self.mesh.floats[v] for v in f]] for edge in (c[:2], c[1:])))]
            for point in points:
                accepted = set()
                for f, direction in itertools.product(range(-2, 3), range(6)):
                    plan = Plan(self.mesh, [points_forge.off_line([repr(c) for c in point], f, "-", direction, True)], with_winding=True)
                    self.says("P3", plan)
                    if self.ask(plan, None, ("P3",))[0] == 0:
                        accepted.add(direction)
                self.assertEqual(accepted, set(range(6)), point)

    def test_p4_alone(self):
        self.use(DOUBLE)
        for point in ((.125, .125, .125), (1, 1, 1), (-1, 0, 0), (.25, .25, -1)):
            plan = self.plan(point)
            true = int(plan.lines[0].f)
            for f, direction in itertools.product({-true, true + 1, true - 1, true + 2, true + 256, 4294967296, -9999999999} - {true}, range(6)):
                self.alone("P4", plan.with_line(0, f=str(f), code=direction))
        self.use(CUBE)
        self.alone("P4", self.plan((.5, .5, .5), winding=False).with_line(0, word="out", f="0"))
        self.alone("P4", self.plan((.5, .5, -.5), winding=False).with_line(0, word="in", f="1"))

    def test_the_first_failure_is_named(self):
        self.use(CUBE)
        good, p2, p3, p4 = [*self.plan((2, 2, 2)).lines, Line(("2", "0", "0"), "on", "-", "-", 0),
                            points_forge.off_line(("0", "0", "0"), 3, "-", 0, True), points_forge.off_line(("1/3", "1/3", "1/3"), 0, "-", 0, True)]
        for lines in itertools.permutations((good, p2, p3, p4)):
            first = next(line for line in lines if line is not good)
            expected = {id(p2): "P2", id(p3): "P3", id(p4): "P4"}[id(first)]
            message = self.says(expected, Plan(self.mesh, lines, with_winding=True))
            self.assertRegex(message, "line %d: the (point|winding number) is " % (lines.index(first) + 1))
        self.use(models.OPEN)
        plan = Plan(self.mesh, [p2, p4], with_winding=True)
        self.says("P1", plan)
        self.says("B1", plan.copy(extra=b"\0"))
        self.says("A2", plan.copy(extra=b"\0", values={"on": 0}))
        self.says("A1", plan.copy(extra=b"\0", values={"on": 0}), plan.answers() + b"x")
        self.says("S1", plan.copy(values={"on": "1"}), b"x")

    def test_a1_alone(self):
        plan = self.use(TET).plan((1, 1, 1), (0, 0, 0))
        self.alone("A1", plan, plan.with_line(0, shell="5").answers())
        self.alone("A1", plan, plan.with_line(0, tokens=("2/2", "1", "1")).answers())
        self.alone("A1", plan.copy(values={"answers_bytes": len(plan.answers()) + 1}))
        self.alone("A1", plan.copy(values={"answers_sha256": "0" * 64}))
        for answers in (b"", plan.answers()[:-1], plan.answers() + b"\n", plan.answers() * 2):
            self.says("A1", plan, answers)

    def test_a2_alone(self):
        plan = self.use(TET).plan((1, 1, 1), (0, 0, 0), (0, 0, .5), (2, 2, 2))
        plan.lines.append(Line("123", "undecided", "-", "-", None))
        self.says("ACCEPT", plan)
        for key, true in (("points", 5), ("on", 2), ("undecided", 1)):
            for wrong in (true - 1, true + 1, 0, 2 ** 64 - 1):
                self.alone("A2", plan.copy(values={key: wrong}))

    def test_s1(self):
        plan = self.use(TET).plan((1, 1, 1))
        for key in ("answers_sha256", "answers_bytes", "decimals", "winding", "points", "on", "undecided"):
            for value in (None, "", "x", [], -1, *((0, 1) if key in ("winding", "decimals", "answers_sha256") else (True, "1"))):
                self.says("S1", plan.copy(values={key: value}))
        for word in ("Nearest", "nearest ", "exactly", "nearest|exact", True):
            self.says("S1", plan.copy(values={"decimals": word}))
        self.says("S1", plan.copy(values={"answers_sha256": plan.quantities()["answers_sha256"].upper()}))
        self.says("S1", plan.copy(values={"faces": 4}))
        head, _, body = plan.certificate(self.bytes, self.model).partition(b"\n")
        for key in ("on", "decimals", "answers_bytes"):
            value = plan.quantities()[key]
            member = (',"%s":%s' % (key, '"%s"' % value if isinstance(value, str) else value)).encode()
            self.assertIn(member, head)
            self.assertEqual(vc.check(self.bytes, head.replace(member, b"") + b"\n" + body, plan.answers())[1][:9], "REJECT S1")


class Bodies(PointsTest):
    def body_says(self, expected, plan, body):
        """The plan's certificate with another body."""
        head = dict(plan.quantities())
        cert = forge.certificate(self.bytes, self.model, "points-1", body, head)
        code, message = vc.check(self.bytes, cert, plan.answers())
        self.assertEqual(attacks.condition_of(code, message), expected, message)

    def test_b1(self):
        self.use(models.join(*[CUBE] * 12))               # 144 triangles: numbers of two bytes
        on = points_forge.triangles_at(self.mesh, (0, 0, 0))
        plan = self.plan((.5, .5, .5), (0, 0, 0), (2, 2, 2)).with_line(1, code=on[-1])
        body = plan.body()
        self.assertEqual(body[20:], bytes([plan.lines[0].code, on[-1] - 128 | 128, 1, plan.lines[2].code]))
        self.body_says("ACCEPT", plan, body)
        start, end = body[:21], body[23:]
        wrong = [*(body[:n] for n in range(len(body))), body + b"\0", b"VTMV" + body[4:], b"VTPU" + body[4:]]
        wrong += [body[:k] + bytes([body[k] ^ bit]) + body[k + 1:] for k in range(4, 20) for bit in (1, 128)]
        wrong += [start + code + end for code in (b"\x90\1", b"\x8e\x81\0", b"\x80\0", b"\0\0", b"\xff" * 9 + b"\1", b"\xff" * 9 + b"\2", b"\x80" * 9 + b"\1", b"\x80" * 40, b"\x8e\x80\x01")]
        wrong += [body[:20] + bytes([code]) + body[21:] for code in (6, 7, 128, 255)] + [body[:-1] + b"\6"]
        for lie in wrong:
            self.body_says("B1", plan, lie)
        for f in on:
            self.body_says("ACCEPT", plan, start + forge.varint(f) + end)

    def test_undecided_points_have_no_bytes(self):
        self.use(TET)
        plan = Plan(self.mesh, [Line("123", "undecided", "-", "-", None)] * 2)
        self.assertEqual(len(plan.body()), 20)
        self.says("ACCEPT", plan)
        self.says("B1", plan.copy(extra=b"\0"))

    def test_a_body_without_its_codes_is_not_searched_for_them(self):
        """The numbers of the body and of the statement are huge; the files are small."""
        plan = self.use(TET).plan((2, 2, 2))
        self.says("A2", plan.copy(values={"points": 2 ** 63}))
        self.body_says("B1", plan, plan.body()[:12] + b"\xff" * 8 + plan.body()[20:])

    def test_the_work_bound(self):
        """2000 triangles whose boxes all hold 20 points are as much work as may be; the box of one more holds some of the points."""
        near, far = ("1/8", "1/8", "1/16"), ("-1/8", "-1/8", "-1/16")
        copies = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)] * 500
        for extra, twenty, expected in (([], (20, 0), "ACCEPT"), ([(4, 4, 5)], (10, 10), "ACCEPT"), ([(4, 4, 5)], (11, 9), "B1"), ([(4, 5, 4)], (0, 20), "ACCEPT"),
                                        ([], (21, 0), "B1"), ([(4, 4, 5)], (20, 0), "B1")):
            self.use((REGULAR[0] + [(0, 0, 0), (.5, .5, .25)], copies + extra))
            lines = [points_forge.off_line(at, 500, "-", 3, True) for at, n in zip((near[:2] + ("1/17",), far), twenty) for _ in range(n)]
            plan = Plan(self.mesh, lines, "exact", True)
            self.says(expected, plan)
            if expected == "B1":
                self.assertEqual(self.ask(plan, None, ("B1",))[0], 0)

    def test_points_on_triangles_are_work(self):
        """Twenty points in the boxes of all 2999 triangles and ten points on a triangle are as much work as may be."""
        copies = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)] * 749 + [(4, 4, 5)] * 3
        near, far = ("1/8", "1/8", "1/17"), ("1/8", "1/8", "-1/17")
        lines = [Line(("1", "1", "1"), "on", "-", "-", 0)] * 10
        for extra, beside, expected in (([], 0, "ACCEPT"), ([(6, 6, 7)], 10, "ACCEPT"), ([(6, 6, 7)], 9, "B1")):
            self.use((REGULAR[0] + [(0, 0, -.5), (.5, .5, .25), (0, 0, 0), (.5, .5, .25)], copies + extra), as_indexed=True)
            off = [points_forge.off_line(at, 749, "-", 3, True) for at, n in ((near, 20 - beside), (far, beside)) for _ in range(n)]
            self.says(expected, Plan(self.mesh, off + lines, "exact", True))

    def test_the_work_bound_comes_before_other_conditions(self):
        self.use((REGULAR[0], ([(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)] * 500)[:-1]))
        lines = [points_forge.off_line(("1/8", "1/8", "1/16"), 7, "-", 3, True)] * 21
        self.says("P1", Plan(self.mesh, lines[:20], "exact", True))
        self.says("B1", Plan(self.mesh, lines, "exact", True))


class Boxes(PointsTest):
    def test_the_tree_finds_the_triangles_of_section_5(self):
        rng = random.Random(5)
        for seed in range(60):
            mesh = self.use(points_forge.chain(rng) if seed % 2 else solids.voxels(rng)).mesh
            tree = box_tree.BoxTree(list(box_tree.boxes_of_triangles(mesh.p, mesh.tris)))
            for point in points_forge.interesting(mesh, rng, 8):
                q = [c / mesh.unit for c in point]
                for direction in range(6):
                    u = direction // 2
                    p, s = (u + 1) % 3, (u + 2) % 3
                    touched = [f for f, box in enumerate(mesh.box) if all(low <= c <= high for c, (low, high) in zip(q, box))]
                    ahead = [f for f, box in enumerate(mesh.box) if box[p][0] <= q[p] < box[p][1] and box[s][0] <= q[s] < box[s][1] and
                             (box[u][0] <= q[u] if direction % 2 else box[u][1] >= q[u])]
                    found = tree.near([math.floor(c) for c in q], [math.ceil(c) for c in q], direction)
                    self.assertEqual((sorted(found[0]), sorted(found[1]), found[2]), (touched, ahead, len(set(touched + ahead))))


# ---------------------------------------------------------------- coordinates and lines

TINY = Fraction(1, 2 ** 1074)
TOKENS = {  # valid: (nearest, exact)
    "0": (0, 0), "-0": (0, 0), "+0.0": (0, 0), ".0": (0, 0), "0.": (0, 0), "1.": (1, 1), ".5": (HALF, HALF), "-.5": (-HALF, -HALF), "+1e1": (10, 10),
    "1E+1": (10, 10), "1.5e-1": (Fraction(0.15), Fraction(3, 20)), "007": (7, 7), "0.1": (Fraction(0.1), Fraction(1, 10)), "1e23": (Fraction(1e23), 10 ** 23),
    "9007199254740993": (2 ** 53, 2 ** 53 + 1), "9007199254740995": (2 ** 53 + 4, 2 ** 53 + 3), "9007199254740993.0000000000000000001": (2 ** 53 + 2, 2 ** 53 + 1 + Fraction(1, 10 ** 19)),
    "4.9406564584124654e-324": (TINY, Fraction("4.9406564584124654e-324")), "2.4703282292062327e-324": (0, Fraction("2.4703282292062327e-324")),
    "2.4703282292062328e-324": (TINY, Fraction("2.4703282292062328e-324")), "2.2250738585072011e-308": ((2 ** 52 - 1) * TINY, Fraction("2.2250738585072011e-308")),
    "2.2250738585072012e-308": (2 ** 52 * TINY, Fraction("2.2250738585072012e-308")),
    "1.7976931348623158e308": (2 ** 1024 - 2 ** 971, 17976931348623158 * 10 ** 292), "1e-4096": (0, Fraction(1, 10 ** 4096)), "0e4096": (0, 0),
    "1e-0004096": (0, Fraction(1, 10 ** 4096)), "0." + "0" * 400 + "1e401": (1, 1), "1" + "0" * 400 + "e-400": (1, 1), "0" * 4095 + "1": (1, 1),
    "1." + "0" * 4094: (1, 1), "0x1p0": (1, 1), "0X1P+0": (1, 1), "-0x.8p1": (-1, -1), "0x8.p-3": (1, 1), "+0xA.fp0": (Fraction(175, 16),) * 2, "0x0p-4096": (0, 0),
    "0x1p4096": (2 ** 4096,) * 2, "0x1p-4096": (Fraction(1, 2 ** 4096),) * 2, "0x1p-0004096": (Fraction(1, 2 ** 4096),) * 2, "0x1.00000000000008p0": (1 + Fraction(1, 2 ** 53),) * 2,
    "0x" + "f" * 4092 + "p0": (16 ** 4092 - 1,) * 2, "1/3": (THIRD,) * 2, "-2/6": (-THIRD,) * 2, "+4/012": (THIRD,) * 2, "0/7": (0, 0), "-0/1": (0, 0),
    "1/" + "9" * 4094: (Fraction(1, 10 ** 4094 - 1),) * 2, "9" * 4094 + "/1": (10 ** 4094 - 1,) * 2}
NEAREST_ONLY = {"0e99999999999999999999": 0, "1e-4097": 0, "1e-99999999999999999999": 0, "-1e-400000": 0, "0.1e0000000000000000000001": 1, "0e-4097": 0}
NEVER_NEAREST = ("1e400", "-1e400", "1e309", "1.7976931348623159e308", "2e308", "1e4096", "9" * 4096)
NEITHER = ("", ".", "+", "-", "e1", ".e1", "1e", "1e+", "--1", "+-1", "1,5", "1_0", "1d0", "1.2.3", "1e1.5", "nan", "inf", "-inf", "Infinity", "1f", "0x", "0x1", "0xp1", "0x.p1", "0x1p",
           "0x1p+", "0x1.8", "0x1e5", "x1p0", "0x1P1.5", "0xgp0", "0x1p4097", "0x1p-4097", "0x0p99999999999999999999", "0x1p0x1", "1x", "--0x1p0", "0x-1p0", "1/0", "1/00", "0/0", "1/-2", "1/+2", "/2", "1/",
           "1/2/3", "1.0/2", "1e1/2", "0x1/2", "1//2", "1p0", "\u0661", "\uff11", "1\u00a0", "1\0", "0" * 4096 + "1", "1/" + "9" * 4095, "0x" + "f" * 4093 + "p0", "\"1\"", "1;")
EXACT_FAR = ("1e4097", "0e4097", "0e-4097", "1e99999999999999999999", "1e-99999999999999999999")


class Coordinates(PointsTest):
    def assert_token(self, token, decimals, value):
        """value: None if it is not allowed."""
        try:
            n, d = points_answers.coordinate(token.encode(), decimals == "nearest")
            found = Fraction(n, d)
            self.assertGreater(d, 0)
        except points_answers.NotAllowed:
            found = None
        self.assertEqual(found, value, (token[:60], decimals))

    def test_tokens_and_what_they_mean(self):
        for token, values in TOKENS.items():
            for decimals, value in zip(("nearest", "exact"), values):
                self.assert_token(token, decimals, value)
                self.assertEqual(points_forge.meaning(token, decimals), value, token[:60])
        for token, value in NEAREST_ONLY.items():
            self.assert_token(token, "nearest", value)
        for token in NEVER_NEAREST:
            self.assert_token(token, "nearest", None)
            self.assert_token(token, "exact", Fraction(token) if len(token) < 4000 else 10 ** 4096 - 1)
        for token in NEITHER:
            self.assert_token(token, "nearest", None)
            self.assert_token(token, "exact", None)
        for token in EXACT_FAR:
            self.assert_token(token, "exact", None)
        self.assert_token("0.1e0000000000000000000001", "exact", 1)

    def test_a_tie_with_the_first_number_beyond_all_is_infinite(self):
        tie = 2 ** 1024 - 2 ** 970
        for sign in ("", "-"):
            self.assert_token(sign + str(tie), "nearest", None)
            self.assert_token(sign + str(tie - 1), "nearest", (2 ** 1024 - 2 ** 971) * (-1 if sign else 1))
            self.assert_token(sign + str(tie - 1) + "." + "9" * 700, "nearest", (2 ** 1024 - 2 ** 971) * (-1 if sign else 1))

    def test_random_decimals_round_to_the_nearest_number(self):
        rng = random.Random(2)
        for _ in range(3000):
            kind = rng.random()
            if kind < .4:                                 # halfway between two numbers, or a hair beside
                number = Fraction(math.ldexp(rng.randrange(1, 2 ** rng.choice((1, 3, 53))), rng.choice((rng.randint(-1080, -1020), rng.randint(-60, 60)))))
                step = points_forge.nearest(number * (1 + Fraction(1, 2 ** 52))) - number or TINY
                value = number + step / 2 + step * rng.choice((0, 0, Fraction(1, 10 ** 30), -Fraction(1, 10 ** 30)))
                token = points_forge.decimal_text(value)
            else:
                token = "%d.%de%d" % (rng.randrange(10 ** rng.randint(1, 20)), rng.randrange(10 ** 20), rng.randint(-345, 310))
            if len(token) <= 4096:
                self.assert_token(token, "nearest", points_forge.meaning(token, "nearest"))
                self.assert_token(token, "exact", points_forge.meaning(token, "exact"))

    def test_tokens_in_a_file(self):
        """Each of the valid tokens, off a small cube and on a degenerate triangle through its number if that is a number of the file."""
        for decimals, k in (("nearest", 0), ("exact", 1)):
            self.use(CUBE)
            for token, values in TOKENS.items():
                for place in range(3):
                    tokens = ["1/2"] * 3
                    tokens[place] = token
                    point = [HALF] * 3
                    point[place] = Fraction(values[k])
                    line = points_forge.true_line(self.mesh, point, self.rng, decimals, True, tokens)
                    self.says("ACCEPT", Plan(self.mesh, [line], decimals, True))
            for token in NEITHER:
                if token.isascii():
                    line = "1 %s 1 - 0 -\n" % token
                    self.text_says("A2", line.encode(), decimals=decimals, winding=True, points=1)

    def test_what_decimals_mean_decides(self):
        self.use(([(0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1), (0.3, 0.3, 0.3)], TET[1]))
        for point in self.mesh.floats:
            tokens = [repr(c) for c in point]
            plan = Plan(self.mesh, [points_forge.true_line(self.mesh, point, self.rng, "nearest", True, tokens)], "nearest", True)
            self.assertEqual(plan.lines[0].word, "on")
            self.says("ACCEPT", plan)
            self.alone("P2", plan.copy(decimals="exact"))
            exact = points_forge.true_line(self.mesh, [Fraction(c) for c in tokens], self.rng, "exact", True, tokens)
            self.says("ACCEPT", plan.copy(decimals="exact", lines=[exact]))
            self.says("P3", plan.copy(lines=[exact]))


class Lines(PointsTest):
    GOOD = {True: ("0 0 0 on - -", "1/3 1/9 1/9 - 1 0", "2 2 2 - 0 4294967295", "9 9 9 undecided - -", "1/3 1/9 1/9 - 1 9999999999", "2 2 2 - 0 -"),
            False: ("0 0 0 on - 7", "1/3 1/9 1/9 in 1 0", "2 2 2 out 0 -", "9 9 9 undecided - -", "2 2 2 out 0 12")}
    BAD = {True: ("2 2 2 in 1 -", "2 2 2 out 0 -", "2 2 2 - - -", "2 2 2 - 00 -", "2 2 2 - -0 -", "2 2 2 - +0 -", "2 2 2 - 0.0 -", "2 2 2 - 12345678901 -", "2 2 2 - -12345678901 -", "2 2 2 - 01 -", "2 2 2 - --1 -",
                  "2 2 2 - 0x0 -", "2 2 2 -- 0 -", "2 2 2  0 -"),
           False: ("2 2 2 - 0 -", "2 2 2 out 1 -", "2 2 2 in 0 -", "2 2 2 in - -", "2 2 2 out - -", "2 2 2 out 00 -", "2 2 2 out -0 -", "2 2 2 IN 1 -", "2 2 2 inside 1 -", "2 2 2 out  -", "2 2 2 in 2 -", "2 2 2 in -1 -"),
           None: ("", " ", "0 0 0 on -", "0 0 0 on - - -", "0 0 0 on - - ", " 0 0 0 on - -", "0  0 0 on - -", "0 0 0 on -  -", "0\t0 0 on - -", "0 0 0 on - -\r", "0 0 0 on - -\0", "\ufeff0 0 0 on - -", "0 0 0 on 0 -",
                  "0 0 0 on -1 -", "0 0 0 on - -1", "0 0 0 on - 00", "0 0 0 on - 01", "0 0 0 on - +1", "0 0 0 on - 12345678901", "0 0 0 on - --", "0 0 0 on - x", "0 0 0 ON - -", "0 0 0 On - -", "0 0 0 undecided - 0",
                  "0 0 0 undecided 0 -", "0 0 0 undecided -1 -", "0 0 0 Undecided - -", "0 0 0 maybe - -", "x 0 0 on - -", "0 x 0 on - -", "0 0 x on - -", "nan 0 0 undecided - -", "0 0 1/0 undecided - -", "0 0 on - -",
                  "0 0 0 0 on - -", "# 0 0 on - -", "0,0,0,on,-,-", "0 0 0 on - 1 ", "0\u00a00 0 on - -", "0 0 0 on - \u0661")}

    def plan_of(self, winding):
        self.use(TET)
        lines = [text.split() for text in self.GOOD[winding]]
        return Plan(self.mesh, [Line(t[:3], *t[3:], None if t[3] == "undecided" else 0) for t in lines], with_winding=winding)

    def test_good_lines(self):
        for winding in (True, False):
            plan = self.plan_of(winding)
            self.assertEqual(plan.answers().decode(), "".join(line + "\n" for line in self.GOOD[winding]))
            self.says("ACCEPT", plan)

    def test_each_bad_line_at_each_place(self):
        for winding in (True, False):
            plan = self.plan_of(winding)
            lines = [line + "\n" for line in self.GOOD[winding]]
            for bad in (*self.BAD[winding], *self.BAD[None]):
                for place in (0, 2, len(lines)):
                    answers = "".join([*lines[:place], bad + "\n", *lines[place:]]).encode()
                    counts = {key: n + (word in bad) for key, n, word in (("on", plan.quantities()["on"], " on "), ("undecided", 1, "undecided"))}
                    message = self.says("A2", plan.copy(claimed_answers=answers, values={"points": len(lines) + 1, **counts}), answers)
                    self.assertIn("line %d: " % (place + 1), message)

    def test_ends_of_lines(self):
        plan = self.plan_of(True)
        true = plan.answers()
        for answers, points in ((true[:-1], 6), (true[:-1], 5), (true.replace(b"\n", b"\r\n"), 6), (true.replace(b"\n", b"\r"), 0), (true + b"\n", 7), (b"\n" + true, 7), (true + b"\n", 6),
                                (true + b"x", 6), (true.replace(b"\n", b"\n\n"), 12), (b"\xef\xbb\xbf" + true, 6), (true[:-1] + b"\0", 6), (true.rstrip(b"-\n"), 5)):
            self.says("A2", plan.copy(claimed_answers=answers, values={"points": points}), answers)
        plan = self.plan_of(False)                        # whose last line ends with a number of two digits
        self.says("A2", plan.copy(claimed_answers=plan.answers()[:-1], values={"points": len(plan.lines) - 1}), plan.answers()[:-1])

    def test_the_flag_of_windings(self):
        for winding in (True, False):
            self.says("A2", self.plan_of(winding).copy(values={"winding": not winding}))
        plan = self.use(TET).plan((0, 0, 0))
        for winding in (True, False):
            self.says("ACCEPT", plan.copy(winding=winding))

    def test_random_changes_never_make_a_lie(self):
        """Answers that are true, and answers with a false line, with damaged bodies and damaged answers."""
        rng = random.Random(23)
        self.use(CUBE)
        points = points_forge.interesting(self.mesh, rng, 6)
        true = points_forge.true_plan(self.mesh, points, rng, "exact", True)
        number = next(i for i, line in enumerate(true.lines) if line.is_off())
        for plan, answers_are_true in ((true, True), (true.with_line(number, f="5"), False)):
            for _ in range(200):
                cert = forge.certificate(self.bytes, self.model, "points-1", mesh_test.damaged(plan.body(), rng, False), plan.quantities())
                self.assertIn(vc.check(self.bytes, cert, plan.answers())[0], (0, 1) if answers_are_true else (1,))
        for _ in range(300):
            answers = mesh_test.damaged(true.answers(), rng, False)
            plan = true.copy(claimed_answers=answers, values={"points": answers.count(b"\n")})
            code, message = self.ask(plan, answers)
            self.assertIn(code, (0, 1), message)
            if code == 0:
                self.assert_true(answers)

    def assert_true(self, answers):
        for text in answers.decode().splitlines():
            *tokens, word, f, _ = text.split(" ")
            on = points_forge.triangles_at(self.mesh, [points_forge.meaning(token, "exact") for token in tokens])
            self.assertEqual(bool(on), word == "on", text)
            if not on:
                self.assertEqual(int(f), points_forge.winding(self.mesh, [points_forge.meaning(token, "exact") for token in tokens]))


# ---------------------------------------------------------------- the program

class Program(PointsTest):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        plan = self.use(TET).plan((0, 0, 0), (2, 2, 2))
        certificates = mesh_test.CertificateTest()
        certificates.setUp()
        for name, data in (("model", self.bytes), ("cert", plan.certificate(self.bytes, self.model)), ("answers", plan.answers()), ("other", plan.answers() + b"x"),
                           ("valid_model", certificates.bytes), ("valid_cert", certificates.cert())):
            (self.folder / name).write_bytes(data)

    PROGRAM = [sys.executable, "-B", mesh_test.PROGRAM]

    def run_here(self, *names):
        """(exit code, text), after the text has gone where it belongs."""
        done = subprocess.run([*self.PROGRAM, *names], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr if done.returncode < 2 else done.stdout, "")
        return done.returncode, done.stdout + done.stderr

    def test_three_files(self):
        self.assertEqual(self.run_here("model", "cert", "answers")[0], 0)
        code, text = self.run_here("model", "cert", "other")
        self.assertEqual((code, text[:10]), (1, "REJECT A1:"))

    def test_a_third_file_is_needed_by_this_claim_and_by_no_other(self):
        for names, claim in ((("model", "cert"), "points-1"), (("valid_model", "valid_cert", "answers"), "mesh-valid-1")):
            code, text = self.run_here(*names)
            self.assertEqual((code, claim in text, text.count("\n")), (2, True, 1), text)
        self.assertEqual(self.run_here("valid_model", "valid_cert")[0], 0)

    def test_usage(self):
        for names in ((), ("model",), ("model", "cert", "answers", "answers"), ("model", "cert", "--claims")):
            self.assertEqual(self.run_here(*names)[0], 2)

    def test_answers_that_cannot_be_opened(self):
        os.mkfifo(self.folder / "fifo")
        for name in ("missing", ".", "fifo", "/dev/null"):
            code, text = self.run_here("model", "cert", name)
            self.assertEqual((code, text.count("\n")), (4, 1), text)

    def test_a_model_that_is_refused(self):
        plan = Plan(self.mesh, ())
        self.bytes = b"OFF\n0 0 0\n"
        self.assertEqual(self.ask(plan)[0], 4)


if __name__ == "__main__":
    unittest.main()
