#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope micro: microstructures that certify accepts, and refusals that leave nothing behind."""
import itertools
import json
import math
import unittest
from fractions import Fraction

import cylinders
import schema
import support
from support import run

def cube(low, high):
    """The cube [low, high]^3."""
    ends = (low, high)
    return "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for z in ends for y in ends for x in ends) + (
        "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")


def jack_corners(cell, size):
    """The corners of the node, and of the ends of the arms, of a jack with node 1/5 and caps 1/8 in a cube of cells."""
    node, cap, half = Fraction(1, 5), Fraction(1, 8), Fraction(1, 2)
    points = list(itertools.product((half - node, half + node), repeat=3))
    for axis, end, a, b in itertools.product(range(3), (0, 1), (-cap, cap), (-cap, cap)):
        p = [half + a, half + b]
        p.insert(axis, end)
        points.append(p)
    return [[(i + x) * size for i, x in zip(cell, p)] for p in points]


class MicroCommand(support.Folder):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out.vmicro"
        self.box = self.volumes("box", {"op": "box", "min": [0, 0, 0], "max": [8, 8, 8]})

    def micro(self, *arguments, cage=None, counts="4,4,4", tile="jack,degree=1", expect=0):
        """The report of a microstructure whose numbers are those that certify finds."""
        self.out.unlink(missing_ok=True)
        done = run("micro", "--cage", cage or self.box, "--tile", tile, "--counts", counts, "-o", self.out, "--json", "-", *arguments, timeout=600)
        self.assertEqual(done.returncode, expect, done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        if expect == 1:
            self.assertFalse(self.out.exists())
            self.assertIsNone(report["output"])
            return report
        file = support.only_file(self.out)
        self.assertEqual((file["verdict"], file["sha256"]), ("VALID", report["output"]["sha256"]))
        self.assertEqual(file["counts"]["tiles"], report["tiles"]["kept"])
        for key in ("volume", "density", "scale"):
            self.assertEqual(report[key] is None, report["tiles"]["kept"] == 0)
        for key in ("glued_caps", "components", "shells", "genus"):
            self.assertEqual(file["counts"][key], report[key], key)
        return report

    def refused(self, words, status, *arguments):
        done = run("micro", "--cage", self.box, "--tile", "jack", "--counts", "2,2,2", *arguments, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (status, ""), done.stderr)
        self.assertIn(words, " ".join(done.stderr.split()))
        self.assertFalse(self.out.exists())

    def test_models_of_other_kinds_and_shared_streams_are_refused(self):
        solid = support.MODELS / "dms" / "tetrahedron.vdms"
        self.refused("a simplex-spline solid is no solid for --model", 4, "-o", self.out, "--model", solid)
        self.refused("would both write standard output", 2, "-o", "-", "--json", "-")
        self.refused("would both write standard output", 2, "-o", self.out, "--list", "-", "--json", "-")
        self.refused("- is not read", 2, "-o", self.out, "--model", "-")
        self.micro(counts="1,1,1")
        for model in self.out, solid:
            done = run("cage", "box", "--around", model, "-o", self.folder / "c.vjson")
            self.assertEqual(done.returncode, 4)
            self.assertIn("no cage is made around", done.stderr)

    def test_volumes_that_are_glued_along_w_are_not_doubled(self):
        cage = json.loads(self.box.read_text())
        above = json.loads(json.dumps(cage["entities"][0]))
        for point in above["shape"]["points"]:
            point[2] = str(Fraction(point[2]) + 8)
        cage["entities"].append(above)
        two = self.folder / "two.vjson"
        two.write_text(json.dumps(cage))
        report = self.micro("--double", "w=1", cage=two, counts="2,2,2", tile="jack", expect=1)
        self.assertEqual([(d["code"], d["wall"]) for d in report["defects"]], [("cage", "w1")])
        self.micro(cage=two, counts="2,2,2", tile="jack")

    def test_marks_escapes_and_names_are_read_by_all(self):
        solid = self.folder / "m\udcff.off"
        solid.write_text(cube(1, 7))
        tile = self.folder / "t\udcff.off"
        tile.write_text(cube("0.25", "0.75"))
        self.micro("--model", solid, "--material", "\udcff=x", tile=tile)
        text = self.out.read_bytes()
        at = text.index(b'["', text.index(b'"cells"')) + 2
        self.out.write_bytes(b"\xef\xbb\xbf" + text[:at] + b"\\u%04x" % text[at] + text[at + 1:])
        self.assertEqual(support.only_file(self.out)["verdict"], "VALID")

    def test_a_block_of_jacks_has_the_genus_of_its_graph(self):
        for tile in ("jack", "jack,degree=1", "jack,node=1/4,cap=0.2"):
            report = self.micro(tile=tile, counts="3,4,5")
            self.assertEqual((report["tiles"]["total"], report["genus"]), (60, 2 * 60 - 12 - 20 - 15 + 1))

    def test_volume_density_and_scale_are_enclosed(self):
        # Frusta of degree 1 with node 1/5 and cap 1/8, three tenths long; the scale is the volume of the box.
        jack = 0.4**3 + 6 * 0.3 * (0.4**2 + 0.4 * 0.25 + 0.25**2) / 3
        report = self.micro()
        for key, truth in (("volume", 512 * jack), ("density", jack), ("scale", 512)):
            bounds = report[key]
            self.assertLessEqual(bounds["lo"], truth * (1 + 1e-12))
            self.assertGreaterEqual(bounds["hi"], truth * (1 - 1e-12))
            self.assertLess(bounds["hi"] - bounds["lo"], 1e-9 * truth)
        torus = self.volumes("torus", {"op": "torus", "major": 3, "minor": 1})
        report = self.micro(cage=torus, counts="2,2,6")
        cage = 6 * math.pi**2
        self.assertAlmostEqual(report["volume"]["lo"] / report["density"]["lo"] / cage, 1, 7)
        self.assertLess(report["scale"]["lo"], report["scale"]["hi"])

    def test_bounds_of_measures_that_are_far_apart_are_numbers(self):
        # Along u the cube is mapped by u^2 / ((1 - u)^2 + 2 w u (1 - u) + u^2).
        for w in (Fraction(1, 10**4), Fraction(1, 10**50)):
            points = [[str(c) for c in (i * k, a * k, b * k, k)]
                      for i, k in ((0, 1), (Fraction(1, 2), w), (1, 1)) for a, b in itertools.product((0, 1), repeat=2)]
            cage = self.folder / "uneven.vjson"
            cage.write_text(json.dumps({"format": "veritope-spline-1", "groups": [], "entities": [{"kind": "volume", "group": None, "attributes": [], "shape": {
                "degrees": [2, 1, 1], "periodic": [False] * 3, "knots": [["0"] * 3 + ["1"] * 3, *[["0", "0", "1", "1"]] * 2], "rational": True,
                "components": 4, "points": points}}]}))
            report = self.micro(cage=cage, counts="3,3,3")
            for key in ("volume", "density"):
                self.assertLessEqual(0, report[key]["lo"])
                self.assertLessEqual(report[key]["lo"], 1)
            self.assertLessEqual(report["density"]["hi"], 1)
            # A jack covers more than a tenth of its cell, and the cells' faces are planes.
            self.assertGreater(report["volume"]["hi"], 0.1)
            done = run("micro", "--cage", cage, "--tile", "jack", "--counts", "3,3,3", "-o", self.out)
            self.assertRegex(done.stdout, r"volume +0 to [0-9.e+]+, 0 to 100 % of the cells")

    def test_tiles_are_kept_in_the_interior_of_the_model(self):
        solid = self.folder / "cube.off"
        solid.write_text(cube(1, 7))
        listed = self.folder / "cells.csv"
        # Cells of length 1: the solid is [1, 7]^3. Its walls are walls of cells, so that the outermost tiles touch them with their caps.
        report = self.micro("--model", solid, "--list", listed, counts="8,8,8")
        self.assertEqual(report["tiles"], {"total": 512, "kept": 64, "crossing": 0, "touching": 216 - 64 + 6 * 36, "outside": 512 - 216 - 6 * 36, "undecided": 0, "floating": 0})
        lines = listed.read_text().splitlines()
        self.assertEqual(lines[0], "volume,i,j,k,status")
        self.assertEqual(len(lines), 513)
        self.assertIn("0,3,3,3,kept", lines)
        self.assertIn("0,1,3,3,touching", lines)
        self.assertIn("0,0,0,0,outside", lines)
        self.assertEqual(json.loads(self.out.read_text())["model"]["name"], "cube.off")
        for jobs in (1, 2):
            self.micro("--model", solid, "--jobs", jobs, counts="8,8,8")
            self.assertEqual(support.only_file(self.out)["sha256"], report["output"]["sha256"])

    def test_a_solid_of_patches_keeps_the_tiles_whose_corners_it_contains(self):
        # The cylinder of radius 3 around the line (4, y, 0) from z = 1 to z = 7, moved: a convex solid.
        solid, listed = self.folder / "cylinder.vjson", self.folder / "cells.csv"
        solid.write_text(cylinders.cylinder(4, 1, 7, radius=3, place=lambda p: (p[0], p[1] + 4, p[2] + Fraction(1, 10))))
        report = self.micro("--model", solid, "--list", listed, tile="jack,degree=1,node=1/5,cap=1/8", counts="10,10,10")
        self.assertEqual((report["tiles"]["touching"], report["tiles"]["undecided"]), (0, 0))
        self.assertEqual(json.loads(self.out.read_text())["model"]["name"], "cylinder.vjson")
        for line in listed.read_text().splitlines()[1:]:
            *cell, status = line.split(",")
            inside = [self.in_cylinder(*p) for p in jack_corners([int(i) for i in cell[1:]], Fraction(8, 10))]
            self.assertEqual(all(inside), status == "kept", line)
            if status == "outside":
                self.assertFalse(any(inside), line)
        for jobs in (1, 2):
            self.micro("--model", solid, "--jobs", jobs, tile="jack,degree=1,node=1/5,cap=1/8", counts="10,10,10")
            self.assertEqual(support.only_file(self.out)["sha256"], report["output"]["sha256"])

    @staticmethod
    def in_cylinder(x, y, z):
        return (x - 4) ** 2 + (y - 4) ** 2 < 9 and 1 < z - Fraction(1, 10) < 7

    def test_a_ball_with_a_neck_contradicts_no_status(self):
        solid, listed = self.folder / "neck.vjson", self.folder / "cells.csv"
        # Half as large, with the middle of the ball at (4, 4, 3).
        middle, half = (4, 4, 3), Fraction(1, 2)
        solid.write_text(cylinders.ball_with_neck(lambda p: tuple(m + half * x for m, x in zip(middle, p))))
        self.assertEqual(support.only_file(solid)["verdict"], "VALID")
        report = self.micro("--model", solid, "--list", listed, tile="jack,degree=1,node=1/5,cap=1/8", counts="11,11,11")
        self.assertEqual((report["tiles"]["touching"], report["tiles"]["undecided"]), (0, 0))
        self.assertGreater(report["tiles"]["kept"], 50)
        for line in listed.read_text().splitlines()[1:]:
            *cell, status = line.split(",")
            inside = []
            for p in jack_corners([int(i) for i in cell[1:]], Fraction(8, 11)):
                x, y, z = (2 * (a - m) for a, m in zip(p, middle))
                inside.append(x * x + y * y + z * z < 25 or (x * x + y * y < 9 and 0 < z < 8))
            if status == "kept":
                self.assertTrue(all(inside), line)
            if status == "outside":
                self.assertFalse(any(inside), line)
            if any(inside) and not all(inside):
                self.assertEqual(status, "crossing", line)

    def test_a_solid_of_volumes_is_its_border(self):
        solid = self.volumes("cylinder", {"op": "place", "translate": [4, 4, "11/10"], "of": {"op": "cylinder", "radius": 3, "height": 6}})
        surface = self.folder / "surface.vjson"
        surface.write_text(cylinders.cylinder(4, 1, 7, radius=3, place=lambda p: (p[0], p[1] + 4, p[2] + Fraction(1, 10))))
        tiles = [self.micro("--model", file, counts="8,8,8")["tiles"] for file in (solid, surface)]
        self.assertEqual(tiles[0], tiles[1])

    def test_solids_of_patches_that_are_open_or_not_in_the_cage_are_refused(self):
        solid = self.folder / "cylinder.vjson"
        text = json.loads(cylinders.cylinder(4, 1, 7, radius=3, place=lambda p: (p[0], p[1] + 4, p[2])))
        solid.write_text(json.dumps({**text, "entities": text["entities"][1:]}))
        self.assertEqual(self.micro("--model", solid, expect=1)["defects"][0]["code"], "model")
        solid.write_text(cylinders.cylinder(4, 1, 9, radius=3, place=lambda p: (p[0], p[1] + 4, p[2])))
        defect = self.micro("--model", solid, expect=1)["defects"][0]
        self.assertEqual(defect["code"], "cage")
        self.assertRegex(defect["message"], r"surface \d+.* does not lie inside of the cage: its point near \(\S+, \S+, \S+\) is on its border or outside")
        # No solid is a microstructure, or a curve.
        self.micro(counts="2,2,2")
        other = self.folder / "solid.vmicro"
        self.out.rename(other)
        done = run("micro", "--cage", self.box, "--tile", "jack", "--counts", "2,2,2", "-o", self.out, "--model", other)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("a microstructure is no solid for --model", done.stderr)

    def test_only_the_largest_part_is_kept_if_it_is_asked_for(self):
        solid, listed = self.folder / "two.off", self.folder / "cells.csv"
        # Two cubes: 4 x 4 x 4 cells lie in the one, and one in the other.
        first, second = cube("0.5", "5.5").splitlines(), cube("5.7", "7.3").splitlines()
        faces = ["4 " + " ".join(str(int(i) + 8) for i in line.split()[1:]) for line in second[10:]]
        solid.write_text("\n".join(["OFF", "16 12 0", *first[2:10], *second[2:10], *first[10:], *faces]) + "\n")
        both = self.micro("--model", solid, "--bridge", "none", counts="8,8,8")
        self.assertEqual((both["tiles"]["kept"], both["components"]), (65, 2))
        self.assertIsNone(both["bridges"])
        one = self.micro("--model", solid, "--bridge", "none", "--connected", "--list", listed, counts="8,8,8")
        self.assertEqual((one["tiles"]["kept"], one["tiles"]["floating"], one["components"]), (64, 1, 1))
        self.assertIn("0,6,6,6,floating", listed.read_text().splitlines())

    def test_each_volume_may_have_counts_of_its_own(self):
        cut = self.folder / "cut.vjson"
        self.assertEqual(run("cage", "split", "--of", self.box, "--at", "u=1/4", "-o", cut).returncode, 0)
        report = self.micro(cage=cut, counts="1,4,4/3,4,4")
        self.assertEqual((report["tiles"]["total"], report["genus"], report["components"]), (64, 2 * 64 - 3 * 16 + 1, 1))
        self.assertEqual(len(json.loads(self.out.read_text())["grids"][1]["breaks"][0]), 4)
        done = run("micro", "--cage", self.box, "--tile", "jack", "--counts", "1,1,1/2,2,2", "-o", self.out)
        self.assertEqual((done.returncode, self.out.exists()), (2, True))
        self.assertIn("--counts has numbers for 2 volumes, and the cage has 1", " ".join(done.stderr.split()))

    def test_pictures_have_tiles_cage_and_solid(self):
        solid = self.folder / "cube.off"
        solid.write_text(cube(1, 7))
        self.micro("--model", solid, counts="8,8,8")
        for name in ("a.png", "a.gltf", "a.vtu", "a.obj"):
            picture = self.folder / name
            done = run("render", self.out, "-o", picture, "--nets", "--around", solid, "--json", "-", *(["--size", "200,150"] if name == "a.png" else []))
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            self.assertEqual(schema.faults(report), [])
            self.assertEqual((report["micro"]["tiles"], report["micro"]["cage"], report["micro"]["around"]), (64, True, str(solid)))
            self.assertGreater(picture.stat().st_size, 1000)
        for option in (["--explode", "1"], ["--grid", "3"], ["--bounds", "0,0,0,1,1,1"], ["--chord", "1"]):
            done = run("render", self.out, "-o", self.folder / "b.png", *option)
            self.assertEqual((done.returncode, (self.folder / "b.png").exists()), (2, False))
            self.assertIn(f"{option[0]} is not for microstructures", done.stderr)
        self.assertIn("--around is for microstructures", run("render", solid, "-o", self.folder / "b.png", "--around", solid).stderr)

    def test_materials_are_kept_in_the_file(self):
        self.micro("--material", "glass=x/8", "--material", "heat=exp(-u)", counts="2,1,1")
        materials = json.loads(self.out.read_text())["materials"]
        self.assertEqual([m["name"] for m in materials], ["glass", "heat"])
        self.assertEqual(materials[0]["values"], [[0] * 4 + [2**19] * 4 + [2**20] * 4])
        self.assertEqual(materials[1]["values"][0][4], round(2**20 * 2.718281828459045 ** -0.5))
        report = self.micro("--material", "glass=1/(x-4)", counts="2,1,1", expect=1)
        self.assertEqual(report["defects"][0]["code"], "material")
        self.assertIn("glass: corner (1, 0, 0) of grid 0", report["defects"][0]["message"])

    def test_free_caps_are_continued_to_the_skin_of_the_model(self):
        solid, mesh = self.folder / "cube.off", self.folder / "out.ply"
        solid.write_text(cube("0.5", "7.5"))
        report = self.micro("--model", solid, "--mesh", mesh, "--chord", "0.05", counts="8,8,8")
        bridges = report["bridges"]
        self.assertEqual((report["tiles"]["kept"], bridges["caps"], bridges["built"], sum(bridges["dropped"].values())), (216, 216, 216, 0))
        self.assertEqual(bridges["kink_degrees"], {"lo": 0, "hi": 0})
        self.assertTrue(0 < bridges["reach"]["lo"] <= bridges["reach"]["hi"] <= 0.07 * 3**0.5, bridges)
        self.assertEqual(len(json.loads(self.out.read_text())["bridges"]), 216)
        file = support.only_file(mesh)
        self.assertEqual((file["verdict"], file["counts"]["shells"], file["counts"]["genus"]), ("VALID", 1, report["genus"]))
        sha = report["output"]["sha256"]
        for jobs in (1, 3):
            self.assertEqual(self.micro("--model", solid, "--jobs", jobs, counts="8,8,8")["output"]["sha256"], sha)
        near = self.micro("--model", solid, "--alpha", "1/3", "--skin", "0.01", counts="8,8,8")
        self.assertLessEqual(near["bridges"]["reach"]["hi"], 0.01)
        self.assertNotEqual(near["output"]["sha256"], sha)
        # The caps of the cells that touch the solid's surface.
        solid.write_text(cube("0.999", "7.001"))
        flat = self.micro("--model", solid, counts="8,8,8")["bridges"]
        self.assertEqual((flat["caps"], flat["built"], flat["dropped"]["flat"]), (216, 0, 216))

    def test_free_caps_are_swept_to_the_skin_of_the_model(self):
        solid, mesh = self.folder / "cube.off", self.folder / "out.ply"
        solid.write_text(cube("0.5", "7.5"))
        report = self.micro("--model", solid, "--bridge", "space", "--mesh", mesh, "--chord", "0.05", counts="8,8,8")
        bridges = report["bridges"]
        self.assertEqual((report["tiles"]["kept"], bridges["caps"], bridges["built"], sum(bridges["dropped"].values())), (216, 216, 216, 0))
        self.assertLess(bridges["kink_degrees"]["hi"], 1e-3)
        self.assertTrue(0 < bridges["reach"]["lo"] <= bridges["reach"]["hi"] <= 0.07 * 3**0.5, bridges)
        written = json.loads(self.out.read_text())
        self.assertEqual((len(written["sweeps"]), "bridges" in written), (216, False))
        file = support.only_file(mesh)
        self.assertEqual((file["verdict"], file["counts"]["shells"], file["counts"]["genus"]), ("VALID", 1, report["genus"]))
        sha = report["output"]["sha256"]
        for jobs in (1, 3):
            again = self.micro("--model", solid, "--bridge", "space", "--jobs", jobs, counts="8,8,8")
            self.assertEqual(again["output"]["sha256"], sha)
        near = self.micro("--model", solid, "--bridge", "space", "--alpha", "1/3", "--skin", "0.01", counts="8,8,8")
        self.assertLessEqual(near["bridges"]["reach"]["hi"], 0.01)
        held = self.micro("--model", solid, "--bridge", "space", "--connected", counts="8,8,8")
        self.assertEqual((held["tiles"]["kept"], held["tiles"]["floating"]), (216, 0))
        for arguments in ((), ("--model", solid)):
            decided = json.loads(run("certify", self.out, *arguments, "--no-check", "--json", "-").stdout)["files"][0]
            self.assertEqual((decided["verdict"], decided["counts"]["bridges"], decided["counts"]["genus"]), ("VALID", 216, report["genus"]))
        self.assertIn("216 bridges in space", run("info", self.out).stdout)

    def test_sweeps_begin_with_a_kink_in_a_sheared_cage(self):
        # (u + w / 2, v, w): the lines of w meet the walls at 90 - 26.565 degrees, and sweeps begin along the normal.
        sheared = json.loads(self.box.read_text())
        shape = sheared["entities"][0]["shape"]
        shape["points"] = [[str(Fraction(x) + Fraction(z) / 2), y, z] for x, y, z in shape["points"]]
        cage, solid = self.folder / "sheared.vjson", self.folder / "cube.off"
        cage.write_text(json.dumps(sheared))
        solid.write_text(cube("4.2", "7.8"))
        report = self.micro("--model", solid, "--bridge", "space", tile="branch,arms=w0+w1", cage=cage, counts="8,8,16")
        self.assertGreater(report["bridges"]["built"], 10)
        kink = report["bridges"]["kink_degrees"]
        self.assertAlmostEqual(kink["lo"], 26.565051177, 4)
        self.assertAlmostEqual(kink["hi"], 26.565051177, 4)
        domain = self.micro("--model", solid, tile="branch,arms=w0+w1", cage=cage, counts="8,8,16")
        self.assertEqual(domain["bridges"]["kink_degrees"], {"lo": 0, "hi": 0})

    def test_parts_that_no_bridge_holds_are_floating(self):
        solid = self.folder / "cube.off"
        solid.write_text(cube("0.999", "7.001"))
        report = self.micro("--model", solid, "--connected", counts="8,8,8")
        self.assertEqual((report["tiles"]["kept"], report["tiles"]["floating"]), (0, 216))
        solid.write_text(cube("0.5", "7.5"))
        report = self.micro("--model", solid, "--connected", counts="8,8,8")
        self.assertEqual((report["tiles"]["kept"], report["tiles"]["floating"]), (216, 0))

    def test_bridges_need_a_model(self):
        solid = self.folder / "cube.off"
        solid.write_text(cube(1, 7))
        for arguments, why in ((["--bridge", "domain"], "--bridge domain needs --model"), (["--alpha", "1/2"], "which need --model"),
                               (["--skin", "1"], "which need --model"), (["--bridge", "space"], "--bridge space needs --model"),
                               (["--bridge", "spaces", "--model", solid], "must be domain, space or none, not spaces"),
                               (["--model", solid, "--bridge", "none", "--skin", "1"], "--bridge none builds none"),
                               (["--model", solid, "--alpha", "0"], "needs a number over 0"), (["--model", solid, "--alpha", "3/2"], "needs a number over 0")):
            done = run("micro", "--cage", self.box, "--tile", "jack", "--counts", "4,4,4", "-o", self.out, *arguments)
            self.assertEqual(done.returncode, 2, done)
            self.assertIn(why, " ".join(done.stderr.split()))
        self.assertFalse(self.out.exists())

    def test_thickness_is_a_number_of_each_wall(self):
        report = self.micro("--thickness", "1/8+1/20*sin(x)*cos(3*v)")
        self.assertEqual(report["genus"], 2 * 64 - 3 * 16 + 1)
        walls = json.loads(self.out.read_text())["walls"][0]
        self.assertEqual([len(axis) for axis in walls], [80, 80, 80])
        self.assertGreater(len(set(walls[0])), 10)
        report = self.micro("--thickness", "x/8", expect=1)
        self.assertEqual(report["defects"][0]["code"], "thickness")
        self.assertIn("is not between", report["defects"][0]["message"])

    def test_arms_are_left_out_where_the_cage_is_collapsed(self):
        cone = self.volumes("cone", {"op": "cone", "bottom": 2, "top": 0, "height": 3})
        report = self.micro(cage=cone, counts="2,2,2")
        self.assertEqual((report["tiles"]["total"], report["kinds"], report["components"]), (40, 2, 1))

    def test_a_torus_is_glued_to_itself(self):
        torus = self.volumes("torus", {"op": "torus", "major": 3, "minor": 1})
        report = self.micro(cage=torus, counts="2,2,6")
        self.assertEqual((report["tiles"]["total"], report["components"]), (5 * 24, 1))

    def test_cages_models_and_tiles_that_are_wrong_are_refused(self):
        folded = self.folder / "folded.vjson"
        text = json.loads(self.box.read_text())
        text["entities"][0]["shape"]["points"][7] = ["1", "1", "1"]
        folded.write_text(json.dumps(text))
        self.assertEqual(self.micro(cage=folded, expect=1)["defects"][0]["code"], "cage")
        outside = self.folder / "outside.off"
        outside.write_text(cube(1, 9))
        defect = self.micro("--model", outside, expect=1)["defects"][0]
        self.assertEqual(defect["code"], "cage")
        self.assertIn("does not lie inside of the cage", defect["message"])
        open_mesh = self.folder / "open.off"
        open_mesh.write_text(cube(1, 7).replace("8 6 0", "8 5 0").replace("4 1 3 7 5\n", ""))
        self.assertEqual(self.micro("--model", open_mesh, expect=1)["defects"][0]["code"], "model")
        self.assertEqual(self.micro(tile="jack,node=1/20,cap=9/20", expect=1)["defects"][0]["code"], "F3")

    def test_meshes_are_solids_with_the_numbers_of_the_microstructure(self):
        torus = self.volumes("torus", {"op": "torus", "major": 3, "minor": 1})
        for ending in ("ply", "stl", "obj", "off"):
            mesh = self.folder / f"m.{ending}"
            report = self.micro("--mesh", mesh, "--chord", "0.05", cage=torus, counts="1,1,4")
            file = support.only_file(mesh)
            self.assertEqual((file["verdict"], file["sha256"]), ("VALID", report["mesh"]["file"]["sha256"]))
            self.assertEqual((file["counts"]["genus"], file["counts"]["shells"]), (report["genus"], report["shells"]))
            self.assertEqual(file["counts"]["faces"], report["mesh"]["facets"])
            self.assertLessEqual(report["mesh"]["distance"], 0.05)
        finer = self.micro("--mesh", mesh, "--chord", "0.025", cage=torus, counts="1,1,4")
        self.assertEqual(finer["genus"], report["genus"])
        self.assertGreater(finer["mesh"]["facets"], report["mesh"]["facets"])

    def test_an_empty_microstructure_is_written_without_a_mesh(self):
        solid, mesh = self.folder / "small.off", self.folder / "m.ply"
        solid.write_text(cube("0.3", "0.5"))
        report = self.micro("--model", solid, "--mesh", mesh, "--chord", "0.1")
        self.assertEqual((report["tiles"]["kept"], report["mesh"], report["components"]), (0, None, 0))
        self.assertFalse(mesh.exists())

    def test_limits_and_wrong_usage(self):
        base = ["micro", "--cage", self.box, "--tile", "jack", "-o", self.out, "--counts"]
        self.assertEqual(run(*base, "2,2,2", "--max-tiles", 8).returncode, 0)
        self.out.unlink()
        self.assertEqual(run(*base, "2,2,2", "--max-tiles", 7).returncode, 4)
        for counts in ("0,1,1", "1,1", "1,1,1,1", "a,1,1", "", "1,1,99999999999999999999"):
            self.assertEqual(run(*base, counts).returncode, 2, counts)
        for tile in ("ball", "jack,node", "jack,node=1/2", "jack,cap=0", "jack,degree=2", "jack,size=1", ""):
            self.assertEqual(run("micro", "--cage", self.box, "--tile", tile, "-o", self.out, "--counts", "1,1,1").returncode, 2, tile)
        for formula in ("1+", "q", "sin x"):
            self.assertEqual(run(*base, "1,1,1", "--thickness", formula).returncode, 2, formula)
        for mesh in (["--mesh", "m.ply"], ["--chord", "1"], ["--mesh", "m.xyz", "--chord", "1"], ["--mesh", "m.ply", "--chord", "0"]):
            self.assertEqual(run(*base, "1,1,1", *mesh).returncode, 2, mesh)
        for option in (["--list", self.out], ["--mesh", self.out.with_suffix(".ply"), "--chord", "1", "--list", self.out.with_suffix(".ply")],
                       ["--list", self.box], ["--json", self.out]):
            self.assertEqual(run(*base, "1,1,1", *option).returncode, 2, option)
        self.assertEqual(run("micro", "--cage", self.folder / "none.vjson", "--tile", "jack", "--counts", "1,1,1", "-o", self.out).returncode, 4)
        self.assertFalse(self.out.exists())
        done = run("micro", "--cage", self.box, "--tile", "jack", "--counts", "1,1,1", "-o", "-")
        self.assertTrue(done.stdout.startswith('{"format": "veritope-micro-1"'))


if __name__ == "__main__":
    unittest.main()
