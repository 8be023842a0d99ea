#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope dms iso: surfaces of known topology, what is in doubt, refusals, and the files that are written."""
import json
import math
import sys
import unittest

import schema
import terminal
from support import MODELS, ROOT, Folder, run

sys.path.insert(0, str(ROOT / "tests" / "support"))
import dms_files  # noqa: E402

F = dms_files.Q


def sphere(centre=(F(1, 10), F(-1, 7), F(1, 9)), points=dms_files.grid_domain((2, 2, 2))):
    """A quadratic model of the cube [-1, 1]^3 whose attribute a is the square of the distance from the centre: control points are polar forms."""
    places, tetrahedra = points
    places = [[c - 1 for c in p] for p in places]
    control = {}
    for t in tetrahedra:
        for i in t:
            for j in t:
                p, q = places[i], places[j]
                product = sum((a - c) * (b - c) for a, b, c in zip(p, q, centre))
                control[tuple(sorted((i, j)))] = [(a + b) / 2 for a, b in zip(p, q)] + [product]
    return dms_files.text(2, [[p] for p in places], tetrahedra, control, ("a",))


class DmsIso(Folder):
    def setUp(self):
        super().setUp()
        self.model = self.folder / "m.vdms"
        self.model.write_bytes(sphere())

    def iso(self, *options, model=None, status=0, level="1/4", within="2", output="f.off"):
        done = run("dms", "iso", model or self.model, "--attribute", "a", "--level", level, "--within", within, "-o", output, *options,
                   "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, status, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(list(document), schema.keys_of("dms_iso"))
        return document

    def test_a_sphere_is_certified_and_its_mesh_is_valid(self):
        answer = self.iso()
        self.assertEqual((answer["certified"], answer["components"], answer["euler"]), (True, 1, 2))
        self.assertEqual((answer["undecided"], answer["num_undecided"], answer["obstacle"]), ([], 0, None))
        lines = (self.folder / "f.off").read_text().split()
        self.assertEqual((int(lines[1]), int(lines[2])), (answer["vertices"], answer["triangles"]))
        numbers = [float(x) for x in lines[4:4 + 3 * answer["vertices"]]]
        for k in range(answer["vertices"]):
            x, y, z = numbers[3 * k:3 * k + 3]
            self.assertAlmostEqual(math.dist((x, y, z), (1 / 10, -1 / 7, 1 / 9)), 0.5, delta=1e-14)

    def test_a_terminal_shows_what_takes_long(self):
        shown = terminal.run_on_terminal("dms", "iso", self.model, "--attribute", "a", "--level", "1/4", "--within", "1/100", "--max-cells", "60000",
                                         "-o", self.folder / "f.off")
        self.assertIn("m.vdms: finding the surface", shown)
        self.assertRegex(shown.splitlines()[-1], "cells are in doubt$")

    def test_smaller_cells_make_more_triangles_and_the_same_surface(self):
        coarse, fine = self.iso(), self.iso(within="0.3")
        self.assertGreater(fine["triangles"], coarse["triangles"])
        self.assertEqual((fine["certified"], fine["components"], fine["euler"]), (True, 1, 2))

    def test_surfaces_are_written_in_three_formats_and_in_space(self):
        for name in ("f.off", "f.ply", "f.obj"):
            answer = self.iso(output=name)
            self.assertIn(f'{answer["triangles"]} faces', run("info", name, cwd=self.folder).stdout)
        domain = (self.folder / "f.off").read_bytes()
        answer = self.iso("--space", "solid")  # the map is the identity
        self.assertEqual((answer["space"], (self.folder / "f.off").read_bytes()), ("solid", domain))

    def test_a_singular_level_and_a_level_at_a_vertex_are_in_doubt(self):
        answer = self.iso("--max-cells", "2000", level="0", status=3)
        self.assertEqual(answer["certified"], False)
        self.assertEqual({cell["why"] for cell in answer["undecided"]}, {"open"})
        at_vertex = (1 + F(1, 10)) ** 2 + (1 - F(1, 7)) ** 2 + (1 + F(1, 9)) ** 2
        answer = self.iso("--max-cells", "2000", level=str(at_vertex), status=3)
        self.assertIn("vertex", {cell["why"] for cell in answer["undecided"]})

    def test_vertices_at_the_level_are_one_vertex_only_where_that_keeps_the_topology(self):
        # An annulus that passes an edge whose ends are at the level on two sides: the edge would be in four triangles.
        for within in ("100", "1"):
            found = self.iso(model=MODELS / "dms" / "pinched_level.vdms", level="0", within=within)
            self.assertEqual((found["certified"], found["components"], found["euler"]), (True, 1, 0))
            lines = (self.folder / "f.off").read_text().split("\n")
            vertices, triangles = map(int, lines[1].split()[:2])
            faces = [tuple(map(int, line.split()[1:])) for line in lines[2 + vertices:2 + vertices + triangles]]
            edges = [(f[i], f[(i + 1) % 3]) for f in faces for i in range(3)]
            self.assertEqual(len(edges), len(set(edges)))
            both = {tuple(sorted(e)) for e in edges}
            self.assertEqual(len({v for f in faces for v in f}) - len(both) + len(faces), 0)

    def test_a_vertex_beyond_binary64_is_refused_with_its_tetrahedron(self):
        data = json.loads(sphere())
        for entry in data["control"]:
            entry["value"][0] = str(F(entry["value"][0]) * 10 ** 400)
        (self.folder / "far.vdms").write_text(json.dumps(data))
        done = run("dms", "iso", "far.vdms", "--attribute", "a", "--level", "1/4", "--within", "2", "--space", "solid", "-o", "f.off",
                   cwd=self.folder)
        self.assertEqual(done.returncode, 4, done)
        self.assertRegex(" ".join(done.stderr.split()), "far.vdms: tetrahedron [0-9]+: a vertex of the surface is beyond binary64")
        self.assertFalse((self.folder / "f.off").exists())

    def test_too_few_cells_leave_wide_ones(self):
        answer = self.iso("--max-cells", "500", within="0.001", status=3)
        self.assertIn("wide", {cell["why"] for cell in answer["undecided"]})

    def test_models_with_defects_are_refused_and_nothing_is_written(self):
        text = (MODELS / "dms" / "tetrahedron.vdms").read_text()
        flat = self.folder / "flat.vdms"
        flat.write_text(text.replace('["0", "0", "1"]]]', '["0", "0", "0"]]]').replace("density", "a"))
        answer = self.iso(model=flat, status=1)
        self.assertTrue(answer["defects"])
        self.assertEqual((answer["certified"], answer["components"], answer["undecided"]), (False, None, []))
        self.assertFalse((self.folder / "f.off").exists())

    def test_an_unknown_attribute_is_named_with_those_that_exist(self):
        done = run("dms", "iso", self.model, "--attribute", "b", "--level", "0", "--within", "1", "-o", "f.off", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done)
        self.assertIn("--attribute b: the model has the attributes a", done.stderr)

    def test_the_summary_says_what_the_page_shows(self):
        done = run("dms", "iso", "m.vdms", "--attribute", "a", "--level", "1/4", "--within", "1", "-o", "f.off", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        self.assertRegex(done.stdout, r"^certified  f\.off  1 component, euler 2, \d+ triangles\n$")


if __name__ == "__main__":
    unittest.main()
