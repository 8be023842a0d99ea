#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates of version 2: thin solids, smooth sections and blocks that are accepted, and
hostile bytes."""
import copy
import random
import unittest
from fractions import Fraction as Q

import star_box_2_forge as forge2
import star_box_2_models as models2
import star_box_forge as forge
import star_box_models as models
import star_box_test as star
from star_box_2_judged import Judged, OnAPlate, replaced, Prover2, SCALE, UNIT, vc

from veritope_checker.patches import star_box_2_sheets as sheets


class SoundModels(Judged):
    def test_plates_along_the_axes_and_turned_take_three_boxes_at_every_gap(self):
        for turned in (False, True):
            for gap in (Q(1, 16), Q(1, 1 << 18)):
                prover = models2.proved_plate(gap, turned)
                self.says("ACCEPT", prover)
                walls = next(box for box in prover.plan.boxes if len(box.centres) == 2)
                self.assertEqual((len(prover.plan.boxes), walls.frame), (3, int(turned)))
                self.assertGreater(min(h - l for l, h in zip(walls.lo, walls.hi)), UNIT // 2)

    # PROVES STAR-4
    def test_concentric_spheres_take_the_same_boxes_at_every_gap(self):
        counts = set()
        for gap in (Q(1, 1 << 12), Q(1, 1 << 20)):
            prover = models2.proved_shell(gap)
            self.says("ACCEPT", prover)
            self.assertEqual((prover.plan.values["shells"], prover.plan.values["vertices"]), (2, 12))
            counts.add(len(prover.plan.boxes))
        self.assertEqual(len(counts), 1)

    # PROVES STAR-5
    def test_a_smooth_section_of_four_sides_has_normals_zero_in_its_corners(self):
        prover = Prover2(models2.prism(models2.squircle), search=True).prove()
        self.says("ACCEPT", prover)
        corner = prover.patches[0].corner_of(prover.patches[0].make_g()[3])
        self.assertEqual(corner, [0] * 4)
        self.assertRaisesRegex(ValueError, "no box", forge.Prover(models2.prism(models2.squircle), deepest=3).prove)

    def test_a_smooth_section_of_three_sides_has_triangles_with_normals_zero_in_their_corners(self):
        prover = Prover2(models2.rounded_prism(), search=True).prove()
        self.says("ACCEPT", prover)
        self.assertEqual(prover.patches[0].corner_of(prover.patches[0].make_g()[3]), [0] * 3)
        with replaced((sheets, "sides_at", lambda patch, at: [])):
            self.assertIn("no box", self.why_not(models2.rounded_prism()))

    def why_not(self, entities):
        try:
            Prover2(entities, search=True, deepest=3).prove()
        except ValueError as e:
            return str(e)
        return ""

    def test_blocks_whose_normals_at_a_vertex_lie_in_no_half_space(self):
        prover = models2.star_and_mesh(models2.blocks()).prove()
        self.says("ACCEPT", prover)
        self.assertEqual([box.kind for box in prover.plan.boxes], [1, 0])

    def test_certificates_of_version_1_in_the_form_of_version_2(self):
        for entities in (models.cube(), models.tetrahedron(), models.bicubic_ball(), models.octant_sphere(), models.snake()):
            prover = forge.Prover(entities).prove()
            plan = forge2.to_version_2(prover.plan)
            self.says("ACCEPT", prover, plan)
            self.assertEqual(forge2.read_plan(prover.model, prover.certificate()).body(), plan.body())
            for claim, magic in (("star-box-1", b"VTS2"), ("star-box-2", b"VTSB")):
                lie = copy.copy(plan if magic == b"VTS2" else prover.plan)
                self.says("B1", prover, lie, claim=claim)

    def test_bodies_are_read_as_they_are_written(self):
        for prover in (models2.proved_plate(Q(1, 64), True), models2.proved_shell(Q(1, 1 << 12))):
            read = forge2.read_plan(prover.model, prover.certificate())
            self.assertEqual(read.body(), prover.plan.body())

    def test_turned_claims(self):
        turned = star.AnySign([models.reversed_surface(e) for e in models.cube()]).prove()
        plan = forge2.to_version_2(turned.plan)
        plan.values.update(bodies=0)
        self.says("W2", turned, plan)
        plan.values.update(winding=0)
        self.says("ACCEPT", turned, plan, claim="star-box-turned-2")
        self.says("S1", turned, plan, claim="star-box-2")
        plan.values.update(winding=2)
        self.says("W3", turned, plan, claim="star-box-turned-2")

    def test_a_flag_does_not_matter_to_a_flat_patch(self):
        entities = models2.blocks()
        entities = [models.reversed_surface(e) if i % 2 else e for i, e in enumerate(entities)]
        self.says("ACCEPT", models2.star_and_mesh(entities, flags=[i % 2 for i in range(len(entities))]).prove())

    def test_p1_a_break_on_a_line_that_is_a_point(self):
        """The normals are zero on collapsed sides of patches, which S1 allows."""
        prover = star.cut(*star.cusp(), kind=Prover2, search=True, checked=False).prove()
        self.alone("P1", prover)


class Hostile(OnAPlate):
    def test_bytes_of_the_body(self):
        rng, codes, body = random.Random(91), [0] * 5, self.plate.plan.body()
        for trial in range(300 * SCALE):
            lie = forge.bent(rng, body)
            plan = copy.copy(self.plate.plan)
            plan.body = lambda lie=lie: lie
            code, line = vc._check(self.plate.model, plan.certificate(self.plate.model), frozenset())
            self.assertIn(code, (0, 1), (trial, lie.hex(), line))
            codes[code] += 1
        self.assertGreater(codes[1], 200)

if __name__ == "__main__":
    unittest.main()
