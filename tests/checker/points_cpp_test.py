#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""points-1 in the C++ checker (docs/certificates/points.md): every spelling, every condition, their order and limits, and random meshes and
points whose truth answers_forge.py finds in other ways. VERITOPE_CHECK names the program."""
import math
import os
import pathlib
import random
import resource
import struct
import subprocess
import tempfile
import unittest
from fractions import Fraction

import judges
import mesh_models as models
import answers_forge as points

forge = points.forge
SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
INSIDE, OUTSIDE = ("0.25", "0.25", "0.25"), ("1", "1", "1")


def tearDownModule():
    most, factor = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 3 if os.environ.get("VERITOPE_SANITIZE") else 1
    assert most < factor * 700 * 1024, "a run took %d KiB: a count that lies was believed" % most


def in_cpp(model, certificate, answers):
    """(exit code, condition or ACCEPT, all that was printed)."""
    paths = [os.path.join(judges.FOLDER.name, name) for name in ("model", "certificate", "answers")]
    for path, data in zip(paths, (model, certificate, answers)):
        with open(path, "wb") as file:
            file.write(data)
    r = subprocess.run([judges.CHECK, *paths], capture_output=True, text=True, timeout=600, check=False)
    return r.returncode, judges.condition(r.stdout), r.stdout + r.stderr


def chain_of(mesh, fmt="off", as_indexed=False):
    return points.Chain(forge.Model(*models.triangles(mesh), fmt, as_indexed))


class PointsTest(unittest.TestCase):
    def says(self, expected, files, *words):
        code, condition, text = in_cpp(*files)
        self.assertEqual((code, condition), ({"ACCEPT": 0, "": 4}.get(expected, 1), expected), text)
        for word in words:
            self.assertIn(word, text)
        return text

    def tet(self, decimals="nearest", winding=False, mesh=models.TET):
        return points.Answers(chain_of(mesh), decimals, winding)

    def four(self, **how):
        """A line of each word."""
        a = self.tet(**how)
        a.add(INSIDE, "3")
        a.add(OUTSIDE, "-", 5)
        a.add(("0.5", "0.25", "0"))
        a.put(("7", "7", "7"), "undecided", "-")
        self.assertEqual([line[1] for line in a.lines], ["-", "-", "on", "undecided"] if a.winding else ["in", "out", "on", "undecided"])
        return a


class Sound(PointsTest):
    def test_a_line_of_each_word(self):
        for winding in (False, True):
            for decimals in ("nearest", "exact"):
                self.says("ACCEPT", self.four(winding=winding, decimals=decimals).files(), "ACCEPT points-1: 4 points, 1 on, 1 undecided")

    def test_the_bytes_of_a_small_body(self):
        """Written out by hand from section 3."""
        body = b"VTPT" + bytes([4, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0]) + bytes([0, 5, 0])
        a = self.four()
        self.assertEqual(a.body(), body)
        self.assertEqual(a.bytes(), b"0.25 0.25 0.25 in 1 3\n1 1 1 out 0 -\n0.5 0.25 0 on - -\n7 7 7 undecided - -\n")

    def test_no_points_at_all(self):
        self.says("ACCEPT", self.tet().files(), "0 points, 0 on, 0 undecided")

    def test_every_format(self):
        for name, (mesh, *_) in models.SOLIDS.items():
            for writer, (fmt, write) in models.WRITERS.items():
                with self.subTest(solid=name, writer=writer):
                    a = points.Answers(points.Chain(models.File(write(mesh), fmt)))
                    for i, x in enumerate(("0.125", "0.25", "0.75", "4.5", "-0.5", "0")):
                        a.add((x, "0.3", "0.4"), "-", i)
                    self.says("ACCEPT", a.files())

    def test_every_direction_from_every_place_of_a_grid(self):
        """Rays through vertices, along edges and in faces."""
        for mesh in (models.CUBE, models.RING, models.OCTAHEDRON, models.ELL, models.ONION, models.turned(models.REGULAR)):
            a = self.tet(winding=True, mesh=mesh)
            steps = [k / 2 for k in range(-3, 8)]
            rng = random.Random(5)
            for _ in range(250):
                place = [repr(rng.choice(steps)) for _ in range(3)]
                for direction in range(6):
                    a.add(place, "-", direction)
            self.says("ACCEPT", a.files())

    def test_any_winding_number(self):
        """Copies of a tetrahedron, and copies inside out."""
        for n in (-3, -1, 2, 130):
            one = models.turned(models.TET) if n < 0 else models.TET
            a = self.tet(winding=True, mesh=models.join(*[one] * abs(n)))
            for direction in range(6):
                a.add(INSIDE, "0", direction)
            self.assertEqual(a.lines[0][2], str(n))
            a.add(("0", "0.5", "0"), "-", 3 * abs(n))       # numbers of triangles of two bytes for the 130 copies
            self.says("ACCEPT", a.files())

    def test_merged_and_indexed_models(self):
        """The triangles of one tetrahedron with vertices of their own are closed only after merging."""
        where, tris = models.triangles(models.TET)
        apart = forge.Model([where[v] for t in tris for v in t], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(4)])
        a = points.Answers(points.Chain(apart))
        a.add(INSIDE)
        self.says("ACCEPT", a.files())
        a.chain = points.Chain(apart.copy(as_indexed=True))
        self.says("P1", a.files())


class Random(PointsTest):
    WIDTHS = (0, -1000, 900, -1074)                       # powers of two that scale everything

    def place(self, rng, power):
        return math.ldexp(rng.choice((rng.randrange(5), rng.randrange(9) / 2)) if power != -1074 else rng.randrange(5), power)

    def words(self, rng, x, decimals):
        """A spelling of x, or of a rational number near x."""
        kind = rng.randrange(6)
        if kind < 2 or (kind == 2 and decimals == "exact" and len(repr(x)) > 12):
            return rng.choice(list(points.spellings(x)))
        if kind == 2:
            return repr(x)
        return ("%d/%d" % (Fraction(x) * 3).as_integer_ratio(), "%d/%d" % (Fraction(x) + Fraction(x) / 1023).as_integer_ratio(),
                rng.choice(list(points.spellings(x))))[kind - 3]

    def test_truth_is_accepted_and_every_other_answer_is_rejected(self):
        rng, counts = random.Random(20), dict.fromkeys(("on", "off", "P2", "P3", "P4"), 0)
        for _ in range(60 * SCALE):
            power = rng.choice(self.WIDTHS)
            model, solids = points.tetrahedra(rng, rng.randrange(1, 6), lambda: self.place(rng, power))
            chain = points.Chain(model)
            a = points.Answers(chain, rng.choice(("nearest", "exact")), True)
            for _ in range(40):
                place = [self.place(rng, power) for _ in range(3)]
                if rng.random() < .3:                     # on a triangle, mostly
                    corners, w = chain.corners(rng.randrange(len(chain.tris))), rng.choice(((1, 1, 2), (1, 0, 3), (2, 2, 0), (1, 1, 1)))
                    place = [sum(x * y for x, y in zip(w, c)) / sum(w) for c in zip(*corners)]
                    words = ["%d/%d" % x.as_integer_ratio() for x in place]
                else:
                    words = [self.words(rng, x, a.decimals) for x in place]
                if a.add(words, "-", rng.randrange(6)) == "-":
                    q = [points.value(word, a.decimals) for word in words]
                    self.assertEqual(int(a.lines[-1][2]), points.winding_of_tetrahedra(solids, q), (model.points, model.tris, words))
            with self.subTest(points=model.points, tris=model.tris, indexed=model.as_indexed, lines=a.lines):
                self.says("ACCEPT", a.files())
                self.lie(rng, chain, a, counts)
        self.assertGreater(min(counts.values()), 10 * SCALE, counts)

    def lie(self, rng, chain, a, counts):
        """One lie of each kind, whose line must be named."""
        on = [i for i, line in enumerate(a.lines) if line[1] == "on"]
        off = [i for i, line in enumerate(a.lines) if line[1] == "-"]
        counts["on"] += len(on)
        counts["off"] += len(off)
        if off:
            i = rng.choice(off)
            wrong = str(int(a.lines[i][2]) + rng.choice((-1, 1, 2)))
            self.says("P4", a.changed(i, f=wrong).files(), "line %d" % (i + 1))
            self.says("P2", a.changed(i, word="on", f="-", code=rng.randrange(len(chain.tris))).files(), "line %d" % (i + 1))
            counts["P4"] += 1
        for i in on[:1]:
            self.says("P3", a.changed(i, word="-", f=str(rng.randrange(-1, 2)), code=rng.randrange(6)).files(), "line %d" % (i + 1))
            counts["P3"] += 1
            q = [points.value(word, a.decimals) for word in a.lines[i][0]]
            others = sorted(set(range(len(chain.tris))) - set(chain.on(q)))
            if others:
                self.says("P2", a.changed(i, code=rng.choice(others)).files(), "line %d" % (i + 1))
                counts["P2"] += 1

    def test_points_beside_long_thin_triangles(self):
        """Points one unit in the last place from a face, and rational points nearer than that."""
        mesh = [(0, 0, 0), (1e6, 1e-6, 0), (3, 1e6, 1e-6), (1 / 3, 2 / 3, 1e6)], models.TET[1]
        a = self.tet(winding=True, mesh=mesh)
        chain = a.chain
        for f in range(4):
            middle = [sum(c) / 3 for c in zip(*chain.corners(f))]
            for k in range(3):
                near = float(middle[k])
                for x in (near, math.nextafter(near, math.inf), math.nextafter(near, -math.inf)):
                    a.add([x.hex() if i == k else float(m).hex() for i, m in enumerate(middle)], "-", 2 * k)
                for x in (middle[k] + Fraction(1, 10 ** 400), middle[k] - Fraction(1, 10 ** 400), middle[k]):
                    a.add(["%d/%d" % (x if i == k else m).as_integer_ratio() for i, m in enumerate(middle)], "-", 2 * k + 1)
        self.assertEqual({line[1] for line in a.lines}, {"on", "-"})
        self.assertEqual({line[2] for line in a.lines}, {"-", "0", "-1"} if chain.winding([Fraction(1)] * 3) < 0 else {"-", "0", "1"})
        self.says("ACCEPT", a.files())

    def test_the_smallest_and_the_greatest_numbers(self):
        tiny, great = 5e-324, 1.7976931348623157e308
        for mesh in ([(x * tiny, y * tiny, z * tiny) for x, y, z in models.move(models.REGULAR, (0, 0, 0), 4)[0]], models.REGULAR[1]), \
                ([(x * great, y * great, z * great) for x, y, z in models.REGULAR[0]], models.REGULAR[1]), models.REGULAR:
            for decimals in ("nearest", "exact"):
                a = self.tet(decimals, True, mesh)
                words = ("0", "-0", "0x1p-1074", "0x1p-1075", "-0x1p-4096", "1/3", "-1e-400", "0x1.fffffffffffffp1023", "0x1.fffffffffffff8p+1023",
                         "-0x1p1024", "0x1p4096", "-0x1p4096", "1e309/1".replace("e309", "0" * 309), "1", "0x.8p1", "0x1p-1000")
                rng = random.Random(3)
                for direction in range(6):
                    for _ in range(20):
                        a.add([rng.choice(words) if decimals == "exact" or "e" not in w else "0" for w in rng.choices(words, k=3)]
                              if decimals == "exact" else [rng.choice([w for w in words if w != "-1e-400"]) for _ in range(3)], "-", direction)
                self.says("ACCEPT", a.files())


class Spellings(PointsTest):
    GOOD = {  # both, then exact alone
        True: ("0", "-0", "+0", "00", "1", "+1", "-1", "1.", ".5", "-.5", "+.5e1", "1e0", "1E0", "1e+0", "1e-0", "007.250e-001", "1.5E+2", "0e99",
               "0x0p0", "0X1P1", "0x1.p0", "0x.8p0", "+0xAbc.DeFp-9", "-0x1p+4", "0x1p4096", "0x1p-4096", "0x1p00004096", "0x1p-0004096",
               "0/1", "-0/7", "1/3", "+1/3", "-1/3", "001/003", "123456789123456789123456789/987654321987654321"),
        False: ("1e4096", "1e-4096", "-1.5e+4096", "0e-4096", ".1e-4096", "1e04096")}
    BAD = ("", "-", "+", ".", "-.", "e1", ".e1", "1e", "1e+", "1e-", "+-1", "--1", "1 ", "1,5", "1_0", "inf", "nan", "NaN", "-inf", "Infinity", "0x", "0x1", "0x1.8", "0xp1",
           "0x.p1", "0x1p", "0x1p+", "0x1pA", "0x1g", "0x1e5", "x1p1", "0x 1p1", "0x1p1.5", "0x-1p1", "1p1", "1/", "/1", "1/0", "0/0", "1/00", "1/-3", "1/+3",
           "1./3", "1.5/3", "1/3.0", "1/3/5", "1e1/3", "1/3e1", "0x1/3", "1/0x3", "0x1p1/3", "0x1p4097", "0x1p-4097", "0x1p99999999999999999999",
           "1\t", "\t1", "1\r", "1\v", "1\0", "\0", "1\0e5", "\u00e9", "\uff11", "0x1P1P1", "1..5", "1.5.5", "1ee5", "1e5e5", "1f", "1d0", "1e0x5")

    def line(self, word, decimals):
        a = self.tet(decimals)
        return a.put((word, "5", "5"), "undecided", "-") and a

    def test_good_and_bad_spellings(self):
        for decimals in ("nearest", "exact"):
            for both, words in self.GOOD.items():
                for word in words:
                    with self.subTest(word=word, decimals=decimals):
                        good = both or decimals == "exact" or "e-" in word
                        self.says("ACCEPT" if good else "A2", self.line(word, decimals).files())
            for word in self.BAD:
                with self.subTest(word=word, decimals=decimals):
                    self.says("A2", self.line(word, decimals).files(), "line 1")

    def test_all_good_spellings_mean_what_the_page_says(self):
        """The points are on a segment's triangle exactly if their value is what Python's fractions find."""
        for decimals in ("nearest", "exact"):
            a = self.tet(decimals, True)
            for word in self.GOOD[True] + (self.GOOD[False] if decimals == "exact" else ()) + ("0.1", "0.3", "1e-5", "-7e-3"):
                for place in ((word, "0", "0"), ("0", word, "0.25"), ("0.125", "0.125", word), (word, word, word)):
                    a.add(place, "-", len(a.lines) % 6)
            self.says("ACCEPT", a.files())

    def test_exponents_of_nearest_decimals_may_be_any(self):
        for word, good in (("1e-99999999999999999999", True), ("0e99999999999999999999", True), ("1e309", False), ("1.7976931348623157e308", True),
                           ("1.7976931348623158e308", True), ("1.797693134862315808e308", False), ("-1e4096", False), ("1e99999999999999999999", False)):
            self.says("ACCEPT" if good else "A2", self.line(word, "nearest").files())
        for word in ("1e4097", "1e-4097", "0e4097", "1e99999999999999999999", "1e-18446744073709551616"):
            self.says("A2", self.line(word, "exact").files())

    def test_the_greatest_length(self):
        for decimals in ("nearest", "exact"):
            for word in ("1" * 200 + "." + "2" * 3895, "-." + "9" * 4094, "0x." + "f" * 4090 + "p-9", "1/" + "3" * 4094, "0" * 4096, "-" + "7" * 4093 + "/7"):
                self.assertEqual(len(word), 4096)
                self.says("ACCEPT", self.line(word, decimals).files())
                longer = word.replace("0x", "0x0", 1) if "x" in word else word[0] + "0" + word[1:] if word[0] != "-" else "-0" + word[1:]
                self.says("A2", self.line(longer, decimals).files())

    def test_long_numbers_are_compared_exactly(self):
        """The diagonal face of the tetrahedron x + y + z = 1, and points that miss it by 10^-4000."""
        third = "0." + "3" * 4000
        for last, on in (("3", False), ("4", True)):
            a = self.tet("exact", True)
            a.add((third, third, "0." + "3" * 3999 + last))
            self.assertEqual(a.lines[0][1] == "on", on)
            self.says("ACCEPT", a.files())
            self.says("P3" if on else "P2", a.changed(0, **({"word": "-", "f": "0", "code": 0} if on else {"word": "on", "f": "-", "code": 3})).files())

    def test_a_nearest_decimal_is_rounded_and_an_exact_one_is_not(self):
        """The decimals add up to 1, and so do not the binary64 numbers."""
        words = ("0.1", "0.2", "0.7")
        self.assertNotEqual(sum(Fraction(float(w)) for w in words), 1)
        for decimals, on in (("exact", True), ("nearest", False)):
            a = self.tet(decimals, True)
            self.assertEqual(a.add(words) == "on", on)
            self.says("ACCEPT", a.files())
            a.decimals = "nearest" if on else "exact"
            self.says("P2" if on else "P3", a.files())


class Lines(PointsTest):
    def says_of_line(self, expected, words, winding=False, codes=b"\0"):
        """A file of one line, whose counts are those of its words."""
        a = self.tet(winding=winding)
        text = words.encode() + b"\n"
        body = b"VTPT" + struct.pack("<IIQ", 4, 4, 1) + codes
        kinds = words.split(" ")[3:4]
        self.says(expected, a.files(text, body, points=1, on=kinds.count("on"), undecided=kinds.count("undecided")))

    def test_words(self):
        inside, outside, face = ".25 .25 .25 ", "1 1 1 ", ".25 .25 0 "
        for words, codes in ((inside + "in 1 -", b"\0"), (inside + "in 1 0", b"\0"), (inside + "in 1 9999999999", b"\5"), (outside + "out 0 -", b"\3"), (outside + "out 0 17", b"\3"),
                             (face + "on - -", b"\0"), (face + "on - 4", b"\0"), (outside + "undecided - -", b"")):
            self.says_of_line("ACCEPT", words, codes=codes)
        for words in ("in 0 -", "in 2 -", "in - -", "in -1 -", "in 01 -", "in +1 -", "in 1 ", "in  1 -", "out 1 -", "out - -", "out 00 -", "out -0 -", "- 1 -", "- 0 -", "On - -", "IN 1 -", "inside 1 -",
                      "on 0 -", "on 1 -", "on  -", "on - 01", "on - -1", "on - +1", "on - 10000000000", "on - x", "on - --", "undecided 0 -", "undecided - 0", "undecided - 1",
                      "undecided", "undecided -", "undecided - - ", "undecided - - -", " undecided - -", "undecided\t- -", "undecided - -\r", "undecided - -\0", "undecided - -#", "", "1 1 1"):
            self.says_of_line("A2", face + words, codes=b"")
        for words in ("1 1  undecided - -", "1  1 1 undecided - -", " 1 1 1 undecided - -", "1 1 undecided - -", "1 1 1 1 undecided - -", "# comment", "", " ", "     ", "1\t1 1 undecided - - "):
            self.says_of_line("A2", words, codes=b"")

    def test_words_with_winding_numbers(self):
        inside, outside, face = ".25 .25 .25 ", "1 1 1 ", ".25 .25 0 "
        for words, codes in ((inside + "- 1 -", b"\0"), (outside + "- 0 5", b"\0"), (face + "on - -", b"\0"), (face + "undecided - -", b"")):
            self.says_of_line("ACCEPT", words, True, codes)
        for f in ("9999999999", "-9999999999", "-1", "1234567890"):
            self.says_of_line("P4", outside + "- %s -" % f, True)
        for words in ("in 1 -", "out 0 -", "- - -", "- -0 -", "- 01 -", "- -01 -", "- +1 -", "- 12345678901 -", "- -12345678901 -", "- 1. -", "- --1 -", "- 1- -", "-  -", "- 0 -1", "- 0 ", "-1 0 -"):
            self.says_of_line("A2", inside + words, True)

    def test_the_last_line_ends_with_a_line_feed(self):
        a = self.four()
        text = a.bytes()
        for bad in (text[:-1], text + b"1", text + b"\n", b"\n" + text, text.replace(b"\n", b"\r\n"), text + b" "):
            self.says("A2", a.files(bad))
        self.says("A2", a.files(text[:-1]), "line 4")
        self.says("A2", a.files(b"\n", points=0, on=0, undecided=0), "line 1")

    def test_numbers_of_lines(self):
        a = self.four()
        for key, right in (("points", 4), ("on", 1), ("undecided", 1)):
            for wrong in (0, right + 1, 2 ** 32 + right, 2 ** 64 - 1):
                self.says("A2", a.files(**{key: wrong}))

    def test_a1(self):
        a = self.four()
        model, certificate, text = a.files()
        for other in (b"", text + b"\n", text[:-1], text.replace(b"7 7", b"7 8")):
            self.says("A1", (model, certificate, other))
        for key, value in (("answers_bytes", 0), ("answers_bytes", 2 ** 64 - 1), ("answers_sha256", "0" * 64)):
            self.says("A1", a.files(**{key: value}))

    def test_s1(self):
        a = self.four()
        for key, value in (("answers_sha256", "0" * 63), ("answers_sha256", "A" * 64), ("answers_sha256", 5), ("answers_bytes", "5"), ("decimals", ""), ("decimals", "Exact"), ("decimals", "nearest "),
                           ("decimals", True), ("winding", "true"), ("winding", 1), ("points", "4"), ("on", True), ("undecided", ""), ("more", 1), ("claim", "points-2"), ("subject_format", "step")):
            self.says("S1", a.files(**{key: value}))
        for key in ("answers_sha256", "answers_bytes", "decimals", "winding", "points", "on", "undecided", "as_indexed", "reading_rule"):
            model, certificate, text = a.files()
            self.says("S1", (model, certificate.replace(b'"%s":' % key.encode(), b'"other":', 1), text))
        self.says("S2", a.files(reading_rule="none"))
        self.says("S3", a.files(subject_bytes=1))
        self.says("S4", a.files(body_sha256="0" * 64))

    def test_the_order_of_s_and_a_and_the_model(self):
        a = self.four()
        bad = {"decimals": "no", "reading_rule": "none", "subject_bytes": 1, "body_sha256": "0" * 64, "answers_bytes": 1, "points": 5}
        for expected in ("S1", "S2", "S3", "S4", "A1", "A2"):
            self.says(expected, a.files(body=b"", **bad))
            bad.pop(next(iter(bad)))
        self.says("B1", a.files(body=b""))
        refused = points.Answers(chain_of(models.TET))
        refused.chain.bytes = b"OFF 1 0 0\n0 0 0"
        self.says("", refused.files())
        self.says("A2", refused.files(points=1))


class Body(PointsTest):
    def test_layout(self):
        a = self.four()
        good = a.body()
        for n in range(len(good)):
            self.says("B1", a.files(body=good[:n]))
        for bad in (good + b"\0", b"VTPS" + good[4:], good[:4] + b"\5" + good[5:], good[:8] + b"\3" + good[9:], good[:11] + b"\1" + good[12:], good[:12] + b"\5" + good[13:], good[:12] + b"\3" + good[13:],
                    good[:19] + b"\x80" + good[20:], good[:12] + struct.pack("<Q", 2 ** 64 - 1) + good[20:], good[:20] + b"\6" + good[21:], good[:21] + b"\xff" + good[22:], good[:22] + b"\4",
                    good[:22] + b"\x80\0", good[:22] + b"\x80\x01", good[:22] + b"\xff" * 9 + b"\x01", good[:22] + b"\xff" * 9 + b"\x02", good[:22] + b"\x84" + b"\x80" * 8 + b"\x00"):
            self.says("B1", a.files(body=bad))
        for code in range(4):
            self.says("ACCEPT" if code == 0 else "P2", a.files(body=good[:22] + bytes([code])))

    def test_every_direction_is_a_proof(self):
        a = self.four()
        for one in range(6):
            for other in range(6):
                self.says("ACCEPT", a.changed(0, code=one).changed(1, code=other).files())

    def test_numbers_of_triangles_of_two_bytes(self):
        a = self.tet(winding=True, mesh=models.join(*[models.TET] * 50))
        on = a.chain.on([Fraction(0), Fraction(1, 4), Fraction(1, 4)])
        self.assertGreater(on[-1], 127)
        for f in range(200):
            a.lines = []
            a.put(("0", "1/4", "1/4"), "on", "-", "-", f)
            self.says("ACCEPT" if f in on else "P2", a.files())
        a.put(("0", "1/4", "1/4"), "on", "-", "-", 200)
        self.says("B1", a.files(), "line 2")

    def test_mutations_neither_crash_nor_pass(self):
        a, rng = self.four(), random.Random(17)
        good = a.body()
        for _ in range(150 * SCALE):
            body = bytearray(good)
            at = rng.randrange(len(body))
            body[at] = rng.randrange(256)
            code, _, text = in_cpp(*a.files(body=bytes(body)))
            self.assertEqual(code == 0, bytes(body) == good or (at in (20, 21) and body[at] < 6), text)
            text = bytearray(a.bytes())
            text[rng.randrange(len(text))] = rng.choice(b" \n0123456789-+.e/xpinoutd")
            code, _, printed = in_cpp(*a.files(text=bytes(text)))
            self.assertIn(code, (0, 1), printed)


class Conditions(PointsTest):
    def test_p1(self):
        """Open, doubled and misoriented triangles, and what is closed as a chain although it is no surface."""
        tris = models.TET[1]
        for bad in (tris[:3], tris + [tris[0]], [tris[0][::-1]] + tris[1:], tris[:2], [(0, 1, 2)], tris + [(0, 1, 0), (1, 2, 3)]):
            a = points.Answers(chain_of((models.TET[0], bad), as_indexed=True), winding=True)
            self.says("P1", a.files())
            a.put(("9", "9", "9"), "-", "0", "-", 0)
            a.put(("8", "8", "8"), "on", "-", "-", 0)        # a lie, but P1 is tested first
            self.says("P1", a.files())
        for good in ([(0, 0, 0)], [(0, 0, 1)], [(0, 1, 0)], [(1, 0, 0)], [(0, 1, 2), (0, 2, 1)], [(0, 1, 2), (2, 1, 0)], tris + [(3, 3, 1)], tris + tris, tris + [t[::-1] for t in tris],
                     tris + [(0, 1, 2), (2, 1, 0)]):
            a = points.Answers(chain_of((models.TET[0], good), as_indexed=True), winding=True)
            for place in (INSIDE, OUTSIDE, ("0", "0", "0"), ("1", "0", "0"), ("0.5", "0", "0"), ("0.75", "0.125", "0"), ("2", "0", "0"), ("0", "0", "0.5"), ("-1", "0", "0"), ("0.5", "0", "0.1")):
                for direction in range(6):
                    a.add(place, "-", direction)
            self.says("ACCEPT", a.files())

    def test_degenerate_triangles_count_for_p2_and_p3(self):
        """Segments and points outside of the solid."""
        where = models.TET[0] + [(5, 5, 5), (7, 9, 5), (6, 7, 5)]
        for extra, segment in (((4, 4, 5), True), ((4, 5, 6), True), ((6, 5, 4), True), ((4, 6, 5), True), ((4, 4, 4), False)):
            tris = models.TET[1] + [extra] + ([extra[::-1]] if len(set(extra)) == 3 else [])
            a = points.Answers(chain_of((where, tris), as_indexed=True))
            for place in (("5", "5", "5"), ("6", "7", "5"), ("6.5", "8", "5"), ("16/3", "17/3", "5"), ("6", "8", "5"), ("4.5", "4", "5"), ("5.5", "6", "5.5"), ("8", "11", "5"), ("5.5", "5.5", "5")):
                a.add(place)
            words = [line[1] for line in a.lines]
            self.assertEqual(words, ["on"] + ["on" if segment else "out"] * 3 + ["out"] * 5)
            self.says("ACCEPT", a.files())
            for i, word in enumerate(words):
                lie = {"word": "on", "f": "-", "code": 4} if word == "out" else {"word": "out", "f": "0", "code": i % 6}
                self.says("P2" if word == "out" else "P3", a.changed(i, **lie).files(), "line %d" % (i + 1))

    def test_p3_is_tested_before_p4_and_lines_in_their_order(self):
        a = self.four(winding=True)
        self.says("P3", a.changed(2, word="-", f="77", code=0).files(), "line 3")
        wrong = a.changed(0, f="0").changed(2, code=1)
        self.says("P4", wrong.files(), "line 1")
        self.says("P2", wrong.changed(0, f="1").files(), "line 3")
        late = a.changed(2, code=1)
        late.add(INSIDE)
        self.says("P2", late.changed(4, f="5").files(), "line 3")

    def test_boundary_points_of_every_kind(self):
        """Vertices, edges and faces are on; their nearest neighbours are not."""
        for mesh in (models.CUBE, models.REGULAR, models.OCTAHEDRON):
            a = self.tet(winding=True, mesh=mesh)
            for f in range(len(a.chain.tris)):
                corners = a.chain.corners(f)
                for w in ((1, 0, 0), (1, 1, 0), (0, 1, 2), (1, 1, 1), (5, 2, 1)):
                    place = [sum(x * y for x, y in zip(w, c)) / Fraction(sum(w)) for c in zip(*corners)]
                    for k in range(-1, 3):
                        moved = [x + (Fraction(1, 2 ** 90) if i == k else 0) for i, x in enumerate(place)]
                        a.add(["%d/%d" % x.as_integer_ratio() for x in moved], "-", f % 6)
            self.assertGreaterEqual([line[1] for line in a.lines].count("on"), 5 * len(a.chain.tris))
            self.says("ACCEPT", a.files())


class Work(PointsTest):
    """Copies of one surface, all with the same boxes: the greatest number within the bound, and one more."""

    def assert_exact(self, mesh, place, direction, expected_units):
        one = chain_of(mesh)
        q = [points.value(word, "exact") for word in place]
        units, faces = one.units(q, direction), len(one.tris)
        self.assertEqual(units, expected_units)
        lines = 20 * faces // units
        most = 1000 * lines // (units * lines - 10 * faces)
        for n, answer in ((most, "ACCEPT"), (most + 1, "B1")):
            self.says(answer, self.copies(mesh, one, n, q, place, direction, lines).files())

    def copies(self, mesh, one, n, q, place, direction, lines):
        a = points.Answers(points.Chain(forge.Model(mesh[0], models.triangles(mesh)[1] * n)), "exact", True)
        for _ in range(lines):
            a.put(place, "-", str(n * one.winding(q)), "-", direction)
        return a

    def test_boxes_that_contain_the_point(self):
        self.assert_exact(models.REGULAR, ("0", "0", "0"), 0, 4)
        self.assert_exact(models.REGULAR, ("1/3", "1/5", "-1/7"), 3, 4)

    def test_boxes_that_the_ray_meets(self):
        """A cube: the ray meets two boxes of each side across it; its lower ends across the ray count, its upper ends do not."""
        for words, direction, units in ((("-3", "1/4", "1/3"), 0, 4), (("-3", "1/4", "1/3"), 1, 0), (("1/2", "1/2", "1/2"), 4, 2), (("-3", "0", "1/2"), 0, 4), (("-3", "1", "1/2"), 0, 0),
                                        (("-3", "1/2", "0"), 0, 4), (("-3", "1/2", "1"), 0, 0), (("-3", "0", "0"), 0, 4), (("1/2", "5", "1/2"), 3, 4), (("1/2", "5", "0"), 3, 4),
                                        (("1/2", "1/2", "-5"), 4, 4), (("1/2", "1/2", "5"), 4, 0), (("1/2", "1/2", "5"), 5, 4)):
            if units:
                self.assert_exact(models.CUBE, words, direction, units)
            else:
                one = chain_of(models.CUBE)
                q = [points.value(word, "exact") for word in words]
                self.assertEqual(one.units(q, direction), 0)
                self.says("ACCEPT", self.copies(models.CUBE, one, 500, q, words, direction, 200).files())

    def test_the_ends_of_boxes_along_the_ray(self):
        """A face in the plane of the ray's start counts, on both sides; the point is beside it, within its box."""
        mesh = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4)], models.TET[1]
        for direction in (4, 5):
            one = chain_of(mesh)
            q = [Fraction(7, 2), Fraction(7, 2), Fraction(0)]
            self.assertEqual(one.on(q), [])
            self.assert_exact(mesh, ("7/2", "7/2", "0"), direction, one.units(q, direction))

    def test_on_points_are_one_unit_each(self):
        """They stay within the bound whatever contains them, and so do undecided points, which cost nothing."""
        a = points.Answers(points.Chain(forge.Model(models.TET[0], models.TET[1] * 3000)), "exact", True)
        for i in range(1200):
            a.put(("1/3", "1/3", "1/3"), "on", "-", "-", 4 * i + 3)
            a.put(("0", "0", "0"), "undecided", "-")
        self.says("ACCEPT", a.files())

    def test_the_work_is_named_before_what_else_fails(self):
        one, zero, place = chain_of(models.REGULAR), [Fraction(0)] * 3, ("0", "0", "0")
        n = 1000 * 20 // (4 * 20 - 10 * 4)
        for more, expected in ((0, None), (1, "B1")):
            a = self.copies(models.REGULAR, one, n + more, zero, place, 0, 20)
            self.says(expected or "P4", a.changed(0, f="3").files())
            self.says(expected or "P4", a.changed(19, f="3").files())
        a = self.copies(models.REGULAR, one, n + 1, zero, place, 0, 20)
        a.put(("0", "0", "0"), "on", "-", "-", 0)            # 1 unit, and 1000 units more are allowed
        self.says("P2", a.changed(0, f="%d" % (n + 1)).files(), "line 21")
        a.chain = points.Chain(forge.Model(models.REGULAR[0], models.REGULAR[1] * (n + 1) + [(0, 1, 2)]))
        self.says("P1", a.files())
        a.chain = points.Chain(forge.Model(models.REGULAR[0], models.REGULAR[1] * (n + 25) + [(0, 1, 2)]))
        self.says("B1", a.files())


class CommandLine(PointsTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.names = [self.folder / name for name in ("m.off", "c", "a")]
        for path, data in zip(self.names, self.four().files()):
            path.write_bytes(data)

    def run_it(self, *args, **how):
        r = subprocess.run([judges.CHECK, *map(str, args)], capture_output=True, text=True, timeout=120, check=False, **how)
        return r.returncode, r.stdout.strip(), r.stderr.strip()

    def test_answers(self):
        self.assertEqual(self.run_it(*self.names), (0, "ACCEPT points-1: 4 points, 1 on, 1 undecided", ""))
        model, certificate, answers = self.names
        self.assertEqual(self.run_it(model, certificate, model)[0], 1)

    def test_a_missing_and_a_needless_third_file_are_usage(self):
        model, certificate, answers = self.names
        code, out, err = self.run_it(model, certificate)
        self.assertEqual((code, out, err), (2, "", "The claim points-1 needs a third file, ANSWERS: veritope-check MODEL CERT [ANSWERS]"))
        plan = forge.Plan(forge.mesh_of(forge.Model(*models.triangles(models.TET))), random.Random(1))
        certificate.write_bytes(plan.certificate(model.read_bytes(), forge.Model(*models.triangles(models.TET))))
        self.assertEqual(self.run_it(model, certificate)[0], 0)
        code, out, err = self.run_it(model, certificate, answers)
        self.assertEqual((code, out, err), (2, "", "The claim mesh-valid-1 needs no file ANSWERS: veritope-check MODEL CERT [ANSWERS]"))
        self.assertEqual(self.run_it(model, certificate, answers, answers)[0], 2)

    def test_files_that_cannot_be_read(self):
        model, certificate, answers = self.names
        none = self.folder / "none"
        os.mkfifo(self.folder / "fifo")
        for bad in (none, self.folder, self.folder / "fifo", "/dev/null"):
            for args in ((bad, certificate, answers), (model, bad, answers), (model, certificate, bad)):
                code, out, err = self.run_it(*args)
                self.assertEqual((code, out, err.split(": ")[0]), (4, "", str(bad)))
        model.write_bytes(b"OFF")
        refused = points.Answers(chain_of(models.TET))
        refused.chain.bytes = b"OFF"
        for path, data in zip(self.names, refused.files()):
            path.write_bytes(data)
        code, out, err = self.run_it(*self.names)
        self.assertEqual((code, out, err.split(": ")[0]), (4, "", str(model)))

    def test_help_names_the_third_file(self):
        self.assertIn("veritope-check MODEL CERT [ANSWERS]", self.run_it("--help")[1])


if __name__ == "__main__":
    unittest.main()
