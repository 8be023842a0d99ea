#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope micro --nest: tiles in the volumes of tiles, their genus, and refusals."""
import json
import unittest

import schema
import support
from support import run


class MicroNest(support.Folder):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out.vmicro"
        self.box = self.volumes("box", {"op": "box", "min": [0, 0, 0], "max": [2, 3, 4]})

    def micro(self, *arguments, cage=None, counts="2,1,1", tile="jack,degree=1"):
        return run("micro", "--cage", cage or self.box, "--tile", tile, "--counts", counts, "-o", self.out, *arguments)

    def nested(self, *arguments, code=0, **how):
        done = self.micro("--json", "-", *arguments, **how)
        self.assertEqual(done.returncode, code, done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        return report

    def certified(self, *arguments):
        file = support.only_file(self.out, *arguments, timeout=600)
        self.assertEqual((file["verdict"], file["certificate"]["checked"]), ("VALID", True))
        return file

    def test_jacks_in_jacks_have_the_genus_that_is_counted_by_hand(self):
        # Two jacks of seven volumes hang together at 13 faces; genus = glued caps - tiles + 1.
        for n, tiles, caps in ((1, 14, 13), (2, 14 * 8, 14 * 12 + 13 * 4)):
            report = self.nested("--nest", f"jack:{n},{n},{n}")
            self.assertEqual((report["tiles"]["total"], report["tiles"]["kept"], report["glued_caps"]), (tiles, tiles, caps))
            self.assertEqual((report["components"], report["shells"], report["genus"]), (1, 1, caps - tiles + 1))
            self.assertEqual(report["outer"], {"total": 2, "kept": 2, "crossing": 0, "touching": 0, "outside": 0, "undecided": 0, "volumes": 14})
            counts = self.certified()["counts"]
            self.assertEqual((counts["tiles"], counts["glued_caps"], counts["genus"]), (tiles, caps, caps - tiles + 1))

    def test_the_cage_is_the_outer_structure(self):
        outer = self.nested()
        self.assertIsNone(outer["outer"])
        inner = self.nested("--nest", "frame:1,1,1")
        cage = json.loads(self.out.read_text())["cage"]
        file = self.folder / "cage.vjson"
        file.write_text(json.dumps(cage))
        counts = support.only_file(file, timeout=600)
        self.assertEqual((counts["verdict"], counts["counts"]["genus"]), ("VALID", outer["genus"]))
        # The density is over the outer tiles.
        whole = outer["volume"]
        self.assertAlmostEqual(inner["density"]["lo"] * whole["lo"], inner["volume"]["lo"], places=6)

    def test_curved_cages_graded_arms_and_mixed_tiles_are_certified(self):
        cone = self.volumes("cone", {"op": "cone", "bottom": 2, "top": 1, "height": 3})
        for cage, counts, tile, arguments in ((cone, "1,1,1", "jack,degree=1", ("--nest", "jack:1,1,1")),
                                              (self.box, "2,1,1", "jack,degree=1", ("--thickness", "1/8+x/40", "--nest", "frame:1,2,1")),
                                              (self.box, "1,1,2", "branch", ("--nest", "jack,degree=1:2,1,1"))):
            report = self.nested(*arguments, cage=cage, counts=counts, tile=tile)
            self.assertEqual(self.certified()["counts"]["genus"], report["genus"])

    def test_tiles_of_both_levels_lie_in_the_model(self):
        block = self.folder / "block.off"
        corners = [(x, y, z) for x in (0.45, 1.55) for y in (0.7, 2.3) for z in (0.9, 3.1)]
        block.write_text("OFF\n8 6 0\n" + "".join("%r %r %r\n" % p for p in corners) + "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n")
        names = self.folder / "cells.csv"
        report = self.nested("--model", block, "--nest", "jack:1,1,1", "--list", names, counts="4,4,4")
        outer = report["outer"]
        self.assertEqual((outer["total"], outer["kept"], outer["undecided"], outer["volumes"]), (64, 8, 0, 56))
        self.assertEqual(outer["crossing"] + outer["outside"], 56)
        self.assertEqual((report["tiles"]["kept"], report["bridges"]), (outer["volumes"], None))
        self.assertEqual(len(names.read_text().splitlines()), 1 + outer["volumes"])
        self.certified("--model", block)

    def test_without_outer_tiles_nothing_is_nested(self):
        tiny = self.folder / "tiny.off"
        tiny.write_text("OFF\n4 4 0\n1 1 1\n1.01 1 1\n1 1.01 1\n1 1 1.01\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")
        report = self.nested("--model", tiny, "--nest", "jack:1,1,1")
        self.assertEqual((report["tiles"]["kept"], report["tiles"]["total"], report["outer"]), (0, 2, None))

    def test_the_bytes_do_not_depend_on_the_number_of_jobs(self):
        texts = []
        for jobs in (1, 2):
            self.nested("--nest", "jack:2,1,1", "--jobs", jobs)
            texts.append(self.out.read_bytes())
        self.assertEqual(texts[0], texts[1])

    def test_limits_hold_for_inner_cells(self):
        self.nested("--nest", "jack:2,1,1", "--max-tiles", 28)
        self.out.unlink()
        done = self.micro("--nest", "jack:2,1,1", "--max-tiles", 27)
        self.assertEqual(done.returncode, 4)
        self.assertIn("more than 27 cells (--max-tiles)", done.stderr)
        self.assertFalse(self.out.exists())

    def test_what_cannot_be_nested_is_refused(self):
        for arguments, how, says in ((("--nest", "jack"), {}, "needs TILE:K,M,N"), (("--nest", "jack:1,1"), {}, "K,M,N"),
                                     (("--nest", "jack:0,1,1"), {}, "K,M,N"), (("--nest", "jill:1,1,1"), {}, "needs jack, frame, branch"),
                                     (("--nest", "curves3:1,1,1"), {}, "needs a closed tile, and curves3 is open"),
                                     (("--nest", "jack:1,1,1"), {"tile": "frame"}, "jacks and branches"),
                                     (("--nest", "jack:1,1,1", "--double", "w=1"), {"counts": "2,1,2"}, "exclude each other"),
                                     (("--nest", "jack:1,1,1", "--model", "m.off", "--bridge", "domain"), {}, "no bridges")):
            done = self.micro(*arguments, **how)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(says, done.stderr)
            self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
