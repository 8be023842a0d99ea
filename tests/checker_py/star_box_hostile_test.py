#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates: damaged bodies and models, and how strictly models in JSON are read."""
import copy
import json
import random
import unittest
from fractions import Fraction as Q

import star_box_forge as forge
import star_box_models as models
import star_box_test as star

SCALE, UNIT, vc = star.SCALE, star.UNIT, star.vc


class Hostile(star.StarBoxTest):
    """Bytes by someone who wants a crash, a hang or a wrong ACCEPT."""

    def judged(self, model, cert, note):
        code, line = vc.check(model, cert)
        self.assertIn(code, (0, 1, 4), (note, line))
        return code

    def test_bytes_of_the_body(self):
        rng, codes = random.Random(1), [0] * 5
        for prover in (forge.Prover(models.cube()).prove(), forge.Prover(models.tetrahedron(), factor=2).prove()):
            body = prover.plan.body()
            for trial in range(900 * SCALE):
                lie = forge.bent(rng, body)
                plan = copy.copy(prover.plan)
                plan.body = lambda: lie
                codes[self.judged(prover.model, plan.certificate(prover.model), (trial, lie.hex()))] += 1
        self.assertGreater(codes[1], 500)

    def test_bytes_of_the_model(self):
        rng = random.Random(2)
        prover = forge.Prover(models.octant_sphere()[:2], checked=False)
        prover.plan.boxes, prover.plan.trees = [forge.Box(1, [0] * 3, [UNIT] * 3)], [[0], [0]]
        for trial in range(600 * SCALE):
            lie = bytearray(prover.model)
            for _ in range(rng.randint(1, 4)):
                at = rng.randrange(len(lie))
                lie[at:at + rng.randint(0, 3)] = bytes(rng.choice(b'0123456789"[]{},:/-e.x\xff\x00 ') for _ in range(rng.randint(0, 3)))
            self.judged(bytes(lie), prover.plan.certificate(bytes(lie)), (trial, bytes(lie)))

    def test_models_that_are_refused(self):
        good = json.loads(forge.encode_model(models.cube()[:1] + models.tetrahedron()[:1]))
        plan = forge.Prover(models.cube()).prove().plan

        def refused(change):
            model = copy.deepcopy(good)
            result = change(model)
            data = result if isinstance(result, bytes) else json.dumps(model).encode()
            self.assertEqual(self.judged(data, plan.certificate(data), str(data[:200])), 4, data[:900])

        def put(*path_and_value):
            *path, last, value = path_and_value

            def change(model):
                for key in path:
                    model = model[key]
                model[last] = value
            return change

        shape = ("entities", 0, "shape")
        for change in (put("format", "veritope-spline-2"), put("extra", 1), put("groups", {}), put("entities", 0, "kind", "blob"),
                       put("entities", 0, "group", 0), put(*shape, "degrees", [1]), put(*shape, "degrees", [0, 1]), put(*shape, "degrees", [1, 64]),
                       put(*shape, "degrees", [1, True]), put(*shape, "periodic", [0, 0]), put(*shape, "periodic", [True, False]),
                       put(*shape, "components", 4), put(*shape, "components", 10 ** 9), put(*shape, "rational", True),
                       put(*shape, "knots", 0, ["0", "0", "1"]), put(*shape, "knots", 0, ["0", "1", "1", "2"]), put(*shape, "knots", 0, ["0", "1", "0", "1"]),
                       put(*shape, "knots", 0, ["0", "0", "0", "0"]), put(*shape, "knots", 0, ["0", "0", "0", "1", "1"]),
                       put(*shape, "points", []), put(*shape, "points", 0, ["1", "2"]), put(*shape, "points", 0, [1, "1", "1"]),
                       lambda m: m["entities"][0]["shape"]["points"][0].append(m["entities"][0]["shape"]["points"][1].pop(0)),
                       lambda m: m["entities"][0]["shape"].update(rational=True, components=1, points=[["1"]] * 4),
                       put("entities", 1, "shape", "degree", 64), put("entities", 1, "shape", "degree", 2), put("entities", 1, "shape", "rational", 1),
                       lambda m: b"", lambda m: b"\xff\xfe", lambda m: b"[" * 100000, lambda m: b'{"a":' * 100000, lambda m: b"1" * 10 ** 6,
                       lambda m: b'{"format":1e5}', lambda m: b'{"format":NaN}', lambda m: b'{"format":"a","format":"b"}',
                       lambda m: json.dumps({"format": "veritope-spline-1", "entities": [], "groups": []}).encode()):
            refused(change)
        weight = models.torus()[:1]
        weight[0]["shape"]["points"][0][3] = "0"
        data = forge.encode_model(weight)
        self.assertEqual(self.judged(data, plan.certificate(data), "weight"), 4)

    def read_as_json(self, kind, shape, name="A", key="name"):
        """Is a model with one more entity read, or refused?  An entity of another kind has a shape that is not examined."""
        prover = forge.Prover(models.cube(), checked=False)
        text = prover.model.decode().replace('"groups": []', '"groups": [{"%s": "%s", "parent": null, "attributes": []}]' % (key, name), 1)
        text = text[:-2] + ', {"kind": "%s", "group": 0, "attributes": [], "shape": %s}]}' % (kind, shape)
        data = text.encode("utf-8", "surrogateescape")
        return self.judged(data, prover.plan.certificate(data), data) != 4

    def test_json_is_read_strictly(self):
        for kind in ("curve", "volume", "trimmed", "model", "m\\u006fdel"):
            self.assertTrue(self.read_as_json(kind, '{"a": [{"b": [1, -23, true, null, {}]}, "c"]}'), kind)
        for shape in ("[]", "1", '"a"', "null", "{,}", '{"a": 1.5}', '{"a": 1e5}', '{"a": nul}', '{"a": NaN}', '{"a": -}', '{"a": 01}', '{"a": 1, "a": 1}', '{"a": 1, "\\u0061": 1}',
                      '{"a": 1234567890123456}', '{"a": [1,]}', '{"a": 1,}', '{"a" 1}', '{"\\ud800": 1}', '{"a": ["\\ud800"]}', '{"a": "\\x"}', "{'a': 1}"):
            self.assertFalse(self.read_as_json("curve", shape), shape)
        for depth in (99, 100):
            self.assertEqual(self.read_as_json("curve", '{"a": %s}' % ("[" * (depth - 1) + "1" + "]" * (depth - 1))), depth == 99)
        for name in (r"\u20ac\ud83d\ude00", r'\"\\\/\b\f\n\r\t\u0000', "\u20ac\U0001f600\x7f"):
            self.assertTrue(self.read_as_json("curve", "{}", name), name)
        for name in ("\\ud800", "\\udc00", "\\ud800\\u0041", "\\ud800x", "\\q", "\\u12", "\\u12g4", "\\", "\n", "\x1f", "\udc80", "\udcc0\udc80", "\udced\udca0\udc80",
                     "\udcf4\udc90\udc80\udc80", "\udcc3", "\udcff", "\udce2\udc82"):
            self.assertFalse(self.read_as_json("curve", "{}", name), ascii(name))
        self.assertTrue(self.read_as_json("curve", "{}", "A", "n\\u0061me"))

    def test_other_forms_of_a_number(self):
        prover = forge.Prover(models.cube()).prove()
        for one in ("+1", "1.", "01.0e+00", "10e-1", "1e-" + "0" * 16000, "0x1", "0X.8p+1", "7/7", "\\u0031"):
            data = prover.model.replace(b'"1"', b'"%s"' % one.encode())
            self.assertEqual(self.judged(data, prover.plan.certificate(data), one), 0, one)

    def test_a_period_shorter_than_the_degree(self):
        """One span, periodic: all control points are equal along it."""
        rows = [[(i, 1, 2)] * 3 for i in range(2)]
        entity = forge.surface(rows, degrees=(1, 2), knots=[[0, 0, 1, 1], [-2, -1, 0, 1, 2, 3]])
        entity["shape"]["periodic"][1] = True
        plan = forge.Plan([entity])
        data = forge.encode_model([entity])
        self.assertEqual(self.judged(data, plan.certificate(data), "periodic"), 1)
        entity["shape"]["points"][0][0] = "9"
        data = forge.encode_model([entity])
        self.assertEqual(self.judged(data, plan.certificate(data), "not periodic"), 4)

    def test_long_numbers_and_great_counts(self):
        prover = forge.Prover(models.cube()).prove()
        for name, value in (("unit", 4096), ("unit", -4096), ("roots", [[12, 12]] * 6),
                            ("breaks", [[[Q(0)] + [Q(i, 1 << 2000) for i in range(1, 9)] + [Q(1)]] * 2] * 6),
                            ("breaks", [[[Q(0)] + [Q(i, 5001) for i in range(1, 5000)] + [Q(1)]] * 2] * 6)):
            plan = copy.copy(prover.plan)
            setattr(plan, name, value)
            self.assertEqual(self.judged(prover.model, plan.certificate(), name), 1)
        high = [forge.surface([[(Q(i, 3 ** 1200), Q(j, 7 ** 500), (i * j) ** 15) for j in range(16)] for i in range(16)])]
        plan = forge.Plan(high)
        plan.roots, plan.trees, plan.boxes = [[0, 0]], [[0]], [forge.Box(1, [0] * 3, [1 << 60] * 3, shift=9)]
        model = forge.encode_model(high)
        self.assertEqual(self.judged(model, plan.certificate(model), "degree 15"), 1)

    def test_a_node_that_never_has_s1_ends_the_work(self):
        prover = forge.Prover(models.cube()).prove()
        plan = copy.deepcopy(prover.plan)
        for box in plan.boxes:
            box.plus = list(box.minus)
        self.says("C2", prover, plan=plan)


if __name__ == "__main__":
    unittest.main()
