#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope micro: microstructures that certify accepts, and refusals that leave nothing behind."""
import json
import unittest

import schema
import support
from support import run

def cube(low, high):
    """The cube [low, high]^3."""
    ends = (low, high)
    return "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for z in ends for y in ends for x in ends) + (
        "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")


class MicroCommand(support.Folder):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out.vmicro"
        self.box = self.tree("box", {"op": "box", "min": [0, 0, 0], "max": [8, 8, 8]})

    def tree(self, name, root):
        tree, volumes = self.folder / f"{name}.json", self.folder / f"{name}.vjson"
        tree.write_text(json.dumps({"format": "veritope-tree-1", "root": root}))
        self.assertEqual(run("build", tree, "-o", volumes).returncode, 0)
        return volumes

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
        for key in ("glued_caps", "components", "shells", "genus"):
            self.assertEqual(file["counts"][key], report[key], key)
        return report

    def test_a_block_of_jacks_has_the_genus_of_its_graph(self):
        for tile in ("jack", "jack,degree=1", "jack,node=1/4,cap=0.2"):
            report = self.micro(tile=tile, counts="3,4,5")
            self.assertEqual((report["tiles"]["total"], report["genus"]), (60, 2 * 60 - 12 - 20 - 15 + 1))

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

    def test_only_the_largest_part_is_kept_if_it_is_asked_for(self):
        solid, listed = self.folder / "two.off", self.folder / "cells.csv"
        # Two cubes: 4 x 4 x 4 cells lie in the one, and one in the other.
        first, second = cube("0.5", "5.5").splitlines(), cube("5.7", "7.3").splitlines()
        faces = ["4 " + " ".join(str(int(i) + 8) for i in line.split()[1:]) for line in second[10:]]
        solid.write_text("\n".join(["OFF", "16 12 0", *first[2:10], *second[2:10], *first[10:], *faces]) + "\n")
        both = self.micro("--model", solid, counts="8,8,8")
        self.assertEqual((both["tiles"]["kept"], both["components"]), (65, 2))
        one = self.micro("--model", solid, "--connected", "--list", listed, counts="8,8,8")
        self.assertEqual((one["tiles"]["kept"], one["tiles"]["floating"], one["components"]), (64, 1, 1))
        self.assertIn("0,6,6,6,floating", listed.read_text().splitlines())

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
        cone = self.tree("cone", {"op": "cone", "bottom": 2, "top": 0, "height": 3})
        report = self.micro(cage=cone, counts="2,2,2")
        self.assertEqual((report["tiles"]["total"], report["kinds"], report["components"]), (40, 2, 1))

    def test_a_torus_is_glued_to_itself(self):
        torus = self.tree("torus", {"op": "torus", "major": 3, "minor": 1})
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
        torus = self.tree("torus", {"op": "torus", "major": 3, "minor": 1})
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
