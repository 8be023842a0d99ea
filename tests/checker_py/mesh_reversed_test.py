#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Tests of docs/certificates/mesh-reversed.md: which triangles a body may reverse, and what it has to say about them. What this claim
shares with mesh-valid-1 is tested in mesh_test.py."""
import itertools
import random
import unittest

import mesh_test                                          # says where the others are
import mesh_models as models
from mesh_models import BROKEN, CUBE, ONION, RING, SHELL, TET, TWIST, TWO

forge, vc = mesh_test.forge, mesh_test.vc
NESTED_WRONG = BROKEN[9]                                  # a cube in a cube, both outward
SECOND_TURNED = models.join(TET, models.move(models.turned(TET), (3, 0.25, 0.5)))


def with_face_turned(mesh, *faces):
    points, triangles = models.triangles(mesh)
    return points, [t[::-1] if f in faces else t for f, t in enumerate(triangles)]


class ReversedTest(mesh_test.CertificateTest):
    def plan(self, flips=None, share=1, **changes):
        """flips: all triangles if None."""
        plan = forge.ReversedPlan(self.mesh, range(len(self.mesh.tris)) if flips is None else flips, random.Random(3), share)
        for key, value in changes.items():
            setattr(plan, key, value)
        return plan

    def alone(self, condition, plan):
        """The condition, and no other one, rejects the certificate."""
        cert = self.cert(plan)
        self.says(condition, cert)
        self.assertEqual(vc._check(self.bytes, cert, frozenset((condition,)))[0], 0)


class Accepted(ReversedTest):
    def accepts(self, mesh, flips, shells, **quantities):
        for share in (0, 1):
            plan = self.shape(mesh).plan(flips, share)
            found = plan.quantities()
            wanted = {"reversed": len(plan.flips), "reversed_shells": shells, **quantities}
            self.assertEqual({key: found[key] for key in wanted}, wanted)
            self.assertEqual(vc.check(self.bytes, self.cert(plan)), (0, "ACCEPT mesh-reversed-1"))

    def test_solids_that_are_inside_out(self):
        for mesh, shells, bodies, genus, volume in models.SOLIDS.values():
            self.accepts(models.turned(mesh), None, shells, bodies=bodies, genus=genus, volume=volume)
        self.accepts(models.turned(TWIST), None, 1)

    def test_one_of_several_shells(self):
        self.accepts(NESTED_WRONG, range(12, 24), 1, bodies=1, volume="26/1")
        self.accepts(SECOND_TURNED, range(4, 8), 1, bodies=2, volume="1/3")
        self.accepts(models.join(TWO, models.turned(models.move(ONION, (40, 0, 0)))), range(8, 44), 3, bodies=4)

    def test_triangles_that_disagree_with_their_neighbours(self):
        for mesh in (CUBE, RING, TWIST):
            n = len(models.triangles(mesh)[1])
            for flips in ((0,), (n - 1,), (2, 3), range(0, n, 2)):
                self.accepts(with_face_turned(mesh, *flips), flips, 0)
        self.accepts(with_face_turned(SECOND_TURNED, 1), (1, 4, 5, 6, 7), 1)

    def test_every_format(self):
        for writer, (fmt, write) in models.WRITERS.items():
            with self.subTest(writer):
                self.use(models.File(write(models.turned(CUBE)), fmt))
                self.says("ACCEPT", self.cert(self.plan()))
        self.says("ACCEPT", self.shape(SECOND_TURNED, as_indexed=True).cert(self.plan(range(4, 8))))

    def test_separators_and_any_order(self):
        rng = random.Random(5)
        for mesh in (models.turned(RING), models.turned(ONION)):
            plan = self.with_separators(self.shape(mesh).plan())
            self.says("ACCEPT", self.cert(plan))
            rng.shuffle(plan.order)
            self.says("ACCEPT", self.cert(plan))


class Rejected(ReversedTest):
    def accepted_choices(self, mesh, among):
        """The sets of triangles among these whose reversal is accepted."""
        self.shape(mesh)
        found = []
        for bits in itertools.product((0, 1), repeat=len(among)):
            flips = [f for f, bit in zip(among, bits) if bit]
            code, line = vc.check(self.bytes, self.cert(self.plan(flips)))
            self.assertIn(code, (0, 1), line)
            found += [flips] if code == 0 else []
        return found

    def test_exactly_one_choice_is_right(self):
        self.assertEqual(self.accepted_choices(models.turned(TET), range(4)), [[0, 1, 2, 3]])
        self.assertEqual(self.accepted_choices(with_face_turned(TET, 2), range(4)), [[2]])
        self.assertEqual(self.accepted_choices(with_face_turned(TET, 1, 2), range(4)), [[1, 2]])
        self.assertEqual(self.accepted_choices(SECOND_TURNED, range(8)), [[4, 5, 6, 7]])

    def test_no_choice_is_right_for_a_solid_or_for_what_no_reversal_mends(self):
        for mesh in (TET, models.OPEN, BROKEN[1], BROKEN[2], BROKEN[4]):
            self.assertEqual(self.accepted_choices(mesh, range(len(mesh[1]))), [])
        self.assertEqual(self.accepted_choices(TWO, range(8)), [])
        for mesh in (SHELL, NESTED_WRONG, ONION):         # whole shells
            triangles, found = len(models.triangles(mesh)[1]), []
            self.shape(mesh)
            for chosen in itertools.product((0, 1), repeat=triangles // 12):
                flips = [f for f in range(triangles) if chosen[f // 12]]
                if vc.check(self.bytes, self.cert(self.plan(flips)))[0] == 0:
                    found.append(chosen)
            self.assertEqual(found, [(0, 1)] if mesh is NESTED_WRONG else [])

    def test_r1_alone(self):
        self.shape(TET)
        self.alone("R1", self.plan(()))
        self.shape(SHELL)
        self.alone("R1", self.plan(()))
        self.says("R1", self.cert(self.plan((), order=[0] * 24)))       # before V1
        self.says("B1", self.with_body(lambda body: body + b"\0", self.cert(self.plan(()))))  # but after B1

    def test_v10_alone(self):
        """A solid that is turned inside out by the body, and one of its shells."""
        for mesh, flips in ((TET, None), (SHELL, range(12, 24)), (SHELL, range(12)), (NESTED_WRONG, range(12))):
            plan = self.shape(mesh).plan(flips)
            cert = self.cert(plan)
            self.says("V10", cert)
            self.assertEqual(vc._check(self.bytes, cert, frozenset(("V10", "V11")))[0], 0)

    def test_v11_alone(self):
        self.shape(models.join(models.turned(TET), models.move(with_face_turned(TET, 1), (3, 0, 0))))
        true = self.plan((0, 1, 2, 3, 5)).quantities()
        self.assertEqual((true["reversed"], true["reversed_shells"]), (5, 1))
        for key in ("reversed", "reversed_shells", "shells", "bodies", "faces", "vertices", "edges", "genus"):
            for wrong in {0, 1, 2, 5, 8, true[key] + 1, true[key] - 1, 2 ** 64 - 1} - {true[key], -1}:
                self.alone("V11", self.plan((0, 1, 2, 3, 5), values={key: wrong}))
        self.alone("V11", self.plan((0, 1, 2, 3, 5), values={"volume": "1/6"}))

    def test_the_other_conditions_are_about_the_reversed_triangles(self):
        self.shape(models.turned(TET))
        self.says("V1", self.cert(self.plan(order=[0, 1, 2, 2])))
        self.alone("V4", self.plan((1, 2, 3), 0))         # the volume is right, and no star code says which way normals point
        self.says("V7", self.cert(self.plan(stars={0: 1, 1: 13})))
        self.says("V8", self.cert(self.plan(extra_separators=[(99, (1, 2, 3))])))
        self.says("V9", self.cert(self.plan(extra_codes=b"\0")))
        self.says("V2", self.shape(models.join(models.turned(TET), models.turned(TET)), as_indexed=True).cert(self.plan()))
        self.says("V3", self.shape(models.turned(BROKEN[1])).cert(self.plan()))

    def test_a_reversed_triangle_keeps_its_first_vertex(self):
        """Axes of codes are made of edges and normals of (v0, v2, v1): codes along any axes that serve do not hold for another order."""
        self.shape(models.turned(TWIST))

        def answers(mesh):
            found = set()
            for seed in range(20):
                plan, rng = self.plan(share=0), random.Random(seed)
                plan.pair = lambda a, b, rng=rng: bytes(forge.chain(mesh, a, b, rng))
                found.add(vc.check(self.bytes, self.cert(plan))[1][:9])
            return found

        self.assertEqual(answers(self.plan().mesh), {"ACCEPT me"})
        for turn in (lambda a, b, c: (b, a, c), lambda a, b, c: (c, b, a), lambda a, b, c: (a, b, c)):
            self.assertIn("REJECT V9", answers(forge.Mesh(self.mesh.floats, [turn(*t) for t in self.mesh.tris])))


class Bodies(ReversedTest):
    def test_b1_bits(self):
        """A tetrahedron has four triangles: four bits of one byte belong to none.  A cube has a byte and a half, a ring whole bytes."""
        for mesh, size in ((TET, 1), (CUBE, 2), (RING, 8)):
            self.shape(models.turned(mesh))
            n = len(self.mesh.tris)
            good = self.cert(self.plan())
            bits = good.partition(b"\n")[2][12:12 + size]
            self.assertEqual(int.from_bytes(bits, "little"), (1 << n) - 1)
            spare = [(1 << n) - 1 | 1 << k for k in range(n, 8 * size)]
            self.bodies_say("B1", good, *(self.bits(good, size, value.to_bytes(size, "little")) for value in spare),
                            self.bits(good, size, bits + b"\0"), self.bits(good, size, b""))
        self.shape(models.turned(TET))
        good = self.cert(self.plan())
        for byte, answer in ((15, "ACCEPT"), (1, "V4"), (0, "R1"), (31, "B1"), (143, "B1"), (16, "B1")):       # section 4
            self.says(answer, self.with_body(lambda _, byte=byte: self.bits(good, 1, bytes([byte])), good))

    def bits(self, cert, size, new):
        body = cert.partition(b"\n")[2]
        return body[:12] + new + body[12 + size:]

    def test_b1(self):
        good = self.shape(models.turned(SHELL)).cert(self.with_separators(self.plan()))
        body = good.partition(b"\n")[2]
        self.bodies_say("B1", good, *[body[:n] for n in range(len(body))], body + b"\0", b"VTMV" + body[4:], b"VTMI" + body[4:],
                        body[:4] + b"\x19" + body[5:], body[:8] + b"\x11" + body[9:], body[:4] + b"\xff" * 4 + body[8:])

    def test_a_body_of_another_claim(self):
        cert = self.shape(TET).cert(mesh_test.forge.Plan(self.mesh, random.Random(3), 1))
        self.says("ACCEPT", cert)
        self.says("S1", cert.replace(b"mesh-valid-1", b"mesh-reversed-1", 1))
        self.says("B1", cert.replace(b"mesh-valid-1", b"mesh-reversed-1", 1).replace(b'"genus":', b'"reversed":0,"reversed_shells":0,"genus":', 1))

    def test_s1(self):
        good = self.shape(models.turned(TET)).cert(self.plan())
        self.says("ACCEPT", good)
        for old, new in ((b'"reversed":4,', b""), (b'"reversed":4', b'"reversed":"4"'), (b'"reversed":4', b'"reversed":04'), (b'"reversed":4', b'"reversed":true'),
                         (b'"reversed_shells":1', b'"reversed_shells":-1'), (b',"reversed_shells":1', b""), (b'"reversed":4', b'"reversed":4,"rules":"M8"'),
                         (b"mesh-reversed-1", b"mesh-reversed-2")):
            self.assertIn(old, good)
            self.says("S1", good.replace(old, new, 1))

    def test_random_changes_never_make_a_lie(self):
        rng = random.Random(17)
        for mesh, is_solid_once_turned in ((models.turned(TWIST), True), (NESTED_WRONG, False), (SHELL, False)):
            cert = self.shape(mesh).cert(self.with_separators(self.plan()))
            self.assertEqual(vc.check(self.bytes, cert)[0], 0 if is_solid_once_turned else 1)
            for _ in range(150):
                code, line = vc.check(self.bytes, self.with_body(lambda body: mesh_test.damaged(body, rng, True), cert))
                self.assertIn(code, (0, 1) if is_solid_once_turned else (1,), line)


if __name__ == "__main__":
    unittest.main()
