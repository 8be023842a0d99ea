#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope chain: counts, hypotheses, origins, statuses."""
import json
import re
import unittest
from fractions import Fraction

import schema
import support
from support import MODELS, Folder, run

CUBE = MODELS / "patches" / "cube.itd"
TETRAHEDRON = "OFF\n4 4 0\n0 0 0\n3 0 0\n0 2 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"


class Chain(Folder):
    def chain(self, *arguments):
        done = run("chain", *arguments, "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        return document

    def file(self, name, content):
        (self.folder / name).write_text(content)
        return self.folder / name

    def test_the_simplices_of_a_tetrahedron_from_inside_outside_and_a_corner(self):
        model = self.file("t.off", TETRAHEDRON)
        for origin, signs in [("0,0,0", (1, 0, 3)), ("1/2,1/2,1/4", (4, 0, 0)), ("0x1p3,0,0", (1, 1, 2)), ("-1,-1,-1", (1, 3, 0))]:
            document = self.chain(model, "--origin", origin)
            self.assertEqual(tuple(document["simplices"].values()), signs, origin)
            self.assertEqual(document["free_form"], {"plus": 0, "minus": 0, "zero": 4, "mixed": 0, "undecided": 0})
            self.assertEqual([Fraction(x) for x in document["origins"][0]["origin"]], [Fraction(8) if x.startswith("0x") else Fraction(x) for x in origin.split(",")])

    def test_auto_is_the_cheapest_origin_of_the_table(self):
        document = self.chain(MODELS / "valid_frame.off", "--origin", "auto")
        costs = [o["cell_tests"] for o in document["origins"]]
        self.assertEqual(costs[0], min(costs))
        self.assertLess(costs[0], self.chain(MODELS / "valid_frame.off")["origins"][0]["cell_tests"])

    def test_origins_stand_once(self):
        for origin in ("0,0,0", "auto", "1/2,1/2,1/2"):
            points = [tuple(o["origin"]) for o in self.chain(CUBE, "--origin", origin)["origins"]]
            self.assertEqual(len(points), len(set(points)))

    def test_the_text_has_the_numbers_of_the_json(self):
        text = run("chain", MODELS / "valid_frame.off").stdout
        document = self.chain(MODELS / "valid_frame.off")
        self.assertIn("%(plus)d plus, %(minus)d minus, %(zero)d zero" % document["simplices"], text)
        self.assertIn(f"fail at {document['literal']['planes_share_lines']['violations']} of 16 vertices; {document['literal']['planes_share_lines']['first']}",
                      re.sub(r"\s+", " ", text))

    def test_models_that_are_not_valid_have_no_chain(self):
        for model, status in [(support.INVALID, 1), (MODELS / "patches" / "not_certified_smallest.vjson", 3), (support.UNREADABLE, 4)]:
            done = run("chain", model, "--json", "r.json", cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout, self.listing()), (status, "", []))
            self.assertIn("no chain is made", re.sub(r"\s+", " ", done.stderr))

    def test_the_report_does_not_depend_on_the_number_of_threads(self):
        reports = {run("chain", CUBE, "--json", "-", "--jobs", jobs).stdout for jobs in (1, 2, 3)}
        self.assertEqual(len(reports), 1)


if __name__ == "__main__":
    support.main()
