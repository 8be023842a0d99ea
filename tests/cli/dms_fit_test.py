#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope dms fit: fits beside exact evaluations of the models that it writes, what it refuses, its page and its report."""
import json
import random
import re
import unittest
from fractions import Fraction as F

import schema
from support import MODELS, ROOT, Folder, run

DOMAIN = MODELS / "dms" / "domain.vdms"


def points(count, seed):
    """Points of the unit tetrahedron, on a lattice."""
    draw = random.Random(seed)
    out = []
    while len(out) < count:
        p = [F(draw.randrange(17), 16) for _ in range(3)]
        if sum(p) <= 1:
            out.append(p)
    return out


def text_of(rows):
    return "".join(" ".join(str(x) for x in row) + "\n" for row in rows)


class DmsFit(Folder):
    def setUp(self):
        super().setUp()
        (self.folder / "domain.vdms").write_bytes(DOMAIN.read_bytes())

    def fit(self, rows, *options, status=0):
        done = run("dms", "fit", "-", "-o", "out.vdms", "--domain", "domain.vdms", *options, "--json", "-", input=text_of(rows), cwd=self.folder)
        self.assertEqual(done.returncode, status, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(list(document), schema.keys_of("dms_fit"))
        return document

    def exact_values(self, rows):
        done = run("dms", "eval", "out.vdms", "-", "--exact", input=text_of(row[:3] for row in rows), cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        return [[F(x) for x in line.split()] for line in done.stdout.splitlines()]

    def refused(self, text, *options, status=4):
        done = run("dms", "fit", "-", "-o", "out.vdms", "--domain", "domain.vdms", "--degree", "2", *options, input=text, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (status, ""), done)
        self.assertFalse((self.folder / "out.vdms").exists())
        return " ".join(done.stderr.split())

    def test_the_page_shows_what_the_program_prints(self):
        rows = [p + [(p[0] - p[1]) ** 3 + p[2] ** 2] for p in points(60, 1)]
        (self.folder / "data.txt").write_text(text_of(rows))
        page = (ROOT / "docs" / "cli" / "dms-fit.md").read_text()
        command, answer = page.split("```\n")[1].removeprefix("$ ").split("\n", 1)
        done = run(*command.split()[1:], cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr, done.stdout), (0, "", answer))

    def test_errors_are_those_of_the_model_as_written(self):
        rows = [p + [abs(p[0] - F(1, 4)), p[1] * p[2] * p[0]] for p in points(150, 2)]
        report = self.fit(rows, "--degree", "2", "--max-tetrahedra", "30")
        self.assertEqual((report["points"], report["outside"], report["conflicts"], report["end"], report["reached"]), (150, 0, 0, "budget", None))
        self.assertLessEqual(report["tetrahedra"], 30)
        values = self.exact_values(rows)
        for a, (mse, most) in enumerate(zip(report["attribute_mse"], report["max_error"])):
            errors = [abs(value[3 + a] - row[3 + a]) for value, row in zip(values, rows)]
            exact = sum(e * e for e in errors) / len(rows)
            self.assertTrue(exact <= F(mse) <= exact * (1 + F(1, 10**6)))
            self.assertTrue(max(errors) <= F(most) <= max(errors) * (1 + F(1, 10**6)))
        self.assertTrue(all(value[:3] == row[:3] for value, row in zip(values, rows)))
        self.assertLessEqual(report["geometry_mse"], 1e-20)
        model = json.loads((self.folder / "out.vdms").read_text())
        self.assertEqual(model["attributes"], report["attributes"])
        self.assertEqual((len(model["tetrahedra"]), len(model["control"])), (report["tetrahedra"], report["control_points"]))
        self.assertEqual(sum(map(len, model["vertices"])), report["knots"])
        self.assertEqual(report["rounds"][-1]["tetrahedra"], report["tetrahedra"])

    def test_polynomials_of_the_degree_are_reproduced(self):
        for degree in 1, 2, 3:
            rows = [p + [(p[0] - 2 * p[1] + p[2] / 3 + 1) ** degree] for p in points(400, degree)]
            report = self.fit(rows, "--degree", str(degree), "--tolerance", "1e-18")
            self.assertLessEqual(report["attribute_mse"][0], 1e-18)
            self.assertEqual((report["reached"], report["end"], report["undetermined"]), (True, "tolerance", 0))

    def test_tolerances_are_decimals_fractions_and_hexadecimal_numbers(self):
        rows = [p + [abs(p[0] - F(1, 4))] for p in points(300, 4)]
        for text in "0.0009765625", "1/1024", "0x1p-10":
            report = self.fit(rows, "--degree", "1", "--tolerance", text)
            self.assertEqual((report["tolerance"], report["reached"]), (2**-10, True))
        (self.folder / "out.vdms").unlink()
        for text in "0", "-1/2", "1/0", "1e301", "nan", "x":
            self.assertIn(f"--tolerance: must be a mean square error from 1e-300 to 1e300, not {text}",
                          self.refused(text_of(rows), f"--tolerance={text}", status=2))

    def test_a_tolerance_that_is_not_reached_is_status_3(self):
        rows = [p + [abs(p[0] - F(1, 4))] for p in points(300, 4)]
        report = self.fit(rows, "--degree", "1", "--tolerance", "1e-12", "--max-tetrahedra", "20", status=3)
        self.assertEqual((report["reached"], report["end"]), (False, "budget"))
        self.assertTrue((self.folder / "out.vdms").exists())
        rows.append(rows[7][:3] + [F(5)])
        report = self.fit(rows, "--degree", "1", "--tolerance", "1e-12", "--max-tetrahedra", "500", status=3)
        self.assertEqual(report["conflicts"], 1 + sum(row[:3] == rows[7][:3] for row in rows[:-1]))
        self.assertIn(7, report["conflict_points"])

    def test_points_outside_and_control_points_without_data_are_listed(self):
        rows = [[F(1, 10), F(1, 10), F(1, 10), F(2)], [F(2), F(0), F(0), F(9)], [F(0), F(0), F(-1, 10**12), F(9)]]
        report = self.fit(rows, "--degree", "2")
        self.assertEqual((report["outside"], report["outside_points"]), (2, [1, 2]))
        self.assertGreater(report["undetermined"], 0)
        self.assertEqual(report["undetermined"], len(report["undetermined_control"]))
        self.assertLessEqual(report["attribute_mse"][0], 1e-18)

    def test_free_knots_are_not_worse_and_models_stay_sound(self):
        rows = [p + [abs(p[0] + p[1] / 2 - F(1, 3))] for p in points(200, 5)]
        fixed = self.fit(rows, "--degree", "2", "--max-tetrahedra", "16")
        free = self.fit(rows, "--degree", "2", "--max-tetrahedra", "16", "--knots", "free", "--feature", "1,0,0,1/4")
        self.assertLess(free["attribute_mse"][0], fixed["attribute_mse"][0])
        values = self.exact_values(rows)
        self.assertTrue(all(value[:3] == row[:3] for value, row in zip(values, rows)))
        done = run("certify", "out.vdms", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)

    def test_the_same_input_gives_the_same_bytes(self):
        rows = [p + [p[0] ** 4] for p in points(100, 6)]
        files = []
        for _ in range(2):
            self.fit(rows, "--degree", "2", "--max-tetrahedra", "40", "--knots", "free")
            files.append((self.folder / "out.vdms").read_bytes())
        self.assertEqual(files[0], files[1])

    def test_bad_data_are_refused_with_their_place(self):
        self.assertIn("standard input:2: column 7: 'nan' is not finite", self.refused("0 0 0 1\n0 0 0 nan\n"))
        self.assertIn("standard input:2: column 6: each line has as many numbers as the first one, 4, but there are 3", self.refused("0 0 0 1\n0 0 0\n"))
        self.assertIn("a line has at least 4 numbers, but there are 3", self.refused("0 0 0\n"))
        self.assertIn("there are no data", self.refused("# nothing\n"))
        self.assertIn("standard input:2: number 4 is beyond binary64", self.refused("0 0 0 1\n0 0 0 1e309\n"))
        self.assertIn("no point lies in the closed domain", self.refused("5 5 5 1\n", status=1))
        self.assertIn("more than --max-tetrahedra 1", self.refused("0 0 0 1\n", "--max-tetrahedra", "1"))

    def test_wrong_usage(self):
        for options, what in ((["--knots", "loose"], "must be free or fixed"), (["--feature", "1,2,3"], "must be four numbers"),
                              (["--feature", "0,0,0,1"], "three zeros"), ([], "--degree N is required")):
            degree = ["--degree", "2"] if options else []
            done = run("dms", "fit", "d", "-o", "out.vdms", "--domain", "domain.vdms", *degree, *options, cwd=self.folder)
            self.assertEqual(done.returncode, 2, done)
            self.assertIn(what, done.stderr)
        done = run("dms", "fit", "d", "-o", "out.vdms", "--degree", "2", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--domain D.vdms is required", done.stderr)
        done = run("dms", "fit", "d", "-o", "out.vdms", "--degree", "2", "--auto", "--domain", "domain.vdms", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--auto makes the domain, so it excludes --domain", " ".join(done.stderr.split()))

    def automatic(self, rows, *options, status=0):
        done = run("dms", "fit", "-", "-o", "out.vdms", "--auto", *options, "--json", "-", input=text_of(rows), cwd=self.folder)
        self.assertEqual(done.returncode, status, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(list(document), schema.keys_of("dms_fit"))
        self.assertIsNone(document["domain"])
        return document

    def test_data_that_fill_a_cube_get_its_eight_corners(self):
        rows = [[F(x, 4), F(y, 4), F(z, 4), F(x * x - y * z, 16)] for x in range(7) for y in range(7) for z in range(7)]
        report = self.automatic(rows, "--degree", "2")
        self.assertEqual((report["auto"]["kind"], report["auto"]["vertices"], report["auto"]["spacing"]), ("hull", 8, .25))
        self.assertEqual((report["points"], report["outside"], report["tetrahedra"]), (343, 0, report["auto"]["tetrahedra"]))
        self.assertLessEqual(report["attribute_mse"][0], 1e-18)

    def test_data_with_a_tunnel_get_a_domain_with_one(self):
        draw = random.Random(8)
        rows = []
        for x, y, z in ((x, y, z) for x in range(-9, 10) for y in range(-9, 10) for z in range(-3, 4)):
            if ((x * x + y * y)**.5 - 6)**2 + z * z <= 9:
                p = [n * F(1, 5) + F(draw.randrange(-20, 21), 1000) for n in (x, y, z)]
                rows.append(p + [abs(p[0] - F(1, 3))])
        report = self.automatic(rows, "--degree", "2", "--max-tetrahedra", "4000", "--tolerance", "1e-3")
        self.assertEqual((report["auto"]["kind"], report["outside"], report["reached"]), ("occupancy", 0, True))
        self.assertGreaterEqual(report["tetrahedra"], report["auto"]["tetrahedra"])
        values = self.exact_values(rows)
        self.assertTrue(all(value[:3] == row[:3] for value, row in zip(values, rows)))
        done = run("certify", "out.vdms", "--json", "c.json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        file = json.loads((self.folder / "c.json").read_text())["files"][0]
        self.assertEqual([s["genus"] for s in file["shells"]], [1])

    def test_data_without_a_domain_are_refused(self):
        for rows, why in (([[x, y, 0, 1] for x in range(3) for y in range(3)], "lie in one plane"), ([[0, 0, 0, 1], [1, 0, 0, 1]], "needs four points")):
            done = run("dms", "fit", "-", "-o", "out.vdms", "--auto", "--degree", "2", input=text_of(rows), cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (1, ""), done)
            self.assertIn(why, " ".join(done.stderr.split()))
            self.assertFalse((self.folder / "out.vdms").exists())
        cube = [[x, y, z, x] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        done = run("dms", "fit", "-", "-o", "out.vdms", "--auto", "--degree", "2", "--max-tetrahedra", "1", input=text_of(cube), cwd=self.folder)
        self.assertEqual(done.returncode, 4, done)
        self.assertIn("more than --max-tetrahedra 1", " ".join(done.stderr.split()))

    def test_domains_with_defects_or_of_another_kind_are_refused(self):
        model = json.loads(DOMAIN.read_text())
        model["tetrahedra"][0][:2] = reversed(model["tetrahedra"][0][:2])
        (self.folder / "domain.vdms").write_text(json.dumps(model))
        report = self.fit([[0, 0, 0, 1]], "--degree", "2", status=1)
        self.assertEqual([d["code"] for d in report["defects"]][:1], ["tet-reversed"])
        self.assertIsNone(report["attribute_mse"])
        (self.folder / "domain.vdms").write_bytes((MODELS / "dms" / "tetrahedron.vdms").read_bytes())
        self.assertIn("a domain must have degree 1", self.refused("0 0 0 1\n", status=1))


if __name__ == "__main__":
    unittest.main()
