#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope cage: cages that certify accepts, that contain their models exactly, and refusals that leave nothing behind."""
import json
import unittest
from fractions import Fraction

import support
from support import MODELS, run

FRAME, BUNNY = MODELS / "valid_frame.off", support.DATA / "mesh" / "solid1" / "thingiCSG__bunny_remap.off"


def vertices(path):
    """The vertices of an .off file, exactly."""
    words = path.read_text().split()
    count = int(words[1])
    numbers = [Fraction(word) for word in words[4:4 + 3 * count]]
    return [tuple(numbers[3 * i:3 * i + 3]) for i in range(count)]


def points(entity):
    """The control points of a volume, exactly."""
    return [tuple(Fraction(x) for x in point[:3]) for point in entity["shape"]["points"]]


class Cage(support.Folder):
    def cage(self, *arguments, expect=0, name="c.vjson"):
        """The report of a cage that certify calls VALID, with the same numbers."""
        path = self.folder / name
        path.unlink(missing_ok=True)
        done = run("cage", *arguments, "-o", path, "--json", "-", timeout=600)
        self.assertEqual(done.returncode, expect, done.stderr)
        if expect != 0:
            self.assertFalse(path.exists())
            self.assertEqual(done.stdout, "")
            return " ".join(done.stderr.split())
        report = json.loads(done.stdout)
        file = support.only_file(path)
        self.assertEqual((file["verdict"], file["sha256"]), ("VALID", report["output"]["sha256"]))
        self.assertEqual(report["output"]["bytes"], path.stat().st_size)
        self.assertEqual([file["counts"][key] for key in ("cells", "internal", "boundary", "euler")],
                         [report["counts"][key] for key in ("cells", "internal", "boundary", "euler")])
        self.assertEqual((report["counts"]["genus"], report["regular"]), (sum(shell["genus"] for shell in file["shells"]), file["regular"]))
        self.entities = json.loads(path.read_text())["entities"]
        return report

    def test_boxes_have_the_corners_that_they_were_given(self):
        report = self.cage("box", "--min=-1,0,1/3", "--max", "1,0.5,2")
        self.assertEqual((report["kind"], report["input"], report["counts"]["cells"]), ("box", None, 1))
        self.assertEqual(points(self.entities[0])[0], (-1, 0, Fraction(1, 3)))
        self.assertEqual(points(self.entities[0])[-1], (1, Fraction(1, 2), 2))
        report = self.cage("box", "--min", "0,0,0", "--max", "1,1,1", "--degrees", "3,1,2", "--spans", "2,1,4")
        self.assertEqual(report["counts"]["control_points"], 5 * 2 * 6)
        self.assertLessEqual(report["volume"]["lo"], 1)
        self.assertGreaterEqual(report["volume"]["hi"], 1)

    def test_a_box_around_a_model_is_its_box_grown_by_the_margin(self):
        corners = vertices(FRAME)
        low, high = [tuple(f(v[k] for v in corners) for k in range(3)) for f in (min, max)]
        self.cage("box", "--around", FRAME, "--margin", 0)
        self.assertEqual((points(self.entities[0])[0], points(self.entities[0])[-1]), (low, high))
        self.cage("box", "--around", FRAME)
        diagonal = sum((b - a) ** 2 for a, b in zip(low, high))
        for k in range(3):
            grown = low[k] - points(self.entities[0])[0][k]
            self.assertEqual(points(self.entities[0])[-1][k] - high[k], grown)
            self.assertGreaterEqual((20 * grown) ** 2, diagonal)
            self.assertLessEqual((20 * grown * Fraction(1000, 1001)) ** 2, diagonal)

    def test_rings_discs_and_sectors(self):
        for arguments, genus, regular, internal in ((["--inner", 1], 1, True, 1), ([], 0, False, 1), (["--sector", 200], 0, False, 0),
                                                    (["--inner", "1/3", "--sector", "77.5"], 0, True, 0),
                                                    (["--inner", 1, "--axis", "1,2,3", "--point", "1/3,0,5", "--start", "1,0,0"], 1, True, 1)):
            with self.subTest(arguments):
                report = self.cage("radial", "--outer", 2, "--height=-1,3/2", *arguments)
                self.assertEqual((report["counts"]["genus"], report["regular"], report["counts"]["internal"]), (genus, regular, internal))
                self.assertEqual(report["angle_error"] is not None, "--sector" in arguments)
        self.cage("radial", "--around", FRAME)
        self.cage("radial", "--around", FRAME, "--axis", "1,1,1")
        self.assertIn("lies in the hole (--inner)", self.cage("radial", "--around", FRAME, "--inner", 1, expect=1))
        self.assertIn("not proved to lie inside of the cage, and nothing is written: triangle", self.cage("radial", "--around", FRAME, "--sector", 90, expect=3))

    def test_a_hull_contains_the_model_and_is_smaller_than_the_box(self):
        box = self.cage("box", "--around", FRAME)
        for arguments in ([], ["--degrees", "2,2,2", "--spans", "3,3,3"]):
            hull = self.cage("hull", "--around", FRAME, *arguments)
            self.assertLess(hull["volume"]["hi"], box["volume"]["lo"])
            self.assertGreater(hull["pull"]["rounds"], 0)
        self.cage("hull", "--around", MODELS / "patches" / "cube.itd")
        self.cage("hull", "--around", MODELS / "splines" / "two_cubes.mesh")

    @unittest.skipUnless(BUNNY.exists(), "needs VERITOPE_DATA")
    def test_a_hull_around_a_bunny_has_less_than_half_of_the_box(self):
        box = self.cage("box", "--around", BUNNY)
        hull = self.cage("hull", "--around", BUNNY, "--spans", "4,4,4")
        self.assertLess(hull["volume"]["hi"], 0.5 * box["volume"]["lo"])

    def field(self, lines, name="f.csv"):
        path = self.folder / name
        path.write_text("".join(line + "\n" for line in lines))
        return path

    def test_a_fit_follows_directions_and_tensors(self):
        places = [(x / 4, y / 4, z / 4) for x in range(3) for y in range(3) for z in range(5)]
        vectors = ["x,y,z,dx,dy,dz,t"] + [f"{x},{y},{z},{(-1) ** i * 0.2 * z},0,{(-1) ** i},{1 / 8 + z / 64}" for i, (x, y, z) in enumerate(places)]
        small = ["--spans", "1,1,2"]
        report = self.cage("fit", "--field", self.field(vectors), *small)
        self.assertEqual((report["kind"], report["fit"]["vectors"], report["fit"]["tensors"]), ("fit", 45, False))
        self.assertEqual(report["counts"]["control_points"], 4 * 4 * 5)
        self.assertLess(report["fit"]["degrees"]["worst"], 3)
        self.assertLess(report["fit"]["thickness_error"], 0.001)
        self.assertEqual(len(self.entities[0]["shape"]["points"][0]), 4)
        tensors = [f"{x} {y} {z} 1 1 2 0 0 0" for x, y, z in places]
        report = self.cage("fit", "--field", self.field(tensors), "--around", FRAME, "--degrees", "1,1,1", *small)
        self.assertTrue(report["fit"]["tensors"])
        self.assertLess(report["fit"]["degrees"]["worst"], 0.01)
        self.assertIsNone(report["fit"]["thickness_error"])

    def test_a_field_that_is_wrong_is_refused_with_its_line(self):
        good = "0 0 0 0 0 1"
        for lines, words in (([good, "0 0 0 0 0 x"], "line 2: dz: 'x' is not a number"), ([good, "0 0 0 0 0 0"], "line 2: the direction is 0"),
                             ([good, "1 nan 0 0 0 1"], "line 2: y: 'nan' is not finite"), (["0 0 0 1 1 1 0 0 0"], "line 1: the tensor has no first principal direction"),
                             ([good], "all vectors are at one place"), ([], "there is no vector in it"), (["1 2 3"], "line 1: a line has 6 numbers")):
            with self.subTest(words):
                self.assertIn(words, self.cage("fit", "--field", self.field(lines), expect=4))
        field = self.field([good, "1 1 1 0 0 1"])
        for arguments, status, words in ((["fit"], 2, "fit needs --field F.csv"), (["fit", "--field", field, "--margin", 0], 2, "--margin of a fit must be positive"),
                                         (["fit", "--field", field, "--degrees", "8,1,1"], 4, "--degrees of a fit are at most 7"),
                                         (["fit", "--field", field, "--spans", "17,16,16"], 4, "--spans of a fit are at most 4096"),
                                         (["fit", "--field", self.folder / "none.csv"], 4, "none.csv"),
                                         (["box", "--field", field, "--min", "0,0,0", "--max", "1,1,1"], 2, "--field is for fit, not for box")):
            with self.subTest(words):
                self.assertIn(words, self.cage(*arguments, expect=status))

    def test_a_split_cage_stays_glued_and_a_crack_opens(self):
        self.cage("box", "--min", "0,0,0", "--max", "2,2,2", name="box.vjson")
        report = self.cage("split", "--of", self.folder / "box.vjson", "--at", "u=1/3")
        self.assertEqual((report["counts"]["cells"], report["counts"]["internal"]), (2, 1))
        report = self.cage("split", "--of", self.folder / "box.vjson", "--at", "u=1/2", "--open", "w1", "--from", "1/2", "--low=-1/4,0,0", "--high", "1/4,0,0")
        self.assertEqual((report["counts"]["cells"], report["counts"]["internal"], report["counts"]["genus"]), (4, 3, 0))
        self.assertAlmostEqual(report["volume"]["lo"], 7.5)
        self.assertIn("the cage is INVALID", self.cage(
            "split", "--of", self.folder / "box.vjson", "--at", "u=1/2", "--open", "w1", "--from", "1/2", "--low", "1/4,0,0", expect=1))
        self.assertIn("more than two faces that are not glued meet", self.cage(
            "split", "--of", self.folder / "box.vjson", "--at", "u=1/2", "--open", "w1", "--from", "1/2", "--low", "0,0,1/4", expect=1))
        self.cage("radial", "--outer", 2, "--inner", 1, "--height", "0,1", name="ring.vjson")
        self.cage("split", "--of", self.folder / "ring.vjson", "--at", "u=1/2", name="two.vjson")
        report = self.cage("split", "--of", self.folder / "two.vjson", "--entity", 1, "--at", "w=1/4")
        self.assertEqual((report["counts"]["cells"], report["counts"]["genus"]), (4, 1))

    def test_what_does_not_fit_names_the_option_and_writes_nothing(self):
        self.cage("box", "--min", "0,0,0", "--max", "2,2,2", name="box.vjson")
        flat = support.write_off(self.folder / "flat.off", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        far = support.write_off(self.folder / "far.off", [(2.0**52 + x, y, z) for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))],
                                [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
        before = self.listing()
        of = ["split", "--of", self.folder / "box.vjson"]
        for arguments, status, words in ((["box", "--min", "0,0,0", "--max", "1,0,1"], 2, "--min must be less than max, and in y they are 0 and 0"),
                                         (["hull", "--around", far], 4, "far.off: content of this size is too far from the origin"),
                                         (["box", "--around", flat, "--margin", 0], 4, "flat.off: it has no extent in z and no margin"),
                                         (["box", "--min", "0,0,0", "--max", "1,1,1", "--spans", "4096,4096,4096"], 4, "--spans and degrees give"),
                                         (["radial", "--outer", 1, "--inner", 1, "--height", "0,1"], 2, "--inner must be less than outer, and they are 1 and 1"),
                                         (["radial", "--outer", 1, "--height", "1,0"], 2, "--height: low must be less than high, and they are 1 and 0"),
                                         (["radial", "--outer", 1, "--height", "0,1", "--sector", 360], 2, "--sector: degrees must be more than 0"),
                                         (["radial", "--outer", 1, "--height", "0,1", "--axis", "0,0,0"], 2, "--axis must not be 0"),
                                         (["radial", "--outer", 1, "--height", "0,1", "--start", "0,0,2"], 2, "--start lies along the axis"),
                                         ([*of, "--at", "u=1"], 2, "--at must lie inside of the domain, from 0 to 1, and it is 1"),
                                         ([*of, "--at", "u=1/2", "--entity", 7], 2, "--entity 7 does not exist"),
                                         ([*of, "--at", "u=1/2", "--open", "u1", "--from", "1/2", "--low", "1,0,0"], 2, "--open names a face across the axis of the cut"),
                                         ([*of, "--at", "u=1/2", "--open", "w1", "--from", 2, "--low", "1,0,0"], 2, "--from must lie inside of the domain"),
                                         ([*of, "--at", "u=1/2", "--open", "w1", "--from", "1/2", "--low", "0,0,0"], 2, "--low and high are equal"),
                                         (["split", "--of", MODELS / "patches" / "cube.itd", "--at", "u=1/2"], 4, "cube.itd"),
                                         (["split", "--of", FRAME, "--at", "u=1/2"], 4, "this is a mesh (off); needed is a file of splines"),
                                         (["box", "--around", MODELS / "splines" / "trimmed.itd"], 4, "no cage is made around entity 0, a trimmed surface")):
            with self.subTest(words):
                self.assertIn(words, self.cage(*arguments, expect=status))
                self.assertEqual(self.listing(), before)

    def test_a_cage_can_go_to_standard_output(self):
        done = run("cage", "box", "--min", "0,0,0", "--max", "1,1,1", "-o", "-")
        self.assertEqual(len(json.loads(done.stdout)["entities"]), 1)


if __name__ == "__main__":
    support.main()
