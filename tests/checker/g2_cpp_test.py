#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""reading-rule-g2.md in the C++ checker: what a text means, what is refused, certificates. VERITOPE_CHECK and VERITOPE_PRINT_MODEL name the
programs."""
import random
import unittest
from fractions import Fraction as Q

import judges
import printed_models
import star_box_forge as forge
import star_box_models as models
import volume_grids as grids

FLAT = "200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n"
WEIGHTED = "200 1 0 0 3 1 2 2 0 0 1 1 2 2 0 0 1 1 0 0 0 1 1 0 0 1 0 1 0 1 1 1 0 %s"


class Meaning(printed_models.PrintedTest):
    fmt = "g2"

    def test_the_first_axis_is_the_fastest_and_weights_are_last(self):
        (flat,) = self.entities(FLAT)
        self.assertEqual(flat, {"kind": "surface", "rational": False, "components": 3, "degrees": [1, 1], "knots": [[0, 0, 1, 1]] * 2,
                                "points": [(0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0)]})
        (weighted,) = self.entities("200 1 0 0 3 1 3 3 0 0 0 2 2 2 2 2 5 5 7 7 " + " ".join("%d %d 0 %d" % (i, j, 1 + i + 3 * j) for j in (0, 1) for i in (0, 1, 2)))
        self.assertEqual((weighted["rational"], weighted["components"], weighted["degrees"]), (True, 4, [2, 1]))
        self.assertEqual(weighted["knots"], [[0, 0, 0, 2, 2, 2], [5, 5, 7, 7]])
        self.assertEqual(weighted["points"], [(i, j, 0, 1 + i + 3 * j) for i in (0, 1, 2) for j in (0, 1)])    # the point is homogeneous as it stands

    def test_a_volume(self):
        volume = grids.Grid(axes=[[grids.SKEW], [grids.LINEAR], [(4, (0,) * 5 + (1,) * 5)]], weight=lambda x, y, z: 1 + x + y).volumes()
        self.reads(volume, grids.g2(volume))

    def test_decimals_are_exact_and_lines_mean_nothing(self):
        for word, value in (("0.1", Q(1, 10)), ("-.5e-2", Q(-1, 200)), ("+7.", 7), ("1E+03", 1000), ("1e4096", 10 ** 4096), ("0" * 999 + "3", 3)):
            (flat,) = self.entities("\xef\xbb\xbf" + FLAT.replace("1 1 0\n", "1 1 %s" % word).replace("\n", "\v\f\t\r"))
            self.assertEqual(flat["points"][3][2], value, word)

    def test_the_header_and_extra_integers_mean_nothing(self):
        for head in ("200 -7 +99 0", "200 1 0 4 1 -2 4611686018427387904 -4611686018427387904", "+0200 1 0 -0"):
            self.assertEqual(self.entities(FLAT.replace("200 1 0 0", head)), self.entities(FLAT))

    def test_several_objects(self):
        entities = models.cube() + grids.Grid(place=lambda x, y, z: (x, y, 2 * z)).volumes() + models.octant_sphere()[:1]
        self.reads(entities, grids.g2(entities))

    def test_other_dimensions_are_read(self):
        for dim in (1, 2, 4, 1000):
            (e,) = self.entities("200 1 0 0 %d 0 2 2 0 0 1 1 2 2 0 0 1 1 %s" % (dim, "5 " * 4 * dim))
            self.assertEqual(e["points"], [(5,) * dim] * 4)


class Refusals(printed_models.PrintedTest):
    fmt = "g2"

    def test_an_empty_file_and_truncations(self):
        self.refused("line 1, at '': expected an integer", "", " ", "\xef\xbb\xbf")
        words = FLAT.split()
        for n in range(1, len(words)):
            self.refused("expected", " ".join(words[:n]))

    def test_classes(self):
        self.refused("line 1, at '100': neither a spline surface (200) nor a spline volume (700)", FLAT.replace("200", "100"))
        self.refused("line 11, at '210'", FLAT + "210 1 0 0")
        self.refused("neither", FLAT.replace("200", "-200"), FLAT + "7")
        self.refused("expected an integer", FLAT.replace("200", "200.0"), FLAT + "x", FLAT.replace("200", "2e2"))

    def test_headers(self):
        self.refused("expected an integer", *(FLAT.replace("200 1 0 0", "200 " + h) for h in ("x 0 0", "1 x 0", "1 0 x", "1 0 1 x", "1 0 1 1.0", "1 0 0.0", "4611686018427387905 0 0")))
        self.refused("expected an integer from 0 to", FLAT.replace("1 0 0", "1 0 -1", 1), FLAT.replace("1 0 0", "1 0 %d" % (len(FLAT) + 30), 1))
        self.refused("line 2, at '0': expected an integer from 1 to 1000", FLAT.replace("3 0\n", "0 0\n"))
        self.refused("expected an integer from 1 to 1000", FLAT.replace("3 0\n", "1001 0\n"), FLAT.replace("3 0\n", "-3 0\n"))
        self.refused("expected an integer from 0 to 1", FLAT.replace("3 0\n", "3 2\n"), FLAT.replace("3 0\n", "3 -1\n"))

    def test_axes(self):
        self.refused("line 3, at '1': expected an integer from 2 to 2", FLAT.replace("2 2", "2 1", 1))
        self.refused("expected an integer from 2 to 2", FLAT.replace("2 2", "2 3", 1), FLAT.replace("2 2", "2 -2", 1))
        self.refused("from 2 to 64", "200 1 0 0 3 0 70 65 " + "0 " * 300)
        self.refused("expected an integer from 0 to", FLAT.replace("2 2", "-2 2", 1), FLAT.replace("2 2", "%d 2" % (len(FLAT) + 99), 1))
        for knots, word in (("0 0 -1 1", "less than the one before"), ("0 0 0 1", "occurs too often"), ("1 1 1 1", "occurs too often"), ("0 1 1 1", "occurs too often")):
            self.refused(word, FLAT.replace("0 0 1 1", knots, 1))
        self.refused("domain is empty", "200 1 0 0 3 0 3 3 0 1 2 2 2 3 2 2 0 0 1 1 " + "0 " * 18)
        self.refused("at 'x': expected a decimal", FLAT.replace("0 0 1 1", "0 0 1 x"))

    def test_points(self):
        self.refused("line 11, at '3': neither", FLAT + "3")  # a number too many begins an object
        for word in ("nan", "inf", "0x1", "1/2", "1,5", ".", "-", "e5", "1e", "1e+", "1.2.3", "1e5.0", "--1", "0" * 1001, "1e4097", "1e-4097", "1\0", "1e99999999999999999999"):
            self.refused("", FLAT.replace("1 1 0\n", "1 1 %s\n" % word))
        self.refused("line 10, at 'nan': expected a decimal", FLAT.replace("1 1 0\n", "1 1 nan\n"))
        self.assertEqual(len(self.entities(WEIGHTED % "1e-9")), 1)
        self.refused("a weight is not positive", WEIGHTED % "0", WEIGHTED % "-1")

    def test_counts_that_lie_take_no_memory_and_no_time(self):
        """The file holds 4,000 bytes; its axes claim up to 4,000^3 points."""
        big = "1 " * 2000
        self.refused("", "200 1 0 %d" % len(big) + big, "200 1 0 0 1000 1 999 2 " + big, FLAT + "200 1 0 0 3 0 900 2 " + big)
        knots = "60 2 0 %s 59 " % " ".join(map(str, range(60)))
        self.refused("more control points than the file can hold", "700 1 0 0 3 0 " + knots * 3)
        self.refused("more control points than the file can hold", "200 1 0 0 1000 0 " + knots * 2 + big)


class Certificates(printed_models.PrintedTest):
    fmt = "g2"

    def says(self, expected, prover, text, fmt="g2"):
        prover.plan.values["subject_format"] = fmt
        code, condition, out = judges.in_cpp(text.encode(), prover.plan.certificate(text.encode()))
        self.assertEqual((code, condition), (0 if expected == "ACCEPT" else 4 if not expected else 1, expected), out)

    def test_sound_models_are_accepted(self):
        for entities in (models.cube(), models.octant_sphere()):
            prover = forge.Prover(entities).prove()
            self.says("ACCEPT", prover, grids.g2(entities))
            self.says("", prover, grids.g2(entities), "g2-faces")      # surfaces are no volumes
            self.says("", prover, grids.g2(entities), "mfem")
            self.says("", prover, grids.g2(entities), "vjson")
            self.says("S1", prover, grids.g2(entities), "g2-face")

    def test_another_order_of_the_points_is_another_model(self):
        prover = forge.Prover(models.cube()).prove()
        lines = grids.g2(models.cube()).split("\n")       # a head of six lines, four points
        lines[7], lines[8] = lines[8], lines[7]
        self.says("P1", prover, "\n".join(lines))

    def test_volumes_and_other_dimensions_fail_b2(self):
        plan, interval = forge.Plan([]), forge.u32(2) + b"\0\1" + b"\2\1"    # breaks 0 and 1
        box = forge.zigzag(0) + forge.u32(1) + b"\1\0" + b"\0\0\0" + b"\1\1\1"
        for text, patches, tree in ((grids.g2(grids.Grid().volumes()), b"", b""),
                                    ("200 1 0 0 2 0 2 2 0 0 1 1 2 2 0 0 1 1 0 0 1 0 0 1 1 1", interval * 2 + b"\0\0", b"\1")):
            model, body = text.encode(), b"VTSB" + forge.u32(1) + b"\0" + patches + box + tree + forge.u32(0)
            plan.values["subject_format"], plan.body = "g2", lambda body=body: body
            code, condition, out = judges.in_cpp(model, plan.certificate(model))
            self.assertEqual((code, condition), (1, "B2"), out)

    def test_mutated_texts_are_read_or_refused(self):
        rng, base = random.Random(81), grids.g2(models.cube()[:1] + grids.Grid().volumes())
        bits = ["200", "700", " ", "-", "+", ".", "e", "0", "9", "1e4096", "\n", "x", "64", "3", "99999999999999999999"]
        for _ in range(200):
            text = base
            for _ in range(rng.randrange(1, 4)):
                at = rng.randrange(len(text))
                text = text[:at] + rng.choice(bits) + text[at + rng.randrange(4):]
            with self.subTest(text):
                self.assertIn(printed_models.printed(text, "g2")[0], (0, 4))
                self.assertIn(printed_models.printed(text, "g2-faces")[0], (0, 4))


if __name__ == "__main__":
    unittest.main()
