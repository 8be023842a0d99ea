#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""mesh-reversed-1 in the C++ checker (docs/certificates/mesh-reversed.md): bodies by the page, lies that differ from an honest certificate
in one thing, and every test of mesh-valid-1, whose models are stored with some triangles reversed. VERITOPE_CHECK names the program."""
import hashlib
import json
import os
import random
import struct
import unittest

import judges
import mesh_models as models
import mesh_test as mesh_tests

forge = mesh_tests.forge
SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))


def reversed_triangle(t):
    return t[0], t[2], t[1]


def bitmap(chosen, faces):
    out = bytearray((faces + 7) // 8)
    for f in chosen:
        out[f // 8] |= 1 << f % 8
    return bytes(out)


class Reversal:
    """A model (of indices) as a file has it, with the triangles that have to be reversed, and certificates about it. `right`: a forge.Model
    whose triangles bound a solid."""

    def __init__(self, right, chosen):
        self.chosen = set(chosen)
        self.right = right
        self.mesh = forge.mesh_of(right)                  # after the replacement, which the conditions are about
        tris = [reversed_triangle(t) if f in self.chosen else t for f, t in enumerate(right.tris)]
        self.bytes = right.copy(tris=tris).encode()

    def plan(self, share=1):
        return forge.Plan(self.mesh, random.Random(3), share)

    def shells(self):
        return sum(set(shell) <= self.chosen for shell in forge.shells(self.mesh))

    def body(self, plan=None, bits=None):
        """bits: instead of those of the chosen triangles."""
        body = (plan or self.plan()).body()
        return b"VTMR" + body[4:12] + (bitmap(self.chosen, len(self.mesh.tris)) if bits is None else bits) + body[12:]

    def certificate(self, body=None, **values):
        quantities = {**self.plan().quantities(), "reversed": len(self.chosen), "reversed_shells": self.shells(), **values}
        return forge.certificate(self.bytes, self.right, "mesh-reversed-1", self.body() if body is None else body, quantities)


def model_of(mesh, fmt="off"):
    return forge.Model(*models.triangles(mesh), fmt)


TETRAHEDRON = model_of(models.TET)
NINE = model_of(models.prism(9))                          # 32 triangles


class ReversedTest(unittest.TestCase):
    def says(self, expected, model, certificate):
        code, condition, text = judges.in_cpp(model, certificate)
        self.assertEqual((code, condition), ({"ACCEPT": 0, "": 4}.get(expected, 1), expected), text)
        return text

    def accepted(self, reversal, **values):
        text = self.says("ACCEPT", reversal.bytes, reversal.certificate(**values))
        self.assertIn("ACCEPT mesh-reversed-1: ", text)
        self.assertIn("%d reversed, %d reversed_shells, " % (len(reversal.chosen), reversal.shells()), text)


class Sound(ReversedTest):
    def test_the_example_of_the_page(self):
        """A tetrahedron that is inside out; the byte is 15, 1, 0, 31."""
        case = Reversal(TETRAHEDRON, range(4))
        self.assertEqual((case.body()[12], case.shells()), (15, 1))
        self.accepted(case)
        for byte, condition in ((1, "V4"), (0, "R1"), (31, "B1"), (16, "B1"), (128, "B1")):
            self.says(condition, case.bytes, case.certificate(case.body(bits=bytes([byte]))))

    def test_shells_that_are_inside_out(self):
        for name in ("torus", "nested", "onion", "two bodies"):
            for fmt in ("off", "obj", "ply"):
                right = model_of(models.SOLIDS[name][0], fmt)
                for shell in forge.shells(forge.mesh_of(right)):
                    self.accepted(Reversal(right, shell))
        self.accepted(Reversal(right, range(len(right.tris))))

    def test_single_triangles(self):
        """M5: some faces disagree with their neighbours; no shell is reversed as a whole."""
        for chosen in ({0}, {7}, {8}, {31}, {0, 8, 9, 31}, set(range(31))):
            case = Reversal(NINE, chosen)
            self.assertEqual(case.shells(), 0)
            self.accepted(case)

    def test_stl(self):
        """The ids of an STL file count corners in file order, so that a reversal changes them."""
        for write in (models.stl_text, models.stl_binary):
            points, tris = models.triangles(models.CUBE)
            mesh = models.File(write((points, [reversed_triangle(t) for t in tris])), "stl")
            where, there = mesh.reading()
            right = forge.Model(where, [reversed_triangle(t) for t in there], "stl")
            case = Reversal(forge.Model(points, tris), range(len(tris)))
            case.right, case.bytes, case.mesh = right, mesh.data, forge.Mesh(where, right.tris)
            self.accepted(case)

    def test_random_triangles_of_random_solids(self):
        rng = random.Random(4711)
        for _ in range(20 * SCALE):
            name = rng.choice(sorted(models.SOLIDS))
            right = model_of(models.SOLIDS[name][0], rng.choice(("off", "obj", "ply")))
            chosen = [f for f in range(len(right.tris)) if rng.random() < .5] or [0]
            with self.subTest(name=name, chosen=chosen):
                self.accepted(Reversal(right, chosen))


class Lies(ReversedTest):
    def test_r1(self):
        """Nothing is reversed, and everything else is right."""
        for right in (TETRAHEDRON, NINE):
            case = Reversal(right, ())
            self.says("R1", case.bytes, case.certificate())
            self.says("ACCEPT", case.bytes, case.plan().certificate(case.bytes, right))    # mesh-valid-1

    def test_r1_is_tested_after_b1_and_before_v1(self):
        case = Reversal(TETRAHEDRON, ())
        body = bytearray(case.body())
        body[13] ^= 1                                     # the first number of `order`
        self.says("R1", case.bytes, case.certificate(bytes(body)))
        self.says("B1", case.bytes, case.certificate(bytes(body) + b"\0"))
        case = Reversal(TETRAHEDRON, range(4))
        body[12] = 15
        self.says("V1", case.bytes, case.certificate(bytes(body)))

    def test_v11(self):
        case = Reversal(model_of(models.SHELL), forge.shells(forge.mesh_of(model_of(models.SHELL)))[1])
        self.accepted(case)
        for key, value in (("reversed", 0), ("reversed", 11), ("reversed", 13), ("reversed", 2 ** 64 - 1), ("reversed_shells", 0),
                           ("reversed_shells", 2), ("reversed_shells", 12), ("faces", 23), ("volume", "27/1")):
            self.says("V11", case.bytes, case.certificate(**{key: value}))

    def test_a_shell_of_which_all_triangles_but_one_are_reversed_is_not_counted(self):
        case = Reversal(NINE, range(31))
        self.says("V11", case.bytes, case.certificate(reversed_shells=1))
        self.accepted(case)

    def test_a_solid_reversed(self):
        """The file bounds a solid, and the list takes its shells, or some of them, inside out."""
        for name, chosen in (("cube", None), ("nested", 0), ("nested", 1), ("nested", None), ("two bodies", 1)):
            right = model_of(models.SOLIDS[name][0])
            wrong = set(range(len(right.tris))) if chosen is None else set(forge.shells(forge.mesh_of(right))[chosen])
            lie = Reversal(right.copy(tris=[reversed_triangle(t) if f in wrong else t for f, t in enumerate(right.tris)]), wrong)
            self.assertEqual(lie.bytes, right.encode())
            self.says("V10", lie.bytes, lie.certificate())

    def test_the_triangles_that_are_left_as_they_are_count_too(self):
        case = Reversal(NINE, {0, 8, 9, 31})
        for missing in sorted(case.chosen):
            fewer = Reversal(NINE, case.chosen)
            fewer.chosen = case.chosen - {missing}
            self.says("V4", fewer.bytes, fewer.certificate())
        more = Reversal(NINE, case.chosen)
        more.chosen = case.chosen | {5}
        self.says("V4", more.bytes, more.certificate())


class Bodies(ReversedTest):
    def test_layout(self):
        case = Reversal(NINE, {3, 4})
        good = case.body()
        self.assertEqual(good[12:16], b"\x18\0\0\0")
        self.says("ACCEPT", case.bytes, case.certificate(good))
        for n in range(len(good)):
            self.says("B1", case.bytes, case.certificate(good[:n]))
        for bad in (good + b"\0", b"VTMV" + good[4:], b"VTMr" + good[4:], good[:4] + b"\x21" + good[5:], good[:8] + b"\x11" + good[9:],
                    good[:12] + good[16:], good[:16] + b"\0" + good[16:]):
            self.says("B1", case.bytes, case.certificate(bad))

    def test_bits_of_no_triangle(self):
        """12 triangles: four bits of the second byte belong to none; 32 triangles have no such bits, 33 have seven."""
        case = Reversal(model_of(models.CUBE), range(12))
        good = case.body()
        for bit in range(4, 8):
            self.says("B1", case.bytes, case.certificate(good[:13] + bytes([good[13] | 1 << bit]) + good[14:]))
        case = Reversal(NINE, range(32))
        self.assertEqual(case.body()[12:16], b"\xff" * 4)
        self.accepted(case)

    def test_the_claims_have_their_own_magic_and_keys(self):
        case = Reversal(TETRAHEDRON, range(4))
        good = case.certificate()
        for old, new in ((b'"reversed":4,', b""), (b'"reversed_shells":1', b'"reversed_shell":1'), (b'"reversed":4', b'"reversed":"4"'),
                         (b"mesh-reversed-1", b"mesh-valid-1"), (b"mesh-reversed-1", b"mesh-reversed-2"), (b'"1/6"', b'"1/0"'),
                         (b'"as_indexed":false,', b""), (b'"off"', b'"vjson"')):
            self.assertIn(old, good)
            self.says("S1", case.bytes, good.replace(old, new, 1))
        self.says("S2", case.bytes, good.replace(b"ties to even", b"ties to odd", 1))
        self.says("S3", case.bytes + b"\n", good)
        self.says("S4", case.bytes, good + b"\0")
        self.says("B1", case.bytes, case.certificate(case.plan().body()))
        self.says("", b"OFF 1 0 0\n0 0 0", forge.certificate(b"OFF 1 0 0\n0 0 0", case.right, "mesh-reversed-1", case.body(),
                                                          {**case.plan().quantities(), "reversed": 4, "reversed_shells": 1}))

    def test_mutations_neither_crash_nor_pass(self):
        """A changed body is rejected, unless it is another proof of the same claim."""
        case, rng = Reversal(model_of(models.SHELL), range(12)), random.Random(17)
        good = case.body()
        for _ in range(200 * SCALE):
            body = bytearray(good)
            at = rng.randrange(len(body))
            body[at] = rng.randrange(256)
            code, condition, text = judges.in_cpp(case.bytes, case.certificate(bytes(body)))
            self.assertIn(code, (0, 1), text)
            if code == 0 and at in range(12, 15):
                self.assertEqual(bytes(body), good, at)   # no other list of triangles serves


def told_of_reversed(certificate, model, chosen):
    """(model, certificate) of mesh-reversed-1 that say of `chosen` reversed what a certificate of mesh-valid-1 says of the model; None
    where that has no meaning."""
    line, _, body = certificate.partition(b"\n")
    try:
        statement = json.loads(line)
    except ValueError:
        return None
    if model.fmt == "stl" or statement.get("claim") != "mesh-valid-1" or len(body) < 12 or statement["body_sha256"] != hashlib.sha256(body).hexdigest():
        return None
    tris = [reversed_triangle(t) if f in chosen else t for f, t in enumerate(model.tris)]
    subject = model.copy(tris=tris).encode()
    shells = forge.shells(forge.mesh_of(model))
    magic = b"VTMR" if body[:4] == b"VTMV" else body[:4]
    body = magic + body[4:12] + bitmap(chosen, len(tris)) + body[12:]
    statement.update(claim="mesh-reversed-1", subject_sha256=hashlib.sha256(subject).hexdigest(), subject_bytes=len(subject),
                     body_sha256=hashlib.sha256(body).hexdigest(), reversed=len(chosen), reversed_shells=sum(set(s) <= chosen for s in shells))
    return subject, json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


class AsValid(mesh_tests.Valid):
    """The tests of V1 to V11 of mesh-valid-1, asked again of files that have a third of their triangles reversed."""
    asked = 0

    def says(self, expected, cert, model=None):
        if model is not None or not isinstance(self.model, forge.Model):
            return
        chosen = set(range(0, len(self.model.tris), 3))
        told = told_of_reversed(cert, self.model, chosen)
        if told is None:
            return
        code, condition, text = judges.in_cpp(*told)
        self.assertEqual((code, condition), (0 if expected == "ACCEPT" else 1, expected), text)
        AsValid.asked += 1

    @classmethod
    def tearDownClass(cls):
        assert cls.asked > 200, f"only {cls.asked} certificates of mesh-valid-1 were told of reversed triangles"


if __name__ == "__main__":
    unittest.main()
