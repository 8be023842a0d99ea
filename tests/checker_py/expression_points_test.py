#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Tests of docs/certificates/points.md, section 7: true words of expressions are accepted, and each condition rejects lies that break nothing
else. What is true says the oracle of expression_forge.py, or the hand of who wrote the test."""
import json
import random
import unittest
from fractions import Fraction as Q

import mesh_test                                          # says where the others are

attacks, vc = mesh_test.attacks, mesh_test.vc
import expression_forge as forge                          # noqa: E402
from veritope_checker.common.errors import Refused        # noqa: E402

RNG = random.Random(5)


def block(low, high):
    return forge.MeshSolid(forge.box_planes(low, high), *forge.box_mesh(low, high), random.Random(1), False)


def cube(low, size):
    part = forge.curved.cube().placed([Q(size, 2)] * 3, [c + Q(size, 2) for c in low])
    return forge.PatchSolid(forge.box_planes(low, [c + size for c in low]), part, random.Random(2))


LEFT, RIGHT, SMALL = block((0, 0, 0), (1, 1, 1)), block((1, 0, 0), (2, 1, 1)), block((0, 0, 0), (.5, .5, .5))
BOX, WIDE = ((-1, -1, -1), (3, 3, 3)), ((-4, -4, -4), (4, 4, 4))


class ExpressionTest(unittest.TestCase):
    def use(self, tree, box=BOX, **operands):
        self.chain = forge.Chain(tree, operands, {name: name.lower() for name in operands}, box)
        self.subject = forge.Subject(self.chain, False)
        return self

    def plan(self, *points):
        return forge.Plan(self.subject, [forge.true_line(self.subject, [Q(c) for c in q], RNG, "exact") for q in points], "exact")

    def line(self, q, word, *codes):
        return forge.Plan(self.subject, [forge.Line([str(c) for c in q], word, bytes(codes))], "exact")

    def ask(self, plan, model=None, files=None, skip=None):
        model = model or self.chain.data
        beside = "", forge.Files(self.chain.files() if files is None else files, Refused)
        given = model, plan.certificate(model, self.subject.as_indexed)
        return vc.check(*given, plan.answers(), beside) if skip is None else vc._check(*given, frozenset(skip), plan.answers(), beside)

    def says(self, expected, plan, **how):
        code, message = self.ask(plan, **how)
        self.assertEqual(attacks.condition_of(code, message), expected, message)
        return message

    def alone(self, condition, plan, **how):
        """The condition, and no other one, rejects the certificate."""
        self.says(condition, plan, **how)
        self.assertEqual(self.ask(plan, skip=(condition,), **how)[0], 0)


class Words(ExpressionTest):
    # PROVES POINT-6
    def test_walls_that_two_blocks_share(self):
        for tree, word in ((("|", "A", "B"), "in"), (("+", "A", "B"), "in"), (("&", "A", "B"), "out"), (("-", "A", "B"), "on"), (("-", "B", "A"), "on"),
                           (("&", "A", ("!", "B")), "on"), (("-", "A", "A"), "out")):
            operands = {name: {"A": LEFT, "B": RIGHT}[name] for name in forge.leaves_of(tree)}
            self.use(tree, **operands)
            self.assertEqual(self.subject.word((1, Q(1, 2), Q(1, 3))), word)
            self.says("ACCEPT", self.plan((1, Q(1, 2), Q(1, 3)), (1, 0, Q(1, 2)), (1, 1, 1), (Q(1, 2),) * 3, (2, 2, 2)))

    def test_sides_of_the_box(self):
        self.use(("|", ("!", "A"), "A"), A=LEFT)
        plan = self.plan((-1, 0, 0), (-1, -1, 0), (3, 3, 3), (0, 0, 0), (1, Q(1, 2), Q(1, 2)), (4, 0, 0))
        self.assertEqual([line.word for line in plan.lines], ["on", "on", "on", "in", "in", "out"])
        self.assertEqual([len(line.codes) for line in plan.lines[:3]], [0, 0, 0])
        self.says("ACCEPT", plan)

    def test_patches_are_flat_walls(self):
        for other in RIGHT, cube((1, 0, 0), 1):
            self.use(("|", "A", "B"), A=cube((0, 0, 0), 1), B=other)
            plan = self.plan((1, Q(1, 2), Q(1, 3)), (1, 0, Q(1, 2)), (1, 1, 1), (1, 0, 0), (0, 0, 0), (Q(1, 2),) * 3)
            self.assertEqual([line.word for line in plan.lines], ["in", "on", "on", "on", "on", "in"])
            self.says("ACCEPT", plan)

    # PROVES POINT-7.P
    def test_patches_around_a_pole(self):
        """The first corner of a box and the middle of its top, where patches are petals, at whichever side they are collapsed; others are not."""
        for seed in range(6):
            fans = forge.FanBox((0, 0, 0), (1, 1, 1), random.Random(seed), lambda face: ("fan", "corner", "plain", None)[(face + seed) % 4])
            for pole in fans.poles:
                other = cube(pole if seed % 2 else [c - 1 for c in pole], 1)
                for tree in ("|", "A", "B"), ("&", "A", "B"), ("-", "A", "B"), ("-", "B", "A"):
                    self.use(tree, box=WIDE, A=fans, B=other)
                    word = self.subject.word(pole)
                    codes = [bytes([forge.ON]) + RNG.choice(solid.places(pole)) for solid in (fans, other)]
                    codes = b"".join(codes if tree[1] == "A" else codes[::-1])
                    for said in ("in", "on", "out"):
                        self.says("ACCEPT" if said == word else "P5", self.line(pole, said, *codes))

    def test_a_file_in_a_file_is_beside_it(self):
        inner = forge.Chain(("-", "A", "B"), {"A": LEFT, "B": SMALL}, {"A": "parts/a", "B": "../b"}, BOX)
        self.chain = forge.Chain(("&", "X", ("!", "A")), {"X": inner, "A": SMALL}, {"X": "in/x.json", "A": "./b"}, ((-2, -2, -2), (4, 4, 4)))
        self.subject = forge.Subject(self.chain, False)
        files = {"in/x.json": inner.data, "in/parts/a": LEFT.data, "in/../b": SMALL.data}
        self.says("ACCEPT", self.plan((Q(1, 4),) * 3, (Q(3, 4),) * 3, (Q(1, 2), Q(1, 4), Q(1, 4))), files=files)

    def test_boxes_of_two_files_that_touch(self):
        for tree, word in ((("|", "X", "Y"), "in"), (("&", "X", "Y"), "out"), (("-", "X", "Y"), "on"), (("-", "Y", "X"), "on")):
            x = forge.Chain(("!", "A"), {"A": SMALL}, {"A": "s"}, BOX)
            y = forge.Chain(("!", "A"), {"A": block((4, 0, 0), (5, 1, 1))}, {"A": "t"}, ((3, -2, -2), (6, 3, 3)))
            self.use(tree, box=((-9,) * 3, (9,) * 3), X=x, Y=y)
            q = 3, Q(1, 2), Q(1, 2)
            self.assertEqual(self.subject.word(q), word)
            self.says("ACCEPT", self.plan(q, (3, 3, 3), (3, -1, 0), (-1, 0, 0), (5, 3, 3)), files=self.chain.files())

    def test_an_edge_on_a_face(self):
        # The edge of a wedge of B lies in the middle of a wedge of A's top.
        top = Q(1, 2), Q(1, 2), 1
        points = [(.5, 0, 1), (.5, 1, 1), (0, .5, 2), (1, .5, 2)]
        for a, b in ((0, 1), (1, 0)):
            tetrahedron = forge.MeshSolid([], points, forge.oriented(points), random.Random(1), False)
            operands = [LEFT, tetrahedron]
            codes = [bytes([forge.ON]) + solid.places(top)[0] for solid in operands]
            for op, word in ("&", "out"), ("|", "on"), ("-", "on"):
                self.use((op, "A", "B"), A=operands[a], B=operands[b])
                self.says("ACCEPT", self.line(top, word, *codes[a], *codes[b]))
                for other in {"in", "on", "out"} - {word}:
                    self.alone("P5", self.line(top, other, *codes[a], *codes[b]))

    def test_tetrahedra_with_a_common_vertex(self):
        rng = random.Random(3)
        for _ in range(60):
            operands = {}
            for name in "ABCD"[:rng.randint(2, 4)]:
                planes, points = forge.tetrahedron((2, 2, 2), rng.randint(1, 2), rng.randrange(3))
                move = forge.forge.sub((2, 2, 2), rng.choice(points))
                points = [tuple(a + b for a, b in zip(p, move)) for p in points]
                planes = [(n, c + forge.forge.dot(n, move)) for n, c in planes]
                operands[name] = forge.MeshSolid(planes, points, forge.oriented(points), rng, False)
            names = sorted(operands)
            while True:
                tree = forge.random_tree(rng, names, 3)
                if set(forge.leaves_of(tree)) == set(names):
                    break
            self.use(tree, box=((-9,) * 3, (9,) * 3), **operands)
            plan = self.plan((2, 2, 2), (2, 2, Q(5, 2)), (Q(5, 2), 2, 2), (Q(3, 2), 2, 2))
            self.says("ACCEPT", plan)
            if forge.ON in plan.lines[0].codes[:1]:
                for word in {"in", "on", "out"} - {plan.lines[0].word}:
                    self.says("P5", plan.with_line(0, word=word))

    def test_random_ones(self):
        for seed in range(25):
            rng = random.Random(seed)
            self.subject = forge.random_subject(rng)
            self.chain = self.subject.chain
            self.says("ACCEPT", forge.true_plan(self.subject, rng))


class Codes(ExpressionTest):
    def test_only_what_is_needed_has_a_code(self):
        self.use(("|", "A", "B"), A=LEFT, B=SMALL)
        inside, half = (Q(1, 4),) * 3, (Q(3, 4),) * 3
        self.says("ACCEPT", self.line(half, "in", 6))         # the box of B does not hold it
        self.says("ACCEPT", self.line(inside, "in", 6 + 3))
        self.says("ACCEPT", self.line(inside, "in", forge.OPEN, 6))
        self.says("B1", self.line(inside, "in", 6, 6))
        self.says("ACCEPT", self.line((2, 2, 2), "out"))
        self.says("B1", self.line((2, 2, 2), "out", 0))
        self.says("B1", self.line(inside, "in", 15))
        self.says("B1", self.line(inside, "in"))

    def test_each_condition_of_a_code(self):
        self.use(("-", "A", "B"), A=LEFT, B=SMALL)
        inside, face = (Q(1, 4),) * 3, (1, Q(3, 4), Q(1, 3))
        on = self.subject.solids[0].places(face)[0]
        self.says("ACCEPT", self.line(face, "on", forge.ON, *on))
        other = bytes([next(f for f in range(12) if bytes([f]) not in self.subject.solids[0].places(face))])
        self.alone("P2", self.line(face, "on", forge.ON, *other))
        self.alone("P3", self.line(face, "out", 0))
        self.alone("P4", self.line(inside, "out", 0))
        self.alone("P4", self.line((Q(3, 4),) * 3, "out", 0))
        self.alone("P5", self.line(inside, "in", 6, 6))
        self.alone("P5", self.line(inside, "out", 6, forge.OPEN))
        self.says("B1", self.line(face, "on", forge.ON, 12))

    def test_operands_that_are_open(self):
        self.use(("&", "A", "B"), A=LEFT, B=SMALL)
        inside = (Q(1, 4),) * 3
        self.says("P5", self.line(inside, "in", 6, forge.OPEN))
        self.says("P5", self.line(inside, "in", forge.OPEN, 6))
        self.use(("|", ("&", "A", "B"), "A"), A=LEFT, B=SMALL)  # it does not matter what B is
        self.says("ACCEPT", self.line(inside, "in", 6, forge.OPEN))
        self.says("ACCEPT", self.line((1, Q(3, 4), Q(1, 3)), "on", forge.ON, *LEFT.places((1, Q(3, 4), Q(1, 3)))[0]))

        self.use("A", A=LEFT)
        for word in ("in", "on", "out"):
            self.says("P5", self.line(inside, word, forge.OPEN))
            self.says("P5", self.line((0, 0, 0), word, forge.OPEN))

    # PROVES POINT-7
    def test_walls_that_are_not_flat(self):
        ball = forge.BallSolid(random.Random(4))
        for number, entity in enumerate(ball.entities):
            for at in (Q(1, 2), Q(1, 3)), (Q(1, 2), Q(0)), (Q(1), Q(1, 4)), (Q(0), Q(0)), (Q(1), Q(1)):
                q = forge.curved.point_at(entity, at)
                if forge.points_forge.nearest(q[0]) != q[0] or abs(q[0]) == 1:
                    continue
                half = block((q[0], -2, -2), (2, 2, 2))
                self.use(("|", "A", "B"), box=((-3,) * 3, (3,) * 3), A=ball, B=half)
                codes = bytes([forge.ON]) + forge.place_code(number, at), bytes([forge.ON]) + half.places(q)[0]
                for word in ("in", "on", "out"):
                    self.says("P5", self.line(q, word, *codes[0], *codes[1]))
                self.use("A", box=((-3,) * 3, (3,) * 3), A=ball)
                self.says("ACCEPT", self.line(q, "on", *codes[0]))

    # PROVES POINT-7.P
    def test_fans_that_do_not_turn(self):
        for fault in forge.fan_forge.FAULTS:
            fans = forge.FanBox((0, 0, 0), (1, 1, 1), random.Random(1), lambda face, fault=fault: fault if face == 1 else "plain")
            q, = fans.poles
            other = block((q[0], -1, -1), (2, 2, 2))
            self.use(("|", "A", "B"), box=WIDE, A=fans, B=other)
            for word in ("in", "on", "out"):
                plan = self.line(q, word, forge.ON, *fans.places(q)[0], forge.ON, *other.places(q)[0])
                self.alone("P5", plan)
            self.use("A", A=fans)                         # without another wall, nothing has to be flat
            self.says("ACCEPT", self.line(q, "on", forge.ON, *fans.places(q)[0]))

    def test_a_patch_with_two_neighbouring_collapsed_sides(self):
        """All sides of a sheet are collapsed to one point: each of its corners ends one and starts one."""
        rows = [[(Q(i * (3 - i), 2), Q(j * (3 - j), 2), 0) if 0 < i < 3 and 0 < j < 3 else (0, 0, 0) for j in range(4)] for i in range(4)]
        part = type("Part", (), {"entities": [forge.fan_forge.patch_forge.surface(rows)], "size": [(0, 1), (0, 1), (0, 0)]})
        sheet, other = forge.PatchSolid([], part, random.Random(1)), block((0, -1, -1), (2, 2, 2))
        sheet.side = lambda q: 0
        self.use(("|", "A", "B"), box=WIDE, A=sheet, B=other)
        for word in ("in", "on", "out"):
            for at in (0, 0), (0, 1), (1, 1), (Q(1, 3), 0):
                self.alone("P5", self.line((0, 0, 0), word, forge.ON, *forge.place_code(0, at), forge.ON, *other.places((0, 0, 0))[0]))

    def test_walls_at_parameters_of_kind_1(self):
        left = cube((0, 0, 0), 1)

        def code_at(q):
            number, at = next((n, at) for n, e in enumerate(left.entities) for at in [forge.parameters_of(e, q)] if at)
            return bytes([forge.ON]) + forge.forge.varint(number) + b"\1" + forge.curved.as_root(at, RNG).bytes()

        for q, is_inside in (((1, Q(1, 2), Q(1, 3)), True), ((1, 0, Q(1, 3)), False), ((1, 1, 1), False)):
            code = code_at(q)
            self.use("A", A=left)
            self.says("ACCEPT", self.line(q, "on", *code))
            self.use(("|", "A", "B"), A=left, B=RIGHT)
            for word in ("in", "on", "out"):
                good = is_inside and word == self.subject.word(q)
                self.says("ACCEPT" if good else "P5", self.line(q, word, *code, forge.ON, *RIGHT.places(q)[0]))

    def test_a_mesh_that_is_no_solid(self):
        twice = block((0, 0, 0), (1, 1, 1))
        twice.model = twice.model.copy(tris=2 * twice.model.tris)
        twice.mesh, twice.data = forge.forge.mesh_of(twice.model), twice.model.encode()
        q, found = (1, 0, Q(1, 2)), []
        for apex in (0, -1, .5), (1.5, .5, .5):               # of a tetrahedron that touches an edge of A from outside
            points = [(1, 0, 0), (1, 0, 1), apex, ((apex[0] + 1.25) / 2, (apex[1] - .25) / 2, .5)]
            b = forge.MeshSolid([], points, forge.oriented(points), random.Random(1), False)
            self.use(("&", "A", "B"), A=twice, B=b)
            codes = b"".join(bytes([forge.ON]) + solid.places(q)[0] for solid in (twice, b))
            found += [self.ask(self.line(q, word, *codes)) for word in ("in", "on", "out")]
        self.assertTrue(any("not closed" in message for code, message in found), found)
        self.says("P4", self.line((Q(1, 4),) * 3, "in", 6))

    def test_points_that_are_not_covered_are_counted(self):
        self.use(("|", "A", "B"), A=LEFT, B=SMALL)
        lie = self.line((Q(1, 4),) * 3, "out", forge.NOT_COVERED)
        self.assertIn("1 points, 1 not covered", self.says("ACCEPT", lie))
        self.says("B1", lie.copy(counts={"marked": 0}))
        self.says("B1", lie.copy(counts={"marked": 2}))
        self.says("P5", lie.copy(lines=[lie.lines[0].changed(codes=b"\6")]))

    def test_more_than_twelve_solids_at_a_point(self):
        blocks = {"ABCDEFGHIJKLMNO"[i]: block((0, 0, 0), (1 + i, 1, 1)) for i in range(14)}
        tree = "A"
        for name in sorted(blocks)[1:]:
            tree = "|", tree, name
        self.use(tree, box=((-1, -1, -1), (20, 3, 3)), **blocks)
        self.says("ACCEPT", self.plan((0, 0, 0), (Q(1, 2), 0, 0), (Q(1, 2), Q(1, 2), 0), (14, 1, 1)))
        wrong = self.plan((0, 0, 0))
        self.alone("P5", wrong.with_line(0, word="in"))


class Lines(ExpressionTest):
    def test_expressions_have_neither_shells_nor_winding_numbers(self):
        self.use("A", A=LEFT)
        plan = self.line((Q(1, 4),) * 3, "in", 6)
        for shell in ("0", "7"):
            other = plan.copy()
            other.answers = lambda shell=shell: plan.answers()[:-2] + shell.encode() + b"\n"
            self.says("A2", other)
        self.says("A2", plan.copy(values={"winding": True}))
        self.alone("A2", self.plan().copy(values={"winding": True}))
        self.says("ACCEPT", plan.copy(lines=[plan.lines[0].changed(word="undecided")]))


class Files(ExpressionTest):
    def setUp(self):
        self.use(("-", "A", ("!", "B")), A=LEFT, B=SMALL)
        self.true = self.plan((Q(1, 4),) * 3, (Q(3, 4),) * 3)
        self.files = self.chain.files()

    def test_a_changed_file(self):
        self.alone("O1", self.true, files={**self.files, "a": self.files["a"] + b"\n"})
        self.says("O1", self.true, files={"a": self.files["b"], "b": self.files["a"]})
        self.says("exit 4", self.true, files={"a": self.files["a"]})

    def test_operands_lie_in_the_interior_of_the_box(self):
        for low, high in (((0, -1, -1), (3, 3, 3)), ((-1, -1, -1), (3, 1, 3)), ((-1, -1, Q(1, 4)), (3, 3, 3))):
            self.use(("|", "A", "B"), box=(low, high), A=LEFT, B=SMALL)
            self.alone("O2", self.plan())
        inner = forge.Chain("A", {"A": SMALL}, {"A": "s"}, ((-3, -3, -3), (2, 2, 2)))
        self.use("X", box=((-3, -4, -4), (4, 4, 4)), X=inner)
        self.alone("O2", self.plan(), files={"x": inner.data, "s": SMALL.data})

    def test_a_mesh_that_is_not_closed(self):
        hole = block((0, 0, 0), (1, 1, 1))
        hole.model = hole.model.copy(tris=hole.model.tris[1:])
        hole.mesh, hole.data = forge.forge.mesh_of(hole.model), hole.model.encode()
        self.use("A", A=hole)
        self.alone("P1", self.plan())

    def test_what_a_chain_file_must_be(self):
        good = json.loads(self.chain.data)
        operands = good["operands"]

        def refused(**changes):
            data = json.dumps({**good, **changes}).encode()
            self.says("exit 4", self.true, model=data)

        for key in good:
            refused(**{key: None})
            self.says("exit 4", self.true, model=json.dumps({k: v for k, v in good.items() if k != key}).encode())
        refused(schema="veritope-chain-2")
        refused(boundary="certified")
        refused(other=1)
        for expression in ("", "A", "A - !(B", "A - !B)", "A - - B", "A B", "A - !B -", "A - !C", "A | \"b\"", "A - !B & 1", "A ^ B", "!"):
            refused(expression=expression)
        for box in (["0"] * 5, ["0"] * 6, ["-1", "-1", "-1", "3", "3", 3], ["-1", "-1", "-1", "3", "3", "x"], ["3", "3", "3", "-1", "-1", "-1"]):
            refused(box=box)
        for changes in ({"name": "1"}, {"name": "B"}, {"path": ""}, {"path": "\0"}, {"sha256": "0"}, {"format": "off2"}, {"format": 1}, {"more": ""}):
            refused(operands=[{**operands[0], **changes}, *operands[1:]])
        refused(operands=operands + [{**operands[0], "name": "C"}])
        self.says("exit 4", self.true, model=self.chain.data + b"x")
        self.says("ACCEPT", self.true, model=b"\xef\xbb\xbf" + self.chain.data.replace(b": ", b" :\r\n\t"))
        self.says("ACCEPT", self.true, model=self.chain.data.replace(b"(A - !(B))", b"A-! (((B)))"))

    def test_strength_of_operators(self):
        blocks = {"A": LEFT, "B": RIGHT, "C": SMALL}
        for text, tree in (("A | B & C", ("|", "A", ("&", "B", "C"))), ("A - B | C", ("|", ("-", "A", "B"), "C")), ("A - B - C", ("-", ("-", "A", "B"), "C")),
                           ("!A & B | C", ("|", ("&", ("!", "A"), "B"), "C")), ("A & !B & C", ("&", ("&", "A", ("!", "B")), "C")),
                           ("A - (B | C)", ("-", "A", ("|", "B", "C"))), ("!!A | B + C", ("+", ("|", ("!", ("!", "A")), "B"), "C"))):
            self.use(tree, **blocks)
            self.chain.changed = {"expression": text}
            points = [(Q(i, 4), Q(j, 4), Q(1, 4)) for i in range(-1, 10) for j in range(-1, 6, 2)]
            self.says("ACCEPT", self.plan(*points))

    def test_long_and_deep_expressions(self):
        for text in ("(" * 5000 + "A" + ")" * 5000, "!" * 3000 + "A", " | ".join(["A"] * 9999), "(A & " * 3000 + "A" + ")" * 3000):
            self.use("A", A=LEFT)
            if "!" in text:                               # an even number of complements, on which the word depends inside of the box only
                self.subject.variables.append(self.chain.box)
            self.chain.changed = {"expression": text}
            leaves = text.count("A")
            self.says("ACCEPT", self.line((Q(1, 4),) * 3, "in", 6).copy(counts={"leaves": leaves}))
            self.says("P5", self.line((Q(1, 4),) * 3, "out", 6).copy(counts={"leaves": leaves}))
        for text in (" | ".join(["A"] * 10001), "!" * 100001 + "A"):
            self.chain.changed = {"expression": text}
            self.says("exit 4", self.line((9, 9, 9), "out"))

    def test_files_that_double(self):
        inner, files = LEFT, {"f0": LEFT.data}
        for k in range(1, 20):
            inner = forge.Chain(("|", "A", "A"), {"A": inner}, {"A": "f%d" % (k - 1)}, ((-k, -k, -k), (k + 1, k + 1, k + 1)))
            files["f%d" % k] = inner.data
            self.chain, self.subject = inner, None
            subject = type("Subject", (), {"solids": [LEFT], "num_leaves": 2 ** k, "as_indexed": False})
            plan = forge.Plan(subject, [forge.Line(["0.5"] * 3, "in", b"\6")], "exact")
            self.subject = subject
            self.says("ACCEPT" if 2 ** k <= 10000 else "exit 4", plan, files=files)

    def test_files_in_files(self):
        inner, files = LEFT, {"f0": LEFT.data}
        for k in range(1, 1002):
            inner = forge.Chain("A", {"A": inner}, {"A": "f%d" % (k - 1)}, ((-k, -k, -k), (k + 1, k + 1, k + 1)))
            inner = type("Done", (), {"data": inner.data, "form": "chain", "box": inner.box})
            files["f%d" % k] = inner.data
            if k >= 1000:
                self.subject = type("Subject", (), {"solids": [LEFT], "num_leaves": 1, "as_indexed": False})
                plan = forge.Plan(self.subject, [forge.Line(["0.5"] * 3, "in", b"\6")], "exact")
                self.says("ACCEPT" if k == 1000 else "exit 4", plan, model=inner.data, files=files)


class Work(ExpressionTest):
    def test_many_wedges_at_a_point(self):
        for n, expected in ((40, "ACCEPT"), (300, "B1")):
            a, b = (forge.pyramid(n, floor, RNG) for floor in (0.0, -1.0))
            self.use(("|", "A", "B"), box=((-2000,) * 3, (2000,) * 3), A=a, B=b)
            codes = b"".join(bytes([forge.ON]) + solid.places((0, 0, 9))[0] for solid in (a, b))
            self.says(expected, self.line((0, 0, 9), "on", *codes))

    def test_a_long_expression_of_many_solids_at_a_point(self):
        names = "ABCDEFGHIJKLMN"
        blocks = {name: block((0, 0, 0), (1 + i, 1, 1)) for i, name in enumerate(names)}
        tree = names[0]
        for name in names[1:]:
            tree = "|", tree, name
        for repeated, expected in ((700, "B1"), (1, "ACCEPT")):
            self.use(tree, box=((-1, -1, -1), (20, 3, 3)), **blocks)
            self.chain.changed = {"expression": " | ".join(list(names) * repeated)}
            plan = self.plan(*[(0, 0, 0)] * 6)
            self.says(expected, plan.copy(counts={"leaves": 14 * repeated}))


if __name__ == "__main__":
    unittest.main()
