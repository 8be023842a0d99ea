#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of real models for both checkers. VERITOPE_CHECK names the program; VERITOPE_DATA, or ../shared/data beside the checkout,
holds the models (mesh/MANIFEST.tsv). Without them the tests are skipped with one message."""
import csv
import os
import pathlib
import unittest

import judges
import mesh_reading_test as reading_tests
import mesh_test as python_tests

forge = python_tests.forge
judges.judge(python_tests.vc)
DATA = pathlib.Path(os.environ.get("VERITOPE_DATA") or judges.ROOT.parent / "shared" / "data") / "mesh"


class RealModels(python_tests.CertificateTest):
    @classmethod
    def setUpClass(cls):
        if not (DATA / "MANIFEST.tsv").exists():
            raise unittest.SkipTest("no real models: set VERITOPE_DATA")
        with open(DATA / "MANIFEST.tsv", encoding="utf-8", newline="") as file:
            cls.rows = list(csv.DictReader(file, delimiter="\t"))

    def chosen(self, rows, at_least):
        """Each row, with its bytes and format, as a subtest."""
        self.assertGreater(len(rows), at_least)
        for row in rows:
            with self.subTest(file=row["file"]):
                yield row, (DATA / row["file"]).read_bytes(), row["format"][:3]

    def test_malformed_ones_are_refused(self):
        for _, data, fmt in self.chosen([r for r in self.rows if r["class"] == "malformed"], 30):
            self.says("exit 4", reading_tests.any_certificate(data, fmt), data)

    def test_small_solids_are_accepted(self):
        small = [r for r in self.rows if r["class"] in ("solid1", "solidN") and int(r["triangles"]) <= 500]
        for row, data, fmt in self.chosen(small, 15):
            plan = self.use(python_tests.models.File(data, fmt)).plan(1)
            found = plan.quantities()
            self.assertEqual((found["genus"], found["shells"]), (int(row["genus"]), int(row["shells"])))
            self.says("ACCEPT", self.cert(plan))
            self.says("ACCEPT", self.cert(self.with_separators(plan)))

    def test_small_broken_ones_are_rejected_and_their_witnesses_accepted(self):
        broken = [r for r in self.rows if r["valid_solid"] == "0" and r["class"] != "malformed" and int(r["triangles"]) <= 300]
        for _, data, fmt in self.chosen(broken, 20):
            witnesses = self.use(python_tests.models.File(data, fmt)).honest()
            self.says("ACCEPT", forge.invalid_certificate(self.bytes, self.model, self.mesh, sorted(witnesses.values(), key=lambda w: w[0])))
            code, line = python_tests.vc.check(self.bytes, self.cert(self.plan(1)))
            self.assertEqual(code, 1, line)
            expected = {"V3": {1}, "V4": {3, 4, 5}, "V5": {2}, "V6": {6}, "V9": {7}, "V10": {8}}
            self.assertTrue(set(witnesses) & expected[judges.condition(line)], (line, witnesses))


if __name__ == "__main__":
    unittest.main()
