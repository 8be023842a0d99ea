#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope convert --weld: what is welded and what is not, reports, statuses."""
import json
import pathlib
import unittest
from fractions import Fraction

import schema
import support
from support import DATA, MODELS, Folder, run

WALLS = pathlib.Path(__file__).parent / "welds" / "walls.itd"
TWO_CUBES = MODELS / "splines" / "two_cubes.mesh"


def box(low, high):
    """The lines of a trilinear cell in .itd."""
    at = [" ".join(f"[{(low, high)[i][0]} {(low, high)[j][1]} {(low, high)[k][2]}]" for i in (0, 1)) for k in (0, 1) for j in (0, 1)]
    return "[TRIVAR BEZIER 2 2 2 E3\n" + "\n".join(at) + "\n]\n"


class Weld(Folder):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "o.vjson"

    def weld(self, path, eps, *arguments, expect=0):
        done = run("convert", path, self.out, "--weld", eps, *arguments)
        self.assertEqual(done.returncode, expect, done.stderr)
        return done

    def report(self, path, eps, *arguments):
        done = self.weld(path, eps, "--json", "-", *arguments)
        self.assertEqual(done.stderr, "")
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(document["output"]["bytes"], self.out.stat().st_size)
        return document

    def file(self, text, name="m.itd"):
        (self.folder / name).write_text(text)
        return self.folder / name

    def test_near_faces_are_welded_and_others_are_listed(self):
        text = self.weld(WALLS, "1e-3").stdout
        self.assertIn("glued: 1 pair of faces, 0 before; 1 cell changes, by at most 0.0003 (cell 1)", text)
        self.assertIn("welded: cell 0 u1 and cell 1 u0, moved by at most 0.0003", text)
        self.assertIn("apart: cell 1 u1 and cell 2 u0: they differ by 0.25", text)
        report = self.report(WALLS, "1e-3")
        self.assertEqual(report["eps"], "1/1000")
        self.assertEqual(report["counts"], {"cells": 3, "changed": 1, "glued_before": 0, "glued_after": 1})
        (pair,) = report["welded"]
        self.assertEqual(pair["winner"], {"cell": 0, "part": "u1"})
        self.assertEqual(pair["loser"], {"cell": 1, "part": "u0"})
        self.assertEqual(pair["symmetry"], 0)
        self.assertEqual(pair["distance"], {"exact": "3/10000", "decimal": 0.0003})
        self.assertEqual(pair["displacement"], pair["distance"])
        self.assertEqual(report["largest_displacement"], pair["distance"])
        self.assertEqual(report["farthest_cell"], 1)
        (apart,) = report["apart"]
        self.assertEqual((apart["because"], apart["distance"]["exact"]), ("control-points", "1/4"))
        cells = json.loads(self.out.read_text())["entities"]
        self.assertEqual([p[0] for p in cells[1]["shape"]["points"] if Fraction(p[0]) < 2], ["1"] * 6)

    def test_the_distance_may_be_any_exact_number_and_is_compared_exactly(self):
        for eps, count in [("0.0003", 1), ("3/10000", 1), ("0.00029999999999999999999999999", 0), ("0x1p-11", 1), ("0x1p-12", 0), ("1e-300", 0)]:
            with self.subTest(eps):
                self.assertEqual(len(self.report(WALLS, eps)["welded"]), count)

    def test_nothing_moves_without_a_near_pair(self):
        for path in (WALLS, TWO_CUBES):
            self.assertEqual(run("convert", path, self.folder / "plain.vjson").returncode, 0)
            report = self.report(path, "1e-9")
            self.assertEqual((report["welded"], report["counts"]["changed"], report["farthest_cell"]), ([], 0, None))
            self.assertEqual(report["largest_displacement"], {"exact": "0", "decimal": 0})
            self.assertEqual(self.out.read_bytes(), (self.folder / "plain.vjson").read_bytes())
        self.assertEqual(report["counts"]["glued_before"], 1)

    def test_welded_volumes_are_valid_and_welding_again_changes_nothing(self):
        cells = [box((0, 0, 0), (1, 1, 1)), box((1, 0.0001, 0), (2, 1, "0.9999")), box((0, 1, 0), (1, 2, 1.0002)), box((1, 1, 0), (2, 2, 1))]
        path = self.file("".join(cells))
        self.assertNotEqual(support.only_file(path)["verdict"], "VALID")
        report = self.report(path, "1e-3")
        self.assertEqual(report["counts"]["glued_after"], 4)
        self.assertLessEqual(Fraction(report["largest_displacement"]["exact"]), Fraction(1, 1000))
        after = support.only_file(self.out)
        self.assertEqual((after["verdict"], after["counts"]["internal"]), ("VALID", 4))
        first = self.out.read_bytes()
        again = self.report(self.file(self.out.read_text(), "again.vjson"), "1e-3")
        self.assertEqual(again["welded"], [])
        self.assertEqual(self.out.read_bytes(), first)

    def test_a_crowd_and_a_collapse_are_refused_for_their_pairs(self):
        report = self.report(self.file(box((0, 0, 0), ("0.0001", 1, 1))), "1e-3")
        self.assertEqual([pair["because"] for pair in report["apart"]], ["collapse"])
        cells = [box((0, 0, 0), (1, 1, 1)), box((1.0001, 0, 0), (2, 1, 1)), box((1.0002, 0, 0), (3, 1, 1))]
        report = self.report(self.file("".join(cells)), "1e-3")
        self.assertEqual([pair["because"] for pair in report["apart"]], ["several", "several"])
        self.assertEqual(report["counts"]["changed"], 0)

    def test_the_report_and_the_file_go_where_they_are_asked_for(self):
        done = run("convert", WALLS, "-", "--to", "vjson", "--weld", "1e-3", "--json", self.folder / "r.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["format"], "veritope-spline-1")
        self.assertIn("welded: cell 0 u1", done.stderr)
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["output"]["path"], "-")
        self.assertEqual(self.listing(), ["r.json"])

    def test_faces_and_pictures_are_those_of_welded_cells(self):
        path = self.file(box((0, 0, 0), (1, 1, 1)) + box((1.0001, 0, 0), (2, 1, 1)))
        self.weld(path, "1e-3", "--faces", "--lossy")
        faces = support.only_file(self.out)
        self.assertEqual((faces["verdict"], faces["counts"]["entities"]), ("VALID", 10))
        self.assertEqual(run("convert", path, self.folder / "o.vtu", "--weld", "1e-3").returncode, 0)

    def test_what_the_format_cannot_hold_is_refused(self):
        """Degree elevation makes thirds, which are not decimals."""
        high = "[TRIVAR BEZIER 4 2 2 E3\n" + "\n".join(
            " ".join(f"[{x} {j + 1} {k}]" for x in ("0", "0.3333", "0.6667", "1")) for k in (0, 1) for j in (0, 1)) + "\n]\n"
        path = self.file(box((0, 0, 0), (1, 1, 1)) + high)
        done = run("convert", path, self.folder / "o.itd", "--weld", "1e-3")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--to vjson keeps every spline", done.stderr)
        self.assertEqual(self.listing(), ["m.itd"])
        self.assertEqual(self.report(path, "1e-3")["counts"]["glued_after"], 1)

    def test_files_that_are_not_of_volumes_alone_are_refused(self):
        done = self.weld(self.file(box((0, 0, 0), (1, 1, 1)) + "[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0]]\n"), "1e-3", expect=4)
        self.assertIn("m.itd: entity 1: a surface, not a volume (--weld is for files of volumes only)", done.stderr)
        plane = "[TRIVAR BEZIER 2 2 2 E2\n" + "[0 0] [1 0] [0 1] [1 1] [2 0] [3 0] [2 1] [3 1]\n]\n"
        done = self.weld(self.file(plane), "1e-3", expect=4)
        self.assertIn("entity 0: a volume with 2 coordinates, not in space", done.stderr)
        self.assertEqual(self.listing(), ["m.itd"])

    @unittest.skipUnless(DATA.is_dir(), "needs VERITOPE_DATA")
    def test_a_real_cylinder_becomes_valid(self):
        """Its cubic walls have 0.083333333333333 where the elevated line has 1/12."""
        path = DATA / "cad" / "iritprim__ns_cylinder_poly.itd"
        before = support.only_file("--orient", "auto", path)
        self.assertEqual(before["verdict"], "INVALID")
        report = self.report(path, "1e-9")
        self.assertEqual([(p["winner"]["cell"], p["loser"]["cell"]) for p in report["welded"]], [(4, 0), (4, 1), (4, 2), (4, 3)])
        self.assertEqual(report["largest_displacement"]["exact"], "1/3000000000000000")
        self.assertEqual(report["apart"], [])
        certificate = self.folder / "c"
        after = support.only_file("--orient", "auto", self.out, "--certificate", certificate)
        self.assertEqual((after["verdict"], after["counts"]["internal"]), ("VALID", 8))
        self.assertTrue(after["certificate"]["checked"])
        self.assertIn(b'"claim":"vmodel-1"', certificate.read_bytes())


if __name__ == "__main__":
    support.main()
