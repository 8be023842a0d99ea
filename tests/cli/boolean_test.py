# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope boolean, and classify of what it writes: words on shared walls, files that name each other, statuses, messages."""
import hashlib
import json
import os
import pathlib
import re
import struct
import unittest

import schema
from cylinders import cylinder
from support import MODELS, Folder, run

FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
SPLINES = MODELS / "patches" / "cube.itd"


def box(low, high, faces=FACES):
    rows = ["%r %r %r\n" % tuple((low, high)[i >> k & 1][k] for k in range(3)) for i in range(8)]
    return f"OFF\n8 {len(faces)} 0\n" + "".join(rows) + "".join("4 %d %d %d %d\n" % f for f in faces)


class Expressions(Folder):
    """A folder with blocks, and what writes and asks expressions of them."""

    def setUp(self):
        super().setUp()
        self.file("a.off", box((0, 0, 0), (1, 1, 1)))
        self.file("b.off", box((1, 0, 0), (2, 1, 1)))
        self.file("c.off", box((0, 0, 0), (0.5, 0.5, 0.5)))
        self.file("open.off", box((0, 0, 0), (1, 1, 1), FACES[1:]))

    def file(self, name, content):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(content)
        return path

    def boolean(self, *arguments, status=0):
        done = run("boolean", *arguments, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout if status == 0 else re.sub(r"\s+", " ", done.stderr)

    def classify(self, chain, *points, options=(), status=0):
        """The words of the points."""
        self.file("points.txt", "".join(p + "\n" for p in points))
        done = run("classify", chain, "points.txt", *options, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        if status != 0:
            self.assertEqual(done.stdout, "")
            return re.sub(r"\s+", " ", done.stderr)
        return [line.split()[3] for line in done.stdout.splitlines()]


class Boolean(Expressions):
    def test_walls_that_two_blocks_share(self):
        points = "1 .5 .5", "1 0 .5", "0.5 0.5 0.5", "3 0 0", "1/3 0 1/7", "1 1/3 0x1p-3"
        for expression, words in (("A | B", "in on in out on in"), ("A + B", "in on in out on in"), ("A & B", "out out out out out out"), ("A - B", "on on in out on on"),
                                  ("A - A", "out out out out out out"), ("A & !B", "on on in out on on"), ("!(A - B)", "on on out in on on"), ("!(A | B) | A | B", "in in in in in in")):
            names = [f"{name}={name.lower()}.off" for name in "AB" if name in expression]
            self.boolean(expression, *names, "-o", "e.json")
            self.assertEqual(" ".join(self.classify("e.json", *points)), words, expression)

    def test_lines_have_f_and_no_shell(self):
        self.boolean("A | B", "A=a.off", "B=b.off", "-o", "e.json")
        self.file("points.txt", "x,y,z\n.5 .5 .5\n0 0 0\n9,9;9\n")
        done = run("classify", "e.json", "points.txt", "--json", "j.json", "-o", "answers.txt", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual((self.folder / "answers.txt").read_text(), ".5 .5 .5 in 1 -\n0 0 0 on - -\n9 9 9 out 0 -\n")
        report = json.loads((self.folder / "j.json").read_text())
        self.assertEqual(schema.faults(report), [])
        self.assertEqual(report["counts"], {"points": 3, "in": 1, "on": 1, "out": 1, "undecided": 0})
        self.assertEqual(report["model"]["sha256"], hashlib.sha256((self.folder / "e.json").read_bytes()).hexdigest())

    def test_the_chain_file_names_operands_relative_to_itself(self):
        (self.folder / "sub").mkdir()
        self.assertEqual(self.boolean('A - "b.off"', "A=a.off", "-o", "sub/e.json"), "wrote  sub/e.json  2 operands, depth 1, 2 different solids\n")
        chain = json.loads((self.folder / "sub" / "e.json").read_text())
        digest = hashlib.sha256((self.folder / "a.off").read_bytes()).hexdigest()
        self.assertEqual(list(chain), ["schema", "tool", "expression", "operands", "box", "boundary"])
        self.assertEqual((chain["schema"], chain["expression"], chain["boundary"]), ("veritope-chain-1", "A - file1", "not certified"))
        self.assertEqual(chain["operands"][0], {"name": "A", "path": "../a.off", "sha256": digest, "format": "off"})
        self.assertEqual(chain["box"], ["-2", "-1", "-1", "4", "2", "2"])
        self.assertEqual(self.classify("sub/e.json", ".5 .5 .5"), ["in"])
        os.rename(self.folder / "sub", self.folder / "moved")
        self.assertEqual(self.classify("moved/e.json", ".5 .5 .5"), ["in"])

    def test_equal_files_are_one_solid(self):
        self.file("copy.off", (self.folder / "a.off").read_text())
        report = json.loads(self.boolean("A - B | A", "A=a.off", "B=copy.off", "-o", "e.json", "--json", "-"))
        self.assertEqual(schema.faults(report), [])
        self.assertEqual(report["size"], {"operands": 3, "depth": 2, "variables": 1})
        self.assertEqual(report["normal_form"], "(x0 & !x0) | x0")
        self.assertEqual(self.classify("e.json", "0 0 0", ".5 .5 .5"), ["on", "in"])

    def test_expressions_are_operands(self):
        self.boolean("A | B", "A=a.off", "B=b.off", "-o", "u.json")
        self.boolean("U - C", "U=u.json", "C=c.off", "-o", "e.json")
        self.boolean("!E", "E=e.json", "-o", "n.json", "--json", "j.json")
        report = json.loads((self.folder / "j.json").read_text())
        self.assertEqual(report["normal_form"], "x3 & ((!x0 & !x1) | x2)")
        self.assertEqual(report["operands"][0]["format"], "chain")
        self.assertEqual(report["size"], {"operands": 3, "depth": 3, "variables": 4})
        words = self.classify("n.json", "1 .75 .75", ".25 .25 .25", ".5 .25 .25", "0 .25 .25", "-26 0 0", "-9 0 0")
        self.assertEqual(words, ["out", "in", "on", "in", "on", "in"])

    def test_the_box_of_complements(self):
        self.boolean("!A", "A=a.off", "-o", "e.json", "--box", "-1,-1,-1,1.5,4/3,0x1p1")
        words = self.classify("e.json", "-1 0 0", "0 4/3 0", "0 1.3333333333333333 0", "1.5 1.5 1.5", "1.25 1.25 2")
        self.assertEqual(words, ["on", "on", "in", "out", "on"])
        self.boolean("!A", "A=a.off", "-o", "e.json", "--box", "-.1,-.1,-.1,1.1,1.1,1.1")
        self.assertEqual(self.classify("e.json", "-.1 0 0", "-1/10 0 0"), ["on", "in"])  # decimals are the nearest binary64 numbers
        for bounds, words in (("0,-1,-1,2,2,2", "the operand A is not in the interior of the box"), ("1,2,3", "--box: needs six bounds X0,Y0,Z0,X1,Y1,Z1, and there are 3"),
                              ("0,0,0,1,0,1", "--box: has no interior: 0,0,0,1,0,1"), ("0,0,0,1,x,1", "and has 'x'"), ("0,0,0,1,1e999,1", "which is beyond binary64")):
            self.assertIn(words, self.boolean("!A", "A=a.off", "-o", "x.json", "--box", bounds, status=2))
        self.assertFalse((self.folder / "x.json").exists())

    def test_operands_may_be_spline_models(self):
        """The unit cube in flat patches, without half of a mesh of itself."""
        self.file("half.off", box((0, 0, 0), (1, 1, .5)))
        self.boolean("A - B", f"A={SPLINES}", "B=half.off", "-o", "e.json")
        self.assertEqual(self.classify("e.json", ".5 .5 .75", ".5 .5 .25", ".5 .5 .5", "1 .5 .75", "1 .5 .25", "1 1 1", "1/3 1/3 1"),
                         ["in", "out", "on", "on", "out", "on", "on"])

    def test_curved_solids_abut_or_touch(self):
        """Three cylinders of radius 1: the second one stands on the first one, the third one touches both along a line."""
        for name, (x, low, high) in (("low", (0, 0, 2)), ("high", (0, 2, 4)), ("beside", (2, 0, 4))):
            self.file(f"{name}.vjson", cylinder(x, low, high))
        points = "0 0 2", "3/5 4/5 2", "1/4 0 2", "0 1 1", "2 0 2"
        for expression, words in ("L | H", "in on in on out"), ("L & H", "out out out out out"), ("L - H", "on on on on out"):
            self.boolean(expression, "L=low.vjson", "H=high.vjson", "-o", "e.json")
            self.assertEqual(" ".join(self.classify("e.json", *points)), words, expression)
        self.boolean("L & B", "L=low.vjson", "B=beside.vjson", "-o", "e.json")
        done = run("classify", "e.json", "-", "--json", "j.json", cwd=self.folder, input="0 0 1\n1 0 1\n")
        self.assertEqual((done.returncode, done.stdout), (3, "0 0 1 out 0 -\n1 0 1 undecided - -\n"))
        self.assertEqual(json.loads((self.folder / "j.json").read_text())["undecided"],
                         [{"line": 2, "reason": "face 0 of low.vjson and face 3 of beside.vjson touch there"}])
        self.assertIn("1 of 2 points are undecided; line 2: face 0 of low.vjson and", " ".join(done.stderr.split()))
        self.assertEqual(json.loads((self.folder / "j.json").read_text())["undecided_not_listed"], 0)
        many = "".join(f"1 0 {i}/100\n" for i in range(1, 151))              # the cylinders touch along a line
        done = run("classify", "e.json", "-", "--json", "j.json", "-o", "a.txt", cwd=self.folder, input=many)
        report = json.loads((self.folder / "j.json").read_text())
        self.assertEqual((done.returncode, schema.faults(report)), (3, []))
        self.assertEqual((report["counts"]["undecided"], report["undecided_not_listed"]), (150, 50))
        self.assertEqual([u["line"] for u in report["undecided"]], list(range(1, 101)))

    def test_operands_are_decided_first(self):
        self.assertIn("operand B: INVALID open.off", self.boolean("A | B", "A=a.off", "B=open.off", "-o", "x.json", status=1))
        self.assertIn("M3", self.boolean("A | B", "A=a.off", "B=open.off", "-o", "x.json", status=1))
        self.assertIn("operand B: none.off: cannot be read", self.boolean("A | B", "A=a.off", "B=none.off", "-o", "x.json", status=4))
        # The exit status of several is the first of 5, 1, 4, 3.
        self.boolean("A | B | C", "A=a.off", "B=open.off", "C=none.off", "-o", "x.json", status=1)
        self.assertFalse((self.folder / "x.json").exists())
        self.boolean("A | B", "A=a.off", "B=b.off", "-o", "e.json")
        chain = (self.folder / "e.json").read_text()
        digest = hashlib.sha256((self.folder / "b.off").read_bytes()).hexdigest()
        for path, status in (("open.off", 1), ("none.off", 4)):
            new = hashlib.sha256((self.folder / path).read_bytes()).hexdigest() if status == 1 else digest
            self.file("x.json", chain.replace("b.off", path).replace(digest, new))
            self.assertIn("operand B: ", self.classify("x.json", "0 0 0", status=status))

    def test_changed_operands_and_files_that_contain_themselves_are_refused(self):
        self.boolean("A | B", "A=a.off", "B=b.off", "-o", "e.json")
        chain = (self.folder / "e.json").read_text()
        self.file("b.off", box((1, 0, 0), (3, 1, 1)))
        self.assertIn("operand B: b.off has changed since the expression was made", self.classify("e.json", "0 0 0", status=4))
        self.boolean("A", "A=a.off", "-o", "x.json")
        own = json.loads((self.folder / "x.json").read_text())
        own["operands"][0].update(path="x.json", format="chain")
        self.file("x.json", json.dumps(own))
        self.assertIn("x.json is an operand of itself", self.classify("x.json", "0 0 0", status=4))
        self.file("y.json", json.dumps(own).replace("x.json", "z.json"))
        self.file("z.json", json.dumps(own).replace("x.json", "y.json"))
        self.classify("y.json", "0 0 0", status=4)
        broken = chain.replace('"boundary"', '"border"')
        self.file("x.json", broken)
        self.assertIn("x.json: line 8: unknown key 'border'", self.classify("x.json", "0 0 0", status=4))
        self.file("x.json", chain.replace('"off"', '"foo"'))
        self.assertIn("there is no format 'foo'", self.classify("x.json", "0 0 0", status=4))
        self.file("x.json", chain.replace('"-2"', '"0"').replace("b.off", "c.off"))
        self.classify("x.json", "0 0 0", status=4)

    def test_points_of_all_kinds_and_any_number_of_threads(self):
        self.boolean("A | B", "A=a.off", "B=b.off", "-o", "e.json")
        rows = [(x / 4, y / 4, 0.5) for x in range(-2, 10) for y in range(-2, 7)]
        text = "".join("%r,%r;%r\n" % row for row in rows)
        self.file("points.txt", text)
        want = run("classify", "e.json", "points.txt", "--jobs", "1", cwd=self.folder).stdout
        self.assertEqual(len(want.splitlines()), len(rows))
        self.assertEqual(run("classify", "e.json", "points.txt", "--jobs", "3", cwd=self.folder).stdout, want)
        self.assertEqual(run("classify", "e.json", "-", cwd=self.folder, input=text).stdout, want)
        header = "{'descr': '<f8', 'fortran_order': False, 'shape': (%d, 3), }" % len(rows)
        header += " " * (-(len(header) + 11) % 64) + "\n"
        (self.folder / "points.npy").write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + b"".join(struct.pack("<3d", *r) for r in rows))
        answers = run("classify", "e.json", "points.npy", cwd=self.folder).stdout
        self.assertEqual([line.split()[3:] for line in answers.splitlines()], [line.split()[3:] for line in want.splitlines()])
        self.assertIn("column 5: 'x'", self.classify("e.json", "0 0 x", status=4))

    def test_files_in_files_have_a_limit(self):
        self.boolean("A", "A=a.off", "-o", "n0.json")
        for i in range(1001):
            chain = json.loads((self.folder / f"n{i}.json").read_text())
            digest = hashlib.sha256((self.folder / f"n{i}.json").read_bytes()).hexdigest()
            chain["operands"][0].update(path=f"n{i}.json", sha256=digest, format="chain")
            chain["box"] = [str(-i - 2)] * 3 + [str(i + 3)] * 3
            self.file(f"n{i + 1}.json", json.dumps(chain))
        self.assertEqual(self.classify("n999.json", "0 0 0", ".5 .5 .5"), ["on", "in"])
        self.assertIn("more than 1000 chain files in each other", self.classify("n1001.json", "0 0 0", status=4))

    def test_limits(self):
        wide = "|".join(["A"] * 10001)
        self.assertIn("more than 10000 operands", self.boolean(wide, "A=a.off", "-o", "x.json", status=4))
        self.assertIn("depth 1001", self.boolean("!" * 1001 + "A", "A=a.off", "-o", "x.json", status=4))
        self.boolean("!" * 1000 + "A", "A=a.off", "-o", "e.json")
        self.assertEqual(self.classify("e.json", "0 0 0", ".5 .5 .5", "1.5 0 0", "2 0 0", "3 0 0"), ["on", "in", "out", "out", "out"])
        self.boolean("|".join(["(A - B)"] * 5000), "A=a.off", "B=b.off", "-o", "e.json")
        self.assertEqual(self.classify("e.json", "1 .5 .5", ".5 .5 .5"), ["on", "in"])
        self.boolean("E | E", "E=e.json", "-o", "f.json", status=4)  # operands of operands count

    def test_usage(self):
        for arguments, words in ((("A | ", "A=a.off"), "EXPR: column 5: an operand expected"), (("A | B", "A=a.off"), "EXPR: column 5: the name B has no file"),
                                 (("A", "A=a.off", "B=b.off"), "EXPR does not use the name B"), (("A", "A=a.off", "A=b.off"), "the name A has two files"),
                                 (("A", "a.off"), "write NAME=FILE, not a.off"), (("A", "A=-"), "an operand is a file, not -")):
            self.assertIn(words, self.boolean(*arguments, "-o", "x.json", status=2))
        self.assertIn("does not end in .json", self.boolean("A", "A=a.off", "-o", "x.off", status=2))
        self.assertIn("-o OUT.json is required", self.boolean("A", "A=a.off", status=2))
        self.boolean("A", "A=a.off", "-o", "x.json", "--json", "x.json", status=2)
        self.boolean("A", "A=a.off", "-o", "nowhere/x.json", status=4)
        self.boolean("A", "A=a.off", "-o", "e.json")
        self.assertIn("the output e.json is the input e.json", self.boolean("E", "E=e.json", "-o", "e.json", status=2))
        for option in ("--winding",), ("--by", "normal"):
            self.assertIn("is an expression of solids", self.classify("e.json", "0 0 0", options=option, status=2))

    def test_other_commands_know_the_files(self):
        self.boolean("A", "A=a.off", "-o", "e.json")
        done = run("certify", "e.json", cwd=self.folder)
        self.assertEqual(done.returncode, 3)
        self.assertIn("UNDECIDED  e.json  this is a chain file", done.stdout)
        done = run("info", "e.json", cwd=self.folder)
        self.assertEqual(done.returncode, 4)
        self.assertIn("this is a chain file, an expression of solids", re.sub(r"\s+", " ", done.stdout + done.stderr))


if __name__ == "__main__":
    unittest.main()
