#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every file of the real models (VERITOPE_DATA): verdict, exit status, counts and volume as their MANIFEST.tsv says."""
import csv
import os
import unittest
from fractions import Fraction

import support
from support import DATA, run

FOLDER = DATA / "mesh"
COLUMNS = {"vertices": "vertices", "faces": "triangles", "shells": "shells", "euler": "euler", "genus": "genus",
           **{name: name for name in ("boundary_edges", "nonmanifold_edges", "misoriented_edges", "nonmanifold_vertices",
                                      "degenerate_faces", "duplicate_faces", "selfint_pairs")}}
AS_INDEXED = {"boundary_edges": "asgiven_boundary_edges", "nonmanifold_edges": "asgiven_nonmanifold_edges",
              "misoriented_edges": "asgiven_misoriented_edges", "nonmanifold_vertices": "asgiven_nonmanifold_vertices",
              "shells": "asgiven_shells"}
IS_THERE = (FOLDER / "MANIFEST.tsv").is_file()
MOST_SECONDS = 1.0  # for a malformed file: a busy machine needs room
MOST_HEAP = 50 << 20


def limit_memory():
    """What is allocated, whether it is used or not; stacks of threads count, too. Sanitizers need more for themselves."""
    if os.environ.get("VERITOPE_SANITIZE"):
        return
    support.resource.setrlimit(support.resource.RLIMIT_DATA, (MOST_HEAP, MOST_HEAP))


def manifest():
    with open(FOLDER / "MANIFEST.tsv", newline="") as file:
        return list(csv.DictReader(file, delimiter="\t"))


@unittest.skipUnless(IS_THERE, "no real models")
class Manifest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = manifest()
        cls.done = run("certify", "--json", "-", *(FOLDER / row["file"] for row in cls.rows), timeout=600)
        cls.files = support.json.loads(cls.done.stdout)["files"]
        cls.readable = [(row, file) for row, file in zip(cls.rows, cls.files) if row["class"] != "malformed"]

    def test_every_verdict_and_exit_status(self):
        self.assertEqual(self.done.returncode, 1)
        self.assertEqual(len(self.files), len(self.rows))
        for row, file in zip(self.rows, self.files):
            if row["class"] == "malformed":
                expected = ("UNREADABLE", 4)
            else:
                expected = ("VALID", 0) if row["valid_solid"] == "1" else ("INVALID", 1)
                self.assertTrue(file["certificate"] and file["certificate"]["checked"], row["file"])
            with self.subTest(row["file"]):
                self.assertEqual((file["verdict"], file["exit"]), expected, file["error"])

    def test_every_count(self):
        for row, file in self.readable:
            with self.subTest(row["file"]):
                stated = {name: None if row[column] in ("na", "") else int(row[column]) for name, column in COLUMNS.items()}
                self.assertEqual({name: file["counts"][name] for name in COLUMNS}, stated)
                self.assertTrue(file["sha256"].startswith(row["sha256_16"]))
                self.assertEqual(file["bytes"], int(row["bytes"]))

    def test_every_volume_of_a_closed_surface(self):
        """The manifest's volumes are doubles with ten digits; zero and infinity there may be under- and overflow."""
        for row, file in self.readable:
            if file["volume"] is None or row["volume"] in ("inf", "nan", "na", ""):
                continue
            with self.subTest(row["file"]):
                exact, stated = Fraction(file["volume"]["exact"]), Fraction(row["volume"])
                self.assertLessEqual(abs(exact - stated), abs(stated) * Fraction(1, 10**8) + Fraction(1, 10**300))
                if row["volume_sign"] in ("-1", "0", "1"):
                    self.assertEqual((exact > 0) - (exact < 0), int(row["volume_sign"]))

    def test_the_counts_as_indexed(self):
        files = support.report("--as-indexed", "--no-check", *(FOLDER / row["file"] for row, _ in self.readable), timeout=600)["files"]
        for (row, _), file in zip(self.readable, files):
            with self.subTest(row["file"]):
                stated = {name: int(row[column]) for name, column in AS_INDEXED.items()}
                self.assertEqual({name: file["counts"][name] for name in AS_INDEXED}, stated)

    def test_malformed_files_are_refused_at_once_with_a_place(self):
        for row in self.rows:
            if row["class"] != "malformed":
                continue
            with self.subTest(row["file"]):
                begin = support.time.monotonic()
                done = run("certify", "-q", "--jobs", 2, FOLDER / row["file"], preexec_fn=limit_memory)
                self.assertLess(support.time.monotonic() - begin, MOST_SECONDS)
                self.assertEqual((done.returncode, done.stderr), (4, ""))
                self.assertRegex(done.stdout, r"^UNREADABLE  \S+  (line|byte) \d+: .+\n$")


if __name__ == "__main__":
    if not IS_THERE:
        print(f"{unittest.defaultTestLoader.loadTestsFromTestCase(Manifest).countTestCases()} tests skipped: no real models in {FOLDER} "
              "(VERITOPE_DATA)")
    support.main()
