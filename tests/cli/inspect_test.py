#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope inspect: counts, incidences, where models are not manifolds, pairs of cells, statuses."""
import itertools
import json
import random
import unittest
from fractions import Fraction

import schema
import support
from support import DATA, MODELS, Folder, run

TWO_CUBES = MODELS / "splines" / "two_cubes.mesh"


def volume(degrees, points, knots=None, rational=False):
    """points: in the order of the format, the last axis fastest."""
    knots = knots or [[0] * (d + 1) + [1] * (d + 1) for d in degrees]
    shape = {"degrees": degrees, "periodic": [False] * 3, "knots": [[str(t) for t in axis] for axis in knots], "rational": rational,
             "components": 4 if rational else 3, "points": [[str(Fraction(x)) for x in p] for p in points]}
    return {"kind": "volume", "group": None, "attributes": [], "shape": shape}


def trilinear(at):
    """The cell whose corner (i, j, k) is at(i, j, k)."""
    return volume([1, 1, 1], [at(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)])


def cube(x, y, z):
    return trilinear(lambda i, j, k: (x + i, y + j, z + k))


def document(*cells):
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": list(cells)})


def ring(inner=1, first=0, quarters=4):
    """A part of a square ring: u from outside inward, v around, w up; all quarters: v0 and v1 are equal."""
    around = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    points = [(r * around[(first + n) % 4][0], r * around[(first + n) % 4][1], z) for r in (2, inner) for n in range(quarters + 1) for z in (0, 1)]
    return volume([1, 1, 1], points, [[0, 0, 1, 1], [0, *range(quarters + 1), quarters], [0, 0, 1, 1]])


class Model(Folder):
    def file(self, *cells, name="m.vjson"):
        (self.folder / name).write_text(document(*cells))
        return self.folder / name

    def inspect(self, model):
        done = run("inspect", model, "--json", "-")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        out = json.loads(done.stdout)
        self.assertEqual(schema.faults(out), [])
        self.assert_consistent(out)
        return out

    def pair(self, model, a, b):
        done = run("inspect", model, "--pair", f"{a},{b}", "--json", "-")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        out = json.loads(done.stdout)
        self.assertEqual(schema.faults(out), [])
        self.assertEqual(out["cells"], [a, b])
        return out

    def assert_consistent(self, out):
        """Every list agrees with those of the other direction; ids are their places."""
        cells, surfaces, curves, points = (out[key] for key in ("cells", "v_surfaces", "v_curves", "v_points"))
        for elements in (cells, surfaces, curves, points):
            self.assertEqual([e["id"] for e in elements], list(range(len(elements))))
        n = out["counts"]
        self.assertEqual((n["cells"], n["v_surfaces"], n["v_curves"], n["v_points"]), tuple(map(len, (cells, surfaces, curves, points))))
        self.assertEqual(n["half_v_surfaces"], sum(len(s["halves"]) for s in surfaces))
        self.assertEqual(n["internal"] + n["boundary"], n["v_surfaces"])
        self.assertEqual(n["euler"], len(points) - len(curves) + len(surfaces) - len(cells))
        if out["betti"] is not None:
            b = out["betti"]
            self.assertEqual((b[0] - b[1] + b[2] - b[3], b[0]), (n["euler"], out["components"]))
        for s in surfaces:
            for half in s["halves"]:
                self.assertEqual(cells[half["cell"]]["faces"][half["part"]], s["id"])
            self.assertEqual(s["symmetry"] is None, len(s["halves"]) == 1)
        for c in cells:
            shared = {half["cell"] for s in surfaces if s["id"] in c["faces"].values() for half in s["halves"]}
            self.assertEqual(c["neighbours"], sorted(shared - {c["id"]}))
        for p in points:
            self.assertEqual(p["v_curves"], [c["id"] for c in curves if p["id"] in c["points"]])
            self.assertEqual(p["cells"], sorted({corner["cell"] for corner in p["corners"]}))
        self.assertEqual(sum(len(p["corners"]) for p in points), 8 * len(cells))
        self.assertEqual(len({tuple(p["at"]) for p in points}), len(points))
        collapsed_edges = sum(len(c["part"]) == 4 for c in out["collapsed"])
        self.assertEqual(sum(len(c["edges"]) for c in curves) + collapsed_edges, 12 * len(cells))
        for c in curves:
            self.assertEqual(c["half_v_surfaces"], sum(2 * len(fan["cells"]) for fan in c["fans"]))
            self.assertEqual(c["v_surfaces"], sorted({s for fan in c["fans"] for s in fan["v_surfaces"]}))
            self.assertEqual(c["cells"], sorted({cell for fan in c["fans"] for cell in fan["cells"]}))
            self.assertEqual(c["boundary"], not all(fan["cyclic"] for fan in c["fans"]))
        good = all(len(c["fans"]) == 1 for c in curves) and all(len(p["links"]) == 1 and p["links"][0]["kind"] != "other" for p in points)
        self.assertEqual(out["manifold"], good)

    def counts(self, out):
        return tuple(out["counts"][key] for key in ("v_points", "v_curves", "v_surfaces", "internal", "half_v_surfaces"))


class Inspect(Model):
    def test_a_box(self):
        out = self.inspect(self.file(cube(0, 0, 0)))
        self.assertEqual(self.counts(out), (8, 12, 6, 0, 6))
        self.assertEqual((out["betti"], out["components"], out["manifold"], out["collapsed"]), ([1, 0, 0, 0], 1, True, []))
        self.assertEqual(out["v_points"][5]["at"], ["1/1", "0/1", "1/1"])
        self.assertEqual(out["v_points"][5]["corners"], [{"cell": 0, "part": "u1v0w1"}])
        self.assertEqual([c["edges"][0]["part"] for c in out["v_curves"]],
                         [a + b for p, q in (("v", "w"), ("u", "w"), ("u", "v")) for b in (q + "0", q + "1") for a in (p + "0", p + "1")])

    def test_three_cubes_in_an_l_as_in_figure_3(self):
        model = self.file(cube(0, 0, 0), cube(1, 0, 0), cube(0, 1, 0))
        out = self.inspect(model)
        self.assertEqual(self.counts(out), (16, 28, 16, 2, 18))
        inner = [c for c in out["v_curves"] if len(c["cells"]) == 3]
        self.assertEqual([(len(c["v_surfaces"]), c["half_v_surfaces"], len(c["edges"])) for c in inner], [(4, 6, 3)])
        self.assertEqual([len(out["v_points"][p]["v_curves"]) for p in inner[0]["points"]], [5, 5])
        outer = [c for c in out["v_curves"] if c["edges"] == [{"cell": 1, "part": "u1v1"}]]
        self.assertEqual([(c["v_surfaces"], c["half_v_surfaces"]) for c in outer], [([out["cells"][1]["faces"][k] for k in ("u1", "v1")], 2)])
        self.assertEqual([len(out["v_points"][p]["v_curves"]) for p in outer[0]["points"]], [3, 3])
        self.assertTrue(out["manifold"])
        self.assertEqual(self.pair(model, 0, 1)["surfaces"], [out["cells"][0]["faces"]["u1"]])
        common = self.pair(model, 1, 2)
        self.assertEqual((common["surfaces"], common["curves"], common["points"]), ([], [inner[0]["id"]], sorted(inner[0]["points"])))
        self.assertFalse(common["exactly_one_point"])

    def test_the_page_shows_what_is_printed(self):
        self.file(cube(0, 0, 0), cube(1, 0, 0), cube(0, 1, 0), name="L.vjson")
        page = (support.ROOT / "docs" / "cli" / "inspect.md").read_text()
        printed = run("inspect", "L.vjson", cwd=self.folder).stdout
        self.assertIn(printed, page)
        lines = run("inspect", "L.vjson", "--json", "-", cwd=self.folder).stdout.splitlines()
        self.assertIn(lines[lines.index('"v_curves":[') + 12], page)

    def test_two_cubes_on_one_edge(self):
        model = self.file(cube(0, 0, 0), cube(1, 1, 0))
        out = self.inspect(model)
        self.assertEqual(self.counts(out), (14, 23, 12, 0, 12))
        shared = [c for c in out["v_curves"] if len(c["cells"]) == 2]
        self.assertEqual([(len(c["fans"]), c["half_v_surfaces"]) for c in shared], [(2, 4)])
        self.assertEqual([[link["kind"] for link in out["v_points"][p]["links"]] for p in shared[0]["points"]], [["disk", "disk"]] * 2)
        self.assertEqual((out["manifold"], out["components"]), (False, 1))
        self.assertFalse(self.pair(model, 0, 1)["exactly_one_point"])
        text = run("inspect", model).stdout
        self.assertIn("no, at 1 V-curve and 2 V-points", text)
        self.assertIn("from (1, 1, 0) to (1, 1, 1): 2 fans, cells 0, 1", text)

    def test_two_cubes_on_one_vertex(self):
        model = self.file(cube(0, 0, 0), cube(1, 1, 1))
        out = self.inspect(model)
        self.assertEqual(self.counts(out), (15, 24, 12, 0, 12))
        self.assertEqual(out["manifold"], False)
        common = self.pair(model, 0, 1)
        self.assertEqual((common["surfaces"], common["curves"], len(common["points"]), common["exactly_one_point"]), ([], [], 1, True))
        self.assertEqual(out["v_points"][common["points"][0]]["at"], ["1/1"] * 3)
        self.assertIn("meet at exactly one point", run("inspect", model, "--pair", "1,0").stdout)

    def test_cubes_apart(self):
        model = self.file(cube(0, 0, 0), cube(5, 0, 0))
        out = self.inspect(model)
        self.assertEqual((self.counts(out), out["components"], out["betti"], out["manifold"]), ((16, 24, 12, 0, 12), 2, [2, 0, 0, 0], True))
        self.assertIn("do not meet", run("inspect", model, "--pair", "0,1").stdout)

    def test_a_cell_and_its_copy_share_all_curves_and_no_surface(self):
        model = self.file(cube(0, 0, 0), cube(0, 0, 0))
        out = self.inspect(model)
        self.assertEqual(self.counts(out), (8, 12, 12, 0, 12))
        self.assertEqual({len(c["fans"]) for c in out["v_curves"]}, {2})
        # Two balls that meet in the edges of a cube: the six pairs of faces bound six regions, one of which is outside.
        self.assertEqual(out["betti"], [1, 0, 5, 0])
        self.assertIn("u0 of cell 0 and u0 of cell 1 are equal, with their cells on the same side", run("inspect", model).stdout)

    def test_a_ring_of_one_cell_is_glued_to_itself(self):
        out = self.inspect(self.file(ring()))
        self.assertEqual((self.counts(out), out["betti"], out["manifold"]), ((4, 8, 5, 1, 6), [1, 1, 0, 0], True))
        (inside,) = [s for s in out["v_surfaces"] if s["symmetry"] is not None]
        self.assertEqual((inside["halves"], inside["symmetry"]), ([{"cell": 0, "part": "v0"}, {"cell": 0, "part": "v1"}], 0))
        self.assertEqual(out["cells"][0]["neighbours"], [])
        closed = [c for c in out["v_curves"] if c["points"][0] == c["points"][1]]
        self.assertEqual(len(closed), 4)
        for c in out["v_curves"]:
            self.assertEqual((c["half_v_surfaces"], len(c["fans"])), (2, 1) if c in closed else (4, 1))

    def test_a_ring_of_two_cells(self):
        model = self.file(ring(first=0, quarters=2), ring(first=2, quarters=2))
        out = self.inspect(model)
        self.assertEqual((self.counts(out), out["betti"], out["manifold"]), ((8, 16, 10, 2, 12), [1, 1, 0, 0], True))
        common = self.pair(model, 0, 1)
        self.assertEqual([len(common[key]) for key in ("surfaces", "curves", "points")], [2, 8, 8])

    def test_a_cylinder_of_one_cell_around_an_axis(self):
        out = self.inspect(self.file(ring(inner=0)))
        self.assertEqual((self.counts(out), out["betti"], out["manifold"]), ((4, 6, 4, 1, 5), [1, 0, 0, 0], True))
        (face,) = [c for c in out["collapsed"] if c["part"] == "u1"]
        axis = out["v_curves"][face["onto"]["id"]]
        self.assertEqual((face["onto"]["kind"], [e["part"] for e in axis["edges"]], axis["boundary"]), ("curve", ["u1v0", "u1v1"], False))
        self.assertEqual(axis["fans"], [{"cyclic": True, "cells": [0], "v_surfaces": [1]}])
        self.assertEqual([c["part"] for c in out["collapsed"]], ["u1", "u1w0", "u1w1"])

    def test_standard_input(self):
        text = document(cube(0, 0, 0))
        self.assertEqual(run("inspect", "-", "--format", "vjson", "--json", "-", input=text).stdout, run("inspect", self.file(cube(0, 0, 0)), "--json", "-").stdout)

    def test_collapsed_faces_and_edges(self):
        wedge = trilinear(lambda i, j, k: (i, j * i, k))  # u0 is collapsed onto an edge
        out = self.inspect(self.file(wedge))
        self.assertEqual(self.counts(out), (6, 9, 5, 0, 5))
        self.assertEqual(out["cells"][0]["faces"]["u0"], None)
        (axis,) = [c for c in out["v_curves"] if len(c["edges"]) == 2]
        self.assertEqual(axis["edges"], [{"cell": 0, "part": "u0v0"}, {"cell": 0, "part": "u0v1"}])
        onto = {c["part"]: c["onto"] for c in out["collapsed"]}
        self.assertEqual(onto, {"u0": {"kind": "curve", "id": axis["id"]}, "u0w0": {"kind": "point", "id": axis["points"][0]},
                                "u0w1": {"kind": "point", "id": axis["points"][1]}})
        self.assertIn("u0 of cell 0 onto V-curve", run("inspect", self.folder / "m.vjson").stdout)
        pyramid = trilinear(lambda i, j, k: (i * k, j * k, k))
        out = self.inspect(self.file(pyramid))
        self.assertEqual((self.counts(out), out["manifold"]), ((5, 8, 5, 0, 5), True))
        self.assertEqual(out["collapsed"][0], {"cell": 0, "part": "w0", "onto": {"kind": "point", "id": 0}})
        self.assertEqual(len(out["collapsed"]), 5)

    def test_curves_are_equal_in_either_direction_and_in_other_spaces(self):
        """The second cell meets the first in one curve, which has another degree, domain and direction in it; or in its ends only."""
        def above(curve, degree, knots):
            def row(j, k):
                return [(x + 3 * j, y + 3 * (j + k), z + 3 * k) for x, y, z in curve] if j or k else curve
            return volume([degree, 1, 1], [row(j, k)[i] for i in range(degree + 1) for j in (0, 1) for k in (0, 1)], [knots, [0, 0, 1, 1], [0, 0, 1, 1]])

        arc = [(0, 0, 0), (1, 2, 0), (2, 0, 0)]
        elevated = [(0, 0, 0), (Fraction(2, 3), Fraction(4, 3), 0), (Fraction(4, 3), Fraction(4, 3), 0), (2, 0, 0)]
        other = [(0, 0, 0), (1, -2, 0), (2, 0, 0)]

        def below(curve):
            def point(i, j, k):
                return (curve[i][0], curve[i][1] - 3 * j, curve[i][2] - 3 * k)
            return volume([2, 1, 1], [point(i, j, k) for i in range(3) for j in (0, 1) for k in (0, 1)])

        for reverse, same in itertools.product((False, True), (False, True)):
            curve = elevated[::-1] if reverse else elevated
            model = self.file(above(curve, 3, [5] * 4 + [9] * 4), below(arc if same else other))
            out = self.inspect(model)
            self.assertEqual((out["counts"]["v_points"], out["counts"]["v_curves"]), (14, 23 if same else 24))
            self.assertEqual(len(self.pair(model, 0, 1)["curves"]), 1 if same else 0)
            self.assertEqual(len(self.pair(model, 0, 1)["points"]), 2)
            self.assertFalse(self.pair(model, 0, 1)["exactly_one_point"])

    def test_random_polycubes_are_what_cubes_of_a_lattice_say(self):
        for seed in range(30):
            rng = random.Random(seed)
            places = rng.sample(list(itertools.product(range(3), repeat=3)), rng.randrange(1, 14))
            with self.subTest(seed=seed, places=places):
                out = self.inspect(self.file(*(cube(*p) for p in places)))
                self.assertEqual([out["counts"][key] for key in ("v_points", "v_curves", "v_surfaces")], [len(elements_of(places, d)) for d in (0, 1, 2)])
                self.assertEqual(out["manifold"], is_lattice_manifold(set(places)))
                self.assertEqual(out["counts"]["internal"], sum(tuple(x + d for x, d in zip(p, step)) in places for p in places
                                                                for step in ((1, 0, 0), (0, 1, 0), (0, 0, 1))))

    def test_left_handed_cells_are_glued(self):
        turned = trilinear(lambda i, j, k: (1 + j, i, k))
        model = self.file(cube(0, 0, 0), turned)
        out = self.inspect(model)
        self.assertEqual((self.counts(out), out["manifold"]), ((12, 20, 11, 1, 12), True))
        self.assertRegex(run("inspect", model).stdout, r"\n  reversed +cell 1\n")

    def test_files_that_are_no_v_models_are_not_covered(self):
        surface = {"kind": "surface", "group": None, "attributes": [], "shape": {"degrees": [1, 1], "periodic": [False] * 2,
                   "knots": [["0", "0", "1", "1"]] * 2, "rational": False, "components": 3, "points": [["0", "0", "0"], ["0", "1", "0"], ["1", "0", "0"], ["1", "1", "0"]]}}
        plane = cube(0, 0, 0)
        plane["shape"]["components"] = 2
        plane["shape"]["points"] = [p[:2] for p in plane["shape"]["points"]]
        torn = volume([1, 1, 1], [(i, j, k) for i in (0, 1, 2, 3) for j in (0, 1) for k in (0, 1)], [[0, 0, 1, 1, 2, 2], [0, 0, 1, 1], [0, 0, 1, 1]])
        flat = trilinear(lambda i, j, k: (0, 0, k))
        # The sides of u0 are one point, and it has a point off that.
        bulge = volume([1, 2, 2], [(i, 2 * i if j != 1 or k != 1 else 1 - i, (i * j * k)) if i == 1 or (j, k) == (1, 1) else (0, 0, 0)
                                   for i in (0, 1) for j in range(3) for k in range(3)])
        for cells, words in (([cube(0, 0, 0), surface], "entity 1: a surface, not a volume"), ([plane], "entity 0: a volume with 2 coordinates, not in space"),
                             ([torn], "entity 0: axis 0: the inner knot 1 occurs more often than the degree 1"), ([], "the file has no volumes"),
                             ([flat], "cell 0: edge u0v0 is between collapsed faces only"),
                             ([bulge], "cell 0: all edges of face u0 are collapsed, but the face is not")):
            with self.subTest(words):
                done = run("inspect", self.file(*cells), "--json", self.folder / "o.json")
                self.assertEqual((done.returncode, done.stdout), (3, ""))
                self.assertIn("not covered: " + words, " ".join(done.stderr.split()))
                self.assertEqual(self.listing(), ["m.vjson"])
        done = run("inspect", support.VALID)
        self.assertEqual(done.returncode, 3)
        self.assertIn("it is a mesh, and V-models are files of volumes", " ".join(done.stderr.split()))

    def test_attributes_are_ignored(self):
        cells = [cube(0, 0, 0), cube(1, 0, 0)]
        for number, cell in enumerate(cells):
            cell["shape"]["components"] = 4
            cell["shape"]["points"] = [p + [str(number)] for p in cell["shape"]["points"]]
        self.assertEqual(self.counts(self.inspect(self.file(*cells))), (12, 20, 11, 1, 12))

    def test_over_a_limit(self):
        points = [(i, j, k) for i in range(17) for j in (0, 1) for k in (0, 1)]
        done = run("inspect", self.file(volume([16, 1, 1], points)))
        self.assertEqual(done.returncode, 4)
        self.assertIn("entity 0: the volume has the degree 16", " ".join(done.stderr.split()))

    def test_a_pair_that_is_not_there_is_wrong_usage(self):
        model = self.file(cube(0, 0, 0), cube(1, 0, 0))
        for pair, words in (("0,2", "there are 2 cells, numbered from 0"), ("0", "needs the numbers of two cells A,B, not 0"), ("0,x", "not 0,x"),
                            ("-1,0", "not -1,0"), ("0,1,1", "not 0,1,1"), ("0,99999999999", "not 0,99999999999")):
            done = run("inspect", model, "--pair=" + pair)
            self.assertEqual((done.returncode, done.stdout), (2, ""), pair)
            self.assertIn(words, " ".join(done.stderr.split()))

    def test_a_file_that_mfem_wrote(self):
        out = self.inspect(TWO_CUBES)
        self.assertEqual((self.counts(out), out["manifold"]), ((12, 20, 11, 1, 12), True))

    def test_a_report_that_is_a_file(self):
        report = self.folder / "r.json"
        done = run("inspect", TWO_CUBES, "--json", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("2 cells, 11 V-surfaces (1 internal), 20 V-curves, 12 V-points", done.stdout)
        self.assertEqual(report.read_text(), run("inspect", TWO_CUBES, "--json", "-").stdout)

    def test_a_grid_of_10648_cells(self):
        n = 22
        model = self.file(*(cube(x, y, z) for x in range(n) for y in range(n) for z in range(n)))
        done = run("inspect", model, "--json", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        out = json.loads(done.stdout)
        self.assertEqual(self.counts(out), (23**3, 3 * 22 * 23**2, 3 * 23 * 22**2, 3 * 21 * 22**2, 6 * 22**3))
        self.assertEqual((out["betti"], out["manifold"]), ([1, 0, 0, 0], True))


def elements_of(places, dimension):
    """The points, edges or faces of the cubes at these places, each as the double of its middle."""
    offsets = [d for d in itertools.product((0, 1, 2), repeat=3) if d.count(1) == dimension]
    return {tuple(2 * x + d for x, d in zip(p, offset)) for p in places for offset in offsets}


def is_lattice_manifold(places):
    """Whether around each edge and each vertex the cubes, and the other places, are connected through faces, as they are in a manifold."""
    for dimension in (0, 1):
        for middle in elements_of(places, dimension):
            around = [tuple(p) for p in itertools.product(*([x // 2 - 1, x // 2] if x % 2 == 0 else [x // 2] for x in middle))]
            for side in ([p for p in around if p in places], [p for p in around if p not in places]):
                if side and len(connected(side[0], set(side))) != len(side):
                    return False
    return True


def connected(start, places):
    seen, todo = {start}, [start]
    while todo:
        p = todo.pop()
        for q in places - seen:
            if sum(abs(x - y) for x, y in zip(p, q)) == 1:
                seen.add(q)
                todo.append(q)
    return seen


@unittest.skipUnless(DATA.is_dir(), "needs VERITOPE_DATA")
class RealFiles(Model):
    # Cells, V-surfaces, internal, V-curves, V-points, b1, manifold.
    FILES = {
        "mfem__ball-nurbs.mesh": (7, 24, 18, 32, 16, 0, True),
        "mfem__beam-hex-nurbs.mesh": (2, 11, 1, 20, 12, 0, True),
        "mfem__two-cubes-nurbs.mesh": (2, 11, 1, 20, 12, 0, True),
        "mfem__two-cubes-nurbs-rot.mesh": (2, 11, 1, 20, 12, 0, True),
        "mfem__two-cubes-nurbs-autoedge.mesh": (2, 11, 1, 20, 12, 0, True),
        "mfem__cube-nurbs.mesh": (1, 6, 0, 12, 8, 0, True),
        "gismo__fichera.xml": (7, 33, 9, 51, 26, 0, True),
        "gismo__cylinder.xml": (1, 5, 1, 8, 4, 1, True),
        "gismo__GshapedVolume.xml": (1, 6, 0, 12, 8, 0, True),
        "iritprim__ns_cylinder_rational.itd": (5, 22, 8, 32, 16, 0, True),
        "iritprim__ns_sphere_rational.itd": (7, 24, 18, 32, 16, 0, True),
        "iritprim__ns_sphere_poly.itd": (7, 38, 4, 52, 16, 9, False),
        "iritprim__ns_cylinder_poly.itd": (5, 26, 4, 40, 16, 4, False),
    }

    def test_real_files_are_what_is_known_of_them(self):
        for name, known in self.FILES.items():
            with self.subTest(name):
                out = self.inspect(DATA / "cad" / name)
                n = out["counts"]
                found = (*(n[key] for key in ("cells", "v_surfaces", "internal", "v_curves", "v_points")), out["betti"][1], out["manifold"])
                self.assertEqual(found, known)

    def test_counts_are_those_of_certify(self):
        for name in ("mfem__ball-nurbs.mesh", "gismo__cylinder.xml", "iritprim__ns_cylinder_rational.itd"):
            done = run("certify", "--orient", "auto", "--no-check", DATA / "cad" / name, "--json", "-")
            (file,) = json.loads(done.stdout)["files"]
            counts = self.inspect(DATA / "cad" / name)["counts"]
            for key in set(counts) - {"bodies", "boxes"}:
                self.assertEqual(counts[key], file["counts"][key], (name, key))


if __name__ == "__main__":
    support.main()
