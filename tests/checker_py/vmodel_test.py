#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of vmodel-1: V-models that are mapped one to one, a lie for every clause of every condition, false models of which all
but one condition is right, limits, hostile bytes. A lie differs from an honest certificate in nothing else; where the test says `alone`, it
is accepted without the condition that rejects it."""
import itertools
import os
import random
import unittest
from fractions import Fraction as Q

import model_texts as texts
import star_box_test as star
import volume_folded_forge as folds
import volume_folded_test as fold_tests
import vmodel_false_models as false_models
import vmodel_forge as forge
import vmodel_models as models
from vmodel_forge import LEAF

vc = star.vc
SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
NUMBERS = ("cells", "pieces", "half_v_surfaces", "v_surfaces", "v_curves", "v_points", "euler", "reversed", "singular", "patches", "shells",
           "bodies", "genus", "boxes")


class VModelTest(unittest.TestCase):
    def says(self, expected, plan, skip=()):
        model = plan.model()
        code, line = vc._check(model, plan.certificate(model), frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT " + plan.claim, "ACCEPT"), expected, line)
        self.assertEqual(code, {"ACCEPT": 0, "ERROR": 4}.get(expected, 1), line)

    def alone(self, condition, plan):
        self.says(condition, plan)
        self.says("ACCEPT", plan, {condition})

    def reaches_x(self, expected, plan):
        """Judges a certificate whose X is empty: B1 is the first that can fail there."""
        plan.x = b""
        self.says("B1" if expected == "ACCEPT" else expected, plan.settled())


class Honest(VModelTest):
    def test_models_that_are_mapped_one_to_one(self):
        for name in models.honest_models():
            with self.subTest(name):
                self.says("ACCEPT", models.honest(name))

    def test_cells_whose_parameters_have_other_names_and_directions(self):
        for name in ("three in an L", "in a cube", "a fan", "a pyramid with breaks", "curved pair"):
            for seed in range(2):
                maps, options = models.honest_models()[name]
                with self.subTest(name, seed=seed):
                    if options:                           # all names, and the breaks with them
                        axes = [(1, 2, 0), (2, 0, 1)][seed]
                        plan = forge.proved([models.permuted(m, axes) for m in maps], None, [[added[a] for a in axes] for added in options["added"]])
                    else:
                        plan = forge.proved(*models.renamed(maps, random.Random(seed)))
                    self.assertEqual(plan.values["v_curves"], models.honest(name).values["v_curves"])
                    self.says("ACCEPT", plan)

    def test_every_format(self):
        for name in ("cube", "two", "mirrored", "a wedge", "a ring", "squares", "in a cube"):
            for subject_format in ("itd", "g2", "mfem"):
                with self.subTest(name, format=subject_format):
                    plan = models.honest(name).changed(subject_format=subject_format, text=None)
                    if subject_format == "mfem":          # every map is rational, and N of another degree
                        plan.maps = [folds.made_rational(m) for m in plan.maps]
                        plan.entries = forge.signs_of(plan)
                    self.says("ACCEPT", plan)

    def test_numbers_that_are_known(self):
        """(cells, V-points, V-curves, V-surfaces, half-V-surfaces, genus)"""
        known = {"cube": (1, 8, 12, 6, 6, 0), "two": (2, 12, 20, 11, 12, 0), "three in an L": (3, 16, 28, 16, 18, 0),
                 "in a cube": (7, 16, 32, 24, 42, 0), "a ring": (1, 4, 8, 5, 6, 1), "a figure eight": (13, 48, 100, 64, 78, 2),
                 "a wedge": (1, 6, 9, 5, 5, 0),
                 "a pyramid": (1, 5, 8, 5, 5, 0), "six pyramids": (6, 9, 20, 18, 30, 0), "a fan": (4, 10, 21, 16, 20, 0),
                 "a shrunk edge": (1, 7, 11, 6, 6, 0)}
        for name, numbers in known.items():
            values = models.honest(name).values
            self.assertEqual(tuple(values[k] for k in ("cells", "v_points", "v_curves", "v_surfaces", "half_v_surfaces", "genus")), numbers, name)
            euler = values["v_points"] - values["v_curves"] + values["v_surfaces"] - values["cells"]
            self.assertEqual(values["euler"], 2 * euler if euler >= 0 else -2 * euler - 1)

    def test_the_signs_are_those_of_another_way_to_compute_them(self):
        """At random points of random cells, rational or not, with inner knots or not."""
        rng, kinds = random.Random(5), set()
        for trial in range(12 * SCALE):
            m = fold_tests.random_volume(rng)
            flag = rng.randrange(2)
            for index, net in forge.pieces(m, [[], [], []])[:4]:
                values, degrees = forge.determinant(net, m.degrees, m.rational, flag)
                for ends in itertools.product((0, 1), repeat=3):
                    at = values[tuple(e * n for e, n in zip(ends, degrees))]
                    sign = folds.sign(m, tuple(zip(index, ends))) * (-1 if flag else 1)
                    self.assertEqual((at > 0) - (at < 0), sign, (trial, index, ends))
            plan = forge.Plan([m], [flag])
            plan.codes = [1 if forge.collapse_of(net) else 0 for net in forge.Faces([m], plan.added).nets]
            plan.entries = forge.signs_of(plan, 2)
            holds = all(self.holds(net, m, flag, plan.entries.get(n, ((), LEAF)))
                        for n, (_, net) in enumerate(forge.pieces(m, [[], [], []])))
            self.reaches_x("ACCEPT" if holds else "V2", plan)
            kinds.add(holds)
        self.assertIn(False, kinds)

    def holds(self, net, m, flag, entry):
        values, degrees = forge.determinant(net, m.degrees, m.rational, flag)
        try:
            return forge.tree_of(values, degrees, entry[0], 2) == entry[1]
        except ValueError:
            return False

    def test_all_names_and_directions_of_parameters(self):
        """The common face of two cells has no symmetry: one symmetry of eight fits."""
        bump = [Q(0), Q(1, 8), Q(1, 4), Q(1, 2)]

        def cell(first):
            return folds.cube(lambda p: (first + p[0] + (bump[int(p[1] + 2 * p[2])] if first + p[0] == 1 else 0), p[1], p[2]))
        found = set()
        for axes in itertools.permutations(range(3)):
            for reverse in itertools.product((0, 1), repeat=3):
                plan = forge.Plan([cell(0), models.permuted(cell(1), axes, reverse)], [0, models.is_mirror(axes, reverse)])
                right = forge.glued(forge.Faces(plan.maps, plan.added), plan.flags)[1]
                self.assertIsInstance(right, tuple)
                for symmetry in range(8):
                    plan.codes = [0] * 12
                    plan.codes[1], plan.codes[right[0]] = (right[0], symmetry), 2
                    self.reaches_x("ACCEPT" if symmetry == right[1] else "V3", plan)
                found.add(right)
        self.assertEqual(len(found), 48)

    def test_faces_that_agree_up_to_a_factor(self):
        with_knot = folds.with_knots(1, [1])
        maps = [models.spline((1, 1, 1), [[0, 0, 1, 1], with_knot, [0, 0, 1, 1]], lambda i, j, k, x=x: (x + i, Q(j), Q(k))) for x in (0, 1)]
        heavy = texts.Map(maps[1].degrees, maps[1].knots, [tuple(5 * c for c in (*p, 1)) for p in maps[1].points], True)
        plan = forge.proved([maps[0], heavy])
        self.assertEqual(sum(isinstance(code, tuple) for code in plan.codes), 1)
        self.says("ACCEPT", plan)

    def test_trees_deeper_than_needed_and_zeros_that_are_listed_by_corners(self):
        plan = models.honest("cube")
        tree = LEAF
        for level in range(64):
            tree = (level % 3, tree, LEAF) if level % 2 else (level % 3, LEAF, tree)
        self.says("ACCEPT", plan.changed(entries={0: ((), tree)}))
        self.says("B1", plan.changed(entries={0: ((), (0, LEAF, (1, tree, LEAF)))}))


class FalseModels(VModelTest):
    # PROVES VMODEL-1
    def test_each_is_rejected_by_the_condition_that_it_breaks(self):
        for name in false_models.FALSE:
            with self.subTest(name):
                plan, condition = false_models.false(name)
                (self.alone if name not in false_models.NOT_ALONE else self.says)(condition, plan)

    def test_an_inner_face_that_is_a_point(self):
        """Cut at that face, each half is sound; V1 and V2 both reject it."""
        plan = false_models.double_pyramids(True)
        self.says("V1", plan)
        self.says("V2", plan, {"V1"})
        self.says("ACCEPT", plan, {"V1", "V2"})


class Lies(VModelTest):
    def change(self, name, **fields):
        return models.honest(name).changed(**fields).settled()

    def codes(self, name, **codes):
        plan = models.honest(name)
        for face, code in codes.items():
            plan.codes[int(face[1:])] = code
        return plan.settled()

    # PROVES VMODEL-1.V1
    def test_v1_codes(self):
        for code in (0, 2):
            self.says("V1", self.codes("a wedge", f0=code))
        self.says("V1", self.codes("six pyramids", f0=(6, 0), f6=2))
        for face in range(6):
            self.says("V1", self.codes("cube", **{"f%d" % face: 1}))

    def test_v1_equal_points_with_other_weights_are_not_collapsed(self):
        """Traps: the weights (1, 1, 1) and (1, 4, 1) of two rows."""
        def cell(weights, low):
            """The face u = 0 is the line from (0, 0, low) to (0, 0, low + 1); the weights of the row w are weights[w]."""
            points = [(u, u * v, low + w, weights[w][int(2 * v)]) for w in (0, 1) for v in (0, Q(1, 2), 1) for u in (0, 1)]
            return texts.Map((1, 2, 1), [[0, 0, 1, 1], [0, 0, 0, 1, 1, 1], [0, 0, 1, 1]], [(x * f, y * f, z * f, f) for x, y, z, f in points], True)
        for low in (0, -1):                               # the point 0 is equal to all its multiples
            for weights, is_collapsed in ((((1, 1, 1), (1, 1, 1)), True), (((1, 4, 1), (2, 8, 2)), True), (((1, 1, 1), (1, 4, 1)), False)):
                m = cell(weights, low)
                self.assertEqual(forge.collapse_of(forge.Faces([m], [[[], [], []]]).nets[0]), "first" if is_collapsed else None)
                for code in (0, 1):
                    plan = forge.Plan([m])
                    plan.codes[0], plan.entries = code, {0: ([8], LEAF)}
                    self.reaches_x("ACCEPT" if is_collapsed == bool(code) else "V1", plan)

    def test_v1_an_edge_that_collapses_on_one_of_two_spans(self):
        knots = [[0, 0, 1, 1], [0, 0, 1, 1], [0, 0, 1, 2, 2]]
        heights = (0, 1, 2)

        def point(i, j, k, short):
            return Q(i), Q(j), Q(heights[k] if (i, j) != (1, 1) or not short else max(0, heights[k] - 1))
        for short in (False, True):
            plan = forge.Plan([models.spline((1, 1, 1), knots, lambda i, j, k, s=short: point(i, j, k, s))])
            plan.entries = forge.signs_of(plan)
            self.reaches_x("V1" if short else "ACCEPT", plan)

    def test_v1_an_edge_inside_of_a_side_that_is_no_edge_of_the_cell(self):
        """The height along w is 0 at the knots 0, 1 and 2 of the side v = 0: at its ends it may be, at the knot 1 it may not."""
        for heights, says in (((0, 1, 0, 1, 0), "V1"), ((0, 1, 1, 1, 0), "ACCEPT")):
            knots = [[0, 0, 0, 1, 1, 2, 2, 2], [0, 0, 1, 1], [0, 0, 1, 1]]
            plan = forge.Plan([models.spline((2, 1, 1), knots, lambda i, j, k, h=heights: (Q(i, 2), Q(j), Q(k) * (1 if j else h[i])))])
            plan.entries = forge.signs_of(plan)
            self.reaches_x(says, plan)

    def test_v1_a_side_that_collapses_onto_a_curve_with_a_constant_part(self):
        for axes in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1)):
            for heights, says in (((0, 0, 1), "V1"), ((0, Q(1, 2), 1), "ACCEPT")):
                knots = [[0, 0, 1, 1], [0, 0, 1, 1], [0, 0, 1, 2, 2]]
                m = models.spline((1, 1, 1), knots, lambda i, j, k, h=heights: (Q(i), Q(i * j), Q(k) if i else h[k]))
                plan = forge.Plan([models.permuted(m, axes)], [models.is_mirror(axes, (0, 0, 0))])
                plan.codes, plan.entries = forge.glued(forge.Faces(plan.maps, plan.added), plan.flags), forge.signs_of(plan)
                self.assertIn(1, plan.codes)
                self.reaches_x(says, plan)

    def test_v2_zeros(self):
        cube = models.honest("cube")
        for zero in range(26):
            self.alone("V2", cube.changed(entries={0: ([zero], LEAF)}).settled())
        wedge = models.honest("a wedge")
        for zero in (2, 5, 6, 7, 0, 1):                   # edges and corners of the face
            self.says("V2", wedge.changed(entries={0: ([8, zero], LEAF)}).settled())
            self.says("V2", wedge.changed(entries={0: ([zero], LEAF)}).settled())
        self.says("V2", wedge.changed(entries={}).settled())
        for name in ("a flat edge", "a shrunk edge", "squares"):
            self.alone("V2", models.honest(name).changed(entries={}).settled())

    def test_v2_a_zero_inside_of_a_cell(self):
        """x = (2u - 1)^3 is one to one, but N is 0 on a face that is inside."""
        cubed = (-1, 1, -1, 1)
        m = folds.bezier((3, 1, 1), lambda u, v, w: (cubed[int(3 * u)], v, w))
        plan = forge.proved([m], added=[[[Q(1, 2)], [], []]])
        self.assertEqual([zeros for zeros, _ in plan.entries.values()], [[17], [8]])
        self.alone("V2", plan)

    def test_v2_a_zero_on_a_glued_face(self):
        square = (0, 0, 1)
        a = folds.bezier((2, 1, 1), lambda u, v, w: (square[int(2 * u)], v, w))
        b = folds.bezier((2, 1, 1), lambda u, v, w: (-square[int(2 * u)], v, w))
        plan = forge.proved([a, b], [0, 1])
        self.assertEqual(plan.entries, {0: ([8], LEAF), 1: ([8], LEAF)})
        self.alone("V2", plan)

    # PROVES VMODEL-1.V2
    def test_v2_leaves(self):
        plan = models.honest("a tree")
        self.alone("V2", plan.changed(entries={}).settled())
        (zeros, tree), = plan.entries.values()
        axis, low, high = tree
        for other in ((1 - axis, low, high), (2, low, high)):
            self.alone("V2", plan.changed(entries={0: (zeros, other)}).settled())
        for name in ("cube", "two", "a wedge"):
            honest = models.honest(name)
            for cell in range(len(honest.flags)):
                turned = list(honest.flags)
                turned[cell] = 1
                self.says("V2", honest.changed(flags=turned).settled())

    def test_v2_every_leaf_is_tested(self):
        """N is negative in one half, or in the last or first of many parts."""
        for x in ((0, 1, 2, 1), (0, -1, 0, 1)):
            plan = forge.Plan([folds.bezier((3, 1, 1), lambda u, v, w, x=x: (x[int(3 * u)], v, w))])
            for tree in ((0, LEAF, LEAF), (0, LEAF, (0, LEAF, LEAF)), (0, (0, LEAF, LEAF), LEAF)):
                plan.entries = {0: ((), tree)}
                self.reaches_x("V2", plan)

    def test_v2_zeros_of_the_piece_do_not_excuse_leaves_inside(self):
        """N = u (1 - u) (1 - 2u)^2: the faces u = 0 and u = 1 are zeros, the plane u = 1/2, where the leaves end, is not."""
        x = (0, 0, 3, -1, 2, 2)                           # 12/5 times the integral of N
        plan = forge.Plan([folds.bezier((5, 1, 1), lambda u, v, w: (x[int(5 * u)], v, w))])
        plan.entries = {0: ([8, 17], (0, LEAF, LEAF))}
        (_, net), = forge.pieces(plan.maps[0], [[], [], []])
        values, degrees = forge.determinant(net, (5, 1, 1), False, 0)
        self.assertEqual(forge.zeros_of(values, degrees), [8, 17])
        for part in forge.halves(values, degrees, 0):
            self.assertEqual(min(part.values()), 0)
            self.assertEqual(forge.zeros_of(part, degrees), [8, 17])
        self.reaches_x("V2", plan)

    def test_v3_names(self):
        self.says("V3", self.codes("cube", f0=2))
        self.says("V3", self.codes("two", f6=0))
        self.says("V3", self.codes("two", f1=0))
        self.says("V3", self.codes("two", f1=(7, 0)))
        self.says("V3", self.codes("two", f0=(6, 0)))
        self.says("V3", self.codes("three in an L", f0=(1, 0)))

    # PROVES VMODEL-1.V3
    def test_v3_orientation_breaks_and_maps(self):
        plan = models.honest("two")
        for symmetry in range(1, 8):
            self.alone("V3", self.codes("two", f1=(6, symmetry)))
        with_breaks = models.honest("two with breaks")
        for added in ([[[], [Q(1, 3)], []], [[], [8], []]], [[[], [Q(1, 3)], []], [[], [], []]], [[[], [Q(2, 3)], []], [[], [9], []]],
                      [[[], [Q(1, 3)], []], [[], [8, 9], []]]):
            lie = with_breaks.changed(added=added)
            self.reaches_x("V3", lie)
        for k in range(3):                                # one of the four corners of one face, by one ulp
            near = [p if p != (1, 1, 1) else tuple(c + (Q(1, 1 << 52) if i == k else 0) for i, c in enumerate(p)) for p in plan.maps[0].points]
            m = texts.Map((1, 1, 1), plan.maps[0].knots, near)
            self.reaches_x("V3", plan.changed(maps=[m, plan.maps[1]], text=None))

    def test_v3_pieces_that_are_equal_at_other_breaks(self):
        """The knot at 1/2 of one cell has moved to 1/3 in the other: each piece of the face is what it was."""
        for knot, says in ((Q(1, 2), "ACCEPT"), (Q(1, 3), "V3")):
            maps = [models.spline((1, 1, 1), [[0, 0, 1, 1], [0, 0, t, 1, 1], [0, 0, 1, 1]], lambda i, j, k, x=x: (Q(x + i), Q(j), Q(k)))
                    for x, t in ((0, Q(1, 2)), (1, knot))]
            plan = forge.Plan(maps)
            plan.codes[1], plan.codes[6] = (6, 0), 2
            self.reaches_x(says, plan)

    def test_v3_faces_that_differ_in_signs_alone(self):
        a, b = models.honest("two").maps
        turned = models.mapped(b, lambda p: (p[0], -p[1], -p[2]))
        for other, says in ((b, "ACCEPT"), (turned, "V3")):
            plan = forge.Plan([a, other])
            plan.codes[1], plan.codes[6] = (6, 0), 2
            self.reaches_x(says, plan)

    def test_v3_other_maps_of_one_face(self):
        """The points are equal, under a quadratic change of parameters or with a polynomial factor."""
        a, squared = models.honest("two").maps[0], (0, Q(1, 4), 1)     # v -> (v + v^2) / 2
        change = folds.bezier((1, 2, 1), lambda u, v, w: (1 + u, squared[int(2 * v)], w))
        weights = (1, Q(3, 2), 2)                         # times 1 + v
        half = (0, Q(1, 2), 1)
        times = texts.Map((1, 2, 1), change.knots, [tuple(c * weights[int(2 * v)] for c in (1 + u, p, w, 1)) for w in (0, 1) for v, p in zip(
            (0, Q(1, 2), 1), (0, Q(2, 3), 1)) for u in (0, 1)], True)
        fair = folds.bezier((1, 2, 1), lambda u, v, w: (1 + u, half[int(2 * v)], w))
        for other, expected in ((fair, "ACCEPT"), (change, "V3"), (times, "V3")):
            plan = forge.Plan([a, other])
            plan.codes[1], plan.codes[6] = (6, 0), 2
            self.reaches_x(expected, plan)

    # PROVES VMODEL-1.V4
    def test_v4(self):
        plan, _ = false_models.false("turned in X")
        self.alone("V4", plan)
        for name, other in (("cube", "cube with breaks"), ("cube with breaks", "cube")):
            lie = models.honest(name)
            lie.x = forge.ProverOfX(forge.entities_of_x(lie), forge.breaks_of_x(models.honest(other))).prove().plan
            self.alone("V4", lie.settled())

    def test_w3(self):
        for name in ("cube", "two", "a wedge", "a ring", "mirrored"):
            plan = models.honest(name)
            for key in NUMBERS:
                for step in (-1, 1):
                    if plan.values[key] + step >= 0:
                        self.alone("W3", plan.changed(values={**plan.values, key: plan.values[key] + step}))

    def test_b1_of_the_head(self):
        plan = models.honest("two with breaks")
        for magic in (b"VTVF", b"VTS2", b"vtvm"):
            self.says("B1", plan.changed(magic=magic))
        for count in (0, 1, 3, 1 << 20, (1 << 32) - 1):
            self.says("B1", plan.changed(count=count))
        self.says("B1", plan.changed(flags=[0, 2]))
        for added in ([0], [1], [-1], [2], [Q(1, 3), Q(1, 3)], [Q(2, 3), Q(1, 3)]):
            self.says("B1", plan.changed(added=[[[], added, []], plan.added[1]]))
        knot = models.honest("a ring")
        self.says("B1", knot.changed(added=[[[2], [], []]]))
        self.says("B1", plan.changed(tail=b"\0"))
        for name in ("cube", "two"):
            honest = models.honest(name)
            last = 6 * len(honest.flags) - 1
            for code in ((last + 1, 0), (last + 1, 7), ((1 << 58) + 5, 0)):
                honest.codes[last] = code
                self.says("B1", honest)

    def test_b1_of_the_determinants(self):
        plan = models.honest("two")
        for entries, expected in (({0: ((), LEAF)}, "ACCEPT"), ({1: ((), LEAF)}, "ACCEPT"), ({2: ((), LEAF)}, "B1"),
                                  ({0: ((), LEAF), 1: ((), LEAF)}, "ACCEPT"), ({0: ((), LEAF), 1: ((), LEAF), 2: ((), LEAF)}, "B1"),
                                  ({1 << 62: ((), LEAF)}, "B1"), ({(1 << 63) - 1: ((), LEAF)}, "B1"), ({0: (1 << 26, LEAF)}, "B1"),
                                  ({0: (1 << 62, LEAF)}, "B1"), ({0: ((), b"\4\0\0")}, "B1")):
            self.says(expected, plan.changed(entries=entries))
        for piece in (1, 2):
            self.says("B1", plan.changed(entries={0: ((), LEAF), piece + (1 << 62): ((), LEAF)}))

    def test_every_body_that_is_cut_off(self):
        plan = models.honest("a wedge")
        body, x = plan.body(), plan.x.body()
        for n in [*range(len(body) - len(x) + 40), *range(len(body) - 40, len(body))]:
            self.says("B1", plan.changed(body=lambda n=n: body[:n]))
        for n in range(11, len(body) - len(x)):           # a varint that is not in its shortest form
            self.says("B1", plan.changed(body=lambda n=n: body[:n] + bytes([body[n] | 128, 0]) + body[n + 1:]))

    def test_entities_that_are_no_volumes_in_space(self):
        plan = models.honest("cube")
        surface, plane = texts.bezier((1, 1), lambda u, v: (u, v, 0)), texts.bezier((1, 1, 1), lambda u, v, w: (u, v))
        for other in (surface, plane):
            self.says("ERROR", plan.changed(text=texts.json_text([plan.maps[0], other])))
        for subject_format in ("vjson-faces", "stl", "mesh"):
            self.says("S1", plan.changed(values={**plan.values, "subject_format": subject_format}))
        self.says("S1", plan.changed(values={k: v for k, v in plan.values.items() if k != "euler"}))
        self.says("B1", plan.changed(text=texts.json_text([]), count=0, flags=[], added=[], codes=[]))


class Limits(VModelTest):
    """Each limit of B2, at it and beyond it."""

    def test_degrees(self):
        for degree, expected in ((15, "ACCEPT"), (16, "B2")):
            self.reaches_x(expected, forge.Plan([models.box((0, 0, 0), (1, 1, 1), (degree, 1, 1))]))

    def test_pieces(self):
        many = [Q(i, 300) for i in range(1, 257)]
        plan = forge.Plan([models.box((0, 0, 0), (1, 1, 1))], added=[[many, many[:255], many[:255]]])
        plan.values = dict.fromkeys(NUMBERS, 0)
        model = plan.model()
        self.assertEqual(vc._check(model, plan.certificate(model), frozenset())[0], 1)
        plan.numbers = lambda: dict.fromkeys(NUMBERS, 0)
        self.reaches_x("B2", plan)

    def test_bits_of_control_points(self):
        for bits, says in ((4096, "ACCEPT"), (4097, "B2")):
            small = {(1, 0, 0): Q(1, 1 << 4096), (0, 1, 0): Q(1, (1 << bits - 1) + 1)}
            m = folds.cube(lambda p, small=small: (*p[:2], p[2] + small.get(p, 0)))
            self.reaches_x(says, forge.Plan([m]))

    def test_bits_of_all_coefficients(self):
        """In the degrees (5, 5, 5) N has 15^3 = 3375 coefficients; 4971 bits are the most, and are already too much work here."""
        for bits, says in ((4971, "too much work|more work"), (4972, "too long")):
            x = (0, 1, 2, 3, 4, 1 << bits - 1)
            plan = forge.Plan([folds.bezier((5, 5, 5), lambda u, v, w, x=x: (x[int(5 * u)], 5 * v, 5 * w))]).settled()
            line = vc._check(plan.model(), plan.certificate(), frozenset())[1]
            self.assertRegex(line, "REJECT (B2|V2): .*(%s)" % says)

    def test_bits_of_knots_and_breaks(self):
        """The least common denominator of these two breaks has 2048 bits, or one more."""
        for power, says in ((1024, "ACCEPT"), (1025, "B2")):
            plan = forge.Plan([folds.cube()], added=[[[Q(1, 1 << power), Q(1, 3 ** 646)], [], []]])
            self.reaches_x(says, plan)

    def test_work(self):
        """Long knots at high degrees cost work before any coefficient is known; so do many pieces and deep trees."""
        rng = random.Random(3)
        far = sorted(rng.randrange(1 << 2000) for _ in range(20))
        long = forge.Plan([models.box((0, 0, 0), (1, 1, 1), (15, 1, 1))], added=[[[Q(t, (1 << 2000) + 1) for t in far], [], []]])
        many = forge.Plan([models.box((0, 0, 0), (1, 1, 1), (3, 3, 3))], added=[[[Q(i, 20) for i in range(1, 20)]] * 3])
        deep = forge.Plan([models.box((0, 0, 0), (1, 1, 1), (8, 8, 8))])
        tree = LEAF
        for level in range(8):
            tree = (level % 3, tree, tree)
        deep.entries = {0: ((), tree)}
        for plan, says in ((long, "B2"), (many, "[BV]2"), (deep, "V2")):
            plan.values = dict.fromkeys(NUMBERS, 0)
            line = vc._check(plan.model(), plan.certificate(), frozenset())[1]
            self.assertRegex(line, "REJECT %s: .*(too much work|more work)" % says)


class Hostile(VModelTest):
    def test_bytes_of_bodies(self):
        """No certificate of a false model is accepted."""
        rng, accepted = random.Random(11), 0
        false = [false_models.false(name)[0] for name in ("cavity", "folded at a corner", "cell and copies", "one ulp", "turned inner cell")]
        honest = [models.honest(name) for name in ("cube", "two with breaks", "a wedge", "squares", "a ring", "a tree")]
        for trial in range(300 * SCALE):
            is_false = trial % 2 == 0
            plan = rng.choice(false if is_false else honest)
            body = plan.body()
            head = len(body) - len(plan.x.body())
            lie = star.forge.bent(rng, body[:head]) + body[head:] if rng.random() < .8 else body[:head] + star.forge.bent(rng, body[head:])
            code, line = vc._check(plan.model(), plan.changed(body=lambda lie=lie: lie).certificate(), frozenset())
            self.assertIn(code, (1,) if is_false else (0, 1), (trial, lie[:head + 9].hex(), line))
            accepted += code == 0
        self.assertGreater(accepted, 3)


if __name__ == "__main__":
    unittest.main()
