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
