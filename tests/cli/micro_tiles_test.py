#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope micro --tile: frames, branches, tiles from files of every kind, tiles placed by a formula, and refusals."""
import itertools
import json
import random
import unittest
from fractions import Fraction

import schema
import support
from support import run

LINES = (0, "1/4", "3/8", "5/8", "3/4", 1)
# A ring across w, with stubs to u0 and u1, in blocks between these lines.
RING = [(i, j, 2) for i in (1, 2, 3) for j in (1, 2, 3) if (i, j) != (2, 2)] + [(0, 2, 2), (4, 2, 2)]


def blocks(cells, lines=LINES):
    """The surface of the union of blocks: points and outward quadrilaterals."""
    points, faces, full = {}, [], set(cells)
    for cell in cells:
        for axis in range(3):
            for end in (0, 1):
                beside = list(cell)
                beside[axis] += 2 * end - 1
                if tuple(beside) in full:
                    continue
                first, second = ((axis + 1) % 3, (axis + 2) % 3) if end else ((axis + 2) % 3, (axis + 1) % 3)
                face = []
                for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(cell)
                    corner[axis] += end
                    corner[first] += i
                    corner[second] += j
                    face.append(points.setdefault(tuple(corner), len(points)))
                faces.append(face)
    return [[str(lines[i]) for i in p] for p in points], faces


def decimal(text):
    """The number as a float, which is exact if its denominator is a power of two."""
    top, _, bottom = text.partition("/")
    return int(top) / int(bottom or 1)


def off(points, faces):
    return (f"OFF\n{len(points)} {len(faces)} 0\n" + "".join(" ".join(str(decimal(x)) for x in p) + "\n" for p in points)
            + "".join(f"{len(f)} " + " ".join(map(str, f)) + "\n" for f in faces))


def triangles(faces):
    return [t for a, b, c, d in faces for t in ([a, b, c], [a, c, d])]


def entity(kind, shape):
    return {"kind": kind, "group": None, "attributes": [], "shape": shape}


def tensor(points, degrees):
    knots = [["0"] * (d + 1) + ["1"] * (d + 1) for d in degrees]
    return {"degrees": degrees, "periodic": [False] * len(degrees), "knots": knots, "rational": False, "components": 3, "points": points}


def surfaces(points, faces):
    return [entity("surface", tensor([points[f[k]] for k in (0, 3, 1, 2)], [1, 1])) for f in faces]


def volume(low, high):
    corners = [[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    return entity("volume", tensor(corners, [1, 1, 1]))


def block_volume(cell):
    return volume([str(LINES[i]) for i in cell], [str(LINES[i + 1]) for i in cell])


class MicroTiles(support.Folder):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out.vmicro"
        self.box = self.volumes("box", {"op": "box", "min": [0, 0, 0], "max": [8, 8, 8]})

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def vjson(self, name, entities):
        return self.file(name, json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities}))

    def micro(self, *tiles, counts="2,2,2", options=(), expect=0):
        self.out.unlink(missing_ok=True)
        chosen = [word for tile in tiles for word in ("--tile", tile)]
        done = run("micro", "--cage", self.box, *chosen, "--counts", counts, "-o", self.out, "--json", "-", *options, timeout=600)
        self.assertEqual(done.returncode, expect, done.stderr)
        if expect not in (0, 1):
            return done.stderr
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        if expect == 1:
            self.assertFalse(self.out.exists())
            (defect,) = report["defects"]
            return defect
        file = support.only_file(self.out)
        self.assertEqual((file["verdict"], file["sha256"], file["certificate"]["checked"]), ("VALID", report["output"]["sha256"], True))
        for key in ("glued_caps", "components", "shells", "genus"):
            self.assertEqual(file["counts"][key], report[key], key)
        return report

    def test_blocks_of_frames_have_the_genus_of_their_graphs(self):
        # Seven for each tile, and the cycles of the graph of tiles.
        for k, m, n in ((1, 1, 1), (2, 1, 1), (2, 2, 2), (3, 2, 1)):
            report = self.micro("frame", counts=f"{k},{m},{n}")
            links = 3 * k * m * n - k * m - m * n - n * k
            self.assertEqual((report["glued_caps"], report["components"], report["shells"]), (links, 1, 1))
            self.assertEqual(report["genus"], 7 * k * m * n + links - k * m * n + 1)

    def test_branches_have_arms_where_they_are_told_to(self):
        # Arms along u and w only: each layer across v is a part.
        report = self.micro("branch", counts="3,2,4")
        self.assertEqual((report["components"], report["genus"]), (2, 2 * (3 - 1) * (4 - 1)))
        report = self.micro("branch,arms=v0+v1+w1,degree=1", counts="2,3,2")
        self.assertEqual((report["components"], report["glued_caps"], report["genus"]), (4, 2 * 2 * 2, 0))
        report = self.micro("branch,arms=u0+u1", counts="3,1,1", options=("--thickness", "1/8+u/100"))
        self.assertEqual((report["components"], report["genus"]), (1, 0))

    def test_meshes_are_tiles(self):
        points, faces = blocks(RING)
        generator = random.Random(5)
        rough = [p if p[0] in "01" else [x if "/" not in x else f"{int(decimal(x) * 256) + generator.randrange(-6, 7)}/256" for x in p] for p in points]
        for text in (off(points, faces), off(points, triangles(faces)), off(rough, triangles(faces))):
            report = self.micro(self.file("ring.off", text), counts="3,2,1")
            self.assertEqual((report["components"], report["glued_caps"], report["genus"]), (2, 4, 6))
            self.assertEqual(json.loads(self.out.read_text())["tiles"][0]["name"], "ring.off")
            done = run("convert", self.folder / "ring.off", self.folder / "ring.stl")
            self.assertEqual(done.returncode, 0, done)
            self.assertEqual(self.micro(str(self.folder / "ring.stl"), counts="3,2,1")["genus"], 6)

    def test_surfaces_volumes_and_mixed_files_are_tiles(self):
        points, faces = blocks(RING)
        self.assertEqual(self.micro(self.vjson("surfaces.vjson", surfaces(points, faces)), counts="3,2,1")["genus"], 6)
        self.assertEqual(self.micro(self.vjson("volumes.vjson", [block_volume(c) for c in RING]), counts="3,2,1")["genus"], 6)
        # Four blocks are volumes; the surface of the others is given, with the walls between, half of it as triangles.
        solid, rest = RING[:4], RING[4:]
        points, faces = blocks(rest)
        walls = blocks(solid)
        common = {frozenset(tuple(walls[0][i]) for i in f) for f in walls[1]}
        kept = [f for f in faces if frozenset(tuple(points[i]) for i in f) in common]
        others = [f for f in faces if f not in kept]
        pieces = [entity("triangle", {"degree": 1, "rational": False, "components": 3, "points": [points[i] for i in t]})
                  for t in triangles(others)]
        mixed = [block_volume(c) for c in solid] + surfaces(points, kept) + pieces
        self.assertGreater(len(kept), 0)
        report = self.micro(self.vjson("mixed.vjson", mixed), counts="3,2,1")
        self.assertEqual((report["components"], report["glued_caps"], report["genus"]), (2, 4, 6))

    def test_an_itd_file_of_volumes_and_polygons_is_a_tile(self):
        solid, rest = RING[:4], RING[4:]
        points, faces = blocks(rest)
        # Polygons turn clockwise there; one of them is two triangles.
        rings = [list(reversed(f)) for f in faces[1:]] + [list(reversed(t)) for t in triangles(faces[:1])]

        def row(p):
            return "[" + " ".join(str(decimal(x)) for x in p) + "]"
        polygons = "\n".join(f"[POLYGON {len(f)} " + " ".join(row(points[i]) for i in f) + "]" for f in rings)
        self.vjson("solid.vjson", [block_volume(c) for c in solid])
        self.assertEqual(run("convert", self.folder / "solid.vjson", self.folder / "solid.itd").returncode, 0)
        splines = (self.folder / "solid.itd").read_text().rstrip()
        mixed = self.file("mixed.itd", splines + "\n[OBJECT MESH\n" + polygons + "\n]\n")
        report = self.micro(mixed, counts="3,2,1")
        self.assertEqual((report["components"], report["glued_caps"], report["genus"]), (2, 4, 6))

    def test_curved_triangles_are_tiles(self):
        # An octahedron whose edges are bent outward.
        ends = [[sign * (axis == k) for k in range(3)] for axis in range(3) for sign in (-1, 1)]

        def point(p):
            return [str(Fraction(1, 2) + x * Fraction(1, 4)) for x in p]

        def between(a, b):
            return [(x + y) * Fraction(3, 5) for x, y in zip(a, b)]
        faces = []
        for i, j, k in itertools.product((0, 1), repeat=3):
            a, b, c = ends[i], ends[2 + j], ends[4 + k]
            if (i + j + k) % 2 == 0:
                b, c = c, b
            net = [a, between(a, b), between(a, c), b, between(b, c), c]
            faces.append(entity("triangle", {"degree": 2, "rational": False, "components": 3, "points": [point(p) for p in net]}))
        report = self.micro(self.vjson("round.vjson", faces), counts="2,1,1")
        self.assertEqual((report["components"], report["shells"], report["genus"]), (2, 2, 0))
        message = self.micro(self.vjson("open.vjson", faces[1:]), expect=1)["message"]
        self.assertIn("S0, the surface is not closed: side", message)

    def test_tiles_from_files_are_meshed_and_filtered(self):
        points, faces = blocks(RING)
        ring = self.file("ring.off", off(points, triangles(faces)))
        mesh = self.folder / "out.ply"
        self.micro(ring, counts="3,2,1", options=("--mesh", mesh, "--chord", "0.01"))
        self.assertEqual(support.only_file(mesh)["counts"]["genus"], 6)
        # A solid that ends in the middle of the cells 0 and 2, and off the tiles of the others.
        corner = ["0.5", "7.5"]
        solid = self.file("solid.off", "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for z in corner for y in corner for x in ("3", "5")) +
                          "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")
        report = self.micro(ring, counts="8,2,1", options=("--model", solid))
        self.assertEqual({k: v for k, v in report["tiles"].items() if v}, {"total": 16, "touching": 8, "outside": 8})

    def test_a_bubble_of_the_model_in_the_hollow_of_a_frame_does_no_harm(self):
        def cube(low, high, turned, first):
            ends = (low, high)
            corners = [f"{x} {y} {z}" for z in ends for y in ends for x in ends]
            faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
            return corners, ["4 " + " ".join(str(first + i) for i in (f[::-1] if turned else f)) for f in faces]
        # The eight inner cells of length 2 lie in the solid; the bubble is in the middle of one of them.
        outer, inner = cube(0.5, 7.5, False, 0), cube(2.9, 3.1, True, 8)
        solid = self.file("bubble.off", "\n".join(["OFF", "16 12 0", *outer[0], *inner[0], *outer[1], *inner[1]]) + "\n")
        report = self.micro("frame", counts="4,4,4", options=("--model", solid))
        self.assertEqual((report["tiles"]["kept"], report["tiles"]["crossing"], report["genus"]), (8, 56, 61))
        report = self.micro("jack", counts="4,4,4", options=("--model", solid))
        self.assertEqual((report["tiles"]["kept"], report["tiles"]["crossing"]), (7, 57))

    def test_cells_are_doubled_from_a_layer_on(self):
        # 8 tiles and 12 links, 16 links, 16 tiles and 24 links.
        for tile in ("jack", "jack,degree=1"):
            for options in ((), ("--thickness", "1/10+u*v/20+w/50")):
                report = self.micro(tile, counts="2,2,3", options=("--double", "w=2", *options))
                self.assertEqual((report["tiles"]["total"], report["glued_caps"], report["components"]), (24, 52, 1))
                self.assertEqual(report["genus"], 52 - 24 + 1)
        report = self.micro("jack", "frame", counts="1,1,2", options=("--double", "w=1", "--place", "0"))
        self.assertEqual((report["tiles"]["total"], report["genus"]), (5, 4 + 4 - 5 + 1))
        solid = self.file("solid.off", "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for z in (1, 7) for y in (1, 7) for x in (1, 7)) +
                          "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")
        listed, mesh = self.folder / "cells.csv", self.folder / "out.ply"
        report = self.micro("jack,degree=1", counts="4,4,8", options=("--double", "w=4", "--model", solid, "--list", listed, "--mesh", mesh, "--chord", "0.1"))
        self.assertEqual(len(listed.read_text().splitlines()), 1 + 4 * 16 + 4 * 64)
        self.assertEqual(support.only_file(mesh)["counts"]["genus"], report["genus"])
        for options, why in ((("--double", "w=2"), "needs a layer below"), (("--double", "w=0"), "needs w=L"), (("--double", "u=1"), "needs w=L")):
            self.assertIn(why, " ".join(self.micro("jack", counts="2,2,2", options=options, expect=2).split()))
        self.assertIn("needs a jack", self.micro("frame", counts="2,2,2", options=("--double", "w=1"), expect=2))
        self.assertIn("needs a jack", self.micro("frame", options=("--thickness", "1/8"), expect=2))

    def test_tiles_are_placed_by_a_formula(self):
        tiles = ("jack,degree=1", "frame,bar=1/4,margin=1/10")
        report = self.micro(*tiles, counts="3,3,3", options=("--place", "min(1, 3*u)"))
        # One layer of jacks, and two of frames, whose caps are equal to theirs.
        self.assertEqual((report["kinds"], report["components"], report["genus"]), (2, 1, 7 * 18 + 54 - 27 + 1))
        first = self.micro(*tiles, counts="3,3,3", options=("--place", "2*rand(7)"))
        self.assertEqual(self.micro(*tiles, counts="3,3,3", options=("--place", "2*rand(7)"))["output"], first["output"])
        defect = self.micro(*tiles, counts="3,3,3", options=("--place", "3*u"), expect=1)
        self.assertEqual(defect["code"], "place")
        self.assertIn("cell (2, 0, 0) of volume 0: the value 2621440/2^20 is the number 2 of a tile, and there are 2", defect["message"])
        self.assertEqual(self.micro("jack", "frame", counts="3,3,3", options=("--place", "2*u"), expect=1)["code"], "T4")
        self.assertIn("several tiles need --place", self.micro(*tiles, expect=2))

    def test_tiles_that_are_wrong_are_refused_with_condition_and_wall(self):
        points, faces = blocks(RING)
        defect = self.micro(self.file("open.off", off(points, faces[:-1])), expect=1)
        self.assertEqual((defect["code"], defect["tile"]), ("S0", 0))
        self.assertIn("the surface is not closed", defect["message"])
        large = [[f"{3 * int(decimal(x) * 8)}/16" for x in p] for p in points]
        defect = self.micro(self.file("large.off", off(large, faces)), expect=1)
        self.assertEqual((defect["code"], defect["wall"]), ("T2", "u1"))
        self.assertIn("the tile leaves the cube", defect["message"])
        inward = self.micro(self.file("inward.off", off(points, [f[::-1] for f in faces])), expect=1)
        self.assertEqual(inward["code"], "F3")
        self.assertIn("inside-out", inward["message"])
        one, four = blocks([(1, 2, 2), (2, 2, 2)])
        moved = [[f"{int(decimal(x) * 32) + 3}/32" for x in p] for p in one]
        shifted = [[i + len(one) for i in f] for f in four]
        defect = self.micro(self.file("crossing.off", off(one + moved, four + shifted)), expect=1)
        self.assertEqual(defect["code"], "F3")
        self.assertIn("cross near", defect["message"])
        far, eight = blocks([(1, 2, 2), (3, 2, 2)])
        self.assertIn("components", self.micro(self.file("two.off", off(far, eight)), expect=1)["message"])
        # Caps of one wall that meet in an edge of the cube.
        self.assertEqual(self.micro(self.file("edge.off", off(*blocks([(0, 0, 2), (1, 0, 2)]))), expect=1)["code"], "T2")

    def test_files_that_hold_no_tile_are_refused(self):
        quarter = {"degrees": [2, 1], "periodic": [False, False], "knots": [["0"] * 3 + ["1"] * 3, ["0", "0", "1", "1"]], "rational": True,
                   "components": 4, "points": [["1", "0", "0", "1"], ["1", "0", "1", "1"], ["1", "1", "0", "1"], ["1", "1", "1", "1"],
                                               ["0", "2", "0", "2"], ["0", "2", "2", "2"]]}
        for entities, why in (([entity("surface", quarter)], "is rational; the patches of tiles are polynomial"),
                              ([entity("curve", {"degrees": [1], "periodic": [False], "knots": [["0", "0", "1", "1"]], "rational": False, "components": 3,
                                                 "points": [["0", "0", "0"], ["1", "0", "0"]]})], "entity 0 is a curve"),
                              ([entity("surface", tensor([["1", "0", str(i)] for i in range(18)], [8, 1]))], "has the degree 8")):
            self.assertIn(why, " ".join(self.micro(self.vjson("bad.vjson", entities), expect=4).split()))
        self.assertIn("no such", self.micro(str(self.folder / "missing.off"), expect=4).lower())
        cells = list(itertools.product(range(14), repeat=3))
        many = self.file("many.off", off(*blocks(cells, [f"{i}/16" for i in range(1, 16)])))
        self.assertIn("2352 triangles, more than 2048", " ".join(self.micro(many, expect=4).split()))
        for tile, why in (("ring", "needs jack, frame, branch"), ("frame,rod=1", "has no key rod"), ("frame,bar=1/3", "is not a tile"),
                          ("branch,arms=u2", "needs walls such as"), ("branch,arms=u0+w1+u0", "names the wall u0 twice"),
                          ("jack,node=1/5,cap=1/8,node=1/4", "has the key node twice"), ("jack,arms=u0", "has no key arms")):
            self.assertIn(why, " ".join(self.micro(tile, expect=2).split()))


if __name__ == "__main__":
    unittest.main()
