# SPDX-License-Identifier: LGPL-3.0-or-later
"""Certificates of answers about expressions: made by veritope classify, accepted by both checkers, and by neither if anything is changed."""
import json
import os
import pathlib
import random
import re
import sys
import unittest

import boolean_test
import support
from support import BIN, MODELS, run

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "mutation"))
import expression_forge  # noqa: E402
import patch_points_forge  # noqa: E402

CUBE = MODELS / "patches" / "cube.itd"
POINTS = ("0.5 .5 .5", "1 0.5 0.5", "1 0 0.5", "1 1 1", "0.25 0.5 0.5", "9 9 9", "0 1/3 0x1p-2", "1/3 1/7 1/9")


class AnsweredExpressions(boolean_test.Expressions):
    """Answers with certificates, and both checkers."""

    def answer(self, expression, *bindings, points=POINTS, options=(), status=0):
        """Writes e.json, answers, c; the JSON report."""
        self.boolean(expression, *bindings, "-o", "e.json")
        self.file("points.txt", "".join(p + "\n" for p in points))
        done = run("classify", "e.json", "points.txt", "-o", "answers", "--certificate", "c", "--json", "report.json", *options, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.errors = re.sub(r"\s+", " ", done.stderr)
        return json.loads((self.folder / "report.json").read_text())

    def check(self, status, said, *files):
        """Both checkers about e.json, c, answers, or these files."""
        files = files or ("e.json", "c", "answers")
        for program in ([BIN / "veritope-check"], [sys.executable, "-B", support.CHECKER_PY]):
            done = run(*program[1:], *files, program=program[0], cwd=self.folder)
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)
            self.assertIn(said, done.stdout + done.stderr)


class Certificates(AnsweredExpressions):
    def change(self, name, *pairs):
        text = (self.folder / name).read_text()
        for old, new in pairs:
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        self.file(name, text)

    def test_every_answer_is_covered_where_walls_are_flat(self):
        for expression in "A | B", "A & B", "A - B", "A - A", "!(A - B) + B", "A & !B", "(A | B) - C", "!A & !B & !C":
            names = [f"{name}={name.lower()}.off" for name in "ABC" if name in expression]
            report = self.answer(expression, *names)
            size = (self.folder / "c").stat().st_size
            self.assertEqual(report["certificate"], {"path": "c", "bytes": size, "uncovered": 0, "checked": True})
            self.check(0, "points-1: 8 points")
            self.check(0, "0 not covered")

    def test_spline_operands_and_nested_files(self):
        self.boolean("A - C", "A=a.off", "C=c.off", "-o", "inner.json")
        volumes = MODELS / "splines" / "two_cubes.mesh"       # by its boundary faces
        self.assertEqual(self.answer("X | S | X - V", "X=inner.json", f"S={CUBE}", f"V={volumes}")["certificate"]["uncovered"], 0)
        self.check(0, "8 points")
        self.change("inner.json", ("A - C", "C - A"))
        self.check(1, "O1")

    def test_a_point_where_a_curved_wall_meets_another_is_not_covered(self):
        (self.folder / "ball.vjson").write_bytes(patch_points_forge.Solid([patch_points_forge.ball()]).encode())
        self.file("half.off", boolean_test.box((0, -2, -2), (2, 2, 2)))
        report = self.answer("B & H", "B=ball.vjson", "H=half.off", points=("0 3/5 4/5", "3/5 0 4/5", "0.5 0 0", "0 0.25 0.25", "1 1 1"))
        self.assertEqual(report["counts"], {"points": 5, "in": 1, "on": 3, "out": 1, "undecided": 0})
        self.assertEqual(report["certificate"]["uncovered"], 1)
        self.check(0, "1 not covered")
        self.change("answers", ("0 3/5 4/5 on - -", "0 3/5 4/5 in 1 -"))   # of this one nothing is claimed, but the file is another
        self.check(1, "A1")

    def test_random_expressions(self):
        """All words are those of an oracle that knows neither rays nor wedges, and all are covered."""
        first, count = int(os.environ.get("VT_TEST_SEED", "0")), 12 * int(os.environ.get("VT_TEST_SCALE", "1"))
        for seed in range(first, first + count):
            rng = random.Random(seed)
            subject = expression_forge.random_subject(rng)
            points = list(expression_forge.interesting(subject, rng, 60))
            for name, data in {"e.json": subject.chain.data, **subject.chain.files()}.items():
                path = self.folder / str(seed) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
            files = [f"{seed}/{name}" for name in ("e.json", "words.cert", "words.txt")]
            self.file(f"{seed}/points.txt", "".join("%s %s %s\n" % tuple(q) for q in points))
            done = run("classify", files[0], f"{seed}/points.txt", "-o", files[2], "--certificate", files[1], *["--as-indexed"] * subject.as_indexed, cwd=self.folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""), seed)
            words = [line.split()[3] for line in (self.folder / files[2]).read_text().splitlines()]
            self.assertEqual(words, [subject.word(q) for q in points], seed)
            self.check(0, "points-1: 60 points", *files)
            self.check(0, " 0 not covered", *files)

    def test_points_need_at_most_a_few_bytes(self):
        points = ["%d/7 %d/11 %d/13" % (i % 20 - 3, i // 20 % 20, i % 17) for i in range(2000)]
        self.answer("(A | B) - C", "A=a.off", "B=b.off", "C=c.off", points=points)
        body = (self.folder / "c").read_bytes().split(b"\n", 1)[1]
        self.assertLess(len(body), 2000)

    def test_changes_are_noticed(self):
        self.answer("A | B", "A=a.off", "B=b.off")
        files = {name: (self.folder / name).read_text() for name in ("e.json", "answers", "a.off")}
        certificate = (self.folder / "c").read_bytes()
        for name, pair, said in (("answers", ("in 1", "out 0"), "A1"), ("answers", ("9 9 9", "9 9 8"), "A1"), ("a.off", ("1 1 1", "1 1 2"), "O1"),
                                 ("e.json", ("A | B", "B | A"), "S3")):
            self.change(name, pair)
            self.check(1, said)
            self.file(name, files[name])
        self.file("c", "")
        (self.folder / "c").write_bytes(certificate[:-1])
        self.check(1, "S4")
        (self.folder / "c").write_bytes(certificate)
        self.check(2, "", "e.json", "c")
        (self.folder / "a.off").unlink()
        self.check(4, "a.off")
        (self.folder / "a.off").mkdir()
        self.check(4, "is not a regular file")

    def test_an_output_is_no_operand(self):
        self.boolean("A | B", "A=a.off", "B=b.off", "-o", "e.json")
        self.file("points.txt", "0 0 0\n")
        for options in ("-o", "a.off"), ("-o", "x", "--certificate", "./b.off"), ("-o", "x", "--json", "b.off"):
            done = run("classify", "e.json", "points.txt", *options, cwd=self.folder)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, "the output (./)?[ab].off is the input [ab].off")
        self.assertEqual((self.folder / "a.off").read_text(), boolean_test.box((0, 0, 0), (1, 1, 1)))

    def test_the_checkers_read_operands_beside_the_file_from_elsewhere(self):
        self.answer("A | B", "A=a.off", "B=b.off")
        for program in ([BIN / "veritope-check"], [sys.executable, "-B", support.CHECKER_PY]):
            done = run(*program[1:], *(self.folder / name for name in ("e.json", "c", "answers")), program=program[0], cwd="/")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_an_operand_that_the_checkers_do_not_read(self):
        self.file("block.itd", "[OBJECT NONE\n" + "".join(
            "  [POLYGON %d\n%s  ]\n" % (len(f), "".join("    [%d %d %d]\n" % (i & 1, i >> 1 & 1, i >> 2) for i in reversed(f))) for f in boolean_test.FACES) + "]\n")
        report = self.answer("A | B", "A=block.itd", "B=b.off", status=3)
        self.assertIn("have no certificate: block.itd: the checkers read meshes, not these polygons", self.errors)
        self.assertIsNone(report["certificate"])
        self.assertFalse((self.folder / "c").exists())


if __name__ == "__main__":
    unittest.main()
