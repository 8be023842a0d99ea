#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope chain: counts, hypotheses, origins, statuses."""
import json
import re
import unittest
from fractions import Fraction

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    from vtkmodules.vtkCommonCore import reference as vtkReference
except ImportError:
    vtkXMLUnstructuredGridReader = vtkReference = None

import schema
import support
from support import MODELS, Folder, run

CUBE = MODELS / "patches" / "cube.itd"
TETRAHEDRON = "OFF\n4 4 0\n0 0 0\n3 0 0\n0 2 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"


OCTAHEDRON = [[(-1) ** i, (-1) ** j, (-1) ** k] for i in (0, 1) for j in (0, 1) for k in (0, 1)]


def pn_octahedron():
    """Cubic triangles over an octahedron, with normals along the positions."""
    entities = []
    for signs in OCTAHEDRON:
        corners = [[signs[a] if a == b else 0 for b in range(3)] for a in range(3)]
        if signs[0] * signs[1] * signs[2] < 0:
            corners[1], corners[2] = corners[2], corners[1]
        points = []
        for i in (3, 2, 1, 0):
            for j in range(3 - i, -1, -1):
                k = 3 - i - j
                weights = (Fraction(1, 2),) * 3 if i == j == k else tuple({3: Fraction(1), 2: Fraction(1), 1: Fraction(1, 3), 0: Fraction(0)}[n] for n in (i, j, k))
                points.append([str(sum(w * c[axis] for w, c in zip(weights, corners))) for axis in range(3)])
        entities.append({"kind": "triangle", "group": None, "attributes": [], "shape": {"degree": 3, "rational": False, "components": 3, "points": points}})
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities})


class Chain(Folder):
    def chain(self, *arguments):
        done = run("chain", *arguments, "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        return document

    def file(self, name, content):
        (self.folder / name).write_text(content)
        return self.folder / name

    def test_the_simplices_of_a_tetrahedron_from_inside_outside_and_a_corner(self):
        model = self.file("t.off", TETRAHEDRON)
        for origin, signs in [("0,0,0", (1, 0, 3)), ("1/2,1/2,1/4", (4, 0, 0)), ("0x1p3,0,0", (1, 1, 2)), ("-1,-1,-1", (1, 3, 0))]:
            document = self.chain(model, "--origin", origin)
            self.assertEqual(tuple(document["simplices"].values()), signs, origin)
            self.assertEqual(document["free_form"], {"plus": 0, "minus": 0, "zero": 4, "mixed": 0, "undecided": 0})
            self.assertEqual([Fraction(x) for x in document["origins"][0]["origin"]], [Fraction(8) if x.startswith("0x") else Fraction(x) for x in origin.split(",")])

    def test_auto_is_the_cheapest_origin_of_the_table(self):
        document = self.chain(MODELS / "valid_frame.off", "--origin", "auto")
        costs = [o["cell_tests"] for o in document["origins"]]
        self.assertEqual(costs[0], min(costs))
        self.assertLess(costs[0], self.chain(MODELS / "valid_frame.off")["origins"][0]["cell_tests"])

    def test_origins_stand_once(self):
        for origin in ("0,0,0", "auto", "1/2,1/2,1/2"):
            points = [tuple(o["origin"]) for o in self.chain(CUBE, "--origin", origin)["origins"]]
            self.assertEqual(len(points), len(set(points)))

    def test_the_text_has_the_numbers_of_the_json(self):
        text = run("chain", MODELS / "valid_frame.off").stdout
        document = self.chain(MODELS / "valid_frame.off")
        self.assertIn("%(plus)d plus, %(minus)d minus, %(zero)d zero" % document["simplices"], text)
        self.assertIn(f"fail at {document['literal']['planes_share_lines']['violations']} of 16 vertices; {document['literal']['planes_share_lines']['first']}",
                      re.sub(r"\s+", " ", text))

    def test_models_that_are_not_valid_have_no_chain(self):
        for model, status in [(support.INVALID, 1), (MODELS / "patches" / "not_certified_smallest.vjson", 3), (support.UNREADABLE, 4)]:
            done = run("chain", model, "--json", "r.json", cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout, self.listing()), (status, "", []))
            self.assertIn("no chain is made", re.sub(r"\s+", " ", done.stderr))

    def test_the_assumptions_of_the_paper_hold_for_the_octahedron(self):
        document = self.chain(self.file("o.vjson", pn_octahedron()))
        self.assertEqual(document["free_form"], {"plus": 8, "minus": 0, "zero": 0, "mixed": 0, "undecided": 0})
        self.assertEqual(document["literal"], {name: {"holds": True, "violations": 0, "first": None} for name in ("planes_share_lines", "curves_in_planes", "graphs")})
        self.assertEqual(document["origins"][0]["cell_tests"], 2)

    def test_the_literal_f_is_the_winding_number_for_the_octahedron(self):
        model = self.file("o.vjson", pn_octahedron())
        points = self.file("p.txt", "".join(f"{3 * i}/19 {3 * j}/23 {3 * k}/29\n" for i in range(-7, 8) for j in range(-7, 8) for k in range(-7, 8) if i * j * k))
        truth = [line.split()[4] for line in run("classify", model, points).stdout.splitlines()]
        self.assertGreater(truth.count("1"), 500)
        for origin in ("0,0,0", "1/7,-5,0x1p-2", "auto"):
            lines = [line.split() for line in run("classify", model, points, "--by", "literal", "--origin", origin).stdout.splitlines()]
            self.assertEqual([line[4] for line in lines], truth)
            self.assertEqual({(line[3], line[4] == line[5]) for line in lines}, {("-", True)})

    def test_the_literal_f_on_walls(self):
        model = self.file("o.vjson", pn_octahedron())
        points = self.file("p.txt", "1/3 1/3 1/3\n0 0 1\n0 0 0\n1/2 1/2 0\n2 0 0\n")
        self.assertEqual(run("classify", model, points, "--by", "literal").stdout,
                         "1/3 1/3 1/3 - 2 2\n0 0 1 - 8 -\n0 0 0 - 8 8\n1/2 1/2 0 - 4 4\n2 0 0 - 0 0\n")

    def test_the_page_shows_what_the_example_prints(self):
        printed = (support.ROOT / "examples" / "literal_chain" / "expected.txt").read_text()
        self.assertIn(printed, (support.ROOT / "docs" / "cli" / "chain.md").read_text())

    def test_the_cells_for_viewers(self):
        model = self.file("o.vjson", pn_octahedron())
        done = run("chain", model, "--origin", "2,0,0", "-o", self.folder / "cells.vtu")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = (self.folder / "cells.vtu").read_text()

        def array(name):
            return re.search(rf'Name="{name}"[^>]*>\n([^<]*)<', text).group(1).split()
        self.assertEqual(array("kind"), ["0"] * 8 + ["1"] * 8)
        self.assertEqual(sorted(array("coefficient")), ["-1"] * 4 + ["1"] * 12)
        self.assertEqual(array("types"), ["10"] * 8 + ["80"] * 8)
        self.assertEqual(array("patch"), [str(i) for i in range(8)] * 2)
        self.assertEqual(len(array("connectivity")), 8 * 4 + 8 * 20)
        self.assertEqual(run("chain", model, "-o", self.folder / "none" / "c.vtu").returncode, 4)

    @unittest.skipUnless(vtkXMLUnstructuredGridReader, "VTK for Python is not installed")
    def test_vtk_finds_the_patch_at_the_upper_end_of_a_cell(self):
        model = self.file("o.vjson", pn_octahedron())
        run("chain", model, "-o", self.folder / "cells.vtu")
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.folder / "cells.vtu"))
        reader.Update()
        cell = reader.GetOutput().GetCell(8)
        for parameters, expected in [((0, 0, 1), (1, 0, 0)), ((1, 0, 1), (0, 1, 0)), ((0, 1, 1), (0, 0, 1)), ((0.5, 0.5, 1), (0, 5 / 8, 5 / 8)),
                                     ((0.5, 0.5, 0), (0, 0.5, 0.5)), ((1 / 3, 1 / 3, 1), (4 / 9, 4 / 9, 4 / 9))]:
            point, weights, piece = [0.0] * 3, [0.0] * cell.GetNumberOfPoints(), vtkReference(0)
            cell.EvaluateLocation(piece, parameters, point, weights)
            for x, y in zip(point, expected):
                self.assertAlmostEqual(x, y, places=12)

    def test_a_cell_that_definition_1_does_not_accept_is_named(self):
        """A tetrahedron whose upper face hangs down to below the point where the planes of its sides meet."""
        def flat(*corners):
            return {"degree": 1, "rational": False, "components": 3, "points": [list(map(str, c)) for c in corners]}
        a, b, c, d = (0, 0, 0), (1, 0, 0), (0, 1, 0), ("1/4", "1/5", -2)
        deep = {"degree": 3, "rational": False, "components": 3, "points": [
            [0, 0, 0], ["1/3", 0, 0], [0, "1/3", 0], ["2/3", 0, 0], ["1/3", "1/3", "-2/3"], [0, "2/3", 0], [1, 0, 0], ["2/3", "1/3", 0], ["1/3", "2/3", 0], [0, 1, 0]]}
        deep["points"] = [list(map(str, p)) for p in deep["points"]]
        shapes = [deep, flat(b, a, d), flat(c, b, d), flat(a, c, d)]
        entities = [{"kind": "triangle", "group": None, "attributes": [], "shape": shape} for shape in shapes]
        model = self.file("deep.vjson", json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities}))
        document = self.chain(model)
        self.assertEqual(document["free_form"]["minus"], 1)
        self.assertEqual([(r["figure"], r["cell"][:23]) for r in document["cells"]["refused"]], [("3a", "triangle 0, minus part:")])
        self.assertIn("refused      as in figure 3a: triangle 0, minus part: the planes of the three sides meet at", re.sub(r"\n +", " ", run("chain", model).stdout))

    @unittest.skipUnless(support.DATA.is_dir(), "needs VERITOPE_DATA")
    def test_the_assumptions_hold_for_a_real_sphere_and_there_f_is_the_winding_number(self):
        model = support.DATA / "cad" / "mfem__ball-nurbs.mesh"
        document = self.chain(model, "--no-check")
        self.assertEqual([h["holds"] for h in document["literal"].values()], [True] * 3)
        points = self.file("p.txt", "".join(f"{200 * i + 7}/1700 {200 * j + 11}/1900 {200 * k + 13}/2300\n"  # off walls
                                            for i in range(-8, 9) for j in range(-8, 9) for k in range(-8, 9, 3)))
        truth, literal = ([line.split()[4] for line in run("classify", "--no-check", model, points, *options, timeout=600).stdout.splitlines()]
                          for options in ((), ("--by", "literal", "--origin", "1/101,1/103,1/107")))
        self.assertGreater(truth.count("1"), 200)
        self.assertEqual(truth, literal)

    @unittest.skipUnless(support.DATA.is_dir(), "needs VERITOPE_DATA")
    def test_what_an_origin_costs_for_a_real_mesh(self):
        document = self.chain(support.DATA / "mesh" / "solid1" / "thingiCSG__bunny_remap.off", "--no-check")
        costs = [o["cell_tests"] for o in document["origins"]]
        self.assertEqual(len(costs), 5)
        self.assertLess(12 * costs[4], costs[0])    # auto, 0,0,0
        self.assertLess(costs[4], 0.75 * costs[1])  # the centre

    def test_the_report_does_not_depend_on_the_number_of_threads(self):
        reports = {run("chain", CUBE, "--json", "-", "--jobs", jobs).stdout for jobs in (1, 2, 3)}
        self.assertEqual(len(reports), 1)


if __name__ == "__main__":
    support.main()
