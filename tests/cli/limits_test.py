# SPDX-License-Identifier: LGPL-3.0-or-later
"""--max-memory and --max-cells of certify and cover: what is kept, what is said, what the process takes."""
import json
import os
import subprocess
import unittest

import schema
from certify_patches_test import UNIT, block, document, surface, triangle
from support import BIN, Folder, only_file, run

# Two blocks with a slot between them: cells around it are as small as it is wide.
SLOT = block((0, 0, 0), (32, 32, 16)) + block((0, 0, 17), (32, 32, 33))
# A hundred cubes: boxes for more than a mebibyte.
CUBES = [face for x in range(10) for y in range(10) for face in block((2 * x, 2 * y, 0), (2 * x + 1, 2 * y + 1, 1))]


def peak_of(*arguments):
    """The greatest resident memory of the program, in MiB, and its report."""
    command = [str(BIN / "veritope"), *map(str, arguments), "--no-check", "--json", "-"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE)
    text = process.stdout.read()
    _, _, usage = os.wait4(process.pid, 0)
    process.stdout.close()
    process.returncode = 0
    return usage.ru_maxrss / 1024, json.loads(text)


class Limits(Folder):
    def model(self, faces, name="model.vjson"):
        path = self.folder / name
        path.write_text(document([surface(f) for f in faces]))
        return path

    def test_nonsense_is_refused(self):
        for option in ("--max-memory", "--max-cells"):
            for value in ("0", "-1", "1.5", "many", "", "99999999999999999999"):
                for command in (["certify"], ["cover", "-o", self.folder / "x.vtu"]):
                    done = run(*command, self.model(UNIT), option, value)
                    self.assertEqual(done.returncode, 2, (option, value, done.stderr))
                    self.assertIn(option, done.stderr)

    def test_a_decision_that_meets_a_limit_is_undecided_and_says_what_was_reached(self):
        for option, code in (("--max-memory", "memory-limit"), ("--max-cells", "cell-limit")):
            done = run("certify", self.model(CUBES), option, "1", "--json", "-", "--certificate", self.folder / "none")
            report = json.loads(done.stdout)
            self.assertEqual(schema.faults(report), [])
            (one,) = report["files"]
            self.assertEqual((done.returncode, one["verdict"], one["error"]["code"]), (3, "UNDECIDED", code))
            self.assertRegex(one["error"]["message"], "[0-9]+ boxes were tried, and [0-9]+ are proved")
            self.assertFalse((self.folder / "none").exists())
            text = run("certify", self.model(CUBES), option, "1").stdout
            self.assertIn("veritope explain " + code, text)
            self.assertEqual(run("explain", code).returncode, 0)

    def test_a_collar_that_meets_a_limit_leaves_the_proof_as_it_is(self):
        path, plain = self.model(SLOT), self.folder / "plain.cert"
        run("certify", path, "--certificate", plain)
        for option, value, code in (("--max-cells", "200", "cell-limit"), ("--max-memory", "12", "memory-limit")):
            kept = self.folder / "kept.cert"
            done = run("certify", path, "--collar", option, value, "--json", "-", "--certificate", kept)
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            self.assertEqual(schema.faults(report), [])
            (one,) = report["files"]
            self.assertEqual((one["verdict"], one["certificate"]["checked"]), ("VALID", True))
            self.assertEqual((one["collar"]["found"], one["collar"]["code"]), (False, code), one["collar"])
            self.assertIn("cells were tried", one["collar"]["message"])
            self.assertEqual(kept.read_bytes(), plain.read_bytes())

    def test_limits_that_suffice_change_nothing(self):
        free, bound = self.folder / "free.cert", self.folder / "bound.cert"
        path = self.model(block((0, 0, 0), (8, 8, 8)) + block((3, 3, 3), (5, 5, 5), inward=True))
        run("certify", path, "--collar", "--certificate", free)
        run("certify", path, "--collar", "--certificate", bound, "--max-memory", "1000", "--max-cells", "100000")
        self.assertEqual(free.read_bytes(), bound.read_bytes())
        cells = only_file(path, "--collar")["collar"]["cells"]
        self.assertTrue(only_file(path, "--collar", "--max-cells", str(cells))["collar"]["found"])
        self.assertFalse(only_file(path, "--collar", "--max-cells", str(cells - 1))["collar"]["found"])

    def test_cover_keeps_to_the_limits(self):
        out = self.folder / "cells.vtu"
        done = run("cover", self.model(SLOT), "-o", out, "--max-cells", "200")
        self.assertEqual(done.returncode, 3)
        self.assertFalse(out.exists())
        rows = json.loads(run("cover", self.model(SLOT), "--sweep", "2", "--max-cells", "50", "--json", "-").stdout)
        self.assertEqual(schema.faults(rows), [])
        self.assertTrue(any("over 50" in (row["limit"] or "") for row in rows["rows"]), rows["rows"])

    @unittest.skipIf(os.environ.get("VERITOPE_SANITIZE"), "sanitizers take memory of their own")
    def test_the_process_takes_a_tenth_more_at_most(self):
        path = self.model(SLOT)
        base, _ = peak_of("certify", self.model(UNIT, "unit.vjson"))
        for limit in (20, 60):
            peak, report = peak_of("certify", path, "--collar", "--max-memory", limit)
            self.assertEqual(report["files"][0]["verdict"], "VALID")
            self.assertLessEqual(peak, 1.1 * limit + base + 8, limit)

    def test_a_side_of_very_many_patches_is_named_with_a_few_of_them(self):
        path = self.folder / "copies.vjson"
        path.write_text(document([triangle([(0, 0, 0), (1, 0, 0), (0, 1, 0)])] * 3000))
        one = only_file(path)
        self.assertEqual((one["verdict"], len(one["defects"])), ("INVALID", 1))
        self.assertIn("2999 other sides are one curve", one["defects"][0]["message"])
        self.assertEqual(len(one["defects"][0]["parts"]), 20)


if __name__ == "__main__":
    unittest.main()
