#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope dms xray: integrals along segments beside fractions, the page, refusals."""
import json
import math
import re
import unittest
from fractions import Fraction as F

import schema
from dms_test import DOMAIN, TETRAHEDRON, bernstein
from support import ROOT, Folder, run


def at(ends, t):
    return [p + t * (q - p) for p, q in zip(ends[:3], ends[3:])]


def part_inside(ends):
    """The parameters for which a segment is in the unit tetrahedron, or None."""
    low, high = F(0), F(1)
    for value in (lambda t: at(ends, t)[0], lambda t: at(ends, t)[1], lambda t: at(ends, t)[2], lambda t: 1 - sum(at(ends, t))):
        here, there = value(F(0)), value(F(1))
        if here == there:
            if here < 0:
                return None
            continue
        cut = here / (here - there)
        low, high = (max(low, cut), high) if there > here else (low, min(high, cut))
    return (low, high) if low < high else None


class DmsXray(Folder):
    def integrate(self, model, segments, *options, status=0, attribute="density"):
        done = run("dms", "xray", model, "-", "--attribute", attribute, *options, "--json", "-", input="".join(s + "\n" for s in segments), cwd=self.folder)
        self.assertEqual(done.returncode, status, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(list(document), schema.keys_of("dms_xray"))
        return document

    def test_the_page_shows_what_the_program_prints(self):
        (self.folder / "tetrahedron.vdms").write_bytes(TETRAHEDRON.read_bytes())
        page = (ROOT / "docs" / "cli" / "dms-xray.md").read_text()
        block = page.split("```\n")[1]
        parts = re.split(r"(?m)^\$ ", block)[1:]
        self.assertEqual(len(parts), 2)
        for part in parts:
            command, answer = part.split("\n", 1)
            words = command.split()
            self.assertEqual(words[0], "echo")
            bar = words.index("|")
            self.assertEqual(words[bar + 1], "veritope")
            done = run(*words[bar + 2:], input=" ".join(words[1:bar]) + "\n", cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (0, answer), command)

    def test_integrals_beyond_binary64_are_infinite_and_long_segments_are_not(self):
        model = json.loads(TETRAHEDRON.read_text())
        for control in model["control"]:
            control["value"][3] = str(10**320)
        (self.folder / "high.vdms").write_text(json.dumps(model))
        for file, segment, answer in (("high.vdms", "0 0 0 1/2 0 0", "inf 0.0000000000000000e+00"), (TETRAHEDRON, "-1e200 0 0 1e200 0 0", "5.1851851851851849e-01 5.9540197189777389e-01")):
            done = run("dms", "xray", file, "-", "--attribute", "density", input=segment + "\n", cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout.split(" ", 1)[1]), (0, answer + "\n"), done.stderr)

    def test_integrals_of_a_collapsed_tetrahedron_are_simpsons(self):
        model = json.loads(TETRAHEDRON.read_text())
        model["vertices"] = [cloud[:1] for cloud in model["vertices"]]
        path = self.folder / "collapsed.vdms"
        path.write_text(json.dumps(model))
        segments = ["0 0 0 1/2 1/2 1/2", "-1 1/5 1/7 3 1/4 1/9", "1/5 0.25 0x1p-3 1/3 1/3 1/5", "0 0 0 1 0 0", "1 0 0 0 1 0", "1/2 1/4 1/4 1/4 1/2 1/4",
                    "2 2 2 3 3 3", "1/9 1/9 1/9 1/9 1/9 1/9", "5 0 0 5 0 0"]
        answer = self.integrate(path, segments)
        self.assertEqual((answer["degree"], answer["attribute"]), (2, "density"))
        self.assertEqual(len(answer["segments"]), len(segments))
        for text, segment in zip(segments, answer["segments"]):
            ends = [F(t) if "x" not in t else F(float.fromhex(t)) for t in text.split()]
            value = lambda t: bernstein(model, at(ends, t))[3]
            part = part_inside(ends)
            if ends[:3] == ends[3:]:
                mean = value(F(0)) if min(*ends[:3], 1 - sum(ends[:3])) >= 0 else F(0)
            elif part is None:
                mean = F(0)
            else:
                a, b = part
                mean = (b - a) / 6 * (value(a) + 4 * value((a + b) / 2) + value(b))
            self.assertEqual(F(segment["mean"]), mean, text)
            square = mean**2 * sum((q - p)**2 for p, q in zip(ends[:3], ends[3:]))
            self.assertTrue(F(segment["integral"]["lo"])**2 <= square <= F(segment["integral"]["hi"])**2, text)
            low, high = (math.exp(-segment["integral"][k]) for k in ("hi", "lo"))
            self.assertTrue(segment["intensity"]["lo"] <= high and low <= segment["intensity"]["hi"], text)
            for bounds in segment["integral"], segment["intensity"]:
                self.assertLessEqual(bounds["hi"] - bounds["lo"], 1e-15 * max(1, bounds["hi"]))

    def test_lines_are_those_of_the_report(self):
        done = run("dms", "xray", TETRAHEDRON, "-", "--attribute", "density", input="# two\n\n0 0 0 1 1 1\n-1,0,0,1,0,0\n")
        lines = [[float(x) for x in line.split()] for line in done.stdout.splitlines()]
        self.assertEqual(len(lines), 2)
        for (mean, integral, intensity), segment in zip(lines, self.integrate(TETRAHEDRON, ["0 0 0 1 1 1", "-1 0 0 1 0 0"])["segments"]):
            self.assertEqual(mean, float(F(segment["mean"])))
            self.assertTrue(segment["integral"]["lo"] <= integral <= segment["integral"]["hi"])
            self.assertTrue(segment["intensity"]["lo"] <= intensity <= segment["intensity"]["hi"])

    def test_models_with_defects_are_refused(self):
        model = json.loads(TETRAHEDRON.read_text())
        model["vertices"][3].append(["0", "0", "-1"])
        (self.folder / "bad.vdms").write_text(json.dumps(model))
        document = self.integrate("bad.vdms", ["0 0 0 1 1 1"], status=1)
        self.assertEqual([(d["code"], d["tetrahedra"], d["beta"]) for d in document["defects"]], [("cloud-degenerate", [0], [0, 0, 0, 1]), ("cloud-inside", [0, 0], [0, 0, 0, 1])])
        self.assertEqual(document["segments"], [])

    def test_wrong_arguments_and_files_are_named(self):
        for arguments, words in (([TETRAHEDRON, "-"], "--attribute A is required"), ([TETRAHEDRON, "-", "--attribute", "mass"], "the model has the attributes density"),
                                 ([DOMAIN, "-", "--attribute", "density"], "the model has no attributes"), (["-", "-", "--attribute", "a"], "M is a file")):
            done = run("dms", "xray", *arguments, input="")
            self.assertEqual(done.returncode, 2, done)
            self.assertIn(words, " ".join(done.stderr.split()))
        for text, words in (("0 0 0 1 1\n", "standard input:1: column 10: a segment has six coordinates"), ("0 0 0 1 1 nan\n", "standard input:1: column 11"),
                            ("0 0 0 1 1 1\n0 0 0 1 1 1 1\n", "standard input:2: column 13")):
            done = run("dms", "xray", TETRAHEDRON, "-", "--attribute", "density", input=text)
            self.assertEqual(done.returncode, 4, done)
            self.assertIn(words, " ".join(done.stderr.split()))

    def test_help_fits_and_its_options_are_on_the_page(self):
        page = (ROOT / "docs" / "cli" / "dms-xray.md").read_text()
        done = run("dms", "xray", "--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.rstrip("\n").split("\n")
        self.assertLessEqual(len(lines), 25)
        self.assertLessEqual(max(map(len, lines)), 80)
        for option in set(re.findall(r"--[a-z-]+", done.stdout)) - {"--help"}:
            self.assertIn(option if not option.startswith("--max-") else "--max-...", page)


if __name__ == "__main__":
    unittest.main()
