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
                                        Meeting(models.torus(), (5, *THIRD), (5, *HALF)))):
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
