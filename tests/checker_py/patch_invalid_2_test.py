#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of patch-invalid-2: models with two points that have one image, a lie for every condition and for
every clause of M1, sound models, hostile bytes. A lie is rejected by its condition and, where the test says `alone`,
accepted without it."""
import random
import unittest
from fractions import Fraction as Q

import patch_invalid_2_forge as forge
import patch_invalid_2_models as meeting
import patch_invalid_models as broken
import patch_invalid_test as first
import star_box_forge as star_forge
import star_box_itd_test as itd
import star_box_models as models
import star_box_test as star

vc, SCALE, Meeting, HALF, CENTROID = first.vc, first.SCALE, forge.Meeting, meeting.HALF, meeting.CENTROID
THIRD = (Q(1, 3), Q(3, 4))


def face_twice():
    """A sound cube whose first face comes once more, as patch 6."""
    return Meeting(models.cube() + models.cube()[:1], (0, *THIRD), (6, *THIRD))


class Honest(first.PatchInvalidTest):
    # PROVES INVALID-3
    def test_models_of_every_kind_are_refuted(self):
        for name, finding in meeting.honest():
            with self.subTest(name):
                self.says("ACCEPT", finding)
                if not any(len(axis) > 2 for axes in finding.breaks for axis in axes):
                    a, b = [forge.point(finding.entities[patch], u, v) for patch, u, v in (finding.a, finding.b)]
                    self.assertEqual(a, b)

    def test_a_turned_or_mirrored_copy_agrees_in_the_middle_and_not_elsewhere(self):
        for patch in (meeting.lopsided(), models.torus()[0]):
            for n, twin in enumerate(meeting.all_turned(patch)):
                self.says("ACCEPT", Meeting([patch, twin], (0, *HALF), (1, *HALF)))
                self.says("ACCEPT" if n == 0 else "M2", Meeting([patch, twin], (0, *THIRD), (1, *THIRD)))
        for degree in (1, 3):
            patch = meeting.lopsided_triangle(degree)
            for n, twin in enumerate(meeting.all_permuted(patch)):
                self.says("ACCEPT", Meeting([patch, twin], (0, *CENTROID), (1, *CENTROID)))
                self.says("ACCEPT" if n == 0 else "M2", Meeting([patch, twin], (0, *THIRD), (1, *THIRD)))

    def test_the_parameters_of_a_turned_copy_turn_with_it(self):
        u, v = THIRD
        places = [(u, v), (u, 1 - v), (1 - u, v), (1 - u, 1 - v), (v, u), (1 - v, u), (v, 1 - u), (1 - v, 1 - u)]
        patch = meeting.lopsided()
        for twin, place in zip(meeting.all_turned(patch), places):
            self.says("ACCEPT", Meeting([patch, twin], (0, u, v), (1, *place)))
            self.says("ACCEPT", Meeting([twin, patch], (0, *place), (1, u, v)))

    def test_the_parameters_of_a_triangle_are_those_of_the_page(self):
        """A patch whose middle lies where (1 - s, s (1 - t), s t) says."""
        s, t = Q(3, 5), Q(2, 7)
        for triangle in (meeting.lopsided_triangle(1), meeting.lopsided_triangle(2), models.cubic_octahedron()[5]):
            weights, rows = (1 - s, s * (1 - t), s * t), forge.rows_of(triangle)
            while len(rows) > 1:
                rows = [[tuple(weights[0] * a + weights[1] * b + weights[2] * c for a, b, c in zip(*three))
                         for three in zip(row, below, below[1:])] for row, below in zip(rows, rows[1:])]
            x, y, z = rows[0][0]
            sheet = broken.sheet((x - 1, y - 1, z), (2, 0, 0), (0, 2, 0))
            self.says("ACCEPT", Meeting([sheet, triangle], (0, *HALF), (1, s, t)))
            self.says("ACCEPT", Meeting([sheet, triangle], (1, s, t), (0, *HALF)))
            for other in ((t, s), (s, 1 - t), (1 - s, t)):
                self.says("M2", Meeting([sheet, triangle], (1, *other), (0, *HALF)))

    def test_a_patch_that_is_a_point_or_a_curve(self):
        for patch in (meeting.one_point(), meeting.one_point(True), meeting.one_curve(),
                      star_forge.triangle([(1, 2, 3)] * 3), star_forge.triangle([(1, 2, 3)] * 10, 3)):
            self.says("ACCEPT", Meeting([patch], (0, *HALF), (0, Q(1, 2), Q(1, 3))))
            self.says("ACCEPT", Meeting([patch], (0, *HALF), (0, Q(1, 2), 1)))

    def test_patches_that_share_a_point_may_meet_elsewhere(self):
        """Two neighbours of a cube, one of which has been pushed through the other; they still share an edge."""
        left = star_forge.surface([[(0, 0, 0), (0, 2, 0)], [(2, 0, 0), (2, 2, 0)]])
        right = star_forge.surface([[(x, y, z) for y in (0, 2)] for x, z in ((0, 0), (1, Q(1, 4)), (2, -Q(3, 4)))])
        u = Q(2, 5)                                       # z = u (1 - u) / 2 - 3 u^2 / 4 = 0
        self.assertEqual(forge.point(right, u, Q(1, 2)), (2 * u, 1, 0))
        self.says("ACCEPT", Meeting([left, right], (0, u, Q(1, 2)), (1, u, Q(1, 2))))
        self.says("ACCEPT", Meeting([left, right], (1, u, Q(1, 8)), (0, u, Q(1, 8))))

    def test_b_may_lie_on_a_border_or_a_corner_and_a_may_not(self):
        plate, at = meeting.plate(), (Q(1, 3), Q(2, 5))
        corner, q = forge.point(plate, *at), Q(1, 2)
        spike, triangle = meeting.spike(corner), star_forge.triangle
        for patch, b in ((meeting.wheel(), (at[0], 0)), (spike, (0, 0)), (meeting.turned(spike, 0, 1, 1), (1, 1)),
                         (triangle([(5, 5, 5), corner, (1, 1, 9)]), (1, 0)),
                         (triangle([(5, 5, 5), (1, 1, 9), corner]), (1, 1)),
                         (triangle([(5, 5, 5), [2 * c for c in corner], (0, 0, 0)]), (1, q))):
            self.says("ACCEPT", Meeting([plate, patch], (0, *at), (1, *b)))
            self.alone("M1", Meeting([plate, patch], (1, *b), (0, *at)))

    def test_equal_points_with_other_weights_agree(self):
        plain = meeting.lopsided()
        rows = [[tuple(7 * c for c in p) + (7,) for p in row] for row in forge.rows_of(plain)]
        heavy = star_forge.surface(rows, rational=True)
        self.says("ACCEPT", Meeting([plain, heavy], (0, *THIRD), (1, *THIRD)))
        rational = models.torus()[0]
        x, y, z = forge.point(rational, *THIRD)
        sheet = broken.sheet((x, y, z), (0, 3, 0), (0, 0, 3))
        self.says("ACCEPT", Meeting([rational, sheet], (0, *THIRD), (1, 0, 0)))
        flat = star_forge.triangle([(x, y, z + 1), (x, y, z - 1), (x, y + 1, z)])
        self.says("ACCEPT", Meeting([rational, flat], (0, *THIRD), (1, Q(1, 2), 0)))
        self.says("M2", Meeting([rational, flat], (0, *THIRD), (1, *HALF)))

    def test_inner_breaks_number_the_patches_v_fastest(self):
        sheet = broken.sheet((0, 0, 0), (3, 0, 0), (0, 2, 0), (3, 2))
        across = broken.sheet((Q(3, 2), Q(1, 2), -1), (0, 1, 0), (0, 0, 4), (2, 2))
        # (3/2, 3/4, 0): patch 2 of 0..5 at (1/2, 3/4), and patch 6 of 6..9 at (1/2, 1/2)
        good = Meeting([sheet, across], (2, Q(1, 2), Q(3, 4)), (6, Q(1, 2), Q(1, 2)))
        self.says("ACCEPT", good)
        for n in (0, 1, 3, 4, 5):
            self.says("M2", self.changed(good, a=(n, *good.a[1:])))
        for n in (7, 8, 9):
            self.says("M2", self.changed(good, b=(n, *good.b[1:])))
        finer = self.changed(good, breaks=[[[Q(0), Q(1), Q(4, 3), Q(2), Q(3)], [Q(0), Q(1), Q(2)]], good.breaks[1]],
                             a=(4, Q(1, 4), Q(3, 4)), b=(8, *HALF))
        self.says("ACCEPT", finer)                        # u = 3/2 is a quarter of [4/3, 2]
        breaks = [[[Q(0), Q(1), Q(3, 2), Q(2), Q(3)], good.breaks[0][1]], good.breaks[1]]
        on_a_break = self.changed(finer, breaks=breaks, a=finer.b, b=(4, 0, Q(3, 4)))
        self.says("ACCEPT", on_a_break)
        self.alone("M1", self.changed(on_a_break, a=on_a_break.b, b=on_a_break.a))

    def test_one_number_of_the_places_differs(self):
        """M1 asks for one difference of three; here each is the only one."""
        point = meeting.one_point()
        self.says("ACCEPT", Meeting([point, point], (0, *HALF), (1, *HALF)))
        self.says("ACCEPT", Meeting([point], (0, *HALF), (0, Q(1, 3), Q(1, 2))))
        self.says("ACCEPT", Meeting([point], (0, *HALF), (0, Q(1, 2), Q(1, 3))))

    def test_numbers_need_not_be_in_lowest_terms_and_may_be_long(self):
        twice = face_twice()
        self.says("ACCEPT", self.changed(twice, a=(0, (2, 6), (6, 8)), b=(6, (5, 15), (3 << 60, 1 << 62))))
        most = (1 << 63) - 1
        for t in (Q(1, most), Q(most - 1, most), Q(1 << 62, most)):
            self.says("ACCEPT", self.changed(twice, a=(0, t, Q(1, 2)), b=(6, t, Q(1, 2))))
            near = t.numerator - (t.numerator > 1), most - 1
            self.says("M2", self.changed(twice, a=(0, t, Q(1, 2)), b=(6, near, Q(1, 2))))

    def test_flags_do_not_change_parameters(self):
        for flags in ([1] * 7, [0] * 6 + [1], [1, 0, 1, 0, 1, 0, 1]):
            finding = face_twice()
            finding.flags = flags
            self.says("ACCEPT", finding)

    def test_a_model_in_itd(self):
        finding = face_twice()
        model = ("[OBJECT [a 1] N\n" + itd.itd_text(finding.entities) + "]\n").encode()
        self.says("M2", self.changed(finding, values={"subject_format": "itd"}, a=(0, *HALF)), model=model)
        self.says("ACCEPT", self.changed(finding, values={"subject_format": "itd"}), model=model)

    def test_degree_15_is_the_highest(self):
        for degree, says in ((15, "ACCEPT"), (16, "B2")):
            high = star_forge.surface([[(i, j, i * j) for j in range(2)] for i in range(degree + 1)])
            self.says(says, Meeting([high, high], (0, *THIRD), (1, *THIRD)))
            high = meeting.lopsided_triangle(degree)
            self.says(says, Meeting([high, high], (0, *THIRD), (1, *THIRD)))

    # PROVES INVALID-3
    def test_closed_shells_that_touch_in_a_point(self):
        """By whichever places the point is named on the two shells."""
        for name, one, other, at in meeting.touching():
            with self.subTest(name):
                finding, mine, yours = meeting.touch(one, other, at)
                self.assertGreater(len(mine), 0)
                pairs = [(a, b) for a in mine for b in yours]
                for a, b in pairs[::max(1, len(pairs) // 20) if SCALE == 1 else 1]:
                    self.says("ACCEPT", self.changed(finding, a=a, b=b))
                    self.says("ACCEPT", self.changed(finding, a=b, b=a))

    def test_touching_shells_whatever_their_breaks_flags_and_order(self):
        for name, one, other, at in meeting.touching():
            with self.subTest(name):
                finding, _, _ = meeting.touch(one, other, at)
                n, m = len(one), len(other)
                for flags in ([1] * (n + m), [1] * n + [0] * m, [0] * n + [1] * m):
                    self.says("ACCEPT", self.changed(finding, flags=flags))
                turned = [meeting.other_way(e) for e in one]
                one_turned = turned[:1] + one[1:]
                for entities, flags in ((turned, [0] * n), (turned, [1] * n), (one_turned, [1] + [0] * (n - 1))):
                    again, _, _ = meeting.touch(entities, other, at)
                    self.says("ACCEPT", self.changed(again, flags=flags + [0] * m))
                backward, _, _ = meeting.touch(other, one, at)
                self.says("ACCEPT", backward)
                if not any(e["kind"] == "triangle" for e in one + other):
                    finding.breaks = [[[Q(0), Q(1, 2), Q(1)]] * 2] * (n + m)
                    named = forge.places_at(finding, at, (0, Q(1, 3), Q(1, 2), Q(2, 3), 1))
                    mine, yours = [[p for p in named if (p[0] < 4 * n) == is_mine] for is_mine in (True, False)]
                    self.says("ACCEPT", self.changed(finding, a=yours[0], b=mine[0]))

    def test_one_shell_that_is_pinched(self):
        """Its ends have different vertices in one point; two places of one of the ends are one vertex."""
        entities = meeting.pinched_ring()
        finding = Meeting(entities, (0, 0, 0), (0, 0, 0))
        places = forge.places_at(finding, (1, 1, 1), (0, 1))
        ends = {p: max(max(map(Q, c)) for c in entities[p[0]]["shape"]["points"]) > 1 for p in places}
        self.assertEqual(sorted(set(ends.values())), [False, True])
        for n, a in enumerate(places):
            for b in places[n % 3::1 if SCALE > 1 else 3]:
                lie = self.changed(finding, a=a, b=b)
                if ends[a] == ends[b]:
                    self.alone("M1", lie)
                else:
                    self.says("ACCEPT", lie)

    def test_a_line_inside_a_surface_that_is_a_point(self):
        """A knot there is a break, so that P1 does not hold; cut there, it would be a vertex on each of its sides."""
        finding = Meeting([meeting.tips()], (1, Q(1, 3), 1), (2, Q(1, 3), 0))
        self.alone("M1", finding)
        self.alone("M1", self.changed(finding, a=(13, 0, 1), b=(6, 1, 0)))
        self.alone("M1", self.changed(finding, flags=[1]))
        for a, b in (((1, Q(1, 3), 1), (13, Q(1, 3), 1)), ((2, 0, 0), (6, 1, 0)), ((0, 0, 0), (8, Q(1, 2), 0)),
                     ((3, 0, 1), (3, 1, 1))):
            self.alone("M1", self.changed(finding, a=a, b=b))
        two = [meeting.revolved(profile) for profile in (meeting.TIPS[:3], meeting.TIPS[2:])]
        finding = Meeting(two, (1, Q(1, 3), 1), (8, Q(1, 3), 0))
        self.says("ACCEPT", finding)                      # as two surfaces, with outer sides that are points
        self.says("ACCEPT", self.changed(finding, a=(7, 0, 1), b=(12, 1, 0)))
        self.alone("M1", self.changed(finding, a=(7, 0, 1), b=(1, Q(1, 3), 1)))

    def test_a_line_inside_a_bezier_patch_that_is_a_point(self):
        """Uncut it is a segment of X, by reason (a) between its ends and by (b) to its ends; no cut there is one of P1's."""
        entities, cut = star.cusp()
        finding = Meeting(entities, (0, Q(1, 2), 0), (0, Q(1, 2), 1))
        self.says("ACCEPT", finding)
        self.says("ACCEPT", self.changed(finding, a=(0, Q(1, 2), Q(1, 3)), b=(0, Q(1, 2), Q(2, 3))))
        places = forge.places_at(self.changed(finding, breaks=cut), (0, 0, 1), (0, Q(1, 3), 1))
        self.assertEqual(len(places), 4 * 3 + 4)          # patches 0 to 3 are the sheet's, 4 to 7 are its neighbours'
        for a in places:
            for b in places[::3]:
                self.alone("M1", self.changed(finding, breaks=cut, a=a, b=b))

    def test_a_patch_that_is_a_point_has_a_vertex_and_a_domain(self):
        triangles = [star_forge.triangle([(1, 2, 3)] * 3), star_forge.triangle([(1, 2, 3)] * 10, 3)]
        for patch in (meeting.one_point(), *triangles):
            for border in ((0, 0), (0, Q(1, 2)), (1, Q(1, 2)), (Q(1, 2), 1)):
                self.says("ACCEPT", Meeting([patch], (0, *border), (0, *HALF)))
                self.says("ACCEPT", Meeting([patch], (0, *HALF), (0, *border)))
                self.says("ACCEPT", Meeting([patch, patch], (0, *border), (1, *border)))
                self.alone("M1", Meeting([patch], (0, *border), (0, 1, 1)))

    def test_places_on_borders_in_other_terms(self):
        finding, _, _ = meeting.touch(models.cube(), meeting.crosswise((1, 1, Q(1, 2))), (1, 1, Q(1, 2)))
        n, *at = finding.a
        for times in (2, 3, 1 << 50):
            at = [(Q(t).numerator * times, Q(t).denominator * times) for t in finding.a[1:]]
            self.says("ACCEPT", self.changed(finding, a=(n, *at)))


class Lies(first.PatchInvalidTest):
    """For every condition a lie that this condition rejects; alone unless the test says why that is impossible."""

    def test_s1_s3_and_s4(self):
        finding = face_twice()
        cert, model = finding.certificate(), star_forge.encode_model(finding.entities)
        self.assertEqual(vc.check(model, cert), (0, "ACCEPT patch-invalid-2"))
        for old, new, expected in ((b'"meeting"', b'"crossing"', "S1"), (b'"meeting"', b'"side"', "S1"),
                                   (b'"meeting"', b'"meetings"', "S1"), (b'"meeting"', b'""', "S1"),
                                   (b'"meeting"', b"0", "S1"), (b',"finding":"meeting"', b"", "S1"),
                                   (b',"finding"', b',"same":0,"opposite":0,"finding"', "S1"),
                                   (b'"patches":7', b'"patches":"7"', "S1"), (b'"flipped":0,', b"", "S1"),
                                   (b'"patch-invalid-2"', b'"patch-invalid-1"', "S1"),
                                   (b'"patch-invalid-2"', b'"patch-invalid-3"', "S1"), (b'"vjson"', b'"stl"', "S1"),
                                   (b'"subject_bytes":', b'"subject_bytes":1', "S3"), (b"VTI2", b"VTPI", "S4")):
            self.assertIn(old, cert)
            self.assertTrue(vc.check(model, cert.replace(old, new, 1))[1].startswith("REJECT %s:" % expected), new)

    def test_b1_a_field_that_the_page_forbids(self):
        good = face_twice()
        (_, *a), (_, *b), cube = good.a, good.b, good.entities
        curve = {"kind": "curve", "group": None, "attributes": [], "shape": {}}
        triangle = models.tetrahedron()[0]
        bad = [self.changed(good, tail=b"\0"), self.changed(good, magic=b"VTPI"), self.changed(good, magic=b"VTS2"),
               self.changed(good, flags=[2] + [0] * 6), self.changed(good, flags=[0] * 6 + [255]),
               self.changed(good, a=(7, *a)), self.changed(good, b=(7, *b)), self.changed(good, b=((1 << 63) - 1, *b)),
               self.changed(good, a=((1 << 63), *a)), self.changed(good, breaks=[[[0, 1], [0, 2]]] + good.breaks[1:]),
               self.changed(good, breaks=[[[0, Q(1, 2), Q(1, 2), 1], [0, 1]]] + good.breaks[1:]),
               self.changed(good, breaks=[[[0], [0, 1]]] + good.breaks[1:]), self.changed(good, breaks=good.breaks[1:])]
        top = 1 << 63
        for n, d in ((0, 0), (1, 0), (2, 1), (4, 3), (top - 1, top - 2), (1, top), (top, top), (1 << 70, 1 << 70)):
            bad += [self.changed(good, a=(0, (n, d), a[1])), self.changed(good, a=(0, a[0], (n, d))),
                    self.changed(good, b=(6, (n, d), b[1])), self.changed(good, b=(6, b[0], (n, d)))]
        for finding in bad:
            self.says("B1", finding)
        for n in (0, 1, 6, 8, 1 << 31, (1 << 32) - 1):    # N, with kinds and flags for seven entities
            lie = self.changed(good)
            body = lie.body()
            lie.body = lambda n=n, body=body: body[:4] + star_forge.u32(n) + body[8:]
            self.says("B1", lie)
        fewer = Meeting(cube[:6], good.a, good.b)
        fewer.values = {"patches": 7}
        self.says("B1", fewer, model=star_forge.encode_model(cube))
        for entity, wrong in ((cube[0], (0, 2, 3, 255)), (triangle, (0, 1, 3, 255)), (curve, (1, 2, 3))):
            for kind in wrong:
                lie = Meeting(cube + [entity], good.a, good.b)
                lie.kinds[7] = kind
                self.says("B1", lie)
        self.says("B1", Meeting([], (0, *HALF), (0, *THIRD)))

    def test_b1_a_varint_that_is_longer_than_needed(self):
        good = face_twice()
        body = good.body()
        self.assertEqual(body[-5:], b"\6\1\3\3\4")
        for tail in (b"\x86\0\1\3\3\4", b"\6\x81\0\3\3\4", b"\6\1\x83\0\3\4", b"\6\1\3\3\x84\0", b"\6\1\3\3\x84\x80\0"):
            lie = self.changed(good)
            lie.body = lambda tail=tail: body[:-5] + tail
            self.says("B1", lie)

    def test_b1_a_body_that_ends_too_early(self):
        triangles = Meeting(broken.pierced(), (0, Q(1, 2), Q(5, 12)), (1, 1, Q(2, 3)))
        for finding in (face_twice(), triangles, Meeting([meeting.zigzag()], (2, *HALF), (0, *HALF))):
            self.says("ACCEPT", finding)
            body = finding.body()
            for n in range(len(body)):
                lie = self.changed(finding)
                lie.body = lambda n=n, body=body: body[:n]
                self.says("B1", lie)

    def test_b1_a_patch_of_an_entity_that_has_none(self):
        """An entity of another kind has no patches, so that the numbers of later ones do not move; B2 rejects it."""
        curve = {"kind": "curve", "group": None, "attributes": [], "shape": {}}
        point = meeting.one_point()
        for entities in ([curve, point], [point, curve]):
            finding = Meeting(entities, (0, *HALF), (0, *THIRD))
            self.says("B2", finding)
            self.says("B1", self.changed(finding, b=(1, *THIRD)))

    def test_b2_an_entity_that_no_patch_comes_from(self):
        flat = star_forge.surface([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
        wide = star_forge.surface([[(0, 0, 0, 0), (0, 1, 0, 0)], [(1, 0, 0, 0), (1, 1, 0, 0)]])
        high = star_forge.surface([[(i, j, 0) for j in range(2)] for i in range(17)])
        good = face_twice()
        for entity in (flat, wide, high, star_forge.triangle([(0, 0), (1, 0), (0, 1)]), meeting.lopsided_triangle(16)):
            self.says("B2", Meeting(good.entities + [entity], good.a, good.b))
            self.says("B2", Meeting([entity] + good.entities, (1, *THIRD), (7, *THIRD)))
            self.says("B2", Meeting([entity, entity], (0, *THIRD), (1, *THIRD)))

    def test_b2_long_numbers_matter_in_the_patches_of_a_and_b_only(self):
        long = star_forge.surface([[(0, 0, Q(1, 3 ** 5200)), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
        good = face_twice()
        self.says("ACCEPT", Meeting(good.entities + [long], good.a, good.b))
        self.says("B2", Meeting(good.entities + [long], (7, *THIRD), good.b))
        self.says("B2", Meeting(good.entities + [long], good.a, (7, *THIRD)))
        near = [Q(0), Q(1, 3 ** 1200), Q(1, 2 ** 1000), Q(1, 2), Q(1)]     # the second interval is long as a fraction
        cut = self.changed(good, breaks=[[near, [Q(0), Q(1)]]] + good.breaks[1:], b=(9, Q(3, 4), Q(1, 2)))
        for n, says in enumerate(("M2", "B2", "M2", "ACCEPT")):
            self.says(says, self.changed(cut, a=(n, *HALF)))
        self.says("B2", self.changed(cut, b=(1, *HALF)))

    def test_b2_a_surface_that_is_torn_at_a_knot(self):
        """Two unit squares in one place, as one entity: an inner knot of multiplicity 2, degree 1."""
        rows = [[(x, y, 0) for y in (0, 1)] for x in (0, 1, 0, 1)]
        torn = star_forge.surface(rows, (1, 1), [[0, 0, 1, 1, 2, 2], [0, 0, 1, 1]])
        self.alone("B2", Meeting([torn], (0, *THIRD), (1, *THIRD)))
        good = face_twice()
        self.alone("B2", Meeting(good.entities + [torn], good.a, good.b))
        kept = star_forge.surface([rows[0], rows[1], rows[0]], (1, 1), [[0, 0, 1, 2, 2], [0, 0, 1, 1]])
        self.says("ACCEPT", Meeting([kept], (0, *THIRD), (1, Q(2, 3), Q(3, 4))))     # folded, but in one piece

    def test_b2_a_knot_at_an_end_of_the_domain_is_no_inner_one(self):
        """Its multiplicity may exceed the degree, as in surfaces whose last control points lie beyond the domain."""
        rows = [[(x, y, 0) for y in (0, 1)] for x in (0, 1, 7)]
        plain = broken.sheet((0, 0, 0), (1, 0, 0), (0, 1, 0))
        ends = star_forge.surface(rows, (1, 1), [[0, 0, 1, 1, 2], [0, 0, 1, 1]])
        starts = star_forge.surface(rows[::-1], (1, 1), [[-1, 0, 0, 1, 1], [0, 0, 1, 1]])
        self.says("ACCEPT", Meeting([plain, ends], (0, *THIRD), (1, *THIRD)))
        self.says("ACCEPT", Meeting([plain, starts], (0, *THIRD), (1, 1 - THIRD[0], THIRD[1])))

    def test_b3(self):
        for key, values in (("patches", (0, 6, 8, (1 << 64) - 1)), ("flipped", (1, 7))):
            for value in values:
                self.alone("B3", self.changed(face_twice(), values={key: value}))
        flagged = self.changed(face_twice(), flags=[0] * 6 + [1])
        self.says("ACCEPT", flagged)
        self.alone("B3", self.changed(flagged, values={"flipped": 0}))
        cut = Meeting([meeting.zigzag()], (2, *HALF), (0, *HALF), [1])
        self.says("ACCEPT", cut)                          # one flag, three patches
        self.alone("B3", self.changed(cut, values={"flipped": 3}))
        self.alone("B3", self.changed(cut, values={"patches": 1}))

    # PROVES INVALID-3.M1
    def test_m1_a_on_the_borders_of_sound_models(self):
        """The two sides of an edge, a corner of several patches, a pole: one point of X, however it is named."""
        along = (0, Q(1, 3), Q(2, 3), 1)
        borders = sorted({(end, t) for end in (0, 1) for t in along} | {(t, end) for end in (0, 1) for t in along})
        for build, pairs in ((models.cube, 40), (models.octant_sphere, 66), (models.torus, 112),
                             (models.tetrahedron, 16)):
            entities = build()
            named, found = {}, 0
            for n, entity in enumerate(entities):
                for u, v in borders:
                    if entity["kind"] == "surface" or u > 0:
                        named.setdefault(forge.point(entity, u, v), []).append((n, u, v))
            for places in named.values():
                for a, b in zip(places, places[1:]):
                    self.alone("M1", Meeting(entities, a, b))
                    found += 1
            self.assertEqual(found, pairs)

    def test_m1_only_one_number_of_a_is_0_or_1(self):
        good = face_twice()
        for u, v in ((0, Q(1, 3)), (1, Q(1, 3)), (Q(1, 3), 0), (Q(1, 3), 1), (0, 0), (1, 1)):
            self.alone("M1", self.changed(good, a=(0, u, v), b=(6, u, v)))
        self.alone("M1", self.changed(good, a=(0, (0, 5), (1, 3)), b=(6, 0, (1, 3))))
        self.alone("M1", self.changed(good, a=(0, (5, 5), (1, 3)), b=(6, 1, (1, 3))))

    # PROVES INVALID-3.M1
    def test_m1_the_first_corner_of_a_triangle(self):
        """It is one point, whatever t is. (The claim is true here all the same: A is in the open domain, B is not.)"""
        plate, at = meeting.plate(), (Q(1, 3), Q(2, 5))
        corner = forge.point(plate, *at)
        for triangle in (star_forge.triangle([corner, (5, 5, 5), (1, 1, 9)]),
                         star_forge.triangle([corner + (1,), (5, 5, 5, 2), (1, 1, 9, 1)], 1, True)):
            for t in (0, Q(1, 2), 1):
                self.alone("M1", Meeting([plate, triangle], (0, *at), (1, 0, t)))
            self.alone("M1", Meeting([plate, triangle], (0, *at), (1, (0, 3), (1, 2))))
            self.alone("M1", Meeting([triangle], (0, 0, Q(1, 2)), (0, 0, Q(1, 3))))              # nor is A here
        self.says("ACCEPT", Meeting([plate, meeting.spike(corner)], (0, *at), (1, 0, 0)))        # B on a surface

    # PROVES INVALID-3.M1
    def test_m1_one_place_that_is_written_in_two_ways(self):
        for entities in (models.cube(), models.tetrahedron(), models.torus(), models.cubic_octahedron()):
            for a, b in (((0, *HALF), (0, *HALF)), ((0, *HALF), (0, (2, 4), (3, 6))),
                         ((0, (1, 3), (2, 3)), (0, (5, 15), (4 << 58, 6 << 58))), ((0, *CENTROID), (0, *CENTROID))):
                self.alone("M1", Meeting(entities, a, b))

    # PROVES INVALID-3.M2
    def test_m2_points_that_agree_in_two_coordinates_of_three(self):
        patch = meeting.lopsided()
        for axis in range(3):
            for gap in (Q(1), Q(1, 1 << 52), Q(1, 10 ** 300), -Q(1, 7)):
                moved = [[tuple(c + gap * (k == axis) for k, c in enumerate(p)) for p in row]
                         for row in forge.rows_of(patch)]
                heavy = [[tuple(3 * c for c in p) + (3,) for p in row] for row in moved]
                for rows in (moved, heavy):
                    other = star_forge.surface(rows, rational=rows is heavy)
                    self.alone("M2", Meeting([patch, other], (0, *THIRD), (1, *THIRD)))

    # PROVES INVALID-3.M1
    def test_m1_one_point_of_a_shell_that_touches_another(self):
        """P1 holds, and there are two points of X with one image: but not these."""
        for name, one, other, at in meeting.touching():
            finding, mine, yours = meeting.touch(one, other, at)
            for places in (mine, yours):
                for a, b in list(zip(places, places[1:])) + [(places[0], places[0])]:
                    with self.subTest(name, a=a, b=b):
                        self.alone("M1", self.changed(finding, a=a, b=b))

    def test_m1_the_same_place_on_a_border_twice(self):
        for entities in (models.cube(), models.tetrahedron(), models.octant_sphere()):
            for at in ((0, 0), (1, 1), (1, Q(1, 3)), (Q(2, 5), 0), (0, Q(1, 2)), (Q(2, 5), 1)):
                self.alone("M1", Meeting(entities, (1, *at), (1, *at)))
        self.alone("M1", Meeting(models.cube(), (1, (2, 4), (0, 3)), (1, (3, 6), (0, 7))))

    def test_m1_the_two_sides_of_an_edge(self):
        """At t of the one and 1 - t of the other: one image, and one point. At t of both: two points, two images."""
        entities = models.cube() + models.cube(1, (2, 2, 2))
        finding, t = Meeting(entities, (0, 0, 0), (0, 0, 0)), Q(1, 5)
        near = forge.places_at(finding, (1, 1, 2 * t - 1), (0, t, 1 - t, 1))
        far = forge.places_at(finding, (1, 1, 1 - 2 * t), (0, t, 1 - t, 1))
        self.assertEqual((len(near), len(far)), (2, 2))
        for a, b in (near, near[::-1], far, far[::-1]):
            self.alone("M1", self.changed(finding, a=a, b=b))
        for a in near:
            for b in far:
                self.alone("M2", self.changed(finding, a=a, b=b))

    def test_m1_two_names_of_a_pole_or_of_a_first_corner(self):
        sphere = models.octant_sphere()
        finding = Meeting(sphere, (0, 0, 0), (0, 0, 0))
        for pole in ((0, 0, 1), (0, 0, -1)):
            named = forge.places_at(finding, pole)
            self.assertEqual(len(named), 28)
            for a, b in list(zip(named, named[1:] + named[:1])) + list(zip(named, named[9:])):
                self.alone("M1", self.changed(finding, a=a, b=b))
        for entities in (models.tetrahedron(), models.cubic_octahedron()):
            corner = forge.point(entities[0], 0, 0)
            for a in [(0, 0, t) for t in (0, Q(1, 3), Q(1, 2), 1)]:
                for b in forge.places_at(Meeting(entities, a, a), corner, (0, Q(1, 2), 1)):
                    self.alone("M1", Meeting(entities, a, b))

    def test_m1_shells_that_are_not_closed(self):
        """One patch is missing, or comes twice, or has come loose: P1 does not hold, wherever that is."""
        loose = broken.sheet((9, 9, 9), (1, 0, 0), (0, 1, 0))
        for name, one, other, at in list(meeting.touching())[::3]:
            with self.subTest(name):
                whole, _, _ = meeting.touch(one, other, at)
                for k in range(0, len(one + other), 5):
                    entities = one + other
                    self.alone("M1", Meeting(entities + entities[k:k + 1], whole.a, whole.b))
                    if k not in (whole.a[0], whole.b[0]):
                        a, b = [(n - (n > k), u, v) for n, u, v in (whole.a, whole.b)]
                        self.alone("M1", Meeting(entities[:k] + entities[k + 1:], a, b))
                self.alone("M1", Meeting(one + other + [loose], whole.a, whole.b))

    def test_m1_a_side_that_is_its_own_opposite(self):
        """A sheet, folded: v = 0 goes there and back. Its other sides are collapsed, or a pair."""
        there = star_forge.surface([[(0, 0, 0)] * 3, [(3, 0, 0)] * 2 + [(3, 1, 0)], [(0, 0, 0)] * 3])
        self.alone("M1", Meeting([there], (0, 0, 0), (0, 0, 1)))
        self.alone("M1", Meeting([there], (0, Q(1, 3), 0), (0, Q(2, 3), 0)))

    def test_m1_a_break_that_the_neighbour_lacks(self):
        """A point of the common curve, which is a vertex by the one and inside a side by the other: one point."""
        whole, half, sound = [Q(0), Q(1)], [Q(0), Q(1, 2), Q(1)], models.cube()
        for axes in ([half, whole], [whole, half], [half, half]):
            finding = Meeting(sound, (0, 0, 0), (0, 0, 0))
            finding.breaks = [axes] + finding.breaks[1:]
            found = 0
            for axis in range(3):
                for ends in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
                    at = [*ends[:axis], 0, *ends[axis:]]
                    places = forge.places_at(finding, at, (0, Q(1, 2), 1))
                    for a, b in zip(places, places[1:]):
                        self.alone("M1", self.changed(finding, a=a, b=b))
                        found += a[0] < 6 <= b[0] + 4 * (len(axes[0]) - 1) * (len(axes[1]) - 1)
            self.assertGreater(found, 2)
        touching, _, _ = meeting.touch(sound, models.cube(1, (2, 2, 2)), (1, 1, 1))
        for k in (1, 5, 7):                               # the claim is true here, but P1 does not hold at these breaks
            breaks = touching.breaks[:k] + [[half, whole]] + touching.breaks[k + 1:]
            lie = self.changed(touching, breaks=breaks)
            mine, yours = [[p for p in forge.places_at(lie, (1, 1, 1), (0, 1)) if (p[0] < 6 + (k < 6)) == is_mine]
                           for is_mine in (True, False)]
            self.alone("M1", self.changed(lie, a=mine[0], b=yours[0]))

    def test_m1_flags_by_which_sides_run_the_same_way(self):
        for name, one, other, at in list(meeting.touching())[1::3]:
            with self.subTest(name):
                finding, _, _ = meeting.touch(one, other, at)
                for k in range(0, len(one + other), 3):
                    flags = [int(n == k) for n in range(len(one + other))]
                    self.alone("M1", self.changed(finding, flags=flags))
                    self.alone("M1", self.changed(finding, flags=[1 - f for f in flags]))
                turned = [meeting.other_way(e) if n == 1 else e for n, e in enumerate(one)]
                again, _, _ = meeting.touch(turned, other, at)
                self.alone("M1", again)                   # the model is wrong, and so are all flags but these
                again.flags[1] = 1
                self.says("ACCEPT", again)

    def test_b2_long_numbers_matter_in_all_patches_for_reason_b_only(self):
        long = star_forge.surface([[(0, 0, Q(1, 3 ** 5200)), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
        on_face = (1, Q(1, 3), Q(1, 2))
        finding, _, _ = meeting.touch(models.cube(), meeting.leaning(on_face), on_face)
        for entities, shift in ((finding.entities + [long], 0), ([long] + finding.entities, 1)):
            a, b = [(n + shift, u, v) for n, u, v in (finding.a, finding.b)]
            self.says("B2", Meeting(entities, a, b))
            self.says("ACCEPT", Meeting(entities, a, b), {"M1"})
            self.says("ACCEPT", Meeting(entities, b, a))  # by reason (a): A is inside the face

    # PROVES INVALID-3.M2
    def test_m2_different_points_of_closed_shells(self):
        for name, one, other, at in list(meeting.touching())[::2]:
            finding, mine, yours = meeting.touch(one, other, at)
            away = [place for place, p in forge.places(finding, (0, Q(1, 7), 1)) if p != at]
            for b in away[::7]:
                with self.subTest(name, b=b):
                    if b[0] >= len(one):
                        self.alone("M2", self.changed(finding, a=mine[0], b=b))
                    self.alone("M2", self.changed(finding, a=yours[0], b=b))

    def test_m2_is_about_points_and_not_about_homogeneous_ones(self):
        """(P, w) and (P, z) with other weights: equal numbers, other points, unless P = 0."""
        light = star_forge.surface([[(i, j, 1, 1) for j in range(2)] for i in range(2)], rational=True)
        heavy = star_forge.surface([[(i, j, 1, 2) for j in range(2)] for i in range(2)], rational=True)
        self.alone("M2", Meeting([light, heavy], (0, *HALF), (1, *HALF)))
        origin = [star_forge.surface([[(i, j, 0, w) for j in (-1, 1)] for i in (-1, 1)], rational=True) for w in (1, 2)]
        self.says("ACCEPT", Meeting(origin, (0, *HALF), (1, *HALF)))

    def test_m2_parameters_that_are_slightly_off(self):
        for name, finding in meeting.honest():
            if name in ("a point", "a rational point"):
                continue                                  # wherever the places are, the points are the same
            n, u, v = finding.a
            for off in (Q(1, 1 << 20), -Q(1, 1 << 40)):
                if name != "a pinched line" and name != "a curve":
                    self.alone("M2", self.changed(finding, a=(n, u, v + off)))
                self.alone("M2", self.changed(finding, a=(n, u + off, v)))

    def test_m2_the_patches_next_to_the_right_ones(self):
        finding = face_twice()
        for n in range(1, 6):
            self.alone("M2", self.changed(finding, a=(n, *THIRD)))
            self.alone("M2", self.changed(finding, b=(n, *THIRD)))

    def test_a_body_of_version_1_is_none_of_this_version(self):
        old = first.crossing_of_cubes(fixed=1)
        new = Meeting(old.entities, (0, *HALF), (9, *HALF))
        self.says("B1", self.changed(new, magic=b"VTPI"))
        lie = self.changed(new)
        lie.body = old.body
        self.says("B1", lie)
        lie = self.changed(new)
        lie.body = lambda: b"VTI2" + old.body()[4:]
        self.says("B1", lie)
        back = first.forge.Finding(old.entities)
        back.body = new.body
        self.says("B1", back)


class SoundModels(first.PatchInvalidTest):
    """No two places make a sound model invalid."""

    SOUND = (models.cube, models.torus, models.octant_sphere, models.tetrahedron, models.cubic_octahedron,
             models.bicubic_ball)

    def test_random_places_that_are_the_same_or_near(self):
        rng, tiny = random.Random(52), Q(1, 1 << 40)
        choices = (0, 1, Q(1, 2), Q(1, 3), Q(2, 3), tiny, 1 - tiny, (0, 7), (7, 7), (2, 4))
        for build in self.SOUND:
            entities = build()
            for trial in range(150 * SCALE):
                n = len(entities)
                a, b = rng.choice(((0, 0), (0, 1), (rng.randrange(n), rng.randrange(n))))
                u, v, s, t = [rng.choice(choices) for _ in range(4)]
                if rng.random() < .5:
                    s, t = rng.choice(((u, v), (v, u)))
                finding = Meeting(entities, (a, u, v), (b, s, t))
                code, line = vc._check(star_forge.encode_model(entities), finding.certificate(), frozenset())
                self.assertEqual((code, line[:8]), (1, "REJECT M"), (build.__name__, trial, finding.a, finding.b, line))

    def cut_and_turned(self, rng, entities):
        """Some entities turned, and those reversed; all cut at the same breaks, which are symmetric. (Places, by
        their points; the Meeting.)"""
        flags = [rng.randrange(2) for _ in entities]
        whole, cut = [Q(0), Q(1)], rng.choice(([], [Q(1, 2)], [Q(1, 3), Q(2, 3)]))
        turned = [meeting.other_way(e) if flag else e for e, flag in zip(entities, flags)]
        finding = Meeting(turned, (0, 0, 0), (0, 0, 0))
        finding.flags = flags if rng.random() < .5 else [1 - flag for flag in flags]
        finding.breaks = [[[whole[0], *cut, whole[1]]] * 2 if b else b for b in finding.breaks]
        named = {}
        for place, p in forge.places(finding, (0, Q(1, 5), Q(1, 2), Q(4, 5), 1)):
            named.setdefault(p, []).append(place)
        return named, finding

    # PROVES INVALID-3.M1
    def test_places_on_the_borders_of_sound_models(self):
        """What denotes one point of X is never taken for two; what denotes two is taken for two, so that M2 decides."""
        rng = random.Random(59)
        for build in (*self.SOUND, models.snake):
            for trial in range(2 * SCALE):
                named, finding = self.cut_and_turned(rng, build())
                several = [p for p, places in named.items() if len(places) > 1]
                for _ in range(8):
                    p, q = rng.choice(several), rng.choice(list(named))
                    for times in (1, 3):
                        (n, *a), b = rng.choice(named[p]), rng.choice(named[p])
                        a = [(Q(t).numerator * times, Q(t).denominator * times) for t in a]
                        with self.subTest(build.__name__, trial=trial, a=a, b=b):
                            self.alone("M1", self.changed(finding, a=(n, *a), b=b))
                    a, b = rng.choice(named[p]), rng.choice(named[q])
                    with self.subTest(build.__name__, trial=trial, a=a, b=b):
                        self.alone("M1" if p == q else "M2", self.changed(finding, a=a, b=b))

    def test_seams(self):
        """A surface that closes on itself: its two ends are different parameters of one point of X."""
        torus = broken.polygon_torus()
        for k in range(4):
            self.alone("M1", Meeting([torus[0]], (k, 0, Q(1, 3)), (12 + k, 1, Q(1, 3))))
            self.alone("M1", Meeting([torus[0]], (4 * k, Q(1, 3), 0), (4 * k + 3, Q(1, 3), 1)))
            self.alone("M1", Meeting([torus[0]], (k, 1, Q(1, 3)), (4 + k, 0, Q(1, 3))))       # an inner break
        self.alone("M1", Meeting(broken.drop(), (0, 0, Q(1, 2)), (0, 1, Q(1, 2))))


class Hostile(first.PatchInvalidTest):
    """Bytes by someone who wants a crash, a hang or a wrong ACCEPT."""

    def test_bytes_of_bodies_about_invalid_models(self):
        for seed, (_, finding) in enumerate(meeting.honest()):
            self.mutated(finding, 300 + seed, 60 * SCALE, True)

    def test_bytes_of_bodies_about_sound_models(self):
        for seed, finding in enumerate((Meeting(models.cube(), (0, *HALF), (2, Q(1, 2), 1)),
                                        Meeting(models.tetrahedron(), (1, *CENTROID), (2, 1, Q(1, 2))),
                                        Meeting(models.octant_sphere(), (0, *HALF), (1, *HALF)),
                                        Meeting(models.torus(), (5, *THIRD), (5, *HALF)),
                                        Meeting(models.cube(), (0, 1, Q(1, 2)), (2, Q(1, 2), 1)),
                                        Meeting(models.octant_sphere(), (0, 0, 1), (2, Q(1, 2), 1)),
                                        Meeting(models.tetrahedron(), (1, 0, 1), (2, 1, Q(1, 2))))):
            self.mutated(finding, 400 + seed, 250 * SCALE)

    def test_breaks_that_would_make_many_patches(self):
        """3,000 x 3,000 patches are spoken of, but the finding is about two of them."""
        many = [Q(i, 3000) for i in range(3001)]
        finding = face_twice()
        finding.breaks = [[many, many]] + finding.breaks[1:]
        middle = 1500 * 3000 + 1500                       # from (1/2, 1/2) on
        finding.a, finding.b = (middle, *HALF), (9000000 + 5, Q(3001, 6000), Q(3001, 6000))
        self.assertEqual(self.judged(finding, "many")[1], "ACCEPT patch-invalid-2")
        for n in (middle + 1, middle - 3000, 0, 8999999):
            self.assertEqual(self.judged(self.changed(finding, a=(n, *HALF)), n)[1].split(":")[0], "REJECT M2")
        self.says("B1", self.changed(finding, b=(9000006, *HALF)))

    def test_many_patches_are_not_cut_for_reason_b(self):
        """A patch must be worth three bytes of the model or the body, as in star-box.md."""
        many = [Q(i, 3000) for i in range(3001)]
        finding = Meeting(models.cube(), (0, 0, 0), (0, 0, 0))
        finding.breaks = [[many, many]] + finding.breaks[1:]
        for b in ((0, 0, 0), (1, 0, 0), (9000004, 0, 0)):
            self.assertEqual(self.judged(self.changed(finding, b=b), b)[1].split(":")[0], "REJECT M1")

    def test_long_numbers_in_patches_of_degree_15(self):
        most = (1 << 63) - 1
        rows = [[(Q(i, 3 ** 100), Q(j, 7 ** 50), (i * j) ** 15) for j in range(16)] for i in range(16)]
        high = star_forge.surface(rows)
        tall = star_forge.triangle([(Q(i, 3 ** 100), Q(i * i, 7 ** 50), i ** 30) for i in range(136)], 15)
        for patch in (high, tall):
            finding = Meeting([patch, patch], (0, (most - 2, most), (1, most)), (1, (most - 2, most), (1, most)))
            self.assertEqual(self.judged(finding, "degree 15")[1], "ACCEPT patch-invalid-2")
            finding.b = (1, (most - 3, most), (1, most))
            self.assertEqual(self.judged(finding, "degree 15")[1].split(":")[0], "REJECT M2")


if __name__ == "__main__":
    unittest.main()
