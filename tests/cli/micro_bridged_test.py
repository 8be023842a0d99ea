#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope micro: bridges in the composed surface, in the volume, in info and in pictures; the clearance of the tiles."""
import json
import re
import unittest
from fractions import Fraction

import schema
import support
from support import run


def block(low, high):
    """The cube [low, high]^3."""
    ends = (low, high)
    return "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for z in ends for y in ends for x in ends) + (
        "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")


OCTAHEDRON = "OFF\n6 8 0\n3.1 2 2\n0.1 2 2\n2 3.9 2\n2 0.1 2\n2 2 3.9\n2 2 0.1\n" + "".join(
    f"3 {a} {b} {c}\n" for a, b, c in ((0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)))


class MicroBridged(support.Folder):
    def setUp(self):
        super().setUp()
        self.out, self.solid = self.folder / "out.vmicro", self.folder / "solid.off"
        self.box = self.volumes("box", {"op": "box", "min": [0, 0, 0], "max": [4, 4, 4]})
        self.solid.write_text(block("0.5", "3.5"))

    def command(self, *arguments, cage=None, counts="4,4,4", tile="jack,degree=1"):
        return ["micro", "--cage", cage or self.box, "--tile", tile, "--counts", counts, "--model", self.solid, *arguments]

    def micro(self, *arguments, **how):
        done = run(*self.command("-o", self.out, "--json", "-", *arguments, **how), timeout=600)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        return report

    def creased(self):
        """The box in eight by eight by eight parts of unequal sizes, each of the same size in the parameters."""
        spline = json.loads(self.box.read_text())
        (entity,) = spline["entities"]
        places = ["0", "4/9", "1", "13/9", "2", "22/9", "3", "31/9", "4"]
        entity["shape"]["knots"] = [["0", *(str(Fraction(i, 8)) for i in range(9)), "1"]] * 3
        entity["shape"]["points"] = [[x, y, z] for x in places for y in places for z in places]
        path = self.folder / "creased.vjson"
        path.write_text(json.dumps(spline))
        return path

    def test_the_composed_surface_has_the_bridges_and_is_certified(self):
        path = self.folder / "surface.vjson"
        report = self.micro("--emit", path)
        self.assertEqual((report["tiles"]["kept"], report["bridges"]["built"]), (8, 24))
        # 8 jacks of 30 patches; 12 pairs of equal caps are left out, and 24 caps for five faces of a bridge each.
        composed = report["composed"]
        self.assertEqual((composed["patches"], composed["bridges"], composed["bridges_left_out"]), (8 * 30 - 2 * 12 + 4 * 24, 24, []))
        file = support.only_file(path, timeout=600)
        self.assertEqual((file["verdict"], file["counts"]["patches"], file["counts"]["shells"], file["counts"]["genus"]),
                         ("VALID", composed["patches"], report["shells"], report["genus"]))
        structure = support.only_file(self.out)["counts"]
        self.assertEqual((structure["bridges"], structure["shells"], structure["genus"]), (24, report["shells"], report["genus"]))
        # Both volumes hold the bridges.
        self.assertLessEqual(report["volume"]["lo"], file["volume"]["hi"])
        self.assertGreaterEqual(report["volume"]["hi"], file["volume"]["lo"])
        without = self.micro("--bridge", "none")
        self.assertGreater(report["volume"]["lo"], without["volume"]["hi"] + 0.5)
        self.assertAlmostEqual(report["density"]["lo"] * 64, report["volume"]["lo"])

    def test_bridges_into_a_glued_volume_are_composed_with_its_map(self):
        cage, path = self.folder / "split.vjson", self.folder / "surface.vjson"
        self.assertEqual(run("cage", "split", "--of", self.box, "--at", "u=1/2", "-o", cage).returncode, 0)
        x, y = ("0.5", "2.6"), ("0.5", "3.5")
        self.solid.write_text("OFF\n8 6 0\n" + "".join(f"{a} {b} {c}\n" for c in y for b in y for a in x) +
                              "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")
        report = self.micro("--emit", path, cage=cage, counts="2,4,4")
        across = [b for b in json.loads(self.out.read_text())["bridges"] if (b["grid"], b["volume"]) == (0, 1)]
        self.assertEqual((len(across), report["bridges"]["built"], report["composed"]["bridges"]), (4, 16, 16))
        file = support.only_file(path, timeout=600)
        self.assertEqual((file["verdict"], file["counts"]["shells"], file["counts"]["genus"]), ("VALID", report["shells"], report["genus"]))
        self.assertLessEqual(report["volume"]["lo"], file["volume"]["hi"])
        self.assertGreaterEqual(report["volume"]["hi"], file["volume"]["lo"])

    def test_formats_hold_the_same_faces_for_every_number_of_jobs(self):
        for ending in ("vjson", "itd", "vtu"):
            path, texts = self.folder / f"surface.{ending}", []
            for jobs in (1, 2):
                report = self.micro("--emit", path, "--jobs", jobs)
                texts.append(path.read_bytes())
            self.assertEqual(texts[0], texts[1])
        bridges = texts[0].split(b'Name="bridge"')[1].split(b">")[1].split(b"<")[0].split()
        self.assertEqual(len(bridges), report["composed"]["patches"])
        for b in range(24):
            self.assertEqual(bridges.count(str(b).encode()), 5)
        self.assertEqual(bridges.count(b"-1"), report["composed"]["patches"] - 5 * 24)

    def test_bridges_across_a_crease_are_left_out_by_name(self):
        cage, path = self.creased(), self.folder / "surface.vjson"
        self.solid.write_text(OCTAHEDRON)
        report = self.micro("--emit", path, cage=cage, counts="8,8,8")
        composed = report["composed"]
        across = []
        for number, bridge in enumerate(json.loads(self.out.read_text())["bridges"]):
            if any(min(x) < Fraction(i, 8) < max(x) for x in zip(*[map(Fraction, p) for p in bridge["points"]]) for i in range(1, 8)):
                across.append(number)
        self.assertGreater(len(across), 0)
        self.assertGreater(composed["bridges"], 0)
        self.assertEqual((composed["bridges_left_out"], composed["bridges"]), (across, report["bridges"]["built"] - len(across)))
        done = run(*self.command("-o", self.out, "--emit", path, cage=cage, counts="8,8,8"), timeout=600)
        text = " ".join(done.stdout.split())
        self.assertIn(f"left out {len(across)} {'bridge' if len(across) == 1 else 'bridges'} not composed, because a knot of the cage crosses {'it' if len(across) == 1 else 'them'}: {across[0]}", text)
        file = support.only_file(path, timeout=600)
        self.assertEqual((file["verdict"], file["counts"]["shells"], file["counts"]["genus"]), ("VALID", report["shells"], report["genus"]))

    def test_the_volume_is_that_of_the_mesh_up_to_its_distance(self):
        mesh = self.folder / "out.ply"
        self.solid.write_text(OCTAHEDRON)
        report = self.micro("--mesh", mesh, "--chord", "0.005", counts="8,8,8")
        self.assertGreater(report["bridges"]["built"], 50)
        volume = support.only_file(mesh)["volume"]
        self.assertLessEqual(report["volume"]["hi"] - report["volume"]["lo"], 1e-9 * report["volume"]["hi"])
        self.assertAlmostEqual(report["volume"]["lo"] / float(volume["decimal"]), 1, delta=0.05)
        # Where bridges cross creases, bounds are wider.
        creased = self.micro(cage=self.creased(), counts="8,8,8")["volume"]
        self.assertLessEqual(creased["hi"] - creased["lo"], 1e-6 * creased["hi"])

    def test_the_clearance_of_a_block_is_a_rational_number(self):
        for low, high, truth in (("0.5", "3.5", 0.5), ("0.625", "3.75", 0.375), ("0.25", "3.9375", 0.75)):
            self.solid.write_text(block(low, high))
            for jobs in (1, 3):
                clearance = self.micro("--jobs", jobs)["clearance"]
                self.assertLessEqual(clearance["lo"], truth)
                self.assertGreaterEqual(clearance["hi"], truth)
                self.assertLessEqual(clearance["hi"], 1.01 * clearance["lo"])
        done = run(*self.command("-o", self.out))
        self.assertIn("clearance 0.75 from the tiles to the surface of the model", " ".join(done.stdout.split()))
        # Bridges come nearer, and do not count.
        self.assertEqual(self.micro("--bridge", "none")["clearance"], clearance)

    def test_the_clearance_from_a_model_of_splines_is_that_from_a_mesh(self):
        self.solid.write_text(block("0.625", "3.75"))
        mesh = self.micro("--bridge", "none")["clearance"]
        self.solid = self.volumes("block", {"op": "box", "min": ["5/8", "5/8", "5/8"], "max": ["15/4", "15/4", "15/4"]})
        patches = self.micro()["clearance"]
        self.assertLessEqual(patches["lo"], 0.375)
        self.assertGreaterEqual(patches["hi"], 0.375)
        self.assertLessEqual(patches["hi"], 1.01 * patches["lo"])
        self.assertLessEqual(mesh["lo"], patches["hi"])

    def test_without_a_model_or_a_tile_there_is_no_clearance(self):
        done = run("micro", "--cage", self.box, "--tile", "jack", "--counts", "1,1,1", "-o", self.out, "--json", "-")
        self.assertIsNone(json.loads(done.stdout)["clearance"])
        self.solid.write_text(block("0.1", "0.2"))
        report = self.micro()
        self.assertEqual((report["tiles"]["kept"], report["clearance"]), (0, None))

    def test_info_and_pictures_know_bridges(self):
        self.micro()
        (file,) = json.loads(run("info", self.out, "--json", "-").stdout)["files"]
        self.assertEqual((file["counts"]["tiles"], file["counts"]["bridges"]), (8, 24))
        self.assertRegex(run("info", self.out).stdout, re.compile(r"^ +bridges +24 bridges$", re.M))
        done = run("render", self.out, "-o", self.folder / "view.gltf", "--json", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["micro"]["bridges"], 24)
        self.micro("--bridge", "none")
        self.assertNotIn("bridges", run("info", self.out).stdout)


if __name__ == "__main__":
    unittest.main()
