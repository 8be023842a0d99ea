#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope build: cells that certify accepts, refusals with a pointer, and what is left behind."""
import json
import pathlib
import random
import time
import unittest

import support
from support import run

TREES = pathlib.Path(__file__).resolve().parent / "trees"
UNIT = ["0", "0", "1", "1"]


def surface(*corners):
    """The bilinear surface of four corners: (0,0), (0,1), (1,0), (1,1)."""
    return {"degrees": [1, 1], "periodic": [False, False], "knots": [UNIT, UNIT], "rational": False, "components": 3,
            "points": [[str(x) for x in corner] for corner in corners]}


def square(z, size=1):
    return surface((0, 0, z), (0, size, z), (size, 0, z), (size, size, z))


class Build(support.Folder):
    def build(self, root, *arguments, expect=0):
        tree = self.folder / "tree.json"
        tree.write_text(json.dumps({"format": "veritope-tree-1", "root": root}))
        self.out = self.folder / "out.vjson"
        done = run("build", tree, "-o", self.out, *arguments)
        self.assertEqual(done.returncode, expect, done.stderr)
        return done

    def certified(self, root, genus=0):
        """The entities of the one body that is built."""
        self.build(root)
        file = support.only_file(self.out, "--orient", "auto")
        self.assertEqual(file["verdict"], "VALID", file)
        self.assertEqual([shell["genus"] for shell in file["shells"]], [genus])
        return json.loads(self.out.read_text())["entities"]

    def test_every_primitive_is_certified(self):
        for root, cells, genus in (({"op": "box", "min": [0, 0, 0], "max": [1, 2, "1/3"]}, 1, 0),
                                   ({"op": "cylinder", "radius": 2, "height": 5}, 5, 0),
                                   ({"op": "cone", "bottom": 2, "top": "0.5", "height": 5}, 5, 0),
                                   ({"op": "cone", "bottom": 2, "top": 0, "height": 5}, 5, 0),
                                   ({"op": "torus", "major": 3, "minor": 1}, 5, 1),
                                   ({"op": "sphere", "radius": "1e3"}, 7, 0),
                                   ({"op": "cylinder", "radius": 2, "height": 5, "cells": "one"}, 1, 0),
                                   ({"op": "sphere", "radius": 2, "cells": "one"}, 1, 0)):
            with self.subTest(root):
                self.assertEqual(len(self.certified(root, genus)), cells)

    def test_every_constructor_is_certified(self):
        profile = surface((1, 0, 0), (1, 0, 1), (2, 0, 0), (2, 0, 1))
        around = [(1, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)]
        tube = {"degrees": [1, 1], "periodic": [False, False], "knots": [["0", "0", "1", "2", "3", "4", "4"], UNIT], "rational": False,
                "components": 3, "points": [[str(x * (1 + z)), str(y * (1 + z)), str(3 * z)] for x, y in around for z in (0, 1)]}
        sections = [square(0), square(1, 2), square(2), square(3, 2)]
        for root in ({"op": "extrude", "surface": square(0), "vector": [1, 1, 1]},
                     {"op": "ruled", "surfaces": [square(0), square(3, 2)]},
                     {"op": "revolve", "surface": profile, "point": [0, 0, 0], "axis": [0, 0, 1], "degrees": 100},
                     {"op": "revolve", "surface": profile, "point": [-1, -1, 0], "axis": [1, 2, 5], "degrees": "300.5"},
                     {"op": "sweep", "sections": sections, "parameters": [0, 1, 2, 3], "degree": 3, "mode": "interpolate"},
                     {"op": "sweep", "sections": sections, "parameters": [0, 1, 2, 3], "degree": 2, "mode": "approximate"},
                     {"op": "tube", "surface": tube}):
            with self.subTest(root["op"]):
                self.assertEqual(len(self.certified(root)), 1)
        self.certified({"op": "revolve", "surface": profile, "point": [-1, -1, 0], "axis": [1, 2, 5]}, genus=1)

    def test_glued_placed_and_split_cells_keep_their_walls(self):
        box = {"op": "box", "min": [0, 0, 0], "max": [1, 1, 1]}
        two = {"op": "glue", "of": [box, {"op": "place", "of": box, "translate": [1, 0, 0]}]}
        self.assertEqual(len(self.certified(two)), 2)
        self.assertEqual(len(self.certified({"op": "split", "of": {"op": "torus", "major": 2, "minor": 1}, "axis": "w", "at": "1/3"}, 1)), 10)
        turned = {"op": "place", "of": {"op": "sphere", "radius": 1}, "scale": [1, 2, 3],
                  "rotate": {"axis": [1, 1, 1], "point": [0, 0, 1], "degrees": -45}, "translate": [1, 2, 3]}
        self.assertEqual(len(self.certified(turned)), 7)
        mirrored = {"op": "place", "of": {"op": "cylinder", "radius": 1, "height": 1}, "matrix": [[1, 0, 0, 0], [0, -1, 0, 0], [0, 0, 1, 0]]}
        self.assertEqual(len(self.certified(mirrored)), 5)

    def test_random_placements_of_random_primitives_are_certified(self):
        seed = 2110
        draw = random.Random(seed)
        for loop in range(12):
            size = lambda: f"{draw.randint(1, 40)}/{draw.randint(1, 9)}"
            entry = lambda: draw.randint(-5, 5)
            primitive = draw.choice([{"op": "cylinder", "radius": size(), "height": size()}, {"op": "cone", "bottom": size(), "top": size(), "height": size()},
                                     {"op": "sphere", "radius": size()}, {"op": "box", "min": [-1, -2, -3], "max": [size(), size(), size()]}])
            place = {"op": "place", "of": primitive, "scale": [size(), size(), size()],
                     "rotate": {"axis": [entry(), entry(), 7], "point": [entry(), entry(), entry()], "degrees": str(draw.randint(-400000, 400000) / 1000)},
                     "translate": [size(), size(), size()]}
            with self.subTest(seed=seed, loop=loop, tree=place):
                self.certified(place)

    def test_volumes_and_surfaces_come_from_files(self):
        self.build({"op": "cylinder", "radius": 1, "height": 1})
        (self.folder / "sub").mkdir()
        (self.folder / "sub" / "c.vjson").write_bytes(self.out.read_bytes())
        cylinder = {"op": "file", "path": "sub/c.vjson"}
        self.assertEqual(len(self.certified(cylinder)), 5)
        self.assertEqual(len(self.certified({"op": "file", "path": "sub/c.vjson", "entity": 0})), 1)
        run("convert", "--faces", self.folder / "sub" / "c.vjson", self.folder / "faces.vjson")
        self.certified({"op": "extrude", "surface": {"op": "file", "path": "faces.vjson", "entity": 0}, "vector": [0, 0, 5]})
        done = self.build({"op": "file", "path": "out.vjson"}, expect=4)
        self.assertIn("which is the file to be written", done.stderr)
        done = self.build({"op": "glue", "of": [cylinder, {"op": "file", "path": "faces.vjson"}]}, expect=4)
        self.assertIn("tree.json: line 1: /root/of/1/entity: entity 0 of the file is a surface, no volume", done.stderr)

    def test_the_report_names_angles_and_matrices(self):
        done = run("build", TREES / "parts.json", "-o", self.folder / "parts.vjson", "--json", "-")
        report = json.loads(done.stdout)
        self.assertEqual(report["schema"], "veritope-build-1")
        self.assertEqual(report["counts"], {"cells": 18, "control_points": 56 * 2 + 308 + 8, "nodes": 8, "files": 0})
        self.assertEqual([note["pointer"] for note in report["notes"]], ["/root/of/2", "/root/of/3"])
        angle, matrix = report["notes"][0]["angle"], report["notes"][1]["matrix"]
        self.assertEqual(angle["degrees"], "30")
        self.assertNotEqual(angle["lo"], angle["hi"])
        self.assertEqual(matrix, {"determinant": "1", "distance_from_rotation": "1/1000"})

    def test_refusals_write_nothing_and_say_where(self):
        done = run("build", TREES / "wrong.json", "-o", self.folder / "x.vjson", "--json", self.folder / "x.json")
        self.assertEqual(done.returncode, 4)
        self.assertIn("wrong.json: line 4: /root/of/1/minor: minor must be less than major", done.stderr.replace("\n", " "))
        self.assertEqual(self.listing(), [])

    def test_malformed_trees_are_refused_at_once(self):
        box = '{"op":"box","min":[0,0,0],"max":[1,1,1]}'
        start = '{"format":"veritope-tree-1","root":'
        texts = ["", "{", "[]", start, start + "[" * 100000, start + '{"op":"glue","of":[' * 5000, start + '{"of":[' * 5000 + "]}" * 5000 + "}",
                 start + '{"op":"box","min":[' + "0," * 20000, start + '{"op":"sphere","radius":' + "9" * 6000 + "}}",
                 start + '{"op":"sphere","radius":"1e99999"}}', start + '{"op":"place","scale":"1/0","of":' + box + "}}",
                 start + '{"op":"sweep","degree":99999999,"mode":"interpolate","parameters":[],"sections":[]}}', "\0" * 1000,
                 start + '{"op":"\\ud800","of":1}}', start + box.replace("box", "b\u00f6x") + "}"]
        for text in texts:
            with self.subTest(text[:60]):
                tree = self.folder / "bad.json"
                tree.write_text(text)
                begin = time.monotonic()
                done = run("build", tree, "-o", self.folder / "x.vjson")
                self.assertEqual((done.returncode, done.stdout), (4, ""), done.stderr)
                self.assertLess(time.monotonic() - begin, 5, "milliseconds are meant; a busy machine takes longer")
        self.assertEqual(self.listing(), ["bad.json"])

    def test_numbers_that_would_not_be_read_back_are_not_written(self):
        """Three scales by numbers of 4,000 digits; with a wider limit the file is written."""
        root, factor = {"op": "sphere", "radius": 1}, "1" + "0" * 3998 + "1"
        for _ in range(3):
            root = {"op": "place", "scale": factor, "of": root}
        done = self.build(root, expect=4)
        self.assertIn("out.vjson: not written, it would not be read back: cell 0 has a number of more than 5096 digits", done.stderr.replace("\n    ", " "))
        self.assertFalse(self.out.exists())
        self.build(root, "--max-digits", 20000)
        self.assertEqual(run("info", "--max-digits", 20000, self.out).returncode, 0)

    def test_the_volumes_can_go_to_standard_output(self):
        tree = self.folder / "tree.json"
        tree.write_text('{"root": {"radius": 1, "op": "sphere"}, "format": "veritope-tree-1"}')
        done = run("build", tree, "-o", "-")
        self.assertEqual(len(json.loads(done.stdout)["entities"]), 7)


if __name__ == "__main__":
    support.main()
