#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The reading rule for .g2 (docs/certificates/reading-rule-g2.md) in the Python checker: what a text means, what is refused, certificates."""
import random
import time
import unittest
from fractions import Fraction as Q

import star_box_forge as forge                            # says where the checker is
import model_texts as texts
import star_box_models as models
from veritope_checker import program as vc
from veritope_checker.patches.model_g2 import read_g2
from veritope_checker.patches.model_subject import read_subject

FLAT = "200 1 0 0 3 0 2 2 0 0 1 1 2 2 0 0 1 1 0 0 0 1 0 0 0 1 0 1 1 0\n"
BLOCK = "700 1 0 0 3 1 2 2 0 0 1 1 2 2 0 0 1 1 2 2 0 0 1 1 " + " ".join("%d %d %d 1" % (i, j, k) for k in (0, 1) for j in (0, 1) for i in (0, 1)) + "\n"


def changed(text, at, word):
    """The text with another word, or none, in the place of word number `at`."""
    words = text.split()
    words[at:at + 1] = word.split()
    return " ".join(words)


class G2Test(unittest.TestCase):
    def read(self, text):
        """What the text means, after all checkers have read it."""
        data = text if isinstance(text, bytes) else text.encode("latin-1")
        self.assertTrue(texts.is_read(vc, data, "g2"), text)
        return read_g2(data)

    def refused(self, *of_texts):
        for text in of_texts:
            with self.subTest(text[:300]):
                self.assertFalse(texts.is_read(vc, text, "g2"))


class Meaning(G2Test):
    def test_the_first_axis_is_fastest(self):
        (flat,) = self.read(FLAT)
        self.assertEqual(flat.rows, [[[0, 0, 0, 1], [0, 1, 0, 1]], [[1, 0, 0, 1], [1, 1, 0, 1]]])
        self.assertEqual((flat.kind, flat.degrees, flat.knots, flat.rational, flat.dimension), ("surface", (1, 1), [[0, 0, 1, 1]] * 2, False, 3))

    def test_the_weight_comes_last_and_is_multiplied_in(self):
        (weighted,) = self.read("200 0 0 0 3 1 3 3 0 0 0 2 2 2 2 2 0 0 1 1 " + " ".join("%d 0 0 %d" % (i, i + 1) for i in range(6)))
        self.assertEqual(weighted.rows, [[[i + 3 * j, 0, 0, i + 3 * j + 1] for j in range(2)] for i in range(3)])
        self.assertEqual((weighted.degrees, weighted.knots[0], weighted.rational), ((2, 1), [0, 0, 0, 2, 2, 2], True))

    def test_volumes(self):
        (block,) = self.read(BLOCK)
        self.assertEqual((block.kind, block.sizes, block.rational, block.dimension), ("volume", [2, 2, 2], True, 3))
        self.assertEqual([block.at(i, j, k) for i, j, k in ((1, 0, 0), (0, 1, 0), (0, 1, 1))], [[1, 0, 0, 1], [0, 1, 0, 1], [0, 1, 1, 1]])
        self.assertEqual([e and e.kind for e in read_subject((BLOCK + FLAT).encode(), "g2")], [None, "surface"])

    def test_random_maps_in_other_forms_of_numbers_and_blanks(self):
        rng = random.Random(3)
        for _ in range(40):
            maps = [random_map(rng) for _ in range(rng.randint(1, 3))]
            words = texts.g2_text(maps).decode().split()
            words = [w if rng.random() < .6 or "e" in w else rng.choice(("+%s", "0%s", "000%s")) % w if w[0] != "-" else w for w in words]
            text = "".join(rng.choice((" ", "\n", "\t", "\r\n", "\v", "\f", "  \n ")) + w for w in words) + rng.choice(("", "\n", " "))
            found = self.read(rng.choice(("", "\u00ef\u00bb\u00bf")) + text)
            self.assertEqual(len(found), len(maps))
            for entity, wanted in zip(found, maps):
                self.assertTrue(texts.same(texts.meaning(entity), wanted), text)

    def test_decimals_are_exact(self):
        for word, value in (("0.1", Q(1, 10)), ("-.5e-2", Q(-1, 200)), ("+7.", 7), ("1E+03", 1000), ("0.1e0000000004096", 10 ** 4095), ("0." + "0" * 998 + "1", Q(1, 10 ** 999)),
                            ("1e-4096", Q(1, 10 ** 4096)), ("3.0000000000000001", 3 + Q(1, 10 ** 16))):
            (flat,) = self.read(changed(FLAT, 20, word))
            self.assertEqual(flat.rows[0][0][2], value, word)

    def test_numbers_that_mean_nothing(self):
        (wanted,) = self.read(FLAT)
        for head in ("200 -1 99 0", "+200 4611686018427387904 -4611686018427387904 0", "200 1 0 3 1 -2 +3", "0200 1 0 1 0", "200 -0 0 -0"):
            (found,) = self.read(FLAT.replace("200 1 0 0", head))
            self.assertEqual(found.rows, wanted.rows)

    def test_other_dimensions_are_read(self):
        """They fail B2, which is tested after the body was read."""
        for dimension in (1, 2, 4, 1000):
            text = "200 1 0 0 %d 0 2 2 0 0 1 1 2 2 0 0 1 1 %s" % (dimension, " ".join(map(str, range(4 * dimension))))
            self.assertEqual(self.read(text)[0].dimension, dimension)


def random_map(rng):
    num_axes, rational = rng.choice((2, 2, 3)), rng.random() < .5
    degrees = [rng.randint(1, 3) for _ in range(num_axes)]
    knots = []
    for p in degrees:
        inner = sorted(rng.choice((1, 2, Q(5, 2))) for _ in range(rng.randint(0, 1 if num_axes == 3 else 3)))
        inner = [t for t in inner if inner.count(t) <= p]
        knots.append([Q(-1, 2)] * rng.randint(1, p + 1) + [0] + inner + [7, 8] + [9] * p)
        knots[-1] = knots[-1] if rng.random() < .5 else [0] * (p + 1) + inner + [8] * (p + 1)
    sizes = [len(t) - p - 1 for p, t in zip(degrees, knots)]
    if any(t[p] >= t[n] or any(a == b for a, b in zip(t, t[p + 1:])) or n <= p for p, t, n in zip(degrees, knots, sizes)):
        return random_map(rng)
    dimension = rng.choice((3, 3, 3, 2, 5))
    points = [[Q(rng.randint(-99, 99), 1 << rng.randint(0, 9)) for _ in range(dimension)] + [Q(rng.randint(1, 9), 8)] * rational
              for _ in range(texts.prod(sizes))]
    return texts.Map(degrees, knots, points, rational)


class Refusals(G2Test):
    def test_truncations_and_tokens_too_many(self):
        for text in (FLAT, BLOCK):
            words = text.split()
            self.refused(*(" ".join(words[:n]) for n in range(len(words))), *(text + w for w in ("0", "x", "200", "# end", "]")))
        self.refused("", " \n", "\u00ef\u00bb\u00bf", "\u00ff\u00fe")

    def test_every_integer_where_it_does_not_belong(self):
        """Words 0 to 7 and 12, 13: class, major, minor, a, dim, rational, n, k; n, k."""
        no_integers = ("", "x", "1.0", "1e0", "0x1", "1,", "--1", "+-1", "+", "1/1", "\u00b2", "1\0", "1_0", "4611686018427387905", "-4611686018427387905", "9" * 5000)
        for at in (0, 1, 2, 3, 4, 5, 6, 7, 12, 13):
            self.refused(*(changed(FLAT, at, w) for w in no_integers))
        self.refused(*(changed(FLAT, 0, w) for w in ("100", "210", "-200", "201", "0", "700", "2")))
        self.refused(*(changed(FLAT, 3, w) for w in ("-1", "1", "29", "1000000000")))
        self.refused(*(changed(FLAT, 4, w) for w in ("0", "-3", "2", "4", "1001")), *(changed(FLAT, 5, w) for w in ("-1", "1", "2")))
        for at in (6, 12):
            self.refused(*(changed(FLAT, at, w) for w in ("-2", "0", "1", "3", "1000000000000", "4611686018427387904")),
                         *(changed(FLAT, at + 1, w) for w in ("-2", "0", "1", "3", "65", "4611686018427387904")))
        self.assertTrue(texts.is_read(vc, changed(FLAT, 1, "0" * 5000 + "7"), "g2"))

    def test_orders_up_to_64(self):
        for order in (64, 65):
            knots = "0 " * order + "1 " * order
            text = "200 1 0 0 1 0 %d %d %s 2 2 0 0 1 1 %s" % (order, order, knots, "0 " * (2 * order))
            self.assertEqual(texts.is_read(vc, text, "g2"), order == 64)

    def test_decimals(self):
        words = ("x", "1,5", "1/2", "0x1", "nan", "inf", ".", "-", "+-1", "1e", "1e+", "e5", ".e5", "1.2.3", "1e5.0", "1e4097", "1e-4097", "0" * 1001, "1" * 1001,
                 "1." + "0" * 1000, "1e99999999999999999999", "\u00b2", "1\0")
        for at in (8, 14, 18, 29):
            self.refused(*(changed(FLAT, at, w) for w in words))

    def test_knots(self):
        text = "200 1 0 0 1 0 3 2 %s 2 2 0 0 1 1 0 1 2 3 4 5"
        for knots, good in (("0 0 1 2 2", True), ("0 1 2 3 4", True), ("0 0 2 1 2", False), ("0 0 0 1 1", False), ("0 0 0 0 0", False), ("0 1 1 1 2", False), ("0 1 1 2 3", True),
                            ("0 0 1 2", False), ("0 0 1 2 2 2", False), ("2 2 1 0 0", False), ("0 1 1 1 1", False)):
            self.assertEqual(texts.is_read(vc, text % knots, "g2"), good, knots)

    def test_weights(self):
        self.refused(*(changed(BLOCK, 24 + 4 * i + 3, w) for i in (0, 3, 7) for w in ("0", "-1", "-1e-4096", "0e5")))
        self.assertTrue(texts.is_read(vc, changed(BLOCK, 27, "1e-4096"), "g2"))

    def test_counts_that_lie_take_no_time(self):
        """Each is refused before anything of its size exists."""
        start = time.process_time()
        n = 99000
        for text in ("200 1 0 %d " % n, "200 1 0 0 3 0 %d 2 " % n, "200 1 0 0 1000 0 300 2 %s 300 2 %s" % (("0 0 " + " ".join(map(str, range(1, 299))) + " 299 299 ",) * 2),
                     "700 1 0 0 3 0 " + ("300 2 0 0 " + " ".join(map(str, range(1, 299))) + " 299 299 ") * 3):
            text += "1" * (100000 - len(text))
            self.refused(text)
        self.assertLess(time.process_time() - start, 5)


class Certificates(unittest.TestCase):
    def test_sound_models_are_accepted(self):
        for make in (models.cube, models.octant_sphere, models.torus):
            entities = make()
            texts.accepted(self, vc, texts.g2_text([texts.map_of(e) for e in entities]), "g2", forge.Prover(entities).prove())

    def answer(self, entities, text, subject_format="g2"):
        prover = forge.Prover(entities).prove()
        prover.plan.values["subject_format"] = subject_format
        return vc.check(text, prover.plan.certificate(text))

    def test_another_order_of_the_points_is_another_model(self):
        lines = texts.g2_text([texts.map_of(e) for e in models.cube()]).decode().split("\n")
        lines[6], lines[7] = lines[7], lines[6]           # a head of two lines, two of each axis
        self.assertEqual(self.answer(models.cube(), "\n".join(lines).encode())[1][:9], "REJECT P1")

    def test_a_volume_or_a_plane_surface_fails_b2(self):
        entities = models.cube()
        text = texts.g2_text([texts.map_of(e) for e in entities])
        plan = forge.Prover(entities).prove().plan
        plan.values["subject_format"] = "g2"
        plan.entities, plan.flags = plan.entities + [None], plan.flags + [0]
        data = text + BLOCK.encode()
        self.assertEqual(vc.check(data, plan.certificate(data))[1][:9], "REJECT B2")
        entities = [forge.surface([[p[:2] for p in row] for row in ([(0, 0), (0, 1)], [(1, 0), (1, 1)])])]
        plan = forge.Plan(entities)
        plan.roots, plan.trees, plan.boxes = [[0, 0]], [[0]], [forge.Box(1, [0] * 3, [1 << 30] * 3)]
        plan.values["subject_format"] = "g2"
        data = texts.g2_text([texts.map_of(e) for e in entities])
        self.assertEqual(vc.check(data, plan.certificate(data))[1][:9], "REJECT B2")

    def test_the_format_of_the_statement_counts(self):
        text = texts.g2_text([texts.map_of(e) for e in models.cube()])
        for other in ("vjson", "itd", "mfem", "vjson-faces", "itd-faces", "g2-faces", "mfem-faces"):
            self.assertEqual(self.answer(models.cube(), text, other)[0], 4, other)
        for other in ("g2-", "g2-faces ", "G2", "gotools", "faces", "-faces"):
            self.assertEqual(self.answer(models.cube(), text, other)[1][:9], "REJECT S1", other)


class Mutations(unittest.TestCase):
    def test_mutated_texts_get_one_answer(self):
        """With both checkers as judges: neither a crash nor two answers."""
        rng = random.Random(72)
        base = (FLAT + BLOCK).split(" ")
        bits = ["0", "1", "2", "-1", "3", "1e4096", "1e-4096", "x", "200", "700", "", "2.", "64", "+", "1\n2", "\u00ef\u00bb\u00bf", "4611686018427387904", "1000"]
        for _ in range(250):
            words = list(base)
            for _ in range(rng.randrange(1, 3)):
                at = rng.randrange(len(words))
                words[at:at + rng.randrange(3)] = [rng.choice(bits)] * rng.randrange(2)
            texts.is_read(vc, " ".join(words), "g2")


if __name__ == "__main__":
    unittest.main()
