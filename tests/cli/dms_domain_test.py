#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope dms domain: hulls and occupancy domains of points, their certificates, reports and refusals."""
import itertools
import json
import math
import random
import re
import unittest
from fractions import Fraction as F

import schema
from support import ROOT, Folder, only_file, run


def det(a, b, c, d):
    u, v, w = ([x - y for x, y in zip(p, a)] for p in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]))


def text(points):
    return "".join(" ".join(map(str, p)) + "\n" for p in points)


def volume6(model):
    places = [[F(x) for x in cloud[0]] for cloud in model["vertices"]]
    return sum(det(*(places[v] for v in t)) for t in model["tetrahedra"])


def shell_scan(seed, inner, outer, distance):
    """Points of a ball with a cavity, or of a ball, at least a distance apart, moved a little."""
    rng = random.Random(seed)
    out = []
    for _ in range(int(60 * (outer / distance) ** 3)):
        p = [rng.uniform(-outer, outer) for _ in range(3)]
        if inner <= math.hypot(*p) <= outer and all(math.dist(p, q) >= distance for q in out):
            out.append(p)
    return [[x + rng.uniform(-.05, .05) * distance for x in p] for p in out]


class DmsDomain(Folder):
    def domain(self, points, *options, status=0):
        """The report and the model."""
        done = run("dms", "domain", "-", "-o", "d.vdms", "--json", "-", *options, input=text(points), cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (status, ""), done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(list(document), schema.keys_of("dms_domain"))
        model = json.loads((self.folder / "d.vdms").read_text())
        self.assertEqual(document["vertices"], len(model["vertices"]))
        self.assertEqual(document["tetrahedra"], len(model["tetrahedra"]))
        return document, model

    def certified(self):
        file = only_file(self.folder / "d.vdms")
        self.assertEqual(file["verdict"], "VALID", file)
        return file

    def test_the_page_shows_what_the_program_prints(self):
        page = (ROOT / "docs" / "cli" / "dms-domain.md").read_text()
        block = page.split("```\n")[1]
        commands = re.split(r"(?m)^\$ ", block)[1:]
        command, answer = commands[0].split("\n", 1)
        given = command.split("'")[1].replace("\\n", "\n")
        done = run(*command.split("| veritope ")[1].split(), input=given, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (0, answer))
        done = run("certify", "hull.vdms", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)

    def test_a_grid_with_points_that_binary64_does_not_have(self):
        points = [[F(i, 3) for i in p] for p in itertools.product(range(3), repeat=3)]
        document, model = self.domain(points + points[:4], "--hull")
        self.assertEqual((document["points"], document["duplicates"], document["vertices"]), (31, 4, 27))
        self.assertEqual(volume6(model), 6 * F(8, 27))
        self.assertEqual([[F(x) for x in cloud[0]] for cloud in model["vertices"]], points)
        self.assertEqual((document["delaunay"], document["steiner"], document["removed"]), (True, 0, []))
        self.assertGreater(document["min_dihedral"], 10)
        kinds = [v["vertex_class"] for v in document["classes"]]
        self.assertEqual([kinds.count(k) for k in ("corner", "curve", "smooth")], [8, 12, 6])
        self.assertEqual([v["vertex_class_paper"] for v in document["classes"]], kinds)
        self.assertEqual(sorted(len(line) for line in document["feature_lines"]), [3] * 12)
        self.assertEqual(self.certified()["shells"][0]["genus"], 0)

    def test_random_points_have_empty_spheres_and_are_certified(self):
        rng = random.Random(3)
        points = [[rng.random() for _ in range(3)] for _ in range(60)]
        document, model = self.domain(points, "--hull")
        self.assertEqual(document["vertices"], 60)
        exact = [[F(x) for x in p] for p in points]
        self.assertEqual([[F(x) for x in cloud[0]] for cloud in model["vertices"]], [[F(str(x)) for x in p] for p in points])
        for t in model["tetrahedra"]:
            corners = [exact[v] for v in t]
            self.assertGreater(det(*corners), 0)
        self.certified()

    def test_occupancy_domains_have_the_topology_of_the_object(self):
        document, model = self.domain(shell_scan(1, 0, 1, .25))
        self.assertEqual([s["genus"] for s in self.certified()["shells"]], [0])
        points = shell_scan(1, .55, 1, .22)
        document, model = self.domain(points)
        self.assertEqual([s["genus"] for s in self.certified()["shells"]], [0, 0])
        self.assertGreater(len(document["removed"]), 0)
        self.assertLessEqual({r["why"] for r in document["removed"]}, {"middle", "sphere", "edge", "vertex", "ring", "satellite"})
        hull, _ = self.domain(points, "--hull")
        self.assertEqual(hull["tetrahedra"], document["tetrahedra"] + len(document["removed"]))

    def limits_of(self, model):
        """The largest volume, and the largest squared ratio of circumradius and shortest edge, by fractions."""
        places = [[F(x) for x in cloud[0]] for cloud in model["vertices"]]
        volume = ratio = F(0)
        for t in model["tetrahedra"]:
            a, b, c, d = (places[v] for v in t)
            six = det(a, b, c, d)
            volume = max(volume, six / 6)
            u, v, w = ([x - y for x, y in zip(p, a)] for p in (b, c, d))
            uu, vv, ww = (sum(x * x for x in p) for p in (u, v, w))
            cross = lambda p, q: [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
            centre = [(uu * x + vv * y + ww * z) / (2 * six) for x, y, z in zip(cross(v, w), cross(w, u), cross(u, v))]
            shortest = min(sum((x - y)**2 for x, y in zip(p, q)) for p, q in itertools.combinations((a, b, c, d), 2))
            ratio = max(ratio, sum(x * x for x in centre) / shortest)
        return volume, ratio

    def test_limits_of_volume_and_of_radius_over_edge(self):
        plate = [[x, y, z] for x in (0, 1) for y in (0, 4) for z in (0, F(1, 3))]
        document, model = self.domain(plate, "--hull", "--max-volume", "1/100", "--max-radius-edge", "2")
        self.assertEqual(volume6(model), 8)
        volume, ratio = self.limits_of(model)
        self.assertLessEqual(volume, F(1, 100))
        self.assertLessEqual(ratio, 4)
        refinement = document["refinement"]
        self.assertEqual((refinement["max_volume"], refinement["max_radius_edge"], refinement["end"]), ("1/100", "2", "limits"))
        self.assertEqual((refinement["over_volume"], refinement["over_radius_edge"], refinement["protected"], refinement["small_angles"]), (0, 0, 0, 0))
        self.assertEqual((document["steiner"], document["vertices"]), (refinement["inserted"], 8 + refinement["inserted"]))
        self.assertAlmostEqual(refinement["largest_volume"], float(volume), 12)
        self.assertAlmostEqual(refinement["largest_radius_edge"], math.sqrt(ratio), 9)
        self.assertEqual([[F(x) for x in cloud[0]] for cloud in model["vertices"][:8]], plate)
        self.assertTrue(all(F(x) in (0, limit) or 0 < F(x) < limit for cloud in model["vertices"] for x, limit in zip(cloud[0], (1, 4, F(1, 3)))))
        self.assertEqual(self.certified()["shells"][0]["genus"], 0)

    def test_a_budget_of_points_is_kept_and_what_was_reached_is_said(self):
        cube = [list(p) for p in itertools.product((0, 1), repeat=3)]
        document, _ = self.domain(cube, "--hull", "--max-volume", "0.02")
        needed = document["refinement"]["inserted"]
        self.assertIsInstance(document["delaunay"], bool)
        document, _ = self.domain(cube, "--hull", "--max-volume", "0.02", "--max-points", str(needed))
        self.assertEqual(document["refinement"]["end"], "limits")
        done = run("dms", "domain", "-", "-o", "d.vdms", "--hull", "--max-volume", "0.02", "--max-points", str(needed - 1), "--json", "j.json", input=text(cube), cwd=self.folder)
        self.assertEqual(done.returncode, 3, done)
        self.assertIn("the limits are not reached", done.stdout)
        self.assertIn("--max-points", done.stdout)
        document = json.loads((self.folder / "j.json").read_text())
        self.assertEqual(schema.faults(document), [])
        refinement = document["refinement"]
        self.assertEqual((refinement["end"], refinement["inserted"], refinement["max_points"]), ("budget", needed - 1, needed - 1))
        self.assertGreater(refinement["over_volume"], 0)
        model = json.loads((self.folder / "d.vdms").read_text())
        self.assertEqual(volume6(model), 6)
        self.assertAlmostEqual(refinement["largest_volume"], float(self.limits_of(model)[0]), 12)
        self.certified()

    def test_small_angles_are_listed_and_tetrahedra_between_them_protected(self):
        wedge = [[0, 0, 0], [0, 0, 2], [4, F(1, 8), 0], [4, F(1, 8), 2], [4, F(-1, 8), 0], [4, F(-1, 8), 2]]
        document, model = self.domain(wedge, "--hull", "--max-radius-edge", "2")
        refinement = document["refinement"]
        self.assertEqual([len(a["vertices"]) for a in refinement["small_angle_list"]], [3, 3, 2])
        self.assertTrue(all(abs(a["degrees"] - 3.58) < .01 for a in refinement["small_angle_list"]))
        self.assertEqual((refinement["small_angles"], refinement["end"]), (3, "limits"))
        self.assertEqual(refinement["protected"], len(refinement["protected_tetrahedra"]))
        self.assertGreater(refinement["protected"], 0)
        self.assertEqual(volume6(model), 6)

    def test_occupancy_domains_are_refined_as_they_are(self):
        points = shell_scan(1, 0, 1, .3)
        _, coarse = self.domain(points)
        document, fine = self.domain(points, "--max-volume", "1/300")
        self.assertEqual(volume6(fine), volume6(coarse))
        self.assertLessEqual(self.limits_of(fine)[0], F(1, 300))
        self.assertEqual(fine["vertices"][:len(coarse["vertices"])], coarse["vertices"])
        self.assertEqual((document["delaunay"], document["refinement"]["taken_away"]), (False, 0))

    def test_limits_out_of_range_are_wrong_usage(self):
        for options, why in ((["--max-volume", "0"], "must be a positive number, not 0"), (["--max-volume", "-1/2"], "must be a positive number"),
                             (["--max-volume", "x"], "must be a positive number, not x"), (["--max-radius-edge", "0.999"], "must be a number of at least 1, not 0.999"),
                             (["--max-points", "5"], "--max-points needs --max-volume or --max-radius-edge")):
            done = run("dms", "domain", "-", "-o", "d.vdms", "--hull", *options, input="", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done)
            self.assertIn(why, " ".join(done.stderr.split()))

    def test_neither_of_tetgens_files_is_overwritten(self):
        texts = {"t.node": "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n", "t.ele": "1 4 0\n0 0 1 2 3\n"}
        for name, content in texts.items():
            (self.folder / name).write_text(content)
        for options in (("t.node", "-o", "t.ele"), ("t.ele", "-o", "t.node"), ("t.node", "-o", "o.vdms", "--json", "t.ele")):
            done = run("dms", "domain", *options, cwd=self.folder)
            self.assertEqual(done.returncode, 2, done)
            self.assertIn("is the input t.", done.stderr)
        for name, content in texts.items():
            self.assertEqual((self.folder / name).read_text(), content)
        self.assertEqual(run("dms", "domain", "t.node", "-o", "o.vdms", cwd=self.folder).returncode, 0)

    def test_points_without_a_domain_are_refused(self):
        for points, why in (([[0, 0, 0]] * 9, "all 9 points lie in one plane"),
                            ([[i, i * i, 0] for i in range(30)], "all 30 points lie in one plane"),
                            ([[0, 0, 0], [1, 0, 0]], "a tetrahedron needs four points, not 2"),
                            ([], "a tetrahedron needs four points, not 0")):
            done = run("dms", "domain", "-", "-o", "d.vdms", "--hull", input=text(points), cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (1, ""), done)
            self.assertIn(why, done.stderr)
            self.assertFalse((self.folder / "d.vdms").exists())
        done = run("dms", "domain", "-", "-o", "d.vdms", input=text([[0, 0, 0], [1, 0, 0], [50, 0, 90], [50, 1, 90]]), cwd=self.folder)
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("no tetrahedron has the middles of its edges", done.stderr)

    def test_files_that_cannot_be_read_are_named_with_the_line(self):
        done = run("dms", "domain", "-", "-o", "d.vdms", "--hull", input="0 0 0\n1 0\n", cwd=self.folder)
        self.assertEqual(done.returncode, 4, done)
        self.assertIn(":2", done.stderr)
        for options in ([], ["-o", "d.vdms", "--json", "d.vdms"]):
            done = run("dms", "domain", "-", *options, input="", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done)


if __name__ == "__main__":
    unittest.main()
