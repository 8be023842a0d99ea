#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Tests of docs/certificates/mesh.md: true certificates are accepted, and each condition rejects lies that break nothing else. Here the
Python checker answers; tests/checker/mesh_test.py asks both. mesh_reading_test.py is about the reading rule."""
import hashlib
import json
import math
import os
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "mutation"))
import attacks                                            # noqa: E402

PROGRAM = os.environ.get("VERITOPE_CHECK_PY") or str(attacks.CHECKER_PY)    # a mutant sets it
vc = attacks.load_checker(PROGRAM)
import forge                                              # noqa: E402
import mesh_models as models                              # noqa: E402
import solids                                             # noqa: E402
from mesh_models import BOOK, BROKEN, CROSSED, CUBE, ELL, OPEN, REGULAR, RING, SHELL, TWIST, TWO    # noqa: E402
from veritope_checker.common.errors import Reject         # noqa: E402
from veritope_checker.mesh import mesh_model, mesh_reader as reader, mesh_valid    # noqa: E402

TET_POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
TET = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


class CertificateTest(unittest.TestCase):
    def setUp(self):
        self.rng = random.Random(7)
        self.use(forge.Model(TET_POINTS, TET))

    def use(self, model):
        self.model, self.bytes, self.mesh = model, model.encode(), forge.mesh_of(model)
        return self

    def shape(self, mesh, as_indexed=False):
        """use() of (points, polygons)."""
        return self.use(forge.Model(*models.triangles(mesh), as_indexed=as_indexed))

    def plan(self, share=0, **changes):
        """share: of the vertices that have star codes."""
        p = forge.Plan(self.mesh, random.Random(3), share)
        for key, value in changes.items():
            setattr(p, key, value)
        return p

    def with_separators(self, plan):
        """The plan with a separator wherever one of the table's directions serves, but for leaf pairs."""
        def cut(a, b, _):
            va, vb = ({v for f in faces for v in self.mesh.tris[f]} for faces in (a, b))
            both_ways = (d for c in forge.STAR_TABLE for d in (c, forge.neg(c)))
            return None if len(a) == len(b) == 1 else next((d for d in both_ways if forge.separates(self.mesh, d, va, vb)), None)
        plan.cut = cut
        return plan

    def cert(self, plan=None):
        return (plan or self.plan()).certificate(self.bytes, self.model)

    def says(self, expected, cert, model=None):
        code, message = vc.check(self.bytes if model is None else model, cert)
        self.assertEqual(attacks.condition_of(code, message), expected, message)

    def bodies_say(self, expected, good, *bodies):
        """The certificate `good` is accepted, and with each of the other bodies the answer is `expected`."""
        self.says("ACCEPT", good)
        for body in bodies:
            self.says(expected, self.with_body(lambda _: body, good))

    def claim(self, expected, points, tris, *witnesses, rules=None, as_indexed=True):
        """The certificate of the witnesses."""
        self.use(forge.Model(points, tris, as_indexed=as_indexed))
        cert = forge.invalid_certificate(self.bytes, self.model, self.mesh, list(witnesses), rules)
        self.says(expected, cert)
        return cert

    def honest(self):
        """A witness of each rule that the mesh breaks, by rule; of M8 and M9 only if it breaks no other."""
        out = {w[0]: w for w in forge.true_witnesses(forge.Truth(self.mesh), random.Random(1)).values() if w[0] < 8}
        if not out:
            f, u = next((f, u) for f in range(len(self.mesh.tris)) for u in range(3) if forge.stab_sum(self.mesh, f, u))
            out = {rule: (rule, f, u) for rule in (8, 9)}
        return out

    def crossing(self):
        """A witness that CROSSED breaks M7."""
        self.shape(CROSSED)
        found = (forge.crossing_witness(self.mesh, f, g) for f in range(12) for g in range(12, 16))
        s, t, w, x = next(c for c in found if c)
        return 7, s, t, w, x

    def with_body(self, change, cert=None):
        """The certificate with a changed body and the right body hash."""
        line, _, body = (cert or self.cert()).partition(b"\n")
        new = change(body)
        return line.replace(hashlib.sha256(body).hexdigest().encode(), hashlib.sha256(new).hexdigest().encode()) + b"\n" + new

    def with_line(self, old, new):
        line, _, body = self.cert().partition(b"\n")
        self.assertIn(old, line)
        return line.replace(old, new, 1) + b"\n" + body


class Solids(CertificateTest):
    def test_solids_in_every_format(self):
        for name, (mesh, shells, bodies, genus, volume) in models.SOLIDS.items():
            for writer, (fmt, write) in models.WRITERS.items():
                with self.subTest(solid=name, writer=writer):
                    plan = self.use(models.File(write(mesh), fmt)).plan(1)
                    found = plan.quantities()
                    self.assertEqual([found[k] for k in ("shells", "bodies", "genus", "volume")], [shells, bodies, genus, volume])
                    self.says("ACCEPT", self.cert(plan))

    def test_solids_in_any_order_with_and_without_separators(self):
        rng = random.Random(1)
        for name, mesh in [(name, row[0]) for name, row in models.SOLIDS.items()] + [("twist", TWIST)]:
            with self.subTest(solid=name):
                self.shape(mesh)
                identity = list(range(len(self.mesh.tris)))
                for plan in (self.plan(1), self.plan(1, order=identity)):
                    self.says("ACCEPT", self.cert(plan))
                    self.says("ACCEPT", self.cert(self.with_separators(plan)))
                for _ in range(3):
                    points, tris = models.triangles(mesh)
                    self.says("ACCEPT", self.use(forge.Model(points, rng.sample(tris, len(tris)))).cert(self.plan(1, order=identity)))

    def test_without_star_codes_all_pairs_need_codes(self):
        for mesh in (models.TET, CUBE, RING, TWIST):
            plan = self.shape(mesh).plan(0)
            self.assertGreater(len(plan.walk()[1]), 0)
            self.says("ACCEPT", self.cert(plan))

    def test_star_vectors(self):
        plan = self.shape(CUBE).plan(1)
        plan.stars = {v: tuple(7 * c for c in forge.STAR_TABLE[code - 1]) for v, code in plan.stars.items()}
        self.assertEqual(len(plan.stars), 8)
        self.says("ACCEPT", self.cert(plan))

    def test_as_indexed(self):
        self.says("ACCEPT", self.shape(TWO, as_indexed=True).cert())
        self.says("ACCEPT", self.use(models.File(models.stl_binary(models.TET), "stl", True)).cert())    # STL is merged all the same

    def test_unreferenced_vertices_do_not_count(self):
        self.use(forge.Model([(9, 9, 1e300)] + TET_POINTS, [tuple(v + 1 for v in f) for f in TET]))
        self.assertEqual(self.plan().quantities()["vertices"], 4)
        self.says("ACCEPT", self.cert())

    def test_coordinates_of_every_width(self):
        """One model for each number of limbs, from integers to all of binary64."""
        for tiny in ("1", "-0x1p-1074", "0x1p-30", "0x1p-90", "0x1p-200", "0x1p-500", "0x1p-1074"):
            for huge in ("1", "0x1.fffffffffffffp+1023"):
                e, h = float.fromhex(tiny), float.fromhex(huge)
                self.says("ACCEPT", self.use(forge.Model([(0, 0, e), (h, 0, 0), (0, h, 0), (e, e, h)], TET)).cert())


class Statement(CertificateTest):
    def test_honest(self):
        self.says("ACCEPT", self.cert())
        self.assertEqual(vc.check(self.bytes, self.cert()), (0, "ACCEPT mesh-valid-1"))

    def test_order_of_keys_is_free(self):
        self.says("ACCEPT", self.with_line(b'{"certificate":"veritope-certificate-1",', b"{").replace(
            b"}\n", b',"certificate":"veritope-certificate-1"}\n', 1))
        self.says("ACCEPT", self.with_line(b'"forge"', b'"' + b"x" * 200 + b'"'))
        self.says("ACCEPT", self.with_line(b'"forge"', b'""'))
        line, _, body = self.cert().partition(b"\n")
        keys = list(json.loads(line).items())
        random.Random(3).shuffle(keys)
        self.says("ACCEPT", json.dumps(dict(keys), separators=(",", ":")).encode() + b"\n" + body)

    def test_s1(self):
        for old, new in ((b'"forge"', b'"' + b"x" * 201 + b'"'), (b'"forge"', b'"a\\nb"'), (b'"forge"', b'"\xc3\xa9"'), (b'"forge"', b'"a\tb"'), (b'"forge"', b'"\x1f"'), (b'"forge"', b'"\x7f"'),
                         (b'"forge"', b"7"), (b'"forge"', b"null"), (b'"forge"', b'{"a":1}'), (b'"forge"', b'["a"]'), (b'"tool"', b'"Tool"'),
                         (b'"tool":"forge",', b""), (b'"tool":"forge",', b'"tool":"forge","tool":"forge",'), (b'"tool"', b'"x":1,"tool"'),
                         (b'"tool":', b'"tool" :'), (b"{", b"{ "), (b"{", b""), (b"}", b""), (b"}", b"} "), (b"}", b",}"), (b"}", b"}}"),
                         (b"{", b"[{"), (b'{"cert', b'["cert'), (b'{"cert', b'"cert'), (b'"faces":4', b'"faces":00'), (b"veritope-certificate-1", b"veritope-certificate-2"), (b"mesh-valid-1", b"mesh-valid-2"),
                         (b'"off"', b'"OFF"'), (b'"off"', b'"3mf"'), (b'"as_indexed":false', b'"as_indexed":"false"'), (b'"as_indexed":false', b'"as_indexed":0'),
                         (b'"as_indexed":false', b'"as_indexed":False'), (b'"faces":4', b'"faces":"4"'), (b'"faces":4', b'"faces":04'),
                         (b'"faces":4', b'"faces":-4'), (b'"faces":4', b'"faces":4.0'), (b'"faces":4', b'"faces":4e0'), (b'"faces":4', b'"faces":true'),
                         (b'"faces":4', b'"faces":18446744073709551616'), (b'"faces":4', b'"faces":' + b"9" * 6000), (b'"1/6"', b'"1/0"'), (b'"1/6"', b'"01/6"'),
                         (b'"1/6"', b'"1"'), (b'"1/6"', b'"+1/6"'), (b'"1/6"', b'"1/-6"'), (b'"1/6"', b'"1 /6"'), (b'"1/6"', b'1'), (b'"1/6"', b'"-0/1"'), (b'"1/6"', b'"-1/6"'),
                         (b'"volume"', b'"rules":"M1","volume"'), (b'"faces":4,', b""), (b'"subject_sha256":"', b'"subject_sha256":"0'),
                         (b",", b", "), (b":", b""), (b'"', b""), (b'"faces":4', b'"faces":+4'), (b'"faces":4', b'"faces":'), (b'"faces":4', b'"faces":null'),
                         (b'"faces":4', b'"faces":[4]'), (b'"faces":4', b'"faces":4,"faces":4'), (b'"faces":4', b'"faces":4,"x":4'),
                         (b'"faces":4', b'"faces":4,"tool":4'), (b'"faces":4', b'"Faces":4'), (b'"faces":4', b'"faces":4\n'), (b'"1/6"', b'"/6"'),
                         (b'"1/6"', b'"1/06"'), (b'"1/6"', b'"1/6/1"'), (b'"1/6"', b'""'), (b"false", b"falsey"), (b'"genus":0,', b""),
                         (b"mesh-valid-1", b"mesh-invalid-1"), (b"forge", b'for\\"ge'), (b"forge", b"for\\\\ge"), (b"forge", b"for\0ge"), (b"forge", b"for\nge"),
                         (b'"off"', b'"of"'), (b'"off"', b'" ob"'), (b'"as_indexed"', b'"as_index"'), (b'"as_indexed":false,', b"")):
            self.says("S1", self.with_line(old, new))
        sha = hashlib.sha256(self.bytes).hexdigest().encode()
        for name in (sha, hashlib.sha256(self.cert().partition(b"\n")[2]).hexdigest().encode()):
            for bad in (name.upper(), name[:-1], name + b"0", b"g" + name[1:]):
                self.says("S1", self.with_line(name, bad))
        self.says("S1", b"")
        self.says("S1", self.cert().partition(b"\n")[0])
        self.says("S1", self.cert().replace(b"\n", b"\r\n", 1))
        self.says("S1", b"\n" + self.cert())
        self.says("S1", b"\n")
        self.says("S1", b"{}\n")
        self.says("S1", b"\xef\xbb\xbf" + self.cert())
        self.says("S1", b" " * 65537 + b"\n")
        room = 65536 - len(self.cert().partition(b"\n")[0])
        self.says("V11", self.with_line(b'"1/6"', b'"1/6' + b"6" * room + b'"'))
        self.says("S1", self.with_line(b'"1/6"', b'"1/6' + b"6" * (room + 1) + b'"'))
        self.says("V11", self.with_line(b'"faces":4', b'"faces":18446744073709551615'))
        self.says("V11", self.with_line(b'"faces":4', b'"faces":0'))
        for volume in (b"1" * 60001 + b"/7", b"2/12", b"0/6", b"0/1"):
            self.says("V11", self.with_line(b'"1/6"', b'"' + volume + b'"'))

    def test_s1_of_invalid(self):
        flipped = self.use(forge.Model(TET_POINTS, [(0, 1, 2)] + TET[1:]))
        for rules in ("", "M5 M5", "M5 M3", "M10", "M0", "M5  M8", " M5", "M5 ", "5", "m5", " ", "M5,M8", "M8 M5"):
            self.says("S1", forge.invalid_certificate(self.bytes, self.model, self.mesh, [(5, 0, 1)], [rules]))
        self.says("S1", forge.invalid_certificate(self.bytes, self.model, self.mesh, [(5, 0, 1)]).replace(b'"rules":"M5"', b'"rules":5'))
        self.says("ACCEPT", forge.invalid_certificate(flipped.bytes, flipped.model, flipped.mesh, [(5, 0, 1)]))

    def test_s2_s3_s4(self):
        self.says("S2", self.with_line(b"Reading rule v1", b"Reading rule v2"))
        self.says("S3", self.cert(), self.bytes + b"\n")
        self.says("S3", self.cert(), self.bytes.replace(b"1", b"2", 1))
        self.says("S3", self.with_line(b'"subject_bytes":', b'"subject_bytes":1'))
        self.says("S3", self.with_line(b'"subject_bytes":%d' % len(self.bytes), b'"subject_bytes":%d' % (2 ** 64 - 1)))
        self.says("S3", self.with_line(hashlib.sha256(self.bytes).hexdigest().encode(), b"0" * 64))
        self.says("S4", self.with_line(hashlib.sha256(self.cert().partition(b"\n")[2]).hexdigest().encode(), b"0" * 64))
        self.says("S2", self.with_line(b"ties to even", b"ties to odd"))
        self.says("S2", self.with_line(b"in range.", b"in range"))
        self.says("S4", self.cert() + b"\0")
        self.says("S4", self.cert()[:-1])

    def test_a_refused_model_is_exit_4(self):
        self.use(forge.Model(TET_POINTS, TET))
        data = b"OFF 1 0 0\n0 0 0"
        cert = self.model.copy()
        cert = self.plan().certificate(data, cert)
        self.assertEqual(vc.check(data, cert)[0], 4)

    def test_every_truncation(self):
        data = self.cert()
        line = data.index(b"\n")
        for n in range(len(data)):
            self.says("S1" if n <= line else "S4", data[:n])

    def test_the_wrong_format_is_exit_4(self):
        for fmt in ("obj", "ply", "stl"):
            self.says("exit 4", self.with_line(b'"off"', b'"%s"' % fmt.encode()))


class Bodies(CertificateTest):
    def test_b1_valid(self):
        self.says("ACCEPT", self.with_body(lambda b: b))
        for change in (lambda b: b"", lambda b: b[:3], lambda b: b"VTMI" + b[4:], lambda b: b[:-1], lambda b: b + b"\0", lambda b: b[:4] + b"\5" + b[5:],
                       lambda b: b[:8] + b"\5" + b[9:], lambda b: b[:28] + b"\x0f" + b[29:], lambda b: b[:28] + b"\x0e" + b[29:],
                       lambda b: b[:32] + b"\1\0\0\0" + bytes(12) + b[36:], lambda b: b[:32] + b"\xff" * 4 + b[36:], lambda b: b[:36] + b"\xff" * 4 + b[40:],
                       lambda b: b[:40] + b"\xff" * 4 + b[44:]):
            self.says("B1", self.with_body(change))

    def test_b1_counts_and_truncations(self):
        good = self.shape(SHELL).cert(self.with_separators(self.plan(1)))
        body = good.partition(b"\n")[2]
        stars = 12 + 4 * len(self.mesh.tris)
        counts = stars + len(self.mesh.p)
        bodies = [body[:n] for n in range(len(body))] + [b"VTMX" + body[4:], body[:stars] + b"\xff" + body[stars + 1:]]
        for at in (4, 8, counts, counts + 4 + 12 * struct.unpack_from("<I", body, counts)[0]):
            n = struct.unpack_from("<I", body, at)[0]
            bodies += [body[:at] + struct.pack("<I", m % 2 ** 32) + body[at + 4:] for m in (n + 1, n - 1, n + 2 ** 31, 2 ** 32 - 1)]
        self.bodies_say("B1", good, *bodies)

    def test_b1_varints(self):
        for sep, expected in ((b"\0\0\0\0", "V8"), (b"\x80\0\0\0\0", "B1"), (b"\0\x80\0\0\0", "B1"), (b"\0" + b"\xff" * 9 + b"\1\0\0", "B1"),
                              (b"\xff" * 9 + b"\1\0\0\0", "V8"), (b"\xff" * 9 + b"\2\0\0\0", "B1"), (b"\x80" * 9 + b"\2\0\0\0", "B1"), (b"\xff" * 9 + b"\x81\0\0\0\0", "B1"),
                              (b"\1\xfe\xff\xff\xff\x0f\0\0", "V8"), (b"\1\x80\x80\x80\x80\x10\0\0", "B1"), (b"\1\xfd\xff\xff\xff\x0f\0\0", "V8"),
                              (b"\1\xff\xff\xff\xff\x0f\0\0", "B1"), (b"\0\0\0", "B1"), (b"\xff" * 10 + b"\1\0\0\0", "B1"),
                              (b"\0\x81\0\0\0", "B1"), (b"\0" + forge.varint(2 ** 32) + b"\0\0", "B1"), (b"\0\0\0" + forge.zigzag(-2 ** 31), "B1"),
                              (b"\0\0\0" + forge.zigzag(2 ** 31), "B1")):
            self.says(expected, self.with_body(lambda b: b[:36] + b"\1\0\0\0" + sep + b[40:]))

    def test_b1_nesting_codes(self):
        self.use(forge.Model(*solids.join((TET_POINTS, TET), solids.move((TET_POINTS, TET), (9, 0, 0)))))
        self.says("ACCEPT", self.cert())
        self.says("B1", self.with_body(lambda b: b[:-1] + b"\6"))
        self.says("B1", self.with_body(lambda b: b[:-1]))
        self.says("B1", self.with_body(lambda b: b[:-2]))
        self.says("B1", self.with_body(lambda b: b + b"\0"))
        self.shape(models.TET)
        self.says("B1", self.with_body(lambda b: b + b"\0"))  # one shell has no code

    def test_b1_invalid(self):
        self.use(forge.Model(TET_POINTS, [(0, 1, 2)] + TET[1:]))
        good = forge.invalid_certificate(self.bytes, self.model, self.mesh, [(5, 0, 1)])
        self.says("ACCEPT", good)
        for change in (lambda b: b"VTMV" + b[4:], lambda b: b + b"\0", lambda b: b[:-1], lambda b: b[:12] + bytes(4), lambda b: b[:12] + b"\xff" * 4 + b[16:],
                       lambda b: b[:16] + b"\0" + b[17:], lambda b: b[:16] + b"\x0a" + b[17:], lambda b: b[:-4] + b"\4\0\0\0",
                       lambda b: b[:12] + b"\2\0\0\0" + b[16:] + struct.pack("<BII", 3, 0, 1), lambda b: b[:12] + b"\2" + b[13:]):
            self.says("B1", self.with_body(change, good))
        for w in ((1, 4), (2, 0, 4), (3, 0, 4), (6, 4), (8, 4, 0), (8, 0, 3)):
            self.says("B1", forge.invalid_certificate(self.bytes, self.model, self.mesh, [w]))
        self.bodies_say("B1", good, *[good.partition(b"\n")[2][:n] for n in range(25)])
        crossing = self.crossing()
        f, g = crossing[1:3]
        good = self.claim("ACCEPT", *CROSSED, crossing)
        body = good.partition(b"\n")[2]
        f_end, v_end, three = len(self.mesh.tris), len(self.mesh.p), (b"\1\0\0\0\1" + bytes(8)) * 2
        self.bodies_say("B1", good, *[body[:n] for n in range(len(body))], b"VTMV" + body[4:], body + b"\0",
                        *[body[:at] + struct.pack("<I", n) + body[at + 4:] for at, n in ((4, f_end + 1), (8, v_end - 1), (12, 0), (12, 2), (12, 2 ** 32 - 1))])

        def raw(rule, *fields, tail=b""):
            return body[:12] + struct.pack("<IB%dI" % len(fields), 1, rule, *fields) + tail
        self.bodies_say(
            "B1", good, raw(0, 0), raw(10, 0), raw(1, f_end), raw(2, 0, f_end), raw(2, f_end, 0), raw(3, v_end, 0), raw(4, 0, v_end),
            raw(5, v_end, 0), raw(6, v_end), raw(6, 2 ** 32 - 1), raw(7, 0, f_end, tail=three), raw(7, f_end, 0, tail=three),
            raw(8, f_end, tail=b"\0"), raw(8, 0, tail=b"\3"), raw(9, 0, tail=b"\xff"), raw(7, f, g, 1, tail=b"\0" + bytes(20)),
            raw(7, f, g, 2, tail=b"\1\0" + bytes(20)), raw(7, f, g, 2 ** 32 - 1, tail=bytes(20)),
            raw(7, f, g, 4097, tail=b"\1" * 4097 + bytes(20)))
        self.bodies_say("I7", good, raw(7, f, g, tail=(struct.pack("<I", 4096) + b"\1" * 4096) * 6))
        self.use(forge.Model(TET_POINTS, [(0, 1, 2)] + TET[1:]))
        natural = forge.natural
        try:
            forge.natural = lambda n: struct.pack("<I", 2) + bytes([n, 0])
            bad = forge.invalid_certificate(self.bytes, self.model, self.mesh, [(7, 0, 1, (1, 0, 0), (1, 0, 0))])
        finally:
            forge.natural = natural
        self.says("B1", bad)

    def test_b1_work_of_a_certificate_at_its_bound(self):
        """Two fans of 10,000 triangles whose tips are joined by an open edge: 10,000 units for its witness, 2 for one at the rim."""
        d = 10000
        rim = [(math.ldexp(i, -4), math.ldexp(i * i, -8), 1.) for i in range(d)]
        tris = [(0, 1, 2)] + [(0, 1 + i, 2 + i) for i in range(1, d)] + [(1, 1 + d + i, 2 + d + i) for i in range(1, d)]
        model = forge.Model([(0., 0., 0.), (1., 0., 0.)] + rim + [(x, y, 2.) for x, y, _ in rim], tris, "off", True)
        self.use(model)
        self.assertEqual(sum(0 in t for t in tris), d)
        self.assertEqual(sum(1 in t for t in tris), d)
        heavy, light, lightest = (3, 0, 1), (3, 4, 5), (3, 1 + d, 0)
        self.assertEqual([min(sum(v in t for t in tris) for v in w[1:]) for w in (heavy, light, lightest)], [d, 2, 1])
        for n in range(20000, 40000):                     # all of at least one unit
            heavies, lights = divmod(1000 * (len(tris) + 16 + 9 * n) - n, d - 1)
            if heavies + lights < n:
                break
        for lights, expected in ((lights, "ACCEPT"), (lights + 1, "B1")):
            witnesses = [heavy] * heavies + [light] * lights + [lightest] * (n - heavies - lights)
            self.says(expected, forge.invalid_certificate(self.bytes, self.model, self.mesh, witnesses))


class Valid(CertificateTest):
    def test_v1(self):
        for order in ([0, 1, 2, 2], [0, 1, 2, 4], [3, 2, 1, 2 ** 32 - 1]):
            self.says("V1", self.with_body(lambda b: b[:12] + struct.pack("<4I", *order) + b[28:]))

    def test_v2(self):
        p, t = solids.copy_at_vertex(TET_POINTS, TET, self.rng)
        self.says("V2", self.use(forge.Model(p, t, as_indexed=True)).cert())
        touching = models.join(models.TET, models.move(models.TET, (1, 0, 0)))    # (1, 0, 0) twice
        self.says("V2", self.shape(touching, as_indexed=True).cert())
        touching[0][4] = (1, -0.0, 0)
        self.says("V2", self.shape(touching, as_indexed=True).cert())
        self.says("V6", self.use(forge.Model(p, t)).cert())
        self.says("ACCEPT", self.use(forge.Model(TET_POINTS + [(0, 0, 0)], TET, as_indexed=True)).cert())
        # Both vertices in one triangle only: V4 fails, too, but V2 comes first.
        once = [(0, 1, 2), (3, 4, 5)], TET_POINTS[:3] + [(0, 0, 5), (5, 0, 5)]
        for place in once[1]:
            self.says("V2", self.use(forge.Model(once[1] + [place], once[0], as_indexed=True)).cert())

    def test_v3(self):
        self.says("V3", self.use(forge.Model(TET_POINTS, TET + [(0, 0, 1)])).cert())
        self.says("V3", self.use(forge.Model(TET_POINTS + [(2, 0, 0)], TET + [(0, 1, 4)])).cert())
        flat = TET_POINTS + [(0.5, 0, 0)], [(0, 2, 4), (4, 2, 1), (0, 4, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
        self.shape(flat)
        self.assertTrue(all(len(faces) == 1 and edge[::-1] in forge.edge_uses(self.mesh) for edge, faces in forge.edge_uses(self.mesh).items()))
        self.says("V3", self.cert())                      # and V4 holds
        for collapsed in ((3, 3, 3), (0, 0, 1), (0, 1, 1), (0, 1, 0), (1, 1, 2)):
            self.says("V3", self.use(forge.Model(TET_POINTS, TET[:2] + [collapsed] + TET[2:])).cert())

    def test_v4(self):
        self.says("V4", self.use(forge.Model(TET_POINTS, TET[:3])).cert())
        self.says("V4", self.use(forge.Model(TET_POINTS, [(0, 1, 2)] + TET[1:])).cert())
        self.says("V4", self.use(forge.Model(TET_POINTS, TET + TET[:1])).cert())
        self.says("V4", self.use(forge.Model(TET_POINTS, TET[:1])).cert())
        self.says("V4", self.use(forge.Model(TET_POINTS + [(5, 5, 5)], TET + [(0, 1, 4), (1, 0, 4)])).cert())

    def test_v5(self):
        p = TET_POINTS + [(9, 0, 0), (9, 1, 0), (9, 0, 1)]
        self.says("V5", self.use(forge.Model(p, TET + [(4, 5, 6), (4, 6, 5)])).cert())
        self.says("V5", self.use(forge.Model(TET_POINTS[:3], [(0, 1, 2), (0, 2, 1)])).cert())

    def test_v6(self):
        self.says("V6", self.shape(BROKEN[6]).cert())
        p, t = solids.copy_at_vertex(TET_POINTS, TET, self.rng)
        self.says("V6", self.use(forge.Model(p, t)).cert())

        self.says("V6", self.use(forge.Model([(9, 9, 9)] + p, [tuple(v + 1 for v in f) for f in t])).cert())

    def test_v7(self):
        for v in range(4):
            for code in range(1, 14):
                holds = forge.star_holds(self.mesh, v, forge.STAR_TABLE[code - 1])
                self.says("ACCEPT" if holds else "V7", self.cert(self.plan(stars={v: code})))
        self.says("V7", self.cert(self.plan(stars={0: (0, 0, 0)})))
        self.says("ACCEPT", self.cert(self.plan(stars={0: (5, 6, 7)})))
        self.says("ACCEPT", self.cert(self.plan(stars={0: (-5, -6, -7)})))
        self.use(forge.Model(TET_POINTS + [(5, 5, 5)], TET))
        self.says("V7", self.cert(self.plan(stars={4: 1})))

        self.says("V7", self.cert(self.plan(stars={4: (1, 1, 1)})))

    def test_v7_at_a_corner_of_a_cube(self):
        """The corner (0, 0, 0) is seen properly along d if all components of d have one sign."""
        self.shape(CUBE)
        for d in forge.STAR_TABLE + [(0, 0, 0), (-1, 1, 1), (1, -2 ** 31, 1), (1, 2, 3), (-5, -1, -1), (2 ** 31 - 1, 1, 1), (-2 ** 31,) * 3]:
            for star in {d, forge.STAR_TABLE.index(d) + 1} if d in forge.STAR_TABLE else {d}:
                self.says("ACCEPT" if min(d) > 0 or max(d) < 0 else "V7", self.cert(self.plan(stars={0: star})))

    def test_v7_two_turns(self):
        """A vertex that its triangles go around twice, each seen from the front."""
        ring = [(2, 0, 0), (0, 2, 1), (-2, -1, 2), (3, -1, 3), (1, 3, 4), (-3, -2, 5)]
        tris = [(i, (i + 1) % 6, 6) for i in range(6)] + [((i + 1) % 6, i, 7) for i in range(6)]
        self.use(forge.Model(ring + [(0, 0, 10), (0, 0, -10)], tris))
        self.assertTrue(all(self.mesh.n[f][2] > 0 for f in range(6)))
        self.assertIsNone(forge.star(self.mesh, 6))
        self.says("V7", self.cert(self.plan(stars={6: 3})))

    def test_v7_directions_that_are_wrong_in_one_way_only(self):
        """One triangle is seen from behind, or edge-on."""
        for mesh in (CUBE, RING, TWIST):
            self.shape(mesh)
            kinds = {}
            for v, faces in self.mesh.at.items():
                for d in ((x, y, z) for x in range(-2, 3) for y in range(-2, 3) for z in range(-2, 3)):
                    heights = [forge.dot(self.mesh.n[f], d) for f in faces]
                    signs = tuple(sorted((h > 0) - (h < 0) for h in heights))
                    if len(set(signs)) > 1 and len(kinds.setdefault(signs, [])) < 4:
                        kinds[signs].append((v, d))
            for v, d in (c for cases in kinds.values() for c in cases):
                self.says("V7", self.cert(self.plan(stars={v: d})))

    def test_v7_a_vector_at_every_vertex(self):
        """Their bytes are the greater part of the body."""
        corners, tris = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
        self.use(forge.Model(*solids.join(*(solids.move((corners, tris), (9 * i, 0, 0)) for i in range(8)))))
        corners *= 8
        cert = self.cert(self.plan(stars=dict(enumerate(corners))))
        self.assertLess(len(cert.partition(b"\n")[2]), 13 * len(corners) + 4 + 8 + 4 * len(self.mesh.tris) + len(corners) + 4)
        self.says("ACCEPT", cert)

    def test_v8(self):
        self.use(forge.Model(*solids.join((TET_POINTS, TET), solids.move((TET_POINTS, TET), (1, 1, -1)))))
        for order in (list(range(8)), [0, 4, 1, 5, 2, 6, 3, 7]):
            whole = self.plan(order=order)
            whole.cut = lambda a, b, k: (1, 1, -1) if max(a) < 4 <= min(b) else (-1, -1, 1) if max(b) < 4 <= min(a) else None
            self.says("ACCEPT", self.cert(whole))
            wrong = whole.copy()
            wrong.cut = lambda a, b, k: whole.cut(b, a, k)
            self.says("V8", self.cert(wrong))
        spare = whole.copy()
        spare.extra_separators = [(1000, (1, 0, 0))]
        self.says("V8", self.cert(spare))
        spare.extra_codes = b"\0"                         # V8 comes before V9
        self.says("V8", self.cert(spare))

    def test_v8_separators_that_are_wrong_or_not_used(self):
        plan = self.shape(ELL).with_separators(self.plan(1, order=list(range(len(ELL[1])))))
        separators, codes = plan.walk()
        self.says("ACCEPT", self.cert(plan))
        (k, d), rest, last = separators[0], separators[1:], separators[-1][0]
        for bent in ([(k, forge.neg(d))] + rest, [(k, (0, 0, 0))] + rest, separators + [(last + 1 + 10 ** 6, (1, 0, 0))],
                     separators + [(last + 2 ** 64, (1, 0, 0))], [(i + 10 ** 9, e) for i, e in separators],
                     [(i, tuple(1000 * c + s for c, s in zip(e, (1, -1, 1)))) for i, e in separators]):
            plan.walk = lambda bent=bent: (bent, codes)
            self.says("V8", self.cert(plan))
        plan.walk = lambda: (separators, b"\x1f" * (len(codes) + 1))
        self.says("V9", self.cert(plan))
        plan.extra_separators = [(10 ** 6, (1, 0, 0))]    # V8 comes before V9
        self.says("V8", self.cert(plan))

    def test_v8_separators_of_many_vertices(self):
        """The boxes of two octahedra overlap, so that the root is reached."""
        self.shape(models.join(models.OCTAHEDRON, models.move(models.OCTAHEDRON, (3, 3, 0))))
        n = len(self.mesh.tris)
        for d, expected in (((1, 1, 0), "ACCEPT"), ((-1, -1, 0), "V8"), ((1, 0, 0), "V8"), ((0, 0, 1), "V8")):
            plan = self.plan(1, order=list(range(n)), cut=lambda a, b, k, d=d: d if len(a) + len(b) == n else None)
            self.assertEqual([e for _, e in plan.walk()[0]], [d])
            self.says(expected, self.cert(plan))

    def test_v8_open_is_not_enough(self):
        """Two triangles in the separating plane that share only an edge leave the test open."""
        self.use(forge.Model(*solids.voxel_surface({(0, 0, 0), (1, 0, 0)})))
        plan = self.plan(1, order=list(range(len(self.mesh.tris))))
        plan.cut = lambda a, b, k: (0, 0, 1) if k == 0 else None
        self.says("V8", self.cert(plan))

    def test_v8_touching_sets_need_a_simplex(self):
        tip = [(0, 0, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
        p, t = solids.join((TET_POINTS, TET), (tip, solids.reverse(TET)))
        self.use(forge.Model(p, t))
        self.says("V6", self.cert())

    def test_v9(self):
        honest = self.plan()
        honest.walk()
        a, b = next(p for p, c in self.mesh.codes.items() if c)
        for code in range(256):
            codes = bytes([code])
            holds = [code] in ([c] for c in self.one_byte_codes(a, b))
            self.says("ACCEPT" if holds else "V9", self.cert(self.plan(forced={frozenset((a, b)): codes})))
        self.says("V9", self.cert(self.plan(extra_codes=b"\0")))
        self.says("V9", self.cert(self.plan(forced={frozenset((a, b)): b""})))
        self.use(forge.Model(*solids.voxel_surface({(0, 0, 0), (1, 0, 0), (0, 1, 0)})))
        self.says("ACCEPT", self.cert())
        pair = next(p for p, c in sorted(self.mesh.codes.items()) if c and 0 in self.one_byte_codes(*p))
        self.says("ACCEPT", self.cert(self.plan(forced={frozenset(pair): b"\0"})))
        self.says("V9", self.cert(self.plan(forced={frozenset(pair): b"\x80"})))

    def one_byte_codes(self, a, b):
        for c, d in enumerate(forge.axis_vectors(self.mesh, a, b)):
            for code, e in ((c, d), (c + 32, forge.neg(d))):
                gap, p, q = forge.apply_axis(self.mesh, e, self.mesh.tris[a], self.mesh.tris[b])
                if gap > 0 or gap == 0 and forge.closes(self.mesh, p, q):
                    yield code

    def test_v9_chains(self):
        self.use(forge.Model(*solids.voxel_surface({(0, 0, 0), (1, 0, 0)})))
        self.says("ACCEPT", self.cert())
        seen = set()
        for (a, b), chain in sorted(self.mesh.codes.items()):
            longer = chain and forge.detour(self.mesh, a, b, self.rng)
            if not longer:
                continue
            key, first = frozenset((a, b)), longer[0]
            stay = [c | 64 for c in chain_codes_that_stay(self.mesh, a, b)][:1]
            for codes, expected in ((longer, "ACCEPT"), (longer[:-1] + [longer[-1] | 64], "V9"), ([first & 63] + longer[1:], "V9"), ([first], "V9"),
                                    ([first | 128] + longer[1:], "V9"), (stay * 3 + chain, "ACCEPT"), (stay * 4 + chain, "V9" if stay else "ACCEPT"),
                                    (stay * 3 + [chain[0] | 64], "V9"), (stay * 4, "V9"), (stay * 3, "V9")):
                seen.add((len(codes), expected))
                self.says(expected, self.cert(self.plan(forced={key: bytes(codes)})))
        self.assertLessEqual({(2, "ACCEPT"), (4, "ACCEPT"), (5, "V9")}, seen)

    def test_v9_codes_of_a_twisted_solid(self):
        plan = self.shape(TWIST).plan(0)
        codes = plan.walk()[1]
        self.says("ACCEPT", self.cert(plan))
        for bent in (codes[:-1], codes + b"\0", b"", *[bytes([c]) + codes[1:] for c in (codes[0] ^ 32, codes[0] ^ 64, codes[0] ^ 128, 17, 31)]):
            plan.walk = lambda bent=bent: ([], bent)
            self.says("V9", self.cert(plan))

    def test_v9_a_crossing(self):
        """No code is right for a pair of triangles that cross."""
        plan = self.shape(CROSSED).plan(1, order=list(range(16)))
        self.says("V9", self.cert(plan))
        crossing = [(f, g) for f in range(12) for g in range(12, 16) if forge.crossing_witness(self.mesh, f, g)]
        self.assertTrue(crossing)
        self.assertTrue(all(forge.chain(self.mesh, f, g) is None for f, g in crossing))

    def test_v9_shells_that_touch(self):
        """A prover with a weaker rule finds codes; what touches is never accepted."""
        o, cube = models.OCTAHEDRON, models.move(CUBE, (0, 0, 0), 4)
        touching = (  # a vertex on an edge, a vertex in a face, faces on faces, a face around others, edges that cross
            models.join(o, models.move(o, (3, 1, 0))), models.join(cube, models.move(o, (2, 2, 6))),
            models.join(cube, models.move(CUBE, (4, 1, 1), 2)),
            models.join(models.move(CUBE, (-1, -1, -5), 2), models.move(RING, (0.5, 0.5, -3))),
            models.join(([(-2, 0, 0), (2, 0, 0), (0, -3, -3), (0, 3, -3)], TET), ([(0, -2, 0), (0, 2, 0), (-3, 0, 3), (3, 0, 3)], TET)))
        exact = forge.closes
        for mesh in touching:
            for rule in (exact, lambda m, p, q: len(set(p) | set(q)) == 3 or exact(m, p, q), lambda *_: True):
                self.shape(mesh)                          # forgets the codes of the other rules
                with unittest.mock.patch.object(forge, "closes", rule):
                    cert = self.cert(self.plan(1))
                self.says("V9", cert)

    def test_v10_shells_of_the_wrong_side(self):
        for mesh in (models.turned(models.TET), BROKEN[9], models.turned(SHELL),
                     models.join(TWO, models.move(models.turned(models.TET), (-4, 0, 0))),
                     models.join(models.move(models.turned(CUBE), (-1, -1, -1), 3), CUBE)):
            self.says("V10", self.shape(mesh).cert(self.plan(1, values={"bodies": 1, "volume": "1/1"})))

    def test_v10_rays_through_edges_and_vertices(self):
        """Shells on a grid: rays run along edges and through vertices of the others."""
        whole = {(x, y, z) for x in range(3) for y in range(3) for z in range(3)}
        inner = models.move(solids.voxel_surface({(1, 1, 1)}), (0.75, 0.75, 0.75), 0.5)
        column = models.join(*(models.move(CUBE, (0, 0, 2 * i)) for i in range(4)), models.move(models.TET, (0, 0, -4)))
        spikes = models.join(models.TET, models.move(models.TET, (1, 0, 3)), models.move(models.TET, (0, 1, 6)))
        # Rays through the vertices in the middle of the faces, and at the height of the middle corner of a triangle that they stab.
        small = models.move(models.OCTAHEDRON, (1, 1, 1), 0.125)
        pit = models.join(solids.voxel_surface({(x, y, z) for x in range(2) for y in range(2) for z in range(2)}), models.turned(small))
        tops = [(3, 1, 0), (-1, 3, 0), (-3, -1, 0), (1, -3, 0), (0, 0, 8), (0, 0, -8)], [(i, (i + 1) % 4, 4) for i in range(4)] + [
            ((i + 1) % 4, i, 5) for i in range(4)]
        level = models.join(tops, models.turned(models.move(small, (-0.25, 0.5, -0.5), 0.5)))
        outer = solids.voxel_surface(whole - {(1, 1, 1)})
        for mesh in (models.ONION, models.join(outer, inner), column, spikes, pit, level):
            self.shape(mesh)
            for code in range(6):
                plan = self.plan(1)
                plan.nesting = [code] * len(plan.shells)
                self.says("ACCEPT", self.cert(plan))

    def test_v11_of_a_torus_and_an_onion(self):
        for mesh in (RING, models.ONION):
            plan = self.shape(mesh).plan(1)
            for key, value in plan.quantities().items():
                for wrong in [value + 1, 2 ** 64 - 1] if isinstance(value, int) else ["0/1", "2/12", "1/1", "9" * 9000 + "/7"]:
                    plan.values = {key: wrong}
                    self.says("V11", self.cert(plan))

    def test_random_changes_never_make_a_lie(self):
        """Changed bytes of true certificates; a model that is no solid is never accepted."""
        rng = random.Random(11)
        for mesh, solid in ((ELL, True), (SHELL, True), (TWIST, True), (models.join(models.TET, models.move(models.TET, (0.25,) * 3, 0.25)), False)):
            cert = self.shape(mesh).cert(self.with_separators(self.plan(1)))
            self.assertEqual(vc.check(self.bytes, cert)[0], 0 if solid else 1)
            for _ in range(120):
                code, line = vc.check(self.bytes, self.with_body(lambda body: damaged(body, rng, True), cert))
                self.assertIn(code, (0, 1) if solid else (1,), line)

    def test_v10(self):
        self.says("V10", self.use(forge.Model(TET_POINTS, solids.reverse(TET))).cert())
        outer, inner = solids.box_of(3), solids.box_of(1)
        for code in range(6):
            for a, b, expected in ((outer[1], inner[1], "V10"), (solids.reverse(outer[1]), inner[1], "V10"), (outer[1], solids.reverse(inner[1]), "ACCEPT"),
                                   (solids.reverse(outer[1]), solids.reverse(inner[1]), "V10")):
                for first in (True, False):
                    parts = [(outer[0], a), (inner[0], b)]
                    self.use(forge.Model(*solids.join(*(parts if first else parts[::-1]))))
                    plan = self.plan(nesting=[code, code])
                    plan.values = {"bodies": 1}
                    self.says(expected, self.cert(plan))
        flat = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (2, 2, 0)]
        self.says("V10", self.use(forge.Model(flat, [(0, 1, 2), (1, 3, 2), (0, 2, 3), (0, 3, 1)])).cert_skipping({"V8", "V9"}))

    def cert_skipping(self, skip):
        """The certificate, judged with conditions disabled: returned only if V10 names itself."""
        cert = self.cert()
        code, message = vc._check(self.bytes, cert, frozenset(skip))
        self.assertEqual(attacks.condition_of(code, message), "V10")
        self.assertEqual(vc._check(self.bytes, cert, frozenset(skip | {"V10", "V11"}))[0], 0)
        inverted = self.use(forge.Model(TET_POINTS, solids.reverse(TET)))
        return inverted.cert()

    def test_v11(self):
        for key, lie in (("vertices", 5), ("edges", 5), ("faces", 5), ("shells", 2), ("bodies", 0), ("genus", 1), ("volume", "1/7"), ("volume", "0/1")):
            self.says("V11", self.cert(self.plan(values={key: lie})))

    def test_quantities_of_a_torus_in_a_box(self):
        torus = solids.torus(random.Random(1))
        p, t = solids.join(solids.move(solids.box_of(1000)), (torus[0], solids.reverse(torus[1])), solids.move(solids.box_of(5), (5000, 0, 0)))
        self.use(forge.Model([tuple(c / 1024 for c in q) for q in p], t))
        cert = self.cert(self.plan(1))
        self.assertIn(b'"shells":3,"bodies":2,"genus":1', cert)
        self.says("ACCEPT", cert)


def damaged(body, rng, may_be_cut):
    bent = bytearray(body)
    for _ in range(rng.choice((1, 1, 2, 5))):
        bent[rng.randrange(len(bent))] = rng.choice((0, 1, 255, rng.randrange(256)))
    if may_be_cut and rng.random() < .2:
        del bent[rng.randrange(len(bent)):]
    return bytes(bent)


def chain_codes_that_stay(mesh, a, b):
    """Axes along which both triangles lie in one plane: an open test that removes no vertex."""
    for c, d in enumerate(forge.axis_vectors(mesh, a, b)):
        gap, p, q = forge.apply_axis(mesh, d, mesh.tris[a], mesh.tris[b])
        if gap == 0 and len(p) == len(q) == 3 and not forge.closes(mesh, p, q):
            yield c


class Invalid(CertificateTest):
    def shape_claim(self, expected, mesh, *witnesses, rules=None):
        return self.claim(expected, *models.triangles(mesh), *witnesses, rules=rules, as_indexed=False)

    def test_every_rule_has_a_true_witness(self):
        for rule, mesh in BROKEN.items():
            with self.subTest(rule=rule):
                witnesses = self.shape(mesh).honest()
                self.assertIn(rule, witnesses)
                self.shape_claim("ACCEPT", mesh, *sorted(witnesses.values(), key=lambda w: w[0]))
                for w in witnesses.values():
                    self.shape_claim("ACCEPT", mesh, w)

    def test_every_format(self):
        for fmt, write in models.WRITERS.values():
            self.use(models.File(write(CROSSED), fmt))
            self.says("ACCEPT", forge.invalid_certificate(self.bytes, self.model, self.mesh, list(self.honest().values())))

    def test_no_witness_holds_on_a_solid(self):
        """All small witnesses of the rules without weights, and axis parallel ones of M7."""
        # PROVES MESH-9.M1
        n, v = len(TWIST[1]), len(TWIST[0])
        ends = [tuple(int(i == k) for i in range(3)) for k in range(3)]
        for w in [(1, f) for f in range(n)] + [(8, f, u) for f in range(n) for u in range(3)] + [(6, a) for a in range(v)] + [
                (7, f, (f + 1) % n, e, e) for f in range(n) for e in ends] + [(rule, a, (a + 1) % v) for rule in (3, 5) for a in range(v)]:
            self.shape_claim("I%d" % w[0], TWIST, w)

    def test_conditions_come_in_order(self):
        self.shape_claim("I1", OPEN, (1, 0), (3, 0, 1))
        self.shape_claim("I1", OPEN, (1, 0), (3, 0, 1), rules=["M7"])

    def test_many_witnesses(self):
        block = solids.voxel_surface({(x, y, 0) for x in range(12) for y in range(12)})
        self.shape_claim("I8", block, *[(8, 0, 0)] * 40000)

    def test_random_changes_never_crash(self):
        rng = random.Random(13)
        for mesh in BROKEN.values():
            self.shape(mesh)
            cert = forge.invalid_certificate(self.bytes, self.model, self.mesh, list(self.honest().values()))
            for _ in range(40):
                code, line = vc.check(self.bytes, self.with_body(lambda body: damaged(body, rng, False), cert))
                self.assertIn(code, (0, 1), line)

    def test_i1(self):
        p = TET_POINTS + [(2, 0, 0)]
        self.claim("ACCEPT", p, TET + [(0, 1, 4)], (1, 4))
        self.claim("ACCEPT", p, TET + [(0, 1, 1)], (1, 4))
        self.claim("I1", p, TET + [(0, 1, 4)], (1, 0))

        self.claim("ACCEPT", [(0, 0, 0)], [(0, 0, 0)], (1, 0))

    def test_i2(self):
        self.claim("ACCEPT", TET_POINTS, TET + [(1, 2, 0)], (2, 4, 0))
        self.claim("I2", TET_POINTS, TET + [(1, 2, 0)], (2, 4, 4))
        self.claim("I2", TET_POINTS, TET + [(1, 2, 0)], (2, 4, 1))
        tris = TET + [(2, 1, 0), (0, 0, 1), (0, 1, 1)]
        self.claim("ACCEPT", TET_POINTS, tris, (2, 0, 4))
        for pair in [(f, g) for f in range(4) for g in range(4)] + [(5, 6), (5, 0), (0, 5)]:    # (5, 6): fewer than three vertices
            self.claim("I2", TET_POINTS, tris, (2, *pair))

    def test_i3_i4_i5(self):
        for rule, tris in ((3, TET[1:]), (4, TET + [(0, 1, 2)]), (5, [(0, 1, 2)] + TET[1:])):
            for a, b in ((0, 1), (1, 0), (0, 3), (3, 0), (1, 1)):
                good = rule < 5 and {a, b} == {0, 1} or (a, b) == (0, 1)
                self.claim("ACCEPT" if good else "I%d" % rule, TET_POINTS, tris, (rule, a, b))
        self.claim("I3", TET_POINTS, TET + [(0, 3, 0)], (3, 0, 3))
        self.claim("I4", TET_POINTS, TET + [(0, 3, 0)], (4, 0, 3))  # fewer than three vertices: no edge
        self.claim("I5", TET_POINTS, [(0, 3, 0)], (5, 0, 3))
        for expected, mesh, *pairs in (
                ("ACCEPT", OPEN, (3, 1, 2), (3, 2, 1)), ("I3", OPEN, (3, 0, 1), (3, 1, 1)), ("I3", (TET_POINTS + [(9, 9, 9)], OPEN[1]), (3, 1, 4)),
                ("I3", (TET_POINTS, [(0, 1, 0), (1, 2, 3)]), (3, 0, 1)), ("ACCEPT", BOOK, (4, 0, 1), (4, 1, 0)),
                ("I4", BOOK, (4, 0, 2), (4, 0, 4), (4, 0, 0)), ("ACCEPT", BROKEN[5], (5, 2, 1)), ("I5", BROKEN[5], (5, 1, 2), (5, 0, 1), (5, 1, 1)),
                ("I5", (TET_POINTS, [(0, 1, 2), (0, 1, 3), (1, 0, 3)]), (5, 0, 1)), ("I5", (TET_POINTS, [(0, 1, 2), (0, 1, 3), (0, 1, 2)]), (5, 0, 1))):
            for pair in pairs:
                self.claim(expected, *mesh, pair)

    def test_i6(self):
        p, t = solids.copy_at_vertex(TET_POINTS, TET, self.rng)
        self.claim("ACCEPT", p, t, (6, 1), as_indexed=False)
        self.claim("I6", p, t, (6, 0), as_indexed=False)
        self.claim("I6", p, t, (6, 1))
        self.claim("I6", TET_POINTS + [(7, 7, 7)], TET, (6, 4))
        self.shape_claim("ACCEPT", BROKEN[6], (6, 1))
        self.shape_claim("I6", BROKEN[6], (6, 0))
        p = TET_POINTS + [(0, 0, 2), (0, 0, 3), (0, 1, 3), (0, 5, 5)]
        fans = [(0, 1, 2), (0, 3, 4), (0, 5, 6)]
        self.claim("ACCEPT", p, fans + [(0, 2, 3)], (6, 0))
        self.claim("ACCEPT", p, fans + [(0, 4, 5)], (6, 0))
        self.claim("I6", p, fans + [(0, 2, 3), (0, 5, 1)], (6, 0))
        self.claim("I6", p, fans + [(0, 2, 6), (0, 4, 5)], (6, 0))
        self.claim("ACCEPT", p, fans + [(0, 2, 6), (0, 4, 7)], (6, 0))
        self.claim("I6", p, fans + [(0, 2, 3), (0, 4, 5)], (6, 0))
        # A triangle of fewer than three vertices is at no vertex: it joins no fans.
        self.claim("ACCEPT", p, fans + [(0, 2, 3), (0, 0, 5), (4, 0, 0), (0, 0, 1)], (6, 0))

    def test_i7(self):
        p = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, -1), (1, 1, 1), (9, 9, 1), (0, 0, 0)]
        t = [(0, 1, 2), (3, 4, 5), (0, 5, 4), (0, 1, 5), (6, 5, 4), (0, 0, 1)]
        self.claim("ACCEPT", p, t, (7, 0, 1, (2, 1, 1), (1, 1, 0)))
        self.claim("ACCEPT", p, t, (7, 1, 0, (1, 1, 0), (2, 1, 1)))
        self.claim("ACCEPT", p, t, (7, 1, 0, (2 ** 80, 2 ** 80, 0), (6, 3, 3)))
        self.claim("I7", p, t, (7, 0, 1, (2, 1, 1), (1, 1, 1)))
        self.claim("I7", p, t, (7, 0, 1, (0, 0, 0), (1, 1, 0)))
        self.claim("I7", p, t, (7, 0, 1, (2, 1, 1), (0, 0, 0)))
        self.claim("I7", p, t, (7, 0, 0, (2, 1, 1), (2, 1, 1)))
        self.claim("I7", p, t, (7, 0, 2, (1, 0, 0), (1, 0, 0)))
        self.claim("I7", p, t, (7, 0, 3, (1, 2, 0), (1, 2, 0)))
        self.claim("ACCEPT", p, t, (7, 0, 4, (1, 0, 0), (1, 0, 0)))     # the same position, another vertex
        self.claim("I7", p, t, (7, 0, 5, (1, 0, 0), (0, 1, 0)))
        self.claim("I7", p, t, (7, 5, 3, (1, 0, 0), (1, 0, 0)))
        self.claim("I7", p, t, (7, 5, 1, (1, 0, 0), (1, 0, 0)))
        great = 256 ** 4095                               # of 4096 bytes
        self.claim("ACCEPT", p, t, (7, 1, 0, (great, great, 0), (2 * great, great, great)))
        self.claim("B1", p, t, (7, 1, 0, (256 * great, 256 * great, 0), (2 * great, great, great)))
        p = [(0, 0, 0), (2, 0, 0), (4, 0, 0), (2, -1, -1), (2, 1, -1), (2, 0, 2)]
        t = [(0, 1, 2), (3, 4, 5)]                        # (0, 1, 2) has no area
        self.claim("I7", p, t, (7, 0, 1, (1, 0, 1), (1, 1, 1)))
        self.claim("I7", p, t, (7, 1, 0, (1, 1, 1), (1, 0, 1)))
        self.claim("ACCEPT", p[:2] + [(4, 0, 1)] + p[3:], t, (7, 0, 1, (0, 1, 0), (1, 1, 1)))

    def test_i7_of_a_cube_that_a_tetrahedron_pierces(self):
        _, f, g, w, x = self.crossing()
        zero = [0, 0, 0]
        for expected, witness in (
                ("ACCEPT", (f, g, w, x)), ("ACCEPT", (g, f, x, w)), ("ACCEPT", (f, g, [c << 3000 for c in w], [3 * c for c in x])), ("I7", (f, g, [w[0] + 1] + w[1:], x)),
                ("I7", (f, g, w, x[:2] + [x[2] + (1 << 2000)])), ("I7", (f, g, zero, x)), ("I7", (f, g, w, zero)), ("I7", (f, g, zero, zero)),
                ("I7", (f, f, w, w))):
            self.shape_claim(expected, CROSSED, (7, *witness))
        # Neighbours meet in their common edge only; a common corner does not count.
        self.shape_claim("I7", models.TET, (7, 0, 1, (1, 0, 0), (1, 0, 0)))
        self.shape_claim("I7", models.TET, (7, 0, 1, (1, 0, 1), (1, 1, 0)))

    def test_i7_corners_in_and_on_triangles(self):
        p = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, 0), (9, 9, 9), (2, 0, 0)]
        t = [(0, 1, 2), (0, 1, 3), (3, 4, 2), (0, 1, 5), (1, 1, 4)]        # the last two have no area, which is the business of M1
        for expected, *w in (("ACCEPT", 1, 0, (0, 0, 1), (2, 1, 1)), ("ACCEPT", 2, 0, (1, 0, 0), (2, 1, 1)), ("ACCEPT", 0, 1, (2, 1, 1), (0, 0, 1)),
                             ("I7", 1, 0, (0, 0, 1), (1, 1, 1)), ("I7", 3, 1, (0, 0, 1), (1, 1, 0)), ("I7", 1, 3, (1, 1, 0), (0, 0, 1)),
                             ("I7", 0, 4, (0, 1, 0), (1, 0, 0))):
            self.claim(expected, p, t, (7, *w))

    def test_i7_far_and_near(self):
        """Coordinates of very different size, and of both signs."""
        for e in (1, 2.0 ** -60, 2.0 ** -600, 5e-324, 1e300):
            for s in (1, -1):
                p = [(-3 * s, -1, -e), (5 * s, -2, -e), (s, 7, -e), (s, 1, -e), (s, 1, e), (2 * s, 1, e)]
                self.use(forge.Model(p, [(0, 1, 2), (3, 4, 5)]))
                f, g, w, x = forge.crossing_witness(self.mesh, 0, 1)
                self.claim("ACCEPT", p, [(0, 1, 2), (3, 4, 5)], (7, f, g, w, x))
                self.claim("I7", p, [(0, 1, 2), (3, 4, 5)], (7, f, g, x, w))

    def test_i8_i9_of_cubes(self):
        # PROVES MESH-9.M8: the witness holds on inward shells, and on no face of a solid (above).
        nest = BROKEN[9]
        # A triangle through the point P of face 0 or 1 itself: not applicable there.
        touch = models.join(models.turned(CUBE), ([(0, 0, 0), (0, 1, 0), (0, 0.75, 1.25)], [(0, 1, 2)]))
        sums = [forge.stab_sum(self.shape(touch).mesh, f, 0) for f in (0, 1)]
        self.assertIn(None, sums)
        for rule in (8, 9):
            no = "I%d" % rule
            # The first face of the cube is at x = 0: its normal has no part along y.
            for expected, mesh, f, u in (("ACCEPT", models.turned(CUBE), 0, 0), (no, CUBE, 0, 0), (no, models.turned(CUBE), 0, 1),
                                         ("ACCEPT", nest, 12, 0), (no, nest, 0, 0)):
                self.shape_claim(expected, mesh, (rule, f, u))
            for f in (0, 1):
                self.shape_claim("ACCEPT" if sums[f] else no, touch, (rule, f, 0))

    def test_i8_i9(self):
        for rule in (8, 9):
            self.claim("I%d" % rule, TET_POINTS, TET, (rule, 2, 0))
            self.claim("I%d" % rule, TET_POINTS, TET, (rule, 0, 0))
            self.claim("ACCEPT", TET_POINTS, solids.reverse(TET), (rule, 0, 2))
            self.claim("ACCEPT", TET_POINTS, solids.reverse(TET), (rule, 2, 1))
            self.claim("I%d" % rule, TET_POINTS, solids.reverse(TET), (rule, 0, 1))
        outer, inner = solids.box_of(3), solids.box_of(1)
        for f in range(24):
            for u in range(3):
                p, t = solids.join(outer, inner)
                self.use(forge.Model(p, t))
                good = bool(forge.stab_sum(self.mesh, f, u))
                self.claim("ACCEPT" if good else "I8", p, t, (8, f, u))
                self.assertEqual(good, f >= 12 and self.mesh.n[f][u] != 0)

    def test_i8_a_triangle_through_the_point_proves_nothing(self):
        p = TET_POINTS + [(-1, -1, 1), (3, -1, -1), (-1, 3, -1)]            # through P of (0, 1, 2)
        a, b, c = (0, 0, 0), (4, 0, 0), (0, 4, 0)
        p = [a, b, c, (0, 1, 1), (2, 1, -1), (0, 3, -2)]
        self.use(forge.Model(p, [(0, 1, 2), (3, 4, 5)]))
        self.assertIsNone(forge.stab_sum(self.mesh, 0, 2))
        self.claim("I8", p, [(0, 1, 2), (3, 4, 5)], (8, 0, 2))
        p += [(0, 0, 5), (4, 0, 5), (0, 4, 5)]
        self.claim("I8", p, [(0, 1, 2), (3, 4, 5), (6, 7, 8)], (8, 0, 2))
        self.claim("ACCEPT", p, [(0, 1, 2), (6, 7, 8)], (8, 0, 2))
        self.claim("ACCEPT", p, [(0, 1, 2), (6, 8, 7)], (8, 0, 2))
        self.claim("I8", p, [(0, 1, 2), (6, 8, 7), (6, 7, 8)], (8, 0, 2))

    def test_a_line_stabs_a_triangle_of_the_least_area(self):
        for axis in range(3):
            def at(p, q):
                return tuple((0, p, q)[(k - axis) % 3] for k in range(3))
            square = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)]
            for turn in range(3):
                for triangle, hit in (((0, 1, 2), True), ((0, 2, 3), False)):  # moved by (e, e^2) the corner (0, 0) is in the first
                    t = [square[triangle[(i + turn) % 3]] for i in range(3)]
                    self.assertEqual(mesh_model.line_stabs(t, at(0, 0), axis), hit)
                    self.assertEqual(mesh_model.line_stabs(t[::-1], at(0, 0), axis), hit)

    def test_i8_the_ray_is_moved_off_edges_and_vertices(self):
        base = [(0, 0, 0), (4, 0, 0), (0, 4, 0)]           # P = (1, 1, 0), moved by (e, e^2) in (x, y)
        for triangle, hit in ((((1, 0, 5), (9, 0, 5), (1, 9, 5)), True), (((1, 0, 5), (-9, 0, 5), (1, 9, 5)), False),
                              (((0, 1, 5), (9, 1, 5), (1, 9, 5)), True), (((0, 1, 5), (9, 1, 5), (1, -9, 5)), False),
                              (((1, 1, 5), (9, 0, 5), (9, 9, 5)), True), (((1, 1, 5), (9, 1, 5), (9, 9, 5)), True),
                              (((1, 1, 5), (9, 1, 5), (9, -9, 5)), False), (((1, 1, 5), (1, 9, 5), (9, 9, 5)), False),
                              (((1, 1, 5), (1, 9, 5), (9, 2, 5)), False), (((1, 1, 5), (0, 9, 5), (9, 1, 5)), True),
                              (((0, 0, 5), (2, 2, 5), (2, 0, 5)), True), (((0, 0, 5), (2, 2, 5), (0, 2, 5)), False),
                              (((0, 0, -5), (9, 0, -5), (0, 9, -5)), False), (((1, 0, 5), (1, 9, 5), (1, 0, 9)), False)):
            for turn in range(3):
                p = base + list(triangle[turn:] + triangle[:turn])
                p = [tuple(c[(k - turn) % 3] for k in range(3)) for c in p]        # axis z becomes axis (2 + turn)
                self.claim("ACCEPT" if hit else "I8", p, [(0, 1, 2), (3, 4, 5)], (8, 0, (2 + turn) % 3))
                self.claim("ACCEPT" if hit else "I8", p, [(0, 1, 2), (4, 3, 5)], (8, 0, (2 + turn) % 3))

    def test_i10(self):
        tris = [(0, 1, 2)] + TET[1:]
        self.shape_claim("I10", OPEN, (3, 1, 2), rules=["M1"])
        self.shape_claim("I10", OPEN, (3, 1, 2), rules=["M1", "M3"])
        self.shape_claim("I10", OPEN, (3, 1, 2), rules=["M3", "M4"])
        for rules in (["M3"], ["M5", "M7"], ["M3", "M5"]):
            self.claim("I10", TET_POINTS, tris, (5, 0, 1), rules=rules)
        self.claim("I10", TET_POINTS, TET[1:], (3, 0, 1), (3, 1, 2), rules=["M3", "M7"])
        self.claim("ACCEPT", TET_POINTS, TET[1:], (3, 0, 1), (3, 1, 2), rules=["M3"])


class InProcess(CertificateTest):
    """What only the Python checker can be asked: with limits set, with parts broken, one function of it."""

    def needed(self, conditions, cert):
        """The certificate is rejected by the first of the conditions; all others accept it. V3 and V5 are implied by the second one."""
        code, line = vc._check(self.bytes, cert, frozenset(conditions[1:]))
        self.assertEqual(attacks.condition_of(code, line), conditions[0], line)
        code, line = vc._check(self.bytes, cert, frozenset(conditions))
        self.assertEqual(code, 0, (conditions, line))

    def test_each_condition_of_valid_is_needed(self):
        flat = TET_POINTS + [(0.5, 0, 0)], [(0, 2, 4), (4, 2, 1), (0, 4, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
        two_sided = TET_POINTS + [(9, 0, 0), (9, 1, 0), (9, 0, 1)], TET + [(4, 5, 6), (4, 6, 5)]
        double = solids.copy_at_vertex(TET_POINTS, TET, self.rng)
        for conditions, mesh, as_indexed, changes in (
                (["V1"], models.TET, False, {"order": [0, 1, 2, 2]}), (["V2"], double, True, {}), (["V3", "V9"], flat, False, {}),
                (["V4"], (TET_POINTS, [(0, 1, 2)] + TET[1:]), False, {}), (["V5", "V10"], two_sided, False, {"values": {"bodies": 2}}),
                (["V6"], double, False, {}), (["V7"], models.TET, False, {"stars": {0: 1}}),
                (["V8"], TWO, False, {"cut": lambda a, b, k: (-1, 0, 0) if k == 0 else None, "order": [0, 1, 2, 4, 3, 5, 6, 7]}),
                (["V9"], models.TET, False, {"extra_codes": b"\0"}), (["V10"], BROKEN[9], False, {"values": {"bodies": 1}}),
                (["V11"], models.TET, False, {"values": {"genus": 1}})):
            with self.subTest(conditions=conditions):
                self.shape(mesh, as_indexed)
                self.needed(conditions, self.cert(self.plan(**changes)))

    def test_each_condition_of_invalid_is_needed(self):
        for witness in ((1, 0), (2, 0, 1), (3, 0, 1), (4, 0, 1), (5, 0, 1), (6, 0), (7, 0, 1, (1, 0, 0), (0, 1, 0)), (8, 0, 0), (9, 0, 0)):
            self.needed(["I%d" % witness[0]], forge.invalid_certificate(self.bytes, self.model, self.mesh, [witness]))
        self.use(forge.Model(TET_POINTS, TET[1:]))
        self.needed(["I10"], forge.invalid_certificate(self.bytes, self.model, self.mesh, [(3, 0, 1)], ["M4"]))

    def test_missing_memory_is_exit_3(self):
        with unittest.mock.patch.object(reader, "read_model", side_effect=MemoryError):
            self.assertEqual(vc.check(self.bytes, self.cert()), (3, "ERROR: out of memory"))

    def test_a_bug_is_exit_5(self):
        self.assertEqual(vc.check(self.bytes, None)[0], 5)

    def walks(self, m, allowed, separator=None):
        """Triangles whose boxes all meet: m of them take all (m - 1)^2 calls of cross."""
        tris = [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(m)]
        points = [(x + i / 128, y + i / 64, z) for i in range(m) for x, y, z in ((0., 0., 0.), (99., 1., 0.), (1., 99., 1.))]

        class Body:
            order, stars, codes, work = list(range(m)), [0] * len(points), b"", allowed
            separators = [separator] if separator else []
        try:
            mesh_valid.Walk(Body, mesh_model.Mesh(points, tris), {"V8", "V9"}).run()
        except Reject as e:
            self.assertEqual(e.condition, "B1")
            return False
        return True

    def test_b1_too_much_work(self):
        for m in (2, 3, 8, 21):
            units = (m - 1) ** 2
            self.assertTrue(self.walks(m, units))
            self.assertFalse(self.walks(m, units - 1))
            last = units - 1, (1, 0, 0)                   # in the place of the last call of all, a leaf pair: 2 units more
            self.assertTrue(self.walks(m, units + 2, last))
            self.assertFalse(self.walks(m, units + 1, last))

    def test_b1_work_of_witnesses(self):
        p, fans = solids.copy_at_vertex(TET_POINTS, TET, self.rng)          # two cycles at vertex 1
        flipped = [(0, 1, 2)] + TET[1:]
        crossing = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, -1), (1, 1, 1), (9, 9, 1)]
        for points, tris, witness, units in (
                (p, fans, (6, 1), 6), (TET_POINTS, TET[1:], (3, 0, 1), 2), (TET_POINTS, TET + [(0, 1, 2)], (4, 0, 1), 4),
                (TET_POINTS, flipped, (5, 0, 1), 3), (TET_POINTS, solids.reverse(TET), (8, 0, 2), 4),
                (TET_POINTS, solids.reverse(TET), (9, 0, 2), 4), (TET_POINTS, TET + [(1, 2, 0)], (2, 4, 0), 0),
                (TET_POINTS, TET + [(0, 1, 1)], (1, 4), 0), (crossing, [(0, 1, 2), (3, 4, 5)], (7, 0, 1, (2, 1, 1), (1, 1, 0)), 0)):
            self.use(forge.Model(points, tris))
            cert = forge.invalid_certificate(self.bytes, self.model, self.mesh, [witness] * 3)
            with unittest.mock.patch.object(mesh_model.Body, "work", lambda *_: 3 * units):
                self.says("ACCEPT", cert)
            with unittest.mock.patch.object(mesh_model.Body, "work", lambda *_: 3 * units - 1):
                self.says("B1", cert)

    def test_b1_work_of_the_nesting(self):
        """One unit for each box that the rays look into, over all shells."""
        inner = solids.box_of(1)
        self.use(forge.Model(*solids.join(solids.box_of(3), (inner[0], solids.reverse(inner[1])))))
        cert, run = self.cert(), mesh_valid.Walk.run

        def boxes(order, f_boxes, ray):                   # of the subtree of an order, by its definition
            lo, hi = [[pick(f_boxes[f][side][k] for f in order) for k in range(3)] for side, pick in ((0, min), (1, max))]
            v, u, minus = ray
            p, q = (u + 1) % 3, (u + 2) % 3
            if not (lo[p] <= v[p] < hi[p] and lo[q] <= v[q] < hi[q] and (lo[u] <= v[u] if minus else hi[u] >= v[u])) or len(order) == 1:
                return 1
            half = len(order) // 2
            return 1 + boxes(order[:half], f_boxes, ray) + boxes(order[half:], f_boxes, ray)
        f_boxes = [tuple(zip(*box)) for box in self.mesh.box]
        plan = self.plan()
        units = 0
        for faces, code in zip(plan.shells, plan.nesting):
            u, minus = divmod(code, 2)
            vertices = [self.mesh.p[v] for f in faces for v in self.mesh.tris[f]]
            extreme = (min if minus else max)(p[u] for p in vertices)
            first = min(v for f in faces for v in self.mesh.tris[f] if self.mesh.p[v][u] == extreme)
            units += boxes(plan.order, f_boxes, (self.mesh.p[first], u, minus))
        for allowed, expected in ((units, "ACCEPT"), (units - 1, "B1")):
            def run_and_set(walk, allowed=allowed):
                run(walk)
                walk.cert.work = allowed
            with unittest.mock.patch.object(mesh_valid.Walk, "run", run_and_set):
                self.says(expected, cert)

    def test_v8_compare(self):
        tip = [(0, 0, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
        self.use(forge.Model(*solids.join((TET_POINTS, TET), (tip, solids.reverse(TET)))))
        points, tris = forge.mesh_of(self.model).floats, self.mesh.tris
        mesh = mesh_model.Mesh(points, tris)
        self.assertEqual(mesh_valid.compare((-1, -1, -1), [0, 1, 2, 3], [0, 4, 5, 6], mesh.points), 1)
        self.assertEqual(mesh_valid.compare((-1, 0, 0), [0, 1, 2, 3], [0, 4, 5, 6], mesh.points), ([0, 2, 3], [0, 5, 6]))
        self.assertEqual(mesh_valid.compare((1, 0, 0), [0, 1, 2, 3], [0, 4, 5, 6], mesh.points), 0)
        line = mesh_model.Mesh([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.0, 1.0, 0.0)], [(0, 1, 3)])
        self.assertEqual(mesh_valid.compare((0, 1, 0), [0, 1], [1, 2], line.points), ([0, 1], [1, 2]))
        self.assertEqual(mesh_valid.compare((0, 0, 1), [0, 1], [1, 3], line.points), 1)
        self.assertEqual(mesh_valid.compare((0, 1, 0), [0, 2], [0, 2], line.points), 1)


class CommandLine(unittest.TestCase):
    PROGRAM, VERSION = [sys.executable, PROGRAM], vc.VERSION

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.model, self.certificate = pathlib.Path(folder.name, "m.off"), pathlib.Path(folder.name, "c")
        model = forge.Model(TET_POINTS, TET)
        self.model.write_bytes(model.encode())
        self.certificate.write_bytes(forge.Plan(forge.mesh_of(model), random.Random(1)).certificate(model.encode(), model))

    def run_it(self, *args, **how):
        r = subprocess.run([*self.PROGRAM, *map(str, args)], capture_output=True, text=True, timeout=120, check=False, **how)
        return r.returncode, r.stdout.strip(), r.stderr.strip()

    def test_answers(self):
        code, out, err = self.run_it(self.model, self.certificate)
        self.assertEqual((code, out.split(":")[0], err), (0, "ACCEPT mesh-valid-1", ""))
        self.assertEqual(self.run_it(self.model, self.model)[0], 1)
        self.certificate.write_bytes(self.certificate.read_bytes() + b"x")
        code, out, err = self.run_it(self.model, self.certificate)
        self.assertEqual((code, out[:10], err), (1, "REJECT S4:", ""))

    def test_an_answer_that_is_not_printed_is_none(self):
        environment = {k: v for k, v in os.environ.items() if k != "PYTHONUNBUFFERED"}
        with open("/dev/full", "w", encoding="ascii") as full:
            r = subprocess.run([*self.PROGRAM, self.model, self.certificate], stdout=full, stderr=full, env=environment, check=False)
            self.assertEqual(r.returncode, 4)

    def test_usage(self):
        for args in ([], ["a"], ["a", "b", "c", "d"], ["--what"], ["--help", "x"], ["--what", "x"], ["--skip", "V9"]):
            code, out, err = self.run_it(*args)
            self.assertEqual((code, out, "usage" in err), (2, "", True), args)
        for word in ("--help", "-h"):
            code, out, err = self.run_it(word)
            self.assertEqual((code, "MODEL CERT" in out, err), (0, True, ""))
        self.assertEqual(self.run_it("--version"), (0, self.VERSION, ""))

    def test_files_that_cannot_be_read(self):
        folder, none = self.model.parent, self.model.parent / "none"
        for args in ((self.model, folder), (folder, self.certificate), (self.model, none), (none, self.certificate)):
            code, out, err = self.run_it(*args)
            self.assertEqual((code, out, bool(err)), (4, "", True))

    def test_missing_memory_is_exit_3(self):
        with self.model.open("r+b") as hole:              # more than any memory
            hole.truncate(1 << 42)
        self.assertEqual(self.run_it(self.model, self.certificate)[0], 3)


if __name__ == "__main__":
    unittest.main()
