#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates of version 2: S1 with coefficients that are zero."""
import unittest
from fractions import Fraction as Q

import star_box_2_models as models2
import star_box_forge as forge
import star_box_models as models
from star_box_2_judged import Judged, replaced, Box2, Prover2, units

from veritope_checker.patches import star_box_2_sheets as sheets


class ZeroNormals(Judged):
    """S1 with coefficients that are zero: where they may be, and where not."""

    # PROVES STAR-5.FACES
    def test_an_inner_side_whose_normals_are_zero(self):
        """The line u = 1/2 is mapped to one point: two sheets hang together there."""
        bow = forge.surface([[(-1, 0, 0), (-1, 1, 0)], [(0, 0, 0), (0, -1, 0)], [(1, 0, 0), (1, 1, 0)]])
        box = Box2(0, units(-Q(3, 4), -Q(1, 4), -1), units(Q(3, 4), Q(1, 2), 1),
                   [[units(Q(1, 2), Q(1, 8), -Q(1, 2)), units(Q(1, 2), Q(1, 8), Q(1, 2))]])
        self.one_box("C2", [bow], box, roots=1)
        self.one_box("", [bow], box, (sheets, "is_inner_side", lambda *_: False), roots=1)

    def test_an_inner_corner_whose_normal_is_zero(self):
        # r^2 (x, y) in degree three: x^3, x^2, x, 1 over [-1, 1] in Bernstein form
        cube, square, line, one = (-1, 1, -1, 1), (1, -Q(1, 3), -Q(1, 3), 1), (-1, -Q(1, 3), Q(1, 3), 1), (1, 1, 1, 1)
        rows = [[(cube[i] * one[j] + line[i] * square[j], one[i] * cube[j] + square[i] * line[j], 0) for j in range(4)] for i in range(4)]
        box = Box2(0, units(-1, -1, -1), units(1, 1, 1), [[units(Q(1, 4), Q(1, 8), -Q(1, 2)), units(Q(1, 4), Q(1, 8), Q(1, 2))]])
        self.one_box("C2", [forge.surface(rows)], box)
        self.one_box("", [forge.surface(rows)], box, (sheets, "is_inner_corner", lambda *_: False))

    def root(self, entity, edges=True):
        prover = Prover2([entity], checked=False)
        patch = prover.patches[0]
        if edges:
            patch.sides = [side or (n, True) for n, side in enumerate(patch.sides)]
        return next(forge.star_nodes.root_nodes(patch))

    # PROVES STAR-5.RADIAL
    def test_a_side_on_a_line_through_c(self):
        """g = v^2 for every c of the line that the side v = 0 lies on."""
        root = self.root(forge.surface([[(0, 0, z), (Q(1, 2), 0, z), (1, -1, z)] for z in (0, 1)]))
        plus = units(3, 3, Q(1, 2))
        for height, x, expected in ((-1, 0, False), (Q(1, 2), 0, False), (-1, -Q(1, 8), True)):
            minus = units(x, 0, height)
            with self.subTest(x=x, height=height):
                self.assertEqual(sheets.has_s1(root, (minus, plus)), expected)
                with replaced((sheets, "touches_radial_side", lambda *_: False)):
                    self.assertTrue(sheets.has_s1(root, (minus, plus)))

    def test_a_radial_side_that_only_a_corner_of_the_node_touches(self):
        root = self.root(forge.triangle([(0, 0, 0), (0, 0, 1), (1, -1, 0), (0, 0, 2), (1, -1, 1), (2, -4, 0)], 2))
        for node in [root, *root.children()]:
            lies = any(at[2] == 0 for at in node.at)
            self.assertEqual(sheets.touches_radial_side(node, units(0, 0, -5)), lies, node.at)
            self.assertFalse(sheets.touches_radial_side(node, units(0, Q(1, 1 << 20), -5)))

    def test_sides_of_triangles_whose_normals_are_zero(self):
        """Whichever side it is, all nodes have S1; not for a centre in the plane of the face, and not if the zeros lay inside."""
        for turn in range(3):
            root = self.root(models2.folded_octahedron(turn)[0])
            nodes = [root, *root.children(), *[kid for node in root.children() for kid in node.children()]]
            c, outside = units(0, 0, 0), units(1, 1, 1)
            zeros = [min(c for row in node.coefficients()[0] for c in row) == 0 for node in nodes]
            self.assertEqual(sum(zeros), 1 + 3 + 7, turn)  # quarters of quarters: four with a side there, three with a corner
            for node, has_zeros in zip(nodes, zeros):
                self.assertTrue(sheets.has_s1(node, (c, outside)), (turn, node.at))
                self.assertFalse(sheets.has_s1(node, (outside, c)))
                self.assertFalse(sheets.has_s1(node, (units(1, 0, 0), outside)))
                with replaced((sheets, "sides_at", lambda patch, at: [s for s in range(3) if at[s] == 0 and s != turn])):
                    # the root's corners lie on other sides, too
                    self.assertEqual(sheets.has_s1(node, (c, outside)), node is root or not has_zeros, (turn, node.at))

    def test_two_collapsed_sides_with_a_common_corner(self):
        """S = u v T(u, v): no coefficient of its normal is negative, and many are positive."""
        lune = [[(0, 0, 0)] * 3, [(0, 0, 0), (1, 1, 0), (0, 2, 0)], [(0, 0, 0), (2, 0, 0), (2, 2, 0)]]
        root = self.root(forge.surface(lune), False)
        c = units(0, 0, -9), units(0, 0, 9)
        self.assertFalse(sheets.has_s1(root, c))
        with replaced((sheets, "are_apart", lambda *_: True)):
            self.assertTrue(sheets.has_s1(root, c))

    def test_both_centres_count_and_neither_lies_in_the_plane(self):
        root = self.root(forge.triangle([(0, 0, 0), (1, 0, 0), (0, 1, 0)]))
        for minus, plus in ((-1, 1), (0, 1), (-1, 0), (1, -1), (-2, -1), (1, 2), (0, 0)):
            self.assertEqual(sheets.has_s1(root, (units(0, 0, minus), units(0, 0, plus))), minus < 0 < plus, (minus, plus))

    def test_a_node_that_may_have_zeros_at_a_pole(self):
        """The sides beside a collapsed side are looked at, the collapsed one is not: it would lie on every line through its point."""
        prover = Prover2(models.octant_sphere()[:1], checked=False)
        patch, root = prover.patches[0], prover.forest.roots[0]
        pole = [s for s in range(4) if forge.patches.is_collapsed(patch.side(s))]
        self.assertEqual(len(pole), 1)
        patch.sides = [None if s in pole else (s, True) for s in range(4)]
        self.assertFalse(sheets.touches_radial_side(root, (0, 0, 0)))
        patch.sides[pole[0]] = (9, True)
        self.assertTrue(sheets.touches_radial_side(root, (0, 0, 0)))

    def test_a_triangle_that_is_a_point(self):
        root = self.root(forge.triangle([(1, 0, 0)] * 3), False)
        for c in ((units(0, 0, 0), units(2, 0, 0)), (units(2, 0, 0), units(0, 0, 0))):
            with replaced((sheets, "are_apart", lambda *_: True)):
                self.assertFalse(sheets.has_s1(root, c))

    def test_a_patch_with_a_normal_that_is_zero_everywhere(self):
        root = self.root(forge.surface([[(x, 0, 0) for _ in (0, 1)] for x in (0, 1)]))
        self.assertFalse(sheets.has_s1(root, (units(0, 0, -1), units(0, 0, 1))))

if __name__ == "__main__":
    unittest.main()
