#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The reading rule for .itd (docs/certificates/reading-rule-itd.md) in the Python checker: what a text means, what is refused, certificates."""
import hashlib
import json
import math
import random
import time
import unittest
from fractions import Fraction as Q

import star_box_forge as forge
import star_box_models as models

from veritope_checker import program as vc                # star_box_forge says where it is
from veritope_checker.patches import star_box_itd as itd

read = forge.read
FLAT = "[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0]]"
LINE = "[0 0 0] [1 0 0] [0 1 0] [1 1 0]"


def decimal(value):
    """Exactly; the value has one."""
    value = Q(value)
    for digits in range(400):
        scaled = value * 10 ** digits
        if scaled.denominator == 1:
            return "%de-%d" % (scaled, digits) if digits else "%d" % scaled
    raise ValueError("%s has no short decimal" % value)


def itd_text(entities):
    """Entities of the forge (surfaces without periodic axes) as BSPLINE surfaces."""
    out = []
    for entity in entities:
        shape = entity["shape"]
        p, q = shape["degrees"]
        m, n = len(shape["knots"][0]) - p - 1, len(shape["knots"][1]) - q - 1
        points = shape["points"]
        lines = ["[SURFACE BSPLINE %d %d %d %d %s" % (m, n, p + 1, q + 1, "P3" if shape["rational"] else "E3")]
        lines += ["[KV %s]" % " ".join(map(decimal, axis)) for axis in shape["knots"]]
        for j in range(n):
            for i in range(m):
                at = points[i * n + j]
                lines.append("[%s]" % " ".join(map(decimal, at[3:] + at[:3])))
        out.append("\n".join(lines) + "]\n")
    return "".join(out)


def hollow(model, subject_format="itd"):
    """A certificate that is rejected at once (B1) if its model is not refused (exit 4)."""
    body = b"none"
    statement = {"certificate": "veritope-certificate-1", "tool": "test", "claim": "star-box-1", "subject_sha256": hashlib.sha256(model).hexdigest(),
                 "subject_bytes": len(model), "subject_format": subject_format, "body_sha256": hashlib.sha256(body).hexdigest()}
    statement.update(dict.fromkeys(("patches", "edges", "vertices", "shells", "bodies", "genus", "boxes", "flipped"), 0))
    return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


def is_read(text):
    """By the checkers that vc.check stands for; exit 5 is neither."""
    model = text if isinstance(text, bytes) else text.encode("latin-1")
    code, line = vc.check(model, hollow(model))
    if code == 4:
        return False
    assert line.startswith("REJECT B1"), (text, line)
    return True


def entities_of(text):
    assert is_read(text), text
    return itd.Reader(text.encode("latin-1")).model()


def net(entity):
    """rows[u][v] of tuples."""
    return [[tuple(point) for point in row] for row in entity.rows]


class Meaning(unittest.TestCase):
    def test_u_is_fastest_and_the_weight_comes_first(self):
        (flat,) = entities_of(FLAT)
        self.assertEqual(net(flat), [[(0, 0, 0, 1), (0, 1, 0, 1)], [(1, 0, 0, 1), (1, 1, 0, 1)]])
        self.assertEqual((flat.degrees, flat.knots, flat.rational), ((1, 1), [[0, 0, 1, 1]] * 2, False))
        (weighted,) = entities_of("[SURFACE BEZIER 2 3 P3 [2 0 0 0] [1 1 0 0] [1 0 1 0] [1 1 1 0] [1 0 2 0] [1 1 2 0]]")
        self.assertEqual(net(weighted), [[(0, 0, 0, 2), (0, 1, 0, 1), (0, 2, 0, 1)], [(1, 0, 0, 1), (1, 1, 0, 1), (1, 2, 0, 1)]])
        self.assertEqual((weighted.degrees, weighted.rational), ((1, 2), True))

    def test_decimals_are_exact(self):
        for word, value in (("0.1", Q(1, 10)), ("-.5e-2", Q(-1, 200)), ("+7.", 7), ("1e3", 1000), ("1E+03", 1000), ("0.1e0000000004096", 10 ** 4095),
                            ("0" * 990 + "1e-1", Q(1, 10)), ("0." + "0" * 998 + "1", Q(1, 10 ** 999)), ("3.0000000000000001", 3 + Q(1, 10 ** 16))):
            (flat,) = entities_of(FLAT.replace("[0 0 0]", "[0 0 %s]" % word))
            self.assertEqual(net(flat)[0][0][2], value, word)

    def test_knots_and_repeated_points(self):
        text = "[SURFACE BSPLINE 3 2 2 2 E3 [KV 0 0 .5 1 1][KV -1 0 1 2] [0 0 0][1 0 0][2 0 0] [0 1 0][1 1 0][2 1 0]]"
        (plain,) = entities_of(text)
        self.assertEqual(plain.knots, [[0, 0, Q(1, 2), 1, 1], [-1, 0, 1, 2]])
        ring = "[SURFACE BSPLINE 4 2 3 2 E3 [KVP %s][KV 0 0 1 1] [0 0 0][1 0 0][1 1 0][0 1 0] [0 0 1][1 0 1][1 1 1][0 1 1]]"
        for knots in ("0 1 2 3 4 5 6 7 8", "0 1 2 3 4 5 6.5 7 8"):               # the period does not matter
            (closed,) = entities_of(ring % knots)
            self.assertEqual([row[0] for row in net(closed)], [(0, 0, 0, 1), (1, 0, 0, 1), (1, 1, 0, 1), (0, 1, 0, 1), (0, 0, 0, 1), (1, 0, 0, 1)])

    def test_power_basis(self):
        (parabola,) = entities_of("[SURFACE POWER 3 2 E3 [1 0 0] [1 0 2] [0 0 3] [0 1 0] [0 0 0] [0 0 6]]")  # (1 + u, v, 2u + 3u^2 + 6u^2 v)
        self.assertEqual(parabola.degrees, (2, 1))
        self.assertEqual(net(parabola), [[(1, 0, 0, 1), (1, 1, 0, 1)], [(Q(3, 2), 0, 1, 1), (Q(3, 2), 1, 1, 1)], [(2, 0, 5, 1), (2, 1, 11, 1)]])
        (weights,) = entities_of("[SURFACE POWER 2 2 P3 [1 0 0 0] [1 1 0 0] [0 0 1 0] [0 0 0 0]]")
        self.assertEqual([[p[3] for p in row] for row in net(weights)], [[1, 1], [2, 2]])

    def test_long_coefficients_in_the_power_basis_take_no_time(self):
        """Sums of fractions of 14,000 bits: reduced one by one they took ten seconds for these 6 kB."""
        rng, words = random.Random(5), ("1", "3e4096", "7e2000", "1e-4096", "3e-2000", "7e-3000", "0", "-1")
        given = [[rng.choice(words) for _ in range(3)] for _ in range(256)]
        start = time.process_time()
        (long,) = entities_of("[SURFACE POWER 16 16 E3 %s]" % " ".join("[%s]" % " ".join(p) for p in given))
        self.assertLess(time.process_time() - start, 5)
        for i, j in ((0, 0), (1, 0), (2, 3), (15, 15)):
            wanted = [sum(Q(math.comb(i, r) * math.comb(j, s), math.comb(15, r) * math.comb(15, s)) * Q(given[16 * s + r][c])
                          for r in range(i + 1) for s in range(j + 1)) for c in range(3)]
            self.assertEqual(list(long.rows[i][j]), wanted + [1], (i, j))

    def test_objects_attributes_and_comments_change_nothing(self):
        wanted = [net(e) for e in entities_of(FLAT + FLAT.replace("1 1 0", "1 1 2"))]
        text = ('junk ] " here\n[OBJECT [color 5] [a "]" [b [SURFACE x]]] "A B" [OBJECT [MATRIX 1 0 [ ] "\\"]"] C\v\n' +
                FLAT.replace("BEZIER", "BEZIER [rgb \"1,2\"] [u [KV 1]]") + "]][OBJECT][NUMBER 3] text [ MULTIVAR BEZIER [c 1] 2 " +
                FLAT[len("[SURFACE BEZIER "):].replace("1 1 0", "1 1 2") + "] the end ]]]")
        self.assertEqual([net(e) for e in entities_of(text)], wanted)
        self.assertEqual([net(e) for e in entities_of("\u00ef\u00bb\u00bf" + text)], wanted)

    def test_a_file_without_surfaces_is_read(self):
        self.assertEqual(entities_of("[OBJECT NONE]"), [])


class Refusals(unittest.TestCase):
    def refused(self, *texts):
        for text in texts:
            with self.subTest(text):
                self.assertFalse(is_read(text))

    def test_other_geometry_and_other_groups(self):
        self.refused(*("[OBJECT A %s [%s 1]]" % (FLAT, word) for word in ("CURVE", "TRIVAR", "TRIMSRF", "MODEL", "POLYGON", "POLYLINE", "POINTLIST",
                                                                          "POLYSTRIP", "TRISRF", "INSTANCE")))
        self.refused("[ATTRIBUTE]" + FLAT, "[object A]", "[[OBJECT]]", '["OBJECT"]', "", "no group", '" ]')
        self.refused(FLAT.replace("SURFACE BEZIER", "MULTIVAR BEZIER 3"), FLAT.replace("SURFACE BEZIER", "MULTIVAR BEZIER"))

    def test_brackets_strings_names(self):
        for n in range(len(FLAT)):                        # every truncation
            self.refused("[OBJECT A " + FLAT[:n])
        self.refused(FLAT[:-1], "[OBJECT A", "[OBJECT A B]", '[OBJECT "A" "B"]', '[OBJECT "A]', '[OBJECT "A\\"]', "[NUMBER 3", '[OBJECT [a "]"]')

    def test_headers(self):
        self.refused(*(FLAT.replace("2 2", n) for n in ("2", "0 2", "2 -2", "1 2", "2 1", "2.0 2", "2e0 2", "2 x", "1000000000000 1000000000000", "3 2")))
        self.refused(*(FLAT.replace("E3", t) for t in ("E2", "E4", "P2", "e3", "E33", "E", "3")))
        self.refused(FLAT.replace("BEZIER", "bezier"), FLAT.replace("BEZIER", ""), FLAT.replace("BEZIER", "BEZIER [KV 0]"), FLAT.replace("E3", "E3 [a]"))
        self.refused("[SURFACE BEZIER 65 2 E3 %s]" % (" [0 0 0]" * 130))
        self.assertTrue(is_read("[SURFACE BEZIER 64 2 E3 %s]" % (" [0 0 0]" * 128)))

    def test_points(self):
        self.refused(FLAT.replace("[1 1 0]", ""), FLAT.replace("[1 1 0]", "[1 1 0] [1 1 0]"), FLAT.replace("[1 1 0]", "[1 1]"), FLAT.replace("[1 1 0]", "[1 1 0 0]"),
                     FLAT.replace("[1 1 0]", "[[a] 1 1 0]"), FLAT.replace("[1 1 0]", "1 1 0"), FLAT.replace("[1 1 0]", '["1" 1 0]'))
        weighted = "[SURFACE BEZIER 2 2 P3 [1 0 0 0] [1 0 0 0] [1 0 0 0] [%s 0 0 0]]"
        self.assertTrue(is_read(weighted % "1e-9"))
        self.refused(weighted % "0", weighted % "-1", "[SURFACE POWER 2 2 P3 [1 0 0 0] [-1 0 0 0] [0 0 0 0] [0 0 0 0]]")

    def test_decimals(self):
        self.refused(*(FLAT.replace("[1 1 0]", "[1 1 %s]" % w) for w in ("x", "1,5", "1/2", "0x1", "nan", "inf", ".", "-", "+-1", "1e", "1e+", "e5", ".e5", "1.2.3", "1e5.0",
                                                                         "1e4097", "1e-4097", "0" * 1001, "1" * 1001, "1e99999999999999999999", "\u00b2", "1\0")))

    def test_knots(self):
        text = "[SURFACE BSPLINE 3 2 2 2 E3 %s [KV 0 0 1 1]" + LINE.replace("[1 ", "[.5 0 0] [1 ") + "]"
        self.assertTrue(is_read(text % "[KV 0 0 1 2 2]"))
        self.refused(*(text % k for k in ("[KV 0 0 1 2]", "[KV 0 0 1 2 2 2]", "[KV 0 0 2 1 2]", "[KV 0 0 0 1 1]", "[KV 0 0 0 0 0]", "[KV 0 1 1 1 2]", "[kv 0 0 1 2 2]", "",
                                          "[KVP 0 0 1 2 2]", "[KV 0 0 1 2 [2]]", "KV 0 0 1 2 2", "[KV 0 0 1 2 2] [KV 0 0 1 1]")))


class Certificates(unittest.TestCase):
    def check(self, entities, **values):
        prover = forge.Prover(entities).prove()
        prover.plan.values["subject_format"] = "itd"
        model = itd_text(entities).encode()
        return vc.check(model, prover.plan.certificate(model))

    def test_sound_models_are_accepted(self):
        for name in ("cube", "octant_sphere"):
            self.assertEqual(self.check(getattr(models, name)())[0], 0, name)

    def accepts(self, prover, text):
        prover.plan.values["subject_format"] = "itd"
        model = text.encode()
        self.assertEqual(vc.check(model, prover.plan.certificate(model))[0], 0, text[:300])

    def test_closed_axes(self):
        """A square ring of square section, one surface of 4 x 4 points, is the same with the first points repeated at the end."""
        corners, section = [(1, 1), (-1, 1), (-1, -1), (1, -1)], [(3, -1), (3, 1), (1, 1), (1, -1)]
        rows = [[(r * x, r * y, z) for r, z in section] for x, y in corners]
        knots = [[Q(i) for i in range(7)]] * 2
        closed = [row + row[:1] for row in rows + rows[:1]]
        prover = forge.Prover([forge.surface(closed, (1, 1), knots)]).prove()
        points = " ".join("[%d %d %d]" % rows[i][j] for j in range(4) for i in range(4))
        given = "[KVP 0 1 2 3 4 5 6]"
        self.accepts(prover, "[SURFACE BSPLINE 4 4 2 2 E3 %s %s %s]" % (given, given, points))
        points = " ".join("[%d %d %d]" % closed[i][j] for j in range(4) for i in range(5))
        self.accepts(prover, "[MULTIVAR BSPLINE 2 5 4 2 2 E3 %s %s %s]" % (given.replace("KVP", "KV"), given, points))

    def test_a_ball_in_the_power_basis(self):
        """Bicubic faces, a third of them rational; their Bernstein coefficients are integers, and so are those of the powers."""
        def powers(b):
            return [math.comb(3, r) * sum((-1) ** (r - i) * math.comb(r, i) * b[i] for i in range(r + 1)) for r in range(4)]

        entities = models.cube(144, degree=3, shape=lambda p: [c * (Q(5, 4) - sum(x * x for x in p) * Q(3, 16)) for c in p])
        prover, text = forge.Prover(entities).prove(), ""
        for n, entity in enumerate(entities):
            kind, points = ("P3", [["1", *p] for p in entity["shape"]["points"]]) if n % 3 == 0 else ("E3", entity["shape"]["points"])
            nets = [[[Q(points[4 * i + j][c]) for j in range(4)] for i in range(4)] for c in range(len(points[0]))]
            nets = [list(zip(*[powers(column) for column in zip(*[powers(row) for row in net])])) for net in nets]
            text += "[SURFACE POWER 4 4 %s %s]" % (kind, " ".join("[%s]" % " ".join(decimal(net[i][j]) for net in nets) for j in range(4) for i in range(4)))
        self.accepts(prover, text)

    def test_the_format_of_the_statement_counts(self):
        prover = forge.Prover(models.cube()).prove()
        text = itd_text(models.cube()).encode()
        self.assertEqual(vc.check(text, prover.plan.certificate(text))[0], 4)        # as JSON
        prover.plan.values["subject_format"] = "itd"
        self.assertEqual(vc.check(prover.model, prover.plan.certificate())[0], 4)    # JSON as .itd

    def test_another_order_of_the_points_is_another_model(self):
        prover = forge.Prover(models.cube()).prove()
        prover.plan.values["subject_format"] = "itd"
        text = itd_text(models.cube())
        lines = text.split("\n")                          # a head, two knot vectors, four points
        lines[4], lines[5] = lines[5], lines[4]
        swapped = "\n".join(lines)
        code, line = vc.check(swapped.encode(), prover.plan.certificate(swapped.encode()))
        self.assertEqual((code, line.split(":")[0]), (1, "REJECT P1"), line)

    def test_mutated_texts_get_one_answer(self):
        """With both checkers as judges: neither a crash nor two answers."""
        rng = random.Random(71)
        base = "[OBJECT [a 1] N " + itd_text(models.cube()[:1]) + FLAT + "]"
        bits = ["[", "]", '"', "\\", " ", "KVP", "POWER", "0", "9", "-", ".", "e", "P3", "MULTIVAR", "SURFACE", "OBJECT", "\n", "NUMBER", "[OBJECT", "[c]"]
        for _ in range(150):
            text = base
            for _ in range(rng.randrange(1, 3)):
                at = rng.randrange(len(text))
                text = text[:at] + rng.choice(bits) + text[at + rng.randrange(4):]
            is_read(text)


if __name__ == "__main__":
    unittest.main()
