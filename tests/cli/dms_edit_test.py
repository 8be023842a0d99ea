#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope dms refine, boundary and edit: values before and after, beside fractions; surfaces that certify decides; refusals."""
import json
import math
import re
import unittest
from fractions import Fraction as F

import schema
from support import MODELS, ROOT, Folder, run

DOMAIN, TETRAHEDRON, CLOUDS = (MODELS / "dms" / name for name in ("domain.vdms", "tetrahedron.vdms", "inner_clouds.vdms"))
POINTS = ["1/4 1/4 1/4", "1/3 1/5 1/7", "1/10 1/10 1/10", "0 0 0", "1 0 0", "1/3 1/3 1/3", "1/2 1/4 0", "1/8 1/8 5/8", "5/16 1/4 3/16"]

PAGE = (ROOT / "docs" / "cli" / "dms-edit.md").read_text().split("```json\n")[1].split("```")[0]


def texts(numbers):
    return [str(F(n)) for n in numbers]


class DmsEdit(Folder):
    def values(self, model):
        done = run("dms", "eval", model, "-", "--exact", input="".join(p + "\n" for p in POINTS), cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        return done.stdout

    def refused(self, status, *words, output="x.vdms", text=""):
        done = run("dms", *words, "-o", output, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (status, ""), done)
        self.assertIn(text, " ".join(done.stderr.split()))
        self.assertFalse((self.folder / output).exists())

    def test_insertions_leave_values_equal(self):
        for model, at, clouds in ((TETRAHEDRON, "1/4,1/5,0x1p-3", ("1/4,1/5,1/7", "1/4,1/5,1/7;0.3,0.2,0.1")),
                                  (CLOUDS, "1/10,1/9,1/8", ("1/10,1/9,1/7",)),
                                  (DOMAIN, "1/10,1/9,1/8", ("1,1,1",))):
            for options in [()] + [("--cloud", c) for c in clouds]:
                done = run("dms", "refine", model, "--at", at, *options, "-o", "r.vdms", cwd=self.folder)
                self.assertEqual((done.returncode, done.stderr), (0, ""), done)
                self.assertRegex(done.stdout, r"^wrote  r.vdms  vertex [45] in tetrahedron \d, [47] tetrahedra, \d+ control points\n$")
                self.assertEqual(self.values("r.vdms"), self.values(model))
                document = json.loads((self.folder / "r.vdms").read_text())
                last = [[str(F(float.fromhex(c)) if "x" in c else F(c)) for c in p.split(",")] for p in ";".join((at, *options[1:])).split(";")]
                self.assertEqual(document["vertices"][-1], last)
                self.assertEqual(run("certify", "r.vdms", cwd=self.folder).returncode, 0)
                done = run("dms", "refine", model, "--at", at, *options, "-o", "-", cwd=self.folder)
                self.assertEqual(done.stdout, (self.folder / "r.vdms").read_text())

    def test_insertions_that_are_refused(self):
        for at, words in (("2,0,0", "the point is outside of the domain"), ("0,0,0", "the point is at vertex 0")):
            self.refused(2, "refine", TETRAHEDRON, "--at", at, text=words)
        for at in "1,2", "1,2,3,4", "a,b,c", "nan,0,0", "1,,2":
            self.refused(2, "refine", TETRAHEDRON, "--at", at, text="--at")
        self.refused(2, "refine", TETRAHEDRON, text="--at x,y,z is required")
        self.refused(2, "refine", TETRAHEDRON, "--at", "1/4,1/4,1/4", "--cloud", "1,1,1;2,2,2;3,3,3", text="1, 2 or 3 knots, not 4")
        self.refused(2, "refine", TETRAHEDRON, "--at", "1/4,1/4,1/4", "--cloud", "1,1", text="--cloud")
        self.refused(1, "refine", TETRAHEDRON, "--at", "1/4,1/4,1/4", "--cloud", "2,2,2", text="with the new vertex: cloud-degenerate: tetrahedron")
        self.refused(1, "refine", self.separate(), "--at", "1/4,1/4,1/4", text="these are separate")
        for verb in (("refine", "--at", "1/4,1/5,1/6"), ("boundary",)):
            self.refused(1, verb[0], self.reversed(), *verb[1:], text="tet-reversed: tetrahedron 0")
            self.refused(4, verb[0], "nothing.vdms", *verb[1:])
            self.refused(4, verb[0], MODELS / "m3_crack.stl", *verb[1:])

    def reversed(self):
        text = TETRAHEDRON.read_text().replace("[0,1,2,3]]", "[1,0,2,3]]")
        (self.folder / "reversed.vdms").write_text(text)
        return "reversed.vdms"

    def separate(self):
        model = json.loads(TETRAHEDRON.read_text())
        model["vertices"] = [cloud[:1] for cloud in model["vertices"]]
        model["control"] = [{"tetrahedron": 0, "beta": [entry["at"].count(m) for m in range(4)], "value": entry["value"]}
                            for entry in model["control"]]
        (self.folder / "separate.vdms").write_text(json.dumps(model))
        return "separate.vdms"

    def test_surfaces_are_decided_as_patches(self):
        run("dms", "make", DOMAIN, "-o", "creased.vdms", "--degree", "2", "--clouds", "1/10:7", cwd=self.folder)
        for model, patches in ((TETRAHEDRON, 4), (CLOUDS, 4), (self.separate(), 4), ("creased.vdms", 20)):
            done = run("dms", "boundary", model, "-o", "b.vjson", cwd=self.folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done)
            self.assertRegex(done.stdout, rf"^wrote  b.vjson  4 faces, {patches} Bezier triangles\n$")
            of_patches = run("certify", "b.vjson", "--json", "-", cwd=self.folder)
            of_model = run("certify", model, "--json", "-", cwd=self.folder)
            self.assertEqual((of_patches.returncode, of_model.returncode), (0, 0))
            surface, whole = (json.loads(d.stdout)["files"][0] for d in (of_patches, of_model))
            self.assertEqual(surface["verdict"], "VALID")
            self.assertEqual([s["genus"] for s in surface["shells"]], [s["genus"] for s in whole["shells"]])
            self.assertTrue(surface["volume"]["lo"] <= whole["volume"]["hi"] and whole["volume"]["lo"] <= surface["volume"]["hi"])
            done = run("dms", "boundary", model, "-o", "-", cwd=self.folder)
            self.assertEqual(done.stdout, (self.folder / "b.vjson").read_text())

    def edit(self, moves, model=TETRAHEDRON):
        (self.folder / "s.json").write_text(moves if isinstance(moves, str) else json.dumps(moves))
        done = run("dms", "edit", model, "s.json", "-o", "e.vdms", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        self.assertRegex(done.stdout, r"^wrote  e.vdms  \d+ moves?\n$")
        return json.loads((self.folder / "e.vdms").read_text())

    def unedited(self, moves, status, text, model=TETRAHEDRON):
        (self.folder / "s.json").write_text(moves if isinstance(moves, str) else json.dumps(moves))
        self.refused(status, "edit", model, "s.json", text=text)

    def test_moves_change_what_they_name_alone(self):
        before = json.loads(TETRAHEDRON.read_text())
        self.assertEqual(self.edit([]), before)
        after = self.edit([{"move": "control", "at": [1, 0], "by": ["1/8", "0.25", "-1"]}, {"move": "control", "to": ["5", "6", "7"], "at": [3, 3]},
                           {"move": "coefficient", "at": [0, 0], "attribute": "density", "by": "0x1p-1"},
                           {"move": "coefficient", "at": [2, 3], "attribute": "density", "to": "9"},
                           {"move": "knot", "vertex": 1, "knot": 1, "to": ["9/8", "0", "-1/16"]}, {"move": "knot", "vertex": 2, "knot": 1, "by": ["0", "1/16", "0"]}])
        control = {tuple(e["at"]): e for e in before["control"]}
        control[0, 1]["value"] = ["5/8", "1/4", "-1", "1/2"]
        control[3, 3]["value"] = ["5", "6", "7", "0"]
        control[0, 0]["value"][3] = "3/2"
        control[2, 3]["value"][3] = "9"
        before["vertices"][1][1] = ["9/8", "0", "-1/16"]
        before["vertices"][2][1] = ["0", "9/8", "0"]
        self.assertEqual(after, before)
        separate = self.edit([{"move": "control", "tetrahedron": 0, "beta": [1, 0, 1, 0], "to": ["1", "2", "3"]}], model=self.separate())
        (entry,) = (e for e in separate["control"] if e["beta"] == [1, 0, 1, 0])
        self.assertEqual(entry["value"], ["1", "2", "3", "1/2"])

    def test_lattices_move_as_bernstein_says(self):
        before = json.loads(TETRAHEDRON.read_text())
        by, low, size = ["1/3", "-2", "1/7"], [F(-1, 10), F(-1, 10), F(0)], [F(1), F(2), F(1)]
        box = [texts(low), texts(a + s for a, s in zip(low, size))]
        after = self.edit([{"move": "lattice", "box": box, "degree": [1, 2, 2], "counts": [2, 3, 4], "nodes": [{"at": [1, 1, 1], "by": by}]}])
        moved = 0
        for old, new in zip(before["control"], after["control"]):
            u = [(F(v) - a) / s for v, a, s in zip(old["value"], low, size)]
            share = F(0)
            if all(0 <= t <= 1 for t in u):
                t = 2 * u[2]  # knots 0 0 0 1 2 2 2: the second basis function
                last = 2 * t - F(3, 2) * t * t if t < 1 else (2 - t) ** 2 / 2
                share = u[0] * 2 * u[1] * (1 - u[1]) * last
            moved += share != 0
            self.assertEqual(new["value"], texts([F(v) + share * F(b) for v, b in zip(old["value"], by)] + old["value"][3:]))
        self.assertGreater(moved, 1)
        nodes = [{"at": [i, j, k], "by": ["1", "2", "3"]} for i in range(3) for j in range(4) for k in range(5)]
        after = self.edit([{"move": "lattice", "box": [["-9"] * 3, ["9"] * 3], "degree": [2, 3, 1], "counts": [3, 4, 5], "nodes": nodes}])
        for old, new in zip(before["control"], after["control"]):  # all nodes move alike, and so does the model
            self.assertEqual(new["value"], texts([F(v) + i + 1 for i, v in enumerate(old["value"][:3])] + old["value"][3:]))

    def test_skeletons_give_coefficients(self):
        corners = [["0", "0", "0"], ["1", "0", "0"], ["1", "1/3", "0"]]
        axes = [["1/2", "0", "0"], ["1/8", "1/4", "0"], ["0", "0", "1"]]
        after = self.edit([{"move": "skeleton", "attribute": "density", "skeletons": [
            {"point": ["0", "1/5", "1"], "over": ["1"], "under": ["1", "1"]},
            {"polyline": corners, "over": ["2", "1"], "under": ["1", "0", "1"], "weight": "-1/2"},
            {"ellipsoid": {"centre": ["1/2", "0", "0"], "axes": axes}, "over": ["3"], "under": ["1", "2"]}]}])

        def squared(x, a, b):
            along, away = [q - p for p, q in zip(a, b)], [p - q for p, q in zip(x, a)]
            t = min(max(sum(p * q for p, q in zip(along, away)) / sum(p * p for p in along), F(0)), F(1))
            return sum((p - t * q) ** 2 for p, q in zip(away, along))

        inside = 0
        for old, new in zip(json.loads(TETRAHEDRON.read_text())["control"], after["control"]):
            x = [F(v) for v in old["value"][:3]]
            s = sum((p - q) ** 2 for p, q in zip(x, (F(0), F(1, 5), F(1))))
            line = [[F(v) for v in c] for c in corners]
            r = min(squared(x, line[0], line[1]), squared(x, line[1], line[2]))
            t1 = 4 * x[1]
            e = max(F(0), (2 * (x[0] - F(1, 2) - t1 / 8)) ** 2 + t1 ** 2 + x[2] ** 2 - 1)
            inside += e == 0
            self.assertEqual(new["value"], texts([*x, 1 / (1 + s) - (2 + r) / (2 * (1 + r * r)) + 3 / (1 + 2 * e)]))
        self.assertGreater(inside, 1)

    def test_skeletons_are_rounded_if_that_is_asked_for(self):
        field = {"point": ["1/3", "1/7", "2"], "over": ["-1"], "under": ["1", "1"]}
        exact = self.edit([{"move": "skeleton", "attribute": "density", "skeletons": [field]}])
        for bits in 0, 1, 5, 60:
            after = self.edit([{"move": "skeleton", "attribute": "density", "skeletons": [field], "round": bits}])
            for old, new in zip(exact["control"], after["control"]):
                nearest = F(math.floor(F(old["value"][3]) * 2**bits + F(1, 2)), 2**bits)
                self.assertEqual(new["value"], [*old["value"][:3], str(nearest)])
        long = {**field, "point": [str(F(1, 3**400 + k)) for k in (1, 5, 7)], "under": ["1", "0", "1"]}
        self.unedited([{"move": "skeleton", "attribute": "density", "skeletons": [long]}], 4, "the key 'round'")
        self.edit([{"move": "skeleton", "attribute": "density", "skeletons": [long], "round": 40}])

    def test_scripts_that_break_conditions_are_refused(self):
        self.unedited([{"move": "knot", "vertex": 3, "knot": 0, "to": ["0", "0", "-1"]}], 1, "after the moves: tet-reversed: tetrahedron 0")
        self.unedited([{"move": "knot", "vertex": 1, "knot": 1, "by": ["-9", "0", "0"]}], 1, "after the moves: cloud-degenerate: tetrahedron 0, beta (0,1,0,0): d < 0")
        self.unedited([{"move": "knot", "vertex": 1, "knot": 1, "to": ["7/8", "1/16", "1/16"]}], 1, "after the moves: cloud-inside: tetrahedron 0, beta (0,1,0,0): the hull of these knots of a face of the boundary reaches into tetrahedron 0 at")
        back = [{"move": "knot", "vertex": 3, "knot": 0, "by": ["0", "0", sign + "2"]} for sign in ("-", "")]
        self.assertEqual(self.edit(back), json.loads(TETRAHEDRON.read_text()))  # the last state counts

    def test_wrong_scripts_have_their_place(self):
        point, field = ["0", "0", "0"], {"over": ["1"], "under": ["1"]}
        node = {"move": "lattice", "box": [["0"] * 3, ["1"] * 3], "degree": [1, 1, 1], "counts": [2, 2, 2], "nodes": []}
        for move, words in (({"by": point}, "the first key of a move must be 'move'"), ({}, "the key 'move' is missing"), ({"move": "twist"}, "not 'twist'"),
                            ({"move": "knot", "at": [0, 0]}, "unknown key 'at' of a move of kind 'knot'"),
                            ({"move": "control", "at": [0, 0]}, "one of the keys 'by' and 'to'"),
                            ({"move": "control", "at": [0, 0], "by": point, "to": point}, "one of the keys 'by' and 'to'"),
                            ({"move": "control", "by": point}, "the key 'at' is missing"), ({"move": "control", "at": [0], "by": point}, "must have 2 items, not 1"),
                            ({"move": "control", "at": [0, 4], "by": point}, "no tetrahedron has a control point"),
                            ({"move": "control", "tetrahedron": 0, "by": point}, "control points are shared"),
                            ({"move": "control", "at": [0, 0], "by": [0, 0, 0]}, "s.json: line 2"), ({"move": "control", "at": [0, 0], "by": ["0", "nan", "0"]}, "s.json: line 2"),
                            ({"move": "control", "at": [0, 0], "by": "1"}, "s.json: line 2"), ({"move": "control", "at": ["0", "0"], "by": point}, "s.json: line 2"),
                            ({"move": "control", "at": [0, 0], "by": [str(2**2048), "0", "0"]}, "below 2^2048"),
                            ({"move": "coefficient", "at": [0, 0], "attribute": "colour", "by": "1"}, "no attribute 'colour'"),
                            ({"move": "coefficient", "at": [0, 0], "by": "1"}, "the key 'attribute' is missing"),
                            ({"move": "knot", "vertex": 0, "knot": 1, "by": point}, "knot 1 of vertex 0, whose cloud has 1"),
                            ({"move": "knot", "vertex": 4, "knot": 0, "by": point}, "s.json: line 2"), ({"move": "knot", "vertex": 0, "by": point}, "the key 'knot' is missing"),
                            ({**node, "box": [["0"] * 3, ["1", "1", "0"]]}, "must ascend"), ({**node, "degree": [1, 0, 1]}, "degrees from 1 to 9"),
                            ({**node, "degree": [1, 2, 1]}, "more nodes than its degree"), ({**node, "counts": [2, 2]}, "must have 3 items, not 2"),
                            ({**node, "counts": [65, 2, 2]}, "the counts of a lattice must be an integer from 2 to 64, not '65'"),
                            ({**node, "degree": [1, 10, 1]}, "the degree of a lattice must be an integer from 1 to 9, not '10'"),
                            ({**node, "nodes": [{"at": [0, 0, 2], "by": point}]}, "number 2 of 2 along axis 2"),
                            ({**node, "nodes": [{"at": [0, 0, 0]}]}, "the key 'by' is missing"),
                            ({"move": "skeleton", "attribute": "density", "skeletons": [], "round": 1001}, "s.json: line 2"),
                            ({"move": "skeleton", "attribute": "density", "skeletons": [field]}, "one of the keys 'point', 'polyline'"),
                            ({"move": "skeleton", "attribute": "density", "skeletons": [{**field, "point": point, "polyline": [point]}]}, "one of the keys"),
                            ({"move": "skeleton", "attribute": "density", "skeletons": [{**field, "polyline": []}]}, "at least one point"),
                            ({"move": "skeleton", "attribute": "density", "skeletons": [{**field, "over": [], "point": point}]}, "at least one term"),
                            ({"move": "skeleton", "attribute": "density", "skeletons": [{**field, "ellipsoid": {"centre": point, "axes": [point] * 3}}]}, "in one plane"),
                            ({"move": "skeleton", "attribute": "density", "skeletons": [{"over": ["1"], "under": ["0", "1"], "point": point}]},
                             "move 0: a field's denominator is 0 at the control point (0, 0, 0)")):
            self.unedited("[\n" + json.dumps(move) + "]", 4, words)
        for text in "", "[", "{}", "[] []", '[{"move": "knot", "vertex": 0, "vertex": 0, "knot": 0, "by": ["0", "0", "0"]}]':
            self.unedited(text, 4, "s.json")
        self.unedited([{"move": "control", "at": [0, 0], "by": point}], 4, "control points are separate", model=self.separate())
        self.unedited([{"move": "control", "tetrahedron": 0, "beta": [1, 0, 0, 0], "by": point}], 4, "must add up to 2", model=self.separate())
        self.unedited([{"move": "control", "tetrahedron": 1, "beta": [2, 0, 0, 0], "by": point}], 4, "s.json", model=self.separate())
        self.refused(4, "edit", TETRAHEDRON, "nothing.json")
        self.refused(2, "edit", "-", "-", text="only one of M and SCRIPT")
        (self.folder / "s.json").write_text("[]")
        self.refused(1, "edit", self.reversed(), "s.json", text="tet-reversed: tetrahedron 0")

    def test_the_script_on_the_page_runs(self):
        after = self.edit(PAGE)
        self.assertEqual(after["vertices"][1][1], ["5/4", "0", "0"])
        done = run("dms", "edit", TETRAHEDRON, "-", "-o", "-", input=PAGE, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (0, (self.folder / "e.vdms").read_text()))

    @unittest.skipIf(schema.jsonschema is None, "python3-jsonschema is not installed")
    def test_scripts_obey_the_schema_and_the_schema_is_tight(self):
        of_moves = json.loads((ROOT / "docs" / "formats" / "dms-moves.schema.json").read_text())
        validator = schema.jsonschema.Draft202012Validator(of_moves)
        validator.check_schema(of_moves)
        moves = json.loads(PAGE)
        self.assertEqual([], [e.message for e in validator.iter_errors(moves)])
        self.assertTrue(validator.is_valid([{"move": "control", "tetrahedron": 0, "beta": [2, 0, 0, 0], "by": ["0"] * 3}]))
        for i, move in enumerate(moves):
            for key in move:
                broken = [dict(m) for m in moves]
                del broken[i][key]
                self.assertFalse(validator.is_valid(broken), (i, key))
            self.assertFalse(validator.is_valid([{**move, "more": 0}]))
            self.assertFalse(validator.is_valid([{**move, "move": "twist"}]))
        self.assertFalse(validator.is_valid([{**moves[0], "to": ["0"] * 3}]))

    def test_help_fits_and_options_are_on_the_pages(self):
        for verb in "refine", "boundary", "edit":
            done = run("dms", verb, "--help")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            lines = done.stdout.rstrip("\n").split("\n")
            self.assertLessEqual(len(lines), 25)
            self.assertLessEqual(max(map(len, lines)), 80)
            page = (ROOT / "docs" / "cli" / f"dms-{verb}.md").read_text()
            for option in set(re.findall(r"--[a-z-]+", done.stdout)) - {"--help"}:
                self.assertIn(option if not option.startswith("--max-") else "--max-...", page)


if __name__ == "__main__":
    unittest.main()
