#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope micro with tiles of curves and sheets: filtered and written as splines, and in no .vmicro file."""
import csv
import json
import unittest
from fractions import Fraction

import schema
import support
from support import run


def entity(kind, shape):
    return {"kind": kind, "group": None, "attributes": [], "shape": shape}


def curve(points, degree=None, knots=None, rational=False):
    degree = degree or len(points) - 1
    return entity("curve", {"degrees": [degree], "periodic": [False], "knots": [knots or ["0"] * (degree + 1) + ["1"] * (degree + 1)],
                            "rational": rational, "components": len(points[0]), "points": points})


def box_off(low, high):
    ends = list(zip(low, high))
    return ("OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for z in ends[2] for y in ends[1] for x in ends[0]) +
            "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")


class MicroCurves(support.Folder):
    def setUp(self):
        super().setUp()
        self.cage = self.volumes("box", {"op": "box", "min": [0, 0, 0], "max": [4, 4, 4]})
        self.model, self.out = self.folder / "model.off", self.folder / "curves.vjson"
        self.model.write_text(box_off((0.5, 0.5, 0.5), (3.5, 3.25, 3.5)))

    def micro(self, *arguments, tile="curves3", counts="4,4,4"):
        return run("micro", "--cage", self.cage, "--tile", tile, "--counts", counts, *arguments, timeout=600)

    def emit(self, *arguments, path=None, **how):
        done = self.micro("--emit", path or self.out, "--json", "-", *arguments, **how)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        return report

    def points(self):
        return [[Fraction(x) for x in p] for e in json.loads(self.out.read_text())["entities"] for p in e["shape"]["points"]]

    def test_curves_in_the_interior_are_kept_and_written(self):
        listed = self.folder / "cells.csv"
        report = self.emit("--model", self.model, "--list", listed)
        # Cells 1 and 2 of four lie inside; those of the layers 0 and 3 cross, but for coils that stay clear of the wall.
        rows = list(csv.DictReader(listed.read_text().splitlines()))
        self.assertEqual(len(rows), 64)
        kept = [r for r in rows if r["status"] == "kept"]
        self.assertEqual(len(kept), report["tiles"]["kept"])
        self.assertEqual({(r["i"], r["j"], r["k"]) for r in kept}, {(i, j, k) for i in "12" for j in "12" for k in "12"})
        self.assertEqual((report["composed"]["patches"], report["composed"]["curves"], report["output"], report["genus"]), (8 * 12, 8 * 12, None, None))
        self.assertEqual({e["kind"] for e in json.loads(self.out.read_text())["entities"]}, {"curve"})
        self.assertTrue(all(Fraction(1, 2) < x < Fraction(7, 2) for p in self.points() for x in p))
        unbridged = self.emit("--model", self.model, "--bridge", "none")
        self.assertIsNone(unbridged["bridges"])
        self.assertTrue(all(1 <= x <= 3 for p in self.points() for x in p))

    def test_free_ends_are_bridged_to_the_surface(self):
        report = self.emit("--model", self.model, "--skin", "0.05")
        self.assertEqual(report["bridges"] | {"reach": None}, {"caps": 24, "built": 24, "kink_degrees": {"lo": 0, "hi": 0}, "reach": None,
                                                                "dropped": dict.fromkeys(("flat", "box", "folded", "tile", "skin", "bridge"), 0)})
        self.assertTrue(0 < report["bridges"]["reach"]["lo"] <= report["bridges"]["reach"]["hi"] <= 0.05, report["bridges"])
        document = json.loads(self.out.read_text())
        self.assertEqual([g["name"] for g in document["groups"]], ["bridges"])
        curves = [[[Fraction(x) for x in p] for p in e["shape"]["points"]] for e in document["entities"] if e["group"] is None]
        bridges = [[[Fraction(x) for x in p] for p in e["shape"]["points"]] for e in document["entities"] if e["group"] == 0]
        self.assertEqual((len(curves), len(bridges)), (96, 24))
        steps = {tuple(c[k]): [a - b for a, b in zip(c[k], c[k - 1 if k else 1])] for c in curves for k in (0, -1)}
        low, high = [Fraction(1, 2)] * 3, [Fraction(7, 2), Fraction(13, 4), Fraction(7, 2)]
        for p, q, r in bridges:
            step, way = steps[tuple(p)], [a - b for a, b in zip(q, p)]
            self.assertEqual([step[i] * way[j] for i in range(3) for j in range(3)], [step[j] * way[i] for i in range(3) for j in range(3)])
            self.assertGreater(sum(a * b for a, b in zip(step, way)), 0)
            depth = min(min(x - a, b - x) for x, a, b in zip(r, low, high))
            self.assertTrue(0 < depth <= Fraction(1, 20), r)
        self.assertIn("24 of 24 free ends", self.micro("--emit", self.out, "--model", self.model).stdout)

    def test_bridges_are_written_in_each_format_for_every_number_of_jobs(self):
        for ending in ("vjson", "itd", "vtu"):
            path, texts = self.folder / f"out.{ending}", []
            for jobs in (1, 2):
                self.emit("--model", self.model, "--jobs", jobs, path=path)
                texts.append(path.read_bytes())
            self.assertEqual(texts[0], texts[1])
            if ending == "vtu":
                numbers = {name: texts[0].split(f'Name="{name}"'.encode())[1].split(b"</DataArray>")[0].split(b">", 1)[1].split() for name in ("patch", "bridge", "tile", "types")}
                self.assertEqual((len(numbers["patch"]), len(numbers["bridge"]) - numbers["bridge"].count(b"-1"), set(numbers["tile"]), set(numbers["types"])), (120, 24, {b"0"}, {b"75"}))
            else:
                (info,) = json.loads(run("info", path, "--json", "-").stdout)["files"]
                self.assertEqual(info["counts"]["entities"], 120)

    def test_bridges_lead_to_models_of_splines_and_ends_that_none_reaches_are_counted(self):
        ball = self.volumes("ball", {"op": "place", "matrix": [[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 2]], "of": {"op": "sphere", "radius": "3/2"}})
        report = self.emit("--model", ball, "--alpha", "1/4", counts="6,6,6")
        self.assertEqual(report["bridges"]["caps"], report["bridges"]["built"])
        self.assertGreater(report["bridges"]["built"], 20)
        for e in json.loads(self.out.read_text())["entities"]:
            if e["group"] == 0:
                square = sum((Fraction(x) - 2) ** 2 for x in e["shape"]["points"][2])
                self.assertTrue(Fraction(7, 5) ** 2 < square < Fraction(3, 2) ** 2)
        report = self.emit("--model", self.model, "--skin", "1e-18")
        self.assertEqual((report["bridges"]["built"], report["bridges"]["dropped"]["skin"]), (0, 24))
        self.assertIn("0 of 24 free ends; not built: 24 skin", self.micro("--emit", self.out, "--model", self.model, "--skin", "1e-18").stdout)

    def test_curves_are_drawn(self):
        self.emit("--model", self.model)
        sheets = self.folder / "sheets.vjson"
        self.emit("--model", self.model, path=sheets, tile="jack-surfaces")
        for name in ("a.png", "a.vtu", "a.gltf", "a.obj"):
            picture = self.folder / name
            done = run("render", self.out, "-o", picture, "--around", self.model, "--json", "-", *(["--size", "200,150"] if name == "a.png" else []))
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            self.assertEqual(schema.faults(report), [])
            self.assertEqual((report["curves"], report["micro"]), ({"curves": 96, "sheets": 0, "bridges": 24, "around": str(self.model)}, None))
            done = run("render", self.out, "-o", picture, *([] if name == "a.vtu" else ["--chord", "0.5"]))
            self.assertIn("96 curves, 24 bridges", done.stdout, done.stderr)
        before = self.listing()
        for arguments, status, message in ((("--nets",), 2, "--nets is for files of volumes"), (("--explode", "1"), 2, "--explode is for"),
                                           (("--around", self.folder / "none.off"), 4, "none.off"), (("--grid", "4"), 3, "UNDECIDED"),
                                           (("--grid", "4", "--around", self.model), 2, "--around is for microstructures and curves")):
            done = run("render", self.out, "-o", self.folder / "b.png", *arguments)
            self.assertEqual(done.returncode, status, (arguments, done.stderr, done.stdout))
            self.assertIn(message, " ".join((done.stdout + done.stderr).split()))
        for other in (self.cage, self.model, sheets):
            done = run("render", other, "-o", self.folder / "b.png", "--around", self.model)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("--around is for microstructures and curves", done.stderr)
        self.assertEqual(self.listing(), before)

    def test_without_a_model_all_cells_are_written_in_each_format_for_every_number_of_jobs(self):
        for tile, patches, curves in (("curves3", 12, 12), ("curves3,radius=1/8,parts=7", 21, 21), ("jack-surfaces", 24, 0)):
            for ending in ("vjson", "itd", "vtu"):
                path, texts = self.folder / f"out.{ending}", []
                for jobs in (1, 2):
                    report = self.emit("--jobs", jobs, path=path, tile=tile, counts="2,3,1")
                    texts.append(path.read_bytes())
                self.assertEqual(texts[0], texts[1])
                self.assertEqual((report["composed"]["patches"], report["composed"]["curves"], report["tiles"]["kept"]), (6 * patches, 6 * curves, 6))
                if ending == "vtu":
                    types = texts[0].split(b'Name="types"')[1].split(b"</DataArray>")[0].splitlines()[1:]
                    self.assertEqual((len(types), set(types)), (6 * patches, {b"75" if curves else b"77"}))
                else:
                    (info,) = json.loads(run("info", path, "--json", "-").stdout)["files"]
                    self.assertEqual(info["counts"]["entities"], 6 * patches)

    def test_coils_of_neighbours_are_one_curve(self):
        self.emit(counts="2,1,1")
        pieces = [e["shape"]["points"] for e in json.loads(self.out.read_text())["entities"]]
        ends = [tuple(p[-1]) for p in pieces]
        # Each coil has 3 seams in its cell, and the coil along u goes on in the other cell: 2 * 9 + 1.
        self.assertEqual(sum(tuple(p[0]) in ends for p in pieces), 19)

    def test_a_thickness_and_a_place_are_used(self):
        self.emit("--thickness", "1/8+x/40", tile="jack-surfaces,degree=1", counts="2,1,1")
        self.assertEqual(len(json.loads(self.out.read_text())["entities"]), 48)
        tree = self.micro("--emit", self.out, "--tile", "jack-surfaces", "--place", "u*2", "--json", "-", counts="2,1,1")
        self.assertEqual((tree.returncode, json.loads(tree.stdout)["composed"]), (0, json.loads(tree.stdout)["composed"] | {"patches": 36, "curves": 12}))

    def test_files_of_curves_and_sheets_are_tiles(self):
        tile = self.folder / "tile.vjson"
        line = curve([["0", "1/2", "1/2"], ["1", "1/2", "1/2"]])
        spline = curve([["0", "0", "0"], ["0", "1", "0"], ["1", "1", "1"], ["1", "0", "1"]], 2, ["0", "0", "0", "1/3", "1", "1", "1"])
        sheet = entity("surface", {"degrees": [1, 1], "periodic": [False, False], "knots": [["0", "0", "1", "1"]] * 2, "rational": False,
                                   "components": 3, "points": [["0", "0", "1/4"], ["0", "1", "1/4"], ["1", "0", "1/4"], ["1", "1", "1/2"]]})
        for entities, patches, curves in (([line], 1, 1), ([spline, line], 3, 3), ([sheet], 1, 0), ([line, sheet, spline], 4, 3)):
            tile.write_text(json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities}))
            report = self.emit(tile=tile, counts="2,2,1")
            self.assertEqual((report["composed"]["patches"], report["composed"]["curves"]), (4 * patches, 4 * curves))
            self.assertEqual(self.micro("-o", self.folder / "out.vmicro", tile=tile).returncode, 4 if curves else 1)
        mesh = self.folder / "sheet.off"
        mesh.write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0.5\n4 0 1 2 3\n")
        self.assertEqual(self.emit(tile=mesh, counts="1,1,1")["composed"]["curves"], 0)

    def test_files_that_are_no_tiles_are_refused_with_the_reason(self):
        tile = self.folder / "tile.vjson"
        before = self.listing()
        high = [[str(Fraction(i, 8)), "0", "0"] for i in range(9)]
        for shape, message in ((curve([["0", "0", "0", "1"], ["1", "1", "1", "2"]], rational=True), "curve 0 is rational"),
                               (curve([["0", "0"], ["1", "1"]]), "curve 0 has 2 coordinates"),
                               (curve(high), "curve 0 has the degree 8"),
                               (curve([["0", "0", "0"], ["1", "9/8", "1"]]), "9/8")):
            tile.write_text(json.dumps({"format": "veritope-spline-1", "groups": [], "entities": [shape]}))
            done = self.micro("--emit", self.out, tile=tile)
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertIn(message, " ".join(done.stderr.split()))
            self.assertIn("tile.vjson", done.stderr)
        tile.unlink()
        self.assertEqual(self.listing(), before)

    def test_wrong_usage_is_refused_before_anything_is_read(self):
        vmicro, before = self.folder / "out.vmicro", self.listing()
        for arguments, tile, message in (
                (("-o", vmicro, "--emit", self.out), "curves3", "closed tiles only"), (("-o", vmicro), "jack-surfaces", "closed tiles only"),
                ((), "curves3", "--emit is required"), ((), "jack", "-o OUT.vmicro is required"), (("--emit", self.out), "jack", "-o OUT.vmicro is required"),
                (("--emit", self.out, "--mesh", self.folder / "m.ply", "--chord", "1"), "curves3", "--mesh"),
                (("--emit", self.out, "--connected"), "curves3", "--connected"), (("--emit", self.out, "--material", "heat=1"), "curves3", "--material"),
                (("--emit", self.out, "--model", self.model, "--skin", "0.1"), "jack-surfaces", "sheets get no bridges"),
                (("--emit", self.out, "--skin", "0.1"), "curves3", "--model"), (("--emit", self.out, "--bridge", "domain"), "curves3", "--model"),
                (("--emit", self.out, "--model", self.model, "--bridge", "none", "--alpha", "1/2"), "curves3", "--alpha"),
                (("--emit", self.out, "--double", "w=1"), "curves3", "--double"), (("--emit", self.out, "--thickness", "1/8"), "curves3", "--thickness"),
                (("--emit", self.out), "curves3,radius=1/4", "radius = 1/4"), (("--emit", self.out), "curves3,parts=0", "parts = 0"),
                (("--emit", self.out), "curves3,parts=x", "parts"), (("--emit", self.out), "curves3,node=1", "no key node"),
                (("--emit", self.folder / "a.stl"), "curves3", ".vtu")):
            done = self.micro(*arguments, tile=tile)
            self.assertEqual(done.returncode, 2, (arguments, done.stderr))
            self.assertIn(message, " ".join(done.stderr.split()))
        self.assertEqual(self.listing(), before)

    def test_without_tiles_nothing_is_written(self):
        self.model.write_text(box_off((0.5, 0.5, 0.5), (0.75, 0.75, 0.75)))
        report = self.emit("--model", self.model)
        self.assertEqual((report["tiles"]["kept"], report["composed"]), (0, None))
        self.assertFalse(self.out.exists())
        self.assertIn("wrote nothing", self.micro("--emit", self.out, "--model", self.model).stdout)
        unread = self.micro("--emit", self.out, "--model", self.folder / "missing.off")
        self.assertEqual((unread.returncode, unread.stdout), (4, ""))

    def test_a_composition_over_the_limit_of_degrees_is_refused(self):
        cage = self.folder / "cage.vjson"
        shape = json.loads(self.cage.read_text())
        degrees = [8, 8, 6]
        shape["entities"][0]["shape"] = {"degrees": degrees, "periodic": [False] * 3, "knots": [["0"] * (d + 1) + ["1"] * (d + 1) for d in degrees], "rational": False, "components": 3,
                                         "points": [[str(Fraction(i, 8)), str(Fraction(j, 8)), str(Fraction(k, 6))] for i in range(9) for j in range(9) for k in range(7)]}
        cage.write_text(json.dumps(shape))
        done = run("micro", "--cage", cage, "--tile", "curves3", "--counts", "1,1,1", "--emit", self.out, timeout=600)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("would have degree 66", " ".join(done.stderr.split()))
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
