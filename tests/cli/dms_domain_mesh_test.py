#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope dms domain of meshes and of other programs' tetrahedra: their boundary and volume beside fractions, certificates, refusals."""
import json
import unittest
from fractions import Fraction as F

import schema
from support import INVALID, ROOT, UNREADABLE, Folder, grid, only_file, run, write_off

MEDIT = """MeshVersionFormatted 2
Dimension 3
Vertices
5
0 0 0 1
1 0 0 1
0 1 0 1
0 0 0.1 1
1 1 1 1
Tetrahedra
2
1 2 3 4 1
2 3 5 4 1
End
"""
NODES, ELEMENTS = "5 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 0.1\n4 1 1 1\n", "2 4 0\n0 0 1 2 3\n1 1 2 4 3\n"
GMSH = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
5
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 0.1
5 1 1 1
$EndNodes
$Elements
2
1 4 2 0 1 1 2 3 4
2 4 2 0 1 2 3 5 4
$EndElements
"""


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def faces_of(t):
    p, q, r, s = t
    return [(q, r, s), (p, s, r), (p, q, s), (p, r, q)]


def boundary(tetrahedra):
    """The faces of one tetrahedron only; every other is that of two, once in each direction."""
    seen = {}
    for t in tetrahedra:
        for f in faces_of(t):
            seen.setdefault(frozenset(f), []).append(f)
    assert all(len(fs) <= 2 for fs in seen.values())
    return [fs[0] for fs in seen.values() if len(fs) == 1]


def areas(triangles):
    """{plane: the sum of its triangles' vector areas, twice}; planes by their coefficients over the first that is not 0."""
    out = {}
    for a, b, c in triangles:
        n = cross(minus(b, a), minus(c, a))
        lead = next(x for x in n if x)
        sums = out.setdefault((*(x / lead for x in n), dot(n, a) / lead), [0, 0, 0])
        for k in range(3):
            sums[k] += n[k]
    return out


class DmsDomainMesh(Folder):
    def domain(self, mesh, *options, status=0):
        done = run("dms", "domain", mesh, "-o", "d.vdms", "--json", "-", *options, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (status, ""), done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        model = json.loads((self.folder / "d.vdms").read_text())
        self.assertEqual((document["vertices"], document["tetrahedra"]), (len(model["vertices"]), len(model["tetrahedra"])))
        self.assertEqual(document["vertices"], document["points"] + document["steiner"])
        self.assertFalse(document["delaunay"])
        return document, model

    def check(self, vertices, faces, *options):
        """Writes the mesh, makes its domain, and compares volume and boundary in fractions."""
        document, model = self.domain(write_off(self.folder / "m.off", vertices, faces), *options)
        at = [[F(x) for x in cloud[0]] for cloud in model["vertices"]]
        vertices = [[F(x) for x in v] for v in vertices]
        self.assertEqual(at[:len(vertices)], vertices)
        volume = 0
        for p, q, r, s in ([at[v] for v in t] for t in model["tetrahedra"]):
            d = dot(minus(q, p), cross(minus(r, p), minus(s, p)))
            self.assertGreater(d, 0)
            volume += d
        self.assertEqual(volume, sum(dot(vertices[a], cross(vertices[b], vertices[c])) for a, b, c in faces))
        self.assertEqual(areas([[at[v] for v in f] for f in boundary(model["tetrahedra"])]),
                         areas([[vertices[v] for v in f] for f in faces]))
        return document

    def test_a_box_is_certified(self):
        document = self.check(*grid(3))
        self.assertEqual(document["steiner"], 0)
        self.assertEqual(only_file(self.folder / "d.vdms")["verdict"], "VALID")

    def test_schoenhardts_polyhedron_needs_other_vertices(self):
        vertices = [(4., 0., 0.), (-2., 3.5, 0.), (-2., -3.5, 0.), (3.5, 2., 4.), (-3.5, 2., 4.), (0., -4., 4.)]
        faces = [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
        document = self.check(vertices, faces)
        self.assertGreater(document["steiner"], 0)
        self.assertEqual(only_file(self.folder / "d.vdms")["verdict"], "VALID")

    def test_refined_domains_are_still_the_mesh(self):
        vertices = [(4., 0., 0.), (-2., 3.5, 0.), (-2., -3.5, 0.), (3.5, 2., 4.), (-3.5, 2., 4.), (0., -4., 4.)]
        faces = [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
        document = self.check(vertices, faces, "--max-volume", "1/4")
        self.assertEqual(document["refinement"]["end"], "limits")
        self.assertLessEqual(document["refinement"]["largest_volume"], .25)
        self.assertEqual(only_file(self.folder / "d.vdms")["verdict"], "VALID")
        document = self.check(*grid(2), "--max-radius-edge", "2")
        self.assertEqual((document["refinement"]["end"], document["refinement"]["over_radius_edge"]), ("limits", 0))

    def test_the_bundled_part(self):
        document, _ = self.domain(ROOT / "examples" / "sound_part.stl")
        self.assertEqual(only_file(self.folder / "d.vdms")["verdict"], "VALID")
        self.assertEqual({v["vertex_class"] for v in document["classes"]} - {"smooth", "curve", "corner"}, set())
        self.assertEqual(run("dms", "make", "d.vdms", "-o", "m.vdms", "--degree", "2", cwd=self.folder).returncode, 0)

    def test_limits_and_refusals(self):
        vertices = [(4., 0., 0.), (-2., 3.5, 0.), (-2., -3.5, 0.), (3.5, 2., 4.), (-3.5, 2., 4.), (0., -4., 4.)]
        faces = [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
        mesh = write_off(self.folder / "m.off", vertices, faces)
        for model, options, status, words in ((mesh, ["--max-vertices", "6"], 3, "--max-vertices"), (INVALID, [], 1, "INVALID"),
                                              (UNREADABLE, [], 4, ""), (mesh, ["--hull"], 2, "--hull is for points"),
                                              (self.folder / "none.off", [], 4, "none.off"),
                                              (ROOT / "tests" / "models" / "dms" / "domain.vdms", [], 4, "needed is a mesh")):
            done = run("dms", "domain", model, "-o", "d.vdms", *options, cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (status, ""), done)
            self.assertIn(words, done.stderr)
            self.assertFalse((self.folder / "d.vdms").exists())

    def test_tetrahedra_of_other_programs(self):
        for name, text in (("m.mesh", MEDIT), ("m.msh", GMSH), ("t.node", NODES), ("t.ele", ELEMENTS)):
            (self.folder / name).write_text(text)
        models = []
        for name in "m.mesh", "m.msh", "t.ele", "t.node":
            document, model = self.domain(name)
            self.assertEqual((document["points"], document["steiner"]), (5, 0))
            self.assertEqual(model["vertices"][3], [["0", "0", "1/10"]])
            models.append(model)
        self.assertTrue(all(m == models[0] for m in models))
        self.assertEqual(only_file(self.folder / "d.vdms")["verdict"], "VALID")
        for text, status, words in ((MEDIT.replace("2 3 5 4 1", "2 3 9 4 1"), 4, "no point"), (MEDIT.replace("0.1", "0"), 1, "tet-reversed"),
                                    (MEDIT.replace("2 3 5 4 1", "1 2 3 5 1"), 1, "tet-face-overused"),
                                    (MEDIT.replace("End", "Vertices\n1\n0 0 0 1\nEnd"), 4, "line 14: the file has a second section Vertices")):
            (self.folder / "bad.mesh").write_text(text)
            done = run("dms", "domain", "bad.mesh", "-o", "x.vdms", cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (status, ""), done)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
