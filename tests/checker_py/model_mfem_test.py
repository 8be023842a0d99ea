#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The reading rule for MFEM's NURBS meshes (docs/certificates/reading-rule-mfem.md) in the Python checker: what a text means, what is
refused, certificates."""
import random
import re
import time
import unittest
from fractions import Fraction as Q

import star_box_forge as forge                            # says where the checker is
import mfem_blocks
import model_texts as texts
import star_box_models as models
from veritope_checker import program as vc
from veritope_checker.patches.model_mfem import read_mfem
from veritope_checker.patches.model_subject import read_subject

LINE, PARABOLA, SKEW = (1, [0, 0, 1, 1]), (2, [0, 0, 0, 1, 1, 1]), (1, [0, 0, 1, 3, 3])
CUBIC = (3, [0, 0, 0, 0, 2, 7, 7, 7, 7])
ONE = """MFEM NURBS mesh v1.0
dimension 2
elements 1
1 3 0 1 2 3
boundary 4 1 1 0 1  1 1 1 2  1 1 2 3  1 1 3 0
edges 4
0 0 1
1 1 2
0 3 2
1 0 3
vertices 4
knotvectors 2
1 3 0 0 1 3 3
1 2 0 0 1 1
weights 1 2 3 4 5 6
FiniteElementSpace FiniteElementCollection: NURBS1 VDim: 3 Ordering: 1
0 0 0  2 0 0  2 1 0  0 1 0  1 0 0  1 1 5
"""


class MfemTest(unittest.TestCase):
    def read(self, text):
        data = text if isinstance(text, bytes) else text.encode("latin-1")
        self.assertTrue(texts.is_read(vc, data, "mfem"), text[:3000])
        return [texts.meaning(entity) for entity in read_mfem(data)]

    def assert_same(self, found, wanted, note=""):
        self.assertEqual(len(found), len(wanted), note)
        for a, b in zip(found, wanted):
            self.assertTrue(texts.same(a, b), (a.degrees, b.degrees, a.knots, b.knots, a.points, b.points, note))

    def refused(self, *of_texts):
        for text in of_texts:
            with self.subTest(text[:300]):
                self.assertFalse(texts.is_read(vc, text, "mfem"))

    def bends(self, text, *changes):
        """The text is refused after each of the changes (old, new) of one place."""
        self.assertTrue(texts.is_read(vc, text, "mfem"), text[:3000])
        for old, new in changes:
            self.assertIn(old, text)
            self.refused(text.replace(old, new, 1))


def place(p):
    """Any two lattice points are in different places."""
    return [Q(c) + Q(k, 8) for k, c in enumerate(p)] + [Q(sum((k + 2) * c * c for k, c in enumerate(p)), 4)] * (len(p) == 2)


def weight(p):
    return Q(1 + sum((3 * k + 1) * c for k, c in enumerate(p)) % 7, 4)


class Shared(MfemTest):
    def test_one_patch(self):
        """Numbers: four corners by vertices, then what is within edges 0 and 2; the edge from 3 to 2 rises from 2."""
        points = [(0, 0, 0, 1), (5, 0, 0, 5), (4, 0, 0, 2), (0, 4, 0, 4), (6, 6, 30, 6), (6, 3, 0, 3)]
        self.assert_same(self.read(ONE), [texts.Map((1, 1), [[0, 0, 1, 3, 3], [0, 0, 1, 1]], points, True)])

    def test_ordering_0(self):
        words = ONE.split("Ordering: 1\n")
        columns = zip(*[iter(words[1].split())] * 3)
        text = words[0] + "Ordering: 0\n" + " ".join(" ".join(column) for column in zip(*columns))
        self.assert_same(self.read(text), self.read(ONE))

    def test_weights_are_1_if_the_file_says_so(self):
        wanted = self.read(ONE.replace("1 2 3 4 5 6", "1 1 1 1 1 1"))
        for word in ("unitweights", "autoweights"):
            self.assert_same(self.read(ONE.replace("weights 1 2 3 4 5 6", word)), wanted)

    def test_a_reversed_axis_has_reversed_knots(self):
        """An edge listed against the axis: its knots are t0 + t1 - t; control points keep their numbers."""
        text = ONE.replace("0 0 1\n", "0 1 0\n", 1).replace("0 3 2\n", "0 2 3\n", 1)
        (wanted,) = self.read(ONE)
        wanted.knots[0] = [0, 0, 2, 3, 3]
        self.assert_same(self.read(text), [wanted])
        self.bends(ONE, ("0 0 1\n", "0 1 0\n"), ("0 3 2\n", "0 2 3\n"))      # one alone: different knots along one axis
        symmetric = ONE.replace("0 0 1 3 3", "0 0 1 2 2")
        self.assert_same(self.read(symmetric.replace("0 0 1\n", "0 1 0\n", 1)), self.read(symmetric))

    def test_random_blocks(self):
        """Every numbering of vertices, orientation of patches and order of edges means the same control points."""
        rng = random.Random(8)
        for trial in range(60):
            num_axes = rng.choice((2, 3))
            counts = [rng.randint(1, 3 if num_axes == 2 else 2) for _ in range(num_axes)]
            axes = [rng.choice((LINE, PARABOLA, SKEW, CUBIC)) for _ in counts]
            left_out = {tuple(rng.randrange(n) for n in counts)} if rng.random() < .4 and texts.prod(counts) > 1 else set()
            blocks = mfem_blocks.Blocks(rng, counts, axes, left_out, rng.choice((0, 0, 3)))
            w = rng.choice((None, weight))
            degrees = {p for p, _ in axes}
            collection = "NURBS%d" % min(degrees) if len(degrees) == 1 and rng.random() < .5 else "NURBS"
            text = blocks.text(place, w, rng.randrange(2), collection=collection)
            self.assert_same(self.read(text), list(blocks.maps(place, w or (lambda p: Q(1)))), (trial, text[:2000]))

    def test_files_of_version_1_1(self):
        rng = random.Random(9)
        blocks = mfem_blocks.Blocks(rng, (2, 1), (PARABOLA, LINE))
        wanted = list(blocks.maps(place, weight))
        for extra in ("spacing 0", "refinements 3 -4 spacing 0", "knotvector_refinements 1 5 2 -6 7 spacing 1 -1 2 2 3 4 5 .5 1e3 -6",
                      "refinements 1 1 knotvector_refinements 0 0 spacing 2 0 0 0 0 1 1 1 0 9"):
            self.assert_same(self.read(blocks.text(place, weight, version="v1.1", extra=extra)), wanted)
            self.refused(blocks.text(place, weight, extra=extra))
        for extra in ("", "refinements 3 4", "refinements 3 spacing 0", "refinements 1 2 3 spacing 0", "refinements 1 .5 spacing 0", "knotvector_refinements 1 5 spacing 0", "spacing", "spacing 1",
                      "spacing -1", "spacing 1 0 0 1 0", "spacing 1 0 0 0 1 x", "spacing 1 0 0 -1 0", "spacing 0 refinements 1 1",
                      "knotvector_refinements 0 0 refinements 1 1 spacing 0", "spacing 1 0 0 1 0 1.5", "knotvector_refinements -1 0 spacing 0"):
            self.refused(blocks.text(place, weight, version="v1.1", extra=extra))

    def test_edges_that_no_patch_has(self):
        """They take their numbers, also if they begin and end at one vertex."""
        text = ONE.replace("edges 4\n", "edges 7\n0 4 5\n0 5 5\n1 4 4\n").replace("vertices 4", "vertices 6").replace(
            "weights 1 2 3 4", "weights 1 2 3 4  0 -1 0 0").replace("0 1 0  1 0 0", "0 1 0  9 9 9 9 9 9 9 9 9 9 9 9  1 0 0")
        self.assert_same(self.read(text), self.read(ONE))
        self.bends(text, ("0 4 5", "0 4 6"), ("0 5 5", "2 5 5"), ("0 5 5", "0 4 4"), ("0 5 5", "0 5 4"), ("0 5 5", "0 0 1"), ("1 4 4", "1 2 1"))

    def test_two_dimensions_and_five(self):
        blocks = mfem_blocks.Blocks(random.Random(4), (2, 2), (LINE, CUBIC))
        for of in (lambda p: place(p)[:2], lambda p: place(p) * 2, lambda p: place(p)[:1]):
            self.assert_same(self.read(blocks.text(of)), list(blocks.maps(of, lambda p: Q(1))))


class Separate(MfemTest):
    def test_three_kinds_of_control_points(self):
        rng = random.Random(2)
        for num_axes in (2, 3):
            maps = [texts.bezier([rng.randint(1, 3) for _ in range(num_axes)], lambda *_: [rng.randint(-8, 8), rng.randint(-8, 8), 1, Q(rng.randint(1, 8), 4)], True) for _ in range(3)]
            for kind in ("controlpoints", "controlpoints_homogeneous"):
                self.assert_same(self.read(texts.mfem_text(maps, kind)), maps)
            exact = [texts.Map(m.degrees, m.knots, [(w * x, w * y, w * z, w) for x, y, z, w in m.points], True) for m in maps]
            self.assert_same(self.read(texts.mfem_text(exact, "controlpoints_cartesian")), exact)

    def test_patches_of_different_dimensions(self):
        maps = [texts.bezier((1, 2), lambda u, v: [u, v, 2], True), texts.bezier((1, 1), lambda u, v: [u, v, u * v, 1], True)]
        self.assert_same(self.read(texts.mfem_text(maps)), maps)
        self.assertEqual([e.dimension for e in read_subject(texts.mfem_text(maps), "mfem")], [2, 3])

    def test_edges_mean_nothing_here(self):
        text = texts.mfem_text([texts.bezier((1, 1), lambda u, v: [u, v, 0, 1], True)]).decode()
        self.assert_same(self.read(text.replace("edges\n0", "edges\n2 99 98 97 0 0 0")), self.read(text))
        self.refused(text.replace("edges\n0", "edges\n1 99 98 -1"), text.replace("edges\n0", "edges\n1 99 98"))

    def test_refusals(self):
        text = texts.mfem_text([texts.bezier((1, 1), lambda u, v: [u, v, 0, 1], True)]).decode()
        self.bends(text, ("knotvectors\n2", "knotvectors\n3"), ("dimension\n3", "dimension\n0"), ("dimension\n3", "dimension\n1001"), ("dimension\n3", "dimension\n2"),
                   ("controlpoints_homogeneous", "controlpoints_"), ("1 2 0 0 1 1", "0 2 0 0 1 1"), ("1 2 0 0 1 1", "1 1 0 0 1"), ("1 2 0 0 1 1", "1 2 0 1 0 1"),
                   ("1 2 0 0 1 1", "1 2 0 0 0 1"), ("1 2 0 0 1 1", "64 2 0 0 1 1"), ("patches", "patch"), ("0 0 0 1\n", "0 0 0 0\n"), ("0 0 0 1\n", "0 0 0 -1\n"), ("0 0 0 1\n", "0 0 0 1 1\n"))
        words = text.split()
        self.refused(*(" ".join(words[:n]) for n in range(len(words))), text + " 0", text + "patches")


class Head(MfemTest):
    def test_comments_blanks_and_words(self):
        wanted = self.read(ONE)
        for text in (ONE.replace("\n", "# a 1 # b\n"), ONE.replace("\n", "\r"), ONE.replace(" ", "\n\v\f\t"), "\u00ef\u00bb\u00bf" + ONE + "# end", "#\r" + ONE, ONE.replace("elements 1", "elements 1#2")):
            self.assert_same(self.read(text), wanted)
        self.refused(ONE.replace("elements 1", "elements# 1"), ONE.replace("weights", "#weights"), ONE + "0", "", "#", ONE.replace("Ordering: 1", "Ordering:# 1"))
        for word in ("MFEM", "NURBS", "mesh", "v1.0", "dimension", "elements", "boundary", "edges", "vertices", "knotvectors", "weights", "FiniteElementSpace", "FiniteElementCollection:", "VDim:",
                     "Ordering:"):
            self.refused(*(re.sub(r"(?<!\S)%s(?!\S)" % re.escape(word), new, ONE, count=1) for new in (word.swapcase(), word[:-1], word + "x", "")))
        self.refused(ONE.replace("v1.0", "v1.2"), ONE.replace("v1.0", "1.0"), ONE.replace("NURBS mesh", "mesh"))

    def test_truncations(self):
        words = ONE.split()
        self.refused(*(" ".join(words[:n]) for n in range(len(words))))

    def test_topology(self):
        self.bends(ONE, ("dimension 2", "dimension 1"), ("dimension 2", "dimension 3"), ("dimension 2", "dimension 4"), ("elements 1", "elements 0"), ("elements 1", "elements 2"), ("elements 1", "elements -1"),
                   ("1 3 0 1 2 3\n", "1 4 0 1 2 3\n"), ("1 3 0 1 2 3\n", "x 3 0 1 2 3\n"), ("1 3 0 1 2 3\n", "1 3 0 1 2 4\n"), ("1 3 0 1 2 3\n", "1 3 0 1 2 -3\n"), ("1 3 0 1 2 3\n", "1 3 0 1 2 2\n"),
                   ("1 3 0 1 2 3\n", "1 3 0 2 1 3\n"), ("1 3 0 1 2 3\n", "1 3 0 1 3 2\n"), ("1 1 0 1", "1 2 0 1"), ("1 1 0 1", "1 4 0 1"), ("1 1 0 1", "1 1 0 -1"), ("1 1 0 1", "1 1 0 9999"),
                   ("boundary 4", "boundary 3"), ("boundary 4", "boundary -4"), ("edges 4", "edges 3"), ("edges 4", "edges 5"), ("0 0 1\n", "2 0 1\n"), ("0 0 1\n", "0 0 4\n"), ("0 0 1\n", "1 0 1\n"),
                   ("1 1 2\n", "1 0 1\n"), ("1 1 2\n", "1 1 0\n"), ("1 1 2\n", "1 1 3\n"), ("0 3 2\n", "1 3 2\n"), ("vertices 4", "vertices 3"), ("vertices 4", "vertices 5"), ("vertices 4", "vertices -4"))
        self.assert_same(self.read(ONE.replace("1 1 0 1 ", "7 0 40  7 3 1 1 1 1  7 5 1 2 3 4 5 6 7 8 ").replace("boundary 4", "boundary 6")), self.read(ONE))

    def test_knot_vectors_and_space(self):
        self.bends(ONE, ("knotvectors 2", "knotvectors 0"), ("knotvectors 2", "knotvectors 1"), ("knotvectors 2", "knotvectors 3"), ("knotvectors 2", "knotvectors -2"), ("1 3 0 0 1 3 3", "1 3 0 0 3 1 3"),
                   ("1 3 0 0 1 3 3", "1 3 0 0 0 3 3"), ("1 3 0 0 1 3 3", "1 4 0 0 1 2 3 3"), ("1 3 0 0 1 3 3", "2 3 0 0 0 3 3 3"), ("1 3 0 0 1 3 3", "1 3 0 0 1 3"), ("1 3 0 0 1 3 3", "64 3 0 0 1 3 3"),
                   ("NURBS1", "NURBS2"), ("NURBS1", "NURBS01"), ("NURBS1", "NURBS+1"), ("NURBS1", "NURBSx"), ("NURBS1", "H1_2D_P1"), ("NURBS1", "nurbs"), ("NURBS1", "NURBS1.0"), ("NURBS1", "NURBS0"),
                   ("NURBS1", "NURBS" + "1" * 5000), ("VDim: 3", "VDim: 0"), ("VDim: 3", "VDim: 2"), ("VDim: 3", "VDim: 1001"), ("Ordering: 1", "Ordering: 2"), ("Ordering: 1", "Ordering: -1"),
                   ("weights 1 2", "weights 0 2"), ("weights 1 2", "weights -1 2"), ("weights 1 2", "weights 2"), ("weights 1 2 3 4 5 6", "weights"), ("weights 1 2 3 4 5 6", "unitweights 1"))
        mixed = ONE.replace("1 2 0 0 1 1", "2 3 0 0 0 1 1 1").replace("NURBS1", "NURBS").replace("5 6\n", "5 6 7 8 9\n").replace("1 1 5\n", "1 1 5 7 7 7 8 8 8 9 9 9\n")
        self.bends(mixed, ("NURBS V", "NURBS1 V"), ("NURBS V", "NURBS2 V"))

    def test_integers_and_decimals(self):
        for old, words in (("1 3 0 1 2 3\n", ("x", "1.0", "1e0", "--1", "+", "4611686018427387905", "-4611686018427387905", "9" * 5000, "1_0", "\u00b2")),):
            self.refused(*(ONE.replace(old, w + old[1:], 1) for w in words))
        for word in ("+7", "-0", "-4611686018427387904", "0" * 5000 + "1"):
            self.assertTrue(texts.is_read(vc, ONE.replace("1 3 0 1 2 3\n", word + " 3 0 1 2 3\n"), "mfem"))
        self.bends(ONE, *[("1 1 5\n", "1 1 %s\n" % w) for w in ("x", "1,5", "1/2", "0x1", "nan", ".", "1e", "1e4097", "1" * 1001)])


class Faces(MfemTest):
    def twisted(self, order):
        """Two blocks; the second one's vertices of the common face in another order."""
        blocks = mfem_blocks.Blocks(random.Random(1), (2, 1, 1), (LINE, LINE, LINE))
        common = [v for v, p in blocks.at_vertex.items() if p[0] == 1]
        patch = blocks.patches[1]
        places = [patch.index(v) for v in common]
        blocks.patches[1] = list(patch)
        for at, k in zip(places, order):
            blocks.patches[1][at] = common[k]
        pairs = {(min(a, b), max(a, b)) for _, a, b in blocks.edges}
        blocks.edges += [(0, a, b) for a in range(12) for b in range(a + 1, 12) if (a, b) not in pairs]
        return blocks.text(lambda p: place(p), None)

    def test_faces_with_equal_vertices_agree_in_their_cyclic_order(self):
        answers = {}
        for order in ((0, 1, 2, 3), (1, 0, 2, 3), (0, 2, 1, 3), (3, 1, 2, 0), (0, 1, 3, 2), (3, 2, 1, 0)):
            # All knot vectors are equal, but have different numbers: only their numbers along the axes could be refused.
            text = re.sub(r"(?m)^[12] (\d+) (\d+)$", r"0 \1 \2", self.twisted(order))
            answers[order] = texts.is_read(vc, text, "mfem")
        self.assertEqual({order for order, good in answers.items() if good}, {(0, 1, 2, 3), (3, 1, 2, 0), (0, 2, 1, 3), (3, 2, 1, 0)})


class Hostile(MfemTest):
    def test_counts_that_lie_take_no_time(self):
        start, n = time.process_time(), 99000
        for old, new in (("elements 1", "elements %d" % n), ("boundary 4", "boundary %d" % n), ("edges 4", "edges %d" % n), ("knotvectors 2", "knotvectors %d" % n), ("1 3 0 0 1 3 3", "1 %d 0 0 1 3 3" % n),
                         ("VDim: 3", "VDim: 1000"), ("vertices 4", "vertices %d" % n), ("elements 1", "elements 9999999999999")):
            text = ONE.replace(old, new)
            self.refused(text, text + "#" * (100000 - len(text)))
        self.assertLess(time.process_time() - start, 5)

    def test_edges_that_announce_more_control_points_than_there_are(self):
        """Thirty thousand times thirty thousand, had they to be made."""
        rows = "\n".join("0 %d %d" % (i, i + 1) for i in range(4, 3000))
        knots = "0 0 %s 3000 3000" % " ".join(map(str, range(1, 2999)))
        text = ONE.replace("edges 4\n", "edges %d\n%s\n" % (3000, rows)).replace("vertices 4", "vertices 3001").replace("1 3 0 0 1 3 3", "1 3000 " + knots)
        start = time.process_time()
        self.refused(text)
        self.assertLess(time.process_time() - start, 5)

    def test_patches_that_share_everything(self):
        """Each patch of one set of vertices has as many control points as the whole file."""
        n = 120
        knots = "1 %d 0 0 %s %d %d" % (n, " ".join(map(str, range(1, n - 1))), n, n)
        patches = "1 3 0 1 2 3\n" * 400
        text = ONE.replace("elements 1\n1 3 0 1 2 3\n", "elements 400\n" + patches).replace("1 3 0 0 1 3 3", knots).replace("1 2 0 0 1 1", knots)
        start = time.process_time()
        self.refused(text)
        self.assertLess(time.process_time() - start, 5)

    def test_long_coefficients_take_no_time(self):
        words = ("1e4096", "3e-4096", "7e2000")
        points = " ".join("%s %s %s" % (words[i % 3], words[(i + 1) % 3], words[i % 2]) for i in range(900))
        text = texts.mfem_head(2, 1) + "patches knotvectors 2 29 30 %s 29 30 %s dimension 2 controlpoints_cartesian %s" % (("0 " * 30 + "1 " * 30,) * 2 + (points,))
        start = time.process_time()
        self.assertEqual(len(self.read(text)), 1)
        self.assertLess(time.process_time() - start, 10)


class Certificates(unittest.TestCase):
    def test_sound_models_are_accepted(self):
        for make in (models.octant_sphere, models.torus):
            entities = make()
            texts.accepted(self, vc, texts.mfem_text([texts.map_of(e) for e in entities]), "mfem", forge.Prover(entities).prove())
        rational = [texts.Map(m.degrees, m.knots, [(*p, 1) for p in m.points], True) for m in map(texts.map_of, models.cube())]
        texts.accepted(self, vc, texts.mfem_text(rational, "controlpoints_cartesian"), "mfem", forge.Prover([m.entity() for m in rational]).prove())

    def test_volumes_fail_b2(self):
        blocks = mfem_blocks.Blocks(random.Random(5), (2, 1, 1), (LINE, PARABOLA, LINE))
        data = blocks.text(place).encode()
        self.assertEqual(read_subject(data, "mfem"), [None, None])
        plan = forge.Plan([])
        plan.entities, plan.flags, plan.values = [None, None], [0, 0], {"subject_format": "mfem"}
        self.assertEqual(vc.check(data, plan.certificate(data))[1][:9], "REJECT B2")


class Mutations(MfemTest):
    def test_mutated_texts_get_one_answer(self):
        """With both checkers as judges: neither a crash nor two answers."""
        rng = random.Random(73)
        blocks = mfem_blocks.Blocks(random.Random(5), (2, 1, 1), (SKEW, LINE, LINE))
        bases = [ONE, blocks.text(place, weight, version="v1.1", extra="spacing 0"), texts.mfem_text([texts.bezier((1, 1), lambda u, v: [u, v, 0, 1], True)]).decode()]
        bits = ["0", "1", "2", "3", "-1", "5", "1e4096", "x", "#", "NURBS", "NURBS1", "patches", "knotvectors", "weights", "unitweights", "", "2.", "+", "4", "7", "controlpoints_cartesian", "v1.1",
                "refinements", "spacing"]
        for trial in range(400):
            words = bases[trial % 3].replace("\n", " \n ").split(" ")
            for _ in range(rng.randrange(1, 3)):
                at = rng.randrange(len(words))
                if rng.random() < .3:
                    other = rng.randrange(len(words))
                    words[at], words[other] = words[other], words[at]
                else:
                    words[at:at + rng.randrange(3)] = [rng.choice(bits)] * rng.randrange(2)
            texts.is_read(vc, " ".join(words), "mfem")


if __name__ == "__main__":
    unittest.main()
